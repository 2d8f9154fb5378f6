// ragdoll.c - a doll of eleven capsules falls down a stair.
#include "example.h"

enum { LIMBS = 11, STEPS = 12 };

// Each hangs on an earlier one, at a height; its elbow or knee bends from least
// to most (rad), and 0, 0 is a ball that turns every way.
static const struct {
    double x, y, length, radius;                            // m
    int on;
    double at, least, most;
} limb[LIMBS] = {
    { 0, 1.20, 0.20, 0.14, 0, 0, 0, 0 },                    // chest
    { 0, 1.56, 0.05, 0.10, 0, 1.42, 0, 0 },                 // head
    { 0, 0.90, 0.08, 0.13, 0, 1.00, 0, 0 },                 // hips
    {-.22, 1.12, .2, .05, 0, 1.28, 0, 0}, {.22, 1.12, .2, .05, 0, 1.28, 0, 0},
    {-.22, .82, .2, .04, 3, .98, -2.4, 0}, {.22, .82, .2, .04, 4, .98, -2.4, 0},
    {-.09, .6, .28, .07, 2, .8, 0, 0}, {.09, .6, .28, .07, 2, .8, 0, 0},
    {-.09, .2, .28, .06, 7, .4, 0, 2.4}, {.09, .2, .28, .06, 8, .4, 0, 2.4} };
static tumble_joint joint[LIMBS];
static double worst;
static void build(tumble_world *w)
{
    const double up = STEPS * 0.2 + 0.02;
    tumble_body part[LIMBS];
    tumble_shape stair = tumble_box(w, tumble_v(0.3, 0.2, 2), 1);
    tumble_add_plane(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < STEPS; k++) {
        tumble_body_options at = tumble_at(0.3 * k, 0.2 * (STEPS - k) - 0.1, 0);
        at.kind = TUMBLE_STATIC;
        tumble_add(w, stair, at);
    }
    for (int k = 0; k < LIMBS; k++) {
        double r = limb[k].radius, l = limb[k].length, x = limb[k].x;
        tumble_vec3 at = tumble_v(0, limb[k].at + up, x);
        tumble_shape s = tumble_capsule(w, l, r, 3000 * r * r * (l + r));
        part[k] = tumble_add(w, s, tumble_at(0, limb[k].y + up, x));
        if (k == 0) continue;
        tumble_body on = part[limb[k].on];
        bool bends = limb[k].most > limb[k].least;
        joint[k] = bends ? tumble_hinge(w, on, part[k], at, tumble_v(0, 0, 1))
                         : tumble_ball(w, on, part[k], at);
        if (bends) tumble_set_limits(w, joint[k], limb[k].least, limb[k].most);
    }
    worst = 0;
    tumble_push(w, part[0], tumble_v(60, 0, 0), tumble_v(0, 1.4 + up, 0));
}
static void act(tumble_world *w)
{
    for (int k = 1; k < LIMBS; k++)
        if (tumble_joint_gap(w, joint[k]) > worst)
            worst = tumble_joint_gap(w, joint[k]);
}
static double gap(tumble_world *w) { return act(w), worst; }

const example ragdoll = {
    .name = "ragdoll", .about = "a doll falls down a stair", .seconds = 6,
    .has_floor = true, .eye = { 4.5, 3.2, 5.5 }, .target = { 1.3, 1.1, 0 },
    .build = build, .act = act,
    .claim = "no joint ever gapes by a millimetre", .error = gap, .most = 1e-3 };
