// 09-order.c - Figure 9 c of the paper: relaxations a step against number of
// bodies, in its own room and way: as listed, and by its ordered lists.

#include "trial.h"

#include <math.h>
#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SIZES = 10 };

static const char *const name[] = { "listed", "ordered" };

static int run_and_print(int ordered, int bodies, trial *t)
{
    scene_options what = scene_options_default();
    system_options how = system_options_printed();
    runner r;
    what.bodies = bodies;
    how.ordered = ordered;
    status done = runner_begin_system(&r, AS_PRINTED, SCENE_ROOM, what, how);
    if (!done.ok) {
        fprintf(stderr, "09-order: %s\n", done.why);
        return 0;
    }
    trial_run(&r, 10, t);
    printf("%s,%d,%.5g,%.5g,%.4g,%.4g\n", name[ordered], bodies, t->relaxed,
           t->tested, t->ms, 100 * t->strain);
    return 1;
}

int main(void)
{
    static trial t[2][SIZES];
    trial_print_head("room as printed, 10 s at dt = 1/60 s, tolerance 1 %: "
                     "constraints relaxed and looked at a step (mean), ms a "
                     "step (median), largest strain (%)", FLAGS,
                     "order,bodies,relaxed,tested,ms,strain");
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < SIZES; i++)
            if (!run_and_print(k, 10 * (i + 1), &t[k][i])) return 1;
        printf("\n\n");
    }
    real least = HUGE_VAL, most = 0, relaxed = 0, tested = 0;
    for (int i = 0; i < SIZES; i++) {
        real share = t[1][i].relaxed / t[0][i].relaxed;
        least = fmin(least, share);
        most = fmax(most, share);
        relaxed += share / SIZES;
        tested += t[1][i].tested / t[0][i].tested / SIZES;
    }
    printf("#shares| \"relaxed, least to most\",\"relaxed, mean\","
           "\"looked at, mean\"\n#shares| %.2f to %.2f,%.2f,%.2f\n", least,
           most, relaxed, tested);
    return 0;
}
