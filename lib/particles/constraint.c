//> correction
// constraint.c - distance constraints ("sticks") and angle constraints.
//
// Paper: section 3.2.  Book: chapter 2.

#include "constraint.h"

#include <assert.h>
#include <math.h>

// How a stick corrects its ends: a moves by w_a k along `along`, b by w_b k the
// other way, with k = error / divisor.  Its strain is error / scale.
typedef struct {
    vec3 along;         // m, from a towards b
    real error, scale;  // both in m, or both in m^2; error > 0: too long
    real divisor;
    bool possible;      // false: no direction to move along, or both pinned
} correction;

// The exact length: error = length - L is shared by inverse mass,
//     w_a k length + w_b k length = error.
static inline correction correction_exact(stick s, const particle *a,
                                          const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along);
    real error = length - s.rest_length;
    real divisor = length * (a->inverse_mass + b->inverse_mass);
    return (correction){ along, error, s.rest_length, divisor, divisor > 0 };
}
//<

//> correction-approximate
// One Newton step for the root of d^2 = along . along, from L:
//     length ~ (d^2 + L^2) / (2 L),   error ~ (d^2 - L^2) / (2 L).
// The 2 L cancels in error / length, and no root is left.
static inline correction correction_approximate(stick s, const particle *a,
                                                const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    real now = vec3_length_squared(along);
    real rest = s.rest_length * s.rest_length;
    real w = a->inverse_mass + b->inverse_mass;
    return (correction){ along, now - rest, 2 * rest, (now + rest) * w,
                         now * w > 0 };
}
//<

//> correction-old
// A stick that has turned by more than about 83 degrees in one step cannot be
// corrected along its old direction: along . old <= L^2 / 8.
static const real TURNED = 0.125;

// Move along old, the stick as it lay one step ago, by k:
//     |along - k (w_a + w_b) old|^2 = L^2
// and, to first order in k:
//     d^2 - L^2 = 2 k (w_a + w_b) along . old.
static inline correction correction_old(stick s, const particle *a,
                                        const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    vec3 old = vec3_sub(b->previous, a->previous);
    real rest = s.rest_length * s.rest_length;
    real w = a->inverse_mass + b->inverse_mass;
    real both = vec3_dot(along, old);
    return (correction){ old, vec3_length_squared(along) - rest, 2 * rest,
                         2 * both * w, both > TURNED * rest && w > 0 };
}
//<

//> correction-apply
// The error that counts: that of a satisfied inequality is 0.  NaN stays NaN.
static inline real active_error(stick_kind kind, real error)
{
    if (kind == STICK_AT_LEAST && error > 0) return 0;
    if (kind == STICK_AT_MOST && error < 0) return 0;
    return error;
}

// An error to report: NaN becomes infinity, which no comparison overlooks.
static inline real reported(real error)
{
    return error == error ? error : HUGE_VAL;
}

// Moves both ends, unless the strain is within slop.  Returns true if it did.
static inline bool apply(correction c, stick s, particle *a, particle *b,
                         real slop)
{
    if (fabs(c.error) <= slop * c.scale || !c.possible) return false;

    real k = s.stiffness * c.error / c.divisor;
    a->position = vec3_add_scaled(a->position, k * a->inverse_mass, c.along);
    b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, c.along);
    return true;
}
//<

//> stick-relax
relax_options relax_options_default(void)
{
    return (relax_options){ .root = ROOT_EXACT, .gradient = GRADIENT_OLD,
                            .tolerance = 1e-4, .dead_band = false };
}

relax_options relax_options_pbd(void)
{
    relax_options o = relax_options_default();
    o.gradient = GRADIENT_NEW;
    return o;
}

// Corrects s by the way that the options name.
static inline bool relax(stick s, particle *p, relax_options options,
                         correction *c)
{
    particle *a = &p[s.a], *b = &p[s.b];
    real slop = options.dead_band ? options.tolerance : 0;
    *c = options.gradient == GRADIENT_OLD ? correction_old(s, a, b)
       : options.root == ROOT_APPROXIMATE ? correction_approximate(s, a, b)
                                          : correction_exact(s, a, b);
    c->error = active_error(s.kind, c->error);
    return apply(*c, s, a, b, slop);
}

stick_result stick_relax(stick s, particle *p, relax_options options)
{
    assert(s.a != s.b && s.rest_length > 0 && s.stiffness > 0);
    correction c;
    bool moved = relax(s, p, options, &c);
    return (stick_result){ reported(c.error / c.scale * s.rest_length), moved };
}

real stick_strain(stick s, const particle *p)
{
    correction c = correction_exact(s, &p[s.a], &p[s.b]);
    return reported(fabs(active_error(s.kind, c.error) / c.scale));
}
//<

//> sticks-iterate
relax_result sticks_iterate(const stick *s, int n, particle *p,
                            relax_options options)
{
    assert(n >= 0 && options.tolerance >= 0);
    relax_result r = { .tested = n, .iterations = 1 };
    for (int i = 0; i < n; i++) {
        correction c;
        r.relaxed += relax(s[i], p, options, &c);
        // Written with ! so that NaN, which fails every comparison, enters.
        if (!(fabs(c.error) <= r.worst * c.scale))
            r.worst = reported(fabs(c.error) / c.scale);
    }
    return r;
}
//<

//> sticks-relax
relax_result sticks_relax(const stick *s, int n, particle *p,
                          int most_iterations, relax_options options)
{
    relax_result all = { .worst = 0 };
    for (int k = 0; k < most_iterations; k++) {
        relax_result r = sticks_iterate(s, n, p, options);
        all.worst = r.worst;
        all.tested += r.tested;
        all.relaxed += r.relaxed;
        all.iterations++;
        if (r.worst <= options.tolerance) break;
    }
    return all;
}
//<

//> angle-gradients
//>   A move of an arm's end turns its unit vector $`u`$ by the part of the move
//>   across $`u`$, divided by the arm's length. In the product with $`v`$ only
//>   the part of $`v`$ across $`u`$ counts, so the gradient at that end is $`(v
//>   - (u \cdot v)\,u)/U`$. If all three particles move alike, nothing changes:
//>   the three gradients add up to zero.
// Arms whose sine is below this are in one line, as far as rounding can tell.
static const real STRAIGHT = 1e-8;

// The cosine c = u . v of unit arms u and v, whose lengths are U and V, grows
// by the sum of gradient . move over the three particles:
//     at a: (v - c u) / U,   at b: (u - c v) / V,
// and at the corner minus both, because c is the same if all three move alike.
typedef struct {
    vec3 gradient[3];   // 1/m, at a, b and the corner
    real cosine, sine;
    bool has_arms;      // false: an arm has no length
} elbow;

static elbow elbow_at(angle c, const particle *p)
{
    vec3 u = vec3_sub(p[c.a].position, p[c.corner].position);
    vec3 v = vec3_sub(p[c.b].position, p[c.corner].position);
    real U = vec3_length(u), V = vec3_length(v);
    if (U == 0 || V == 0) return (elbow){ .has_arms = false };

    u = vec3_scale(1 / U, u);
    v = vec3_scale(1 / V, v);
    elbow e = { .cosine = vec3_dot(u, v), .has_arms = true };
    e.sine = vec3_length(vec3_cross(u, v));
    e.gradient[0] = vec3_scale(1 / U, vec3_add_scaled(v, -e.cosine, u));
    e.gradient[1] = vec3_scale(1 / V, vec3_add_scaled(u, -e.cosine, v));
    e.gradient[2] = vec3_scale(-1, vec3_add(e.gradient[0], e.gradient[1]));
    return e;
}
//<

//> angle-relax
//>   Each particle moves along its gradient, in proportion to its inverse mass,
//>   with one factor for all three.
// The least move, weighed by mass, that takes C away is k w gradient, with
//     k = -C / (sum of w |gradient|^2).
// C is cut off at the sine, which turns an arm by one radian: near the straight
// line the gradients are small, and the whole C would whirl the arms round.
stick_result angle_relax(angle c, particle *p)
{
    assert(c.a != c.b && c.a != c.corner && c.b != c.corner);
    assert(c.cosine >= -1 && c.cosine <= 1);
    elbow e = elbow_at(c, p);
    if (!e.has_arms) return (stick_result){ 0, false };

    const int at[3] = { c.a, c.b, c.corner };
    stick_result r = { reported(e.cosine - c.cosine), false };
    real sum = 0;
    for (int i = 0; i < 3; i++)
        sum += p[at[i]].inverse_mass * vec3_length_squared(e.gradient[i]);
    if (r.error == 0 || !(e.sine > STRAIGHT && sum > 0)) return r;

    real C = real_max(-e.sine, real_min(e.sine, r.error));
    real k = -c.stiffness * C / sum;
    for (int i = 0; i < 3; i++) {
        particle *q = &p[at[i]];
        q->position = vec3_add_scaled(q->position, k * q->inverse_mass,
                                      e.gradient[i]);
    }
    r.moved = true;
    return r;
}
//<
