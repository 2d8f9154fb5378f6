// trial.c - runs a scene for a figure.

#include "trial.h"
#include "clock.h"

#include <stdio.h>
#include <stdlib.h>

static const real LAST = 2;     // s, that show what is left at rest

// A reader who looks through a chapter (make 09) waits for a quarter of each run
// only; the book's figures (make figure-09) are of whole ones.
static real whole_or_quarter(real seconds)
{
    return getenv("TUMBLE_QUICK") ? seconds / 4 : seconds;
}

static void raise(real *most, real value)
{
    if (!(value <= *most)) *most = value;
}

// Measures the step that was just taken; false if it has grown beyond all
// numbers.
static bool look(runner *r, bool is_last, real share, trial *out)
{
    measures m = runner_measure(r);
    if (!(m.kinetic - m.kinetic == 0)) return false;
    raise(&out->strain, m.strain);
    raise(&out->penetration, m.penetration);
    out->relaxed += (real)r->relaxed;
    out->tested += (real)r->tested;
    out->steps++;
    if (!is_last) return true;
    raise(&out->at_rest, m.penetration);
    out->kinetic += share * m.kinetic;
    return true;
}

void trial_run(runner *r, real seconds, trial *out)
{
    real dt = r->kind == BY_ENGINE ? r->world.options.dt : r->plain.options.dt;
    int steps = (int)(whole_or_quarter(seconds) / dt + 0.5);
    int last = (int)(LAST / dt + 0.5);
    real *taken = malloc((size_t)(steps + 1) * sizeof *taken);
    *out = (trial){ .steps = 0 };
    for (int k = 0; k < steps && taken; k++) {
        real start = clock_seconds();
        runner_step(r);
        taken[k] = clock_seconds() - start;
        raise(&out->slowest, 1e3 * taken[k]);
        if (!look(r, k >= steps - last, 1.0 / last, out)) break;
    }
    if (out->steps > 0) {
        out->ms = 1e3 * clock_median(taken, out->steps);
        out->relaxed /= out->steps;
        out->tested /= out->steps;
        out->outside = runner_poses(r).outside;
    }
    free(taken);
    runner_free(r);
}

status trial_of(runner_kind kind, scene_kind which, scene_options what,
                real seconds, trial *out)
{
    runner r;
    status done = runner_begin(&r, kind, which, what);
    if (done.ok) trial_run(&r, seconds, out);
    return done;
}

void trial_print_head(const char *what, const char *flags, const char *columns)
{
    printf("# %s\n# compiler: %s\n# flags: %s\n%s\n", what, __VERSION__, flags,
           columns);
}
