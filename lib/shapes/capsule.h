//> round-head
// capsule.h - rigid bodies that are round: all that is near a point or segment.
//
// Paper: no such bodies; it tests spheres only to find what is near.
// Book: chapter 10.
// Units: metres, kilograms.

#pragma once

#include "body.h"

// Both have a core, the particles of the shape: one, or two that an edge joins.
// What is no further from it than the radius is the body.  The mass is spread
// evenly in it.  A function that makes a shape fails, and leaves *s empty, if a
// number is not from 1e-30 to 1e30, or memory is refused.

// A ball around the origin.
status shape_sphere(shape *s, real radius, real mass);

// The mesh of a core of two particles: half and vertex_half have room.
void capsule_join_core(mesh *m);

// All points within radius of a segment of this length, which lies along y
// with its middle in the origin: a rod whose ends are half balls.
status shape_capsule(shape *s, real length, real radius, real mass);
//<
