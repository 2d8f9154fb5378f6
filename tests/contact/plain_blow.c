//> plain-blow-point
//>   How fast a point closes beyond its gap, what an impulse changes, and which
//>   contacts have a body in common.
#include "plain_blow.h"

enum { A, B };

real plain_blow_parting(const plain_blow *x, const plain_touch *c, int k)
{
    real speed = real_max(c->gap[k], 0) / x->h;
    for (int side = A; side <= B && c->body[side] >= 0; side++) {
        int b = c->body[side];
        vec3 v = motion_at(&x->basis[b], &x->velocity[b], c->arm[side][k]);
        speed += (side == A ? 1 : -1) * vec3_dot(c->normal, v);
    }
    return speed;
}

// K, 1/kg: how much faster they part after a unit impulse.
static real answer_of(const plain_blow *x, const plain_touch *c, int k)
{
    real sum = 0;
    for (int side = A; side <= B && c->body[side] >= 0; side++) {
        const motion_basis *b = &x->basis[c->body[side]];
        vec3 moment = vec3_cross(c->arm[side][k], c->normal);
        sum = motion_answer(sum + b->inverse_mass, b, moment);
    }
    return sum;
}

// A gets the impulse along the normal, and B its opposite.
static void push(plain_blow *x, const plain_touch *c, int k, real impulse)
{
    for (int side = A; side <= B && c->body[side] >= 0; side++) {
        int b = c->body[side];
        vec3 all = vec3_scale(side == A ? impulse : -impulse, c->normal);
        motion_push(&x->velocity[b], &x->basis[b], c->arm[side][k], all);
    }
}

static bool closes(const plain_blow *x, const plain_touch *c, real slowest)
{
    bool some = false;
    for (int k = 0; k < c->points; k++)
        some |= plain_blow_parting(x, c, k) < -slowest;
    return some && !c->bounces;
}

static bool share_a_body(const plain_blow *x, const plain_touch *c,
                         const plain_touch *d)
{
    bool some = false;
    for (int k = 0; k < 4; k++) {
        int b = c->body[k / 2];
        some |= b >= 0 && b == d->body[k % 2] && x->basis[b].inverse_mass > 0;
    }
    return some;
}
//<

//> plain-blow
//>   A blow begins with one contact.  Its points are stopped, one after the other,
//>   until nothing changes; then whatever closes beside it joins, and all are
//>   stopped together.
// m/s, how much faster a point of c parts after it: the most.
static real stop_each(plain_blow *x, plain_touch *c)
{
    real most = 0;
    for (int k = 0; k < c->points; k++) {
        real was = c->impulse[k], answer = answer_of(x, c, k);
        c->impulse[k] = real_max(was - plain_blow_parting(x, c, k) / answer, 0);
        push(x, c, k, c->impulse[k] - was);
        most = real_max(most, fabs(c->impulse[k] - was) * answer);
    }
    return most;
}

static void stop(plain_blow *x)
{
    real most = 1;
    for (int n = 0; n < 100000 && most > 1e-13; n++) {
        most = 0;
        for (int i = 0; i < x->touches; i++)
            if (x->touch[i].wave > 0)
                most = real_max(most, stop_each(x, &x->touch[i]));
    }
}

// What closes beside a contact of an earlier wave joins in this one.
static bool spread(plain_blow *x, int wave)
{
    bool some = false;
    for (int i = 0; i < x->touches; i++) {
        plain_touch *c = &x->touch[i];
        bool joins = false;
        for (int j = 0; j < x->touches && c->wave == 0; j++) {
            const plain_touch *d = &x->touch[j];
            joins |= d->wave > 0 && d->wave < wave && share_a_body(x, c, d);
        }
        joins = joins && closes(x, c, x->slowest);
        if (joins) c->wave = wave;
        some |= joins;
    }
    return some;
}

// Does a heavy body strike a light one faster than a load makes them close?
static bool strikes(const plain_blow *x, const plain_touch *c)
{
    if (c->body[B] < 0) return false;
    real a = x->basis[c->body[A]].inverse_mass;
    real b = x->basis[c->body[B]].inverse_mass;
    real ratio = real_max(a, b) / real_min(a, b);
    return ratio > 1 && ratio < HUGE_VAL && closes(x, c, sqrt(ratio) * x->slowest);
}

int plain_blow_stop(plain_blow *x)
{
    int blows = 0;
    for (int i = 0; i < x->touches; i++) {
        if (!strikes(x, &x->touch[i])) continue;
        for (int j = 0; j < x->touches; j++) {
            x->touch[j].wave = j == i;
            for (int k = 0; k < CONTACT_POINTS; k++) x->touch[j].impulse[k] = 0;
        }
        int wave = 1;
        do stop(x);
        while (spread(x, ++wave));
        blows++;
    }
    return blows;
}
//<
