// trial.h - a scene run from its start to its end, timed and measured: what
// the figures of chapter 9 are drawn from.

#ifndef TUMBLE_TRIAL_H
#define TUMBLE_TRIAL_H

#include "world_scene.h"

// Over all steps of a run.  A motion that grew beyond all numbers ends it.
typedef struct {
    int  steps;
    real ms;            // CPU time of a step, median
    real strain;        // largest, of stiff sticks
    real penetration;   // m, largest
    real relaxed, tested;   // sticks a step, mean
} trial;

// Fails as world_scene_build does.
status trial_run(scene_kind kind, scene_options what, world_options how,
                 real seconds, trial *out);

// The head of every CSV: what it is, which compiler, which flags.
void trial_print_head(const char *what, const char *flags,
                      const char *columns);

#endif
