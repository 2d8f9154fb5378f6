// solution.c - a mirror throws the first axis onto the roots of the shares.

#include "masses.h"

// The rows sqrt(share_k) (1, t_k) must be those of an orthogonal matrix, so its
// first column is q, q_k = sqrt(share_k), which has length 1.  Householder's
// mirror at the plane across v = q + (1, 0, 0, 0) throws (1, 0, 0, 0) onto -q:
//     H_kj = (1 if k = j) - v_k v_j / (1 + q_0).
// (q - (1, 0, 0, 0) would do, too, but for q_0 near 1, where it is the small
// difference of large numbers.)  Row 0 is (-q_0, -q_1, -q_2, -q_3), and row k
// is (-q_k, delta_kj - q_k q_j / (1 + q_0)).  All have -q_k in front: divide.
int masses_directions(const real share[FOUR_MASSES], vec3 t[FOUR_MASSES])
{
    real q[FOUR_MASSES], sum = 0;
    for (int k = 0; k < FOUR_MASSES; k++) {
        if (!(share[k] > 0)) return 0;
        sum += share[k];
        q[k] = sqrt(share[k]);
    }
    if (!(fabs(sum - 1) <= 1e-9)) return 0;
    for (int k = 0; k < FOUR_MASSES; k++) {
        real s = 1 / (k == 0 ? q[0] : 1 + q[0]);
        t[k] = (vec3){ s * q[1] - (k == 1 ? 1 / q[1] : 0),
                       s * q[2] - (k == 2 ? 1 / q[2] : 0),
                       s * q[3] - (k == 3 ? 1 / q[3] : 0) };
    }
    return 1;
}

// sum_k share_k (1 + t_k . y) = 1 + 0, and sum_k share_k (1 + t_k . y) t_k =
// 0 + (the unit matrix) y.
void masses_weigh(const real share[FOUR_MASSES], const vec3 t[FOUR_MASSES],
                  vec3 y, real weight[FOUR_MASSES])
{
    for (int k = 0; k < FOUR_MASSES; k++)
        weight[k] = share[k] * (1 + vec3_dot(t[k], y));
}
