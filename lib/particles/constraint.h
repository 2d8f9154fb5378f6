//> constraint-head
// constraint.h - distance constraints ("sticks") and angle constraints.
//
// Paper: section 3.2, "linear constraints".  Book: chapter 2.
// Units: metres, inverse masses in 1/kg, strain without unit (error / length).

#pragma once

#include <stdbool.h>

#include "verlet.h"

typedef enum {
    STICK_EXACT,    // an equality:   distance = rest_length
    STICK_AT_LEAST, // an inequality: distance >= rest_length
    STICK_AT_MOST   // an inequality: distance <= rest_length
} stick_kind;

// a and b count from the first particle of the body that owns the stick.
typedef struct stick {
    int  a, b;
    real rest_length;  // m, > 0
    real stiffness;    // fraction of its error that one relaxation corrects: 1
                       // for a stick, less for a soft one (a cloth's diagonal),
                       // more than 1 for over-relaxation
    stick_kind kind;
} stick;
//<

//> constraint-options
// Along which line is a stick corrected?
typedef enum {
    GRADIENT_NEW,      // along the stick as it lies now (PBD, Jakobsen 2001)
    GRADIENT_OLD       // as it lay one step ago (SHAKE, Ryckaert 1977)
} gradient_kind;

// How is its length computed?  GRADIENT_OLD needs no root.
typedef enum {
    ROOT_EXACT,        // sqrt
    ROOT_APPROXIMATE   // one Newton step from the rest length (Jakobsen)
} root_kind;

typedef struct {
    root_kind     root;
    gradient_kind gradient;
    real          tolerance; // strain at which a stick counts as satisfied
    bool          dead_band; // true: a satisfied stick is not corrected (as in
                             // the paper; engines call the tolerance slop)
} relax_options;
//<

//> constraint-results
// What one relaxation did.
typedef struct {
    real error;         // m, signed length error BEFORE (> 0: too long); 0 for
                        // a satisfied inequality, HUGE_VAL for NaN
    bool moved;         // false if satisfied, or if nothing could move
} stick_result;

// What one iteration, or several, did.  With ROOT_APPROXIMATE and GRADIENT_OLD
// the strain is measured as (d^2 - L^2) / (2 L^2), which needs no root and is
// e + e^2 / 2 for a strain e.
typedef struct {
    real worst;         // largest strain met, each BEFORE its correction; of
                        // several iterations, in the last; HUGE_VAL for NaN
    int  tested;        // sticks looked at
    int  relaxed;       // sticks moved
    int  iterations;    // iterations done
} relax_result;
//<

//> constraint-declare
// Both: exact root, no dead band, tolerance 1e-4.  The default is SHAKE: the
// gradient at the old positions, which keeps angular momentum.  It needs the
// positions of one step ago in `previous`.
relax_options relax_options_default(void);
// PBD: the gradient at the new positions.  It needs no `previous`, and brakes.
relax_options relax_options_pbd(void);

// Moves both ends of s until it has its rest length again (to first order in
// the error for ROOT_APPROXIMATE and GRADIENT_OLD), each end in proportion to
// its inverse mass, so that the centre of mass stays.  Never fails: a stick
// with coincident ends, or with both ends pinned, is not moved.
stick_result stick_relax(stick s, particle *p, relax_options options);

// The strain of s: |length - rest_length| / rest_length, 0 for a satisfied
// inequality, HUGE_VAL for NaN.
real stick_strain(stick s, const particle *p);
//<

//> iterate-declare
// One iteration: relaxes sticks 0 to n-1 once, in that order, so that each
// sees what those before it did (nonlinear Gauss-Seidel).
relax_result sticks_iterate(const stick *s, int n, particle *p,
                            relax_options options);

// Iterates until an iteration meets no strain above options.tolerance, at most
// most_iterations times.  If the worst strain of the result is larger, the
// sticks are not solved: too few iterations, sticks that contradict each other,
// or with GRADIENT_OLD a stick that turned too far in one step.
relax_result sticks_relax(const stick *s, int n, particle *p,
                          int most_iterations, relax_options options);
//<

//> angle-declare
//>   An angle between two sticks from one corner: $`u \cdot v = \cos\theta`$,
//>   for unit vectors along the arms.
// Two sticks from one corner, held at an angle theta: C = 0, where
// C = (u . v) / (|u| |v|) - cos theta, u = a - corner, v = b - corner.
typedef struct angle {
    int  a, corner, b;
    real cosine;        // cos theta, in [-1, 1]
    real stiffness;     // fraction of the error that one relaxation corrects
} angle;

// Turns both arms, and the corner, until C = 0 to first order, by at most about
// one radian.  The centre of mass and the angular momentum stay.  The error of
// the result is C, without unit.  Nothing moves if an arm has no length (error
// 0) or if the arms lie in one line, where no side to turn to is preferred.
stick_result angle_relax(angle c, particle *p);
//<
