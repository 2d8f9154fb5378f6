// wrecker.c - a wrecking ball on a chain, and a wall of bricks.
#include "example.h"

#include <math.h>

enum { LINKS = 8, ROWS = 8, COLUMNS = 6 };
static tumble_body brick[ROWS * COLUMNS];

// The chain is let go from the level of its nail, pulled taut.
static void build_chain(tumble_world *w)
{
    const double length = 0.5, nail = 6;                    // m
    tumble_shape link = tumble_shape_capsule(w, 0.8 * length, 0.05, 4);
    tumble_shape iron = tumble_shape_sphere(w, 0.5, 400);
    tumble_body last = tumble_body_ground();
    for (int k = 0; k < LINKS; k++) {
        tumble_body_options at = tumble_body_at(-length * (k + 0.5), nail, 0);
        at.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), acos(-1) / 2);
        tumble_body next = tumble_body_add(w, link, at);
        tumble_joint_ball(w, last, next, tumble_v(-length * k, nail, 0));
        last = next;
    }
    double end = -length * LINKS;
    tumble_body ball = tumble_body_add(w, iron,
                                       tumble_body_at(end - 0.5, nail, 0));
    tumble_joint_ball(w, last, ball, tumble_v(end, nail, 0));
}

static void build(tumble_world *w)
{
    tumble_shape s = tumble_shape_box(w, tumble_v(0.5, 0.5, 1), 20);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    build_chain(w);
    for (int k = 0; k < ROWS * COLUMNS; k++) {
        int row = k / COLUMNS;
        double z = 1.02 * (k % COLUMNS) - 2.5 + (row % 2) * 0.5;
        brick[k] = tumble_body_add(w, s,
                                   tumble_body_at(0.8, 0.25 + 0.5 * row, z));
    }
}

// How many bricks less than ten were moved by half a metre?
static double spared(tumble_world *w)
{
    int n = 0;
    for (int k = 0; k < ROWS * COLUMNS; k++)
        n += fabs(tumble_body_position(w, brick[k]).x - 0.8) > 0.5;
    return n < 10 ? 10 - n : 0;
}

const example wrecker = {
    .name = "wrecker", .about = "a ball on a chain, and a wall", .seconds = 6,
    .has_floor = true, .eye = { 6, 5, 11 }, .target = { 0, 2.2, 0 },
    .build = build, .claim = "ten bricks or more were moved by half a metre",
    .error = spared };
