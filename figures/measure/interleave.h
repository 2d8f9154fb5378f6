// interleave.h - sticks in an order in which neighbours share no particle, for
// figures that measure what this is worth.

#ifndef TUMBLE_INTERLEAVE_H
#define TUMBLE_INTERLEAVE_H

#include "constraint.h"

#include <stdlib.h>
#include <string.h>

// Reorders n sticks between particle_count particles: round after round takes
// every stick that shares no particle with another taken in the round (a greedy
// colouring).  False if memory is refused; then the order is as it was.
static inline bool interleave(stick *s, int n, int particle_count)
{
    stick *sorted = malloc((size_t)(n + 1) * sizeof *sorted);
    int *taken_in = calloc((size_t)(particle_count + 1), sizeof *taken_in);
    int done = 0, waiting = n;
    if (!sorted || !taken_in) {
        free(sorted);
        free(taken_in);
        return false;
    }
    memcpy(sorted, s, (size_t)n * sizeof *s);
    for (int round = 1; waiting > 0; round++) {
        int kept = 0;
        for (int i = 0; i < waiting; i++) {
            int *a = &taken_in[s[i].a], *b = &taken_in[s[i].b];
            if (*a == round || *b == round) {
                s[kept++] = s[i];
            } else {
                *a = *b = round;
                sorted[done++] = s[i];
            }
        }
        waiting = kept;
    }
    memcpy(s, sorted, (size_t)n * sizeof *s);
    free(sorted);
    free(taken_in);
    return true;
}

#endif
