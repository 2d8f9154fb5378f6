// 09-order.c - Figure 9 c of the paper: relaxations a step against number of
// bodies, for every order of relaxation, in the paper's own scene and way.

#include "trial.h"

#include <math.h>
#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const struct { order_kind kind; const char *name; } order[] = {
    { ORDER_LISTED, "listed" }, { ORDER_BREADTH, "breadth" },
    { ORDER_REPEATED, "repeated" }, { ORDER_WORK_LIST, "work list" },
    { ORDER_LARGEST, "largest first" }
};

enum { ORDERS = sizeof order / sizeof *order, SIZES = 10 };

static int run_and_print(int k, int bodies, trial *t)
{
    scene_options what = scene_options_default();
    world_options how = world_options_paper();
    what.bodies = bodies;
    how.order = order[k].kind;
    status done = trial_run(SCENE_ROOM, what, how, 10, t);
    if (!done.ok) {
        fprintf(stderr, "09-order: %s\n", done.why);
        return 0;
    }
    printf("%s,%d,%.5g,%.5g,%.4g,%.4g\n", order[k].name, bodies, t->relaxed,
           t->tested, t->ms, 100 * t->strain);
    return 1;
}

// What an order does beside the listed one, over all sizes of the room.
static void print_shares(int k, const trial *listed, const trial *t)
{
    real least = HUGE_VAL, most = 0, relaxed = 0, tested = 0;
    for (int i = 0; i < SIZES; i++) {
        real share = t[i].relaxed / listed[i].relaxed;
        least = fmin(least, share);
        most = fmax(most, share);
        relaxed += share / SIZES;
        tested += t[i].tested / listed[i].tested / SIZES;
    }
    printf("#shares| %s,%.2f to %.2f,%.2f,%.2f\n", order[k].name, least, most,
           relaxed, tested);
}

int main(void)
{
    static trial t[ORDERS][SIZES];
    trial_print_head("room, the paper's way, 10 s at dt = 1/60 s, tolerance "
                     "1 %: sticks relaxed and tested a step (mean), ms a step "
                     "(median), largest strain after relaxation (%)", FLAGS,
                     "order,bodies,relaxed,tested,ms,strain");
    for (int k = 0; k < ORDERS; k++) {
        for (int i = 0; i < SIZES; i++)
            if (!run_and_print(k, 10 * (i + 1), &t[k][i])) return 1;
        printf("\n\n");
    }
    printf("#shares| order,\"relaxed, least to most\",\"relaxed, mean\","
           "\"looked at, mean\"\n");
    for (int k = 1; k < ORDERS; k++) print_shares(k, t[0], t[k]);
    return 0;
}
