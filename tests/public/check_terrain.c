// check_terrain.c - surfaces of many triangles, and what lies, rolls and flies
// over them, through tumble.h.  Book: chapter 19.

#include "tumble.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"

#include <check.h>
#include <malloc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double G = 9.81;
static const unsigned ALL = ~0u;

typedef double height_of(double x, double z);

static double flat(double x, double z)
{
    return 0 * (x + z);
}

static double wavy(double x, double z)
{
    return 0.4 * sin(1.1 * x) * cos(0.9 * z);
}

static double bowl(double x, double z)
{
    return 0.05 * (x * x + z * z) + 0.1 * sin(2 * x) * cos(2 * z);
}

typedef enum { HEIGHTS, MESH } form;

static double thickness = 0;        // m; 0: as it comes

// n x n points on a square of that side, turned about z.
static tumble_body lay(tumble_world *w, form as, height_of *f, int n,
                       double side, double turn)
{
    double *height = malloc((size_t)(n * n) * sizeof *height);
    tumble_vec3 *point = malloc((size_t)(n * n) * sizeof *point);
    int *v = malloc(6 * (size_t)(n * n) * sizeof *v), count = 0;
    for (int k = 0; k < n * n; k++) {
        double x = side * (2 * (k % n) - (n - 1)) / (2 * (n - 1));
        double z = side * (2 * (k / n) - (n - 1)) / (2 * (n - 1));
        height[k] = f(x, z);
        point[k] = tumble_v(x, height[k], z);
        int cell[6] = { k, k + n, k + n + 1, k, k + n + 1, k + 1 };
        if (k % n == n - 1 || k / n == n - 1) continue;
        memcpy(v + count, cell, sizeof cell);
        count += 6;
    }
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), turn);
    tumble_body b = as == MESH
        ? tumble_body_add_mesh(w, point, n * n, v, count / 3, thickness, o)
        : tumble_body_add_heights(w, height, n, n, side, side, thickness,
                                  o);
    ck_assert_ptr_null(tumble_world_failure(w));
    free(height);
    free(point);
    free(v);
    return b;
}

static tumble_world *empty(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ck_assert_ptr_nonnull(w);
    return w;
}

static void go(tumble_world *w, int steps)
{
    for (int k = 0; k < steps; k++) tumble_world_step(w);
}

static bool is_same(tumble_body a, tumble_body b)
{
    return a.place == b.place && a.generation == b.generation;
}

// --- laws --------------------------------------------------------------------

// A ball that rolls down a slope without sliding gains 5/7 g sin(slope).
// Rejects: a seam that is met, a piece that comes too late.
START_TEST(a_ball_rolls_down_a_slope_over_two_hundred_edges)
{
    const double slope = 0.2, r = 0.2, seconds = 5;
    for (int as = 0; as < 2; as++) {
        tumble_world *w = empty();
        lay(w, (form)as, flat, 251, 40, -slope);
        double x = -15 * cos(slope) + r * sin(slope);
        double y = 15 * sin(slope) + r * cos(slope);
        tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, r, 1),
                                        tumble_body_at(x, y, 0.03));
        double hop = 0;
        for (int k = 0; k < 60 * seconds; k++) {
            tumble_world_step(w);
            tumble_vec3 p = tumble_body_position(w, b);
            hop = fmax(hop, fabs(p.x * sin(slope) + p.y * cos(slope) - r));
        }
        tumble_vec3 p = tumble_body_position(w, b);
        double way = p.x * cos(slope) - p.y * sin(slope) + 15;
        double wanted = 5.0 / 7 * G * sin(slope) * seconds * seconds / 2;
        ck_assert_msg(fabs(way / wanted - 1) < 0.01 && way > 100 * 0.16,
                      "%g m of %g", way, wanted);
        ck_assert_msg(hop < 1e-3 && fabs(p.z - 0.03) < 1e-3,
                      "%g m off, %g m aside", hop, p.z - 0.03);
        tumble_world_free(w);
    }
}
END_TEST

// A roller of 3 cm, 2 or half as long, its axis across its way.
static tumble_body roll(tumble_world *w, int kind, double way, double speed)
{
    const double r = 0.015, half_pi = acos(0);
    tumble_shape s = kind % 2 ? tumble_shape_capsule(w, 0.04, r, 0.02)
                              : tumble_shape_cylinder(w, kind ? 0.06 : 0.008, r,
                                                      0.02);
    double c = cos(way), z = sin(way), h = sin(half_pi / 2);
    tumble_body_options o = tumble_body_at(0, r, 0);
    tumble_vec3 axis = tumble_v(z, 0, -c);
    tumble_vec3 about = tumble_v(-c, 0, -z);    // y x axis, turned by 90 degrees
    o.pose.rotation = (tumble_quat){ h * about.x, 0, h * about.z, h };
    o.velocity = tumble_v(speed * c, 0, speed * z);
    o.spin = tumble_v(axis.x * speed / r, 0, axis.z * speed / r);
    return tumble_body_add(w, s, o);
}

// At 1 m/s it turns by a radian in a frame, over cells a third as large as it is
// wide, or three times.
// Rejects: what is round, and turns, asked again on its way, without its floor; a
// contact of each triangle, with a friction of its own; a load that is lost as the
// roller goes from one to the next.
START_TEST(what_is_round_rolls_over_triangles_as_on_a_plane)
{
    const double cell[] = { 0.01, 0.09 }, way[] = { 0, 0.4, 0.7853981633974483 };
    for (int k = 0; k < 36; k++) {
        int kind = k % 3;
        double c = cell[k / 3 % 2], to = way[k / 6 % 3];
        tumble_world *w = empty();
        lay(w, (form)(k / 18), flat, (int)(2.8 / c), 2.8 - c, 0);
        tumble_body b = roll(w, kind, to, 1);
        double hop = 0;
        for (int n = 0; n < 75; n++) {
            tumble_world_step(w);
            hop = fmax(hop, tumble_body_position(w, b).y - 0.015);
        }
        tumble_vec3 v = tumble_body_velocity(w, b);
        double along = v.x * cos(to) + v.z * sin(to);
        ck_assert_msg(fabs(along - 1) < 1e-4 && hop < 1e-5,
                      "kind %d, cells of %g m, way %g: %.6f m/s, %g m up", kind,
                      c, to, along, hop);
        tumble_world_free(w);
    }
}
END_TEST

static double energy(tumble_world *w)
{
    tumble_measures m = tumble_world_measure(w);
    return m.kinetic + m.potential;
}

// A coin of so much thickness that leans as it rolls, and so in a circle.
static void roll_coin(tumble_world *w, double r, double thick, double lean)
{
    const double speed = 4 * sqrt(r / 0.5);
    tumble_shape s = tumble_shape_cylinder(w, thick, r, 2);
    tumble_body_options o =
        tumble_body_at(0, r * cos(lean) + thick / 2 * sin(lean), 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), acos(0) + lean);
    tumble_vec3 axis = tumble_quat_rotate(o.pose.rotation, tumble_v(0, 1, 0));
    double spin = axis.z > 0 ? -speed / r : speed / r;
    o.velocity = tumble_v(speed, 0, 0);
    o.spin = tumble_v(spin * axis.x, spin * axis.y, spin * axis.z);
    tumble_body_add(w, s, o);
}

// It touches at one corner, goes over many edges in a second, and is asked several
// times in a frame.  What rolls loses nothing.
// Rejects: a question within the frame that forgets the floor; a normal that leans
// over an edge, as that of the prism does.
START_TEST(a_coin_that_leans_rolls_over_triangles_without_loss)
{
    const double lean[] = { 0.4, 0.7 }, cell[] = { 0.4, 3 };
    for (int k = 0; k < 16; k++) {
        double r = 0.5, thick = k % 2 ? 0.3 * r : 0.1 * r;
        double c = cell[k / 4 % 2] * r;
        tumble_options o = tumble_options_default();
        o.friction = 1;
        tumble_world *w = tumble_world_make(&o);
        int n = (int)(24 / c) + 1;
        lay(w, (form)(k / 8), flat, n, c * (n - 1), 0);
        roll_coin(w, r, thick, lean[k / 2 % 2]);
        go(w, 1);
        double before = energy(w);
        go(w, 100);
        ck_assert_msg(fabs(energy(w) / before - 1) < 5e-3,
                      "%g m thick, lean %g, cells of %g m: %g", thick,
                      lean[k / 2 % 2], c, energy(w) / before - 1);
        tumble_world_free(w);
    }
}
END_TEST

// What slides stops after v^2 / (2 mu g).
// Rejects: hidden sides that stop, lift or turn a box.
START_TEST(a_box_slides_over_a_floor_of_cells_as_friction_says)
{
    for (int k = 0; k < 12; k++) {
        double v = 2 << k % 3, turn = 0.4 * (k / 3 % 2), hop = 0, mu = 0.3;
        tumble_options options = tumble_options_default();
        options.friction = mu;
        tumble_world *w = tumble_world_make(&options);
        lay(w, (form)(k / 6), flat, 21, 40, 0);
        tumble_body_options o = tumble_body_at(-15, 0.1, 0.13);
        o.velocity = tumble_v(v, 0, 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), turn);
        tumble_body b =
            tumble_body_add(w, tumble_shape_box(w, tumble_v(0.4, 0.2, 0.4), 1),
                            o);
        for (int i = 0; i < 240; i++) {
            tumble_world_step(w);
            hop = fmax(hop, fabs(tumble_body_position(w, b).y - 0.1));
        }
        tumble_vec3 p = tumble_body_position(w, b);
        double wanted = v * v / (2 * mu * G);
        ck_assert_msg(fabs((p.x + 15) / wanted - 1) < 0.002,
                      "%g m of %g", p.x + 15, wanted);
        ck_assert_msg(hop < 1e-3 && fabs(p.z - 0.13) < 0.005,
                      "%g m up, %g aside", hop, p.z - 0.13);
        tumble_world_free(w);
    }
}
END_TEST

// On four hundred triangles at once.
// Rejects: a floor of which only the first pieces are seen.
START_TEST(a_box_slides_over_cells_that_are_much_smaller_than_it)
{
    for (int as = 0; as < 2; as++) {
        double mu = 0.5, wanted = 9 / (2 * mu * G);
        tumble_world *w = empty();
        lay(w, (form)as, flat, 101, 10, 0);
        tumble_body_options o = tumble_body_at(-1, 0.25, 0.1);
        o.velocity = tumble_v(3, 0, 0);
        tumble_body b =
            tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 0.5, 1), 1), o);
        go(w, 60);
        tumble_vec3 p = tumble_body_position(w, b);
        ck_assert_msg(fabs((p.x + 1) / wanted - 1) < 0.01 && fabs(p.z - 0.1) < 0.01,
                      "%g m of %g, %g aside", p.x + 1, wanted, p.z - 0.1);
        tumble_world_free(w);
    }
}
END_TEST

// --- piles -------------------------------------------------------------------

static tumble_shape shape_of(tumble_world *w, int kind)
{
    return kind == 0 ? tumble_shape_box(w, tumble_v(0.5, 0.4, 0.6), 1)
         : kind == 1 ? tumble_shape_icosahedron(w, 0.3, 1)
                     : tumble_shape_capsule(w, 0.4, 0.2, 1);
}

enum { PILE = 50 };

static void pour(tumble_world *w, tumble_body *b)
{
    tumble_shape s[3];
    for (int k = 0; k < 3; k++) s[k] = shape_of(w, k);
    for (int k = 0; k < PILE; k++)
        b[k] = tumble_body_add(w, s[k % 3],
                               tumble_body_at(0.5 * (k % 4) - 0.7,
                                              2 + 0.5 * (k / 4),
                                              0.5 * (k % 5) - 1));
}

// Rejects: a piece that goes from under a sleeper, or shakes what lies on it.
START_TEST(a_pile_on_a_wavy_ground_falls_asleep_and_none_falls_through)
{
    for (int as = 0; as < 2; as++) {
        tumble_world *w = empty();
        tumble_body b[PILE];
        lay(w, (form)as, bowl, 81, 20, 0);
        pour(w, b);
        go(w, 3000);            // a capsule rolls to and fro for long
        for (int k = 0; k < PILE; k++) {
            tumble_vec3 p = tumble_body_position(w, b[k]);
            ck_assert_msg(p.y - bowl(p.x, p.z) > 0.15, "body %d is %g m above",
                          k, p.y - bowl(p.x, p.z));
        }
        ck_assert_int_eq(tumble_world_last_step(w).asleep, PILE);
        ck_assert(tumble_world_measure(w).penetration < 0.005);
        tumble_world_free(w);
    }
}
END_TEST

// Cells of 2 m, and heights up to 2 m that have nothing to do with each other.
static double rough(double x, double z)
{
    return 2 * fabs(sin(12.9898 * x + 78.233 * z));
}

// The point of a cone comes to stand in the crease of a valley, where two sides meet,
// and is met by both.
// Rejects: of two sides that hide each other there, both left out.
START_TEST(what_is_pointed_stays_out_of_the_creases_of_a_rough_ground)
{
    unsigned long long r = 11;
    for (int as = 0; as < 2; as++) {
        tumble_world *w = empty();
        lay(w, (form)as, rough, 17, 32, 0);
        tumble_shape cone = tumble_shape_cone(w, 1, 0.4, 50);
        double deepest = 0;
        for (int k = 0; k < 24; k++) {
            tumble_body_options o = tumble_body_at(3 * (k % 5) - 6.3, 4,
                                                   3 * (k / 5) - 6.1);
            tumble_vec3 axis = { random_real(&r), random_real(&r), random_real(&r) };
            o.pose.rotation = tumble_quat_turn(axis, 3 * random_real(&r));
            tumble_body_add(w, cone, o);
        }
        for (int k = 0; k < 400; k++) {
            go(w, 1);
            deepest = fmax(deepest, tumble_world_measure(w).penetration);
        }
        ck_assert_msg(deepest < 0.02, "%g m deep", deepest);
        tumble_world_free(w);
    }
}
END_TEST

// Rejects: a piece that comes for one body, and wakes another.
START_TEST(what_rolls_by_wakes_no_sleeper)
{
    tumble_world *w = empty();
    thickness = 0.5;
    lay(w, HEIGHTS, flat, 11, 10, 0);
    tumble_body b = tumble_body_add(w,
                                    tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                                    tumble_body_at(0, 0.5, -0.1));
    go(w, 120);
    ck_assert(!tumble_body_is_awake(w, b));
    tumble_body_options o = tumble_body_at(-3, 0.2, 1.3);
    o.velocity = tumble_v(4, 0, 0);
    tumble_body rolls = tumble_body_add(w, tumble_shape_sphere(w, 0.2, 1), o);
    for (int k = 0; k < 80; k++) {
        tumble_world_step(w);
        ck_assert(!tumble_body_is_awake(w, b));
    }
    ck_assert(tumble_body_position(w, rolls).x > 0.5);
    tumble_world_free(w);
}
END_TEST

// A sheet of n x n vertices comes to lie on wavy ground of so many points a side, and
// finds memory for all that it touches.
static void lay_sheet(int points, double side, int n, double width)
{
    tumble_world *w = empty();
    tumble_vec3 at[400];
    lay(w, HEIGHTS, wavy, points, side, 0);
    tumble_body b = tumble_body_add(w, tumble_shape_cloth(w, n, n, width, width, 1),
                                    tumble_body_at(0.3, 1, 0.2));
    for (int k = 0; k < 180; k++) {
        go(w, 1);
        ck_assert_int_eq(tumble_world_last_step(w).dropped, 0);
    }
    tumble_body_vertices(w, b, at, 400);
    for (int i = 0; i < n * n; i++)
        ck_assert_msg(at[i].y > wavy(at[i].x, at[i].z), "vertex %d", i);
    tumble_world_free(w);
}

// Rejects: cloth and ropes that know no surface.
START_TEST(a_cloth_lies_on_a_wavy_ground)
{
    lay_sheet(41, 20, 20, 2);
}
END_TEST

// The vertices of the cloth stand .4 m apart, and each is near dozens of triangles.
// Rejects: a list with room for four of them, which drops what is more.
START_TEST(a_coarse_cloth_lies_on_a_ground_of_small_triangles)
{
    lay_sheet(101, 10, 10, 3.6);
}
END_TEST

// --- what is fast, and what is below -------------------------------------------

static tumble_body shoot(tumble_world *w, unsigned long long *r, int k,
                         double from, double speed)
{
    tumble_body_options o = tumble_body_at(4 * random_real(r), from,
                                           4 * random_real(r));
    o.velocity = tumble_v(50 * random_real(r), speed, 0);
    tumble_vec3 sides = tumble_v(0.03, 0.02, 0.04);
    return tumble_body_add(w, k % 2 ? tumble_shape_sphere(w, 0.02, 0.01)
                                    : tumble_shape_box(w, sides, 0.01), o);
}

// From above and from below, at a surface that is 5 cm thick.
// Rejects: a way that ends between two frames; one that a contact with a
// neighbour turns into the next triangle; an edge that lets something through.
START_TEST(a_bullet_of_three_hundred_metres_a_second_stops)
{
    unsigned long long r = 7;
    thickness = 0.05;
    for (int k = 0; k < 400; k++) {
        tumble_world *w = empty();
        double up = k / 4 % 2 ? -1 : 1;
        lay(w, (form)(k / 2 % 2), wavy, 81, 20, 0);
        tumble_body b = shoot(w, &r, k, up * 20, up * -300);
        for (int i = 0; i < 30; i++) {
            tumble_world_step(w);
            tumble_vec3 p = tumble_body_position(w, b);
            if (fabs(p.x) > 9.5 || fabs(p.z) > 9.5) break;
            // (On a cell's diagonal the wave is up to 0.4 (1.1^2 + 0.9^2) 0.25^2 / 8
            // over its triangles.)
            double above = up * (p.y - wavy(p.x, p.z)) + (up < 0 ? 0 : 0.0063);
            ck_assert_msg(above > 0, "shot %d: %g m behind", k, -above);
        }
        tumble_world_free(w);
    }
}
END_TEST

static double groove(double x, double z)
{
    return 8 * fabs(x) + 0 * z;
}

// What is put before one side of a narrow groove may be behind the other.
// Rejects: one that is put before a side once, and not looked for again.
START_TEST(what_is_shot_into_a_groove_stays_in_it)
{
    unsigned long long r = 3;
    for (int k = 0; k < 100; k++) {
        tumble_world *w = empty();
        lay(w, (form)(k / 2 % 2), groove, 41, 8, 0);
        tumble_body_options o = tumble_body_at(random_real(&r), 33,
                                               random_real(&r));
        o.velocity = tumble_v(20 * random_real(&r), -300, 40 * random_real(&r));
        tumble_shape s = k % 2 ? tumble_shape_sphere(w, 0.05, 1)
                               : tumble_shape_box(w, tumble_v(0.1, 0.05, 0.08),
                                                  1);
        tumble_body b = tumble_body_add(w, s, o);
        for (int i = 0; i < 30; i++) {
            tumble_world_step(w);
            tumble_vec3 p = tumble_body_position(w, b);
            if (fabs(p.x) > 3.9 || fabs(p.z) > 3.9) break;
            ck_assert_msg(p.y > groove(p.x, p.z) - 1e-9, "shot %d: %g m below",
                          k, groove(p.x, p.z) - p.y);
        }
        tumble_world_free(w);
    }
}
END_TEST

// Of restitution 0.8, from 100 m/s.
// Rejects: pieces that come only where a body is, and not where it gets; what is
// stopped by the last question alone, and loses its speed.
START_TEST(what_is_thrown_down_bounces)
{
    for (int as = 0; as < 2; as++) {
        tumble_options options = tumble_options_default();
        options.restitution = 0.8;
        tumble_world *w = tumble_world_make(&options);
        lay(w, (form)as, flat, 81, 20, 0);
        tumble_body_options o = tumble_body_at(0.1, 10.4, 0.2);
        o.velocity = tumble_v(0, -100, 0);
        tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.05, 1), o);
        go(w, 8);
        double v = tumble_body_velocity(w, b).y;
        ck_assert_msg(fabs(v / 80 - 1) < 0.02, "%g m/s up", v);
        tumble_world_free(w);
    }
}
END_TEST

// Rejects: a surface that is met from its front only.
START_TEST(from_behind_a_ball_is_stopped)
{
    for (int as = 0; as < 2; as++) {
        tumble_world *w = empty();
        lay(w, (form)as, wavy, 41, 20, 0);
        tumble_body_options o = tumble_body_at(0.3, -5, 0.2);
        o.velocity = tumble_v(0, 20, 0);
        tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.2, 1), o);
        for (int k = 0; k < 60; k++) {
            tumble_world_step(w);
            ck_assert(tumble_body_position(w, b).y < -0.5);
        }
        tumble_world_free(w);
    }
}
END_TEST

// Rejects: the way out through a hidden side, or through the bottom.
START_TEST(what_begins_half_below_is_pushed_up)
{
    for (int k = 0; k < 4; k++) {
        tumble_world *w = empty();
        lay(w, (form)(k / 2), flat, 41, 10, 0);
        tumble_shape s = k % 2 ? tumble_shape_sphere(w, 0.25, 1)
                               : tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5),
                                                  1);
        tumble_body b = tumble_body_add(w, s, tumble_body_at(0.11, 0, 0.07));
        go(w, 240);
        ck_assert_msg(fabs(tumble_body_position(w, b).y - 0.25) < 1e-3,
                      "%g m up", tumble_body_position(w, b).y);
        tumble_world_free(w);
    }
}
END_TEST

// --- questions ---------------------------------------------------------------

static double slope(double x, double z)
{
    return 0.3 * x - 0.2 * z + 1;
}

// A surface whose points lie in a plane is that plane.
// Rejects: a box of the tree that leaves out what it holds.
START_TEST(rays_meet_a_surface_where_it_is)
{
    tumble_world *w = empty();
    tumble_body ground = lay(w, MESH, slope, 61, 20, 0);
    unsigned long long r = 3;
    double length = sqrt(0.3 * 0.3 + 0.2 * 0.2 + 1);
    for (int k = 0; k < 500; k++) {
        double x = 9 * random_real(&r), z = 9 * random_real(&r);
        double to_x = x + random_real(&r), to_z = z + random_real(&r);
        tumble_vec3 from = tumble_v(x, 9, z), to = tumble_v(to_x, -9, to_z);
        double above = 9 - slope(x, z), below = slope(to_x, to_z) + 9;
        tumble_hit hit;
        ck_assert(tumble_world_ray(w, from, to, ALL, &hit));
        ck_assert(fabs(hit.fraction - above / (above + below)) < 1e-9);
        ck_assert(is_same(hit.body, ground));
        ck_assert(fabs(hit.normal.y - 1 / length) < 1e-9);
        ck_assert(tumble_world_nearest(w, from, 100, ALL, &hit));
        if (fabs(x) < 6 && fabs(z) < 6)
            ck_assert(fabs(hit.fraction - above / length) < 1e-9);
    }
    ck_assert(!tumble_world_ray(w, tumble_v(11, 9, 0), tumble_v(11, -9, 0), ALL,
                                NULL));
    ck_assert(!tumble_world_ray(w, tumble_v(0, 9, 0), tumble_v(0, -9, 0), 2,
                                NULL));
    ck_assert(!tumble_world_nearest(w, tumble_v(0, 9, 0), 1, ALL, NULL));
    tumble_world_free(w);
}
END_TEST

// Rejects: pieces that are asked beside the surface, or in its place.
START_TEST(shapes_meet_a_surface_whether_or_not_something_is_near)
{
    for (int k = 0; k < 2; k++) {
        tumble_world *w = empty();
        tumble_body ground = lay(w, HEIGHTS, flat, 61, 20, 0), out[4];
        tumble_shape s = tumble_shape_sphere(w, 0.25, 1);
        if (k) tumble_body_add(w, s, tumble_body_at(3.3, 0.25, 0));
        go(w, 3);
        tumble_pose at = { { 3, 2, 0.1 }, { 0, 0, 0, 1 } };
        tumble_hit hit;
        ck_assert(tumble_world_sweep(w, s, at, tumble_v(0, -4, 0), ALL, &hit));
        ck_assert(k || fabs(hit.fraction - 1.75 / 4) < 1e-9);
        ck_assert(k || is_same(hit.body, ground));
        at.position.y = 0.2;
        at.position.x = -3;
        ck_assert_int_eq(tumble_world_overlap(w, s, at, ALL, out, 4), 1);
        ck_assert(is_same(out[0], ground));
        at.position.y = 0.26;
        ck_assert_int_eq(tumble_world_overlap(w, s, at, ALL, out, 4), 0);
        tumble_world_free(w);
    }
}
END_TEST

// Rejects: a contact that names a piece, an event for each piece.
START_TEST(contacts_and_events_name_the_surface_once)
{
    tumble_world *w = empty();
    tumble_event e[8];
    tumble_contact c[8];
    int begins = 0;
    tumble_body ground = lay(w, MESH, flat, 101, 20, 0);
    tumble_body_options o = tumble_body_at(-5, 0.1, 0.03);
    o.velocity = tumble_v(5, 0, 0);
    tumble_body b =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.4, 0.2, 0.4), 1), o);
    for (int k = 0; k < 60; k++) {
        tumble_world_step(w);
        int n = tumble_world_events(w, e, 8);
        for (int i = 0; i < n; i++) begins += e[i].begins;
        n = tumble_world_contacts(w, c, 8);
        for (int i = 0; i < n; i++)
            ck_assert((is_same(c[i].a, ground) || is_same(c[i].a, b))
                      && (is_same(c[i].b, ground) || is_same(c[i].b, b)));
    }
    ck_assert_int_eq(begins, 1);
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 2);
    tumble_world_free(w);
}
END_TEST

// A wall of 0.2 m, of twelve triangles, 5 m wide.
// Rejects: what is solid behind one side, and stands out of the other.
START_TEST(a_thin_wall_is_met_where_it_is_from_both_sides)
{
    static const int face[36] = {
        0, 4, 6, 0, 6, 2, 3, 7, 5, 3, 5, 1, 0, 1, 5, 0, 5, 4,
        3, 2, 6, 3, 6, 7, 0, 2, 3, 0, 3, 1, 5, 7, 6, 5, 6, 4 };
    tumble_world *w = empty();
    tumble_vec3 p[8];
    tumble_body b[2];
    for (int k = 0; k < 8; k++)
        p[k] = tumble_v(k & 1 ? 2.5 : -2.5, k & 2 ? 2 : 0, k & 4 ? 0.1 : -0.1);
    tumble_body_add_mesh(w, p, 8, face, 12, 0, tumble_body_at(0, 0, 0));
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int k = 0; k < 2; k++) {
        tumble_body_options o = tumble_body_at(0.3, 0.25, k ? 1 : -1);
        o.velocity = tumble_v(0, 0, k ? -4 : 4);
        b[k] = tumble_body_add(w, s, o);
        tumble_hit hit;
        ck_assert(tumble_world_ray(w, tumble_v(1, 1, k ? 3 : -3),
                                   tumble_v(1, 1, 0), ALL, &hit));
        ck_assert(fabs(fabs(hit.point.z) - 0.1) < 1e-9);
    }
    tumble_body top = tumble_body_add(w, tumble_shape_sphere(w, 0.2, 1),
                                      tumble_body_at(-1, 2.2, 0));
    double nearest[2] = { 9, 9 };
    for (int i = 0; i < 120; i++) {
        tumble_world_step(w);
        for (int k = 0; k < 2; k++)
            nearest[k] = fmin(nearest[k],
                              fabs(tumble_body_position(w, b[k]).z));
    }
    for (int k = 0; k < 2; k++)
        ck_assert_msg(fabs(nearest[k] - 0.35) < 0.005, "%g m", nearest[k]);
    ck_assert(fabs(tumble_body_position(w, top).y - 2.2) < 1e-3);
    tumble_world_free(w);
}
END_TEST

// --- coming, going, keeping ----------------------------------------------------

static void backwards(void *context, void (*work)(void *data, int item),
                      void *data, int items)
{
    (void)context;
    for (int k = items - 1; k >= 0; k--) work(data, k);
}

// Rejects: a piece that a copy of the world has not, or finds later.
START_TEST(any_order_and_a_copy_give_the_same_bits)
{
    tumble_body b[PILE];
    tumble_world *w = empty(), *other = empty();
    lay(w, MESH, bowl, 81, 20, 0);
    pour(w, b);
    lay(other, MESH, bowl, 81, 20, 0);
    pour(other, b);
    tumble_world_run_on(other, backwards, NULL);
    go(w, 80);
    go(other, 80);
    size_t size = tumble_world_save(w, NULL, 0);
    void *bytes = malloc(size);
    tumble_world_save(w, bytes, size);
    tumble_world *copy = tumble_world_load(bytes, size);
    ck_assert_ptr_nonnull(copy);
    free(bytes);
    for (int k = 0; k < 200; k++) {
        tumble_world_step(w);
        tumble_world_step(other);
        tumble_world_step(copy);
        ck_assert_uint_eq(tumble_world_hash(w), tumble_world_hash(copy));
    }
    ck_assert_uint_eq(tumble_world_hash(w), tumble_world_hash(other));
    tumble_world_free(w);
    tumble_world_free(other);
    tumble_world_free(copy);
}
END_TEST

// Rejects: pieces, or their shapes, that outlive the surface.
START_TEST(a_surface_that_is_removed_lets_its_load_fall)
{
    tumble_world *w = empty();
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body b = tumble_body_add(w, s, tumble_body_at(0, 0.5, 0));
    size_t size = 0;
    for (int k = 0; k < 20; k++) {
        tumble_body ground = lay(w, (form)(k % 2), flat, 21, 20, 0);
        tumble_body second = lay(w, MESH, flat, 5, 2, 0);
        tumble_pose at = { { 0, 0.5, 0 }, { 0, 0, 0, 1 } };
        tumble_body_set_pose(w, b, at);
        go(w, 120);
        ck_assert(!tumble_body_is_awake(w, b));
        ck_assert(tumble_body_remove(w, ground)
                  && tumble_body_remove(w, second));
        ck_assert(!tumble_body_exists(w, ground)
                  && !tumble_body_remove(w, ground));
        tumble_world_forget_failure(w);
        go(w, 30);
        ck_assert(tumble_body_position(w, b).y < 0);
        if (k == 4) size = tumble_world_save(w, NULL, 0);
        if (k > 4) ck_assert_uint_le(tumble_world_save(w, NULL, 0), size);
    }
    ck_assert(tumble_body_remove(w, b) && tumble_shape_remove(w, s));
    tumble_world_free(w);
}
END_TEST

// Rejects: pieces of what was left behind, for ever; a step that costs more the
// larger the surface is.
START_TEST(a_step_knows_only_what_is_near)
{
    tumble_world *w = empty();
    lay(w, HEIGHTS, flat, 224, 223, 0);
    tumble_body_options o = tumble_body_at(-100, 0.3, 0.2);
    o.velocity = tumble_v(30, 0, 0);
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.3, 1), o);
    size_t size = 0;
    for (int k = 0; k < 360; k++) {
        tumble_world_step(w);
        ck_assert_int_le(tumble_world_last_step(w).pairs, 40);
        if (k == 120) size = tumble_world_save(w, NULL, 0);
    }
    ck_assert(tumble_body_position(w, b).x > 20);
    ck_assert((double)tumble_world_save(w, NULL, 0) < 1.1 * (double)size);
    tumble_world_free(w);
}
END_TEST

// Rejects: pieces that go from under a sleeper.
START_TEST(a_sleeper_goes_on_touching_what_it_lies_on)
{
    tumble_world *w = empty();
    tumble_event e[8];
    lay(w, HEIGHTS, flat, 224, 223, 0);
    tumble_body b = tumble_body_add(w,
                                    tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                                    tumble_body_at(0.2, 0.5, 5));
    go(w, 120);
    ck_assert(!tumble_body_is_awake(w, b));
    ck_assert_int_eq(tumble_world_events(w, e, 8), 1);
    tumble_body_options o = tumble_body_at(-100, 0.3, 0.2);
    o.velocity = tumble_v(30, 0, 0);
    tumble_body far = tumble_body_add(w, tumble_shape_sphere(w, 0.3, 1), o);
    go(w, 360);
    ck_assert(!tumble_body_is_awake(w, b));
    int n = tumble_world_events(w, e, 8);
    for (int k = 0; k < n; k++)
        ck_assert(is_same(e[k].a, far) || is_same(e[k].b, far));
    tumble_world_free(w);
}
END_TEST

// Rejects: a surface of which only the pieces are drawn.
START_TEST(a_surface_is_drawn_as_it_was_given)
{
    tumble_world *w = empty();
    tumble_body b = lay(w, MESH, wavy, 11, 10, 0.5);
    tumble_vec3 at[121];
    int triangles;
    ck_assert_int_eq(tumble_body_vertices(w, b, at, 121), 121);
    const int *v = tumble_body_triangles(w, b, &triangles);
    ck_assert_int_eq(triangles, 200);
    ck_assert(v[0] == 0 && v[1] == 11 && v[2] == 12);
    double x = at[0].x * cos(0.5) + at[0].y * sin(0.5);
    double y = at[0].y * cos(0.5) - at[0].x * sin(0.5);
    ck_assert(fabs(x + 5) < 1e-12 && fabs(y - wavy(-5, -5)) < 1e-12);
    tumble_vec3 p = tumble_body_vertex(w, b, 0);
    ck_assert(p.x == at[0].x && p.y == at[0].y && p.z == at[0].z);
    ck_assert(tumble_body_position(w, b).x == 0
              && tumble_body_position(w, b).y == 0);
    tumble_world_free(w);
}
END_TEST

// Rejects: a filter that pieces which come later do not have.
START_TEST(a_surface_meets_only_what_its_mask_says)
{
    tumble_world *w = empty();
    tumble_body ground = lay(w, HEIGHTS, flat, 21, 20, 0);
    ck_assert(tumble_body_set_filter(w, ground, 2, ALL));
    tumble_shape s = tumble_shape_sphere(w, 0.5, 1);
    tumble_body_options o = tumble_body_at(-5, 0.5, 0);
    tumble_body lies = tumble_body_add(w, s, o);
    o = tumble_body_at(-5, 0.5, 1.2);
    o.mask = 1;
    tumble_body falls = tumble_body_add(w, s, o);
    go(w, 60);
    ck_assert(fabs(tumble_body_position(w, lies).y - 0.5) < 1e-3);
    ck_assert(tumble_body_position(w, falls).y < -3);
    tumble_world_free(w);
}
END_TEST

// --- bad input ---------------------------------------------------------------

static void is_refused(tumble_world *w, tumble_body b, const char *why)
{
    ck_assert_uint_eq(b.generation, 0);
    ck_assert_ptr_nonnull(tumble_world_failure(w));
    ck_assert_msg(strstr(tumble_world_failure(w), why) != NULL,
                  "\"%s\" is not \"%s\"", tumble_world_failure(w), why);
    tumble_world_forget_failure(w);
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 0);
}

// Rejects: a surface of which nothing is known, or half of which is there.
START_TEST(a_bad_surface_is_refused_in_a_sentence)
{
    tumble_world *w = empty();
    tumble_body_options o = tumble_body_at(0, 0, 0), none = o;
    tumble_vec3 p[4] = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 0, 2 } };
    tumble_vec3 lost[3] = { { 0, 0, 0 }, { 0, 0, 1 }, { (double)NAN, 0, 0 } };
    int v[3] = { 0, 1, 2 }, far[3] = { 0, 1, 4 }, line[3] = { 0, 1, 3 };
    none.group = 0;
    is_refused(w, tumble_body_add_mesh(w, p, 4, far, 1, 0, o), "names point 4");
    is_refused(w, tumble_body_add_mesh(w, lost, 3, v, 1, 0, o), "point 2");
    is_refused(w, tumble_body_add_mesh(w, p, 4, line, 1, 0, o), "no triangle");
    is_refused(w, tumble_body_add_mesh(w, p, 4, v, 0, 0, o),
               "0 triangles: it has");
    is_refused(w, tumble_body_add_mesh(w, NULL, 4, v, 1, 0, o),
               "the list of points is NULL");
    is_refused(w, tumble_body_add_mesh(w, p, 4, NULL, 1, 0, o),
               "the list of triangles is NULL");
    is_refused(w, tumble_body_add_mesh(w, p, 4, v, 1, -1, o), "thickness");
    is_refused(w, tumble_body_add_mesh(w, p, 4, v, 1, 1e-9, o), "too thin");
    is_refused(w, tumble_body_add_mesh(w, p, 4, v, 1, 0, none), "group 0");
    double height[4] = { 0, 0, 0, (double)NAN };
    is_refused(w, tumble_body_add_heights(w, height, 2, 2, 1, 1, 0, o),
               "point 3");
    is_refused(w, tumble_body_add_heights(w, height, 1, 2, 1, 1, 0, o),
               "1 x 2");
    is_refused(w, tumble_body_add_heights(w, height, 2, 2, 0, 1, 0, o),
               "0 m wide");
    is_refused(w, tumble_body_add_heights(w, NULL, 2, 2, 1, 1, 0, o),
               "the list of heights is NULL");
    tumble_world_free(w);
    ck_assert_uint_eq(tumble_body_add_mesh(NULL, p, 4, v, 1, 0, o).generation,
                      0);
}
END_TEST

// Rejects: half a surface that stays, or its memory.
START_TEST(without_memory_there_is_no_surface)
{
    double height[9] = { 0 };
    long before = blocks_held;
    bool is_said = true, is_nothing = true;
    tumble_world *w = tumble_world_make(NULL);
    tumble_body b = { 0, 0 };
    int tries = 0;
    for (; tries < 200 && b.generation == 0; tries++) {
        mallocs_left = tries;
        b = tumble_body_add_heights(w, height, 3, 3, 4, 4, 0,
                                    tumble_body_at(0, 0, 0));
        mallocs_left = INT_MAX;
        const char *why = tumble_world_failure(w);
        if (b.generation != 0) break;
        is_said &= why && strstr(why, "memory") != NULL;
        is_nothing &= tumble_world_bodies(w, NULL, 0) == 0;
        tumble_world_forget_failure(w);
    }
    bool is_gone = tumble_body_remove(w, b);
    tumble_world_free(w);
    long after = blocks_held;
    ck_assert(is_said && is_nothing && is_gone && tries > 20);
    ck_assert(after == before);
}
END_TEST

// Rejects: pieces that are counted as there, and have found no memory.
START_TEST(pieces_that_found_no_memory_come_later)
{
    int pairs = 0;
    for (int k = 0; k < 150; k++) {
        tumble_world *w = empty();
        lay(w, HEIGHTS, flat, 21, 20, 0);
        tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.5, 1),
                                        tumble_body_at(4.1, 0.5, 3.3));
        if (k > 0) mallocs_left = 2 * k;
        tumble_world_step(w);
        mallocs_left = INT_MAX;
        go(w, 10);
        if (k == 0) pairs = tumble_world_last_step(w).pairs;
        ck_assert_int_eq(tumble_world_last_step(w).pairs, pairs);
        ck_assert(fabs(tumble_body_position(w, b).y - 0.5) < 5e-3);
        tumble_world_free(w);
    }
}
END_TEST

// Rejects: a piece without a volume.
START_TEST(a_triangle_without_an_area_is_left_out)
{
    tumble_world *w = empty();
    tumble_vec3 p[4] = { { -2, 0, -2 }, { -2, 0, 2 }, { 2, 0, 2 }, { 2, 0, -2 } };
    int v[12] = { 0, 1, 2, 0, 0, 2, 0, 2, 0, 0, 2, 3 };
    tumble_body_add_mesh(w, p, 4, v, 4, 0, tumble_body_at(0, 0, 0));
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.5, 1),
                                    tumble_body_at(0.01, 0.6, 0));
    go(w, 90);
    ck_assert_ptr_null(tumble_world_failure(w));
    ck_assert(fabs(tumble_body_position(w, b).y - 0.5) < 1e-3);
    tumble_world_free(w);
}
END_TEST

// Rejects: a surface of which one piece is moved; a joint that holds nothing.
START_TEST(a_surface_stays_where_it_is)
{
    tumble_world *w = empty();
    tumble_body ground = lay(w, HEIGHTS, flat, 21, 20, 0);
    tumble_pose at = { { 0, 5, 0 }, { 0, 0, 0, 1 } };
    ck_assert(!tumble_body_set_pose(w, ground, at));
    ck_assert(strstr(tumble_world_failure(w), "is a surface") != NULL);
    tumble_world_forget_failure(w);
    ck_assert(!tumble_body_push(w, ground, tumble_v(1, 0, 0),
                                tumble_v(0, 0, 0)));
    tumble_world_forget_failure(w);
    tumble_body sign =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                        tumble_body_at(0, 5, 0));
    tumble_joint_hinge(w, ground, sign, tumble_v(0, 6, 0), tumble_v(0, 0, 1));
    go(w, 120);
    ck_assert(fabs(tumble_body_position(w, sign).y - 5) < 1e-3);
    tumble_world_free(w);
}
END_TEST

// Balls that fall on a terrain, beside a cloth.
static tumble_world *cloth_and_terrain(void)
{
    enum { SIDE = 9 };
    tumble_world *w = tumble_world_make(NULL);
    double h[SIDE * SIDE];
    for (int k = 0; k < SIDE * SIDE; k++) h[k] = 0.1 * (k * k % 7);
    tumble_body_add_heights(w, h, SIDE, SIDE, 4, 4, 0, tumble_body_at(0, 0, 0));
    tumble_shape ball = tumble_shape_sphere(w, 0.2, 1);
    for (int k = 0; k < 12; k++)
        tumble_body_add(w, ball, tumble_body_at(k % 4 - 1.5, 1.5 + k / 4,
                                                0.3 * (k % 3)));
    tumble_shape sheet = tumble_shape_cloth(w, 8, 8, 1, 1, 0.3);
    tumble_body_pin(w, tumble_body_add(w, sheet, tumble_body_at(3, 4, 0)), 0);
    return w;
}

// Fast balls about a cloth that is where the other is.
static tumble_world *cloth_in_a_crowd(void)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape ball = tumble_shape_sphere(w, 0.2, 1);
    tumble_shape sheet = tumble_shape_cloth(w, 8, 8, 1, 1, 0.3);
    for (int k = 0; k < 120; k++) {
        tumble_body_options o = tumble_body_at(2 + k % 5 * 0.5,
                                               3 + k / 25 * 0.5,
                                               k / 5 % 5 * 0.5 - 1);
        o.velocity = tumble_v(9, 0, 0);
        tumble_body_add(w, ball, o);
    }
    tumble_body_add(w, sheet, tumble_body_at(3, 4, 0));
    for (int k = 0; k < 3; k++) tumble_world_step(w);
    return w;
}

// A triangle that comes among the bodies is known to a cloth in the same frame: it
// asks nothing of memory that was not filled.
// Rejects: cloth that looks around before the triangles are there.
START_TEST(cloth_beside_a_terrain_goes_on_with_the_same_bits)
{
    mallopt(M_PERTURB, 0xa5);
    tumble_world *w = cloth_and_terrain();
    for (int f = 0; f < 60; f += 4) {
        tumble_world *other = cloth_in_a_crowd();
        size_t size = tumble_world_save(w, NULL, 0);
        void *saved = malloc(size);
        ck_assert_ptr_nonnull(saved);
        tumble_world_save(w, saved, size);
        ck_assert(tumble_world_restore(other, saved, size));
        for (int k = 0; k < 4; k++) {
            tumble_world_step(w);
            tumble_world_step(other);
            ck_assert_msg(tumble_world_hash(w) == tumble_world_hash(other),
                          "frame %d", f + k);
            ck_assert_int_eq(tumble_world_last_step(w).substeps,
                             tumble_world_last_step(other).substeps);
        }
        free(saved);
        tumble_world_free(other);
    }
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_ball_rolls_down_a_slope_over_two_hundred_edges,
        what_is_round_rolls_over_triangles_as_on_a_plane,
        a_coin_that_leans_rolls_over_triangles_without_loss,
        a_box_slides_over_a_floor_of_cells_as_friction_says,
        a_box_slides_over_cells_that_are_much_smaller_than_it,
        a_pile_on_a_wavy_ground_falls_asleep_and_none_falls_through,
        what_is_pointed_stays_out_of_the_creases_of_a_rough_ground,
        what_rolls_by_wakes_no_sleeper,
        a_cloth_lies_on_a_wavy_ground,
        a_coarse_cloth_lies_on_a_ground_of_small_triangles,
        a_bullet_of_three_hundred_metres_a_second_stops,
        what_is_shot_into_a_groove_stays_in_it,
        what_is_thrown_down_bounces,
        from_behind_a_ball_is_stopped,
        what_begins_half_below_is_pushed_up,
        rays_meet_a_surface_where_it_is,
        shapes_meet_a_surface_whether_or_not_something_is_near,
        contacts_and_events_name_the_surface_once,
        a_thin_wall_is_met_where_it_is_from_both_sides,
        any_order_and_a_copy_give_the_same_bits,
        a_surface_that_is_removed_lets_its_load_fall,
        a_step_knows_only_what_is_near,
        a_sleeper_goes_on_touching_what_it_lies_on,
        a_surface_is_drawn_as_it_was_given,
        a_surface_meets_only_what_its_mask_says,
        a_bad_surface_is_refused_in_a_sentence,
        cloth_beside_a_terrain_goes_on_with_the_same_bits,
        without_memory_there_is_no_surface,
        pieces_that_found_no_memory_come_later,
        a_triangle_without_an_area_is_left_out,
        a_surface_stays_where_it_is,
        NULL
    };
    return suite_run((suite){ .name = "terrain", .tests = tests, .seconds = 60 });
}
