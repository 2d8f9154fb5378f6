// solution.c - to spin is to have been elsewhere.

#include "flip.h"

// r, turned back by the spin during h (Rodrigues).
static vec3 turned_back(vec3 r, vec3 spin, real h)
{
    real back = -vec3_length(spin) * h, c = cos(back), s = sin(back);
    vec3 axis = vec3_unit(spin);
    vec3 turned = vec3_add_scaled(vec3_scale(c, r), s, vec3_cross(axis, r));
    return vec3_add_scaled(turned, vec3_dot(axis, r) * (1 - c), axis);
}

void flip_start(const rigid4 *f, vec3 center, vec3 velocity, vec3 spin, real h,
                particle *p)
{
    for (int k = 0; k < FOUR; k++) {
        vec3 r = vec3_sub(f->at[k], f->center);
        vec3 before = vec3_add_scaled(center, -h, velocity);
        p[k] = (particle){ vec3_add(center, r),
                           vec3_add(before, turned_back(r, spin, h)),
                           1 / f->mass };
    }
}

// With r the mean of both places, from the centre, and v the way between them
// by h: L = sum m r x v, and I = sum m (r.r - r r^T).  I spin = L, by Cramer.
// (All masses are equal and fall out.)
vec3 flip_spin(const particle *p, real h)
{
    vec3 r[FOUR], v[FOUR], middle = { 0, 0, 0 }, drift = middle, l = middle;
    vec3 column[3] = { { 0, 0, 0 } };
    for (int k = 0; k < FOUR; k++) {
        r[k] = vec3_scale(0.5, vec3_add(p[k].position, p[k].previous));
        v[k] = vec3_scale(1 / h, vec3_sub(p[k].position, p[k].previous));
        middle = vec3_add_scaled(middle, 1.0 / FOUR, r[k]);
        drift = vec3_add_scaled(drift, 1.0 / FOUR, v[k]);
    }
    for (int k = 0; k < FOUR; k++) {
        vec3 d = vec3_sub(r[k], middle);
        real d2 = vec3_dot(d, d);
        l = vec3_add(l, vec3_cross(d, vec3_sub(v[k], drift)));
        column[0] = vec3_add_scaled(column[0], -d.x, d);
        column[1] = vec3_add_scaled(column[1], -d.y, d);
        column[2] = vec3_add_scaled(column[2], -d.z, d);
        column[0].x += d2;
        column[1].y += d2;
        column[2].z += d2;
    }
    vec3 yz = vec3_cross(column[1], column[2]);
    real volume = vec3_dot(column[0], yz);
    if (!(volume > 0 && volume < HUGE_VAL)) return (vec3){ 0, 0, 0 };
    return (vec3){ vec3_dot(l, yz) / volume,
                   vec3_dot(l, vec3_cross(column[2], column[0])) / volume,
                   vec3_dot(l, vec3_cross(column[0], column[1])) / volume };
}
