//> motion-head
//>   A box that is thrown about no special axis wobbles. Beside Euler's
//>   equations, solved by a finer program, half of the step leaves a quarter of
//>   the error: order 2.
// motion.h - the six ways in which a rigid body of four particles can move.
//
// Paper: not asked; a body there moves particle by particle.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Frame: the world's.

#pragma once

#include "rigid4.h"

#include <stdalign.h>
#include <stdbool.h>

enum { TURNS = 3 };

// How a rigid body can move.  Its three turns are about the axes of its frame,
// which are perpendicular: so each has an energy of its own, and no inertia
// tensor is needed.  A turn of 1 kg^(1/2) m/s has half a joule.
typedef struct {
    real inverse_mass;  // 1/kg, of the whole body; 0: immovable
    vec3 turn[TURNS];   // rad kg^(-1/2) / m: axis and angle, for a turn of 1
    const rigid4 *of;   // whose moments it has; NULL: immovable
} motion_basis;

extern const motion_basis MOTION_IMMOVABLE;

// A velocity (m/s, and kg^(1/2) m/s), or a displacement (m, and kg^(1/2) m).
// Its address is a multiple of 16 bytes, as real4_gather2 needs it.  Memory of
// malloc has that, so a struct that holds one may come from anywhere.  Its size
// is that of a cache line: in a table that begins with a line, as one of
// table_grow does, no motion lies on two.
enum { MOTION_TURN = 3, MOTIONS = 6, MOTION_LINE = 8 };

typedef struct {
    alignas(16) real of[MOTION_LINE];   // of the centre along x, y, z; three
                                        // turns; two that are not used
} motion;

// How a body may move in a frame.
typedef struct {
    real seconds;       // s, the time of it
    vec3 way;           // m, its centre's, as fast as it is now
    real turn;          // m, what its vertices may go beside that
    real reach;         // m, both together
    vec3 spin;          // rad, by which it turns, as fast as it does now; less
                        // what takes no point of it elsewhere (rigid4_lean)
    real angle;         // rad, the length of that
    real arc;           // m, no vertex goes further by turning
} prediction;
//<

//> motion-declare
// The motion basis of a body whose particles stand as the frame says.
motion_basis basis_find(const rigid4 *f, const rigid_frame *frame);

// The velocity of particles p[0..3] over their last substep of h (s): all of it
// that a rigid body can have.  Linear and angular momentum are those of the
// particles.
motion motion_of(const particle *p, const rigid_frame *frame,
                 const motion_basis *basis, real h);

// The motion with this velocity (m/s) and this spin (rad/s).
motion motion_make(const motion_basis *basis, vec3 velocity, vec3 spin);

// The way of the centre in m: m/s, or m.
static inline vec3 motion_straight(const motion *m)
{
    return vec3_make(m->of[0], m->of[1], m->of[2]);
}

// The rotation in m, about the centre: rad/s, or rad.
static inline vec3 motion_rotation(const motion_basis *basis, const motion *m)
{
    const real *w = m->of + MOTION_TURN;
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(w[0], basis->turn[0]),
                                           w[1], basis->turn[1]),
                           w[2], basis->turn[2]);
}

// How the point at `arm` (m, from the centre) moves: m/s, or m.
static inline vec3 motion_at(const motion_basis *basis, const motion *m,
                             vec3 arm)
{
    return vec3_add(motion_straight(m), vec3_cross(motion_rotation(basis, m), arm));
}

// An impulse (N s) at `arm` (m, from the centre) changes a velocity m; an
// impulse times a time (kg m) changes a displacement.
void motion_push(motion *m, const motion_basis *basis, vec3 arm, vec3 impulse);

// A moment (N m s): likewise, without a way for the centre.
static inline void motion_twist(motion *m, const motion_basis *basis,
                                vec3 moment)
{
    for (int t = 0; t < TURNS; t++)
        m->of[MOTION_TURN + t] += vec3_dot(basis->turn[t], moment);
}

// What answers a unit impulse whose moments are those: 1/kg, or 1/(kg m^2); sum:
// what answers beside the turns of this body.
static inline real motion_answer(real sum, const motion_basis *basis,
                                 vec3 moment)
{
    for (int t = 0; t < TURNS; t++) {
        real row = vec3_dot(basis->turn[t], moment);
        sum += row * row;
    }
    return sum;
}

// Adds so many times v (m/s, or m) to the way of the centre.
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
// One that turns far goes in several moves, of this angle (rad) at most.  In more
// of them than MOTION_MOVES it turns less exactly: a wild spin must not make a
// frame last seconds.
static const real MOTION_FURTHEST = 1.0 / 3;        // tuned, rad
enum { MOTION_MOVES = 1000 };

// A body that stands as the frame says, and whose velocity in that basis is u,
// goes on freely for h (s).  Its angular momentum stays as the world sees it, so
// u changes: it is given in the new basis.  Exact for a body two of whose moments
// are alike; else of order 2, and symmetric in time: its energy does not drift.
void motion_advance(rigid_frame *frame, motion_basis *basis, motion *u, real h);

// The same body, displaced by d, as an impact or a cloth displaces it: its
// angular momentum stays, too.
void motion_displace(rigid_frame *frame, motion_basis *basis, motion *u,
                     const motion *d);

// Rounding bends a frame a little with every turn.  Its axes get their lengths
// and their right angles again, to the square of what they lacked.
void motion_straighten(const rigid4 *f, rigid_frame *frame);

// The end of a frame: the particles stand as the frame says, with the velocity u
// in its basis, written as `previous`, a substep of h (s) ago.
void motion_write(particle *p, const rigid_frame *frame,
                  const motion_basis *basis, const motion *u, real h);
//<

//> motion-frame-declare-inside
// Where a body stands that has been moved by d since it stood as the frame
// says.
rigid_frame motion_frame(const rigid_frame *frame, const motion_basis *basis,
                         const motion *d);
//<
