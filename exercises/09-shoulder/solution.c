// solution.c - sticks between points that ride.

#include "shoulder.h"

vec3 end_place(const rod_end *e, const particle *p)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < e->count; k++)
        sum = vec3_add_scaled(sum, e->share[k], p[e->at[k]].position);
    return sum;
}

// 1/kg: how far the point goes for a unit pull, if each particle takes its
// share of it, and gives its share to the point.
static real stiffness_of(const rod_end *e, const particle *p)
{
    real sum = 0;
    for (int k = 0; k < e->count; k++)
        sum += p[e->at[k]].inverse_mass * e->share[k] * e->share[k];
    return sum;
}

static void pull(const rod_end *e, particle *p, vec3 by)
{
    for (int k = 0; k < e->count; k++) {
        particle *x = &p[e->at[k]];
        x->position = vec3_add_scaled(x->position,
                                      e->share[k] * x->inverse_mass, by);
    }
}

// Both pulls are along d, so neither momentum nor angular momentum comes of it.
real rod_relax(const rod *r, particle *p)
{
    vec3 d = vec3_sub(end_place(&r->b, p), end_place(&r->a, p));
    real distance = vec3_length(d), error = distance - r->length;
    real sum = stiffness_of(&r->a, p) + stiffness_of(&r->b, p);
    if (r->kind == STICK_AT_LEAST && error >= 0) return 0;
    if (r->kind == STICK_AT_MOST && error <= 0) return 0;
    if (!(sum > 0) || !(distance > 0)) return error;
    real part = r->length > 0 ? error / distance : 1;
    pull(&r->a, p, vec3_scale(part / sum, d));
    pull(&r->b, p, vec3_scale(-part / sum, d));
    return error;
}

int rods_relax(const rod *r, int n, particle *p, real tolerance, int cap)
{
    for (int iteration = 1; iteration <= cap; iteration++) {
        int satisfied = 1;
        for (int k = 0; k < n; k++)
            if (fabs(rod_relax(&r[k], p)) > tolerance) satisfied = 0;
        if (satisfied) return iteration;
    }
    return cap;
}
