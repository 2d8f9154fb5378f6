// real4_run.h - the operations of real4.h, by number.

#ifndef TUMBLE_REAL4_RUN_H
#define TUMBLE_REAL4_RUN_H

#include "vec3.h"

#include <stdbool.h>

enum { ADD, SUB, MUL, DIV, MAX, MIN, CHOOSE, SQRT, MAD, SUMS, CROSS_X,
       CROSS_Y, CROSS_Z, MAKE, ALL, ANY, GATHER, OPERATIONS };

typedef struct {
    real a[4], b[4], c[4];
} real_lanes;

void real4_run_plain(int operation, const real_lanes *in, real out[8]);
void real4_run_vectors(int operation, const real_lanes *in, real out[8]);
void real4_run_wide(int operation, const real_lanes *in, real out[8]);
bool real4_has_wide(void);      // else it must not be run

#endif
