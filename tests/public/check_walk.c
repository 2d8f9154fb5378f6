// check_walk.c - tests of tumble_walk.c: a character climbs, slides, rides and stops
// as tumble.h says.

#include "random.h"
#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>

static const double DT = 1.0 / 60, G = 9.81, PI = 3.14159265358979323846;
// Casts are exact to 1e-12 of the way and the sizes, here some metres.
static const double EXACT = 1e-9;
// So many radii is its middle line away from what it touches.
static const double APART = 1 + 1e-5;

static tumble_vec3 plus(tumble_vec3 a, double by, tumble_vec3 b)
{
    return tumble_v(a.x + by * b.x, a.y + by * b.y, a.z + by * b.z);
}

static double dot(tumble_vec3 a, tumble_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double length(tumble_vec3 a) { return sqrt(dot(a, a)); }

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.12g, wanted %.12g", got,
                  wanted);
}

static tumble_world *with_floor(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ck_assert(tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1).generation > 0);
    return w;
}

// A box of these sides, turned about an axis through its centre.
static tumble_body box(tumble_world *w, tumble_kind kind, tumble_vec3 at,
                       tumble_vec3 sides, tumble_vec3 axis, double turn)
{
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.kind = kind;
    o.pose.rotation = tumble_quat_turn(axis, turn);
    tumble_body b = tumble_body_add(w, tumble_shape_box(w, sides, 1), o);
    ck_assert(b.generation > 0);
    return b;
}

static tumble_body upright_box(tumble_world *w, double x, double y, double z,
                               tumble_vec3 sides)
{
    return box(w, TUMBLE_STATIC, tumble_v(x, y, z), sides, tumble_v(0, 1, 0), 0);
}

// It stands on ground at this height.
static tumble_walk on(tumble_walker how, double x, double ground, double z)
{
    double y = ground + how.length / 2 + APART * how.radius;
    tumble_walk at = { .position = tumble_v(x, y, z) };
    return at;
}

static double foot(tumble_walker how, tumble_walk at)
{
    return at.position.y - how.length / 2 - APART * how.radius;
}

static tumble_walk walked(tumble_world *w, tumble_walker how, tumble_walk at,
                          tumble_vec3 velocity, int steps)
{
    for (int k = 0; k < steps; k++) {
        tumble_vec3 way = plus(tumble_v(0, -G * DT * DT, 0), DT, velocity);
        ck_assert(tumble_world_walk(w, how, at, way, &at));
    }
    return at;
}

// Is none of it in anything?
static void is_free(tumble_world *w, tumble_walker how, tumble_walk at)
{
    tumble_shape s = tumble_shape_capsule(w, how.length,
                                          how.radius * (1 - 1e-9), 1);
    tumble_pose pose = { at.position, { 0, 0, 0, 1 } };
    ck_assert_int_eq(tumble_world_overlap(w, s, pose, ~0u, NULL, 0), 0);
    ck_assert(tumble_shape_remove(w, s));
}

START_TEST(it_goes_as_far_as_it_is_told)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_walk at = walked(w, how, on(how, 0, 0, 0), tumble_v(3, 0, -4), 60);
    ck_assert(at.stands);
    near(at.position.x, 3, EXACT);
    near(at.position.y, 0.6 + 0.3 * APART, EXACT);
    near(at.position.z, -4, EXACT);
    near(at.normal.y, 1, EXACT);
    ck_assert(tumble_body_is_same(at.ground, tumble_body_ground()));
    tumble_world_free(w);
}
END_TEST

// --- Steps ---------------------------------------------------------------------
// Walks at a step of this share of the highest one, at an angle to it.
static void try_step(double share, double radius, double step, double angle,
                     double speed)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(4 * radius, radius);
    double high = share * step;
    how.step = step;
    upright_box(w, 10 + 2 * radius, high / 2, 0, tumble_v(20, high, 60));
    tumble_vec3 v = tumble_v(speed * cos(angle), 0, speed * sin(angle));
    int steps = (int)((4 * radius) / (v.x * DT)) + 10;
    tumble_walk at = walked(w, how, on(how, 0, 0, 0), v, steps);
    double t = steps * DT;
    is_free(w, how, at);
    ck_assert(at.stands);
    near(at.position.z, v.z * t, 1e-6 * (v.z * t + 1));
    if (share < 1) {
        near(foot(how, at), high, EXACT);
        // Before a high step it may wait until it is nearer than it keeps.
        ck_assert(at.position.x < v.x * t + EXACT);
        ck_assert(at.position.x > v.x * t - (APART - 1) * radius - EXACT);
    } else {
        near(foot(how, at), 0, EXACT);
        // Its round foot comes nearer to a low one.
        double r = APART * radius, over = fmax(r - high, 0);
        near(at.position.x, 2 * radius - sqrt(r * r - over * over), EXACT);
    }
    tumble_world_free(w);
}

START_TEST(it_climbs_steps_that_are_no_higher_than_its_own)
{
    const double share[] = { 0.1, 0.5, 0.99, 0.999, 1.001, 1.01, 1.5, 3, 30 };
    for (int k = 0; k < 9; k++)
        for (int r = 0; r < 3; r++)
            for (int i = 0; i < 3; i++) {
                double radius = 0.1 * (1 << r);
                try_step(share[k], radius, radius / 2, 0.5 * i, 2);
                try_step(share[k], radius, radius, 0.5 * i, 0.3);
                try_step(share[k], radius, 1.5 * radius, 0.5 * i, 6);
            }
}
END_TEST

START_TEST(it_climbs_a_stair_and_comes_down_again)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    how.step = 0.2;
    for (int k = 0; k < 10; k++)
        upright_box(w, 2 + 0.25 * k + 5, 0.2 * (k + 0.5), 0, tumble_v(10, 0.2, 4));
    tumble_walk at = walked(w, how, on(how, 0, 0, 0), tumble_v(1.5, 0, 0), 240);
    near(at.position.x, 6, EXACT);
    near(foot(how, at), 2, EXACT);
    for (int k = 0; k < 240; k++) {
        at = walked(w, how, at, tumble_v(-1.5, 0, 0), 1);
        ck_assert(at.stands);
        is_free(w, how, at);
    }
    near(at.position.x, 0, EXACT);
    near(foot(how, at), 0, EXACT);
    tumble_world_free(w);
}
END_TEST

START_TEST(off_a_ledge_it_falls)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    how.step = 0.2;
    upright_box(w, -5, 1, 0, tumble_v(10, 2, 4));
    tumble_walk at = walked(w, how, on(how, -1, 2, 0), tumble_v(1, 0, 0), 60);
    ck_assert(at.stands);
    near(foot(how, at), 2, EXACT);
    at = walked(w, how, at, tumble_v(1, 0, 0), 30);
    ck_assert(!at.stands);
    near(at.position.x, 0.5, 0.1);
    at = walked(w, how, at, tumble_v(0, -3, 0), 120);
    ck_assert(at.stands);
    near(foot(how, at), 0, EXACT);
    tumble_world_free(w);
}
END_TEST

// An edge that is higher above its round foot than a step bears it no more: here the
// foot is below the edge by r - sqrt(r^2 - d^2).
START_TEST(on_an_edge_it_stands_until_that_is_a_step_above_its_foot)
{
    // Before that it is not steep.
    for (int k = 3; k < 10; k++) {
        tumble_walker how = tumble_walker_capsule(1.2, 0.3);
        how.step = 0.03 * k;
        double left = 0.3 - how.step, far = sqrt(0.09 - left * left);
        for (int i = -1; i < 2; i += 2) {
            tumble_world *w = with_floor();
            upright_box(w, -5, 1, 0, tumble_v(10, 2, 4));
            tumble_vec3 v = { far + 0.001 * i, 0, 0 };
            tumble_walk at = walked(w, how, on(how, 0, 2, 0), v, 60);
            ck_assert(at.stands == (i < 0));
            tumble_world_free(w);
        }
    }
}
END_TEST

// --- Slopes ----------------------------------------------------------------------
// A slope that rises along x by this angle, its foot at x = 0 on the floor.
static tumble_world *with_slope(double angle)
{
    tumble_world *w = with_floor();
    double s = sin(angle), c = cos(angle);
    box(w, TUMBLE_STATIC, tumble_v(20 * c + 5 * s, 20 * s - 5 * c, 0),
        tumble_v(60, 10, 30), tumble_v(0, 0, 1), angle);
    return w;
}

START_TEST(it_climbs_slopes_that_are_no_steeper_than_its_own)
{
    for (int k = 1; k < 8; k++) {
        double slope = 0.15 * k;
        for (int i = 0; i < 2; i++) {
            double angle = slope + (i == 0 ? -1e-4 : 1e-4);
            tumble_world *w = with_slope(angle);
            tumble_walker how = tumble_walker_capsule(1, 0.25);
            how.slope = slope;
            tumble_walk at = walked(w, how, on(how, -2, 0, 0), tumble_v(2, 0, 1),
                                    180);
            is_free(w, how, at);
            ck_assert(at.stands);
            near(at.position.z, 3, EXACT);
            // Its middle is (length / 2 + 1.01 r / cos) above the slope; it stays
            // where its foot touches that.
            double r = APART * how.radius;
            if (i == 0) {
                near(at.position.x, 4, EXACT);
                near(at.position.y - how.length / 2,
                     4 * tan(angle) + r / cos(angle), EXACT);
            } else {
                near(foot(how, at), 0, EXACT);
                near(at.position.x, -r * tan(angle / 2), 0.02 * r);
            }
            tumble_world_free(w);
        }
    }
}
END_TEST

// Without friction: x = g sin a t^2 / 2 along the slope, in steps of dt.
START_TEST(it_slides_off_steeper_ones_as_its_law_says)
{
    for (int k = 1; k < 8; k++) {
        double angle = 0.18 * k;
        tumble_world *w = with_slope(angle);
        tumble_walker how = tumble_walker_capsule(1, 0.25);
        how.slope = angle - 0.01;
        double r = APART * how.radius, c = cos(angle), s = sin(angle);
        tumble_walk at = { .position = tumble_v(10, 10 * s / c + r / c + 0.5, 0) };
        tumble_vec3 from = at.position, v = { 0, 0, 0 };
        int steps = 30;
        for (int i = 0; i < steps; i++) {
            tumble_vec3 was = at.position;
            v.y -= G * DT;
            ck_assert(tumble_world_walk(w, how, at, plus(tumble_v(0, 0, 0), DT, v),
                                        &at));
            ck_assert(!at.stands);
            v = plus(tumble_v(0, 0, 0), 1 / DT, plus(at.position, -1, was));
        }
        tumble_vec3 went = plus(at.position, -1, from);
        double law = G * s * DT * DT * steps * (steps + 1) / 2;
        near(dot(went, tumble_v(-c, -s, 0)), law, 1e-6);
        near(dot(went, tumble_v(-s, c, 0)), 0, 1e-6);
        tumble_world_free(w);
    }
}
END_TEST

START_TEST(it_stands_still_on_a_slope)
{
    tumble_world *w = with_slope(0.7);
    tumble_walker how = tumble_walker_capsule(1, 0.25);
    tumble_walk at = walked(w, how, on(how, -2, 0, 0), tumble_v(2, 0, 0), 120);
    tumble_vec3 was = at.position;
    at = walked(w, how, at, tumble_v(0, 0, 0), 1000);
    near(length(plus(at.position, -1, was)), 0, EXACT);
    tumble_world_free(w);
}
END_TEST

// --- Walls -----------------------------------------------------------------------
START_TEST(along_a_wall_it_has_the_part_of_its_speed)
{
    for (int k = 0; k < 16; k++)
        for (int fast = 0; fast < 3; fast++) {
            double turn = 2 * PI * k / 16 + 0.1, into = 0.1 + 0.09 * k;
            double speed = 0.05 * pow(10, fast);
            tumble_world *w = with_floor();
            tumble_walker how = tumble_walker_capsule(1.2, 0.3);
            tumble_vec3 n = { cos(turn), 0, sin(turn) }, t = { n.z, 0, -n.x };
            box(w, TUMBLE_STATIC, plus(tumble_v(0, 2, 0), -5.4, n),
                tumble_v(10, 4, 400), tumble_v(0, 1, 0), -turn);
            tumble_walk at = on(how, 0, 0, 0);
            tumble_vec3 v = plus(plus(tumble_v(0, 0, 0), -speed * sin(into), n),
                                 speed * cos(into), t);
            at = walked(w, how, at, v, 240);
            near(dot(at.position, t), 4 * speed * cos(into), 1e-6);
            ck_assert(dot(at.position, n) >= -0.4 + 0.3 * APART - EXACT);
            is_free(w, how, at);
            tumble_world_free(w);
        }
}
END_TEST

START_TEST(in_a_corner_it_stops)
{
    for (int k = 1; k < 18; k++)
        for (int i = 0; i < 5; i++)
            for (int fast = 0; fast < 3; fast++) {
                double half = k * PI / 36, speed = 0.02 * pow(10, fast);
                double to = 0.4 * half * (i - 2), slow = half + fabs(to);
                if (slow > 1.4) continue;   // it leads nowhere along one of them
                tumble_world *w = with_floor();
                tumble_walker how = tumble_walker_capsule(1.2, 0.3);
                // Two walls that meet at x = 0, open to -x by twice `half`.
                for (int side = -1; side < 2; side += 2) {
                    tumble_vec3 n = { -sin(half), 0, -side * cos(half) };
                    tumble_plane_add(w, n, 0, -1);
                }
                double far = 0.3 * APART / sin(half);
                tumble_walk at = on(how, -far - 0.05, 0, 0);
                tumble_vec3 v = { speed * cos(to), 0, speed * sin(to) };
                at = walked(w, how, at, v, (int)(0.3 / (speed * DT * cos(slow))) + 60);
                tumble_vec3 was = at.position;
                at = walked(w, how, at, v, 60);
                near(length(plus(at.position, -1, was)), 0, EXACT);
                near(at.position.x, -far, 0.02 * far);
                is_free(w, how, at);
                tumble_world_free(w);
            }
}
END_TEST

START_TEST(between_steep_walls_it_falls_until_it_is_held)
{
    const double around[] = { 0, 2.9, 4.4 };
    for (int k = 0; k < 8; k++) {
        tumble_world *w = tumble_world_make(NULL);
        tumble_walker how = tumble_walker_capsule(1.2, 0.3);
        tumble_vec3 n[3];
        double up = 0.1 + 0.06 * k, unit = sqrt(1 + up * up);
        for (int i = 0; i < 3; i++) {
            double a = around[i] + 0.2 * k;
            n[i] = tumble_v(cos(a) / unit, up / unit, sin(a) / unit);
            tumble_plane_add(w, n[i], 0, -1);
        }
        tumble_walk at = { .position = tumble_v(0.3, 20 / up, 0.1) };
        at = walked(w, how, at, tumble_v(0, -10 / up, 0), 400);
        tumble_vec3 was = at.position;
        for (int i = 0; i < 3; i++)
            near(dot(plus(was, -0.6, tumble_v(0, 1, 0)), n[i]), 0.3 * APART, 1e-7);
        at = walked(w, how, at, tumble_v(0, -10 / up, 0), 60);
        near(length(plus(at.position, -1, was)), 0, EXACT);
        ck_assert(!at.stands);
        tumble_world_free(w);
    }
}
END_TEST

// Two walls that lean away from each other meet in a line, along which it goes by
// the part of its way.
START_TEST(in_a_gutter_it_falls_along_it)
{
    for (int k = 0; k < 8; k++) {
        tumble_world *w = tumble_world_make(NULL);
        tumble_walker how = tumble_walker_capsule(1.2, 0.3);
        double up = 0.3, a = 2.2 + 0.1 * k;
        tumble_vec3 m = { 1, up, 0 }, n = { cos(a), up, sin(a) };
        tumble_vec3 e = { m.y * n.z - m.z * n.y, m.z * n.x - m.x * n.z,
                          m.x * n.y - m.y * n.x };
        e = plus(tumble_v(0, 0, 0), 1 / length(e), e);
        tumble_plane_add(w, m, 0, -1);
        tumble_plane_add(w, n, 0, -1);
        tumble_walk at = { .position = tumble_v(0, 6, -1 / tan(a / 2)) };
        tumble_vec3 v = { 0, -4, 0 };
        at = walked(w, how, at, v, 240);
        tumble_vec3 was = at.position;
        at = walked(w, how, at, v, 60);
        double law = dot(e, plus(v, -60 * G * DT * DT, tumble_v(0, 1, 0)));
        near(length(plus(plus(at.position, -1, was), -law, e)), 0, 1e-6);
        ck_assert(!at.stands);
        tumble_world_free(w);
    }
}
END_TEST

START_TEST(a_low_ceiling_is_a_wall)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    upright_box(w, 5, 1.9, 0, tumble_v(6, 0.4, 6));     // 1.7 m above the floor
    tumble_walk at = walked(w, how, on(how, 0, 0, 0), tumble_v(2, 0, 0), 240);
    ck_assert(at.stands);
    ck_assert(at.position.x < 2 && at.position.x > 1.69);
    is_free(w, how, at);
    tumble_world_free(w);
}
END_TEST

// --- Seams -------------------------------------------------------------------------
// Goes over a floor, and along a wall at z < 0 that is pressed; the law is v t.
static void cross_seams(tumble_world *w, double speed, double along)
{
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_vec3 v = { speed, 0, along };
    tumble_walk at = on(how, -4, 0, 0);
    double far = 0;
    for (int k = 0; speed * DT * k < 8; k++, far = speed * DT * k) {
        at = walked(w, how, at, v, 1);
        ck_assert(at.stands);
        near(foot(how, at), 0, EXACT);
    }
    near(at.position.x, -4 + far, 1e-6);
    is_free(w, how, at);
}

START_TEST(seams_of_tiles_and_of_triangles_do_not_stop_it)
{
    static double height[41 * 41];
    static tumble_vec3 point[41 * 41];
    static int triangle[40 * 40 * 6];
    int n = 0;
    for (int j = 0; j < 41; j++)
        for (int i = 0; i < 41; i++) {
            int p = 41 * j + i;
            point[p] = tumble_v(0.25 * (i - 20), 0, 0.25 * (j - 20));
            if (i == 40 || j == 40) continue;
            const int of[] = { p, p + 41, p + 1, p + 1, p + 41, p + 42 };
            for (int k = 0; k < 6; k++) triangle[n++] = of[k];
        }
    for (int k = 0; k < 12; k++) {
        double speed = 0.3 + 0.9 * k, along = 0.07 * (k % 5 - 2);
        tumble_world *w = tumble_world_make(NULL);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.kind = TUMBLE_STATIC;
        if (k % 3 == 0) tumble_body_add_heights(w, height, 41, 41, 10, 10, 0, o);
        if (k % 3 == 1)
            tumble_body_add_mesh(w, point, 41 * 41, triangle, n / 3, 0, o);
        for (int i = 0; k % 3 == 2 && i < 40; i++)
            for (int j = -1; j < 2; j++)
                upright_box(w, 0.25 * (i - 20), -0.5, j, tumble_v(0.25, 1, 1));
        cross_seams(w, speed, along);
        tumble_world_free(w);
    }
}
END_TEST

START_TEST(seams_of_a_wall_do_not_stop_it)
{
    for (int k = 1; k < 6; k++) {
        tumble_world *w = with_floor();
        tumble_walker how = tumble_walker_capsule(1.2, 0.3);
        for (int i = -20; i < 40; i++)
            upright_box(w, 0.25 * i, 1, -0.9, tumble_v(0.25, 2, 1));
        tumble_walk at = on(how, 0, 0, 0);
        at = walked(w, how, at, tumble_v(1.1, 0, -0.5 * k), 240);
        near(at.position.x, 4.4, 1e-3);
        near(at.position.z, -0.4 + 0.3 * APART, 1e-3);
        tumble_world_free(w);
    }
}
END_TEST

// --- Platforms -------------------------------------------------------------------
static void ride(double lean)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_body lift = box(w, TUMBLE_KINEMATIC, tumble_v(0, 0, 0),
                           tumble_v(4, 1, 4), tumble_v(1, 0, 0), lean);
    tumble_walk at = walked(w, how, on(how, 0.5, 1, 0), tumble_v(0, -3, 0), 60);
    tumble_vec3 stood = at.position;
    for (int k = 0; k < 300; k++) {
        tumble_vec3 v = { 2 * sin(0.05 * k), 3 * cos(0.04 * k), 1 };
        tumble_body_set_velocity(w, lift, v, tumble_v(0, 0, 0));
        tumble_world_step(w);
        at = walked(w, how, at, tumble_v(0, 0, 0), 1);
        tumble_vec3 p = tumble_body_position(w, lift);
        ck_assert(at.stands && tumble_body_is_same(at.ground, lift));
        near(length(plus(plus(at.position, -1, p), -1, stood)), 0, EXACT);
        v = plus(at.velocity, -1, tumble_body_velocity(w, lift));
        near(length(v), 0, EXACT);
    }
    tumble_world_free(w);
}

START_TEST(a_platform_carries_it)
{
    ride(0);
    ride(0.4);
}
END_TEST

START_TEST(a_turntable_carries_it_in_a_circle)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_body table = box(w, TUMBLE_KINEMATIC, tumble_v(0, 0, 0),
                            tumble_v(6, 1, 6), tumble_v(0, 1, 0), 0);
    tumble_body_set_velocity(w, table, tumble_v(0, 0, 0), tumble_v(0, 1.5, 0));
    tumble_walk at = walked(w, how, on(how, 2, 0.5, 0), tumble_v(0, 0, 0), 1);
    for (int k = 0; k < 600; k++) {
        tumble_world_step(w);
        at = walked(w, how, at, tumble_v(0, 0, 0), 1);
        near(hypot(at.position.x, at.position.z), 2, 1e-6);
        near(length(at.velocity), 1.5 * 2, 1e-5);
        near(at.velocity.x * at.position.x + at.velocity.z * at.position.z, 0,
             1e-5);
    }
    tumble_world_free(w);
}
END_TEST

START_TEST(a_wall_that_comes_pushes_it)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_body wall = box(w, TUMBLE_KINEMATIC, tumble_v(-2, 2, 0),
                           tumble_v(1, 3, 6), tumble_v(0, 1, 0), 0);
    tumble_body_set_velocity(w, wall, tumble_v(1.5, 0, 0), tumble_v(0, 0, 0));
    tumble_walk at = on(how, 0, 0, 0);
    for (int k = 0; k < 180; k++) {
        tumble_world_step(w);
        at = walked(w, how, at, tumble_v(0, 0, 0), 1);
        is_free(w, how, at);
    }
    near(at.position.x, -2 + 4.5 + 0.5 + 0.3 * APART, 1e-6);
    near(foot(how, at), 0, EXACT);
    tumble_world_free(w);
}
END_TEST

// --- The air ---------------------------------------------------------------------
START_TEST(it_jumps_as_a_ball_is_thrown)
{
    tumble_world *w = with_floor();
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    tumble_walk at = walked(w, how, on(how, 0, 0, 0), tumble_v(0, 0, 0), 1);
    tumble_vec3 v = { 1, 4, 0 };
    double highest = 0;
    int n = 0;
    at.stands = false;
    for (; n < 120 && !at.stands; n++) {
        v.y -= G * DT;
        ck_assert(tumble_world_walk(w, how, at, plus(tumble_v(0, 0, 0), DT, v),
                                    &at));
        highest = fmax(highest, foot(how, at));
    }
    // v t - g t (t + dt) / 2 is highest for t = v / g - dt / 2.
    near(highest, 16 / (2 * G) - 4 * DT / 2, 1e-3);
    near(n * DT, 2 * 4 / G, 2 * DT);
    near(at.position.x, n * DT, EXACT);
    near(foot(how, at), 0, EXACT);
    tumble_world_free(w);
}
END_TEST

START_TEST(it_is_never_in_anything)
{
    unsigned long long seed = 7;
    for (int scene = 0; scene < 20; scene++) {
        tumble_world *w = with_floor();
        for (int k = 0; k < 25; k++) {
            tumble_vec3 at = { random_between(&seed, -3, 3),
                               random_between(&seed, 0, 2),
                               random_between(&seed, -3, 3) };
            tumble_vec3 axis = { random_between(&seed, -1, 1),
                                 random_between(&seed, -1, 1),
                                 random_between(&seed, -1, 1) };
            box(w, TUMBLE_STATIC, at,
                tumble_v(random_between(&seed, 0.1, 1.5),
                         random_between(&seed, 0.1, 1.5),
                         random_between(&seed, 0.1, 1.5)),
                axis, random_between(&seed, 0, 6));
        }
        tumble_walker how = tumble_walker_capsule(0.6, 0.15);
        tumble_walk at = { .position = tumble_v(0, 5, 0) };
        tumble_vec3 v = { 0, 0, 0 };
        for (int k = 0; k < 600; k++) {
            if (k % 30 == 0)
                v = tumble_v(random_between(&seed, -4, 4), 0,
                             random_between(&seed, -4, 4));
            v.y = at.stands ? 0 : v.y - G * DT;
            if (at.stands && k % 90 == 0) v.y = 4, at.stands = false;
            tumble_vec3 was = at.position;
            ck_assert(tumble_world_walk(w, how, at,
                                        plus(tumble_v(0, 0, 0), DT, v), &at));
            is_free(w, how, at);
            v.y = fmin(v.y, (at.position.y - was.y) / DT);
        }
        tumble_world_free(w);
    }
}
END_TEST

START_TEST(its_up_is_its_own)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_walker how = tumble_walker_capsule(1.2, 0.3);
    how.up = tumble_v(3, 0, 0);
    tumble_plane_add(w, tumble_v(1, 0, 0), 0, -1);
    tumble_walk at = { .position = tumble_v(2, 0, 0) };
    for (int k = 0; k < 120; k++)
        ck_assert(tumble_world_walk(w, how, at, tumble_v(-0.02, 0.01, 0), &at));
    ck_assert(at.stands);
    near(at.position.x, 0.6 + 0.3 * APART, EXACT);
    near(at.position.y, 1.2, EXACT);
    tumble_world_free(w);
}
END_TEST

START_TEST(what_is_none_is_refused)
{
    tumble_world *w = with_floor();
    tumble_walker good = tumble_walker_capsule(1.2, 0.3), bad[9];
    tumble_walk at = on(good, 0, 0, 0), to = { .position = tumble_v(7, 7, 7) };
    tumble_vec3 way = { 0.1, 0, 0 };
    for (int k = 0; k < 9; k++) bad[k] = good;
    bad[0].radius = 0;
    bad[1].length = -1;
    bad[2].up = tumble_v(0, 0, 0);
    bad[3].step = -0.1;
    bad[4].slope = PI / 2 + 0.01;
    bad[5].slope = NAN;
    bad[6].radius = HUGE_VAL;
    bad[7].up.x = NAN;
    bad[8].slope = -0.1;
    for (int k = 0; k < 9; k++)
        ck_assert(!tumble_world_walk(w, bad[k], at, way, &to));
    ck_assert(!tumble_world_walk(w, good, at, tumble_v(NAN, 0, 0), &to));
    ck_assert(!tumble_world_walk(NULL, good, at, way, &to));
    at.position.z = HUGE_VAL;
    ck_assert(!tumble_world_walk(w, good, at, way, &to));
    near(to.position.x, 7, 0);
    at = on(good, 0, 0, 0);
    ck_assert(tumble_world_walk(w, good, at, way, NULL));
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        it_goes_as_far_as_it_is_told,
        it_climbs_steps_that_are_no_higher_than_its_own,
        it_climbs_a_stair_and_comes_down_again,
        off_a_ledge_it_falls,
        on_an_edge_it_stands_until_that_is_a_step_above_its_foot,
        it_climbs_slopes_that_are_no_steeper_than_its_own,
        it_slides_off_steeper_ones_as_its_law_says,
        it_stands_still_on_a_slope,
        along_a_wall_it_has_the_part_of_its_speed,
        in_a_corner_it_stops,
        between_steep_walls_it_falls_until_it_is_held,
        in_a_gutter_it_falls_along_it,
        a_low_ceiling_is_a_wall,
        seams_of_tiles_and_of_triangles_do_not_stop_it,
        seams_of_a_wall_do_not_stop_it,
        a_platform_carries_it,
        a_turntable_carries_it_in_a_circle,
        a_wall_that_comes_pushes_it,
        it_jumps_as_a_ball_is_thrown,
        it_is_never_in_anything,
        its_up_is_its_own,
        what_is_none_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "walk", .tests = tests, .seconds = 60 });
}
