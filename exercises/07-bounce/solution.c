// solution.c - restitution, through the previous positions.

#include "bounce.h"

// m: how far the point of f has moved in the last step.
static vec3 feature_step(const feature_point *f, const particle *p)
{
    vec3 x = { 0, 0, 0 };
    for (int i = 0; i < f->count; i++) {
        const particle *q = &p[f->vertex[i]];
        x = vec3_add_scaled(x, f->weight[i],
                            vec3_sub(q->position, q->previous));
    }
    return x;
}

// What an impulse (kg m) does to a position, this does to the previous one.
static void move_previous(const feature_point *f, vec3 impulse, particle *p)
{
    for (int i = 0; i < f->count; i++) {
        particle *q = &p[f->vertex[i]];
        q->previous = vec3_add_scaled(q->previous,
                                      q->inverse_mass * f->weight[i], impulse);
    }
}

// The points have moved apart by `moved`, and should have by speed * dt.  An
// impulse J on the previous positions takes (K_A + K_B) J from that.
void bounce(const feature_contact *c, particle *p, real restitution,
            real approach, real dt)
{
    real moved = vec3_dot(vec3_sub(feature_step(&c->a, p),
                                   feature_step(&c->b, p)), c->normal);
    real speed = approach > 0 ? restitution * approach : -approach;
    real inverse_mass = feature_inverse_mass(&c->a, p)
                      + feature_inverse_mass(&c->b, p);
    vec3 impulse = vec3_scale((moved - speed * dt) / inverse_mass, c->normal);
    if (!(inverse_mass > 0) || !vec3_is_finite(impulse)) return;
    move_previous(&c->a, impulse, p);
    move_previous(&c->b, vec3_scale(-1, impulse), p);
}
