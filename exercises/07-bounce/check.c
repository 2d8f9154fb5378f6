// check.c - tests of the exercise 07/bounce.

#include "bounce.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <float.h>

// A sum of a dozen products, each rounded once.
static const real ROUNDING = 1e-14;
static const vec3 UP = { 0, 1, 0 };

static unsigned long long seed;

static feature_point any_feature(int first, int count)
{
    feature_point f = { .count = count };
    real sum = 0;
    for (int i = 0; i < count; i++) {
        f.vertex[i] = first + i;
        f.weight[i] = random_between(&seed, 0.05, 1);
        sum += f.weight[i];
    }
    for (int i = 0; i < count; i++) f.weight[i] /= sum;
    return f;
}

static feature_contact on_floor(void)
{
    return (feature_contact){ .a = { 1, { 0 }, { 1 } }, .normal = UP,
                              .mass_a = 1, .mass_b = HUGE_VAL };
}

// Height of the first bounce, of a fall from 1 m.
static real bounce_height(real restitution)
{
    real dt = 2e-4, highest = 0;
    vec3 gravity = { 0, -9.81, 0 };
    particle p = particle_start(UP, vec3_make(0, 0, 0), gravity, 1, dt);
    feature_contact c = on_floor();
    bool met = false;
    for (int k = 0; k < 6000; k++) {
        real approach = (p.previous.y - p.position.y) / dt;
        verlet_step(&p, 1, gravity, NULL, dt);
        if (met && p.position.y > highest) highest = p.position.y;
        if (met || !(contact_depth(&c, &p) > 0)) continue;
        met = true;
        response_separate(&c, &p, 0);
        bounce(&c, &p, restitution, approach, dt);
    }
    return highest;
}

// Rejects: a bounce by e in height instead of speed; dt forgotten; an impulse
// of the wrong sign.
START_TEST(ball_bounces_to_e_squared_of_its_height)
{
    for (int k = 0; k < 3; k++) {
        real e = k / 2.0, height = bounce_height(e);
        ck_assert_msg(fabs(height - e * e) <= 1e-6 + 0.01 * e * e, "from 1 m, "
                      "with restitution %g, it bounces to %g m, wanted %g", e,
                      height, e * e);
    }
}
END_TEST

// Rejects: moving the present positions, body masses, A alone.
START_TEST(bounce_keeps_momentum_and_positions)
{
    seed = 23;
    for (int k = 0; k < 90; k++) {
        particle p[6], old[6];
        real dt = 0.01, approach = random_between(&seed, 0.1, 3),
             e = random_between(&seed, 0, 1);
        int na = 1 + k % 3, nb = 1 + k / 3 % 3;
        feature_contact c = { .a = any_feature(0, na), .b = any_feature(na, nb),
                              .normal = vec3_unit(random_vec3(&seed, 1)) };
        for (int i = 0; i < 6; i++) {
            real mass = random_between(&seed, 0.5, 2) * (i < na ? 1 : 10);
            p[i] = (particle){ random_vec3(&seed, 1), random_vec3(&seed, 1),
                               1 / mass };
            old[i] = p[i];
        }
        bounce(&c, p, e, approach, dt);
        vec3 sum = { 0, 0, 0 }, step = { 0, 0, 0 };
        for (int i = 0; i < na + nb; i++) {
            ck_assert_msg(vec3_distance(p[i].position, old[i].position) == 0,
                          "a bounce has moved the position of particle %d", i);
            vec3 dx = vec3_sub(p[i].previous, old[i].previous);
            sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass, dx);
            real weight = i < na ? c.a.weight[i] : -c.b.weight[i - na];
            step = vec3_add_scaled(step, weight, vec3_sub(p[i].position,
                                                          p[i].previous));
        }
        ck_assert_msg(vec3_length(sum) < 300 * ROUNDING, "a bounce has made "
                      "momentum: %g kg m in a step", vec3_length(sum));
        real speed = vec3_dot(step, c.normal) / dt;
        ck_assert_msg(fabs(speed - e * approach) < 1000 * ROUNDING, "met at %g "
                      "m/s, with restitution %g: they part at %.12g m/s, "
                      "wanted %.12g", approach, e, speed, e * approach);
    }
}
END_TEST

// Rejects: a pair held back that was parting already.
START_TEST(pair_that_parts_keeps_its_speed)
{
    particle p = { { 0, 0, 0 }, { 0, -0.12, 0 }, 1 };
    feature_contact c = on_floor();
    bounce(&c, &p, 0.5, -2, 0.01);
    real way = p.position.y - p.previous.y;
    ck_assert_msg(fabs(way - 0.02) <= ROUNDING, "parting already at 0.02 m a "
                  "step: after the bounce at %g, wanted 0.02", way);
}
END_TEST

// Rejects: a bounce that is not along the normal alone.
START_TEST(sliding_is_left)
{
    particle p = { { 0, 0, 0 }, { -0.3, 0.05, 0.2 }, 2 };
    feature_contact c = on_floor();
    bounce(&c, &p, 1, 5, 0.01);
    ck_assert(p.previous.x == -0.3 && p.previous.z == 0.2);
    ck_assert_double_eq_tol(p.previous.y, -0.05, ROUNDING);
}
END_TEST

// Rejects: a division by the inverse mass of two walls.
START_TEST(two_walls_stay)
{
    particle p[2] = { { { 0, 0, 0 }, { 0, 1, 0 }, 0 },
                      { { 0, 0, 0 }, { 0, 2, 0 }, 0 } };
    feature_contact c = on_floor();
    for (int k = 0; k < 2; k++) {
        c.b = (feature_point){ k, { 1 }, { 1 } };
        bounce(&c, p, 1, 1, 0.01);
        ck_assert(p[0].previous.y == 1 && p[1].previous.y == 2);
    }
}
END_TEST

// Rejects: infinity, from a side that can hardly be moved.
START_TEST(finite_input_gives_finite_output)
{
    static const real size[6] = { DBL_TRUE_MIN, 1e-200, 1e-20, 1, 1e20, 1e150 };
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < 6; k++) {
                particle p = { { 0, 0, 0 }, { 0, size[j], 0 },
                               i < 5 ? size[i] : 0 };
                feature_contact c = on_floor();
                bounce(&c, &p, 1, size[k], 0.01);
                ck_assert(vec3_is_finite(p.previous));
            }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ball_bounces_to_e_squared_of_its_height,
        bounce_keeps_momentum_and_positions,
        pair_that_parts_keeps_its_speed,
        sliding_is_left,
        two_walls_stay,
        finite_input_gives_finite_output,
        NULL
    };
    return suite_run((suite){ .name = "bounce", .tests = tests });
}
