// 09-order.c - Figure 9 c of the paper: relaxations a step against number of
// bodies, for every order of relaxation, in the paper's own scene and way.

#include "trial.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const struct { order_kind kind; const char *name; } order[] = {
    { ORDER_LISTED, "listed" }, { ORDER_BREADTH, "breadth" },
    { ORDER_REPEATED, "repeated" }, { ORDER_WORK_LIST, "work list" },
    { ORDER_LARGEST, "largest first" }
};

static int print_run(int bodies, int k)
{
    scene_options what = scene_options_default();
    world_options how = world_options_paper();
    trial t;
    what.bodies = bodies;
    how.order = order[k].kind;
    status done = trial_run(SCENE_ROOM, what, how, 10, &t);
    if (!done.ok) {
        fprintf(stderr, "09-order: %s\n", done.why);
        return 0;
    }
    printf("%s,%d,%.5g,%.5g,%.4g,%.4g\n", order[k].name, bodies, t.relaxed,
           t.tested, t.ms, 100 * t.strain);
    return 1;
}

int main(void)
{
    trial_print_head("room, the paper's way, 10 s at dt = 1/60 s, tolerance "
                     "1 %: sticks relaxed and tested a step (mean), ms a step "
                     "(median), largest strain after relaxation (%)", FLAGS,
                     "order,bodies,relaxed,tested,ms,strain");
    for (int k = 0; k < (int)(sizeof order / sizeof *order); k++) {
        for (int bodies = 10; bodies <= 100; bodies += 10)
            if (!print_run(bodies, k)) return 1;
        printf("\n\n");
    }
    return 0;
}
