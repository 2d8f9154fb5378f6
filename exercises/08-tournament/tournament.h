// tournament.h - the largest of many values, while they change.

#ifndef TUMBLE_TOURNAMENT_H
#define TUMBLE_TOURNAMENT_H

#include "ordering.h"

typedef struct {
    int   n;            // values
    int   leaves;       // a power of two, >= n and >= 1
    const real *value;  // [n] none is NaN
    int  *winner;       // [2 * leaves] see README.md
} tournament;

// Sets all winners.  The largest of all values is then value[winner[1]]
// (winner[1] = -1 if n is 0), the first of equals.
void tournament_begin(tournament *t);

// value[k] has changed.
void tournament_change(tournament *t, int k);

// Relaxes the most strained of n sticks, again and again, until that one is
// within options.tolerance or cannot move, or `most` have been relaxed.
// around: stick_lists_build(..., false) of the body, where the sticks of each
// particle stand first in its list.  strain[n] and t->winner are written on;
// t->n is n, and t->value is strain.  Result: relaxed, tested (strains that
// were measured), and worst, the largest strain at the end.
relax_result tournament_relax(tournament *t, real *strain,
                              const stick_lists *around, const stick *s,
                              particle *p, int most, relax_options options);

#endif
