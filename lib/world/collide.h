//> collide-head
// collide.h - from two bodies that are near to the contacts between them.
//
// Paper: sections 5.1 and 6.1.  Book: chapter 16.
// Units: metres, in the world's frame.  Normals point from B to A.

#ifndef TUMBLE_COLLIDE_H
#define TUMBLE_COLLIDE_H

#include "scene.h"
#include "ring.h"
#include "separation.h"
#include "swept.h"

// A body as the queries see it.
typedef struct {
    const shape *plan;
    int  first;         // its first particle in the pool
    const vec3 *at;     // [plan->particles] where they are
    real mass;          // kg; HUGE_VAL: immovable
    rings ring;         // of the plan; empty: none, support scans
} collider;

// m, how far x is in front of the plane.
static inline real plane_height(plane p, vec3 x)
{
    return vec3_dot(x, p.normal) - p.offset;
}

enum { PAIR_CONTACTS = 4 };     // the most that two rigid bodies can have
//<

//> collide-declare
// The contacts of rigid bodies a and b that are nearer than margin (m, >= 0),
// in out; returns their number, at most PAIR_CONTACTS: what manifold_find makes
// of the nearest (or deepest) pair of points.  Where faces or edges lie along
// each other, corners of what they share, the deepest first; else the pair
// alone.
// An immovable body is B, whichever was given first; two of them touch nowhere.
// Normals point from B to A; thickness is 0, for the caller to set.  carried:
// see distance_find; keep one for the pair (a, b) in this order.  Bodies, or a
// margin, that are not finite have no contacts.
int collide_rigid(const collider *a, const collider *b, real margin,
                  distance_cache *carried, penetration_scratch *scratch,
                  contact_point out[PAIR_CONTACTS]);

// The contact of rigid bodies a and b where they first come as near as `apart`
// (m, >= 0), while a goes straight by `way` (m) as seen from b: made now, to be
// kept until then.  *c holds it if the result is SWEPT_TOUCHES; else it says
// what became of them, and *c is as it was.  The time is known to a thousandth
// of the smaller body.  scratch: room for the vertices of both.  The rest as
// for collide_rigid.
swept_status collide_swept(const collider *a, const collider *b, vec3 way,
                           real apart, vec3 *scratch, contact_point *c);

// The particles of a nearer to plane p than margin + thickness (m): writes at
// most capacity contacts, returns how many there are.  A particle is A, the
// plane B, immovable: the normal is the plane's, into the free side.  The
// contacts keep particles thickness away.
int collide_plane(const collider *a, plane p, real margin, real thickness,
                  contact_point *out, int capacity);

// The planes of a rigid body's faces, looking outwards, coplanar faces once:
// at most plan->mesh.faces of them in out, the first face of each in face.
// Returns their number, which may change with the body's strain: the triangles
// of a side are coplanar to a billionth of the body's size, or are counted
// apart.
int hull_planes(const shape *plan, const vec3 *at, plane *out, int *face);

// Which of these planes is x furthest in front of, or least far behind?  Of
// equals the first; 0 where x is not finite.
int hull_ahead(vec3 x, const plane *planes, int count);

// Is particle i of a nearer than reach (m, >= 0) to the convex body b, whose
// planes (of hull_planes, at b->at) are given?  Then c is the contact between
// them (b's feature empty when b is immovable) and the result is 1.  The normal
// points out of b; inside, the way out is the nearest face's.  thickness is 0,
// for the caller to set.  A particle that is not finite touches nothing.
// Requires count > 0.
int collide_point(const collider *a, int i, const collider *b,
                  const plane *planes, const int *face, int count,
                  real reach, contact_point *c);
//<

//> collide-end
#endif
//<
