//> ragdoll
// ragdoll.c - a doll of eleven capsules falls down a stair.
#include "example.h"

enum { LIMBS = 11, STEPS = 12 };

// Each hangs on an earlier one, at a height.  A shoulder leans by its swing
// (rad) and turns from least to most; without a swing it is an elbow.
static const struct { double x, y, length, radius; int on;
                      double at, swing, least, most; } limb[LIMBS] = {
    { 0, 1.20, 0.20, 0.14, 0, 0, 0, 0, 0 },                 // chest
    { 0, 1.56, 0.05, 0.10, 0, 1.42, 0.7, -1, 1 },           // head
    { 0, 0.90, 0.08, 0.13, 0, 1.00, 0.5, -0.4, 0.4 },       // hips
    { -0.22, 1.12, 0.20, 0.05, 0, 1.28, 2, -1, 1 },
    {  0.22, 1.12, 0.20, 0.05, 0, 1.28, 2, -1, 1 },
    { -0.22, 0.82, 0.20, 0.04, 3, 0.98, 0, -2.4, 0 },
    {  0.22, 0.82, 0.20, 0.04, 4, 0.98, 0, -2.4, 0 },
    { -0.09, 0.60, 0.28, 0.07, 2, 0.80, 1, -0.4, 0.4 },
    {  0.09, 0.60, 0.28, 0.07, 2, 0.80, 1, -0.4, 0.4 },
    { -0.09, 0.20, 0.28, 0.06, 7, 0.40, 0, 0, 2.4 },
    {  0.09, 0.20, 0.28, 0.06, 8, 0.40, 0, 0, 2.4 } };
static tumble_joint joint[LIMBS];
static double gap, beyond;              // m, rad
static void build(tumble_world *w)
{
    const double up = STEPS * 0.2 + 0.02;
    tumble_body part[LIMBS];
    tumble_shape stair = tumble_shape_box(w, tumble_v(0.3, 0.2, 2), 1);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < STEPS; k++) {
        tumble_body_options at = tumble_body_at(0.3 * k,
                                                0.2 * (STEPS - k) - 0.1, 0);
        at.kind = TUMBLE_STATIC;
        tumble_body_add(w, stair, at);
    }
    for (int k = 0; k < LIMBS; k++) {
        double r = limb[k].radius, l = limb[k].length, x = limb[k].x;
        tumble_vec3 at = tumble_v(0, limb[k].at + up, x);
        tumble_shape s = tumble_shape_capsule(w, l, r, 3000 * r * r * (l + r));
        part[k] = tumble_body_add(w, s, tumble_body_at(0, limb[k].y + up, x));
        if (k == 0) continue;
        tumble_body on = part[limb[k].on];
        if (limb[k].swing > 0) {
            joint[k] = tumble_joint_ball(w, on, part[k], at);
            tumble_joint_set_cone(w, joint[k], tumble_v(0, 1, 0), limb[k].swing,
                                  limb[k].least, limb[k].most);
        } else {
            joint[k] = tumble_joint_hinge(w, on, part[k], at,
                                          tumble_v(0, 0, 1));
            tumble_joint_set_limits(w, joint[k], limb[k].least, limb[k].most);
        }
    }
    gap = beyond = 0;
    tumble_body_push(w, part[0], tumble_v(150, 0, 0), tumble_v(0, 1.4 + up, 0));
}
static void act(tumble_world *w)
{
    for (int k = 1; k < LIMBS; k++) {
        double g = tumble_joint_gap(w, joint[k]);
        double b = tumble_joint_swing(w, joint[k]) - limb[k].swing;
        if (g > gap) gap = g;
        if (b > beyond) beyond = b;
    }
}
static int laws(tumble_world *w, example_law *is)
{
    act(w);
    is[0] = example_is("widest gap of a joint (m)", 0, gap);
    is[1] = example_is("furthest beyond a cone (rad)", 0, beyond);
    return 2;
}
const example ragdoll = {
    .name = "ragdoll", .about = "a doll falls down a stair", .seconds = 6,
    .has_floor = true, .eye = { 4.5, 3.2, 5.5 }, .target = { 1.3, 1.1, 0 },
    .build = build, .act = act,
    .claim = "no joint gapes by a millimetre, or leans beyond its cone",
    .laws = laws, .most = 1e-3 };
//<
