//> weight-head
//>   A drum with a stone in it is no evenly filled drum.
// weight.h - rigid shapes that are not evenly filled.
//
// Paper: not asked; the mass of a body there is that of its particles.
// Book: chapter 13.
// Units: metres, kilograms.  Frame: the shape's.

#pragma once

#include "rigid4.h"
#include "scene.h"

// A vector of the frame of a placement, in the world.
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

// Copies a shape.  Fails, leaving *s empty, if memory is refused.
status weight_copy(shape *s, const shape *of);

// Copies a rigid shape, and gives the copy a mass (kg), a centre of mass (m) and
// moments of inertia about it (kg m^2): xx, yy, zz, xy, xz, yz of the tensor.  Fails,
// leaving *s empty, if the shape is not rigid, a number is out of range, the centre is
// not inside, no solid has such moments (each principal one is less than the sum of the
// two others), or memory is refused.
status weight_set(shape *s, const shape *of, real mass, vec3 center,
                  const real inertia[6]);

// The weight of a body of several pieces.  Begin with zeros; add the weight of each
// piece at its place in the body; take the mean; then let each piece add its reach from
// the centre.
void weight_add(struct weight *sum, const shape *piece, const placement *at);
void weight_mean(struct weight *sum);
void weight_reach(struct weight *whole, const shape *piece, const placement *at);

// Copies a piece as a shape in the frame of the body, with the weight of the whole
// body.  Fails as weight_copy does.
status weight_piece(shape *s, const shape *piece, const placement *at,
                    const struct weight *whole);
//<
