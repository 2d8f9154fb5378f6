// box3d.c - rooms and piles by this library and by Box3D, each as it comes, in
// one run: what a step costs, beside what is wrong with it.
//
//     build/box3d [THROW]      another throw of the rooms: 1, 2, 3 ...

#include "clock.h"
#include "piles.h"

#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { COUNT = 2, WHOLE = 600, SECOND = 60 };    // frames

static const contender LIST[COUNT] = {
    { &mover_tumble, "tumble", "substeps", 600, 1, { 8 }, 8, true },
    { &mover_box3d, "Box3D", "substeps", 600, 1, { 4 }, 4, true },
};
static const contender AWAKE[COUNT] = {
    { &mover_tumble, "tumble", "substeps", 600, 1, { 8 }, 8, false },
    { &mover_box3d, "Box3D", "substeps", 600, 1, { 4 }, 4, false },
};

int main(int count, char **word)
{
    int seed = count > 1 ? atoi(word[1]) : 1;
    clock_print_head("Rooms and piles: ms a step and what is wrong", FLAGS);
    run_scene(pile_room(50, WHOLE, seed), LIST, COUNT);
    run_scene(pile_room(200, WHOLE, seed), LIST, COUNT);
    run_scene(pile_room(1000, WHOLE, seed), LIST, COUNT);
    run_scene(pile_room(5000, SECOND, seed), AWAKE, COUNT);
    run_scene(pile_room(10000, SECOND, seed), AWAKE, COUNT);
    run_scene(pile_pyramid(20), LIST, COUNT);
    run_scene(pile_tower(20), LIST, COUNT);
    run_scene(pile_drop(1000), LIST, COUNT);
    run_scene(pile_thrown(200), LIST, COUNT);
    return 0;
}
