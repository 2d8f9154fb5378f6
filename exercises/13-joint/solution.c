// solution.c - a push in three directions at once, that may pull as well.

#include "joint.h"

#include <stddef.h>

// The share of a corner of a tetrahedron is the volume that the point has with
// the other three, as a part of the whole.
void joint_shares(const vec3 at[FOUR], vec3 point, real share[FOUR])
{
    vec3 a = vec3_sub(at[1], at[0]), b = vec3_sub(at[2], at[0]);
    vec3 c = vec3_sub(at[3], at[0]), r = vec3_sub(point, at[0]);
    real volume = vec3_dot(a, vec3_cross(b, c));
    share[1] = vec3_dot(r, vec3_cross(b, c)) / volume;
    share[2] = vec3_dot(r, vec3_cross(c, a)) / volume;
    share[3] = vec3_dot(r, vec3_cross(a, b)) / volume;
    share[0] = 1 - share[1] - share[2] - share[3];
}

static vec3 point_of(const particle *p, const real share[FOUR])
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, share[k], p[k].position);
    return sum;
}

// The six ways of one body, the rows of its point along x, y and z, and what
// they add to the columns of K: how far a push of 1 moves the point.
static void add_rows(const particle *p, const real share[FOUR], rigid4_ways *ways,
                     real row[3][FOUR_WAYS], vec3 column[3])
{
    static const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    vec3 at[FOUR];
    for (int k = 0; k < FOUR; k++) at[k] = p[k].previous;
    rigid4_find_ways(at, p[0].inverse_mass, ways);
    rigid4_rows(ways, share, axis, row);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < FOUR_WAYS; k++)
            column[i] = vec3_add_scaled(column[i], row[i][k],
                            vec3_make(row[0][k], row[1][k], row[2][k]));
}

static void push_side_by(particle *p, const rigid4_ways *ways,
                         real row[3][FOUR_WAYS], vec3 push)
{
    real along[FOUR_WAYS];
    vec3 move[FOUR];
    for (int k = 0; k < FOUR_WAYS; k++)
        along[k] = push.x * row[0][k] + push.y * row[1][k] + push.z * row[2][k];
    rigid4_move(ways, along, move);
    for (int k = 0; k < FOUR; k++)
        p[k].position = vec3_add(p[k].position, move[k]);
}

// The push l on A, and -l on B, changes the gap by (K_A + K_B) l, which is to
// be -gap: Cramer's rule.
real joint_close(const joint *j, particle *p)
{
    rigid4_ways ways[2];
    real row[2][3][FOUR_WAYS];
    vec3 column[3] = { { 0, 0, 0 } }, on_b = j->fixed;
    particle *a = p + j->a, *b = j->b >= 0 ? p + j->b : NULL;
    add_rows(a, j->share_a, &ways[0], row[0], column);
    if (b) {
        add_rows(b, j->share_b, &ways[1], row[1], column);
        on_b = point_of(b, j->share_b);
    }
    vec3 gap = vec3_sub(on_b, point_of(a, j->share_a));
    vec3 yz = vec3_cross(column[1], column[2]);
    real volume = vec3_dot(column[0], yz);
    if (!(volume > 0)) return vec3_length(gap);
    vec3 push = { vec3_dot(gap, yz) / volume,
                  vec3_dot(gap, vec3_cross(column[2], column[0])) / volume,
                  vec3_dot(gap, vec3_cross(column[0], column[1])) / volume };
    push_side_by(a, &ways[0], row[0], push);
    if (b) push_side_by(b, &ways[1], row[1], vec3_scale(-1, push));
    return vec3_length(gap);
}
