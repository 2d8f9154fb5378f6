// check_bounds.c - what no frame may do, however hard its contacts are: make
// energy, let something through, or move what touches nothing.
// Book: chapter 18.
//
// Scenes with targets, through tumble.h: whatever keeps these laws may change.

#include "tumble.h"
#include "suite.h"

#include <check.h>
#include <math.h>

#define COUNT(array) (int)(sizeof(array) / sizeof *(array))

static const double RADIUS = 0.05;      // m, of the bullet

static tumble_world *weightless(void)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    ck_assert_ptr_nonnull(w);
    return w;
}

static tumble_body thrown(tumble_world *w, tumble_shape s, tumble_vec3 at,
                          tumble_vec3 velocity)
{
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.velocity = velocity;
    tumble_body b = tumble_body_add(w, s, o);
    ck_assert(tumble_body_exists(w, b));
    return b;
}

static tumble_body kept(tumble_world *w, tumble_shape s, tumble_vec3 at,
                        tumble_kind kind)
{
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.kind = kind;
    tumble_body b = tumble_body_add(w, s, o);
    ck_assert(tumble_body_exists(w, b));
    return b;
}

static double speed(const tumble_world *w, tumble_body b)
{
    tumble_vec3 v = tumble_body_velocity(w, b);
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// --- Energy ------------------------------------------------------------------

static double chance(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 4294967296.0 * 2 - 1;
}

static tumble_vec3 any_way(unsigned *seed, double most)
{
    double x = chance(seed), y = chance(seed), z = chance(seed);
    return tumble_v(most * x, most * y, most * z);
}

static double kinetic(const tumble_world *w)
{
    return tumble_world_measure(w).kinetic;
}

// Boxes of restitution 1 between six walls without gravity or friction, at so many
// sides a second: whatever they strike, turn and pass on, their energy stays.
// Rejects: a box of three moments that an impact puts elsewhere with the energy
// that it has there; what passes others, put back with the spin of a needle.
static double energy_changes(int boxes, tumble_vec3 sides, double speed, double dt)
{
    unsigned seed = 7u * (unsigned)boxes;
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    o.dt = dt;
    o.friction = 0;
    o.restitution = 1;
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    for (int k = 0; k < 6; k++) {
        double d = k % 2 ? 1 : -1;
        tumble_plane_add(w, tumble_v(k / 2 == 0 ? d : 0, k / 2 == 1 ? d : 0,
                                     k / 2 == 2 ? d : 0), -7, -1);
    }
    tumble_shape s = tumble_shape_box(w, sides, 1000);
    for (int i = 0; i < boxes; i++) {
        tumble_body_options b = tumble_body_at(4 * (i % 3) - 4, 3 * (i / 9 % 5) - 6,
                                               4 * (i / 3 % 3) - 4);
        b.velocity = any_way(&seed, speed);
        b.spin = any_way(&seed, speed);
        tumble_body_add(w, s, b);
    }
    double began = kinetic(w), worst = 0;
    for (double time = 0; time < 10; time += dt) {
        tumble_world_step(w);
        worst = fmax(worst, fabs(kinetic(w) / began - 1));
    }
    tumble_world_free(w);
    return worst;
}

START_TEST(boxes_that_bounce_keep_their_energy)
{
    const tumble_vec3 sides[] = { { 1, 1, 1 }, { 1, 0.5, 2 }, { 1.5, 0.3, 1.5 } };
    const int boxes[] = { 1, 2, 9, 40 };
    for (int n = 0; n < COUNT(boxes); n++)
        for (int k = 0; k < COUNT(sides); k++) {
            double dt = k % 2 ? 1 / 120.0 : 1 / 60.0;
            double worst = energy_changes(boxes[n], sides[k], 3 + 2 * k, dt);
            ck_assert_msg(worst <= 1e-3, "%d boxes, shape %d: %g", boxes[n], k,
                          worst);
        }
}
END_TEST

// Needles that spin past each other are put back: what that takes is lost.
START_TEST(needles_that_pass_each_other_gain_no_energy)
{
    double worst = energy_changes(18, tumble_v(0.3, 0.3, 2), 30, 1 / 60.0);
    ck_assert_msg(worst < 1, "%g", worst);
}
END_TEST

// An elastic cord of 1 m, nailed at one end and drawn out to 1.1 m, has stored
// (0.1 m)^2 / (2 c), 0.5 J for c = 0.01 m/N.  It draws a box of 1 kg, which
// then flies through the nail at no more than sqrt(2 * 0.5) = 1 m/s.
// Rejects: a frame that gives more than was stored, and one that loses it.
START_TEST(a_drawn_cord_gives_back_no_more_than_it_has_stored)
{
    const double compliance[] = { 0.1, 0.01, 0.001 };
    for (int k = 0; k < COUNT(compliance); k++) {
        tumble_world *w = weightless();
        tumble_body cord = tumble_body_add(w, tumble_shape_rope(w, 1, 1, 1e-3),
                                           tumble_body_at(0, 0, 0));
        ck_assert(tumble_body_set_stretch(w, cord, compliance[k]));
        ck_assert(tumble_body_pin(w, cord, 0));
        tumble_vec3 end = tumble_body_vertex(w, cord, 1);
        tumble_vec3 nail = tumble_body_vertex(w, cord, 0);
        tumble_shape box = tumble_shape_box(w, tumble_v(0.1, 0.1, 0.1), 1);
        tumble_body b = thrown(w, box, end, tumble_v(0, 0, 0));
        tumble_joint hook = tumble_joint_hang(w, cord, 1, b);
        ck_assert(tumble_joint_exists(w, hook));
        // Away from the nail, until the cord has stored 0.125 / c (J) of it.
        double away = end.x > nail.x ? 1 : -1;
        double start = 0.5 / sqrt(compliance[k]);
        tumble_body_push(w, b, tumble_v(away * start, 0, 0), end);
        double most = 0;
        for (int f = 0; f < 240; f++) {
            tumble_world_step(w);
            most = fmax(most, speed(w, b));
        }
        ck_assert_msg(most <= 1.01 * start, "c %g: %g of %g m/s", compliance[k],
                      most, start);
        // It comes back: the cord has not eaten it.
        ck_assert_msg(most >= 0.9 * start, "c %g: %g", compliance[k], most);
        tumble_world_free(w);
    }
}
END_TEST

// Two boxes fly past each other, far from a pile of needles that are driven
// into each other.
// Rejects: a brake that acts on bodies which touch nothing.
START_TEST(what_touches_nothing_keeps_its_velocity_beside_a_crash)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    o.friction = 1000;
    tumble_world *w = tumble_world_make(&o);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body far = thrown(w, box, tumble_v(1000, 0, 0), tumble_v(10, 0, 0));
    for (int k = 0; k < 8; k++)
        thrown(w, box, tumble_v(1.1 * k, 0.3 * k, 0),
               tumble_v(20 * (3.5 - k), 0, 0));
    for (int f = 0; f < 120; f++) {
        tumble_world_step(w);
        double now = tumble_body_velocity(w, far).x;
        ck_assert_msg(fabs(now - 10) < 1e-9, "frame %d: %.17g m/s", f, now);
    }
    tumble_world_free(w);
}
END_TEST

// A brick that is thrown about between six planes, without gravity and without
// restitution, never has more than at its start.
// Rejects: impulses along the rows of a frame's start that feed on themselves.
START_TEST(a_room_without_gravity_makes_no_energy)
{
    const double fast[] = { 0.1, 3, 100, 3000 };
    for (int k = 0; k < COUNT(fast); k++) {
        tumble_world *w = weightless();
        for (int i = 0; i < 6; i++) {
            double s = i % 2 ? -1 : 1;
            tumble_plane_add(w, tumble_v(s * (i / 2 == 0), s * (i / 2 == 1),
                                         s * (i / 2 == 2)), -0.4, -1);
        }
        tumble_shape brick = tumble_shape_box(w, tumble_v(0.1, 0.2, 0.4), 1);
        tumble_body b = thrown(w, brick, tumble_v(0, 0, 0),
                               tumble_v(fast[k], -2 * fast[k], 3 * fast[k]));
        double before = tumble_world_measure(w).kinetic;
        for (int f = 0; f < 200; f++) {
            tumble_world_step(w);
            double now = tumble_world_measure(w).kinetic;
            ck_assert_msg(now <= before * (1 + 1e-9), "%g m/s, frame %d: %g of "
                          "%g J", fast[k], f, now, before);
            tumble_vec3 x = tumble_body_position(w, b);
            double far = fmax(fabs(x.x), fmax(fabs(x.y), fabs(x.z)));
            ck_assert_msg(far <= 0.4 + 1e-9, "%g m/s: at %g m", fast[k], far);
        }
        tumble_world_free(w);
    }
}
END_TEST

// --- What goes through nothing -----------------------------------------------

// A plate comes up from below at a bullet before its middle, which is nailed or
// lies loose: it is stopped, or takes the bullet along, and both keep their
// momentum.
// Rejects: a plate that is asked where it stood when the frame began.
START_TEST(a_plate_that_moves_goes_through_nothing_that_stands)
{
    const struct { double fast; tumble_kind kind; } c[] = {
        { 1, TUMBLE_STATIC }, { 18, TUMBLE_STATIC }, { 1, TUMBLE_DYNAMIC },
        { 18, TUMBLE_DYNAMIC }, { 300, TUMBLE_DYNAMIC },
        { 3000, TUMBLE_DYNAMIC }
    };
    for (int k = 0; k < COUNT(c); k++) {
        double v = c[k].fast;
        tumble_world *w = weightless();
        tumble_shape plate = tumble_shape_box(w, tumble_v(1, 0.01, 1), 1);
        tumble_shape bullet = tumble_shape_icosahedron(w, RADIUS, 0.05);
        tumble_body up = thrown(w, plate, tumble_v(0, -0.3, 0),
                                tumble_v(0, v, 0));
        tumble_body b = kept(w, bullet, tumble_v(0, 0, 0), c[k].kind);
        for (int f = 0; f < 20; f++) {
            tumble_world_step(w);
            double over = tumble_body_position(w, b).y
                - tumble_body_position(w, up).y;
            ck_assert_msg(over > 0, "case %d, frame %d: %g m", k, f, over);
        }
        double left = tumble_body_velocity(w, up).y;
        if (c[k].kind == TUMBLE_STATIC) {
            ck_assert(fabs(left) < 0.01 * v);
        } else {
            double sum = left + 0.05 * tumble_body_velocity(w, b).y;
            ck_assert(fabs(sum - v) < 1e-9 * v);
        }
        tumble_world_free(w);
    }
}
END_TEST

// A box in the air is struck down by five times its mass, at 20 to 400 m/s: in the
// frame of the blow it would come to the ground, of which nothing was asked when
// the frame began.
// Rejects: a step without guard_walls (26 of these centres come below).
START_TEST(what_is_struck_down_stays_above_the_ground)
{
    for (int k = 0; k < 300; k++) {
        double high = 0.2 + 0.003 * k, v = 20 * exp(0.01 * k);
        tumble_world *w = tumble_world_make(NULL);
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        tumble_shape cube = tumble_shape_box(w, tumble_v(0.2, 0.2, 0.2), 1);
        tumble_shape bullet = k % 2 ? tumble_shape_sphere(w, RADIUS, 5)
                                    : tumble_shape_icosahedron(w, RADIUS, 5);
        double above = high + 0.161 + v / 120 + 0.0007 * (k % 7);
        tumble_body b[2] = {
            thrown(w, cube, tumble_v(0, high, 0), tumble_v(0, 0, 0)),
            thrown(w, bullet, tumble_v(0.01, above, 0.02), tumble_v(0, -v, 0)) };
        for (int f = 0; f < 20; f++) {
            tumble_world_step(w);
            for (int i = 0; i < 2; i++)
                // (A centre stops on the plane itself, to rounding.)
                ck_assert_msg(tumble_body_position(w, b[i]).y >= -1e-12,
                              "%d: body %d in frame %d: %g m", k, i, f,
                              tumble_body_position(w, b[i]).y);
        }
        tumble_world_free(w);
    }
}
END_TEST

// A bullet that overlaps a plate by a third of its radius is put out of it, and
// not thrown.
// Rejects: an overlap that becomes a speed.
START_TEST(an_overlap_of_the_start_is_not_thrown_out)
{
    for (int k = 0; k < 3; k++) {
        tumble_world *w = weightless();
        tumble_shape plate = tumble_shape_box(w, tumble_v(1, 0.01, 1), 1);
        tumble_shape bullet = tumble_shape_icosahedron(w, RADIUS, 0.05);
        kept(w, plate, tumble_v(0, 0, 0), TUMBLE_STATIC);
        double start = 0.005 + 0.04 - 0.006 * k;
        tumble_body b = thrown(w, bullet, tumble_v(0.1, start, 0),
                               tumble_v(0, 0, 0));
        for (int f = 0; f < 120; f++) tumble_world_step(w);
        double high = tumble_body_position(w, b).y, v = speed(w, b);
        ck_assert_msg(v < 0.01 && high < 2 * RADIUS, "%d: at %g m, %g m/s", k,
                      high, v);
        tumble_world_free(w);
    }
}
END_TEST

// A prism of three sides, its edge along z at x = 0, and a bullet that flies
// down past the edge, or into the side, at 100 m/s.
// Rejects: a line through the planes of two sides taken for one through the
// body; a bullet that comes out at the other side.
START_TEST(what_passes_an_edge_is_not_stopped_and_what_meets_a_side_is)
{
    for (int k = 0; k < 40; k++) {
        bool passes = k % 2 == 0;
        double rise = 0.1 + 0.01 * k;
        tumble_vec3 at[6], middle = { 0, 0, 0 };
        for (int i = 0; i < 6; i++)
            at[i] = tumble_v(i < 2 ? 0 : -1, i < 2 ? 0 : i < 4 ? rise : -rise,
                             i % 2 - 0.5);
        tumble_world *w = weightless();
        tumble_shape prism = tumble_shape_hull(w, at, 6, 5);
        tumble_shape bullet = tumble_shape_icosahedron(w, RADIUS, 0.05);
        // The centre of mass of a prism is two thirds of the way to its back.
        middle.x = -2.0 / 3;
        kept(w, prism, middle, TUMBLE_STATIC);
        double x = passes ? 0.06 : -0.5, y = 0.8;
        tumble_body b = thrown(w, bullet, tumble_v(x, y, 0.1),
                               tumble_v(0, -100, 0));
        for (int f = 0; f < 4; f++) tumble_world_step(w);
        tumble_vec3 v = tumble_body_velocity(w, b),
                    p = tumble_body_position(w, b);
        if (passes) ck_assert(v.x == 0 && fabs(v.y + 100) < 1e-9);
        else        ck_assert_msg(v.y > -100 && (p.y > 0 || p.x > 0.04
                                                 || p.x < -1.04),
                                  "%d: at (%g, %g)", k, p.x, p.y);
        tumble_world_free(w);
    }
}
END_TEST

static tumble_shape coin(tumble_world *w)
{
    enum { CORNERS = 12 };
    tumble_vec3 at[2 * CORNERS];
    for (int i = 0; i < 2 * CORNERS; i++) {
        double angle = 2 * 3.14159265358979324 * (i % CORNERS + 0.5) / CORNERS;
        at[i] = tumble_v(5 * cos(angle), i < CORNERS ? -1.25 : 1.25,
                         5 * sin(angle));
    }
    return tumble_shape_hull(w, at, 2 * CORNERS, 1);
}

// Two coins of 10 m meet at 730 m/s, and what is left of one in the other is
// put back.  Rejects: a body that is put back beside its way as if its momentum
// had no moment (.66 of m v size).
START_TEST(what_is_put_back_keeps_its_angular_momentum)
{
    const tumble_vec3 at[] = {
        { 12.087394520230323, -3.6849655252226712, 1.5535093420234452 },
        { -13.979790954134769, -3.3017026944180747, 1.0859038150768958 } };
    const tumble_quat turned[] = {
        { 0.89801661607534911, -0.25374493305613899, -0.059710975377927591,
          -0.35442102875017339 },
        { 0.11345426970951253, 0.68353049052174752, 0.21530744879745625,
          0.68815470622826602 } };
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    o.friction = 0;
    o.restitution = 0.5;
    tumble_world *w = tumble_world_make(&o);
    for (int i = 0; i < 2; i++) {
        tumble_body_options b = tumble_body_at(at[i].x, at[i].y, at[i].z);
        b.pose.rotation = turned[i];
        b.velocity = tumble_v(i ? 364.964462 : -364.964462, 0, 0);
        tumble_body_add(w, coin(w), b);
    }
    tumble_vec3 was = tumble_world_measure(w).angular;
    for (int f = 0; f < 12; f++) tumble_world_step(w);
    tumble_vec3 is = tumble_world_measure(w).angular;
    double off = hypot(hypot(is.x - was.x, is.y - was.y), is.z - was.z);
    ck_assert_msg(off < 1e-9 * 365 * 10, "off by %g", off);
    tumble_world_free(w);
}
END_TEST

// A bat that goes its way at 3 m/s meets a ball at rest.  As the bat has it, the ball
// comes at 3 m/s and goes at e times that: so it leaves at (1 + e) 3 m/s.
// Rejects: a bound on energy that leaves out that what is driven may bounce.
START_TEST(ball_leaves_an_elastic_bat_at_twice_its_speed)
{
    const double most[] = { 0, 0.5, 1 };
    for (int k = 0; k < COUNT(most); k++) {
        tumble_world *w = weightless();
        tumble_shape s = tumble_shape_sphere(w, 0.5, 1);
        tumble_body ball = thrown(w, s, tumble_v(0, 0, 0), tumble_v(0, 0, 0));
        tumble_shape flat = tumble_shape_box(w, tumble_v(0.5, 2, 2), 1);
        tumble_body bat = kept(w, flat, tumble_v(-2, 0, 0), TUMBLE_KINEMATIC);
        ck_assert(tumble_body_set_material(w, ball, 0, most[k]));
        ck_assert(tumble_body_set_velocity(w, bat, tumble_v(3, 0, 0),
                                           tumble_v(0, 0, 0)));
        for (int f = 0; f < 60; f++) tumble_world_step(w);
        double v = tumble_body_velocity(w, ball).x, want = 3 * (1 + most[k]);
        ck_assert_msg(fabs(v - want) < 1e-6, "%g: %g m/s, not %g", most[k], v, want);
        tumble_world_free(w);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        boxes_that_bounce_keep_their_energy,
        needles_that_pass_each_other_gain_no_energy,
        a_drawn_cord_gives_back_no_more_than_it_has_stored,
        what_touches_nothing_keeps_its_velocity_beside_a_crash,
        a_room_without_gravity_makes_no_energy,
        a_plate_that_moves_goes_through_nothing_that_stands,
        what_is_struck_down_stays_above_the_ground,
        an_overlap_of_the_start_is_not_thrown_out,
        what_passes_an_edge_is_not_stopped_and_what_meets_a_side_is,
        what_is_put_back_keeps_its_angular_momentum,
        ball_leaves_an_elastic_bat_at_twice_its_speed,
        NULL
    };
    return suite_run((suite){ .name = "bounds", .tests = tests });
}
