// check_islands.c - does each island take its own substeps, and nothing else?  And
// does it matter how fast it moves with all that it touches?  Book: chapter 18.
//
// Through tumble.h: a heavy box on a light one asks for ten times as many
// substeps as a box that falls beside them.

#include "tumble.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static tumble_world *with_floor(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ck_assert_ptr_nonnull(w);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    return w;
}

static tumble_body add_cube(tumble_world *w, double mass, double x, double y)
{
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), mass);
    return tumble_body_add(w, s, tumble_body_at(x, y, 0));
}

static tumble_body add_spinning_cube(tumble_world *w)
{
    tumble_body_options o = tumble_body_at(0, 2, 0);
    o.velocity = tumble_v(1, 0, 0.3);
    o.spin = tumble_v(2, 1, 3);
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), o);
}

// 1,000 kg on 1 kg.
static tumble_body add_hard_pair(tumble_world *w, tumble_body *light)
{
    tumble_body below = add_cube(w, 1, 10, 0.5);
    if (light) *light = below;
    return add_cube(w, 1000, 10, 1.5);
}

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static double apart(tumble_vec3 a, tumble_vec3 b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

// Rejects: one number of substeps for all; a frame that takes its contacts or its
// velocities from the substeps of another island.
START_TEST(box_beside_a_hard_pair_goes_as_it_goes_alone)
{
    tumble_world *w[2] = { with_floor(), with_floor() };
    tumble_body box[2];
    int most = 0;
    for (int i = 0; i < 2; i++) box[i] = add_spinning_cube(w[i]);
    add_hard_pair(w[1], NULL);
    for (int k = 0; k < 120; k++) {
        for (int i = 0; i < 2; i++) tumble_world_step(w[i]);
        tumble_pose a = tumble_body_pose(w[0], box[0]);
        tumble_pose b = tumble_body_pose(w[1], box[1]);
        ck_assert_msg(memcmp(&a, &b, sizeof a) == 0, "frame %d", k);
        tumble_vec3 u = tumble_body_velocity(w[0], box[0]);
        tumble_vec3 v = tumble_body_velocity(w[1], box[1]);
        ck_assert(memcmp(&u, &v, sizeof u) == 0);
        ck_assert_int_le(tumble_world_last_step(w[0]).substeps, 6);
        int substeps = tumble_world_last_step(w[1]).substeps;
        most = substeps > most ? substeps : most;
    }
    ck_assert_int_gt(most, 24);
    for (int i = 0; i < 2; i++) tumble_world_free(w[i]);
}
END_TEST

static tumble_body add_jaw(tumble_world *w, double x, double speed)
{
    tumble_body_options o = tumble_body_at(x, 0.5, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.velocity = tumble_v(speed, 0, 0);
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 3), 1), o);
}

// Two jaws close on two cubes, to so many of their lengths, and stop.
// Rejects: substeps for a force that shorter ones make larger.
START_TEST(jam_asks_for_no_more_substeps_than_its_weight)
{
    static const double length[] = { 1.98, 1.9 };
    for (int k = 0; k < 2; k++) {
        tumble_world *w = with_floor();
        add_cube(w, 1, -0.5, 0.5);
        add_cube(w, 1, 0.5, 0.5);
        double way = 0.3 + (2 - length[k]) / 2;
        tumble_body left = add_jaw(w, -1.8, way), right = add_jaw(w, 1.8, -way);
        for (int i = 0; i < 60; i++) tumble_world_step(w);
        tumble_body_set_velocity(w, left, tumble_v(0, 0, 0), tumble_v(0, 0, 0));
        tumble_body_set_velocity(w, right, tumble_v(0, 0, 0), tumble_v(0, 0, 0));
        int most = 0;
        for (int i = 0; i < 180; i++) {
            tumble_world_step(w);
            int substeps = tumble_world_last_step(w).substeps;
            most = substeps > most ? substeps : most;
        }
        ck_assert_msg(most <= 8, "closed to %g m: %d substeps", length[k], most);
        tumble_world_free(w);
    }
}
END_TEST

// N: all that pushes b from below.
static double load_on(const tumble_world *w, tumble_body b)
{
    tumble_contact c[16];
    int n = tumble_world_contacts(w, c, 16);
    double sum = 0;
    for (int k = 0; k < n; k++)
        for (int i = 0; i < c[k].points; i++) {
            bool is_a = memcmp(&c[k].a, &b, sizeof b) == 0;
            bool is_b = memcmp(&c[k].b, &b, sizeof b) == 0;
            double up = (is_a - is_b) * c[k].normal.y;
            sum += up > 0 ? up * c[k].force[i] : 0;
        }
    return sum;
}

// m, by which a cube of this side (m) sinks that bears a thousand times its weight,
// over its side.
static double sag(double side)
{
    tumble_world *w = with_floor();
    tumble_vec3 sides = tumble_v(side, side, side);
    tumble_body_add(w, tumble_shape_box(w, sides, 1),
                    tumble_body_at(0, 0.5 * side, 0));
    tumble_body heavy = tumble_body_add(w, tumble_shape_box(w, sides, 1000),
                                        tumble_body_at(0, 1.5 * side, 0));
    for (int k = 0; k < 120; k++) tumble_world_step(w);
    double at = tumble_body_position(w, heavy).y;
    tumble_world_free(w);
    return 1.5 - at / side;
}

// Shorter substeps, as the load asks for, make springs stiffer, for small bodies too.
// Rejects: springs that are no stiffer than 1000 Hz: 0.0031.
START_TEST(cube_of_a_decimetre_bears_its_load_as_one_of_a_metre)
{
    near(sag(0.1), sag(1), 2e-4);
}
END_TEST

// Rejects: impulses that are divided by another island's substep.
START_TEST(contacts_of_both_carry_their_weight)
{
    tumble_options o = tumble_options_default();
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body light = add_cube(w, 2, 0, 0.5), heavy = add_hard_pair(w, NULL);
    for (int k = 0; k < 60; k++) tumble_world_step(w);
    ck_assert_int_gt(tumble_world_last_step(w).substeps, 24);
    near(load_on(w, light), 2 * 9.81, 0.01);
    near(load_on(w, heavy), 1000 * 9.81, 5);
    tumble_world_free(w);
}
END_TEST

// 1,000 kg on so many cubes of 1 kg in a square: the substeps of a frame, at rest.
static int substeps_on(int legs)
{
    tumble_options o = tumble_options_default();
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape leg = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_shape slab = tumble_shape_box(w, tumble_v(4, 1, 4), 1000);
    for (int k = 0; k < legs; k++)
        tumble_body_add(w, leg,
                        tumble_body_at(legs == 1 ? 0 : k % 2 ? 1 : -1, 0.5,
                                       legs == 1 ? 0 : k / 2 ? 1 : -1));
    tumble_body_add(w, slab, tumble_body_at(0, 1.5, 0));
    for (int k = 0; k < 60; k++) tumble_world_step(w);
    int substeps = tumble_world_last_step(w).substeps;
    tumble_world_free(w);
    return substeps;
}

// A ball that flies to and fro between two walls, by ten of its radii in a frame.
static void add_bullet(tumble_world *w)
{
    tumble_shape wall = tumble_shape_box(w, tumble_v(1, 20, 20), 1);
    for (int side = -1; side < 2; side += 2) {
        tumble_body_options o = tumble_body_at(100 + 2 * side, 10, 0);
        o.kind = TUMBLE_STATIC;
        o.friction = 0;
        tumble_body_add(w, wall, o);
    }
    tumble_body_options o = tumble_body_at(100, 0.1, 0);
    o.velocity = tumble_v(60, 0, 0);
    o.friction = 0;
    o.restitution = 1;
    tumble_body_add(w, tumble_shape_sphere(w, 0.1, 0.1), o);
}

// Where a bullet strikes the frame is divided.  A tower beside it must not feel that:
// it takes its own substeps in the parts, and falls asleep.
// Rejects: parts in which all take the substeps of what is fast, so that a tower sags
// less in each of them, sways, and never rests.
START_TEST(tower_falls_asleep_beside_a_bullet)
{
    tumble_world *w = with_floor();
    tumble_body top = { 0 };
    for (int k = 0; k < 10; k++) top = add_cube(w, 1, 0, k + 0.5);
    add_bullet(w);
    for (int k = 0; k < 120; k++) tumble_world_step(w);
    ck_assert(!tumble_body_is_awake(w, top));
    tumble_world_free(w);
}
END_TEST

// Each of four bears a quarter, and the substeps go with the root of that.
// Rejects: contacts each of which is said to bear the whole body.
START_TEST(what_four_bear_asks_for_half_of_what_one_asks_for)
{
    int one = substeps_on(1), four = substeps_on(4);
    ck_assert_int_gt(one, 24);
    ck_assert_int_ge(2 * four, one - 2);
    ck_assert_int_le(2 * four, one + 4);
}
END_TEST

// A rod turns at 40 rad/s about a joint in its middle, whose two halves ask for
// many substeps, and flies at a cube.
// Rejects: momentum that is lost where velocities of two substeps meet.
START_TEST(islands_that_meet_keep_their_momentum)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    tumble_shape half = tumble_shape_box(w, tumble_v(0.5, 0.1, 0.1), 1);
    tumble_body part[2];
    for (int i = 0; i < 2; i++) {
        double x = i ? 0.25 : -0.25;
        tumble_body_options p = tumble_body_at(x, 0, 0);
        p.spin = tumble_v(0, 0, 40);
        p.velocity = tumble_v(3, 40 * x, 0);
        part[i] = tumble_body_add(w, half, p);
    }
    tumble_joint_ball(w, part[0], part[1], tumble_v(0, 0, 0));
    tumble_shape cube = tumble_shape_box(w, tumble_v(1, 1, 1), 5);
    tumble_body hit = tumble_body_add(w, cube, tumble_body_at(3, 0.3, 0));
    tumble_vec3 before = tumble_world_measure(w).momentum;
    int most = 0;
    for (int k = 0; k < 90; k++) {
        tumble_world_step(w);
        int substeps = tumble_world_last_step(w).substeps;
        most = substeps > most ? substeps : most;
        near(apart(tumble_world_measure(w).momentum, before), 0, 1e-11);
    }
    ck_assert_double_gt(tumble_body_velocity(w, hit).x, 0.1);
    ck_assert_int_gt(most, 6);
    tumble_world_free(w);
}
END_TEST

// Rejects: a state without the ages of the islands.
START_TEST(saved_world_goes_on_with_the_same_bits)
{
    tumble_world *w = with_floor();
    add_cube(w, 1, 0, 0.9);
    add_hard_pair(w, NULL);
    for (int k = 0; k < 7; k++) tumble_world_step(w);
    size_t size = tumble_world_save(w, NULL, 0);
    void *bytes = malloc(size);
    ck_assert_ptr_nonnull(bytes);
    ck_assert_uint_eq(tumble_world_save(w, bytes, size), size);
    tumble_world *again = tumble_world_load(bytes, size);
    ck_assert_ptr_nonnull(again);
    for (int k = 0; k < 30; k++) {
        tumble_world_step(w);
        tumble_world_step(again);
        ck_assert(tumble_world_hash(w) == tumble_world_hash(again));
    }
    free(bytes);
    tumble_world_free(w);
    tumble_world_free(again);
}
END_TEST

// One of a hard pair is taken away.
// Rejects: a number of substeps that outlives what asked for it, or is dropped at
// once, or that only one body of an island remembers: each change moves what rests.
START_TEST(island_lets_go_after_half_a_second)
{
    for (int i = 0; i < 2; i++) {
        tumble_world *w = with_floor();
        tumble_body body[2];
        body[1] = add_hard_pair(w, &body[0]);
        for (int k = 0; k < 20; k++) tumble_world_step(w);
        tumble_body_remove(w, body[i]);
        tumble_world_step(w);
        ck_assert_int_gt(tumble_world_last_step(w).substeps, 24);
        for (int k = 0; k < 31; k++) tumble_world_step(w);
        ck_assert_int_le(tumble_world_last_step(w).substeps, 6);
        tumble_world_free(w);
    }
}
END_TEST

// A cloth of 30 x 30 hangs by a corner ten metres away.
// Rejects: substeps of cloth that everybody takes.
START_TEST(box_beside_a_cloth_goes_as_it_goes_alone)
{
    tumble_world *w[2] = { with_floor(), with_floor() };
    tumble_body box[2];
    int most = 0;
    for (int i = 0; i < 2; i++) box[i] = add_cube(w[i], 1, 0, 2);
    tumble_shape s = tumble_shape_cloth(w[1], 30, 30, 1, 1, 0.2);
    tumble_body cloth = tumble_body_add(w[1], s, tumble_body_at(10, 3, 0));
    tumble_body_pin(w[1], cloth, 0);
    for (int k = 0; k < 120; k++) {
        for (int i = 0; i < 2; i++) tumble_world_step(w[i]);
        tumble_pose a = tumble_body_pose(w[0], box[0]);
        tumble_pose b = tumble_body_pose(w[1], box[1]);
        ck_assert_msg(memcmp(&a, &b, sizeof a) == 0, "frame %d", k);
        int substeps = tumble_world_last_step(w[1]).substeps;
        most = substeps > most ? substeps : most;
    }
    ck_assert_int_gt(most, 7);
    for (int i = 0; i < 2; i++) tumble_world_free(w[i]);
}
END_TEST

// --- What is driven ----------------------------------------------------------
static tumble_body add_platform(tumble_world *w, tumble_vec3 velocity)
{
    tumble_body_options o = tumble_body_at(0, -0.5, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.velocity = velocity;
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(60, 1, 60), 1), o);
}

static double pose_apart(const tumble_world *v, tumble_body a,
                         const tumble_world *w, tumble_body b)
{
    return apart(tumble_body_position(v, a), tumble_body_position(w, b));
}

// Both stand on one platform, which is placed anew when it has left its margin for
// either: where it is seen from is rounded otherwise then.  A cube that lies takes
// that over, a ton on a kilogram that rings makes more of it.
// Rejects: islands that are one because something driven touches both; a platform
// that goes on with the substeps of one of them only, or from where another island
// has left it.
START_TEST(box_on_the_platform_of_a_hard_pair_goes_as_it_goes_alone)
{
    // An impact asks for as many substeps as a hard pair, and shares them.
    enum { BOX = 1, PAIR = 2, BOTH = 3, LANDS = 25 };
    const double rounded = 1e-12, rings = 1e-4;     // m
    tumble_world *w[BOTH + 1];
    tumble_body box[BOTH + 1], light[BOTH + 1];
    int most = 0;
    for (int i = BOX; i <= BOTH; i++) {
        w[i] = tumble_world_make(NULL);
        add_platform(w[i], tumble_v(0.5 + 0.01 * _i, 0.25 + 0.005 * _i, 0));
        if (i & BOX)  box[i] = add_spinning_cube(w[i]);
        if (i & PAIR) add_hard_pair(w[i], &light[i]);
    }
    for (int k = 0; k < 300; k++) {
        for (int i = BOX; i <= BOTH; i++) tumble_world_step(w[i]);
        double off = pose_apart(w[BOX], box[BOX], w[BOTH], box[BOTH]);
        ck_assert_msg(off < rounded, "frame %d: %g m", k, off);
        off = pose_apart(w[PAIR], light[PAIR], w[BOTH], light[BOTH]);
        ck_assert_msg(k >= LANDS || off < rings, "frame %d: %g m", k, off);
        int substeps = tumble_world_last_step(w[BOTH]).substeps;
        most = substeps > most ? substeps : most;
    }
    ck_assert_int_gt(most, 20);
    for (int i = BOX; i <= BOTH; i++) tumble_world_free(w[i]);
}
END_TEST

enum { RIDERS = 3 };

// A box that slides, a ball that rolls and slides, and a box that falls on a corner.
static void ride(tumble_vec3 going, int frames, tumble_vec3 out[RIDERS])
{
    tumble_options bounces = tumble_options_default();
    bounces.restitution = 0.25;
    tumble_world *w = tumble_world_make(&bounces);
    tumble_body rider[RIDERS];
    add_platform(w, going);
    for (int i = 0; i < RIDERS; i++) {
        tumble_body_options o = tumble_body_at(2 * i, 0.25, 3 * i);
        o.velocity = tumble_v(going.x + 4, going.y, going.z + 0.5);
        tumble_shape s = i == 1 ? tumble_shape_sphere(w, 0.25, 10)
                                : tumble_shape_box(w, tumble_v(1, 0.5, 1), 10);
        if (i == 2) o.pose.position.y = 1;
        if (i == 2) o.pose.rotation = tumble_quat_turn(tumble_v(1, 2, 3), 1);
        rider[i] = tumble_body_add(w, s, o);
    }
    for (int k = 0; k < frames; k++) tumble_world_step(w);
    for (int i = 0; i < RIDERS; i++) {
        tumble_vec3 x = tumble_body_position(w, rider[i]);
        double time = frames / 60.0;
        out[i] = tumble_v(x.x - time * going.x, x.y - time * going.y,
                          x.z - time * going.z);
    }
    tumble_world_free(w);
}

// Seen from a train all goes as it does at the station, to rounding, while it slides.
// Rejects: a driven body that is one of two that make way, or that lies.
START_TEST(what_slides_in_a_train_slides_as_at_the_station)
{
    tumble_vec3 still[RIDERS], going[RIDERS];
    enum { FRAMES = 25 };
    ride(tumble_v(0, 0, 0), FRAMES, still);
    for (double speed = 0.01; speed < 200; speed *= 20) {
        ride(tumble_v(speed, speed / 2, -speed), FRAMES, going);
        for (int i = 0; i < RIDERS; i++)
            ck_assert_msg(apart(still[i], going[i]) < 1e-9, "%g m/s: %g m", speed,
                          apart(still[i], going[i]));
    }
}
END_TEST

// The substeps of the first and the second frame of a cube that is set down on a
// slope of that angle, and how far down it has come (m) after so many frames.
static double slide_down(double side, double angle, int frames, int substeps[2])
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_vec3 n = tumble_v(-sin(angle), cos(angle), 0);
    tumble_plane_add(w, n, 0, -1);
    tumble_body_options o = tumble_body_at(n.x * side / 2, n.y * side / 2, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), angle);
    tumble_shape s = tumble_shape_box(w, tumble_v(side, side, side), 1);
    tumble_body b = tumble_body_add(w, s, o);
    for (int k = 0; k < frames; k++) {
        tumble_world_step(w);
        if (k < 2) substeps[k] = tumble_world_last_step(w).substeps;
    }
    double way = apart(tumble_body_position(w, b), o.pose.position);
    tumble_world_free(w);
    return way;
}

// Small cubes need more substeps than are usual to bear their own weight, and have
// them before they have borne it.  So they start to slide as they go on.
// Rejects: a first frame that takes the usual number, for nothing has pushed yet.
START_TEST(what_is_set_down_has_its_substeps_in_the_first_frame)
{
    int substeps[2];
    double friction = atan(0.5), angle = 1.02 * friction;
    double pull = 9.81 * (sin(angle) - 0.5 * cos(angle));
    for (double side = 0.005; side < 0.03; side *= 2) {
        double way = slide_down(side, angle, 120, substeps);
        ck_assert_int_ge(substeps[0], 8);
        ck_assert_int_ge(substeps[0] + 1, substeps[1]);
        near(way / (pull * 2 * 2 / 2), 1, 0.07);
    }
    slide_down(0.3, angle, 2, substeps);
    ck_assert_int_eq(substeps[0], 4);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        box_beside_a_hard_pair_goes_as_it_goes_alone,
        jam_asks_for_no_more_substeps_than_its_weight,
        cube_of_a_decimetre_bears_its_load_as_one_of_a_metre,
        contacts_of_both_carry_their_weight,
        tower_falls_asleep_beside_a_bullet,
        what_four_bear_asks_for_half_of_what_one_asks_for,
        islands_that_meet_keep_their_momentum,
        saved_world_goes_on_with_the_same_bits,
        island_lets_go_after_half_a_second,
        what_is_set_down_has_its_substeps_in_the_first_frame,
        box_beside_a_cloth_goes_as_it_goes_alone,
        what_slides_in_a_train_slides_as_at_the_station,
        NULL
    };
    return suite_run((suite){
        .name = "islands", .tests = tests, .seconds = 20,
        .repeated = {
            { box_on_the_platform_of_a_hard_pair_goes_as_it_goes_alone, 0, 11 }
        }
    });
}
