//> motion-head
//>   A box that is thrown about no special axis wobbles. Beside Euler's
//>   equations, solved by a finer program, half of the step leaves a quarter of
//>   the error: order 2.
// motion.h - the six degrees of freedom of a rigid body of four particles.
//
// Paper: not asked; a body there moves particle by particle.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Frame: the world's.

#pragma once

#include "rigid4.h"

#include <stdalign.h>
#include <stdbool.h>

enum { TURNS = 3 };

// How a rigid body can move.  Its three turns are about the axes of its frame, which
// are perpendicular, so each has an energy of its own and no inertia tensor is
// needed.  A turn of 1 kg^(1/2) m/s has half a joule.
typedef struct {
    real inverse_mass;  // 1/kg, of the whole body; 0: immovable
    vec3 turn[TURNS];   // rad kg^(-1/2) / m, axis and angle of a turn of 1
    const rigid4 *of;   // the body with its moments; NULL: immovable
} motion_basis;

extern const motion_basis MOTION_IMMOVABLE;

// A velocity (m/s and kg^(1/2) m/s), or a displacement (m and kg^(1/2) m).
// Its address is a multiple of 16 bytes, which real4_gather2 needs and malloc gives.
// It is as large as a cache line, so in a table that begins with a line, as those of
// table_grow_aligned do, no motion lies on two lines.
enum { MOTION_TURN = 3, MOTIONS = 6, MOTION_LINE = 8 };

typedef struct {
    alignas(16) real of[MOTION_LINE];   // of the centre along x, y, z; three
                                        // turns; two that are not used
} motion;

// How a body may move in a frame.
typedef struct {
    real seconds;       // s, the length of that frame
    vec3 delta;         // m, the displacement of its centre at its velocity now
    real turn;          // m, how much further a vertex may move
    real reach;         // m, how far a vertex may move in all
    vec3 spin;          // rad, the rotation at its spin now, without the part that
                        // moves no point of a round body (rigid4_lean)
    real angle;         // rad, the length of spin
    real arc;           // m, no vertex moves further by that rotation
} prediction;
//<

//> motion-declare
// The motion basis of a body in this frame.
motion_basis basis_find(const rigid4 *f, const rigid_frame *frame);

// The velocity of particles p[0..3] over their last substep of h (s), as far as a
// rigid body can have it.  Linear and angular momentum are those of the particles.
motion motion_of(const particle *p, const rigid_frame *frame,
                 const motion_basis *basis, real h);

// The motion with this velocity (m/s) and this spin (rad/s).
motion motion_make(const motion_basis *basis, vec3 velocity, vec3 spin);

// The velocity (m/s) or displacement (m) of the centre.
static inline vec3 motion_straight(const motion *m)
{
    return vec3_make(m->of[0], m->of[1], m->of[2]);
}

// The spin (rad/s) or rotation (rad) about the centre.
static inline vec3 motion_rotation(const motion_basis *basis, const motion *m)
{
    const real *w = m->of + MOTION_TURN;
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(w[0], basis->turn[0]),
                                           w[1], basis->turn[1]),
                           w[2], basis->turn[2]);
}

// The velocity (m/s) or displacement (m) of the point at `arm` (m, from the centre).
static inline vec3 motion_at(const motion_basis *basis, const motion *m,
                             vec3 arm)
{
    return vec3_add(motion_straight(m), vec3_cross(motion_rotation(basis, m), arm));
}

// Adds to a velocity what an impulse (N s) at `arm` (m, from the centre) gives, or to
// a displacement what an impulse times a time (kg m) gives.
void motion_push(motion *m, const motion_basis *basis, vec3 arm, vec3 impulse);

// The same for an angular impulse (N m s), which moves no centre.
static inline void motion_twist(motion *m, const motion_basis *basis,
                                vec3 moment)
{
    for (int t = 0; t < TURNS; t++)
        m->of[MOTION_TURN + t] += vec3_dot(basis->turn[t], moment);
}

// The inverse effective mass (1/kg or 1/(kg m^2)) for a unit impulse with this moment:
// the share of this body's turns, added to `sum`.
static inline real motion_answer(real sum, const motion_basis *basis,
                                 vec3 moment)
{
    for (int t = 0; t < TURNS; t++) {
        real row = vec3_dot(basis->turn[t], moment);
        sum += row * row;
    }
    return sum;
}

// Adds `times` v (m/s or m) to the motion of the centre.
static inline void motion_add_straight(motion *m, real times, vec3 v)
{
    m->of[0] += times * v.x;
    m->of[1] += times * v.y;
    m->of[2] += times * v.z;
}

static inline void motion_add(motion *m, const motion *more)
{
    for (int i = 0; i < MOTIONS; i++) m->of[i] += more->of[i];
}

static inline bool motion_is_some(const motion *m)
{
    bool some = false;
    for (int i = 0; i < MOTIONS; i++) some |= m->of[i] != 0;
    return some;
}

// m/s: no point within radius (m) of the centre is faster.
static inline real motion_fastest(const motion_basis *basis, const motion *m,
                                  real radius)
{
    return vec3_length(motion_straight(m))
         + radius * vec3_length(motion_rotation(basis, m));
}

// The kinetic energy (J) of a velocity, and its angular momentum (kg m^2/s)
// about the centre.
real motion_energy(const motion_basis *basis, const motion *m);
vec3 motion_angular(const motion_basis *basis, const motion *m);
//<

//> motion-advance-declare
// A large rotation is made in several moves of at most this angle.  There are at most
// MOTION_MOVES; a spin that would need more is less exact, for a wild spin must not
// make a frame last seconds.
static const real MOTION_FURTHEST = 1.0 / 3;        // tuned, rad
enum { MOTION_MOVES = 1000 };

// Lets a body with this frame, and with the velocity u in this basis, move freely for
// h (s).  Its angular momentum stays the same in the world, so u changes with the
// basis.  Exact if two of its moments are equal; else of order 2 and symmetric in time,
// so that its energy does not drift.
void motion_advance(rigid_frame *frame, motion_basis *basis, motion *u, real h);

// Displaces the body by d, as an impact or a cloth does; its angular momentum stays
// the same in the world.
void motion_displace(rigid_frame *frame, motion_basis *basis, motion *u,
                     const motion *d);

// Gives the axes of a frame their lengths and right angles again, which rounding bends
// a little with every turn.  The error left is the square of the error before.
void motion_straighten(const rigid4 *f, rigid_frame *frame);

// Writes frame and velocity u to the particles at the end of a step: `position`, and
// `previous`, a substep of h (s) ago.
void motion_write(particle *p, const rigid_frame *frame,
                  const motion_basis *basis, const motion *u, real h);
//<

//> motion-frame-declare-inside
// The frame of a body after a displacement d from this one.
rigid_frame motion_frame(const rigid_frame *frame, const motion_basis *basis,
                         const motion *d);
//<
