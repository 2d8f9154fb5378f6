//> belt
// belt.c - a conveyor brings boxes to two grippers, of which one is too weak.
#include "example.h"

#include <math.h>

enum { LANES = 2, BOX = 2 };            // BOX: a group
static const double SPEED = 1, GRIP = 0.5, MASS = 10, GRAVITY = 9.81,
    HOLDS = 98.1;                       // N, m g / 2 mu: two fingers
static const tumble_pose HOME = { { 0, -0.1, 0 }, { 0, 0, 0, 1 } };
static tumble_body belt, arm, box[LANES];
static tumble_joint finger[LANES][2];
static double behind, caught;           // m, s

// A box that the belt will bring, and two fingers that slide along z.
static void build_lane(tumble_world *w, int lane, double z)
{
    tumble_shape cube = tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), MASS);
    tumble_shape pad = tumble_shape_box(w, tumble_v(0.2, 0.5, 0.1), 2);
    tumble_body_options at = tumble_body_at(-3, 0.2, z);
    at.group = BOX;
    box[lane] = tumble_body_add(w, cube, at);
    for (int k = 0; k < 2; k++) {
        double side = k ? 1 : -1;
        at = tumble_body_at(0, 0.4, z + 0.35 * side);
        finger[lane][k] = tumble_joint_slider(w, arm,
                                              tumble_body_add(w, pad, at),
                                              at.pose.position,
                                              tumble_v(0, 0, -side));
        tumble_joint_set_motor(w, finger[lane][k], 0, HOLDS);
    }
}

static void build(tumble_world *w)
{
    tumble_body_options at = tumble_body_at(0, 1.5, 0);
    at.kind = TUMBLE_KINEMATIC;
    arm = tumble_body_add(w, tumble_shape_box(w, tumble_v(0.3, 0.2, 3), 1), at);
    at.pose = HOME;
    at.velocity.x = SPEED;
    belt = tumble_body_add(w, tumble_shape_box(w, tumble_v(8, 0.2, 4), 1), at);
    for (int k = 0; k < LANES; k++) build_lane(w, k, 2 * k - 1);
    caught = 0;
}

// The belt has its speed, and is put back in every step.  Where a ray meets a
// box it stops, and the fingers close; then the arm lifts for two seconds.
static void act(tumble_world *w)
{
    const tumble_vec3 none = { 0, 0, 0 }, up = { 0, 0.5, 0 };
    double t = tumble_world_time(w), since = t - caught;
    tumble_body_set_pose(w, belt, HOME);
    if (caught == 0) {
        const tumble_vec3 from = { 0.2, 0.2, -2 }, to = { 0.2, 0.2, 2 };
        if (!tumble_world_ray(w, from, to, BOX, NULL)) return;
        behind = SPEED * t - (tumble_body_position(w, box[0]).x + 3);
        caught = t;
        tumble_body_set_velocity(w, belt, none, none);
        for (int k = 0; k < LANES * 2; k++)
            tumble_joint_set_motor(w, finger[k / 2][k % 2], 0.5,
                                   (k < 2 ? 1.1 : 0.9) * HOLDS);
    } else tumble_body_set_velocity(w, arm, since > 0.4 && since < 2.4
                                    ? up : none, none);
}

static int laws(tumble_world *w, example_law *is)
{
    is[0] = example_is("behind the belt, v^2 / 2 mu g (m)",
                       SPEED * SPEED / (2 * GRIP * GRAVITY), behind);
    is[1] = example_is("lifted by 1.1 m g / 2 mu (yes: 1)", 1,
                       tumble_body_position(w, box[0]).y > 1);
    is[2] = example_is("lifted by 0.9 m g / 2 mu", 0,
                       tumble_body_position(w, box[1]).y > 0.3);
    return 3;
}

const example belt_scene = {
    .name = "belt", .about = "a conveyor, and two grippers", .seconds = 8,
    .eye = { 3, 2.5, 5 }, .target = { 0, 0.6, 0 },
    .build = build, .act = act,
    .claim = "friction starts boxes and holds them as its law says, to 1 %",
    .laws = laws, .most = 0.01 };
//<
