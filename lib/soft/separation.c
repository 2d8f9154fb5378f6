//> separation-friction
//>   The push goes along the normal, and friction across it. What is divided may
//>   be zero or beyond all numbers, so each quotient is looked at before it is used.
#include "separation.h"

static bool is_finite(real x)
{
    return x - x == 0;
}

// The impulse times the substep (kg m) that takes back an overlap of `depth`
// (m) along the normal, where the particles slid past each other by s (m) in
// this step, and a unit push parts them by 1/mass.  Coulomb: |friction| <= mu
// |normal force|.  Both act through the same inverse mass, over the same step,
// so in positions it reads: the sliding that is taken back is at most mu times
// the overlap that is.  Less than that: it sticks.
static vec3 push_apart(vec3 normal, real depth, real mass, vec3 s,
                       real friction)
{
    vec3 push = vec3_scale(depth * mass, normal);
    if (!(friction > 0)) return push;
    s = vec3_add_scaled(s, -vec3_dot(s, normal), normal);
    real limit = friction * depth, slid2 = vec3_length_squared(s);
    real part = slid2 <= limit * limit ? limit > 0 : limit / sqrt(slid2);
    return vec3_add_scaled(push, -part * mass, s);
}
//<

//> particle-contact-separate
//>   Two particles share the push by their masses.
real particle_contact_separate(particle_contact c, particle *p, real friction)
{
    particle *a = &p[c.a], *b = &p[c.b];
    vec3 across = vec3_sub(a->position, b->position);
    real length2 = vec3_length_squared(across);
    if (!particle_contact_overlaps(&c, p) || !(length2 > 0)) return 0;

    real length = sqrt(length2), depth = c.distance - length;
    if (!(depth > 0)) return 0;
    real weight = a->inverse_mass + b->inverse_mass;
    real mass = 1 / weight;
    if (!(weight > 0) || !is_finite(depth * mass)) return depth;

    // One that never moves can have lost where it was, and not where it is.
    vec3 slid = vec3_sub(across, vec3_sub(a->previous, b->previous));
    if (!vec3_is_finite(slid)) return 0;
    vec3 normal = vec3_scale(1 / length, across);
    vec3 push = push_apart(normal, depth, mass, slid, friction);
    a->position = vec3_add_scaled(a->position, a->inverse_mass, push);
    b->position = vec3_add_scaled(b->position, -b->inverse_mass, push);
    return depth;
}
//<

//> particle-contact-brake
//>   Once all are parted, friction brakes each pair.
void particle_contact_brake(particle_contact c, particle *p, vec3 drawn, real most)
{
    particle *a = &p[c.a], *b = &p[c.b];
    vec3 across = vec3_sub(a->position, b->position), up = vec3_unit(across);
    vec3 slid = vec3_sub(across, vec3_sub(a->previous, b->previous));
    slid = vec3_add(slid, drawn);
    slid = vec3_add_scaled(slid, -vec3_dot(slid, up), up);
    real far = vec3_length(slid), weight = a->inverse_mass + b->inverse_mass;
    real fraction = real_min(most / far, 1) / weight;
    if (!(far > 0) || !(most > 0) || !is_finite(far * fraction)) return;
    a->position = vec3_add_scaled(a->position, -fraction * a->inverse_mass, slid);
    b->position = vec3_add_scaled(b->position, fraction * b->inverse_mass, slid);
}
//<

//> surface-separate
//>   A surface does not move, so the particle takes all of it.
real surface_separate(particle *p, vec3 foot, vec3 normal, real distance,
                      real friction)
{
    vec3 over = vec3_sub(p->position, foot), was = vec3_sub(p->previous, foot);
    real depth = distance - vec3_dot(over, normal), w = p->inverse_mass;
    if (!(depth > 0)) return 0;
    real mass = 1 / w;
    if (!(w > 0) || !is_finite(depth * mass)) return depth;
    vec3 push = push_apart(normal, depth, mass, vec3_sub(over, was), friction);
    p->position = vec3_add_scaled(p->position, w, push);
    return depth;
}
//<
