// piles.c - boxes in piles, by this library, ODE and Bullet, in one run: what a
// step costs, beside what is wrong with it.

#include "clock.h"
#include "piles.h"

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const contender LIST[] = {
    { &mover_tumble, "tumble", "substeps", 60, 5, { 1, 2, 4, 8, 16 }, 8, true },
    { &mover_ode, "ODE quickstep", "iterations", 60, 6,
      { 5, 10, 20, 40, 80, 160 }, 20, true },
    { &mover_ode, "ODE dWorldStep", "", 10, 1, { 0 }, 0, false },
    { &mover_bullet, "Bullet", "iterations", 60, 6, { 5, 10, 20, 40, 80, 160 },
      10, true },
};
enum { COUNT = sizeof LIST / sizeof LIST[0] };

int main(void)
{
    clock_print_head("Boxes in piles: ms a step and what is wrong", FLAGS);
    run_scene(pile_pyramid(20), LIST, COUNT);
    run_scene(pile_tower(20), LIST, COUNT);
    run_scene(pile_drop(1000), LIST, COUNT);
    run_scene(pile_thrown(200), LIST, COUNT);
    return 0;
}
