//> poses-head
//>   A simulation that looks right may be wrong by a tenth of a body. So we
//>   measure. The ruler needs a scene, and where its particles are; so it fits
//>   every system in this book. It stands with the tests, beside the slow
//>   oracle of chapter 10.
// poses.h - how far from right do the bodies of a scene lie?
//
// Paper: section 7 measures time only.  Book: chapter 9.
// It does not matter what moved them: all that is asked is a scene, and where
// its particles are.
// Units: metres, in the world's frame.

#ifndef TUMBLE_POSES_H
#define TUMBLE_POSES_H

#include "scene.h"
//<

//> poses-declare
//>   It measures strain, overlap, and what has passed through what it should
//>   not.
typedef struct {
    bool finite;        // every position is
    real strain;        // largest of |length - rest| / rest, stiff sticks
    real strain_rms;    // over the same
    real shear;         // largest over the soft sticks (a cloth's diagonals)
    real overlap;       // m, deepest: rigid bodies in each other
    real behind;        // m, deepest: particles behind planes
    int  outside;       // bodies whose centre is behind a plane
    real inside;        // m, deepest: particles of deformable bodies in rigid
    int  particles_in;  // of deformable bodies, in a rigid one
} poses;

// at: [particles of the scene] body after body, a particle at every vertex.
// Two static bodies are not held against each other.
poses poses_measure(const scene *s, const vec3 *at);

// Triangles of cloths that a rigid body overlaps, by more than a billionth of a
// metre.
int poses_triangles_in(const scene *s, const vec3 *at);

// Links of deformable bodies that pass through triangles of cloths (their own,
// or others').  Compares all with all: slow.
int poses_crossings(const scene *s, const vec3 *at);

// J, at the velocities (at - before) / dt, dt in s; without what never moves.
real poses_kinetic(const scene *s, const vec3 *before, const vec3 *at, real dt);

#endif
//<
