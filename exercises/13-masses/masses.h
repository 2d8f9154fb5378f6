// masses.h - four particles for a body, of any masses that you like.
//
// Without unit: shares of the mass, and places in the frame in which the body's
// spread is the unit matrix.

#ifndef TUMBLE_MASSES_H
#define TUMBLE_MASSES_H

#include "vec3.h"

enum { FOUR_MASSES = 4 };

// Where four particles with these shares (> 0, sum 1 to within 1e-9) have to
// stand: t[0] .. t[3] such that
//     sum share_k t_k = 0   and   sum share_k t_k t_k^T = the unit matrix.
// Of all such places (they may be turned and mirrored) any will do.  Returns 1;
// or 0 if the shares are not such: then t is as it was.
int masses_directions(const real share[FOUR_MASSES], vec3 t[FOUR_MASSES]);

// The weights of the point y: sum weight_k = 1 and sum weight_k t_k = y.
void masses_weigh(const real share[FOUR_MASSES], const vec3 t[FOUR_MASSES],
                  vec3 y, real weight[FOUR_MASSES]);

#endif
