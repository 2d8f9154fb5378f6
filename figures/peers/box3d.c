// box3d.c - what a step costs by this library and by Box3D, and what is wrong with
// it.
//
//     build/box3d FOLDER [THROWS]      the tables go there; 0: a quick race

#include "clock.h"
#include "race.h"

#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { BOTH = 2, ALL = 8 };

// The first two are the engines as they come.
static const contender LIST[ALL] = {
    { &tumble_mover, "tumble", 0 },
    { &box3d_mover, "Box3D", 0 },
    { &box3d_mover, "Box3D: 1 substep", 1 },
    { &box3d_mover, "Box3D: 2 substeps", 2 },
    { &box3d_mover, "Box3D: 8 substeps", 8 },
    { &box3d_mover, "Box3D: 16 substeps", 16 },
    { &tumble_mover, "tumble: 2 substeps", 2 },
    { &tumble_mover, "tumble: 4 substeps", 4 },
};

int main(int count, char **word)
{
    if (count < 2) give_up("wants a folder");
    race_form f = race_begin(word[1], "box3d", count > 2 ? atoi(word[2]) : 20, false);
    clock_print_head("Rooms, piles and joints beside Box3D", FLAGS);
    race_scene(&f, make_thrown, 50, LIST, BOTH);
    race_scene(&f, make_thrown, 200, LIST, ALL);
    race_scene(&f, make_pyramid, 20, LIST, ALL);
    race_scene(&f, make_tower, 20, LIST, ALL);
    race_scene(&f, make_stacks, 30, LIST, BOTH);
    race_scene(&f, make_hard_pair, 30, LIST, BOTH);
    race_scene(&f, make_sizes, 300, LIST, BOTH);
    race_scene(&f, make_rolling, 1000, LIST, BOTH);
    race_scene(&f, make_chain, 50, LIST, ALL - 2);
    race_scene(&f, make_dolls, 30, LIST, ALL - 2);
    race_scene(&f, make_drop, 1000, LIST, BOTH);
    race_scene(&f, make_thrown, 1000, LIST, BOTH);
    race_end(&f);
    return 0;
}
