//> touch-head
// touch.h - particles of cloth and rope, parted from all that they touch.
//
// Paper: section 5.2 and the end of 6.1.  Book: chapter 16.

#pragma once

#include "near.h"
//<

//> touch-declare
//>   Planes and pairs of particles come first, then bodies, then facets.
// Parts two particles of the pool that overlap, and returns by how much they did (m).
real touch_part(const soft_frame *f, particle_contact c, real friction);

// Each parts what is listed and overlaps, and returns how many it parted.
// Particles and planes,
int touch_planes(const soft_frame *f);

// particles and particles,
int touch_pairs(const near_lists *l, const soft_frame *f, real *deepest);

// particles and rigid bodies,
int touch_bodies(const near_lists *l, rigid_view *v, const soft_frame *f,
                 bool is_backward);

// and triangles and links and what these have that no particle can see: edges
// and corners.  Who answers: the corners of a facet, or all that they hang on?
typedef enum { BY_PARTICLE, BY_WHOLE } answering;
int touch_facets(near_lists *l, rigid_view *v, const soft_frame *f, answering who,
                 bool is_backward);

// Does all of the deformable body a keep its distance from the rigid body b?
bool touch_is_clear(rigid_view *v, const soft_frame *f, int a, int b);
//<
