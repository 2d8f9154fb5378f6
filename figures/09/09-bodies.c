// 09-bodies.c - Figure 9 a of the paper: frame rate against number of bodies,
// with the error of the same run: the paper's system as printed and as mended,
// and beside them the engine, in which nothing sleeps.

#include "trial.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static status run(runner_kind kind, int bodies, trial *out)
{
    scene_options what = scene_options_default();
    what.bodies = bodies;
    if (kind != BY_ENGINE) return trial_of(kind, SCENE_ROOM, what, 10, out);
    runner r;
    world_options how = world_scene_options(SCENE_ROOM, 0);
    how.sleep_speed = 0;
    status done = runner_begin_world(&r, SCENE_ROOM, what, how);
    if (done.ok) trial_run(&r, 10, out);
    return done;
}

int main(void)
{
    trial_print_head("room, 10 s at dt = 1/60 s: ms a step (median), largest "
                     "overlap (% of a body's radius)", FLAGS,
                     "bodies,printed_ms,printed_overlap,mended_ms,"
                     "mended_overlap,engine_ms,engine_overlap");
    for (int bodies = 10; bodies <= 200; bodies += bodies < 100 ? 10 : 50) {
        trial t[RUNNERS];
        for (int kind = 0; kind < RUNNERS; kind++) {
            status done = run((runner_kind)kind, bodies, &t[kind]);
            if (done.ok) continue;
            fprintf(stderr, "09-bodies: %s\n", done.why);
            return 1;
        }
        printf("%d", bodies);
        for (int kind = RUNNERS - 1; kind >= 0; kind--)
            printf(",%.4g,%.4g", t[kind].ms,
                   100 * t[kind].penetration / SCENE_BODY_RADIUS);
        printf("\n");
    }
    return 0;
}
