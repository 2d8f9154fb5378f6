//> impact-head
// impact.h - rows that push bodies apart, and the impulses that stop them at once.
//
// Paper: not asked.  Book: chapter 15.
// Units: metres, kilograms, seconds.

#pragma once

#include "motion.h"
//<

//> impact-declare
//>   A row of the Jacobian. The rows of an impact have K = J M^-1 J^T, whose
//>   element i, j says how fast a unit impulse along row j parts the bodies of
//>   row i.
// The two bodies of a contact: a plane is a B that does not move.
enum { A, B, BODIES };

typedef struct {
    vec3 along;                     // from B to A
    int  body[BODIES];              // numbers of velocities; B < 0: none
    real inverse[BODIES];           // 1/kg; 0: it yields to no push
    real turn[BODIES][TURNS];       // kg^(-1/2)
} impact_row;

// m/s, how fast A and B part along a row; < 0: they close.
real impact_parting(const impact_row *r, const motion *velocity);

// How fast a unit impulse along one parts those of the other.
real impact_product(const impact_row *r, const impact_row *s);

void impact_push(const impact_row *r, real impulse, motion *velocity);

// At most so many rows are stopped together.
enum { IMPACT_ROWS = 64 };

typedef struct {
    int  rows, count, good;         // rows; of these in the set; of these factored
    impact_row row[IMPACT_ROWS];
    real part[IMPACT_ROWS];         // m/s, how it parts without any impulse
    real impulse[IMPACT_ROWS], given[IMPACT_ROWS];      // N s
    int  set[IMPACT_ROWS];          // the rows that push
    real k[IMPACT_ROWS][IMPACT_ROWS], l[IMPACT_ROWS][IMPACT_ROWS];
    real d[IMPACT_ROWS], y[IMPACT_ROWS], stop[IMPACT_ROWS];
} impact_set;

static inline void impact_begin(impact_set *w)
{
    w->rows = w->count = w->good = 0;
}

// Adds a row that parts at this speed now (m/s), after what has been given so far.
// Requires: w->rows < IMPACT_ROWS.
void impact_add(impact_set *w, const impact_row *r, real parting);

// The impulses >= 0 that leave no row closing, to rounding: none that pushes parts,
// and the energy is the least that there is.
void impact_stop(impact_set *w);

// The velocities get what impulses have changed by since they were given last.
void impact_apply(impact_set *w, motion *velocity);
//<
