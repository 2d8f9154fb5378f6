// jolt.c - what a step costs by this library and by Jolt, and what is wrong with
// it: the scenes of Box3D's race, and cloth.
//
//     build/jolt FOLDER [THROWS]       the tables go there; 0: a quick race

#include "clock.h"
#include "race.h"

#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { BOTH = 2, ALL = 5, CLOTHS = 5 };

// The first two are the engines as they come.
static const contender LIST[ALL] = {
    { &tumble_mover, "tumble", 0 },
    { &jolt_mover, "Jolt", 0 },
    { &jolt_mover, "Jolt: 2 collision steps", 2 },
    { &jolt_mover, "Jolt: 4 collision steps", 4 },
    { &jolt_mover, "Jolt: 40 iterations", -40 },
};
static const contender CLOTH[CLOTHS] = {
    { &tumble_mover, "tumble", 0 },
    { &jolt_mover, "Jolt", 0 },
    { &jolt_mover, "Jolt: 20 iterations", -20 },
    { &jolt_mover, "Jolt: 80 iterations", -80 },
    { &tumble_mover, "tumble: 4 substeps", 4 },
};

int main(int count, char **word)
{
    if (count < 2) give_up("wants a folder");
    race_form f = race_begin(word[1], "jolt", count > 2 ? atoi(word[2]) : 20, true);
    clock_print_head("Rooms, piles, joints and cloth beside Jolt", FLAGS);
    race_scene(&f, make_cloth_on_cube, 40, CLOTH, CLOTHS);
    race_scene(&f, make_flag, 40, CLOTH, BOTH);
    race_scene(&f, make_cloth_with_boxes, 40, CLOTH, BOTH);
    race_scene(&f, make_thrown, 50, LIST, BOTH);
    race_scene(&f, make_thrown, 200, LIST, ALL);
    race_scene(&f, make_pyramid, 20, LIST, BOTH);
    race_scene(&f, make_tower, 20, LIST, ALL);
    race_scene(&f, make_stacks, 30, LIST, BOTH);
    race_scene(&f, make_hard_pair, 30, LIST, BOTH);
    race_scene(&f, make_sizes, 300, LIST, BOTH);
    race_scene(&f, make_rolling, 1000, LIST, BOTH);
    race_scene(&f, make_chain, 50, LIST, ALL);
    race_scene(&f, make_dolls, 30, LIST, BOTH);
    race_scene(&f, make_cloth_on_cube, 80, CLOTH, BOTH);
    race_scene(&f, make_drop, 1000, LIST, BOTH);
    race_scene(&f, make_thrown, 1000, LIST, BOTH);
    race_end(&f);
    return 0;
}
