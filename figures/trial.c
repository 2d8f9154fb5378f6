// trial.c - runs a scene for a figure.

#define _POSIX_C_SOURCE 200809L

#include "trial.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// Other programs share the machine: their time is not ours.
static real cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

static int compare_real(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

static void raise(real *most, real value)
{
    if (!(value <= *most)) *most = value;
}

static void trial_steps(world *w, int steps, real *taken, trial *out)
{
    for (int k = 0; k < steps; k++) {
        real start = cpu_seconds();
        world_step(w);
        taken[k] = cpu_seconds() - start;
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
    scene s;
    int steps = (int)(seconds / how.dt + 0.5);
    *out = (trial){ .steps = 0 };
    status done = scene_build(&s, kind, what, how);
    if (!done.ok) return done;
    real *taken = malloc((size_t)(steps + 1) * sizeof *taken);
    if (taken) trial_steps(&s.world, steps, taken, out);
    else       done = status_out_of_memory();
    if (out->steps > 0) {
        qsort(taken, (size_t)out->steps, sizeof *taken, compare_real);
        out->ms = 1e3 * taken[out->steps / 2];
        out->relaxed /= out->steps;
        out->tested /= out->steps;
    }
    free(taken);
    scene_free(&s);
    return done;
}

void trial_print_head(const char *what, const char *flags, const char *columns)
{
    printf("# %s\n# compiler: %s\n# flags: %s\n%s\n", what, __VERSION__, flags,
           columns);
}
