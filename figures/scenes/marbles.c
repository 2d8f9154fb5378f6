// marbles.c - a hundred marbles run through a funnel.
#include "example.h"

#include <math.h>

enum { MARBLES = 100, SIDES = 12 };
static const double LONG = 1.6, THICK = 0.1;    // m, a board
static const double AWAY = 0.75, HIGH = 2;      // m, its middle: from the axis
static tumble_body marble[MARBLES];

// Boards that lean, cut so that they close a ring; each is placed by its centre.
static void build_funnel(tumble_world *w, tumble_body_options at)
{
    tumble_vec3 corner[8];
    for (int k = 0; k < 8; k++) {
        double x = k & 1 ? LONG / 2 : -LONG / 2, y = k & 2 ? THICK / 2 : -THICK / 2;
        double wide = (AWAY + (x - y) * sqrt(0.5)) * tan(acos(-1) / SIDES);
        corner[k] = tumble_v(x, y, k & 4 ? wide : -wide);
    }
    double out = AWAY + (LONG * LONG + THICK * THICK) / (24 * AWAY);
    double up = HIGH + (LONG * LONG - THICK * THICK) / (24 * AWAY);
    double c = cos(acos(-1) / 8), s = sin(acos(-1) / 8);
    tumble_shape board = tumble_shape_hull(w, corner, 8, 1), piece[SIDES];
    tumble_pose pose[SIDES];
    for (int k = 0; k < SIDES; k++) {
        double half = acos(-1) * k / SIDES, x = cos(half), y = sin(half);
        piece[k] = board;
        pose[k].position = tumble_v(out * cos(2 * half), up, -out * sin(2 * half));
        // First leaning, about z, then around, about y.
        pose[k].rotation = (tumble_quat){ s * y, c * y, s * x, c * x };
    }
    tumble_body_add_pieces(w, piece, pose, SIDES, at);
}

static void build(tumble_world *w)
{
    tumble_shape s = tumble_shape_sphere(w, 0.05, 0.01);
    tumble_body_options at = tumble_body_at(0, 0, 0);
    at.friction = 0.1;
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    build_funnel(w, at);
    for (int k = 0; k < MARBLES; k++) {
        at.pose.position = tumble_v(0.11 * (k % 5 - 2.02), 2.6 + 0.11 * (k / 25),
                                    0.11 * (k / 5 % 5 - 2.01));
        marble[k] = tumble_body_add(w, s, at);
    }
}

// How many have not come through?
static double stuck(tumble_world *w)
{
    int n = 0;
    for (int k = 0; k < MARBLES; k++) n += tumble_body_position(w, marble[k]).y > 1;
    return n;
}

const example marbles = {
    .name = "marbles", .about = "a hundred through a funnel", .seconds = 10,
    .has_floor = true, .eye = { 3.7, 4.5, 4.8 }, .target = { 0, 1.5, 0 },
    .build = build, .claim = "all have come through", .error = stuck };
