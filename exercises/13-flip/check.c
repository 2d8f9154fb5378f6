// check.c - tests of the exercise 13/flip.

#include "flip.h"
#include "expect.h"
#include "random.h"
#include "shake.h"
#include "suite.h"

#include <check.h>

static const real ROUNDING = 1e-12;

static const vec3 NONE = { 0, 0, 0 };

static shape box;
static rigid4 plan;
static particle p[FOUR];

static unsigned long long seed = 85;

static void make(vec3 sides, real mass)
{
    ck_assert(shape_box(&box, sides, mass).ok);
    ck_assert(rigid4_build(&plan, &box).ok);
}

static void unmake(void)
{
    rigid4_free(&plan);
    shape_free(&box);
}

static real worst_strain(int before)
{
    real worst = 0;
    for (int s = 0; s < FOUR_STICKS; s++) {
        const particle *a = &p[plan.stick[s].a], *b = &p[plan.stick[s].b];
        real d = before ? vec3_distance(a->previous, b->previous)
                        : vec3_distance(a->position, b->position);
        worst = fmax(worst, fabs(d / plan.stick[s].rest_length - 1));
    }
    return worst;
}

START_TEST(start_bends_no_stick)
{
    // 30 rad/s in steps of 1/60 s is half a radian each.
    // Rejects: a chord for an arc.
    make(vec3_make(1, 2, 3), 6);
    for (int round = 0; round < 100; round++) {
        vec3 spin = vec3_scale(30, vec3_unit(random_vec3(&seed, 1)));
        flip_start(&plan, random_vec3(&seed, 9), random_vec3(&seed, 5), spin,
                   1 / 60.0, p);
        near(worst_strain(0), 0, ROUNDING, "strain now");
        near(worst_strain(1), 0, ROUNDING, "strain a step ago");
    }
    unmake();
}
END_TEST

START_TEST(start_is_where_it_should_be)
{
    // Not spinning: all have come straight.  A plan whose centre is elsewhere.
    make(vec3_make(1, 2, 3), 6);
    vec3 off = { 7, -8, 9 }, at = { 1, 2, 3 }, v = { 6, 0, -12 };
    plan.center = vec3_add(plan.center, off);
    for (int k = 0; k < FOUR; k++) plan.at[k] = vec3_add(plan.at[k], off);
    flip_start(&plan, at, v, NONE, 1 / 60.0, p);
    vec3 middle = NONE;
    for (int k = 0; k < FOUR; k++) {
        vec3 way = vec3_sub(p[k].position, p[k].previous);
        near(vec3_distance(way, vec3_scale(1 / 60.0, v)), 0, ROUNDING,
             "its way in the last step");
        near(p[k].inverse_mass, 1 / 1.5, ROUNDING, "inverse mass, of 6 kg / 4");
        middle = vec3_add_scaled(middle, 0.25, p[k].position);
    }
    near(vec3_distance(middle, at), 0, ROUNDING, "where its centre is");
    unmake();
}
END_TEST

START_TEST(centre_flies_straight)
{
    // Whatever the spin is.
    make(vec3_make(1, 2, 3), 6);
    for (int round = 0; round < 100; round++) {
        vec3 at = random_vec3(&seed, 9), v = random_vec3(&seed, 5),
             middle = NONE;
        flip_start(&plan, at, v, random_vec3(&seed, 20), 1 / 60.0, p);
        for (int k = 0; k < FOUR; k++)
            middle = vec3_add_scaled(middle, 0.25, p[k].previous);
        near(vec3_distance(middle, vec3_add_scaled(at, -1 / 60.0, v)), 0,
             ROUNDING, "its centre a step ago is off by");
    }
    unmake();
}
END_TEST

START_TEST(start_spins_by_the_right_hand)
{
    // About z: what is at +x goes to +y.  L.z = sum m (x vy - y vx) > 0.
    make(vec3_make(1, 1, 1), 6);
    flip_start(&plan, NONE, NONE, vec3_make(0, 0, 2), 1 / 60.0, p);
    real l = 0;
    for (int k = 0; k < FOUR; k++)
        l += vec3_cross(p[k].previous, p[k].position).z * 60 * plan.mass;
    near(l, 2 * 1, 0.01, "L about z: I = 6 (1 + 1) / 12 = 1, spin 2");
    unmake();
}
END_TEST

START_TEST(spin_comes_back)
{
    // Half a step ago the mean place is the true one, shortened by cos of half
    // the angle, and so the spin is tan of it: of the order h^2.
    make(vec3_make(1, 2, 3), 6);
    for (int round = 0; round < 200; round++) {
        vec3 spin = random_vec3(&seed, 5);
        real h = 1e-3;
        flip_start(&plan, random_vec3(&seed, 9), random_vec3(&seed, 5), spin, h,
                   p);
        near(vec3_distance(flip_spin(p, h), spin), 0, 1e-4, "spin is off by");
    }
    unmake();
}
END_TEST

START_TEST(flight_is_no_spin)
{
    make(vec3_make(1, 2, 3), 6);
    flip_start(&plan, vec3_make(100, 200, 300), vec3_make(9, -50, 20), NONE,
               1e-3, p);
    near(vec3_length(flip_spin(p, 1e-3)), 0, 1e-8, "spin of who flies");
    unmake();
}
END_TEST

START_TEST(what_has_no_inertia_has_no_spin)
{
    for (int round = 0; round < 2; round++) {
        for (int k = 0; k < FOUR; k++)
            p[k] = (particle){ { 1, 2, 3 }, { 1, 2, 2.5 }, 1 };
        if (round) p[2].position.x = (real)NAN;
        near(vec3_length(flip_spin(p, 0.01)), 0, 0, "spin");
    }
}
END_TEST

static void step(real h)
{
    relax_options o = relax_options_default();
    o.tolerance = 1e-12;
    verlet_step(p, FOUR, NONE, NULL, h);
    shake(&plan, p, 6, o);
}

// The body's own axis: 0 x, 1 y, 2 z, from how its corners ride.
static vec3 body_axis(int axis)
{
    vec3 at[8];
    rigid_frame now = rigid4_frame(p);
    rigid4_ride(&plan, &now, at, 8);
    return vec3_unit(vec3_sub(at[1 << axis], at[0]));
}

START_TEST(top_nods_at_the_textbooks_rate)
{
    // 2 x 2 x 1 m: its axis goes round L at the rate |L| / I across.
    const real h = 1 / 1000.0;
    make(vec3_make(2, 2, 1), 12);
    flip_start(&plan, NONE, NONE, vec3_make(1, 0, 6), h, p);
    real across = 4 + 1, along = 4 + 4;       // 12 (a^2 + b^2) / 12
    vec3 l = { across * 1, 0, along * 6 };
    real period = 2 * 3.14159265358979324 * across / vec3_length(l);
    vec3 axis = body_axis(2);
    int steps = (int)(period / h + 0.5);
    for (int k = 0; k < steps; k++) step(h);
    near(vec3_distance(body_axis(2), axis), 0, 0.002, "its axis, after once "
         "round, is off by");
    vec3 now = flip_spin(p, h);
    near(vec3_length(now), sqrt(37), 1e-3, "how fast it spins");
    unmake();
}
END_TEST

// The quarter period of the elliptic functions, by the arithmetic-geometric
// mean.
static real quarter(real modulus2)
{
    real a = 1, b = sqrt(1 - modulus2);
    for (int k = 0; k < 40; k++) {
        real mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return 3.14159265358979324 / (2 * a);
}

START_TEST(wing_nut_turns_over_in_time)
{
    // A, B, C: moments of 12 kg and 1 x 2 x 3 m about z, y, x.  The spin along
    // the middle axis changes its sign every 2 K / rate.
    const real h = 1 / 500.0, a = 5, b = 10, c = 13;
    make(vec3_make(1, 2, 3), 12);
    flip_start(&plan, NONE, NONE, vec3_make(0.05, 2, 0.01), h, p);
    real twice = c * 0.05 * 0.05 + b * 4 + a * 0.01 * 0.01;
    real l2 = c * c * 0.05 * 0.05 + b * b * 4 + a * a * 0.01 * 0.01;
    real over = (c - b) * (l2 - twice * a), under = (b - a) * (twice * c - l2);
    if (under > over) {
        real kept = over;
        over = under;
        under = kept;
    }
    real wanted = 2 * quarter(under / over) / sqrt(over / (a * b * c));
    real before = 2, crossed[3], time = 0;
    int found = 0;
    while (found < 3 && time < 60) {
        step(h);
        time += h;
        real now = vec3_dot(flip_spin(p, h), body_axis(1));
        if (now * before < 0)
            crossed[found++] = time - h * now / (now - before);
        before = now;
    }
    ck_assert_msg(found == 3, "it has turned over %d times in a minute", found);
    near((crossed[1] - crossed[0]) / wanted, 1, 1e-3, "time from flip to flip");
    near((crossed[2] - crossed[1]) / wanted, 1, 1e-3, "time to the next");
    unmake();
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        start_bends_no_stick,
        start_is_where_it_should_be,
        centre_flies_straight,
        start_spins_by_the_right_hand,
        spin_comes_back,
        flight_is_no_spin,
        what_has_no_inertia_has_no_spin,
        top_nods_at_the_textbooks_rate,
        wing_nut_turns_over_in_time,
        NULL
    };
    return suite_run((suite){ .name = "flip", .tests = tests });
}
