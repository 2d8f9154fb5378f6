// clock.h - how long does it take, on a machine that others use as well?
//
// Processor time, not the time on the wall: other programs are not our matter.
// But they still empty our caches and slow the clock down, for a second or a
// minute.  So what is to be compared takes turns, in rounds: what disturbs a
// round disturbs all of it.

#ifndef TUMBLE_CLOCK_H
#define TUMBLE_CLOCK_H

#include "vec3.h"

// s, of this process, from some moment on.
real clock_seconds(void);

// The median of n numbers, which are sorted by it; 0 of none.
real clock_median(real *x, int n);

enum { CLOCK_WAYS = 64, CLOCK_ROUNDS = 32 };

typedef struct {
    int  ways;          // how many ways there are, 1 to CLOCK_WAYS
    int  rounds;        // each is timed so often, 1 to CLOCK_ROUNDS
    real slice;         // s, and at least that long in a round: short work is
                        // repeated; 0: never
    void (*work)(int way, void *with);
    void *with;
} race;

typedef struct {
    real seconds;       // of one call of work, the median over the rounds
    real ratio;         // to the first way, the median over the rounds
} lap;

// Runs every way, to warm up, and then in rounds: all of them in each, in an
// order that changes.
void clock_race(race r, lap *out);

// s, by which a curve of n points (time, error) comes down to an error: on
// straight lines between the points, both scales logarithmic.  HUGE_VAL: never.
real clock_at_error(const real *seconds, const real *error, int n,
                    real wanted);

// The head of a CSV: what it is, which compiler, flags and processor.
void clock_print_head(const char *what, const char *flags);

// A line of the table that `make speed` prints, as a comment of the CSV:
// what was compared, at which error, the best, and how many times as long the
// other takes.
void clock_print_row(const char *module, const char *what, const char *error,
                     const char *best, const char *other, real ratio);

#endif
