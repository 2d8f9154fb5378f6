// trial.c - runs a scene for a figure.

#include "trial.h"
#include "clock.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

static void raise(real *most, real value)
{
    if (!(value <= *most)) *most = value;
}

static void trial_steps(world *w, int steps, real *taken, trial *out)
{
    for (int k = 0; k < steps; k++) {
        real start = clock_seconds();
        world_step(w);
        taken[k] = clock_seconds() - start;
        measures m = world_measure(w);
        if (!(m.kinetic - m.kinetic == 0)) break;
        raise(&out->strain, m.strain);
        raise(&out->penetration, m.penetration);
        out->relaxed += (real)w->report.relaxed;
        out->tested += (real)w->report.tested;
        out->steps++;
    }
}

status trial_run(scene_kind kind, scene_options what, world_options how,
                 real seconds, trial *out)
{
    world_scene s;
    int steps = (int)(seconds / how.dt + 0.5);
    *out = (trial){ .steps = 0 };
    status done = world_scene_build(&s, kind, what, how);
    if (!done.ok) return done;
    real *taken = malloc((size_t)(steps + 1) * sizeof *taken);
    if (taken) trial_steps(&s.world, steps, taken, out);
    else       done = status_out_of_memory();
    if (out->steps > 0) {
        out->ms = 1e3 * clock_median(taken, out->steps);
        out->relaxed /= out->steps;
        out->tested /= out->steps;
    }
    free(taken);
    world_scene_free(&s);
    return done;
}

void trial_print_head(const char *what, const char *flags, const char *columns)
{
    printf("# %s\n# compiler: %s\n# flags: %s\n%s\n", what, __VERSION__, flags,
           columns);
}
