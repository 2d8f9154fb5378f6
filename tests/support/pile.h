// pile.h - bodies and contacts made by hand, for the tests of the solver.
//
// Needs check.h before it.

#ifndef TUMBLE_PILE_H
#define TUMBLE_PILE_H

#include "plain_solver.h"
#include "solids.h"

enum { PILE_BODIES = 400, PILE_CONTACTS = 1200 };

typedef struct {
    solver_body body[PILE_BODIES];
    contact     contact[PILE_CONTACTS];
    real        reach[PILE_CONTACTS];
    motion      velocity[PILE_BODIES + 1], moved[PILE_BODIES + 1];
    plane       plane[2];
    int         contacts;
    solver_frame frame;
} pile;

static const vec3 GRAVITY = { 0, -9.81, 0 };

// The contacts are found anew: what a solver has kept of them is not good.
static inline void pile_find(pile *p)
{
    static long found;
    for (int k = 0; k < p->contacts; k++) p->contact[k].found = ++found;
}

static inline void pile_clear(pile *p)
{
    *p = (pile){ .plane = { { { 0, 1, 0 }, 0 }, { { 0, 1, 0 }, -1 } } };
    p->frame = (solver_frame){ .body = p->body, .plane = p->plane,
        .h = 1.0 / 480, .warm = 1, .friction = 0.5, .hertz = 60, .damping = 10,
        .max_rate = 3 };
}

// A solid box, upright: static if its mass is 0.
static inline int pile_box(pile *p, vec3 at, vec3 sides, real mass)
{
    solver_body *b = &p->body[p->frame.bodies];
    const real s[3] = { sides.x, sides.y, sides.z };
    *b = (solver_body){ .frame.center = at, .radius = vec3_length(sides) / 2 };
    for (int i = 0; i < 3; i++) {
        real moment = mass / 12 * (s[(i + 1) % 3] * s[(i + 1) % 3]
                                   + s[(i + 2) % 3] * s[(i + 2) % 3]);
        vec3 axis = { i == 0, i == 1, i == 2 };
        b->frame.axis[i] = vec3_scale(s[i] / 2, axis);
        if (mass > 0) b->basis.turn[i] = vec3_scale(1 / sqrt(moment), axis);
    }
    if (mass > 0) b->basis.inverse_mass = 1 / mass;
    return p->frame.bodies++;
}

static inline vec3 local_in(const rigid_frame *frame, vec3 arm)
{
    real x[3];
    for (int i = 0; i < 3; i++)
        x[i] = vec3_dot(arm, frame->axis[i])
             / vec3_length_squared(frame->axis[i]);
    return vec3_make(x[0], x[1], x[2]);
}

// The contact of a with b (or with plane -1 - b), without points.
static inline contact *pile_contact(pile *p, int a, int b, vec3 normal)
{
    contact *c = &p->contact[p->contacts];
    ck_assert_int_lt(p->contacts, PILE_CONTACTS);
    *c = (contact){ .a = a, .b = b, .normal = normal };
    p->reach[p->contacts++] = HUGE_VAL;
    return c;
}

// One more point: arms from both centres, of which B's, or A's over a plane, is moved
// along the normal, where it makes that gap.
static inline void pile_point(pile *p, contact *c, vec3 arm_a, vec3 arm_b,
                              real gap)
{
    contact_point *q = &c->point[c->count++];
    const rigid_frame *a = &p->body[c->a].frame;
    real up = vec3_dot(c->normal, vec3_add(a->center, arm_a));
    *q = (contact_point){ .own = 1 };
    if (c->b >= 0) {
        const rigid_frame *b = &p->body[c->b].frame;
        up -= vec3_dot(c->normal, vec3_add(b->center, arm_b));
        arm_b = vec3_add_scaled(arm_b, up - gap, c->normal);
        q->local_b = local_in(b, arm_b);
    } else {
        up -= p->plane[-1 - c->b].offset;
        arm_a = vec3_add_scaled(arm_a, gap - up, c->normal);
    }
    q->local_a = local_in(a, arm_a);
}

// --- chance ------------------------------------------------------------------

static inline int any_below(int n)
{
    int k = (int)(random_fraction(&seed) * n);
    return k < n ? k : n - 1;
}

// Some mass between 10^-d and 10^d; every eighth body is static.
static inline void pile_any_body(pile *p, int decades)
{
    vec3 at = random_vec3(&seed, 3);
    vec3 sides = { 1 + random_real(&seed) / 2, 1 + random_real(&seed) / 2,
                   1 + random_real(&seed) / 2 };
    real mass = 1;
    for (int k = 0; k < decades; k++) mass *= random_real(&seed) > 0 ? 5 : 0.2;
    int i = pile_box(p, at, sides, any_below(8) ? mass : 0);
    matrix turn = any_rotation();
    solver_body *b = &p->body[i];
    for (int t = 0; t < 3; t++) {
        b->frame.axis[t] = times(&turn, b->frame.axis[t]);
        b->basis.turn[t] = times(&turn, b->basis.turn[t]);
    }
    for (int k = 0; k < MOTIONS && b->basis.inverse_mass > 0; k++)
        p->velocity[i].of[k] = random_real(&seed);
}

// A contact of any two bodies, that pushed a little before.  If `meeting`, its
// points are the same places on both.
static inline void pile_any_contact(pile *p, int a, int b, bool meeting)
{
    contact *c = pile_contact(p, a, b, b < 0 ? p->plane[-1 - b].normal
                                             : random_direction(&seed));
    int count = 1 + any_below(4);
    for (int k = 0; k < count; k++) {
        vec3 arm_a = random_vec3(&seed, 0.7);
        vec3 arm_b = random_vec3(&seed, 0.7);
        vec3 there = vec3_add(p->body[a].frame.center, arm_a);
        if (meeting && b >= 0)
            arm_b = vec3_sub(there, p->body[b].frame.center);
        pile_point(p, c, arm_a, arm_b, 0.01 * random_real(&seed));
        c->impulse[k] = real_max(0, 1e-3 * random_real(&seed));
        if (b >= 0) c->point[k].own = any_below(3) / 2.0;
    }
    c->friction = random_vec3(&seed, 1e-4);
    c->twist = 1e-5 * random_real(&seed);
}

static inline void pile_any(pile *p, int bodies, int contacts, int decades)
{
    pile_clear(p);
    for (int k = 0; k < bodies; k++) pile_any_body(p, decades);
    for (int k = 0; k < contacts; k++) {
        int a = any_below(bodies), b = any_below(bodies);
        if (a == b) b = contact_with_plane(any_below(2));
        pile_any_contact(p, a, b, false);
    }
}

#endif
