//> surface-head
//>   A surface keeps its triangles as they were given, and a tree of boxes
//>   around them.
// surface.h - a surface of many triangles, solid below, and a tree to find them.
//
// Paper: a body there is one convex solid.  Book: chapter 19.
// Units: metres, in the frame of the points.

#pragma once

#include "aabb_tree.h"
#include "scene.h"

// Each triangle is the top of a prism.  Its sides lead from the corners by `down`; or,
// if that is zero, to a triangle half as large that lies behind the middle of the
// first, against its normal.
typedef struct {
    vec3 *point;        // [points] m
    int  (*triangle)[3];        // [triangles] counter-clockwise seen from
                                // outside
    int  points, triangles;
    vec3 down;          // m
    real thickness;     // m, if `down` is zero, the greatest depth,
    real *deep;         // [triangles] m, and the depth of each: at most half of the
                        // distance to what is behind, at least a hundredth of that
    aabb_tree prisms;   // of the triangles that have an area
} surface;

// All its tables, and how many elements each has.
#define SURFACE_TABLES(TABLE, s)                                              \
    TABLE(point, (s)->points) TABLE(triangle, (s)->triangles)                 \
    TABLE(deep, (s)->triangles) TABLE(prisms.around, (s)->triangles)          \
    TABLE(prisms.number, (s)->triangles)                                      \
    TABLE(prisms.node, 2 * aabb_tree_leaves((s)->triangles))
//<

//> surface-query
// The question: which prisms may a box meet that moves straight by `delta`?  Or, if
// by_distance, which are no further from it than `most` (m)?
typedef struct {
    aabb  thing;
    vec3 delta;         // m
    bool by_distance;
    real most;          // of the way (0 to 1), or m
    // Called with a triangle whose prism may be met; returns the new value of
    // `most`.
    real (*meets)(void *context, int triangle);
    void *context;
} surface_query;
//<

//> surface-declare
// Makes a surface; it copies points and triangles.  Requires down or thickness (m) to
// be 0, and not both.  Triangles without an area (lower than a millionth of their
// longest side) are left out.  Fails, leaving *s empty, if no triangle is left, a
// coordinate is not finite, a triangle names a point that does not exist, a prism is
// lower than a millionth of a side, or further from the origin than MOST_AWAY of its
// shortest side, or memory is refused.
status surface_make(surface *s, const vec3 *point, int points,
                    const int (*triangle)[3], int triangles, vec3 down,
                    real thickness);
void   surface_free(surface *s);    // an empty or zeroed one is fine

// The corners (m) of a triangle's prism: its own three, and those below them.
enum { PRISM_CORNERS = 6 };
void   surface_prism(const surface *s, int triangle, vec3 at[PRISM_CORNERS]);

// The fraction at which the segment from one point to another goes in through a
// triangle, from its front; HUGE_VAL if it does not.  A segment that meets the common
// edge of two triangles meets both.
real   surface_entry(const surface *s, int triangle, vec3 from, vec3 to);

// The fraction at which it goes in through another face of the prism, which goes to
// *side; HUGE_VAL if it does not, and -1 if it begins in the prism.
real   surface_entry_below(const surface *s, int triangle, vec3 from, vec3 to,
                           plane *side);

// The plane of a triangle, with the solid behind it.
plane  surface_plane(const surface *s, int triangle);

// The prism as a shape about its centre, which goes to *center (m).  Fails as
// shape_begin does.
status surface_shape(const surface *s, int triangle, shape *made,
                     vec3 *center);

// Calls q->meets for the triangles that answer q, those in nearer boxes first.
void   surface_visit(const surface *s, surface_query *q);
//<
