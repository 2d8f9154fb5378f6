// bridge.c - a rope bridge: planks between two banks, joined by hinges.
#include "example.h"
#include <math.h>

enum { PLANKS = 20 };
static const double LENGTH = 0.5, SPAN = 0.96 * 20 * 0.5;   // m
static tumble_body plank[PLANKS];

// The end of plank k - 1, and the start of plank k: a V, to begin with.
static tumble_vec3 joint(int k)
{
    double down = LENGTH * sqrt(1 - 0.96 * 0.96);
    return tumble_v(0.96 * LENGTH * k - SPAN / 2,
                    -down * (k < PLANKS / 2 ? k : PLANKS - k), 0);
}

static void build(tumble_world *w)
{
    tumble_shape s = tumble_shape_box(w, tumble_v(LENGTH, 0.05, 1.5), 8);
    for (int k = 0; k < PLANKS; k++) {
        tumble_vec3 a = joint(k), b = joint(k + 1);
        double x = (a.x + b.x) / 2, slope = atan2(b.y - a.y, b.x - a.x);
        tumble_body_options at = tumble_body_at(x, (a.y + b.y) / 2, 0);
        at.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), slope);
        at.damping = at.spin_damping = 0.5;
        plank[k] = tumble_body_add(w, s, at);
    }
    for (int k = 0; k <= PLANKS; k++)
        tumble_joint_hinge(w, k > 0 ? plank[k - 1] : tumble_body_ground(),
                           k < PLANKS ? plank[k] : tumble_body_ground(),
                           joint(k), tumble_v(0, 0, 1));
}

// How deep planks hang, and how far they span; the pull is in weights of one.
static double hangs(double pull, double *span)
{
    double deep = *span = 0;
    for (int k = 0; k < PLANKS / 2; k++) {
        double slope = (k + 0.5) / pull;
        *span += 2 * LENGTH / sqrt(1 + slope * slope);
        deep += LENGTH * slope / sqrt(1 + slope * slope);
    }
    return deep;
}

static double wrong_sag(tumble_world *w)
{
    double pull = 500, span;
    for (double by = 500; by > 1e-12; by /= 2, pull += span < SPAN ? by : -by)
        hangs(pull, &span);
    double half = 0.25 * LENGTH / sqrt(1 + 4 * pull * pull);  // of a plank
    double sag = half - tumble_body_position(w, plank[PLANKS / 2]).y;
    return fabs(sag - hangs(pull, &span));
}

const example bridge = {
    .name = "bridge", .about = "twenty planks that hang", .seconds = 20,
    .eye = { 3, 3, 15 }, .target = { 0.2, -0.8, 0 }, .build = build,
    .claim = "it sags as the catenary of planks, to 5 mm",
    .error = wrong_sag, .most = 0.005 };
