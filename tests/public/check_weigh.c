// check_weigh.c - tests of tumble_shape_weighed: bodies with a mass, a centre
// and an inertia of their own.  Book: chapter 13.

#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <string.h>

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(tumble_vec3 got, tumble_vec3 wanted, double tolerance)
{
    near(got.x, wanted.x, tolerance);
    near(got.y, wanted.y, tolerance);
    near(got.z, wanted.z, tolerance);
}

static tumble_world *made(double gravity)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, -gravity, 0);
    o.friction = 1;
    o.sleep_speed = 0;
    return tumble_world_make(&o);
}

static tumble_vec3 cross(tumble_vec3 a, tumble_vec3 b)
{
    return tumble_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                    a.x * b.y - a.y * b.x);
}

// Those of no symmetry.
static const double ANY[6] = { 0.5, 0.6, 0.7, 0.05, -0.08, 0.1 };

// The tensor, times w.
static tumble_vec3 times(const double i[6], tumble_vec3 w)
{
    return tumble_v(i[0] * w.x + i[3] * w.y + i[4] * w.z,
                    i[3] * w.x + i[1] * w.y + i[5] * w.z,
                    i[4] * w.x + i[5] * w.y + i[2] * w.z);
}

// Rejects: moments about the middle of the shape; products of inertia that are
// left out, or with the other sign; the mass of the shape as it was.
START_TEST(an_impulse_gives_what_mass_and_inertia_say)
{
    tumble_world *w = made(0);
    tumble_vec3 center = tumble_v(0.1, -0.2, 0.15);
    tumble_shape s =
        tumble_shape_weighed(w, tumble_shape_box(w, tumble_v(1, 1, 1), 7), 2.5,
                             center, ANY);
    tumble_body b = tumble_body_add(w, s, tumble_body_at(3, 4, 5));
    tumble_vec3 at = tumble_v(3.5, 3.7, 5.2), push = tumble_v(1, -2, 3);
    tumble_vec3 arm = tumble_v(0.5 - 0.1, -0.3 + 0.2, 0.2 - 0.15);
    ck_assert(tumble_body_push(w, b, push, at));
    near(tumble_body_mass(w, b), 2.5, 1e-14);
    near_vec3(tumble_body_velocity(w, b), tumble_v(0.4, -0.8, 1.2), 1e-12);
    near_vec3(times(ANY, tumble_body_spin(w, b)), cross(arm, push), 1e-12);
    ck_assert_ptr_null(tumble_world_failure(w));
    tumble_world_free(w);
}
END_TEST

// Nothing pushes it: its centre of mass goes straight on, whatever it turns, and
// keeps its angular momentum.
START_TEST(what_flies_turns_about_its_own_centre)
{
    tumble_world *w = made(0);
    tumble_vec3 c = tumble_v(0.1, -0.2, 0.15), l = { 0, 0, 0 };
    tumble_shape s = tumble_shape_weighed(w, tumble_shape_sphere(w, 0.5, 1),
                                          2.5, c, ANY);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.velocity = tumble_v(1, 0.5, 0);
    o.spin = tumble_v(2, 3, -1);
    tumble_body b = tumble_body_add(w, s, o);
    l = times(ANY, o.spin);
    for (int k = 0; k < 120; k++) tumble_world_step(w);
    tumble_pose at = tumble_body_pose(w, b);
    double m[9];
    tumble_quat_matrix(at.rotation, m);
    near_vec3(tumble_v(at.position.x + m[0] * c.x + m[1] * c.y + m[2] * c.z,
                       at.position.y + m[3] * c.x + m[4] * c.y + m[5] * c.z,
                       at.position.z + m[6] * c.x + m[7] * c.y + m[8] * c.z),
              tumble_v(2.1, 0.8, 0.15), 1e-9);
    tumble_vec3 spin = tumble_body_spin(w, b);
    tumble_vec3 own = tumble_v(m[0] * spin.x + m[3] * spin.y + m[6] * spin.z,
                               m[1] * spin.x + m[4] * spin.y + m[7] * spin.z,
                               m[2] * spin.x + m[5] * spin.y + m[8] * spin.z);
    tumble_vec3 now = times(ANY, own);
    near(now.x * now.x + now.y * now.y + now.z * now.z,
         l.x * l.x + l.y * l.y + l.z * l.z, 1e-9);
    near_vec3(tumble_v(m[0] * now.x + m[1] * now.y + m[2] * now.z,
                       m[3] * now.x + m[4] * now.y + m[5] * now.z,
                       m[6] * now.x + m[7] * now.y + m[8] * now.z), l, 1e-9);
    tumble_world_free(w);
}
END_TEST

// s, of a drum that rolls to and fro by a fiftieth of a radian: twelve crossings
// of the lowest place, by straight lines.
static double period_of(tumble_world *w, tumble_body b)
{
    double first = 0, last = 0, was = tumble_body_position(w, b).x;
    int n = 0;
    for (int k = 1; k < 3000 && n < 13; k++) {
        tumble_world_step(w);
        double now = tumble_body_position(w, b).x;
        if (was < 0 && now >= 0) {
            last = (k - now / (now - was)) / 60;
            if (n++ == 0) first = last;
        }
        was = now;
    }
    return (last - first) / (n - 1);
}

// A drum of radius R whose centre of mass lies d below its axis rolls, and rocks:
// omega^2 = m g d / (I + m (R - d)^2).  (A ball, and a capsule on its side.)
// Rejects: a centre of mass that is the middle; an inertia that is the shape's; one
// about the middle; rows that stay as they were while it turns a little.
START_TEST(a_drum_with_a_stone_in_it_rocks_with_its_period)
{
    const double r = 0.5, d[] = { 0.1, 0.3 }, mass = 3, g = 9.81;
    for (int k = 0; k < 4; k++) {
        tumble_world *w = made(g);
        double off = d[k / 2], i[6] = { 0.3, 0.25, 0.2, 0, 0, 0 };
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        tumble_shape s = k % 2 == 0 ? tumble_shape_sphere(w, r, 1)
                                    : tumble_shape_capsule(w, 1, r, 1);
        // The capsule lies along z, its stone off along its own x.
        s = tumble_shape_weighed(w, s, mass, k % 2 == 0 ? tumble_v(0, -off, 0)
                                                : tumble_v(-off, 0, 0), i);
        tumble_body_options o = tumble_body_at(-0.02 * r, r, 0);
        const double c = cos(0.02), lie[9] = { -sin(0.02), 0, c,
                                               c, 0, sin(0.02), 0, 1, 0 };
        o.pose.rotation = k % 2 == 0 ? tumble_quat_turn(tumble_v(0, 0, 1), 0.02)
                                     : tumble_quat_from_matrix(lie);
        tumble_body b = tumble_body_add(w, s, o);
        double inertia = k % 2 == 0 ? i[2] : i[1];
        double wanted = 2 * 3.14159265358979
            * sqrt((inertia + mass * (r - off) * (r - off)) / (mass * g * off));
        near(period_of(w, b) / wanted, 1, 0.0005);
        tumble_world_free(w);
    }
}
END_TEST

// A box with the weight of a box flies as a box does, to rounding.
START_TEST(the_weight_that_it_had_changes_nothing)
{
    tumble_vec3 at[2];
    for (int k = 0; k < 2; k++) {
        tumble_world *w = made(9.81);
        tumble_shape s = tumble_shape_box(w, tumble_v(1, 2, 3), 6);
        const double own[6] = { 6.5, 5, 2.5, 0, 0, 0 };
        if (k == 1) s = tumble_shape_weighed(w, s, 6, tumble_v(0, 0, 0), own);
        tumble_body_options o = tumble_body_at(0, 2, 0);
        o.spin = tumble_v(1, 2, 3);
        tumble_body b = tumble_body_add(w, s, o);
        for (int n = 0; n < 40; n++) tumble_world_step(w);
        at[k] = tumble_body_vertex(w, b, 5);
        tumble_world_free(w);
    }
    near_vec3(at[1], at[0], 1e-9);
}
END_TEST

static void refused(double mass, tumble_vec3 center, const double *i,
                    const char *why)
{
    tumble_world *w = made(0);
    tumble_shape s =
        tumble_shape_weighed(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), mass,
                             center, i);
    ck_assert(!tumble_body_exists(w, tumble_body_add(w, s,
                                                     tumble_body_at(0, 0, 0))));
    ck_assert_msg(strstr(tumble_world_failure(w), why) != NULL, "%s",
                  tumble_world_failure(w));
    tumble_world_free(w);
}

START_TEST(a_weight_that_no_body_has_is_refused)
{
    const tumble_vec3 o = tumble_v(0, 0, 0);
    const double good[6] = { 1, 1, 1, 0, 0, 0 };
    const double negative[6] = { 1, -1, 1, 0, 0, 0 };
    const double indefinite[6] = { 1, 1, 1, 2, 0, 0 };
    const double rod[6] = { 1, 1, 2, 0, 0, 0 }, wide[6] = { 1, 1, 2.1, 0, 0, 0 };
    const double hidden[6] = { 1.5, 1.5, 1, 1.2, 0, 0 };    // 2.7, .3 and 1
    const double number[6] = { 1, NAN, 1, 0, 0, 0 };
    refused(0, o, good, "the mass is 0");
    refused(-1, o, good, "the mass is -1");
    refused(NAN, o, good, "the mass is");
    refused(1, tumble_v(0.6, 0, 0), good, "not inside");
    refused(1, tumble_v(0, NAN, 0), good, "not inside");
    refused(1, o, negative, "not positive");
    refused(1, o, indefinite, "not positive");
    refused(1, o, rod, "no solid");
    refused(1, o, wide, "no solid");
    refused(1, o, hidden, "no solid");
    refused(1, o, number, "moment of inertia 1 is");
    refused(1, o, NULL, "without moments");
    tumble_world *w = made(0);
    tumble_shape_weighed(w, tumble_shape_rope(w, 5, 1, 1), 1, o, good);
    ck_assert(strstr(tumble_world_failure(w), "only a rigid shape") != NULL);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        an_impulse_gives_what_mass_and_inertia_say,
        what_flies_turns_about_its_own_centre,
        a_drum_with_a_stone_in_it_rocks_with_its_period,
        the_weight_that_it_had_changes_nothing,
        a_weight_that_no_body_has_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "weigh", .tests = tests,
                              .seconds = 60 });
}
