// battery.h - what the ledger runs at half and at double of a number: short
// scenes, one of each family, through tumble.h, at its defaults.
//
// Units: metres, kilograms, seconds, radians.

#ifndef TUMBLE_BATTERY_H
#define TUMBLE_BATTERY_H

#include "example.h"

// A scene that is running.
typedef struct {
    tumble_world *w;
    unsigned long long bits;    // of all positions after every step
    double worst;               // the error, so far
} battery_run;

// Steps for so many seconds, and gathers the bits.
void battery_step(battery_run *r, double seconds);

// An error that was seen: the largest counts; what is no number is the worst.
void battery_see(battery_run *r, double error);

// Each builds itself in r->w, steps, and says how wrong it is.
typedef struct {
    const char *name, *what, *unit;
    double fine;                // no error that matters is smaller
    void (*run)(battery_run *r);
} battery_scene;

// Their ends have no name.
extern const battery_scene battery_rigid[], battery_held[], battery_soft[];

#endif
