// solution.c - sums over particles, and one small system of equations.

#include "whole.h"

static real mass_of(const particle *p)
{
    return p->inverse_mass > 0 ? 1 / p->inverse_mass : 0;
}

static vec3 velocity_of(const particle *p, real dt)
{
    return vec3_scale(1 / dt, vec3_sub(p->position, p->previous));
}

static vec3 middle_of(const particle *p)
{
    return vec3_scale(0.5, vec3_add(p->position, p->previous));
}

static real energy_of(real mass, vec3 velocity)
{
    return mass * vec3_length_squared(velocity) / 2;
}

// Solves I s = L, where I has the columns a, b, c.  In a line d, I is
// i (1 - d d^T): i on the two axes across it, 0 on it, and the trace is 2 i.
static vec3 turning(vec3 a, vec3 b, vec3 c, vec3 L)
{
    real det = vec3_dot(a, vec3_cross(b, c)), trace = a.x + b.y + c.z;
    if (det > 0x1p-40 * trace * trace * trace) {
        vec3 s = { vec3_dot(L, vec3_cross(b, c)), vec3_dot(L, vec3_cross(c, a)),
                   vec3_dot(L, vec3_cross(a, b)) };
        return vec3_scale(1 / det, s);
    }
    return vec3_scale(trace > 0 ? 2 / trace : 0, L);
}

whole whole_of(const particle *p, int n, real dt)
{
    whole w = { .mass = 0 };
    vec3 a = { 0, 0, 0 }, b = { 0, 0, 0 }, c = { 0, 0, 0 };
    real all = 0;
    for (int i = 0; i < n; i++) {
        real m = mass_of(&p[i]);
        vec3 v = velocity_of(&p[i], dt);
        w.mass += m;
        w.center = vec3_add_scaled(w.center, m, middle_of(&p[i]));
        w.velocity = vec3_add_scaled(w.velocity, m, v);
        all += energy_of(m, v);
    }
    if (!(w.mass > 0)) return w;
    w.center = vec3_scale(1 / w.mass, w.center);
    w.velocity = vec3_scale(1 / w.mass, w.velocity);
    for (int i = 0; i < n; i++) {
        real m = mass_of(&p[i]);
        vec3 r = vec3_sub(middle_of(&p[i]), w.center);
        vec3 u = vec3_sub(velocity_of(&p[i], dt), w.velocity);
        w.angular = vec3_add_scaled(w.angular, m, vec3_cross(r, u));
        real rr = vec3_length_squared(r);
        a = vec3_add_scaled(vec3_add(a, (vec3){ m * rr, 0, 0 }), -m * r.x, r);
        b = vec3_add_scaled(vec3_add(b, (vec3){ 0, m * rr, 0 }), -m * r.y, r);
        c = vec3_add_scaled(vec3_add(c, (vec3){ 0, 0, m * rr }), -m * r.z, r);
    }
    w.spin = turning(a, b, c, w.angular);
    w.flight = energy_of(w.mass, w.velocity);
    w.turning = vec3_dot(w.spin, w.angular) / 2;
    w.rest = all - w.flight - w.turning;
    return w;
}
