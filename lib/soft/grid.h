//> grid-head
// grid.h - which of many equal balls are near each other?  Sorted into cells.
//
// Paper: section 5.2 asks a tree.  Book: chapter 14.
// Units: metres.

#pragma once

#include "sphere_tree.h"

// A point, in the order of the cells.
typedef struct {
    vec3 at;
    int  number;
    int  place;         // in the sheet: see grid_pairs
} grid_point;

typedef struct grid {
    int points, cells;  // for so many there is room
    int *start;         // [cells + 2] the first point of each cell
    int *cell;          // [points] where each point is
    grid_point *sorted; // [points] by cell, then by number
    int *near;          // [points] those near one of them, by their place
                        // in `sorted`
} grid;
//<

//> grid-declare
//>   It has one question. The neighbours of a point in its sheet, beside it and
//>   across the cells, are left out at once, because they are near by nature.
// For that many points, >= 0.  Fails, leaving *g empty, if memory is refused.
status grid_init(grid *g, int points);
void   grid_free(grid *g);      // an empty or zeroed one is fine

// The pairs of n points at `at` (n <= g->points) that are nearer than reach (m,
// > 0), each once, a < b, in an order fixed by the places.  They are a sheet of
// so many columns (>= 1), row by row; each point's neighbours there, of which
// it has up to eight, are left out.  Writes at most capacity of them to out, and
// returns how many there are; or -1, where a tree does better: one point is so
// far from the others that the cells would have to be wide, or is not finite.
int grid_pairs(grid *g, const vec3 *at, int n, real reach, int columns,
               leaf_pair *out, int capacity);
//<
