//> ordering-head
// ordering.h - which constraint first?
//
// Paper: section 6.2.  Book: chapter 8.
// Particles and sticks (distance constraints) count from the first of their
// body.

#pragma once

#include "constraint.h"

// For every particle v of a body its list of sticks:
// stick[start[v]] .. stick[start[v + 1] - 1].
typedef struct {
    int  particles;
    int *start, *stick;
} stick_lists;
//<

//> ordering-declare
//>   Building the lists, freeing them, and finding the particle that moved
//>   most: that is all the book-keeping.
// The lists: sticks in increasing distance from v in the constraint graph; of
// equal distance in the order of the body.  A stick with an end at v has
// distance 1, its neighbours 2, and so on; one that no path reaches stands
// last.  repeated: a stick of distance d stands max(1, n / 2^(d - 1)) times
// (rounded down), n being the largest distance. Requires: every stick joins two
// particles from 0 to particles - 1. Fails, leaving *l empty, if memory is
// refused or the lists would hold more numbers than an int can count.  They
// hold particles * sticks numbers, or more: meant for rigid bodies.
status stick_lists_build(stick_lists *l, const stick *s, int sticks,
                         int particles, bool repeated);
void   stick_lists_free(stick_lists *l);

// The particle of n whose position lies furthest from before[]; the lowest
// index of equals; -1 if none moved.
int most_moved(const particle *p, const vec3 *before, int n);
//<

//> ordering-declare-relax
//>   Now two ways to relax.
// Goes through the list of particle `from` again and again, and relaxes each
// stick that it names, until every stick is within options.tolerance, none can
// move, or max_iterations are done.  from = -1: the order of the body; then l
// may be NULL.  With options.dead_band, a stick within the tolerance is left.
// Result: worst is the largest strain that the last iteration met.
relax_result sticks_relax_from(const stick_lists *l, int from,
                               const stick *s, int n, particle *p,
                               int max_iterations, relax_options options);

// Relaxes the most violated of n sticks, again and again (Southwell), until
// that one is within options.tolerance or cannot move, or max_iterations * n
// have been relaxed.  Slow: every relaxation looks at all n.
relax_result sticks_relax_largest(const stick *s, int n, particle *p,
                                  int max_iterations, relax_options options);
//<
