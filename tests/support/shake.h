// shake.h - chapter 13's plain body: four particles that fly by Verlet, and their
// six sticks.
//
// The engine turns its bodies by motion.h.  This is what that is compared with.

#ifndef TUMBLE_SHAKE_H
#define TUMBLE_SHAKE_H

#include "rigid4.h"

// The pairs of the three axes, each with itself and with the others.
static const int SHAKE_PAIR[FOUR_STICKS][2] = {
    { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 0, 2 }, { 1, 2 }
};

typedef struct {
    real worst;         // relative error of a stick before the last step
    int  steps;
} shake_result;

// G = Y^T Y - S, E_ij = G_ij / (s_i + s_j), and the worst of the sticks: the two of
// the axes i and j are off by (G_ii + G_jj) / (2 (s_i + s_j)) +- E_ij.
static inline real shake_bend(const rigid4 *f, const vec3 y[FOUR_AXES],
                              real bend[FOUR_STICKS])
{
    real g[FOUR_STICKS], worst = 0;
    for (int s = 0; s < FOUR_STICKS; s++) {
        int i = SHAKE_PAIR[s][0], j = SHAKE_PAIR[s][1];
        real sum = f->square[i] + f->square[j];
        g[s] = vec3_dot(y[i], y[j]) - (i == j ? f->square[i] : 0);
        bend[s] = g[s] / sum;
        if (i != j)
            worst = fmax(worst, fabs(g[i] + g[j]) / (2 * sum) + fabs(bend[s]));
    }
    return worst;
}

// Y -= Y0 E.
static inline void shake_step(vec3 y[FOUR_AXES], const vec3 old[FOUR_AXES],
                              const real bend[FOUR_STICKS])
{
    for (int s = 0; s < FOUR_STICKS; s++) {
        int i = SHAKE_PAIR[s][0], j = SHAKE_PAIR[s][1];
        y[i] = vec3_add_scaled(y[i], -bend[s], old[j]);
        if (i != j) y[j] = vec3_add_scaled(y[j], -bend[s], old[i]);
    }
}

// Brings the six sticks to their lengths together: Newton's step for all of them,
// until none is off by more than o.tolerance, at most `steps` times, along the
// sticks as they were a step ago or as they lie (o.gradient).
static inline shake_result shake(const rigid4 *f, particle *p, int steps,
                                 relax_options o)
{
    particle was[FOUR];
    for (int k = 0; k < FOUR; k++)
        was[k] = (particle){ .position = o.gradient == GRADIENT_OLD
                                       ? p[k].previous : p[k].position };
    rigid_frame now = rigid4_frame(p), old = rigid4_frame(was);
    real bend[FOUR_STICKS];
    shake_result r = { .worst = shake_bend(f, now.axis, bend) };
    while (r.worst > o.tolerance && r.steps < steps) {
        shake_step(now.axis, old.axis, bend);
        if (++r.steps < steps) r.worst = shake_bend(f, now.axis, bend);
    }
    for (int k = 0; k < FOUR && r.steps > 0; k++)
        p[k].position = vec3_add(now.center, frame_arm(&now, k));
    return r;
}

// Do the particles stand as in a mirror?  No stick can tell.
static inline bool is_mirrored(const rigid4 *f, const particle *p)
{
    rigid_frame now = rigid4_frame(p), rest = rigid4_rest(f);
    real is = vec3_dot(now.axis[0], vec3_cross(now.axis[1], now.axis[2]));
    real was = vec3_dot(rest.axis[0], vec3_cross(rest.axis[1], rest.axis[2]));
    return (is > 0) != (was > 0);
}

#endif
