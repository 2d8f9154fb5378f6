//> ring-head
// ring.h - what faster queries want of a shape: each vertex's neighbours in one
// row, and how thick the body is.
//
// Book: chapter 10.  The half-edges of the mesh say the same; a row of numbers is
// read faster.

#ifndef TUMBLE_RING_H
#define TUMBLE_RING_H

#include "body.h"

// The mesh neighbours of vertex v are list[start[v]] .. list[start[v + 1] - 1],
// in the order of a turn around it.
typedef struct rings {
    int *start;         // [vertices + 1]
    int *list;          // [2 * edges]
} rings;

// Fails, and leaves *r empty, if memory is refused.
status rings_build(rings *r, const struct mesh *m);
void   rings_free(rings *r);    // an empty or zeroed one is fine

// The radius (m) of the largest sphere about the origin of a rigid shape that
// lies inside it; 0 for a shape that has no inside.
real shape_inner(const shape *s);

#endif
//<
