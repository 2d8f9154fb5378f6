//> obstacle-head
// obstacle.h - planes and convex bodies, as the points of a body meet them.
//
// Paper: sections 5.1 and 6.1.  Book: chapter 16.
// Units: metres, in the world's frame.  Normals point from B to A.

#ifndef TUMBLE_OBSTACLE_H
#define TUMBLE_OBSTACLE_H

#include "collide.h"
#include "scene.h"
#include "separation.h"

// A body whose points have numbers in the pool.
typedef struct {
    const shape *plan;
    int  first;         // its first particle in the pool
    const vec3 *at;     // [plan->particles] where they are
    real mass;          // kg; HUGE_VAL: immovable
} pooled;

// m, how far x is in front of the plane.
static inline real plane_height(plane p, vec3 x)
{
    return vec3_dot(x, p.normal) - p.offset;
}

enum { PAIR_CONTACTS = MANIFOLD_POINTS };
//<

//> obstacle-declare
// The touches of a manifold as contacts between bodies a and b, b immovable if
// one of them is; thickness is 0, for the caller to set.  Returns their number.
int contacts_of_manifold(const manifold *m, const pooled *a, const pooled *b,
                         contact_point out[PAIR_CONTACTS]);

// The particles of a nearer to plane p than margin + thickness (m): writes at
// most capacity contacts, returns how many there are.  A particle is A, the
// plane B, immovable: the normal is the plane's, into the free side.  The
// contacts keep particles thickness away.
int collide_plane(const pooled *a, plane p, real margin, real thickness,
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
int collide_point(const pooled *a, int i, const pooled *b,
                  const plane *planes, const int *face, int count,
                  real reach, contact_point *c);
//<

//> obstacle-end
#endif
//<
