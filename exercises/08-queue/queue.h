// queue.h - sticks that wait in line to be looked at.

#ifndef TUMBLE_QUEUE_H
#define TUMBLE_QUEUE_H

#include "ordering.h"

typedef struct {
    int relaxed;        // sticks moved
    int tested;         // sticks looked at
} queue_result;

// Relaxes the sticks of particle `from`, those around a stick that moved, and
// so on, until all that waited are within tolerance (of strain, >= 0) or budget
// sticks have been relaxed, by relax_options_pbd().  sticks_at: for each
// particle its own sticks (no others).  line[n] and waits[n] are written on.
queue_result queue_relax(const stick *s, int n, particle *p,
                         const stick_lists *sticks_at, int from,
                         real tolerance, int budget, int *line, char *waits);

#endif
