// ray.c - a fan of rays that asks a world what it sees, by tumble.h alone (chapter 19).

#include "live.h"
#include "tumble.h"

#include <stdio.h>

enum { RAYS };                                  // dial
enum { MOST = 180, BOXES = 16, HEAP = 5, PENDULUMS = 3 };
static const double SIDE = 0.5, BALL = 0.2, PLANK[2] = { 2.0, 0.14 }, FAR = 9;      // m

static tumble_world *world;
static tumble_body box[BOXES], ball[PENDULUMS], plank, wall[2];
static tumble_shape cube;
static tumble_vec3 lamp = { -0.3, 1.1, 0 };
static vec3 end[MOST + 1];
static int boxes, rays, met;
static double nearest;

static vec3 taken(tumble_vec3 v)
{
    return vec3_make(v.x, v.y, 0);
}

// Everything stays in one plane, as in a game of two dimensions.
static tumble_body add(tumble_shape s, double x, double y)
{
    tumble_body b = tumble_body_add(world, s, tumble_body_at(x, y, 0));
    tumble_body_set_locked(world, b, TUMBLE_LOCK_FLAT);
    return b;
}

static void add_box(double x, double y)
{
    if (boxes < BOXES) box[boxes++] = add(cube, x, y);
}

static void add_walls(void)
{
    for (int k = 0; k < 2; k++) {
        tumble_body_options o = tumble_body_at(k ? 3.2 : -3.2, 1.5, 0);
        o.kind = TUMBLE_STATIC;
        wall[k] = tumble_body_add(world, tumble_shape_box(world, tumble_v(0.2, 3, 1), 1), o);
    }
}

static void add_moving(void)
{
    tumble_vec3 z = { 0, 0, 1 }, middle = { 0.9, 1.9, 0 };
    plank = tumble_body_add(world, tumble_shape_box(world, tumble_v(PLANK[0], PLANK[1], SIDE), 2),
                            tumble_body_at(middle.x, middle.y, 0));
    tumble_joint_set_motor(world, tumble_joint_hinge(world, tumble_body_ground(), plank, middle, z), 0.7, 40);
    tumble_shape s = tumble_shape_sphere(world, BALL, 1);
    for (int k = 0; k < PENDULUMS; k++) {
        double x = -2.4 + 0.7 * k;
        ball[k] = tumble_body_add(world, s, tumble_body_at(x, 2 - 0.2 * k, 0));
        tumble_joint_hinge(world, tumble_body_ground(), ball[k], tumble_v(x, 3.1, 0), z);
        tumble_body_push(world, ball[k], tumble_v(1.2 - 0.5 * k, 0, 0), tumble_body_position(world, ball[k]));
    }
}

// One after the other: each direction is the one before, turned, which needs no sine.
static void look(void)
{
    double t = 3.14159265358979 / rays, c = (1 - t * t) / (1 + t * t), d = 2 * t / (1 + t * t);
    double x = FAR, y = 0;
    met = 0;
    nearest = FAR;
    for (int k = 0; k < rays; k++) {
        tumble_vec3 to = { lamp.x + x, lamp.y + y, 0 };
        tumble_hit hit;
        bool is_met = tumble_world_ray(world, lamp, to, ~0u, &hit);
        end[k] = taken(is_met ? hit.point : to);
        met += is_met;
        if (is_met && hit.fraction * FAR < nearest) nearest = hit.fraction * FAR;
        double turned = c * x - d * y;
        y = c * y + d * x, x = turned;
    }
    end[rays] = end[0];
}

static void begin(void)
{
    tumble_world_free(world);
    world = tumble_world_make(NULL);
    rays = (int)live_dial(RAYS);
    boxes = 0;
    if (!world) return;
    tumble_plane_add(world, tumble_v(0, 1, 0), 0, -1);
    cube = tumble_shape_box(world, tumble_v(SIDE, SIDE, SIDE), 1);
    add_walls();
    add_moving();
    for (int k = 0; k < HEAP; k++) add_box(1.1 + 0.55 * (k % 3) + 0.2 * (k / 3), 0.3 + 0.7 * (k / 3));
    look();
}

static void turn(int dial)
{
    (void)dial;
    rays = (int)live_dial(RAYS);
    if (world) look();
}

static void step(void)
{
    if (!world) return;
    tumble_world_step(world);
    look();
    if (tumble_world_failure(world)) live_say("%s.", tumble_world_failure(world));
    else live_say("%d rays: %d meet something, the nearest %.2f m away.", rays, met, nearest);
}

static void press(int button)
{
    (void)button;
    if (world) add_box(0.1 * (boxes % 7) - 0.9, 2.6);
}

static void move(int number, vec3 to)
{
    (void)number;
    lamp = tumble_v(to.x, real_max(to.y, 0.05), 0);
    if (world) look();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_plate(live_colour c, tumble_body b, double width, double height)
{
    tumble_pose at = tumble_body_pose(world, b);
    vec3 corner[4];
    for (int k = 0; k < 4; k++)
        corner[k] = taken(tumble_pose_to_world(at, tumble_v(k % 3 ? width / 2 : -width / 2, k < 2 ? -height / 2 : height / 2, 0)));
    live_area(c, corner, 4);
}

static void draw(void)
{
    if (!world) return;
    live_band(LIVE_ORANGE, end, rays);
    for (int k = 0; k < rays; k++) live_dashes(LIVE_ORANGE, (vec3[]){ taken(lamp), end[k] }, 2);
    for (int k = 0; k < rays; k++) live_dot(LIVE_RED, end[k], 2);
    live_line(LIVE_INK, (vec3[]){ { -4, 0, 0 }, { 4, 0, 0 } }, 2);
    for (int k = 0; k < 2; k++) draw_plate(LIVE_GREY, wall[k], 0.2, 3);
    for (int k = 0; k < boxes; k++) draw_plate(LIVE_BLUE, box[k], SIDE, SIDE);
    draw_plate(LIVE_GREEN, plank, PLANK[0], PLANK[1]);
    for (int k = 0; k < PENDULUMS; k++) {
        vec3 at = taken(tumble_body_position(world, ball[k]));
        live_line(LIVE_QUIET, (vec3[]){ { -2.4 + 0.7 * k, 3.1, 0 }, at }, 2);
        live_circle(LIVE_PURPLE, at, BALL);
    }
    live_handle(0, LIVE_ORANGE, taken(lamp), "eye");
}

static unsigned long long hash(void)
{
    return world ? live_hash(tumble_world_hash(world), end, (size_t)rays * sizeof *end) : 0;
}

const live_figure figure = {
    .name = "ray",
    .says = "Rays go out from a point to all sides, and end where they meet boxes, swinging balls, a plank that turns, or the ground",
    .pane = { { -3.5, -0.2, 7, 3.5 } },
    .dial = { [RAYS] = { "rays", NULL, 4, MOST, 4, 48, NULL, false } },
    .button = { "Drop a box" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .turn = turn, .press = press, .move = move,
};
