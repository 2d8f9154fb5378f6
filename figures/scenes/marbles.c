// marbles.c - a hundred marbles run through a funnel.
#include "example.h"

#include <math.h>

enum { MARBLES = 100, SIDES = 12 };
static tumble_body marble[MARBLES];

// Twelve boards around a hole, which lean inwards by half a right angle.
static void build_funnel(tumble_world *w)
{
    tumble_shape board = tumble_shape_box(w, tumble_v(1.6, 0.1, 1.2), 1);
    tumble_shape piece[SIDES];
    tumble_pose pose[SIDES];
    for (int k = 0; k < SIDES; k++) {
        double angle = 2 * acos(-1) * k / SIDES, half = angle / 2;
        double c = cos(acos(-1) / 8), s = sin(acos(-1) / 8);
        piece[k] = board;
        pose[k].position = tumble_v(0.75 * cos(angle), 2, -0.75 * sin(angle));
        // First leaning, about z, then around, about y.
        tumble_quat q = { s * sin(half), c * sin(half), s * cos(half),
                          c * cos(half) };
        pose[k].rotation = q;
    }
    tumble_body_options at = tumble_body_at(0, 0, 0);
    at.friction = 0.1;
    tumble_body_add_pieces(w, piece, pose, SIDES, at);
}

static void build(tumble_world *w)
{
    tumble_shape s = tumble_shape_sphere(w, 0.05, 0.01);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    build_funnel(w);
    for (int k = 0; k < MARBLES; k++) {
        tumble_body_options at = tumble_body_at(0.11 * (k % 5 - 2.02),
                                                2.6 + 0.11 * (k / 25),
                                                0.11 * (k / 5 % 5 - 2.01));
        at.friction = 0.1;
        marble[k] = tumble_body_add(w, s, at);
    }
}

// How many have not come through?
static double stuck(tumble_world *w)
{
    int n = 0;
    for (int k = 0; k < MARBLES; k++)
        n += tumble_body_position(w, marble[k]).y > 1;
    return n;
}

const example marbles = {
    .name = "marbles", .about = "a hundred through a funnel", .seconds = 10,
    .has_floor = true, .eye = { 3.7, 4.5, 4.8 }, .target = { 0, 1.5, 0 },
    .build = build, .claim = "all have come through", .error = stuck };
