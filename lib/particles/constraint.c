//> stick-pull
// constraint.c - sticks: two particles at a fixed distance.
//
// Paper: section 3.2.  Book: chapter 2.

#include "constraint.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// What a stick asks of its ends: a moves by w_a (error / bottom) along, b by as
// much the other way, with w_b.  Its strain is error / size, a division that
// nobody needs who can compare error with a multiple of size.
typedef struct {
    vec3 along;         // m, from a towards b
    real error, size;   // both m, or both m^2; error > 0: too long
    real bottom;        // what the error is divided by
    int  able;          // 0: no direction to push along, or nobody to push
} pull;

// length - L = error is shared out by inverse mass:
//     w_a k + w_b k = error,   along / length = the direction.
static inline pull pull_exact(stick s, const particle *a, const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along);
    real error = length - s.rest_length;
    real bottom = length * (a->inverse_mass + b->inverse_mass);
    return (pull){ along, error, s.rest_length, bottom, bottom > 0 };
}
//<

//> stick-pull-approximate
// One Newton step for the root of d^2 = along . along, from L:
//     length ~ (d^2 + L^2) / (2 L),   error ~ (d^2 - L^2) / (2 L).
// In error / length the 2 L goes out, and no root is left.
static inline pull pull_approximate(stick s, const particle *a,
                                    const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    real now = vec3_length_squared(along);
    real rest = s.rest_length * s.rest_length;
    real weight = a->inverse_mass + b->inverse_mass;
    return (pull){ along, now - rest, 2 * rest, (now + rest) * weight,
                   now * weight > 0 };
}
//<

//> stick-pull-old
// A stick whose direction of one step ago makes more than about 83 degrees with
// the present one cannot be mended along it: along . old <= L^2 / 8.
static const real TURNED = 0.125;

// Push along old, the stick as it lay one step ago, by g:
//     |along - g (w_a + w_b) old|^2 = L^2
// and, to first order in g:
//     d^2 - L^2 = 2 g (w_a + w_b) along . old.
static inline pull pull_old(stick s, const particle *a, const particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    vec3 old = vec3_sub(b->previous, a->previous);
    real rest = s.rest_length * s.rest_length;
    real weight = a->inverse_mass + b->inverse_mass;
    real both = vec3_dot(along, old);
    return (pull){ old, vec3_length_squared(along) - rest, 2 * rest,
                   2 * both * weight, both > TURNED * rest && weight > 0 };
}
//<

//> stick-follow
// The error that counts: a one-sided stick is content on its free side.  Most
// have no such side.  That is asked first: a sign of an error is as good as
// tossed, and a processor that has guessed it wrong begins anew.
static inline real error_counted(stick_kind kind, real error)
{
    if (kind == STICK_EXACT) return error;
    if (kind == STICK_AT_LEAST && error > 0) return 0;
    if (kind == STICK_AT_MOST && error < 0) return 0;
    return error;
}

// An error to report: one that is not a number shows as infinite.
static inline real error_shown(real error)
{
    return error == error ? error : HUGE_VAL;
}

// Does what the stick asks, unless its strain is within band.
static inline int pull_follow(pull q, stick s, particle *a, particle *b,
                              real band)
{
    if (fabs(q.error) <= band * q.size || !q.able) return 0;

    real k = s.stiffness * q.error / q.bottom;
    a->position = vec3_add_scaled(a->position, k * a->inverse_mass, q.along);
    b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, q.along);
    return 1;
}
//<

//> stick-relax
relax_options relax_options_default(void)
{
    return (relax_options){ .root = ROOT_EXACT, .gradient = GRADIENT_NEW,
                            .tolerance = 1e-4, .dead_band = 0 };
}

stick_result stick_relax(stick s, particle *p, relax_options options)
{
    assert(s.a != s.b && s.rest_length > 0 && s.stiffness > 0);
    particle *a = &p[s.a], *b = &p[s.b];
    real band = options.dead_band ? options.tolerance : 0;

    pull q = options.gradient == GRADIENT_OLD ? pull_old(s, a, b)
           : options.root == ROOT_APPROXIMATE ? pull_approximate(s, a, b)
                                              : pull_exact(s, a, b);
    q.error = error_counted(s.kind, q.error);
    int moved = pull_follow(q, s, a, b, band);
    return (stick_result){ error_shown(q.error / q.size * s.rest_length),
                           moved };
}

real stick_strain(stick s, const particle *p)
{
    pull q = pull_exact(s, &p[s.a], &p[s.b]);
    return error_shown(fabs(error_counted(s.kind, q.error) / q.size));
}
//<

//> sticks-sweep
// One stick of a sweep, in whichever of the three ways made q.
static inline void sweep_stick(relax_result *r, pull q, stick s, particle *p,
                               real band)
{
    q.error = error_counted(s.kind, q.error);
    r->relaxed += pull_follow(q, s, &p[s.a], &p[s.b], band);
    // A new worst, which is rare; so put that a NaN passes too, and is shown.
    if (!(fabs(q.error) <= r->worst * q.size))
        r->worst = error_shown(fabs(q.error) / q.size);
}

// One loop for each way, so that no loop chooses: this is the hottest of all.
relax_result sticks_sweep(const stick *s, int n, particle *p,
                          relax_options options)
{
    assert(n >= 0 && options.tolerance >= 0);
    relax_result r = { .tested = n, .sweeps = 1 };
    real band = options.dead_band ? options.tolerance : 0;

    if (options.gradient == GRADIENT_OLD)
        for (int i = 0; i < n; i++)
            sweep_stick(&r, pull_old(s[i], &p[s[i].a], &p[s[i].b]),
                        s[i], p, band);
    else if (options.root == ROOT_APPROXIMATE)
        for (int i = 0; i < n; i++)
            sweep_stick(&r, pull_approximate(s[i], &p[s[i].a], &p[s[i].b]),
                        s[i], p, band);
    else
        for (int i = 0; i < n; i++)
            sweep_stick(&r, pull_exact(s[i], &p[s[i].a], &p[s[i].b]),
                        s[i], p, band);
    return r;
}
//<

//> sticks-sweep-until
// A strain beyond which the old gradient is held to have failed.
static const real OLD_FAILED = 1e-3;

static relax_result sweep_until(const stick *s, int n, particle *p,
                                int max_sweeps, relax_options options)
{
    relax_result all = { .worst = 0 };
    for (int k = 0; k < max_sweeps; k++) {
        relax_result r = sticks_sweep(s, n, p, options);
        all.worst = r.worst;
        all.tested += r.tested;
        all.relaxed += r.relaxed;
        all.sweeps += r.sweeps;
        if (r.worst <= options.tolerance) break;
    }
    return all;
}

// The worst strain of a stick that is not soft.
static real worst_hard(const stick *s, int n, const particle *p)
{
    real worst = 0;
    for (int i = 0; i < n; i++) {
        real strain = s[i].stiffness < 1 ? 0 : stick_strain(s[i], p);
        if (strain > worst) worst = strain;
    }
    return worst;
}
//<

//> sticks-relax
relax_result sticks_relax(const stick *s, int n, particle *p,
                          int particle_count, int max_sweeps,
                          relax_options options, vec3 *scratch)
{
    if (options.gradient == GRADIENT_NEW)
        return sweep_until(s, n, p, max_sweeps, options);

    assert(scratch || particle_count == 0);
    for (int i = 0; i < particle_count; i++) scratch[i] = p[i].position;
    relax_result old = sweep_until(s, n, p, max_sweeps, options);
    real limit = fmax(OLD_FAILED, options.tolerance);
    if (old.worst <= limit || worst_hard(s, n, p) <= limit) return old;

    // The old direction led nowhere: begin again, along the new one.
    for (int i = 0; i < particle_count; i++) p[i].position = scratch[i];
    options.gradient = GRADIENT_NEW;
    relax_result r = sweep_until(s, n, p, max_sweeps, options);
    r.tested += old.tested;
    r.relaxed += old.relaxed;
    r.sweeps += old.sweeps;
    r.fell_back = 1;
    return r;
}
//<

//> sticks-sweep-speeds
// Each end has gone u = position - previous in the last step.  Along the stick,
// d, the ends part by e = (u_b - u_a) . d / d . d; to take it away, a must have
// gone w_a e d / (w_a + w_b) further, and b as much less by its own weight.
static void stick_slow(stick s, particle *a, particle *b)
{
    vec3 along = vec3_sub(b->position, a->position);
    vec3 gone = vec3_sub(along, vec3_sub(b->previous, a->previous));
    real bottom = vec3_length_squared(along)
                * (a->inverse_mass + b->inverse_mass);
    if (s.kind != STICK_EXACT || s.stiffness < 1 || !(bottom > 0)) return;
    real e = vec3_dot(gone, along) / bottom;
    a->previous = vec3_add_scaled(a->previous, -a->inverse_mass * e, along);
    b->previous = vec3_add_scaled(b->previous, b->inverse_mass * e, along);
}

void sticks_sweep_speeds(const stick *s, int n, particle *p)
{
    for (int i = 0; i < n; i++) stick_slow(s[i], &p[s[i].a], &p[s[i].b]);
}
//<

//> sticks-interleave
// Round after round takes every stick that shares no particle with another
// taken in the round.  That is the greedy colouring: each stick gets the first
// colour that none of its neighbours before it in the list has.
// At most n rounds: each takes one stick at least.
status sticks_interleave(stick *s, int n, int particle_count)
{
    for (int i = 0; i < n; i++)
        if (s[i].a < 0 || s[i].a >= particle_count
            || s[i].b < 0 || s[i].b >= particle_count)
            return status_fail("stick %d joins particles %d and %d, of %d", i,
                               s[i].a, s[i].b, particle_count);
    if (n < 2) return status_ok();
    stick *sorted = malloc((size_t)n * sizeof *sorted);
    int *taken_in = calloc((size_t)particle_count, sizeof *taken_in);
    if (!sorted || !taken_in) {
        free(sorted);
        free(taken_in);
        return status_out_of_memory();
    }

    int done = 0, waiting = n;
    for (int round = 1; waiting > 0; round++) {
        int kept = 0;
        for (int i = 0; i < waiting; i++) {
            int *a = &taken_in[s[i].a], *b = &taken_in[s[i].b];
            if (*a == round || *b == round) {
                s[kept++] = s[i];
            } else {
                *a = *b = round;
                sorted[done++] = s[i];
            }
        }
        waiting = kept;
    }
    memcpy(s, sorted, (size_t)n * sizeof *s);
    free(sorted);
    free(taken_in);
    return status_ok();
}
//<

//> angle-relax
// Arms so nearly in one line that rounding decides which way they lean.
static const real STRAIGHT = 1e-8;

// With unit arms u and v, lengths U and V, and c = u . v, the cosine grows by
// at_a . (move of a) + at_b . (move of b) - (at_a + at_b) . (move of corner):
//     at_a = (v - c u) / U,   at_b = (u - c v) / V.
// The least move, weighed by mass, that makes C vanish is w k at, with
//     k = -C / (w_a at_a^2 + w_b at_b^2 + w_corner (at_a + at_b)^2).
// |v - c u| is the sine.  C, cut off at the sine, turns by one radian at most:
// near the straight line, where the cosine hardly answers, it would whirl.
stick_result angle_relax(angle c, particle *p)
{
    assert(c.a != c.b && c.a != c.corner && c.b != c.corner);
    assert(c.cosine >= -1 && c.cosine <= 1);
    particle *a = &p[c.a], *b = &p[c.b], *corner = &p[c.corner];
    vec3 u = vec3_sub(a->position, corner->position);
    vec3 v = vec3_sub(b->position, corner->position);
    real U = vec3_length(u), V = vec3_length(v);
    if (U == 0 || V == 0) return (stick_result){ 0, 0 };

    u = vec3_scale(1 / U, u);
    v = vec3_scale(1 / V, v);
    real cosine = vec3_dot(u, v), sine = vec3_length(vec3_cross(u, v));
    stick_result r = { error_shown(cosine - c.cosine), 0 };

    vec3 at_a = vec3_scale(1 / U, vec3_add_scaled(v, -cosine, u));
    vec3 at_b = vec3_scale(1 / V, vec3_add_scaled(u, -cosine, v));
    vec3 both = vec3_add(at_a, at_b);
    real bottom = a->inverse_mass * vec3_length_squared(at_a)
                + b->inverse_mass * vec3_length_squared(at_b)
                + corner->inverse_mass * vec3_length_squared(both);
    if (r.error == 0 || !(sine > STRAIGHT && bottom > 0)) return r;

    real C = fmax(-sine, fmin(sine, r.error));
    real k = -c.stiffness * C / bottom;
    a->position = vec3_add_scaled(a->position, k * a->inverse_mass, at_a);
    b->position = vec3_add_scaled(b->position, k * b->inverse_mass, at_b);
    corner->position =
        vec3_add_scaled(corner->position, -k * corner->inverse_mass, both);
    r.moved = 1;
    return r;
}
//<

//> bend-make
// Lines that differ by less than this in direction (the sine squared) have no
// crossing that rounding would not move.
static const real ALIKE = 1e-12;

// The points b + u e and d + v f, with e = a - b and f = c - d, are nearest
// where the line between them stands on both: with r = b - d,
//     (r + u e - v f) . e = 0,   (r + u e - v f) . f = 0.
// A rope has a = b, e = 0: then u = 1 will do, and v alone is sought.
status bend_make(bend *b, const int at[4], const particle *p, real stiffness)
{
    assert(at[2] != at[3] && stiffness > 0 && stiffness <= 1);
    vec3 e = vec3_sub(p[at[0]].position, p[at[1]].position);
    vec3 f = vec3_sub(p[at[2]].position, p[at[3]].position);
    vec3 r = vec3_sub(p[at[1]].position, p[at[3]].position);
    if (!vec3_is_finite(e) || !vec3_is_finite(f) || !vec3_is_finite(r))
        return status_fail("a particle of the bend (%d, %d, %d, %d) has a "
                           "position that is not finite",
                           at[0], at[1], at[2], at[3]);

    real ee = vec3_dot(e, e), ff = vec3_dot(f, f), ef = vec3_dot(e, f);
    real re = vec3_dot(r, e), rf = vec3_dot(r, f);
    real area = ee * ff - ef * ef;
    int  rope = at[0] == at[1];
    if (!(ff > 0) || (!rope && !(area > ALIKE * ee * ff)))
        return status_fail("the lines %d-%d and %d-%d of the bend run alike "
                           "and do not cross", at[0], at[1], at[2], at[3]);

    real u = rope ? 1 : (ef * rf - re * ff) / area;
    real v = (rf + u * ef) / ff;
    *b = (bend){ { at[0], at[1], at[2], at[3] },
                 { u, 1 - u, -v, -(1 - v) }, stiffness };
    return status_ok();
}
//<

//> bend-relax
// gap = sum weight_i x_i.  Moving each x_i by -k w_i weight_i gap takes
// k sum w_i weight_i^2 of the gap away: all of it for k = 1 / that sum.
// The pushes add up to nothing, for the weights do; and their torque is
// -k sum x_i x weight_i gap = -k gap x gap = 0.
stick_result bend_relax(bend b, particle *p)
{
    vec3 gap = { 0, 0, 0 };
    real bottom = 0;
    for (int i = 0; i < 4; i++) {
        const particle *q = &p[b.at[i]];
        gap = vec3_add_scaled(gap, b.weight[i], q->position);
        bottom += q->inverse_mass * b.weight[i] * b.weight[i];
    }
    stick_result r = { error_shown(vec3_length(gap)), 0 };
    if (r.error == 0 || r.error == HUGE_VAL || !(bottom > 0)) return r;

    real k = b.stiffness / bottom;
    for (int i = 0; i < 4; i++) {
        particle *q = &p[b.at[i]];
        real share = k * q->inverse_mass * b.weight[i];
        q->position = vec3_add_scaled(q->position, -share, gap);
    }
    r.moved = 1;
    return r;
}
//<
