//> contact-gaps
//>   The gap of each point, where its bodies are now.
#include "contact.h"

#include <stddef.h>

// The height of the frame's centre along n, and of its three axes.
static void heights_along(vec3 n, const rigid_frame *f, real *center,
                          vec3 *axis)
{
    *center = vec3_dot(n, f->center);
    *axis = vec3_make(vec3_dot(n, f->axis[0]), vec3_dot(n, f->axis[1]),
                      vec3_dot(n, f->axis[2]));
}

void contact_gaps(const contact *c, const rigid_frame *a, const rigid_frame *b,
                  real height, real gap[CONTACT_POINTS])
{
    real center_a, center_b = height, out = c->round_a + c->round_b;
    vec3 axis_a, axis_b = { 0, 0, 0 };
    heights_along(c->normal, a, &center_a, &axis_a);
    if (b) heights_along(c->normal, b, &center_b, &axis_b);
    for (int k = 0; k < c->count; k++) {
        const contact_point *p = &c->point[k];
        gap[k] = center_a - center_b - out
               + vec3_dot(axis_a, p->local_a) - vec3_dot(axis_b, p->local_b);
    }
}
//<

//> contact-arms
//>   A ball that rolls touches with another point in every moment. So a round
//>   body keeps the point of its core, and impulses act a radius away from it.
contact_arms contact_sides_of(const contact *c, int k, const rigid_frame *a,
                              const rigid_frame *b)
{
    const contact_point *p = &c->point[k];
    contact_arms arm = { .a = frame_vector(a, p->local_a) };
    arm.a = vec3_add_scaled(arm.a, -c->round_a, c->normal);
    if (b) arm.b = vec3_add_scaled(frame_vector(b, p->local_b), c->round_b,
                                   c->normal);
    return arm;
}

// Both impulses act at one place: what one body gains of angular momentum the
// other loses.  It is where the vertex is, while the face slides along under it.
contact_arms contact_arms_of(const contact *c, int k, const rigid_frame *a,
                             const rigid_frame *b)
{
    const contact_point *p = &c->point[k];
    contact_arms arm = contact_sides_of(c, k, a, b);
    if (!b) return arm;
    vec3 delta = vec3_sub(a->center, b->center);
    vec3 seen = vec3_sub(arm.b, delta);     // B's point, from A's centre
    arm.a = vec3_add(vec3_scale(p->own, arm.a), vec3_scale(1 - p->own, seen));
    arm.b = vec3_add(arm.a, delta);
    return arm;
}
//<

//> contact-load
//>   In the next frame a contact may have other points. Each old point hands
//>   its impulse to the new point nearest to it.
real contact_load(const contact *c)
{
    real sum = 0;
    for (int k = 0; k < c->count; k++) sum += c->impulse[k];
    return sum;
}
//<

//> contact-inherit
//>   A point takes over the impulses of the point that was nearest to it in the
//>   frame before.
int contact_nearest(const contact *c, bool is_a, vec3 local)
{
    int best = 0;
    real least = HUGE_VAL;
    for (int k = 0; k < c->count; k++) {
        vec3 own = is_a ? c->point[k].local_a : c->point[k].local_b;
        real square = vec3_length_squared(vec3_sub(own, local));
        if (square < least) least = square, best = k;
    }
    return best;
}

// No impulse is lost, and none is given twice: a load that nothing carries
// would throw the pile up.  But an impulse along another normal would throw up
// what it has carried: it is not for this contact.
void contact_inherit(contact *now, const contact *was)
{
    contact_clear(now);
    if (now->count == 0 || !(vec3_dot(now->normal, was->normal) >= CONTACT_SAME))
        return;
    now->friction = was->friction;
    now->twist = was->twist;
    for (int k = 0; k < was->count; k++) {
        int to = contact_nearest(now, true, was->point[k].local_a);
        now->impulse[to] += was->impulse[k];
    }
}
//<
