// solution.c - all corners are stopped, and then part again.

#include "strike.h"

static vec3 inertia_apply(const solid *s, vec3 v)
{
    vec3 sum = vec3_scale(v.x, s->inverse[0]);
    sum = vec3_add_scaled(sum, v.y, s->inverse[1]);
    return vec3_add_scaled(sum, v.z, s->inverse[2]);
}

static void solid_push(solid *s, vec3 arm, vec3 p)
{
    vec3 turn = inertia_apply(s, vec3_cross(arm, p));
    s->velocity = vec3_add_scaled(s->velocity, s->inverse_mass, p);
    s->spin = vec3_add(s->spin, turn);
}

// One body gets the impulse, and the other the opposite one.
static void point_push(striking *s, int k, real impulse)
{
    solid_push(s->a, s->ra[k], vec3_scale(impulse, s->normal));
    solid_push(s->b, s->rb[k], vec3_scale(-impulse, s->normal));
}

static real parting_speed(const striking *s, int k)
{
    vec3 of_a = vec3_add(s->a->velocity, vec3_cross(s->a->spin, s->ra[k]));
    vec3 of_b = vec3_add(s->b->velocity, vec3_cross(s->b->spin, s->rb[k]));
    return vec3_dot(s->normal, vec3_sub(of_a, of_b));
}

// 1/M + (r x n) I^-1 (r x n), of both bodies, is how fast the points part for
// an impulse of 1.
real impact_mass(const striking *s, int k)
{
    vec3 ta = vec3_cross(s->ra[k], s->normal);
    vec3 tb = vec3_cross(s->rb[k], s->normal);
    real answer = s->a->inverse_mass + vec3_dot(ta, inertia_apply(s->a, ta));
    answer += s->b->inverse_mass + vec3_dot(tb, inertia_apply(s->b, tb));
    return 1 / answer;
}

void impact_strike(striking *s)
{
    real sum[STRIKE_POINTS] = { 0 };
    real fastest = 0, most = HUGE_VAL;
    for (int k = 0; k < s->points; k++)
        if (-parting_speed(s, k) > fastest) fastest = -parting_speed(s, k);
    for (int n = 0; n < 10000 && most > 1e-12 * fastest; n++) {
        most = 0;
        for (int k = 0; k < s->points; k++) {
            real was = sum[k], mass = impact_mass(s, k);
            sum[k] = was - mass * parting_speed(s, k);
            if (sum[k] < 0) sum[k] = 0;
            point_push(s, k, sum[k] - was);
            if (fabs(sum[k] - was) / mass > most) most = fabs(sum[k] - was) / mass;
        }
    }
    for (int k = 0; k < s->points; k++)
        point_push(s, k, s->restitution * sum[k]);
}
