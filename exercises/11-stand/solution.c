// solution.c - every pair may be a side.

#include "stand.h"

// Seen along a direction: x and y across it.  Far away nothing is lost if
// `from` is near.
typedef struct {
    vec3 x, y, from;
} plane_of;

static vec3 seen_along(const plane_of *w, vec3 p)
{
    vec3 r = vec3_sub(p, w->from);
    return (vec3){ vec3_dot(r, w->x), vec3_dot(r, w->y), 0 };
}

// Does everything lie to the left of the line from i to j, or on it?
static int is_side(const plane_of *w, const vec3 *at, int n, int i, int j)
{
    vec3 from = seen_along(w, at[i]);
    vec3 e = vec3_sub(seen_along(w, at[j]), from);
    if (!(vec3_dot(e, e) > 0)) return 0;
    for (int k = 0; k < n; k++)
        if (vec3_cross(e, vec3_sub(seen_along(w, at[k]), from)).z < 0) return 0;
    return 1;
}

// How far is f from the segment, and is it a corner that is nearest (-1, 1) or
// the side (0)?
static real nearest_on(vec3 from, vec3 to, vec3 f, int *corner)
{
    vec3 e = vec3_sub(to, from);
    real t = vec3_dot(vec3_sub(f, from), e) / vec3_dot(e, e);
    *corner = t <= 0 ? -1 : t >= 1;
    t = t > 0 ? (t < 1 ? t : 1) : 0;
    return vec3_distance(f, vec3_add_scaled(from, t, e));
}

stand stand_find(const vec3 *at, int n, vec3 center, vec3 down)
{
    stand s = { -HUGE_VAL, -1, -1 };
    vec3 across = fabs(down.x) < fabs(down.y) ? (vec3){ 1, 0, 0 }
                                              : (vec3){ 0, 1, 0 };
    if (n < 1 || !(vec3_length(down) > 0)) return s;
    plane_of w = { .x = vec3_unit(vec3_cross(across, down)), .from = at[0] };
    w.y = vec3_unit(vec3_cross(w.x, down));
    vec3 f = seen_along(&w, center);
    real least = HUGE_VAL;
    int sides = 0, inside = 1;
    for (int i = 0; i < n; i++) {
        real d = vec3_distance(f, seen_along(&w, at[i]));
        if (d < least) { least = d; s.a = s.b = i; }
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            if (!is_side(&w, at, n, i, j)) continue;
            vec3 p = seen_along(&w, at[i]), q = seen_along(&w, at[j]);
            int corner;
            real d = nearest_on(p, q, f, &corner);
            sides++;
            inside &= vec3_cross(vec3_sub(q, p), vec3_sub(f, p)).z > 0;
            if (corner != 0 || !(d < least)) continue;
            least = d;
            s.a = i < j ? i : j;
            s.b = i < j ? j : i;
        }
    if (least < HUGE_VAL) s.margin = sides && inside ? least : -least;
    return s;
}
