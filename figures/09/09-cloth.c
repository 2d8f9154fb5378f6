// 09-cloth.c - Figure 9 b of the paper: frame rate against the size of the
// cloth, with the strain of the same run, for our way and the paper's.

#include "trial.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static int print_run(scene_kind kind, int cloth, world_options how,
                     const char *way)
{
    scene_options what = scene_options_default();
    trial t;
    what.cloth = cloth;
    how.resting = 0;
    status done = trial_run(kind, what, how, 5, &t);
    if (!done.ok) {
        fprintf(stderr, "09-cloth: %s\n", done.why);
        return 0;
    }
    printf("%s,%s,%d,%.4g,%.4g\n", scene_name(kind), way, cloth, t.ms,
           100 * t.strain);
    return 1;
}

int main(void)
{
    trial_print_head("cloth scenes, 5 s at dt = 1/60 s: ms a step (median), "
                     "largest strain in any frame (%)", FLAGS,
                     "scene,way,cloth,ms,strain");
    for (scene_kind k = SCENE_CLOTH_ON_CUBE; k <= SCENE_CLOTH_ON_ROPE; k++)
        for (int way = 0; way < 2; way++) {
            for (int cloth = 20; cloth <= 40; cloth += 5)
                if (!print_run(k, cloth, way ? world_options_paper()
                                             : world_scene_options(k, 40),
                               way ? "paper" : "ours")) return 1;
            printf("\n\n");
        }
    return 0;
}
