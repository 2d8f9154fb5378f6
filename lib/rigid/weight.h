//> weight-head
//>   A drum with a stone in it is no evenly filled drum.
// weight.h - rigid shapes that are not evenly filled.
//
// Paper: not asked; a body there weighs what its particles weigh.  Book:
// chapter 13.
// Units: metres, kilograms.  Frame: the shape's.

#pragma once

#include "rigid4.h"
#include "scene.h"

// A vector of its frame, as it is turned.
static inline vec3 placement_vector(const placement *at, vec3 r)
{
    return vec3_add(vec3_scale(r.x, at->x),
           vec3_add(vec3_scale(r.y, at->y), vec3_scale(r.z, at->z)));
}

// All tables of a shape, and how many elements each has: for what copies or saves
// them.
#define SHAPE_TABLES(TABLE, s)                                                \
    TABLE(at, (s)->particles) TABLE(mass, (s)->particles)                     \
    TABLE(stick, (s)->sticks) TABLE(angle, (s)->angles)                       \
    TABLE(face, 3 * (s)->mesh.faces) TABLE(mesh.half, 2 * (s)->mesh.edges)    \
    TABLE(mesh.vertex_half, (s)->mesh.vertices)                               \
    TABLE(mesh.face_half, (s)->mesh.faces) TABLE(skin.at, (s)->skin.points)   \
    TABLE(skin.face, 3 * (s)->skin.faces)

// A shape with copies of all that `of` has.  Fails, and leaves *s empty, if
// memory is refused.
status weight_copy(shape *s, const shape *of);

// The same for a rigid one, with this mass (kg), this centre of mass (m) and
// these moments of inertia about it (kg m^2): xx, yy, zz, xy, xz, yz of the
// tensor.  Fails, and leaves *s empty: a shape that is not rigid, a number out
// of range, a centre that is not inside, moments that no solid has (each
// principal one is less than the sum of the two others), no memory.
status weight_set(shape *s, const shape *of, real mass, vec3 center,
                  const real inertia[6]);

// A body of several pieces.  First their weights are added, each with its place
// in the body, to one of zeros; then the mean is taken; and then it is asked how
// far each piece reaches from the centre.
void weight_add(struct weight *sum, const shape *piece, const placement *at);
void weight_mean(struct weight *sum);
void weight_reach(struct weight *whole, const shape *piece, const placement *at);

// The piece as a shape in the frame of the body, with the weight of the whole.
// Fails as weight_copy does.
status weight_piece(shape *s, const shape *piece, const placement *at,
                    const struct weight *whole);
//<
