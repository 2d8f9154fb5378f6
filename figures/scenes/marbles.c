// marbles.c - a hundred marbles run through a funnel.
#include "example.h"

#include <math.h>

enum { MARBLES = 100, SIDES = 12 };
static const double LONG = 1.6, THICK = 0.1;    // m, a board
static const double AWAY = 0.75, HIGH = 2;      // m, its middle: from the axis
static tumble_body marble[MARBLES];

// A board that leans by half a right angle, cut on both sides so that SIDES of
// them close a ring: as wide as the distance from its axis wants.
static tumble_shape cut_board(tumble_world *w)
{
    tumble_vec3 corner[8];
    for (int k = 0; k < 8; k++) {
        double x = k & 1 ? LONG / 2 : -LONG / 2, y = k & 2 ? THICK / 2 : -THICK / 2;
        double wide = (AWAY + (x - y) * sqrt(0.5)) * tan(acos(-1) / SIDES);
        corner[k] = tumble_v(x, y, k & 4 ? wide : -wide);
    }
    return tumble_shape_hull(w, corner, 8, 1);
}

static void build_funnel(tumble_world *w)
{
    tumble_shape board = cut_board(w);
    // A hull is placed by its centre, which is beyond the middle: it is wider there.
    double out = AWAY + (LONG * LONG + THICK * THICK) / (24 * AWAY);
    double up = HIGH + (LONG * LONG - THICK * THICK) / (24 * AWAY);
    tumble_shape piece[SIDES];
    tumble_pose pose[SIDES];
    for (int k = 0; k < SIDES; k++) {
        double angle = 2 * acos(-1) * k / SIDES, half = angle / 2;
        double c = cos(acos(-1) / 8), s = sin(acos(-1) / 8);
        piece[k] = board;
        pose[k].position = tumble_v(out * cos(angle), up, -out * sin(angle));
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
