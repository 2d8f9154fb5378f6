// ragdoll.c - a doll of eleven capsules falls down a stair.
#include "example.h"

#include <math.h>

enum { LIMBS = 11, STEPS = 12 };

// Each hangs on an earlier one, at a point; its elbow or knee bends from least
// to most (rad), and 0, 0 is a ball that turns every way.
static const struct {
    double x, y, length, radius;    // m
    int on;
    double at, least, most;         // m, the height where it hangs
} limb[LIMBS] = {
    {  0,    1.20, 0.20, 0.14,  0, 0,    0, 0 },        // chest
    {  0,    1.56, 0.05, 0.10,  0, 1.42, 0, 0 },        // head
    {  0,    0.90, 0.08, 0.13,  0, 1.00, 0, 0 },        // hips
    { -0.22, 1.12, 0.20, 0.05,  0, 1.28, 0, 0 },        // arms
    {  0.22, 1.12, 0.20, 0.05,  0, 1.28, 0, 0 },
    { -0.22, 0.82, 0.20, 0.04,  3, 0.98, -2.4, 0 },
    {  0.22, 0.82, 0.20, 0.04,  4, 0.98, -2.4, 0 },
    { -0.09, 0.60, 0.28, 0.07,  2, 0.80, 0, 0 },        // legs
    {  0.09, 0.60, 0.28, 0.07,  2, 0.80, 0, 0 },
    { -0.09, 0.20, 0.28, 0.06,  7, 0.40, 0, 2.4 },
    {  0.09, 0.20, 0.28, 0.06,  8, 0.40, 0, 2.4 } };
static tumble_joint joint[LIMBS];
static double worst;

static void build(tumble_world *w)
{
    const double away = 0, up = STEPS * 0.2 + 0.02;
    tumble_body part[LIMBS];
    tumble_shape stair = tumble_box(w, tumble_v(0.3, 0.2, 2), 1);
    tumble_add_plane(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < LIMBS; k++) {
        double r = limb[k].radius, x = limb[k].x, y = limb[k].y + up;
        tumble_shape s = tumble_capsule(w, limb[k].length, r,
                                        3000 * r * r * (limb[k].length + r));
        part[k] = tumble_add(w, s, tumble_at(away, y, x));
        if (k == 0) continue;
        tumble_vec3 at = tumble_v(away, limb[k].at + up, x);
        bool bends = limb[k].most > limb[k].least;
        joint[k] = bends ? tumble_hinge(w, part[limb[k].on], part[k], at,
                                        tumble_v(0, 0, 1))
                         : tumble_ball(w, part[limb[k].on], part[k], at);
        if (bends) tumble_set_limits(w, joint[k], limb[k].least, limb[k].most);
    }
    for (int k = 0; k < STEPS; k++) {
        tumble_body_options at = tumble_at(0.3 * k, 0.2 * (STEPS - k) - 0.1, 0);
        at.kind = TUMBLE_STATIC;
        tumble_add(w, stair, at);
    }
    worst = 0;
    tumble_push(w, part[0], tumble_v(60, 0, 0), tumble_v(away, 1.4 + up, 0));
}

static void act(tumble_world *w)
{
    for (int k = 1; k < LIMBS; k++)
        worst = fmax(worst, tumble_joint_gap(w, joint[k]));
}

static double gap(tumble_world *w) { (void)w; return worst; }

const example ragdoll = {
    .name = "ragdoll", .about = "a doll falls down a stair", .seconds = 6,
    .has_floor = true, .eye = { 4.5, 3.2, 5.5 }, .target = { 1.3, 1.1, 0 },
    .build = build, .act = act,
    .claim = "no joint ever gapes by more than a millimetre",
    .error = gap, .most = 1e-3 };
