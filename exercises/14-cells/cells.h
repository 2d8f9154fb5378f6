// cells.h - a grid without end, in a table that has one.
//
// Units: metres.

#ifndef TUMBLE_CELLS_H
#define TUMBLE_CELLS_H

#include "vec3.h"

// Cell (i, j, k) of a grid of this size (m) holds what has
// i <= x / size < i + 1, and so on.
typedef struct {
    long long i, j, k;
} cell;

// The cell of a place.  Returns 0, and leaves *c, if the place is not finite or
// lies more than 2^40 cells from the origin along an axis.
int cell_of(vec3 at, real size, cell *c);

// Where the table keeps a cell.  Several may share a slot.
static inline int cell_slot(cell c, int slots)
{
    unsigned long long h = (unsigned long long)c.i * 73856093u
                         ^ (unsigned long long)c.j * 19349663u
                         ^ (unsigned long long)c.k * 83492791u;
    return (int)((h ^ h >> 29) & (unsigned long long)(slots - 1));
}

// All memory is the caller's.  slots is a power of two, 1 or more.
typedef struct {
    int   points, slots;
    cell *in;           // [points] the cell of each
    int  *start;        // [slots + 1] slot s holds member[start[s]] up to, not
    int  *member;       // [points]    including, member[start[s + 1]]
    long  looked;       // distances measured by the last cells_pairs
} cells;

// Puts all points into the table, those of a slot from the lowest number to the
// highest.  Returns 0 if one of them has no cell.
int cells_fill(cells *g, const vec3 *at, real size);

// The pairs no further apart than reach, a < b, each once, in any order; out
// keeps the first `capacity`.  Returns how many there are; or -1 if a point has
// no cell, or if reach is not from 0 to size: then neighbouring cells would not
// be enough.  Measures the distance only of points in the same cell or in
// neighbouring ones.
int cells_pairs(cells *g, const vec3 *at, real size, real reach,
                int (*out)[2], int capacity);

#endif
