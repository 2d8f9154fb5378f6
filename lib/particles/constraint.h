//> constraint-head
// constraint.h - sticks: two particles at a fixed distance.
//
// Paper: section 3.2.  Book: chapter 2.
// Units: metres, inverse masses in 1/kg, strain without unit (error / length).

#ifndef TUMBLE_CONSTRAINT_H
#define TUMBLE_CONSTRAINT_H

#include "verlet.h"

typedef enum {
    STICK_EXACT,    // distance = rest_length
    STICK_AT_LEAST, // distance >= rest_length
    STICK_AT_MOST   // distance <= rest_length
} stick_kind;

// a and b count from the first particle of the body that owns the stick.
typedef struct stick {
    int  a, b;
    real rest_length;  // m, > 0
    real stiffness;    // share of its error that one relaxation corrects: 1 for
                       // a stick, in (0, 1) for a soft one (a cloth's diagonal)
    stick_kind kind;
} stick;
//<

//> constraint-options
typedef enum {
    ROOT_EXACT,        // sqrt
    ROOT_APPROXIMATE   // Jakobsen: one Newton step from the rest length
} root_kind;

typedef enum {
    GRADIENT_NEW,      // along the stick as it lies now (Jakobsen 2001)
    GRADIENT_OLD       // as it lay one step ago (SHAKE, Ryckaert 1977)
} gradient_kind;

typedef struct {
    root_kind     root;      // for GRADIENT_NEW; GRADIENT_OLD needs no root
    gradient_kind gradient;
    real          tolerance; // strain that counts as satisfied
    int           dead_band; // 1: a stick within tolerance is left alone (the
                             // paper's way); 0: every stick is relaxed
} relax_options;

// What one relaxation did.
typedef struct {
    real error;         // m, signed length error BEFORE (> 0: too long);
                        // 0 where a one-sided stick is content, HUGE_VAL for
                        // NaN
    int  moved;         // 0 if satisfied, or nothing could move
} stick_result;

// What one sweep, or several, did.  Where no root is taken (ROOT_APPROXIMATE,
// GRADIENT_OLD) error / rest_length is measured as (d^2 - L^2) / (2 L^2), which
// is e + e^2 / 2 for a strain e.
typedef struct {
    real worst;         // largest |error| / rest_length met, BEFORE relaxing;
                        // of several sweeps, in the last; HUGE_VAL for NaN
    int  tested;        // sticks looked at
    int  relaxed;       // sticks moved
    int  sweeps;        // sweeps done
    int  fell_back;     // GRADIENT_OLD failed and GRADIENT_NEW finished
} relax_result;
//<

//> constraint-declare
// Gradient at the new positions, exact root, no dead band, tolerance 1e-4.
relax_options relax_options_default(void);

// Moves both ends of s until it has its rest length again (to first order in
// the error for ROOT_APPROXIMATE and GRADIENT_OLD), each end in proportion to
// its inverse mass, so that the centre of mass stays.  Never fails: coincident
// or nailed ends have nowhere to go, moved = 0.
stick_result stick_relax(stick s, particle *p, relax_options options);

// The strain of s: |length - rest_length| / rest_length, 0 where a one-sided
// stick is satisfied.
real stick_strain(stick s, const particle *p);
//<

//> sweep-declare
// Relaxes sticks 0 to n-1 once, in that order.
relax_result sticks_sweep(const stick *s, int n, particle *p,
                          relax_options options);

// Sweeps until a sweep meets no strain above options.tolerance, at most
// max_sweeps times.  With GRADIENT_OLD, scratch holds particle_count positions
// (may be NULL otherwise): if the residual after the last sweep exceeds 1e-3
// (or the tolerance, where that is larger), or is not finite, the positions of
// the call are restored and solved with GRADIENT_NEW (result: fell_back = 1).
// Soft sticks do not count here: they are not asked to hold.
relax_result sticks_relax(const stick *s, int n, particle *p,
                          int particle_count, int max_sweeps,
                          relax_options options, vec3 *scratch);

// Makes n sticks keep the length that they have: takes from their ends the part
// of their speeds that would change it, each end in proportion to its inverse
// mass, by moving `previous` alone.  One sweep; linear and angular momentum
// stay.  Soft and one-sided sticks, and those without length, are left out.
void sticks_sweep_speeds(const stick *s, int n, particle *p);

// Reorders n sticks so that neighbours in the list share no particle where that
// can be had (a greedy colouring): a processor then works on several at once.
// Stable within a colour, so the result is the same everywhere.
// Fails, and leaves the order as it was, if a stick has no such ends or memory
// is refused.
status sticks_interleave(stick *s, int n, int particle_count);
//<

//> angle-declare
// Two sticks from one corner, held at an angle theta: C = 0, where
// C = (u . v) / (|u| |v|) - cos theta, u = a - corner, v = b - corner.
typedef struct angle {
    int  a, corner, b;
    real cosine;        // cos theta, in [-1, 1]
    real stiffness;     // share of the error that one relaxation corrects
} angle;

// Turns both arms, and the corner, until C = 0 to first order, by at most about
// one radian.  Centre of mass and angular momentum stay.  error: C, without
// unit.  An arm without length, or arms in one line, have no side to turn to:
// moved = 0.
stick_result angle_relax(angle c, particle *p);
//<

//> bend-declare
// Two triangles (a, b, c) and (b, a, d) that share the edge a b, pulled flat.
// Flat, the lines a b and c d cross, in a point that both lines can name:
// u a + (1 - u) b = v c + (1 - v) d.  weight holds u, 1 - u, -v, -(1 - v).
typedef struct {
    int  at[4];         // a, b, c, d
    real weight[4];     // without unit; their sum is 0
    real stiffness;     // share of the error that one relaxation corrects
} bend;

// The bend of these four particles as they lie now.  A rope bends at m between
// c and d: at = { m, m, c, d }.  Fails if the lines a b and c d run alike, or a
// position is not finite: then *b is left as it was.
status bend_make(bend *b, const int at[4], const particle *p, real stiffness);

// Moves all four until both lines cross again.  Centre of mass and angular
// momentum stay.  error: m, the gap between the two points, never negative.
stick_result bend_relax(bend b, particle *p);

#endif
//<
