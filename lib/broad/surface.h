//> surface-head
//>   A surface keeps its triangles as they were given, and a tree of boxes
//>   around them.
// surface.h - a surface of many triangles, solid below, and which of them are
// where.
//
// Paper: a body there is one convex solid.  Book: chapter 19.
// Units: metres, in the frame of the points.

#pragma once

#include "aabb_tree.h"
#include "scene.h"

// Each triangle is the top of a prism.  From each of its corners an edge goes
// down, by `down`; or, if that is zero, it ends in a triangle half as large, which
// lies behind its middle, against its normal.
typedef struct {
    vec3 *point;        // [points] m
    int  (*triangle)[3];        // [triangles] counter-clockwise seen from
                                // outside
    int  points, triangles;
    vec3 down;          // m
    real thickness;     // m, at most, if `down` is zero
    real *deep;         // [triangles] m, then: no more than half of the way to
                        // what is behind, but at least a hundredth of that
    aabb_tree prisms;   // of triangles that have an area
} surface;

// All its tables, and how many elements each has.
#define SURFACE_TABLES(TABLE, s)                                              \
    TABLE(point, (s)->points) TABLE(triangle, (s)->triangles)                 \
    TABLE(deep, (s)->triangles) TABLE(prisms.around, (s)->triangles)          \
    TABLE(prisms.number, (s)->triangles)                                      \
    TABLE(prisms.node, 2 * aabb_tree_leaves((s)->triangles))
//<

//> surface-query
// What is asked: which prisms may a box meet that goes straight by way?  Or, if
// by_distance, which are no further from it than most (m)?
typedef struct {
    aabb  thing;
    vec3 way;           // m
    bool by_distance;
    real most;          // of the way (0 to 1), or m
    // Called with a triangle whose prism may be met; returns what `most` is from
    // now on.
    real (*meets)(void *context, int triangle);
    void *context;
} surface_query;
//<

//> surface-declare
// Copies points and triangles.  Of down and thickness (m) one is not zero.
// Triangles without an area (lower than a millionth of their longest side) are
// left out.  Fails, leaving *s empty: no triangle is left, a number of a point
// is not finite, a triangle names a point that is not there, a prism is no more
// than a millionth as high as a side is long, or further from the origin than
// MOST_AWAY of its shortest side; or memory is refused.
status surface_make(surface *s, const vec3 *point, int points,
                    const int (*triangle)[3], int triangles, vec3 down,
                    real thickness);
void   surface_free(surface *s);    // an empty or zeroed one is fine

// The corners (m) of a triangle's prism: its own three, and those below them.
enum { PRISM_CORNERS = 6 };
void   surface_prism(const surface *s, int triangle, vec3 at[PRISM_CORNERS]);

// Does the way from one point to another go in through a triangle, from its
// front?  Then the share of the way, or HUGE_VAL.  A way that meets an edge of
// two triangles meets both.
real   surface_entry(const surface *s, int triangle, vec3 from, vec3 to);

// Does it go in through another face of the prism?  Then the share, and that
// face goes to *side.  HUGE_VAL: it does not; -1: it begins in the prism.
real   surface_entry_below(const surface *s, int triangle, vec3 from, vec3 to,
                           plane *side);

// The plane of a triangle, with what is solid behind it.
plane  surface_plane(const surface *s, int triangle);

// The prism as a shape about its centre, which goes to *center (m).  Fails as
// shape_begin does.
status surface_shape(const surface *s, int triangle, shape *made,
                     vec3 *center);

// Calls q->meets for all triangles asked for, the nearer boxes first.
void   surface_visit(const surface *s, surface_query *q);
//<
