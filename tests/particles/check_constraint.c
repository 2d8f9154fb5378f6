// check_constraint.c - tests of chapter 2.  Each names the mistake it rejects.

#include "constraint.h"
#include "expect.h"
#include "gains.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Room for the rounding of some ten operations near 1, each 1.1e-16, in
// whichever order a reader's module does them.
static const real EXACT = 1e-14;
// The same after some thousand steps.
static const real ROUNDING = 1e-12;

static const real not_a_number = (real)NAN;
static const vec3 NO_GRAVITY = { 0, 0, 0 };

static particle at(real x, real y, real z, real inverse_mass)
{
    return (particle){ { x, y, z }, { x, y, z }, inverse_mass };
}

static stick bar(int a, int b, real length)
{
    return (stick){ a, b, length, 1, STICK_EXACT };
}

// The three ways to correct: PBD, with the approximate root, and SHAKE.
enum { WAYS = 3, DEFAULT = WAYS };

static relax_options way(int k)
{
    if (k == DEFAULT) return relax_options_default();
    relax_options o = relax_options_pbd();
    if (k == 1) o.root = ROOT_APPROXIMATE;
    if (k == 2) o.gradient = GRADIENT_OLD;
    return o;
}

static unsigned long long seed = 1;

static real length_of(const particle *p, int a, int b)
{
    return vec3_distance(p[a].position, p[b].position);
}

// ---- One stick

START_TEST(stick_has_its_length_again)
{
    // Rejects: half the error, a move the wrong way.
    for (int i = 0; i < 100; i++) {
        particle p[2] = { at(random_real(&seed), random_real(&seed),
                             random_real(&seed), 1),
                          at(random_real(&seed), random_real(&seed),
                             random_real(&seed), 3) };
        real before = length_of(p, 0, 1);
        stick_result r = stick_relax(bar(0, 1, 0.7), p, way(0));
        near(length_of(p, 0, 1), 0.7, EXACT, "length");
        near(r.error, before - 0.7, EXACT, "error before");
        ck_assert_int_eq(r.moved, 1);
    }
}
END_TEST

START_TEST(ends_share_by_inverse_mass)
{
    // Rejects: equal moves, moves by mass.
    for (int k = 0; k < WAYS; k++) {
        particle p[2] = { at(0, 0, 0, 1), at(1.001, 0, 0, 0.25) };
        stick_relax(bar(0, 1, 1), p, way(k));
        real a = p[0].position.x, b = p[1].position.x - 1.001;
        near(a / -b, 4, 1e-9, "share");
        near(b - a, -0.001, 1e-6, "sum");
        ck_assert(p[0].previous.x == 0 && p[1].previous.x == 1.001);
    }
}
END_TEST

START_TEST(centre_of_mass_stays)
{
    for (int k = 0; k < WAYS; k++) {
        for (int i = 0; i < 100; i++) {
            real wa = 1.5 + random_real(&seed), wb = 1.5 + random_real(&seed);
            particle p[2] = { at(1, random_real(&seed), random_real(&seed), wa),
                              at(-1, random_real(&seed), random_real(&seed),
                                 wb) };
            vec3 before = vec3_add(vec3_scale(1 / wa, p[0].position),
                                   vec3_scale(1 / wb, p[1].position));
            stick_relax(bar(0, 1, 1.3), p, way(k));
            vec3 after = vec3_add(vec3_scale(1 / wa, p[0].position),
                                  vec3_scale(1 / wb, p[1].position));
            near(vec3_distance(before, after), 0, 8 * EXACT, "centre");
        }
    }
}
END_TEST

START_TEST(pinned_end_stays)
{
    // Rejects: half the error for the free end.
    particle p[2] = { at(0, 0, 0, 0), at(0, 3, 0, 2) };
    stick_relax(bar(0, 1, 1), p, way(0));
    near_vec3(p[0].position, (vec3){ 0, 0, 0 }, 0);
    near(p[1].position.y, 1, EXACT, "free end");
}
END_TEST

START_TEST(both_ends_pinned_report_and_stay)
{
    // Rejects: 0 / 0.
    for (int k = 0; k < WAYS; k++) {
        particle p[2] = { at(0, 0, 0, 0), at(0, 2, 0, 0) };
        stick s = bar(0, 1, 1);
        stick_result r = stick_relax(s, p, way(k));
        ck_assert_int_eq(r.moved, 0);
        ck_assert(r.error > 0.99);
        near_vec3(p[1].position, (vec3){ 0, 2, 0 }, 0);
        relax_result all = sticks_iterate(&s, 1, p, way(k));
        ck_assert(all.tested == 1 && all.relaxed == 0 && all.worst > 0.99);
    }
}
END_TEST

START_TEST(coincident_ends_stay_finite)
{
    // Rejects: a division by the length.
    for (int k = 0; k < WAYS; k++) {
        particle p[2] = { at(1, 2, 3, 1), at(1, 2, 3, 1) };
        stick_result r = stick_relax(bar(0, 1, 1), p, way(k));
        ck_assert_int_eq(r.moved, 0);
        ck_assert(r.error < 0);
        near_vec3(p[0].position, (vec3){ 1, 2, 3 }, 0);
        near_vec3(p[1].position, (vec3){ 1, 2, 3 }, 0);
    }
}
END_TEST

START_TEST(soft_stick_corrects_its_share)
{
    // Rejects: a stiffness that is ignored, squared, or cut off at 1.
    particle p[2] = { at(0, 0, 0, 1), at(2, 0, 0, 1) };
    stick s = bar(0, 1, 1);
    s.stiffness = 0.25;
    stick_relax(s, p, way(0));
    near(length_of(p, 0, 1), 1.75, EXACT, "after one");
    stick_relax(s, p, way(0));
    near(length_of(p, 0, 1), 1 + 0.75 * 0.75, EXACT, "after two");
    s.stiffness = 1.5;
    stick_relax(s, p, way(0));
    near(length_of(p, 0, 1), 1 - 0.5 * 0.75 * 0.75, EXACT, "over-relaxed");
}
END_TEST

START_TEST(one_sided_sticks_push_one_way)
{
    // Rejects: the two kinds exchanged; strain of a satisfied stick.
    for (int k = 0; k < WAYS; k++) {
        for (int longer = 0; longer < 2; longer++) {
            real d = longer ? 1.01 : 0.99;
            for (int kind = STICK_AT_LEAST; kind <= STICK_AT_MOST; kind++) {
                particle p[2] = { at(0, 0, 0, 1), at(0, 0, d, 1) };
                stick s = bar(0, 1, 1);
                s.kind = (stick_kind)kind;
                bool acts = (kind == STICK_AT_MOST) == longer;
                real strain = stick_strain(s, p);
                near(strain, acts ? 0.01 : 0, EXACT, "strain");
                stick_result r = stick_relax(s, p, way(k));
                ck_assert_int_eq(r.moved, acts);
                ck_assert(acts || r.error == 0);
                near(length_of(p, 0, 1), acts ? 1 : d, 1e-4, "length");
            }
        }
    }
}
END_TEST

START_TEST(satisfied_stick_is_not_moved)
{
    for (int k = 0; k < WAYS; k++) {
        particle p[2] = { at(0, 0, 0, 1), at(0, 3, 4, 1) };
        stick_result r = stick_relax(bar(0, 1, 5), p, way(k));
        ck_assert(r.moved == 0 && r.error == 0);
        ck_assert(stick_strain(bar(0, 1, 5), p) == 0);
    }
}
END_TEST

START_TEST(approximate_root_never_ends_too_long)
{
    // 2 d L^2 / (d^2 + L^2) <= L, arithmetic against geometric mean.
    // Rejects: another Newton start, or the move of the exact root.
    for (real d = 0.01; d < 100; d *= 1.1) {
        particle p[2] = { at(0, 0, 0, 1), at(d, 0, 0, 2) };
        stick_relax(bar(0, 1, 1), p, way(1));
        real now = length_of(p, 0, 1);
        near(now, 2 * d / (d * d + 1), 4 * EXACT * (1 + d), "law");
        ck_assert(now <= 1 + 4 * EXACT * (1 + d));
    }
}
END_TEST

START_TEST(approximate_root_is_quadratic)
{
    // An error e leaves e^2 / (2 L).
    particle p[2] = { at(0, 0, 0, 1), at(1.001, 0, 0, 1) };
    stick_relax(bar(0, 1, 1), p, way(1));
    near((1 - length_of(p, 0, 1)) / (0.001 * 0.001 / 2), 1, 0.01, "bias");
}
END_TEST

START_TEST(old_gradient_pushes_along_the_old_stick)
{
    // Rejects: the new direction, a forgotten factor 2.
    particle p[2] = { at(0, 0, 0, 1), at(1, 0, 0, 1) };
    p[0].position = (vec3){ 0, -0.05, 0 };
    p[1].position = (vec3){ 1, 0.05, 0 };
    stick_relax(bar(0, 1, 1), p, way(2));
    ck_assert(p[0].position.y == -0.05 && p[1].position.y == 0.05);
    near(p[0].position.x, 0.01 / 4, EXACT, "a");
    near(p[1].position.x, 1 - 0.01 / 4, EXACT, "b");
}
END_TEST

START_TEST(turned_stick_is_left_alone)
{
    // along . old = 0 has no answer, along . old < 0 a wild one.
    for (int k = 0; k < 2; k++) {
        particle p[2] = { at(0, 0, 0, 1), at(1, 0, 0, 1) };
        p[1].position = (vec3){ k ? -0.3 : 0, 1.5, 0 };
        stick_result r = stick_relax(bar(0, 1, 1), p, way(2));
        ck_assert(r.moved == 0 && r.error > 0);
        ck_assert(p[0].position.x == 0 && p[1].position.y == 1.5);
    }
}
END_TEST

START_TEST(not_a_number_does_not_leave_quietly)
{
    // One end is NaN; the other must stay, and the error be reported.
    // Rejects: a comparison that NaN slips through, in any way and any kind; a
    // correction called possible because its length, NaN, is not 0.
    for (int k = 0; k < WAYS; k++) for (int kind = 0; kind < 3; kind++) {
        particle p[3] = { at(0, 0, 0, 1), at(not_a_number, 0, 0, 1),
                          at(1, 0, 0, 1) };
        stick s[2] = { bar(0, 1, 1), bar(0, 2, 1.5) };
        s[0].kind = (stick_kind)kind;
        ck_assert(stick_relax(s[0], p, way(k)).error == HUGE_VAL);
        ck_assert(stick_strain(s[0], p) == HUGE_VAL);
        ck_assert(sticks_iterate(s, 2, p, way(k)).worst == HUGE_VAL);
        ck_assert(vec3_is_finite(p[0].position));
        ck_assert(vec3_is_finite(p[2].position));
    }
}
END_TEST

START_TEST(size_does_not_matter)
{
    // A scene of millimetres or light seconds does the same.  Rejects: an
    // absolute tolerance.
    for (int k = 0; k < WAYS; k++) {
        real scale[3] = { 1, 1.0 / 1099511627776, 1099511627776 }, got[3];
        for (int i = 0; i < 3; i++) {
            particle p[2] = { at(0, 0, 0, 1), at(scale[i], 0, 0, 1) };
            p[1].position.y = 0.25 * scale[i];
            stick_relax(bar(0, 1, 1.125 * scale[i]), p, way(k));
            got[i] = p[1].position.x / scale[i];
        }
        near(got[1], got[0], EXACT, "small");
        near(got[2], got[0], EXACT, "large");
    }
}
END_TEST

// ---- Spin

// The angular speed after steps steps of a stick spun up to w0 (rad/s).
static real spin(int k, real w0, real dt, int steps)
{
    real turn = w0 * dt;
    particle p[2] = { at(0.5, 0, 0, 1), at(-0.5, 0, 0, 1) };
    p[0].previous = (vec3){ cos(turn) / 2, -sin(turn) / 2, 0 };
    p[1].previous = vec3_scale(-1, p[0].previous);
    stick s = bar(0, 1, 1);
    relax_options o = way(k);
    o.tolerance = 1e-15;
    for (int i = 0; i < steps; i++) {
        verlet_step(p, 2, NO_GRAVITY, NULL, dt);
        sticks_relax(&s, 1, p, 20, o);
    }
    vec3 now = vec3_sub(p[1].position, p[0].position);
    vec3 old = vec3_sub(p[1].previous, p[0].previous);
    return atan2(vec3_cross(old, now).z, vec3_dot(old, now)) / dt;
}

START_TEST(old_gradient_keeps_the_spin)
{
    // 10 s at 30 rad/s, half a radian a step.  Rejects: the new gradient.
    near(spin(2, 30, 1.0 / 60, 600) / 30, 1, ROUNDING, "spin");
}
END_TEST

START_TEST(new_gradient_brakes_the_spin_by_its_law)
{
    // w0 / sqrt(1 + 2 w0^2 dt t), to the next order of w dt.
    real law = 30 / sqrt(1 + 2 * 900 * 1.0 / 60 * 10);
    near(spin(0, 30, 1.0 / 60, 600) / law, 1, 0.01, "60 Hz, 10 s");
    law = 30 / sqrt(1 + 2 * 900 * 1.0 / 1200);
    near(spin(0, 30, 1.0 / 1200, 1200) / law, 1, 0.01, "1200 Hz, 1 s");
}
END_TEST

// ---- A pendulum: order

// The angle of a pendulum of length 1, let go level, after 1 s.
static real pendulum(int k, int steps)
{
    real dt = 1.0 / steps;
    vec3 gravity = { 0, -9.81, 0 };
    particle p[2] = { at(0, 0, 0, 0),
                      particle_start((vec3){ 1, 0, 0 }, NO_GRAVITY, gravity, 1,
                                     dt) };
    stick s = bar(0, 1, 1);
    relax_options o = way(k);
    o.tolerance = 1e-14;
    for (int i = 0; i < steps; i++) {
        verlet_step(p, 2, gravity, NULL, dt);
        sticks_relax(&s, 1, p, 50, o);
    }
    return atan2(p[1].position.x, -p[1].position.y);
}

START_TEST(default_options_are_right_for_a_pendulum)
{
    // 1.8e-5 rad after 1 s of 400 steps.  Rejects: the gradient at the new
    // positions, which is off by 0.04 rad.
    real best = pendulum(2, 25600);
    near(pendulum(DEFAULT, 400), best, 2e-4, "angle");
    ck_assert(fabs(pendulum(0, 400) - best) > 0.01);
}
END_TEST

START_TEST(old_gradient_is_of_order_2)
{
    // Three halvings give the order without the true answer.
    real a = pendulum(2, 400), b = pendulum(2, 800), c = pendulum(2, 1600);
    near(log2((a - b) / (b - c)), 2, 0.05, "order");
    a = pendulum(0, 400), b = pendulum(0, 800), c = pendulum(0, 1600);
    ck_assert_msg(log2((a - b) / (b - c)) < 1.8, "the new one is no better?");
}
END_TEST

// ---- A box, spinning free: momentum

enum { CORNERS = 8, PAIRS = 28 };

static int box(particle *p, stick *s, real dt)
{
    vec3 w = { 1, 4, 3 }, drift = { 0.5, -0.25, 0.125 };
    int n = 0;
    for (int i = 0; i < CORNERS; i++) {
        vec3 x = { i & 1 ? 0.5 : -0.5, i & 2 ? 1 : -1, i & 4 ? 1.5 : -1.5 };
        vec3 v = vec3_add(drift, vec3_cross(w, x));
        p[i] = particle_start(x, v, vec3_cross(w, vec3_cross(w, x)),
                              0.5 + 0.25 * i, dt);
        for (int j = 0; j < i; j++) s[n++] = bar(j, i, length_of(p, j, i));
    }
    return n;
}

// sum m x_before x x / dt and sum m (x - x_before) / dt.
static void momenta(const particle *p, int n, real dt, vec3 *l, vec3 *m)
{
    *l = *m = (vec3){ 0, 0, 0 };
    for (int i = 0; i < n; i++) {
        real k = 1 / (p[i].inverse_mass * dt);
        vec3 move = vec3_sub(p[i].position, p[i].previous);
        *l = vec3_add_scaled(*l, k, vec3_cross(p[i].previous, move));
        *m = vec3_add_scaled(*m, k, move);
    }
}

START_TEST(free_body_keeps_its_momenta_in_any_order)
{
    // One iteration or five, listed, reversed or shuffled.
    // Rejects: moves along anything but the line that joined the ends a step ago.
    real dt = 1.0 / 60;
    for (int run = 0; run < 6; run++) {
        particle p[CORNERS];
        stick s[PAIRS];
        int n = box(p, s, dt);
        for (int i = n - 1; run > 1 && i > 0; i--) {
            int j = run < 4 ? (i + 5) % (i + 1)
                            : (int)(random_fraction(&seed) * i);
            stick swap = s[i];
            s[i] = s[j], s[j] = swap;
        }
        vec3 l0, m0, l, m;
        momenta(p, CORNERS, dt, &l0, &m0);
        for (int k = 0; k < 300; k++) {
            verlet_step(p, CORNERS, NO_GRAVITY, NULL, dt);
            for (int j = 0; j < (run % 2 ? 5 : 1); j++)
                sticks_iterate(s, n, p, way(2));
        }
        momenta(p, CORNERS, dt, &l, &m);
        near(vec3_distance(l, l0) / vec3_length(l0), 0, ROUNDING, "angular");
        near(vec3_distance(m, m0) / vec3_length(m0), 0, ROUNDING, "linear");
    }
}
END_TEST

START_TEST(new_gradient_loses_angular_momentum)
{
    // The control: the same body, the other gradient, more than half is gone.
    real dt = 1.0 / 60;
    particle p[CORNERS];
    stick s[PAIRS];
    int n = box(p, s, dt);
    vec3 l0, m0, l, m;
    momenta(p, CORNERS, dt, &l0, &m0);
    for (int k = 0; k < 300; k++) {
        verlet_step(p, CORNERS, NO_GRAVITY, NULL, dt);
        for (int j = 0; j < 5; j++) sticks_iterate(s, n, p, way(0));
    }
    momenta(p, CORNERS, dt, &l, &m);
    // About a point that drifts the linear part comes along: it is kept.
    near(vec3_distance(m, m0) / vec3_length(m0), 0, ROUNDING, "linear");
    ck_assert(vec3_length(l) < 0.6 * vec3_length(l0));
}
END_TEST

// ---- Iterations

enum { LINKS = 10 };

static void rope(particle *p, stick *s, int n, real length)
{
    for (int i = 0; i <= n; i++) p[i] = at(i * length, 0, 0, 1);
    for (int i = 0; i < n; i++) s[i] = bar(i, i + 1, length);
}

START_TEST(chain_converges_at_its_rate)
{
    // Gauss-Seidel on a straight chain: cos^2(pi / (n + 1)) an iteration.
    // Rejects: Jacobi (its square root), a lost half.
    particle p[LINKS + 1];
    stick s[LINKS];
    rope(p, s, LINKS, 1);
    for (int i = 0; i <= LINKS; i++)
        p[i].position.x += 0.01 * random_real(&seed);
    real before = 1, rate = 0;
    for (int k = 0; k < 100; k++) {
        real worst = sticks_iterate(s, LINKS, p, way(0)).worst;
        rate = worst / before;
        before = worst;
    }
    real c = cos(3.14159265358979323846 / (LINKS + 1));
    near(rate, c * c, 1e-6, "rate");
}
END_TEST

START_TEST(iteration_counts_and_measures_before)
{
    // Rejects: strain measured after the move, the sum instead of the largest.
    for (int k = 0; k < WAYS; k++) {
        particle p[4] = { at(0, 0, 0, 1), at(1.001, 0, 0, 1),
                          at(5, 0, 0, 1), at(6.004, 0, 0, 1) };
        stick s[2] = { bar(0, 1, 1), bar(2, 3, 1) };
        relax_result r = sticks_iterate(s, 2, p, way(k));
        near(r.worst, 0.004, 1e-5, "worst");
        ck_assert(r.tested == 2 && r.relaxed == 2 && r.iterations == 1);
        r = sticks_iterate(s, 0, p, way(k));
        ck_assert(r.worst == 0 && r.tested == 0);
    }
}
END_TEST

START_TEST(worst_is_a_strain_and_not_a_length)
{
    // Rejects: the largest error in metres, of a long stick with little strain.
    for (int k = 0; k < WAYS; k++) {
        particle p[4] = { at(0, 0, 0, 1), at(100.4, 0, 0, 1),
                          at(0, 1, 0, 1), at(0, 1.0101, 0, 1) };
        stick s[2] = { bar(0, 1, 100), bar(2, 3, 0.01) };
        near(sticks_iterate(s, 2, p, way(k)).worst, 0.01, 1e-4, "worst");
    }
}
END_TEST

START_TEST(iteration_is_its_sticks_one_by_one)
{
    // Rejects: an iteration that does not agree with the one function.
    for (int k = 0; k < WAYS; k++) {
        particle p[CORNERS], q[CORNERS];
        stick s[PAIRS];
        int n = box(p, s, 0.01);
        for (int i = 0; i < n; i++) {
            s[i].kind = (stick_kind)(i % 3);
            s[i].stiffness = i % 5 ? 1 : 0.5;
        }
        for (int i = 0; i < CORNERS; i++) p[i].position.x *= 1.1;
        memcpy(q, p, sizeof p);
        relax_options o = way(k);
        o.dead_band = true, o.tolerance = 0.01;
        real worst = 0;
        int moved = 0;
        for (int i = 0; i < n; i++) {
            stick_result r = stick_relax(s[i], q, o);
            worst = fmax(worst, fabs(r.error) / s[i].rest_length);
            moved += r.moved;
        }
        relax_result r = sticks_iterate(s, n, p, o);
        ck_assert_int_eq(r.relaxed, moved);
        near(r.worst, worst, EXACT, "worst");
        for (int i = 0; i < CORNERS; i++)
            near(vec3_distance(p[i].position, q[i].position), 0, ROUNDING,
                 "position");
    }
}
END_TEST

START_TEST(dead_band_leaves_small_errors_alone)
{
    // Rejects: a band that is always on, or measured in metres.
    for (int k = 0; k < WAYS; k++) {
        relax_options o = way(k);
        o.tolerance = 0.01;
        particle p[2] = { at(0, 0, 0, 1), at(0, 100.5, 0, 1) };
        stick s = bar(0, 1, 100);
        o.dead_band = true;
        stick_result r = stick_relax(s, p, o);
        ck_assert_int_eq(r.moved, 0);
        ck_assert(r.error > 0.49 && p[1].position.y == 100.5);
        ck_assert_int_eq(sticks_iterate(&s, 1, p, o).relaxed, 0);
        o.dead_band = false;
        ck_assert_int_eq(stick_relax(s, p, o).moved, 1);
        p[1] = at(0, 102, 0, 1);
        p[0] = at(0, 0, 0, 1);
        o.dead_band = true;
        ck_assert_int_eq(stick_relax(s, p, o).moved, 1);
    }
}
END_TEST

START_TEST(relax_stops_at_the_tolerance)
{
    // Rejects: a loop that always runs to the cap, or stops one early.
    for (int k = 0; k < WAYS; k++) {
        particle p[LINKS + 1];
        stick s[LINKS];
        rope(p, s, LINKS, 1);
        p[0].position.x = -0.01;
        relax_options o = way(k);
        o.tolerance = 1e-6;
        relax_result r = sticks_relax(s, LINKS, p, 1000, o);
        ck_assert(r.worst <= 1e-6 && r.iterations > 10 && r.iterations < 1000);
        ck_assert_int_eq(r.tested, r.iterations * LINKS);
        ck_assert(r.relaxed > r.tested / 2 && r.relaxed <= r.tested);
        for (int i = 0; i < LINKS; i++) ck_assert(stick_strain(s[i], p) < 2e-6);
        r = sticks_relax(s, LINKS, p, 1000, o);
        ck_assert_int_eq(r.iterations, 1);
    }
}
END_TEST

START_TEST(relax_stops_at_the_cap)
{
    particle p[LINKS + 1];
    stick s[LINKS];
    rope(p, s, LINKS, 1);
    p[0].position.x = -0.5;
    relax_result r = sticks_relax(s, LINKS, p, 7, way(0));
    ck_assert(r.iterations == 7 && r.worst > 1e-4);
    r = sticks_relax(s, LINKS, p, 0, way(0));
    ck_assert(r.iterations == 0 && r.tested == 0);
}
END_TEST

START_TEST(sticks_that_cannot_be_had_say_so)
{
    // Sticks of 1, 1 and 3 m between three particles; and a stick that SHAKE
    // cannot turn back to.  Rejects: a last strain that passes for the first.
    for (int k = 0; k < WAYS; k++) {
        particle p[3] = { at(0, 0, 0, 1), at(1, 0, 0, 1), at(1, 1, 0, 1) };
        stick s[3] = { bar(0, 1, 1), bar(1, 2, 1), bar(0, 2, 3) };
        relax_result r = sticks_relax(s, 3, p, 40, way(k));
        ck_assert(r.worst > 0.1 && r.iterations == 40);
        for (int i = 0; i < 3; i++) ck_assert(vec3_is_finite(p[i].position));
    }
    particle p[2] = { at(0, 0, 0, 1), at(1, 0, 0, 1) };
    p[1].position = (vec3){ 0, 1.02, 0 };
    stick s = bar(0, 1, 1);
    relax_result r = sticks_relax(&s, 1, p, 4, way(2));
    near(r.worst, 0.02, 1e-3, "strain that stays");
    ck_assert(r.relaxed == 0 && p[1].position.y == 1.02);
    ck_assert(sticks_relax(&s, 1, p, 4, way(0)).worst < 1e-4);
}
END_TEST

// ---- The angle

static real cosine_at(const particle *p, int a, int corner, int b)
{
    vec3 u = vec3_sub(p[a].position, p[corner].position);
    vec3 v = vec3_sub(p[b].position, p[corner].position);
    return vec3_dot(u, v) / (vec3_length(u) * vec3_length(v));
}

START_TEST(elbow_takes_its_angle)
{
    // Rejects: an angle held the wrong way round, a gradient of the wrong sign
    // or length, a corner that stays.
    for (int i = 0; i < 200; i++) {
        particle p[3] = { at(random_real(&seed), random_real(&seed), 1, 0.5),
                          at(random_real(&seed), random_real(&seed), 0, 1),
                          at(random_real(&seed), random_real(&seed), -1, 2) };
        angle c = { 0, 1, 2, 0.95 * random_real(&seed), 1 };
        real before = cosine_at(p, 0, 1, 2) - c.cosine;
        particle q[3];
        memcpy(q, p, sizeof p);
        stick_result r = angle_relax(c, p);
        near(r.error, before, 4 * EXACT, "error before");
        ck_assert_int_eq(r.moved, 1);
        gains_nothing(q, p, 3, ROUNDING);
        for (int k = 0; k < 30; k++) angle_relax(c, p);
        near(cosine_at(p, 0, 1, 2), c.cosine, ROUNDING, "cosine");
    }
}
END_TEST

START_TEST(angle_is_quadratic_near_its_goal)
{
    // Rejects: a fraction that is right in sign only.
    particle p[3] = { at(1, 0, 0, 1), at(0, 0, 0, 3), at(0.01, 1, 0, 2) };
    angle c = { 0, 1, 2, 0, 1 };
    angle_relax(c, p);
    ck_assert(fabs(cosine_at(p, 0, 1, 2)) < 1e-4);
    c.stiffness = 0.25;
    p[0] = at(1, 0, 0, 1), p[1] = at(0, 0, 0, 0), p[2] = at(1e-4, 1, 0, 0);
    angle_relax(c, p);
    near(cosine_at(p, 0, 1, 2) / 1e-4, 0.75, 1e-3, "soft");
    near_vec3(p[1].position, (vec3){ 0, 0, 0 }, 0);
}
END_TEST

START_TEST(straight_elbow_has_no_side_to_turn_to)
{
    // Rejects: 0 / 0, and a whirl where the sine is small.
    particle p[3] = { at(-1, 0, 0, 1), at(0, 0, 0, 1), at(2, 0, 0, 1) };
    angle c = { 0, 1, 2, 0, 1 };
    stick_result r = angle_relax(c, p);
    ck_assert(r.moved == 0 && r.error == -1);
    p[2].position.y = 1e-9;     // as good as straight
    ck_assert(!angle_relax(c, p).moved);
    p[2].position.y = 1e-6;
    r = angle_relax(c, p);
    ck_assert_int_eq(r.moved, 1);
    for (int i = 0; i < 3; i++)
        ck_assert(vec3_distance(p[i].position, p[i].previous) < 2);
    p[0] = p[1];
    r = angle_relax(c, p);
    ck_assert(r.moved == 0 && r.error == 0);
    // The other arm without length.
    c = (angle){ 2, 1, 0, 0, 1 };
    r = angle_relax(c, p);
    ck_assert(r.moved == 0 && r.error == 0);
    p[0].position.x = not_a_number;
    r = angle_relax(c, p);
    ck_assert(r.moved == 0 && r.error == HUGE_VAL);
    ck_assert(vec3_is_finite(p[1].position) && vec3_is_finite(p[2].position));
}
END_TEST

START_TEST(pinned_elbow_reports_and_stays)
{
    particle p[3] = { at(1, 0, 0, 0), at(0, 0, 0, 0), at(1, 1, 0, 0) };
    stick_result r = angle_relax((angle){ 0, 1, 2, 0, 1 }, p);
    ck_assert(r.moved == 0 && r.error > 0.7);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Stick.
        stick_has_its_length_again,
        ends_share_by_inverse_mass,
        centre_of_mass_stays,
        pinned_end_stays,
        both_ends_pinned_report_and_stay,
        coincident_ends_stay_finite,
        soft_stick_corrects_its_share,
        one_sided_sticks_push_one_way,
        satisfied_stick_is_not_moved,
        approximate_root_never_ends_too_long,
        approximate_root_is_quadratic,
        old_gradient_pushes_along_the_old_stick,
        turned_stick_is_left_alone,
        not_a_number_does_not_leave_quietly,
        size_does_not_matter,
        // Motion.
        old_gradient_keeps_the_spin,
        new_gradient_brakes_the_spin_by_its_law,
        default_options_are_right_for_a_pendulum,
        old_gradient_is_of_order_2,
        free_body_keeps_its_momenta_in_any_order,
        new_gradient_loses_angular_momentum,
        // Iteration.
        chain_converges_at_its_rate,
        iteration_counts_and_measures_before,
        worst_is_a_strain_and_not_a_length,
        iteration_is_its_sticks_one_by_one,
        dead_band_leaves_small_errors_alone,
        relax_stops_at_the_tolerance,
        relax_stops_at_the_cap,
        sticks_that_cannot_be_had_say_so,
        // Angle.
        elbow_takes_its_angle,
        angle_is_quadratic_near_its_goal,
        straight_elbow_has_no_side_to_turn_to,
        pinned_elbow_reports_and_stays,
        NULL
    };
    return suite_run((suite){ .name = "constraint", .tests = tests });
}
