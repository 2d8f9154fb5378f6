//> crane
// crane.c - a crane lifts 500 kg, turns, and puts them down; 700 are too much.
#include "example.h"

#include <math.h>

static const double REACH = 5, HIGH = 8, SPEED = 0.5, PULL = 6000,  // m, m/s, N
    GRAVITY = 9.81, STRONG = 1e6;                           // m/s^2, N m
static tumble_body load, heavy;
static tumble_joint mast, rope, other;
static double drive, lifted;                                // N, m

// A winch pulls the two ends of a rope together.
static tumble_joint wind(tumble_world *w, tumble_body jib, tumble_body b)
{
    tumble_vec3 low = tumble_body_position(w, b),
                high = tumble_v(low.x, HIGH, 0);
    low.y += 0.5;
    tumble_joint r = tumble_joint_distance(w, jib, high, b, low, 0,
                                           HIGH - low.y);
    tumble_joint_set_motor(w, r, -SPEED, PULL);
    return r;
}

static void build(tumble_world *w)
{
    const tumble_vec3 cube = { 1, 1, 1 }, up = { 0, 1, 0 };
    tumble_plane_add(w, up, 0, -1);
    tumble_shape beam = tumble_shape_box(w, tumble_v(2 * REACH, 0.4, 0.4),
                                         1000);
    tumble_body jib = tumble_body_add(w, beam, tumble_body_at(0, HIGH, 0));
    load = tumble_body_add(w, tumble_shape_box(w, cube, 500),
                           tumble_body_at(REACH, 0.5, 0));
    heavy = tumble_body_add(w, tumble_shape_box(w, cube, 700),
                            tumble_body_at(-REACH, 0.5, 0));
    mast = tumble_joint_hinge(w, tumble_body_ground(), jib,
                              tumble_v(0, HIGH, 0), up);
    tumble_joint_set_motor(w, mast, 0, STRONG);
    rope = wind(w, jib, load);
    other = wind(w, jib, heavy);
}

// The winch pulls for eight seconds; then its brake holds, and the jib turns.
// At the end the rope is let out, and is slack when the load stands.
static void act(tumble_world *w)
{
    double t = tumble_world_time(w), length = tumble_joint_place(w, rope);
    if (fabs(t - 8) < 0.001) {
        drive = -tumble_joint_drive(w, rope);
        lifted = tumble_body_position(w, load).y - 0.5;
        tumble_joint_set_motor(w, rope, 0, 0);
        tumble_joint_set_limits(w, rope, 0, length);
        tumble_joint_remove(w, other);
        tumble_joint_set_motor(w, mast, 0.1, STRONG);
    }
    if (fabs(t - 24) < 0.001) tumble_joint_set_motor(w, mast, 0, STRONG);
    if (t > 25) tumble_joint_set_limits(w, rope, 0, length + SPEED / 60);
}

static int laws(tumble_world *w, example_law *is)
{
    double gain = PULL / 500 - GRAVITY;                     // m/s^2, at first
    is[0] = example_is("pull of the winch, m g (N)", 500 * GRAVITY, drive);
    is[1] = example_is("lifted, v t - v^2 / 2 a (m)",
                       8 * SPEED - SPEED * SPEED / (2 * gain), lifted);
    is[2] = example_is("centre of the load, put down (m)", 0.5,
                       tumble_body_position(w, load).y);
    is[3] = example_is("centre of what is too heavy (m)", 0.5,
                       tumble_body_position(w, heavy).y);
    return 4;
}

const example crane = {
    .name = "crane", .about = "lifts, turns and puts down", .seconds = 40,
    .has_floor = true, .eye = { 10, 6, 14 }, .target = { 0, 4, 0 },
    .build = build, .act = act,
    .claim = "it lifts what it can, and bears what it lifts, to 0.1 %",
    .laws = laws, .most = 1e-3 };
//<
