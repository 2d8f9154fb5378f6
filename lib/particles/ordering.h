//> ordering-head
// ordering.h - which stick first?
//
// Paper: section 6.2.  Book: chapter 8.
// Particles and sticks count from the first of their body.

#ifndef TUMBLE_ORDERING_H
#define TUMBLE_ORDERING_H

#include "constraint.h"

typedef enum {
    ORDER_LISTED,       // as the shape lists them (Jakobsen)
    ORDER_BREADTH,      // by distance from the particle that moved most
    ORDER_REPEATED,     // the same, near sticks repeated (the paper)
    ORDER_WORK_LIST,    // only sticks with an end that moved
    ORDER_LARGEST       // the most violated next (Southwell)
} order_kind;

// For every particle v of a shape its list of sticks:
// stick[start[v]] .. stick[start[v + 1] - 1].
typedef struct {
    int  particles;
    int *start, *stick;
} stick_lists;
//<

//> ordering-declare
// The lists, sticks in increasing distance (steps in the constraint graph) from
// v; of equal distance in the order of the shape.  A stick with an end at v has
// distance 1; one that no path reaches stands last.  repeated: a stick of
// distance k from v stands max(1, n / 2^(k - 1)) times (rounded down), n the
// largest distance: neighbours n times, theirs n/2 times.  The repeats stand in
// n rounds, distance 1 in every round, 2 in every second, 3 in every fourth: a
// stick relaxed twice in a row would gain nothing.
// Fails, leaving *l empty, if a stick has no such ends, the lists would hold
// more numbers than fit in INT_MAX bytes, or memory is refused.
// The lists hold particles * sticks numbers or more: meant for rigid bodies.
status stick_lists_build(stick_lists *l, const stick *s, int sticks,
                         int particles, int repeated);
void   stick_lists_free(stick_lists *l);

// The particle of n whose position lies furthest from before[]; lowest index of
// equals; -1 if none moved.
int most_moved(const particle *p, const vec3 *before, int n);
//<

//> ordering-declare-from
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

//> ordering-declare-relax
// What ORDER_WORK_LIST and ORDER_LARGEST write on, for bodies of at most that
// many sticks (and particles at most twice as many: each on a stick).  NULL if
// memory is refused.  One for each thread that relaxes.
typedef struct order_scratch order_scratch;
order_scratch *order_scratch_new(int sticks);
void           order_scratch_free(order_scratch *scratch);

// Relaxes until every stick is within options.tolerance, or max_sweeps times
// the number of sticks have been relaxed, or nothing more can move.
// from: the particle that moved most (-1: none, then in the shape's order).
// lists: with repeated = 1 for ORDER_REPEATED; with repeated = 0 for
// ORDER_BREADTH, for ORDER_WORK_LIST, and for ORDER_LARGEST, which looks up
// there which sticks share a particle.  ORDER_LISTED reads none (NULL).
// scratch: for the last two, else NULL.  GRADIENT_OLD does not fall back here.
// options.dead_band: the first three orders relax every stick of a sweep, or
// only those beyond the tolerance; the last two never relax any other.
// Result: worst is the largest strain that the last look at each stick met, so
// worst <= tolerance says that all is well; tested counts every look.
relax_result sticks_relax_ordered(order_kind kind, const stick_lists *lists,
                                  const stick *s, int n, particle *p,
                                  int particles, int from, int max_sweeps,
                                  relax_options options,
                                  order_scratch *scratch);

#endif
//<
