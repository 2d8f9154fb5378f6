// 09-cloth.c - Figure 9 b of the paper: frame rate against the size of the
// cloth, with the strain of the same run: as printed, as mended, the engine.

#include "trial.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static int print_run(scene_kind which, runner_kind kind, int cloth)
{
    scene_options what = scene_options_default();
    trial t;
    what.cloth = cloth;
    status done = trial_of(kind, which, what, 5, &t);
    if (!done.ok) {
        fprintf(stderr, "09-cloth: %s\n", done.why);
        return 0;
    }
    printf("%s,%s,%d,%.4g,%.4g\n", scene_name(which), runner_name(kind), cloth,
           t.ms, 100 * t.strain);
    return 1;
}

int main(void)
{
    trial_print_head("cloth scenes, 5 s at dt = 1/60 s: ms a step (median), "
                     "largest strain in any frame (%)", FLAGS,
                     "scene,system,cloth,ms,strain");
    for (scene_kind k = SCENE_CLOTH_ON_CUBE; k <= SCENE_CLOTH_ON_ROPE; k++)
        for (int kind = RUNNERS - 1; kind >= 0; kind--) {
            for (int cloth = 20; cloth <= 40; cloth += 5)
                if (!print_run(k, (runner_kind)kind, cloth)) return 1;
            printf("\n\n");
        }
    return 0;
}
