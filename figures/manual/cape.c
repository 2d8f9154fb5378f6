//> cape
// cape.c - a cape on the shoulders of a runner.
#include "example.h"

#include <math.h>

enum { COLUMNS = 16, ROWS = 24, VERTICES = COLUMNS * ROWS };
static const double MASS = 0.6, RADIUS = 0.2, LENGTH = 1.2;     // kg, m, m
static tumble_body cape, runner, yoke;
static tumble_joint stitch[COLUMNS];
static int inside;                      // vertices, at any time

// What hangs on a body does not collide with it, so the cape hangs on a yoke
// that goes with the runner.
static void build(tumble_world *w)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body_options at = tumble_body_at(0, 0.8, 0);
    at.kind = TUMBLE_KINEMATIC;
    runner = tumble_body_add(w, tumble_shape_capsule(w, LENGTH, RADIUS, 70),
                             at);
    at.pose.position = tumble_v(0, 1.6, -0.25);
    yoke = tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.05, 0.05), 1),
                           at);
    at = tumble_body_at(0, 1, -0.3);
    at.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), acos(-1) / 2);
    at.damping = 1;                     // 1/s: air
    cape = tumble_body_add(w, tumble_shape_cloth(w, COLUMNS, ROWS, 0.7, 1.2,
                                                 MASS), at);
    for (int i = 0; i < COLUMNS; i++)
        stitch[i] = tumble_joint_hang(w, cape, i, yoke);
    inside = 0;
}

// Which vertices are in the runner, whose axis is upright?
static void count_inside(tumble_world *w)
{
    static tumble_vec3 at[VERTICES];
    tumble_vec3 c = tumble_body_position(w, runner);
    int n = tumble_body_vertices(w, cape, at, VERTICES);
    for (int k = 0; k < n; k++) {
        double x = at[k].x - c.x, y = at[k].y - c.y, z = at[k].z - c.z;
        y = fmax(0, fabs(y) - LENGTH / 2);
        inside += x * x + y * y + z * z < RADIUS * RADIUS;
    }
}

// Two seconds of running, and a sudden stop.
static void act(tumble_world *w)
{
    double t = tumble_world_time(w);
    double speed = t > 0.3 && t < 2.3 ? 2 : 0;  // m/s
    tumble_body_set_velocity(w, runner, tumble_v(0, 0, speed),
                             tumble_v(0, 0, 0));
    tumble_body_set_velocity(w, yoke, tumble_v(0, 0, speed), tumble_v(0, 0, 0));
    count_inside(w);
}

static int laws(tumble_world *w, example_law *is)
{
    double bears = 0;
    for (int i = 0; i < COLUMNS; i++) bears += tumble_joint_force(w, stitch[i]);
    is[0] = example_is("sum of the stitches, m g (N)", MASS * 9.81, bears);
    is[1] = example_is("vertices inside the runner", 0, inside);
    return 2;
}

const example cape_scene = {
    .name = "cape", .about = "on the back of a runner", .seconds = 15,
    .has_floor = true, .eye = { 6, 2.2, 1 }, .target = { 0, 0.8, 2 },
    .build = build, .act = act,
    .claim = "the runner is never in it, and at rest it bears m g, to 0.1 %",
    .laws = laws, .most = 1e-3 };
//<
