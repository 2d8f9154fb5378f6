//> plain-impact-step
//>   The substep: fly, strike, fly on. A point has touched if its gap is closed;
//>   when the first one does is halved down to the last digit.
#include "plain_impact.h"

enum { A, B };

// The bodies go on freely for t seconds.
static void fly(plain_impact *x, real t)
{
    for (int side = A; side <= B; side++) {
        plain_body *b = &x->body[side];
        if (b->basis.inverse_mass > 0)
            motion_advance(&b->frame, &b->basis, &b->velocity, t);
    }
}

// m: how far point k is open.
static real gap_of(const plain_impact *x, int k)
{
    vec3 a = frame_point(&x->body[A].frame, x->at[A][k]);
    vec3 b = frame_point(&x->body[B].frame, x->at[B][k]);
    return vec3_dot(x->normal, vec3_sub(a, b));
}

static bool has_touched_after(plain_impact x, real t)
{
    bool has = false;
    fly(&x, t);
    for (int k = 0; k < x.points; k++) has |= gap_of(&x, k) <= 0;
    return has;
}

static real time_of_touch(const plain_impact *x, real h)
{
    real before = 0, after = h;
    if (has_touched_after(*x, 0)) return 0;
    if (!has_touched_after(*x, h)) return h;
    for (int n = 0; n < 53; n++) {
        real middle = (before + after) / 2;
        if (has_touched_after(*x, middle)) after = middle;
        else before = middle;
    }
    return after;
}

static void strike(plain_impact *x, real later);

real plain_impact_step(plain_impact *x, real h)
{
    real t = time_of_touch(x, h);
    fly(x, t);
    if (t < h) strike(x, 1e-9 * h);
    fly(x, h - t);
    return t;
}
//<

//> plain-impact-strike
//>   The impact: point after point is stopped, again and again, until none closes
//>   and none pulls. Then all impulses act once more, e times as large.
// m, from a centre to A's point: both impulses act there, where a vertex of A
// meets a face of B.
static vec3 arm_of(const plain_impact *x, int side, int k)
{
    vec3 place = frame_point(&x->body[A].frame, x->at[A][k]);
    return vec3_sub(place, x->body[side].frame.center);
}

// m/s: how fast the two points of k part.
static real parting(const plain_impact *x, int k)
{
    const plain_body *a = &x->body[A], *b = &x->body[B];
    vec3 of_a = motion_at(&a->basis, &a->velocity, arm_of(x, A, k));
    vec3 of_b = motion_at(&b->basis, &b->velocity, arm_of(x, B, k));
    return vec3_dot(x->normal, vec3_sub(of_a, of_b));
}

// A gets the impulse along the normal, and B its opposite.
static void push(plain_impact *x, int k, real impulse)
{
    for (int side = A; side <= B; side++) {
        plain_body *b = &x->body[side];
        vec3 all = vec3_scale(side == A ? impulse : -impulse, x->normal);
        motion_push(&b->velocity, &b->basis, arm_of(x, side, k), all);
    }
}

// What takes part touches by so much later (s), and closes.
static void strike(plain_impact *x, real later)
{
    real impulse[CONTACT_POINTS] = { 0 }, most = 1;
    bool takes_part[CONTACT_POINTS];
    for (int k = 0; k < x->points; k++)
        takes_part[k] = gap_of(x, k) < later * -parting(x, k);
    for (int n = 0; n < 100000 && most > 1e-13; n++) {
        most = 0;
        for (int k = 0; k < x->points; k++) {
            if (!takes_part[k]) continue;
            real was = impulse[k], speed = parting(x, k);
            plain_impact pushed = *x;
            push(&pushed, k, 1);
            real answer = parting(&pushed, k) - speed;  // K, 1/kg
            impulse[k] = real_max(was - speed / answer, 0);
            push(x, k, impulse[k] - was);
            most = real_max(most, fabs(impulse[k] - was) * answer);
        }
    }
    for (int k = 0; k < x->points; k++)
        push(x, k, x->restitution * impulse[k]);
}
//<
