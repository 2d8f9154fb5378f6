// solution.c - each keeps to its half.

#include "half.h"

// The point of the link from a to b that is nearest to p.
static vec3 segment_foot(vec3 a, vec3 b, vec3 p)
{
    vec3 u = vec3_sub(b, a);
    real t = vec3_dot(vec3_sub(p, a), u), square = vec3_dot(u, u);
    if (!(t > 0)) return a;
    if (t >= square) return b;
    return vec3_add_scaled(a, t / square, u);
}

// A NaN leaves no room.
static void limit(real *room, real most)
{
    if (!(most >= *room)) *room = most >= 0 ? most : 0;
}

// Two links that do not cross touch first where an end of one meets the other:
// so it is enough to look at all points and links.  A point of a link goes no
// further than the one of its ends that goes further, for it is a mean of both.
// So a link and a point that are d apart, and whose three particles have 0.45 d
// to go at most, are at least a tenth of d apart afterwards.
void half_distances(const vec3 *at, int points, const half_link *link,
                    int links, real most, real *room)
{
    for (int i = 0; i < points; i++) room[i] = most;
    for (int i = 0; i < points; i++) {
        for (int k = 0; k < links; k++) {
            int a = link[k].a, b = link[k].b;
            if (i == a || i == b) continue;
            real far = SHARE * vec3_distance(at[i],
                                             segment_foot(at[a], at[b], at[i]));
            limit(&room[i], far);
            limit(&room[a], far);
            limit(&room[b], far);
        }
    }
}

int half_move(vec3 *at, int points, const vec3 *want, const real *room)
{
    int held = 0;
    for (int i = 0; i < points; i++) {
        vec3 way = vec3_sub(want[i], at[i]);
        real length = vec3_length(way);
        if (length <= room[i]) {
            at[i] = want[i];
            continue;
        }
        held++;
        if (length < HUGE_VAL)
            at[i] = vec3_add_scaled(at[i], room[i] / length, way);
    }
    return held;
}
