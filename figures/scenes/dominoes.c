// dominoes.c - sixty of them on a curve; the first is pushed.
#include "example.h"

#include <math.h>

enum { PIECES = 60 };
static tumble_body piece[PIECES];

static void build(tumble_world *w)
{
    const double radius = 6, step = 0.5 / radius;       // m, rad
    tumble_shape s = tumble_shape_box(w, tumble_v(0.2, 1, 0.5), 0.3);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < PIECES; k++) {
        double angle = k * step;
        tumble_body_options at = tumble_body_at(radius * sin(angle), 0.5,
                                                radius * cos(angle));
        at.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), angle);
        piece[k] = tumble_body_add(w, s, at);
    }
    tumble_body_push(w, piece[0], tumble_v(0.6, 0, 0), tumble_v(0, 1, radius));
}

// How many still stand?
static double standing(tumble_world *w)
{
    int n = 0;
    for (int k = 0; k < PIECES; k++)
        n += tumble_body_position(w, piece[k]).y > 0.45;
    return n;
}

const example dominoes = {
    .name = "dominoes", .about = "sixty on a curve, and a push", .seconds = 15,
    .has_floor = true, .eye = { 9, 9, 14 }, .target = { 0, 0.4, 0 },
    .build = build, .claim = "all have fallen", .error = standing };
