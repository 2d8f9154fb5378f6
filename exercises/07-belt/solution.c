// solution.c - friction as it is seen from the belt.

#include "belt.h"

// The belt carries the place under the particle along by velocity * dt.  What
// the particle has moved beside that, across the normal, is sliding.
static vec3 slide_on_belt(const belt *b, const particle *p, real dt)
{
    vec3 moved = vec3_sub(p->position, p->previous);
    vec3 slide = vec3_add_scaled(moved, -dt, b->velocity);
    return vec3_add_scaled(slide, -vec3_dot(slide, b->normal), b->normal);
}

// Out by the whole overlap; back by the slide, or by as much of it as friction
// can hold.
real belt_push(const belt *b, particle *p, real dt)
{
    real depth = -vec3_dot(vec3_sub(p->position, b->point), b->normal);
    if (!(depth > 0)) return 0;
    if (!(p->inverse_mass > 0)) return depth;

    vec3 slide = slide_on_belt(b, p, dt);
    real limit = b->friction * depth, length = vec3_length(slide);
    real part = length <= limit ? 1 : limit / length;
    vec3 out = vec3_add_scaled(p->position, depth, b->normal);
    p->position = vec3_add_scaled(out, -part, slide);
    return depth;
}
