// fifteen.h - the depth of two boxes, by trying every direction that can count.
//
// Units: metres.  Frame: the world's.

#ifndef TUMBLE_FIFTEEN_H
#define TUMBLE_FIFTEEN_H

#include "hit_face.h"

typedef struct {
    vec3 centre;        // m
    vec3 axis[3];       // unit, perpendicular to each other
    vec3 half;          // m, half edges along them, > 0
} box;

typedef struct {
    real depth;         // m, the least overlap of the fifteen; < 0: apart
    vec3 normal;        // unit, from B to A
    int  direction;     // 0 to 14, the one that it was
} fifteen_result;

fifteen_result boxes_depth(const box *a, const box *b);

#endif
