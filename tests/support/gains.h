// gains.h - what no relaxation may give to a free body: momentum, of either kind.

#ifndef TUMBLE_TESTS_GAINS_H
#define TUMBLE_TESTS_GAINS_H

#include "expect.h"
#include "verlet.h"

// Momentum and angular momentum that n particles gained in one relaxation.
static inline void gains_nothing(const particle *before, const particle *after,
                                 int n, real tolerance)
{
    vec3 push = { 0, 0, 0 }, torque = { 0, 0, 0 };
    for (int i = 0; i < n; i++) {
        if (after[i].inverse_mass == 0) continue;
        vec3 move = vec3_sub(after[i].position, before[i].position);
        vec3 m = vec3_scale(1 / after[i].inverse_mass, move);
        push = vec3_add(push, m);
        torque = vec3_add(torque, vec3_cross(before[i].position, m));
    }
    near(vec3_length(push), 0, tolerance, "momentum");
    near(vec3_length(torque), 0, tolerance, "angular momentum");
}

#endif
