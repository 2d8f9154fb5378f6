// 09-bodies.c - Figure 9 a of the paper: frame rate against number of bodies,
// with the error of the same run, for our way and the paper's.

#include "trial.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static int print_row(int bodies)
{
    scene_options what = scene_options_default();
    world_options ours = world_scene_options(SCENE_ROOM, 0);
    trial a, b;
    what.bodies = bodies;
    ours.resting = 0;
    status done = trial_run(SCENE_ROOM, what, ours, 10, &a);
    if (done.ok)
        done = trial_run(SCENE_ROOM, what, world_options_paper(), 10, &b);
    if (!done.ok) {
        fprintf(stderr, "09-bodies: %s\n", done.why);
        return 0;
    }
    printf("%d,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", bodies,
           a.ms, 100 * a.penetration / 0.5, 100 * a.strain,
           b.ms, 100 * b.penetration / 0.5, 100 * b.strain);
    return 1;
}

int main(void)
{
    trial_print_head("room, 10 s at dt = 1/60 s, nobody sleeps: ms a step "
                     "(median), largest penetration (% of a body's radius) and "
                     "strain (%), our way and the paper's", FLAGS,
                     "bodies,ms,penetration,strain,"
                     "paper_ms,paper_penetration,paper_strain");
    for (int bodies = 10; bodies <= 100; bodies += 10)
        if (!print_row(bodies)) return 1;
    return 0;
}
