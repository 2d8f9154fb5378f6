// hard_judge.h - cloth and rope on their way, judged from outside.
//
// Every frame is looked at.  All comes from positions, and from the clock: the
// library is not asked what it thinks of itself.
// Units: metres, seconds.

#ifndef TUMBLE_HARD_JUDGE_H
#define TUMBLE_HARD_JUDGE_H

#include "crossings.h"
#include "world.h"

// What was found at worst, over all frames of all runs that were watched.
typedef struct {
    real strain;        // of a stick that is to hold, in any frame
    real must;          // what springs, pulled as hard, are stretched by; 0:
                        // it must not be strained
    real off;           // between the two, in one run
    real end;           // in the last frame
    real rest;          // in the last second
    long crossings;     // pairs of triangles, most in a frame
    long inside;        // particles in a rigid body, most in a frame
    long cutting;       // triangles that cut one
    long edges;         // edges of one that pass through a triangle
    real depth;         // m, of the deepest particle
    real speed;         // m/s, of a particle of a cloth or rope, from frame to
                        // frame, in the last second
    int  passed;        // bodies that ended below the floor of watch
    real mean, median, slowest;     // s, a frame
    real substeps;      // a frame, the mean
    int  frames, runs;
} verdict;

// How long; the height that the middle of no moving body may end below, for then
// it has come through what it was to stay on, or has slid off it (-HUGE_VAL: no
// height); and the number of frames, the first ones, in which cloth and rope are
// slowed by 5 % a frame, so that what moves later does not swing on, but is
// shaken.
typedef struct {
    int  frames;
    real floor;         // m
    int  calmed;
} watch_plan;

// Lets a world that has begun run, and adds what is seen to *v, which begins as
// zeros.  False if memory is refused.
bool judge_watch(world *w, watch_plan plan, verdict *v);

// Looks once, as the world stands: no time, no speed, no end.
bool judge_look(const world *w, verdict *v);

// The rigid body of that number, as it stands.
void judge_solid(const world *w, int number, solid *out);

#endif
