// worlds.h - random worlds, each from a number, and what must hold in them.
//
// A trial is a world of a few bodies of any shape, mass, place and speed, with
// options from anywhere in their ranges.  Its seed says all: the same seed is
// the same trial on every machine.
//
// What must hold, whatever the options, shapes, places and speeds:
// - options within their ranges, and shapes, are accepted;
// - a body that was given numbers keeps them, whatever others were given;
// - in a room that six planes close no body's middle gets further out than its
//   radius (where it is thrown against a plane, it may overlap it for a while);
// - the motion of all bodies stays below a thousand times what their speeds,
//   gravity and the overlaps at the start can give.  Rigid bodies are pushed out
//   of those slowly, but particles of deformable bodies within a substep, so
//   that a cloth that is placed inside something flies off.
// What a frame may cost is fuzz_world.c's question.
// Units: metres, seconds, kilograms.

#ifndef TUMBLE_WORLDS_H
#define TUMBLE_WORLDS_H

#include "world.h"

enum {
    TRIAL_BODIES = 32,      // and at most so many shapes
    TRIAL_POINTS = 1600,    // vertices of a body, at most
    TRIAL_TEXT = 240
};

// What did not hold.
typedef enum {
    TRIAL_WELL,
    TRIAL_REFUSED,          // options within the ranges, a shape, or memory
    TRIAL_NOT_NUMBERS,      // a body that was given numbers has some no longer
    TRIAL_OUTSIDE,          // a body has left a closed room
    TRIAL_TOO_FAST          // more motion than anything can have caused
} trial_fault;

typedef struct {
    world world;
    shape shape[TRIAL_BODIES];
    int   shapes;
    bool  is_spoiled[TRIAL_BODIES]; // it was given a velocity that is no number
    int   spoil_step, spoil_first, spoil_count; // when, and which bodies
    real  spoil_with;       // NaN or an infinity
    bool  is_closed;        // six planes make a cube of half side `room`, m
    real  room;
    bool  has_soft;         // it may have deformable bodies
    real  heat;             // J, more motion than this has no cause
    vec3  middle[TRIAL_BODIES];     // m, of each body after the last step
    int   points[TRIAL_BODIES];     // of its shape
    real  radius[TRIAL_BODIES];     // m
    real  mass[TRIAL_BODIES];       // kg; 0: static
    unsigned long long seed, state;
    int   step;             // so many were taken
    char  what[TRIAL_TEXT]; // the trial in a line
    trial_fault fault;      // the first one
    char  why[TRIAL_TEXT];  // the same in words
} trial;

// Makes the world of this seed, ready to step.
trial_fault trial_make(trial *t, unsigned long long seed);

// One step of the world, which is looked at from outside.
trial_fault trial_step(trial *t);

// At any time after trial_make.
void trial_free(trial *t);

#endif
