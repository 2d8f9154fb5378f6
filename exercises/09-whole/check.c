// check.c - tests of the exercise 09/whole.

#include "whole.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

// Differences of places of up to 10 m, by a step of 1/64 s.
static const real ROUNDING = 1e-11;

static const real dt = 0x1p-6;          // s
static const vec3 ZERO = { 0, 0, 0 };

// Asks with memory that ends behind the last particle.
static whole ask(const particle *p, int n)
{
    particle *own = malloc((size_t)(n > 0 ? n : 1) * sizeof *own);
    ck_assert_ptr_nonnull(own);
    if (n > 0) memcpy(own, p, (size_t)n * sizeof *own);
    whole w = whole_of(own, n, dt);
    free(own);
    return w;
}

static void expect(const char *what, real got, real wanted)
{
    ck_assert_msg(fabs(got - wanted) <= ROUNDING * (1 + fabs(wanted)), "%s: "
                  "got %.15g, wanted %.15g", what, got, wanted);
}

static void expect3(const char *what, vec3 got, vec3 wanted)
{
    ck_assert_msg(vec3_distance(got, wanted)
                  <= ROUNDING * (1 + vec3_length(wanted)), "%s: got (%.12g, "
                  "%.12g, %.12g), wanted (%.12g, %.12g, %.12g)", what, got.x,
                  got.y, got.z, wanted.x, wanted.y, wanted.z);
}

// A particle that is at x in the middle of its step, and moves with v.
static particle moving(vec3 x, vec3 v, real mass)
{
    return (particle){ vec3_add_scaled(x, dt / 2, v),
                       vec3_add_scaled(x, -dt / 2, v),
                       mass > 0 ? 1 / mass : 0 };
}

static unsigned long long seed = 11;

// A box of 1, 2 and 3 m of eight particles, 0.5 kg each: about its axes it has
// 4 kg times (4 + 9) / 4, (1 + 9) / 4, (1 + 4) / 4 m^2.
static int make_box(particle *p, vec3 at, vec3 velocity, vec3 spin)
{
    for (int k = 0; k < 8; k++) {
        vec3 r = { k & 1 ? 0.5 : -0.5, k & 2 ? 1 : -1, k & 4 ? 1.5 : -1.5 };
        p[k] = moving(vec3_add(at, r), vec3_add(velocity, vec3_cross(spin, r)),
                      0.5);
    }
    return 8;
}

START_TEST(thrown_particle_flies_and_nothing_else)
{
    // Rejects: a place at the end of the step; dt forgotten; half forgotten.
    particle p = moving((vec3){ 1, 2, 3 }, (vec3){ 3, 0, -4 }, 2);
    whole w = ask(&p, 1);
    expect("mass", w.mass, 2);
    expect3("centre", w.center, (vec3){ 1, 2, 3 });
    expect3("velocity", w.velocity, (vec3){ 3, 0, -4 });
    expect3("spin", w.spin, ZERO);
    expect("flight", w.flight, 25);
    expect("turning", w.turning, 0);
    expect("rest", w.rest, 0);
}
END_TEST

START_TEST(heavy_ones_count_more)
{
    // Rejects: the mean of the places; the inverse mass for the mass.
    particle p[2] = { moving(ZERO, (vec3){ 0, 4, 0 }, 3),
                      moving((vec3){ 4, 0, 0 }, (vec3){ 0, -4, 0 }, 1) };
    whole w = ask(p, 2);
    expect("mass", w.mass, 4);
    expect3("centre", w.center, (vec3){ 1, 0, 0 });
    expect3("velocity", w.velocity, (vec3){ 0, 2, 0 });
}
END_TEST

START_TEST(box_turns_about_its_own_axes)
{
    // Rejects: a wrong entry or sign of the inertia; the diagonal alone.
    particle p[8];
    whole w = ask(p, make_box(p, (vec3){ 5, 6, 7 }, ZERO, (vec3){ 2, 0, 0 }));
    expect3("spin about x", w.spin, (vec3){ 2, 0, 0 });
    expect3("angular momentum", w.angular, (vec3){ 26, 0, 0 });
    expect("turning", w.turning, 26);
    w = ask(p, make_box(p, (vec3){ 5, 6, 7 }, ZERO, (vec3){ 0, 2, 0 }));
    expect3("angular momentum about y", w.angular, (vec3){ 0, 20, 0 });
    w = ask(p, make_box(p, (vec3){ 5, 6, 7 }, ZERO, (vec3){ 1, -2, 3 }));
    expect3("spin about an axis anyhow", w.spin, (vec3){ 1, -2, 3 });
    expect3("angular momentum", w.angular, (vec3){ 13, -20, 15 });
    expect("turning", w.turning, (13 + 40 + 45) / 2.0);
    expect("rest", w.rest, 0);
    expect("flight", w.flight, 0);
}
END_TEST

START_TEST(flight_adds_no_turning)
{
    // Rejects: momentum about the origin; velocities that are not seen from
    // the centre.
    particle p[8];
    whole w = ask(p, make_box(p, (vec3){ 50, -6, 7 }, (vec3){ 3, 4, 12 },
                              (vec3){ 1, -2, 3 }));
    expect3("velocity", w.velocity, (vec3){ 3, 4, 12 });
    expect3("spin", w.spin, (vec3){ 1, -2, 3 });
    expect("flight", w.flight, 4 * 169 / 2.0);
    expect("turning", w.turning, 49);
    expect("rest", w.rest, 0);
}
END_TEST

START_TEST(crooked_body_turns_about_the_axis_it_is_given)
{
    // Its inertia has entries beside the diagonal, and L is not along the spin.
    for (int k = 0; k < 200; k++) {
        particle p[5];
        vec3 x[5], mean = ZERO, spin = random_vec3(&seed, 1);
        real m[5], mass = 0;
        for (int i = 0; i < 5; i++) {
            x[i] = random_vec3(&seed, 1);
            m[i] = 1.5 + random_real(&seed);
            mass += m[i];
            mean = vec3_add_scaled(mean, m[i], x[i]);
        }
        mean = vec3_scale(1 / mass, mean);
        for (int i = 0; i < 5; i++)
            p[i] = moving(x[i], vec3_cross(spin, vec3_sub(x[i], mean)), m[i]);
        whole w = ask(p, 5);
        ck_assert_msg(vec3_distance(w.spin, spin) < 1e-9, "body %d turns with "
                      "(%g, %g, %g), got (%g, %g, %g)", k, spin.x, spin.y,
                      spin.z, w.spin.x, w.spin.y, w.spin.z);
        ck_assert_msg(fabs(w.rest) < 1e-9, "body %d: rigid, but a rest of %g J",
                      k, w.rest);
    }
}
END_TEST

START_TEST(ring_that_widens_does_not_turn)
{
    // Rejects: all that is not flight called turning.
    particle p[12];
    for (int k = 0; k < 12; k++) {
        real by = k * acos(-1.0) / 6;
        vec3 out = { cos(by), sin(by), 0 };
        p[k] = moving(out, vec3_scale(3, out), 0.5);
    }
    whole w = ask(p, 12);
    expect3("spin", w.spin, ZERO);
    expect("turning", w.turning, 0);
    expect("rest", w.rest, 27);
}
END_TEST

START_TEST(stick_whirls_but_not_about_itself)
{
    // Any direction: a determinant of 0, or of a rounding.
    // Rejects: 0 / 0; noise divided by noise.
    for (int k = 0; k < 100; k++) {
        vec3 d = vec3_unit(random_vec3(&seed, 1)),
             side = vec3_cross(d, random_vec3(&seed, 1)),
             from = random_vec3(&seed, 1);
        particle p[3];
        for (int i = 0; i < 3; i++)
            p[i] = moving(vec3_add_scaled(from, i, d), vec3_scale(i, side), 2);
        // A point at distance i moves with i side: spin x d = side.
        whole w = ask(p, 3);
        expect3("spin of a stick", w.spin, vec3_cross(d, side));
        expect("turning", w.turning, 2 * vec3_length_squared(side));
        expect("rest", w.rest, 0);
    }
}
END_TEST

START_TEST(three_energies_add_up_to_all)
{
    for (int k = 0; k < 200; k++) {
        particle p[7];
        real all = 0;
        for (int i = 0; i < 7; i++) {
            vec3 v = random_vec3(&seed, 1);
            real m = 1.5 + random_real(&seed);
            p[i] = moving(random_vec3(&seed, 1), v, m);
            all += m * vec3_length_squared(v) / 2;
        }
        whole w = ask(p, 7);
        expect("all", w.flight + w.turning + w.rest, all);
        ck_assert_msg(w.rest > -ROUNDING && w.turning > -ROUNDING
                      && w.flight > -ROUNDING, "negative: %g, %g, %g J",
                      w.flight, w.turning, w.rest);
    }
}
END_TEST

START_TEST(pins_do_not_count)
{
    // Rejects: 1 / 0.
    particle p[9];
    int n = make_box(p, ZERO, (vec3){ 1, 0, 0 }, (vec3){ 0, 0, 1 });
    p[n] = moving((vec3){ 9, 9, 9 }, ZERO, 0);
    whole w = ask(p, n + 1);
    expect("mass", w.mass, 4);
    expect3("centre", w.center, ZERO);
    expect3("spin", w.spin, (vec3){ 0, 0, 1 });
    w = ask(p + n, 1);
    expect("of a pin: mass", w.mass, 0);
    expect3("its centre", w.center, ZERO);
    expect("its energy", w.flight + w.turning + w.rest, 0);
    w = ask(NULL, 0);
    expect3("of nothing: spin", w.spin, ZERO);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        thrown_particle_flies_and_nothing_else,
        heavy_ones_count_more,
        box_turns_about_its_own_axes,
        flight_adds_no_turning,
        crooked_body_turns_about_the_axis_it_is_given,
        ring_that_widens_does_not_turn,
        stick_whirls_but_not_about_itself,
        three_energies_add_up_to_all,
        pins_do_not_count,
        NULL
    };
    return suite_run((suite){ .name = "whole", .tests = tests });
}
