//> response-point
// response.c - parts two features that overlap.
#include "response.h"

#include <assert.h>

vec3 feature_position(const feature_point *f, const particle *p)
{
    vec3 x = { 0, 0, 0 };
    for (int i = 0; i < f->count; i++)
        x = vec3_add_scaled(x, f->weight[i], p[f->vertex[i]].position);
    return x;
}

real contact_depth(const feature_contact *c, const particle *p)
{
    vec3 across = vec3_sub(feature_position(&c->a, p),
                           feature_position(&c->b, p));
    return c->apart - vec3_dot(across, c->normal);
}
//<

//> response-impulse
// An impulse J at the point gives particle i the part a_i J, which moves it by
// w_i a_i J.  The point, sum a_i x_i, then moves by (sum w_i a_i^2) J.
real feature_inverse_mass(const feature_point *f, const particle *p)
{
    real sum = 0;
    for (int i = 0; i < f->count; i++)
        sum += p[f->vertex[i]].inverse_mass * f->weight[i] * f->weight[i];
    return sum;
}

// impulse: in kg m, that is, times the time step.
static void apply_impulse(const feature_point *f, vec3 impulse, particle *p)
{
    for (int i = 0; i < f->count; i++) {
        particle *x = &p[f->vertex[i]];
        x->position = vec3_add_scaled(x->position,
                                      x->inverse_mass * f->weight[i], impulse);
    }
}
//<

//> response-friction
// m: how far the point has moved since the last step.
static vec3 feature_motion(const feature_point *f, const particle *p)
{
    vec3 x = { 0, 0, 0 };
    for (int i = 0; i < f->count; i++) {
        const particle *q = &p[f->vertex[i]];
        x = vec3_add_scaled(x, f->weight[i],
                            vec3_sub(q->position, q->previous));
    }
    return x;
}

// m: how far A's point has slid past B's, across the normal, but no longer than
// `most`.  This much of the sliding friction undoes.
static vec3 held_slide(const feature_contact *c, const particle *p, real most)
{
    vec3 slide = vec3_sub(feature_motion(&c->a, p), feature_motion(&c->b, p));
    slide = vec3_add_scaled(slide, -vec3_dot(slide, c->normal), c->normal);
    real length = vec3_length(slide);
    return length > most ? vec3_scale(most / length, slide) : slide;
}
//<

//> response-separate
real response_separate(const feature_contact *c, particle *p, real friction)
{
    assert(friction >= 0);
    real depth = contact_depth(c, p);
    if (!(depth > 0)) return 0;
    real inverse_mass = feature_inverse_mass(&c->a, p)
                      + feature_inverse_mass(&c->b, p);
    vec3 move = vec3_sub(vec3_scale(depth, c->normal),
                         held_slide(c, p, friction * depth));
    vec3 impulse = vec3_scale(1 / inverse_mass, move);
    if (!vec3_is_finite(impulse)) return depth;     // nothing can move
    apply_impulse(&c->a, impulse, p);
    apply_impulse(&c->b, vec3_scale(-1, impulse), p);
    return depth;
}
//<

//> response-printed
// Eqs 8 and 9, without masses: moves the point of f by `move`, and its free
// particles by as little as that takes.
static void move_feature(const feature_point *f, vec3 move, particle *p)
{
    real squares = 0;
    for (int i = 0; i < f->count; i++)
        if (p[f->vertex[i]].inverse_mass > 0)
            squares += f->weight[i] * f->weight[i];
    vec3 whole = vec3_scale(1 / squares, move);
    if (!vec3_is_finite(whole)) return;             // nothing can move
    for (int i = 0; i < f->count; i++) {
        particle *x = &p[f->vertex[i]];
        if (x->inverse_mass > 0)
            x->position = vec3_add_scaled(x->position, f->weight[i], whole);
    }
}

// The part of the overlap by which A moves out; < 0: A moves in.  B moves the
// rest, 1 - |part|, the other way.
// Paper: Eq. 10 exchanges the masses, and a deformable body goes inwards; here:
// right or as printed.
static real part_of_a(const feature_contact *c, response_errata errata)
{
    bool soft_in_rigid = c->soft_a && !c->soft_b && c->b.count > 0;
    if (soft_in_rigid && errata.pushed_inwards) return -0.5;
    if (c->mass_b == HUGE_VAL) return 1;
    if (c->mass_a == HUGE_VAL) return 0;
    if (c->soft_a || c->soft_b) return 0.5;         // Eq. 11; the midpoint
    real mass = errata.masses_exchanged ? c->mass_a : c->mass_b;
    return mass / (c->mass_a + c->mass_b);
}

real response_printed(const feature_contact *c, particle *p,
                      response_errata errata)
{
    assert(c->mass_a > 0 && c->mass_b > 0);
    real depth = contact_depth(c, p), part = part_of_a(c, errata);
    if (!(depth > 0)) return 0;
    move_feature(&c->a, vec3_scale(part * depth, c->normal), p);
    move_feature(&c->b, vec3_scale((fabs(part) - 1) * depth, c->normal), p);
    return depth;
}
//<
