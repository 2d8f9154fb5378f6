//> impact-head
// impact.h - the least impulses that stop several closing rows at once.
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
    int  body[BODIES];              // their velocities, by number; B < 0: none
    real inverse[BODIES];           // 1/kg; 0: immovable
    real turn[BODIES][TURNS];       // kg^(-1/2)
} impact_row;

// m/s, how fast A and B part along a row; < 0: they close.
real impact_parting(const impact_row *r, const motion *velocity);

// 1/kg, the speed along one row that a unit impulse along the other gives.
real impact_product(const impact_row *r, const impact_row *s);

void impact_push(const impact_row *r, real impulse, motion *velocity);

// The most rows that are stopped together.
enum { IMPACT_ROWS = 64 };

typedef struct {
    int  rows, count, good;         // rows; those in the set; those factored
    impact_row row[IMPACT_ROWS];
    real part[IMPACT_ROWS];         // m/s, how fast it parts without impulses
    real impulse[IMPACT_ROWS], given[IMPACT_ROWS];      // N s
    int  set[IMPACT_ROWS];          // the rows that push
    real k[IMPACT_ROWS][IMPACT_ROWS], l[IMPACT_ROWS][IMPACT_ROWS];
    real d[IMPACT_ROWS], y[IMPACT_ROWS], stop[IMPACT_ROWS];
} impact_set;

static inline void impact_begin(impact_set *w)
{
    w->rows = w->count = w->good = 0;
}

// Adds a row that parts at this speed (m/s) after the impulses given so far.
// Requires: w->rows < IMPACT_ROWS.
void impact_add(impact_set *w, const impact_row *r, real parting);

// Finds impulses >= 0 after which no row closes, to rounding.  A row with an impulse
// does not part either, so the energy is the least possible.
void impact_stop(impact_set *w);

// Gives the velocities what impulses have changed by since they were last applied.
void impact_apply(impact_set *w, motion *velocity);
//<
