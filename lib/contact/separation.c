//> separation-feature
#include "separation.h"

response_options response_options_default(void)
{
    return (response_options){ .share = SHARE_MASS, .push = PUSH_OUT,
                               .gain = 1, .friction = 0.5, .restitution = 0 };
}

static int is_finite(real x)
{
    return x - x == 0;
}

// What a feature shows: its point, now and one step ago, and its inverse mass
// (1/kg).  The point is p = sum a_i x_i, the same mean of its vertices wherever
// they go.  A push of lambda at p moves x_i by w_i a_i lambda, and so p itself
// by sum a_i (w_i a_i lambda) = (sum w_i a_i^2) lambda: the bracket is 1/mass.
typedef struct {
    vec3 now, before;
    real inverse_mass;
} shown;

// One loop for all three: a vertex's numbers lie side by side, and a loop of
// one to three rounds is guessed wrongly by the processor as often as not.
static inline shown feature_show(const feature_point *f, const particle *p)
{
    shown q = { { 0, 0, 0 }, { 0, 0, 0 }, 0 };
    for (int i = 0; i < f->count; i++) {
        const particle *x = &p[f->vertex[i]];
        real a = f->weight[i];
        q.now = vec3_add_scaled(q.now, a, x->position);
        q.before = vec3_add_scaled(q.before, a, x->previous);
        q.inverse_mass += x->inverse_mass * a * a;
    }
    return q;
}

// B may be no feature at all, but a fixed point that has never moved.
static inline shown show_b(const contact *c, const particle *p)
{
    if (c->b.count == 0) return (shown){ c->fixed, c->fixed, 0 };
    return feature_show(&c->b, p);
}

vec3 feature_now(feature_point f, const particle *p)
{
    return feature_show(&f, p).now;
}

vec3 feature_before(feature_point f, const particle *p)
{
    return feature_show(&f, p).before;
}

real contact_gap(const contact *c, const particle *p)
{
    vec3 across = vec3_sub(feature_show(&c->a, p).now, show_b(c, p).now);
    return vec3_dot(across, c->normal) - c->thickness;
}
//<

//> separation-push
// push in kg m.  Nailed particles have w = 0.
static void push_now(const feature_point *f, particle *p, vec3 push)
{
    for (int i = 0; i < f->count; i++) {
        particle *x = &p[f->vertex[i]];
        real share = x->inverse_mass * f->weight[i];
        x->position = vec3_add_scaled(x->position, share, push);
    }
}

static void push_before(const feature_point *f, particle *p, vec3 push)
{
    for (int i = 0; i < f->count; i++) {
        particle *x = &p[f->vertex[i]];
        real share = x->inverse_mass * f->weight[i];
        x->previous = vec3_add_scaled(x->previous, share, push);
    }
}
//<

//> separation-carry
// Paper: Eqs 8 and 9.  Of all moves dx_i of the feature's particles with
// sum a_i dx_i = move, the one with the least sum |dx_i|^2:
//     dx_i = a_i / (sum a_j^2) move.
// Masses do not enter; nailed particles stay, and leave the sum.
static void carry(const feature_point *f, particle *p, vec3 move)
{
    real sum = 0;
    for (int i = 0; i < f->count; i++)
        if (p[f->vertex[i]].inverse_mass > 0)
            sum += f->weight[i] * f->weight[i];
    // Nobody free to carry it, or with so short a lever that it overflows.
    if (!(sum > 0)) return;
    vec3 whole = vec3_scale(1 / sum, move);
    if (!vec3_is_finite(whole)) return;
    for (int i = 0; i < f->count; i++) {
        particle *x = &p[f->vertex[i]];
        if (!(x->inverse_mass > 0)) continue;
        x->position = vec3_add_scaled(x->position, f->weight[i], whole);
    }
}

// Which part of the overlap is A's to mend, when whole bodies are weighed:
// q = (mA pA + mB pB) / (mA + mB) lies mB / (mA + mB) of the way from pA to pB.
// Written with the ratio of the masses, so that one of them may be infinite.
// Paper: Eq. 10 has mA and mB exchanged; here: both, because the error is worth
// seeing.  As printed, A beside an immovable B would never move; an immovable
// side therefore takes nothing under any rule.
static real part_of_a(const contact *c, share_rule rule, int a_moves,
                      int b_moves)
{
    if (!b_moves || !a_moves) return a_moves ? 1 : 0;
    real ratio = rule == SHARE_PRINTED ? c->mass_b / c->mass_a
                                       : c->mass_a / c->mass_b;
    real part = 1 / (1 + ratio);
    return part >= 0 ? part : (real)0.5;     // infinite / infinite
}

// A's point by part * move along the normal, B's by the rest the other way.
static void carry_both(const contact *c, particle *p, real part, real move)
{
    carry(&c->a, p, vec3_scale(part * move, c->normal));
    carry(&c->b, p, vec3_scale((part - 1) * move, c->normal));
}
//<

//> separation-friction
// How much of the sliding s (m, across the normal) friction may undo, 0 to 1.
// Coulomb: |friction| <= mu |normal force|.  Both act through the same inverse
// mass, over the same step, so in positions it reads: the sliding that is taken
// back is at most mu times the overlap that is.  Less than that: it sticks.
static real braked_part(real mu, real depth, vec3 s)
{
    real limit = mu * depth;
    real slid2 = vec3_length_squared(s);
    if (slid2 <= limit * limit) return limit > 0 ? 1 : 0;
    return limit / sqrt(slid2);
}

// What the features have slid past each other since the step began.
static vec3 sliding(const shown *a, const shown *b, vec3 normal)
{
    vec3 s = vec3_sub(vec3_sub(a->now, b->now),
                      vec3_sub(a->before, b->before));
    return vec3_add_scaled(s, -vec3_dot(s, normal), normal);
}
//<

//> contact-separate
// Least move: minimise sum |dx_i|^2 / (2 w_i) over both features subject to
// the gap closing, sum a_i dx_i.n - sum b_j dx_j.n = depth.  Lagrange:
//     dx_i = w_i a_i lambda n,  dx_j = -w_j b_j lambda n,
//     lambda = depth / (sum w_i a_i^2 + sum w_j b_j^2).
// Then sum m dx = lambda n (sum a_i - sum b_j) = 0: momentum stays.
// Paper: Eqs 8 to 10 weigh whole bodies; here: the features, because only they
// move.
real contact_separate(contact *c, particle *p, response_options options)
{
    shown a = feature_show(&c->a, p), b = show_b(c, p);
    real depth = c->thickness - vec3_dot(vec3_sub(a.now, b.now), c->normal);
    if (!(depth > 0)) return 0;

    // Where bodies are weighed, an infinite mass overrules the particles'.
    if (options.share != SHARE_MASS) {
        if (!is_finite(c->mass_a)) a.inverse_mass = 0;
        if (!is_finite(c->mass_b)) b.inverse_mass = 0;
    }
    // Neither side moves; or so little that the push would overflow.
    real weight = a.inverse_mass + b.inverse_mass;
    if (!(weight > 0)) return depth;
    real mass = 1 / weight, lambda = options.gain * depth * mass;
    if (!is_finite(mass) || !is_finite(lambda)) return depth;
    c->pushed += depth;

    vec3 push = { 0, 0, 0 };
    if (options.share == SHARE_MASS)
        push = vec3_scale(lambda, c->normal);
    else
        carry_both(c, p, part_of_a(c, options.share, a.inverse_mass > 0,
                                   b.inverse_mass > 0),
                   options.gain * depth);

    // The normal push leaves the sliding as it was, so one pass applies both.
    if (options.friction > 0) {
        vec3 s = sliding(&a, &b, c->normal);
        real part = braked_part(options.friction, depth, s);
        push = vec3_add_scaled(push, -part * mass, s);
        // The push times the mean slide: s before, (1 - part) s after.
        c->worn -= part * (1 - part / 2) * mass * vec3_length_squared(s);
    }
    if (a.inverse_mass > 0) push_now(&c->a, p, push);
    if (b.inverse_mass > 0) push_now(&c->b, p, vec3_scale(-1, push));
    return depth;
}
//<

//> contact-bounce
// With u the speed at which the points part, measured over the step as Verlet
// measures it, ((pA - pB) - (pA - pB)_before).n / dt, and u' the speed they are
// to have, the previous points must part by (u' - u) dt less than they did: a
// push of (u - u') dt on them, shared like any other, so momentum stays.  The
// positions, which are apart now, are not touched.
void contact_bounce(const contact *c, particle *p, response_options options,
                    real dt)
{
    shown a = feature_show(&c->a, p), b = show_b(c, p);
    real weight = a.inverse_mass + b.inverse_mass;
    if (!(c->pushed > 0 && weight > 0)) return;
    vec3 moved = vec3_sub(vec3_sub(a.now, b.now),
                          vec3_sub(a.before, b.before));

    // A pair that was parting when it was met keeps that speed.
    real speed = c->approach > 0 ? options.restitution * c->approach
                                 : -c->approach;
    real lambda = (vec3_dot(moved, c->normal) - speed * dt) / weight;
    if (!is_finite(lambda)) return;
    push_before(&c->a, p, vec3_scale(lambda, c->normal));
    push_before(&c->b, p, vec3_scale(-lambda, c->normal));
}
//<

//> sphere-contact-separate
// The same with one particle a side, all weights 1 and the normal along the
// line between them.  No gain: a particle of a cloth or a rope keeps what it is
// given, its sticks being solved afterwards without a body to pull it back.
real sphere_contact_separate(sphere_contact c, particle *p,
                             response_options options)
{
    particle *a = &p[c.a], *b = &p[c.b];
    vec3 across = vec3_sub(a->position, b->position);
    real length2 = vec3_length_squared(across);
    if (!sphere_contact_overlaps(&c, p) || !(length2 > 0)) return 0;

    real length = sqrt(length2), depth = c.distance - length;
    if (!(depth > 0)) return 0;
    real weight = a->inverse_mass + b->inverse_mass;
    if (!(weight > 0)) return depth;
    real mass = 1 / weight;
    if (!is_finite(mass) || !is_finite(depth * mass)) return depth;

    vec3 normal = vec3_scale(1 / length, across);
    vec3 push = vec3_scale(depth * mass, normal);
    if (options.friction > 0) {
        vec3 s = vec3_sub(across, vec3_sub(a->previous, b->previous));
        s = vec3_add_scaled(s, -vec3_dot(s, normal), normal);
        real part = braked_part(options.friction, depth, s);
        push = vec3_add_scaled(push, -part * mass, s);
    }
    a->position = vec3_add_scaled(a->position, a->inverse_mass, push);
    b->position = vec3_add_scaled(b->position, -b->inverse_mass, push);
    return depth;
}
//<

//> leaves-separate
// Every particle of a leaf by the same vector; nailed ones stay.
static void shift(const int *feature, int n, particle *p, vec3 by)
{
    for (int i = 0; i < n; i++) {
        particle *x = &p[feature[i]];
        if (x->inverse_mass > 0) x->position = vec3_add(x->position, by);
    }
}

// Paper: Eq. 11, d = ((rA + rB) / |cB - cA| - 1) (cB - cA), A moves by -d/2 and
// B by d/2.  |d| is the overlap, and its direction needs centres that differ.
real leaves_separate(const int *fa, int na, vec3 ca, real ra,
                     const int *fb, int nb, vec3 cb, real rb, particle *p)
{
    vec3 between = vec3_sub(cb, ca);
    real length = vec3_length(between);
    real depth = ra + rb - length;
    if (!(length > 0 && depth > 0) || !is_finite(depth)) return 0;

    vec3 half = vec3_scale(depth / 2, vec3_scale(1 / length, between));
    shift(fa, na, p, vec3_scale(-1, half));
    shift(fb, nb, p, half);
    return depth;
}
//<

//> deformable-separate
// Paper: d = pB - cA, and A moves as in Eq. 11, by -d/2; but cA lies inside B
// and pB on its surface, so that is the way in.  Here: +d/2, unless the printed
// sign is asked for.  B's point moves to the midpoint, by -d/2, in both.
void deformable_separate(const int *fa, int na, vec3 ca, feature_point b,
                         vec3 pb, particle *p, response_options options)
{
    vec3 half = vec3_scale((real)0.5, vec3_sub(pb, ca));
    vec3 in = vec3_scale(-1, half);
    shift(fa, na, p, options.push == PUSH_PRINTED ? in : half);
    carry(&b, p, in);
}
//<
