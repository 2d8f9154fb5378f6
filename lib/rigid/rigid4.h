//> rigid4-head
//>   What follows from a shape alone is computed once.
// rigid4.h - any rigid body is four particles and six sticks.
//
// Paper: section 4 puts a particle at every vertex, whose inertia is 2.3 to 5
// times the solid's.  Here: Routh's four equal masses, with the mass, the
// centre and the inertia of the solid (Laus and Selig 2020).
// Book: chapter 13.
// Units: metres, kilograms.

#pragma once

#include "body.h"

enum { FOUR = 4, FOUR_STICKS = 6, FOUR_AXES = 3 };

// The frame of four particles: their middle and three vectors, so that particle k is at
// center + sum_i T_ki axis_i, with T_ki = 1 or -1 (the corners of a tetrahedron in a
// cube).  The axes are perpendicular while the sticks hold.
typedef struct {
    vec3 center;            // m
    vec3 axis[FOUR_AXES];   // m
} rigid_frame;

// What all bodies of a shape have in common, as four particles.  The vertices of the
// mesh have fixed coordinates in the frame of the particles.
typedef struct rigid4 {
    vec3  at[FOUR];         // m, at rest, in the frame of the shape
    vec3  center;           // m, the solid's centre of mass, in that frame
    real  mass;             // kg, of each of the four
    real  radius;           // m, their largest distance from the centre
    real  reach;            // m, the body's largest distance from it
    struct stick stick[FOUR_STICKS];        // every pair
    real  square[FOUR_AXES];        // m^2, of the frame's vectors
    int   round_axes;       // about how many axes of the frame it is round: 0, 1 (axis
                            // 1), or 3
    vec3 *local;            // [shape->particles] coordinates of the vertices: each is
                            // at center + local.x axis[0] + ...
    vec3 middle;            // those of the mean of all vertices
    vec3 span;              // the largest of each coordinate
    real turn[FOUR_AXES];   // kg^(-1/2) m^(-2), see motion_basis
    real root[FOUR_AXES];   // kg^(1/2) m, of the moment of inertia about each axis
    real inverse[FOUR_AXES];        // 1/(kg m^2), one over that moment
    real per_length[FOUR_AXES];     // 1/m, one over the length of its vector
    int  alike;             // the moments of this axis and the next one differ least
} rigid4;
//<

//> rigid4-declare
// Computes the four particles of a solid: what the closed mesh of s encloses, or a
// round body, evenly filled with the mass of s.  Fails, leaving *f empty, if s has no
// volume, or so little that rounding loses it, or memory is refused.
status rigid4_build(rigid4 *f, const shape *s);
void   rigid4_free(rigid4 *f);      // an empty or zeroed one is fine

// A solid: its volume (m^3), and the means of x and of x x^T over it.
typedef struct {
    real volume;
    vec3 center;
    real spread[3][3];      // m^2, about the centre
} rigid_solid;

// m += s a a^T.
void rigid4_add_outer(real m[3][3], real s, vec3 a);

// The solid of s, or its own weight if it has one (the volume is then 1); and its mass
// (kg).  A mesh that encloses nothing has a volume of 0.
rigid_solid rigid4_solid(const shape *s);
real  rigid4_mass(const shape *s);

// The signs T of a frame: particle k stands at center + sum_i T[k][i] axis_i.
extern const real FOUR_SIGN[FOUR][FOUR_AXES];

// The frame of four particles.
rigid_frame rigid4_frame(const particle *p);

// The frame of the shape's own four, at rest.
rigid_frame rigid4_rest(const rigid4 *f);

// The vector (m) with these coordinates in a frame, and the coordinates of a
// vector: the axes are perpendicular, so each is found alone.
static inline vec3 frame_vector(const rigid_frame *f, vec3 local)
{
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(local.x, f->axis[0]),
                                           local.y, f->axis[1]),
                           local.z, f->axis[2]);
}

static inline vec3 frame_local(const rigid_frame *f, vec3 r)
{
    const vec3 *axis = f->axis;
    return vec3_make(vec3_dot(r, axis[0]) / vec3_length_squared(axis[0]),
                     vec3_dot(r, axis[1]) / vec3_length_squared(axis[1]),
                     vec3_dot(r, axis[2]) / vec3_length_squared(axis[2]));
}

// The point with these coordinates in a frame.
static inline vec3 frame_point(const rigid_frame *f, vec3 local)
{
    return vec3_add(f->center, frame_vector(f, local));
}

// The arm (m, from the centre) of particle k.
static inline vec3 frame_arm(const rigid_frame *f, int k)
{
    const real *t = FOUR_SIGN[k];
    return frame_vector(f, vec3_make(t[0], t[1], t[2]));
}

// The part of a rotation (rad) that moves points of a body: a rotation about an axis
// about which it is round leaves it in the same space.
static inline vec3 rigid4_lean(const rigid4 *f, const rigid_frame *frame,
                               vec3 turn)
{
    vec3 axis = frame->axis[1];
    if (f->round_axes == 0) return turn;
    if (f->round_axes == FOUR_AXES) return (vec3){ 0, 0, 0 };
    return vec3_add_scaled(turn, -vec3_dot(turn, axis)
                                 / vec3_length_squared(axis), axis);
}

// Where the n vertices are in this frame.
void rigid4_ride(const rigid4 *f, const rigid_frame *frame, vec3 *at, int n);
//<
