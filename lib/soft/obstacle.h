//> obstacle-head
//>   A convex body is what lies behind the planes of all its faces. A particle
//>   that is in front of one of them by more than its *gap*, the distance that
//>   it keeps, does not touch. Most likely the same plane shows that in the
//>   next substep.
// obstacle.h - convex bodies, as the particles of a cloth meet them.
//
// Paper: sections 5.1 and 6.1.  Book: chapter 16.
// Units: metres, in the world's frame.

#pragma once

#include "body.h"
#include "gjk.h"
#include "scene.h"

// A convex body, which owns neither its vertices nor its planes.
typedef struct {
    hull vertices;
    const plane *plane; // [planes] of its faces, normals outwards
    int  planes;
    real size;          // m, the shape's radius
    real round;         // m, of one that is round: its vertices are the core;
                        // a ball or a capsule has no planes
} obstacle;

// A point of a surface.
typedef struct {
    vec3 at;            // m
    vec3 normal;        // unit, out of the body
} surface_point;

// m, how far x is in front of the plane.
static inline real plane_height(plane p, vec3 x)
{
    return vec3_dot(x, p.normal) - p.offset;
}
//<

//> obstacle-declare
//>   The planes of a body are found when it is looked at.
// The planes of the faces of rigid shape s, whose vertices are at `at`, or of
// what is round around those; coplanar faces once.  Writes at most s->mesh.faces of them, and returns their
// number, which may change with a body's strain: the triangles of a side are
// coplanar to a billionth of the body's size, or are counted apart.
int hull_planes(const shape *s, const vec3 *at, plane *out);

// The plane with this number; of a round body the one that touches it under x.
plane obstacle_plane(const obstacle *b, vec3 x, int number);

// Which of these planes is x furthest in front of, or least far behind?  Of
// equals the first; 0 where x is not finite.
int hull_ahead(vec3 x, const plane *planes, int count);

// Is x nearer than reach (m, >= 0) to the body, or in it?  Then *out is the
// point of its surface nearest to x; of an x in the body, under the face that
// is the nearest way out.  ahead: the plane that x was in front of when that
// was last known; the answer does not depend on it by more than rounding.  A
// point that is not finite is near nothing.  Requires a plane, or a round body.
bool obstacle_nearest(const obstacle *b, vec3 x, int ahead, real reach,
                      surface_point *out);

// Is there a plane between the body and the convex hull of these points?  *ahead:
// the number of a plane of the body that is asked first; it receives another.
// What is not finite meets nothing.
bool obstacle_is_apart(const obstacle *b, const vec3 *at, int count, int *ahead);
//<
