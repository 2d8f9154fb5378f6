// bits.c - prints the bits of four short films, so that compilers can be
// compared: make bits.

#include <stdio.h>

#include "world_scene.h"
#include "step.h"

// Enough of them that their contacts come in parts (halves.h).
enum { FEW = 20, MANY = 150 };

// Runs a scene for so many frames and prints the hash of where it ends.
static int film(scene_kind kind, world_options how, int bodies, int frames,
                const char *way)
{
    world_scene s;
    scene_options what = scene_options_default();
    what.bodies = bodies;
    what.cloth = 12;
    status done = world_scene_build(&s, kind, what, how);
    if (!done.ok) {
        fprintf(stderr, "bits: %s: %s\n", scene_name(kind), done.why);
        return 1;
    }
    for (int k = 0; k < frames; k++) world_step(&s.world);
    printf("%s %s %016llx\n", scene_name(kind), way, world_hash(&s.world));
    world_scene_free(&s);
    return 0;
}

int main(void)
{
    const int frames[SCENES] = { 60, 30, 30 };
    int failed = film(SCENE_ROOM, world_scene_options(SCENE_ROOM, 0), MANY, 60,
                      "in parts");
    for (int k = 0; k < SCENES; k++) {
        scene_kind kind = (scene_kind)k;
        failed |= film(kind, world_scene_options(kind, 40), FEW, frames[k],
                       "ours");
    }
    return failed;
}
