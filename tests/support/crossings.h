// crossings.h - what a cloth must not do, counted from outside: triangles that
// cross each other, triangles and particles in a solid, edges of a solid that
// pass through triangles.
//
// It asks positions alone, and nothing of what the library holds to be near.
// Units: metres.

#ifndef TUMBLE_CROSSINGS_H
#define TUMBLE_CROSSINGS_H

#include "vec3.h"

#include <stdbool.h>

// A triangle, or a link of a rope, which says its last corner twice; and the
// box around it.
typedef struct {
    vec3 corner[3], least, most;
    int  vertex[3];     // patches that share one are neighbours
} patch;

// The corners stand at at[vertex[k]]; the patch's own numbers begin at `first`.
patch patch_make(const vec3 *at, const int vertex[3], int first);

// Neighbours meet in what they share, and never count as crossing.  Triangles
// that only touch do not cross.  A link crosses a triangle, but no other link.
bool patches_cross(const patch *a, const patch *b);

// Pairs that cross.  The slow one looks at every pair.  The quick one gives the
// same number, and changes nothing; -1 if memory is refused.  A patch that is
// not finite crosses nothing.
long crossings_count(const patch *x, int n);
long crossings_count_slowly(const patch *x, int n);

// A convex body: its corners, and the planes of its triangles, which look
// outwards.
enum { SOLID_CORNERS = 642, SOLID_FACES = 2 * SOLID_CORNERS };
typedef struct {
    int  corners, faces;
    vec3 corner[SOLID_CORNERS], normal[SOLID_FACES];
    real offset[SOLID_FACES];
    int  face[SOLID_FACES][3];
    vec3 least, most;
    real size;          // m, of the box around it
} solid;

// Takes copies of all.  Requires at most so many corners and faces.
void solid_make(solid *s, const vec3 *at, int corners, const int *face,
                int faces);

// m, how deep x is below the nearest plane; below 0: outside.
real solid_depth(const solid *s, vec3 x);

// Is a part of the patch inside, deeper than rounding?  Touching is no cut.
bool solid_is_cut(const solid *s, const patch *p);

// How many edges of the solid pass through the patch.
int  solid_edges_through(const solid *s, const patch *p);

#endif
