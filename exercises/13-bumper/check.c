// check.c - tests of the exercise 13/bumper.

#include "bumper.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Sums of pushes and places of some metres.
static const real ROUNDING = 1e-12;

static const real h = 1.0 / 256;                // s
static const vec3 GRAVITY = { 0, -9.81, 0 }, UP = { 0, 1, 0 };

enum { MOST = 8 };

static particle p[MOST];
static bumper c[MOST];

static unsigned long long seed = 5;

// A particle of this mass (0: nailed) at a height, falling.
static void put(int i, real mass, real height, real fall)
{
    vec3 x = { 0.5, height, 0 };
    p[i] = (particle){ x, x, mass > 0 ? 1 / mass : 0 };
    if (mass > 0) p[i].previous.y += fall * h;
}

// Bumper i between particles i and i + 1, a metre thick.
static void make(int i, real stiffness, real damping)
{
    c[i] = (bumper){ i, i + 1, UP, 1, stiffness, damping, 0 };
}

static void step(int n, int substeps, int rounds)
{
    for (int k = 0; k < substeps; k++) {
        verlet_step(p, n + 1, GRAVITY, NULL, h);
        bumpers_solve(c, n, p, h, 0, rounds);
    }
}

START_TEST(bumper_leans_by_its_load_over_its_stiffness)
{
    // Rejects: masses ignored, h or h^2 forgotten, pushes that are kept.
    for (real k = 1e3; k < 1e10; k *= 10) {
        real load = 7;
        put(0, 0, 0, 0);
        put(1, load, 1, 0);
        make(0, k, 2 * sqrt(k * load));
        step(1, 2560, 1);
        near((1 - p[1].position.y) * k / (load * 9.81), 1, 1e-6,
             "how deep 7 kg press it, as a share of m g / k");
    }
}
END_TEST

START_TEST(damped_bumper_leans_no_less)
{
    // At rest a damper does nothing.
    for (real d = 1; d < 1e6; d *= 10) {
        put(0, 0, 0, 0);
        put(1, 1, 1 - 9.81 / 1000, 0);
        make(0, 1000, d);
        step(1, 100, 1);
        near(1 - p[1].position.y, 9.81 / 1000, 1e-10, "depth at rest");
    }
}
END_TEST

START_TEST(bumper_is_a_spring_and_a_damper)
{
    // 1 kg lands at 1 m/s on 100 N/m and 4 N s/m, without gravity: its depth
    // is exp(-2 t) sin(w t) / w with w^2 = 100 - 4.  Order 1, as its forces
    // are those of the end.  Rejects: a sign.
    real off[2], w = sqrt(96);
    for (int fine = 0; fine < 2; fine++) {
        real dt = fine ? h / 16 : h / 4, t = 0;
        off[fine] = 0;
        put(0, 0, 0, 0);
        p[1] = (particle){ { 0, 1, 0 }, { 0, 1 + dt, 0 }, 1 };
        make(0, 100, 4);
        while (t < 0.25) {
            verlet_step(p, 2, vec3_make(0, 0, 0), NULL, dt);
            bumpers_solve(c, 1, p, dt, 0, 1);
            t += dt;
            off[fine] = fmax(off[fine], fabs(1 - p[1].position.y
                                             - exp(-2 * t) * sin(w * t) / w));
        }
    }
    ck_assert_msg(off[0] < 1e-3, "at steps of h/4 it is off by %g m", off[0]);
    ck_assert_msg(off[0] > 3 * off[1] && off[0] < 5 * off[1], "a quarter of "
                  "the step should leave a quarter of the error: %g and %g m",
                  off[0], off[1]);
}
END_TEST

START_TEST(no_stiffness_explodes)
{
    // 1 g between 1 kg and the floor, and a drop from a metre.
    for (real k = 1; k < 1e16; k *= 10) {
        put(0, 0, 0, 0);
        put(1, 1e-3, 1, 0);
        put(2, 1, 3, 0);
        make(0, k, 0);
        make(1, k, 0);
        for (int i = 0; i < 512; i++) {
            step(2, 1, 20);
            ck_assert_msg(fabs(p[2].position.y) < 100, "at %g N/m it is at %g "
                          "m after %d substeps", k, p[2].position.y, i);
        }
    }
}
END_TEST

START_TEST(bumper_does_not_pull)
{
    // Away from it; and leaving it so fast that the damper would hold it back.
    put(0, 0, 0, 0);
    for (int leaving = 0; leaving < 2; leaving++) {
        put(1, 1, leaving ? 0.999 : 1.5, leaving ? -9 : 0);
        make(0, 1000, 1000);
        p[1].position.y += leaving ? 9 * h : 0;
        vec3 before = p[1].position;
        near(bumper_push(c, p, h), 0, 0, "push");
        near(vec3_distance(before, p[1].position), 0, 0, "way");
    }
}
END_TEST

START_TEST(looking_twice_changes_nothing)
{
    // Rejects: a sum that forgets what has been pushed.
    for (int round = 0; round < 100; round++) {
        put(0, 2 + random_real(&seed), 0.1 * random_real(&seed),
            random_real(&seed));
        put(1, 2 + random_real(&seed), 0.8 + 0.1 * random_real(&seed),
            random_real(&seed));
        make(0, 1e4 * (1.5 + random_real(&seed)), 10);
        real first = bumper_push(c, p, h), sum = c->pushed;
        near(sum, first, ROUNDING, "the sum after one push");
        near(bumper_push(c, p, h), 0, ROUNDING, "the second push");
        near(c->pushed, sum, ROUNDING, "the sum after two");
    }
}
END_TEST

START_TEST(what_was_pushed_too_much_is_taken_back)
{
    // It was pushed by 0.01 kg m, and another has lifted it off.
    put(0, 0, 0, 0);
    put(1, 2, 1, 0);
    make(0, 1000, 0);
    c->pushed = 0.01;
    p[1].position.y += 0.5 + 0.01 / 2;
    near(bumper_push(c, p, h), -0.01, ROUNDING, "change of the push");
    near(c->pushed, 0, ROUNDING, "sum of the pushes");
    near(p[1].position.y, 1.5, ROUNDING, "height afterwards");
}
END_TEST

START_TEST(momentum_stays_and_no_energy_comes)
{
    // Two meet along any normal.  What they have of energy afterwards, with
    // that of the spring, is no more than before.
    for (int round = 0; round < 200; round++) {
        vec3 moved = { 0, 0, 0 };
        real had = 0, has = 0, k = 1000 * (1.1 + random_real(&seed));
        put(0, 2 + random_real(&seed), 0, 0);
        put(1, 2 + random_real(&seed), 1, 1);
        make(0, k, 5 * (1 + random_real(&seed)));
        c->normal =
            vec3_unit(vec3_make(random_real(&seed), 3, random_real(&seed)));
        p[1].position = vec3_add(p[0].position, c->normal);
        p[1].previous = vec3_add_scaled(p[1].position, h, c->normal);
        for (int i = 0; i < 2; i++)
            had += vec3_length_squared(vec3_sub(p[i].position, p[i].previous))
                 / (2 * h * h * p[i].inverse_mass);
        for (int n = 0; n < 100; n++) {
            verlet_step(p, 2, vec3_make(0, 0, 0), NULL, h);
            bumpers_solve(c, 1, p, h, 0, 1);
        }
        for (int i = 0; i < 2; i++) {
            vec3 v = vec3_sub(p[i].position, p[i].previous);
            has += vec3_length_squared(v) / (2 * h * h * p[i].inverse_mass);
            moved = vec3_add_scaled(moved, 1 / (h * p[i].inverse_mass), v);
        }
        near(vec3_length(moved), 1 / p[1].inverse_mass, 1e-9, "momentum");
        ck_assert_msg(has <= had * (1 + ROUNDING), "energy: %g J become %g",
                      had, has);
    }
}
END_TEST

START_TEST(two_nails_stay)
{
    put(0, 0, 0, 0);
    put(1, 0, 0.5, 0);
    make(0, 1000, 10);
    bumpers_solve(c, 1, p, h, 0, 5);
    near(p[1].position.y, 0.5, 0, "height of a nail");
    near(p[0].position.y, 0, 0, "height of a nail");
}
END_TEST

START_TEST(tower_stands)
{
    // Six on each other, 1 kg each, at 1e5 N/m: bumper i bears 6 - i of them.
    // Rejects: pushes that cannot be taken back; passes in one direction.
    for (int i = 0; i <= 6; i++) put(i, i > 0, i, 0);
    for (int i = 0; i < 6; i++) make(i, 1e5, 200);
    step(6, 1024, 60);
    for (int i = 0; i < 6; i++)
        near(1 - (p[i + 1].position.y - p[i].position.y),
             (6 - i) * 9.81 / 1e5, 1e-6, "how deep a bumper is pressed");
}
END_TEST

START_TEST(rounds_are_counted_and_capped)
{
    put(0, 0, 0, 0);
    put(1, 1, 2, 0);
    put(2, 1, 4, 0);
    make(0, 1000, 1);
    make(1, 1000, 1);
    ck_assert_int_eq(bumpers_solve(c, 2, p, h, 0, 9), 1);
    put(1, 1, 0.9, 0);
    put(2, 1, 1.8, 0);
    ck_assert_int_eq(bumpers_solve(c, 2, p, h, 0, 3), 3);
    ck_assert_int_eq(bumpers_solve(c, 0, p, h, 0, 3), 1);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        bumper_leans_by_its_load_over_its_stiffness,
        damped_bumper_leans_no_less,
        bumper_is_a_spring_and_a_damper,
        no_stiffness_explodes,
        bumper_does_not_pull,
        looking_twice_changes_nothing,
        what_was_pushed_too_much_is_taken_back,
        momentum_stays_and_no_energy_comes,
        two_nails_stay,
        tower_stands,
        rounds_are_counted_and_capped,
        NULL
    };
    return suite_run((suite){ .name = "bumper", .tests = tests });
}
