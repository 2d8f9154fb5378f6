// solution.c - projected Gauss-Seidel, point by point.

#include "shared.h"

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
static void touch_give(solid *body, const touch *t, vec3 p)
{
    solid_push(&body[t->a], t->ra, p);
    solid_push(&body[t->b], t->rb, vec3_scale(-1, p));
}

// m/s, the point of a as seen from that of b.
static vec3 touch_velocity(const solid *body, const touch *t)
{
    const solid *a = &body[t->a], *b = &body[t->b];
    vec3 of_a = vec3_add(a->velocity, vec3_cross(a->spin, t->ra));
    vec3 of_b = vec3_add(b->velocity, vec3_cross(b->spin, t->rb));
    return vec3_sub(of_a, of_b);
}

// 1/M + (r x d) I^-1 (r x d), of both bodies, is how fast the points part for
// an impulse of 1.
real touch_mass(const solid *body, const touch *t, vec3 d)
{
    const solid *a = &body[t->a], *b = &body[t->b];
    vec3 ta = vec3_cross(t->ra, d), tb = vec3_cross(t->rb, d);
    real k = a->inverse_mass + vec3_dot(ta, inertia_apply(a, ta));
    k += b->inverse_mass + vec3_dot(tb, inertia_apply(b, tb));
    return 1 / k;
}

void touches_warm(solid *body, const touch *t, int count)
{
    for (int i = 0; i < count; i++) {
        vec3 p = vec3_add_scaled(t[i].rub, t[i].push, t[i].normal);
        touch_give(body, &t[i], p);
    }
}

// Clamps the sum, and gives what is missing to it.
static void touch_press(solid *body, touch *t, real h)
{
    real lack = vec3_dot(touch_velocity(body, t), t->normal), was = t->push;
    lack += t->gap > 0 ? t->gap / h : 0.2 * t->gap / h;
    t->push = was - touch_mass(body, t, t->normal) * lack;
    if (t->push < 0) t->push = 0;
    touch_give(body, t, vec3_scale(t->push - was, t->normal));
}

// Stops all sliding, or shortens the sum to the rim of Coulomb's cone.
static void touch_rub(solid *body, touch *t)
{
    vec3 v = touch_velocity(body, t), was = t->rub;
    vec3 slide = vec3_add_scaled(v, -vec3_dot(v, t->normal), t->normal);
    real most = t->friction * t->push;
    if (vec3_length(slide) > 0) {
        real mass = touch_mass(body, t, vec3_unit(slide));
        t->rub = vec3_add_scaled(t->rub, -mass, slide);
    }
    real all = vec3_length(t->rub);
    if (all > most) t->rub = vec3_scale(most / all, t->rub);
    touch_give(body, t, vec3_sub(t->rub, was));
}

void touches_solve(solid *body, touch *t, int count, real h, int iterations)
{
    for (int k = 0; k < iterations; k++)
        for (int i = 0; i < count; i++) {
            touch_press(body, &t[i], h);
            touch_rub(body, &t[i]);
        }
}
