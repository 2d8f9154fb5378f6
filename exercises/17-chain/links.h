// links.h - bodies in a row, held together by ball joints; and 3 x 3 matrices.
//
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_BODIES_OF_A_CHAIN_H
#define TUMBLE_BODIES_OF_A_CHAIN_H

#include "vec3.h"

// Its columns: where x, y and z go.
typedef struct { vec3 x, y, z; } block;

static inline vec3 block_apply(block m, vec3 a)
{
    vec3 sum = vec3_add_scaled(vec3_scale(a.x, m.x), a.y, m.y);
    return vec3_add_scaled(sum, a.z, m.z);
}

// First b, then a.
static inline block block_times(block a, block b)
{
    return (block){ block_apply(a, b.x), block_apply(a, b.y), block_apply(a, b.z) };
}

// a + s b.
static inline block block_add_scaled(block a, real s, block b)
{
    return (block){ vec3_add_scaled(a.x, s, b.x), vec3_add_scaled(a.y, s, b.y),
                    vec3_add_scaled(a.z, s, b.z) };
}

static inline block block_inverse(block m)
{
    vec3 u = vec3_cross(m.y, m.z), v = vec3_cross(m.z, m.x), w = vec3_cross(m.x, m.y);
    real s = 1 / vec3_dot(m.x, u);
    return (block){ { s * u.x, s * v.x, s * w.x }, { s * u.y, s * v.y, s * w.y },
                    { s * u.z, s * v.z, s * w.z } };
}

typedef struct {
    vec3  velocity, spin;       // m/s, rad/s
    real  inverse_mass;         // 1/kg
    block inverse;              // 1/(kg m^2), of the inertia
} limb;

// Joint k, between the bodies k and k + 1.
typedef struct {
    vec3  above, below;         // m, arms from the centre of k and of k + 1
    vec3  part;                 // kg m/s, the impulse on body k + 1, found
    block factor;               // room for the walk
} ball_joint;

// How the end of the arm `at` moves for an impulse of 1 along x, y or z at the
// end of the arm r of the same body.
block answer_between(const limb *b, vec3 at, vec3 r);

// Gives every joint the impulse for which, at the end, the points of all have
// the same velocity.  `part` is that impulse on body k + 1; body k gets the
// opposite.  Of joint k at least one body can move.
void chain_hold(limb *body, ball_joint *joint, int joints);

#endif
