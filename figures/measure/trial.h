// trial.h - a scene run from its start to its end, timed and measured: what
// the figures of chapter 9 are drawn from.

#ifndef TUMBLE_TRIAL_H
#define TUMBLE_TRIAL_H

#include "runner.h"

// Over all steps of a run.  A motion that grew beyond all numbers ends it.
typedef struct {
    int  steps;
    real ms;            // CPU time of a step, median
    real slowest;       // ms, the slowest step
    real strain;        // largest, of stiff sticks
    real penetration;   // m, largest: in each other, in walls, cloth in cube
    real at_rest;       // m, the same in the last two seconds
    real kinetic;       // J, mean of the last two seconds
    int  outside;       // bodies whose middle is outside the room, at the end
    real relaxed, tested;   // distance constraints a step, mean
} trial;

// Steps r for so long, and frees it; for a quarter of that if the environment
// has TUMBLE_QUICK, as make 09 and make demo set it.
void trial_run(runner *r, real seconds, trial *out);

// Builds a scene with this kind of runner, and runs it.  Fails as runner_begin
// does.
status trial_of(runner_kind kind, scene_kind which, scene_options what,
                real seconds, trial *out);

// The head of every CSV: what it is, which compiler, which flags.
void trial_print_head(const char *what, const char *flags,
                      const char *columns);

#endif
