// 13-ledger.c - who gave energy to the falling room, and who took it?  The
// accounts of the ledger, with contacts that forget and with warm-started ones.

#include "ledger.h"
#include "world_scene.h"
#include "step.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { STEPS = 360 };

// J: what the stages gave (< 0: took) in six seconds; in all, and of that what
// they gave in those frames in which they gave.
static int print_accounts(const char *name, int memory)
{
    world_options how = world_options_default();
    world_scene s;
    real given[LEDGERS] = { 0 }, was[LEDGERS] = { 0 };
    how.ledger = 1;
    how.memory = memory;
    how.resting = 0;
    if (!world_scene_build(&s, SCENE_ROOM, scene_options_default(), how).ok) return 0;
    real start = ledger_total(&s.world).energy;
    for (int k = 0; k < STEPS; k++) {
        world_step(&s.world);
        for (int i = 0; i < LEDGERS; i++) {
            real now = s.world.ledger[i].energy;
            if (now > was[i]) given[i] += now - was[i];
            was[i] = now;
        }
    }
    printf("\"%s\" %.4g %.4g %.4g %.4g %.4g %.4g\n", name,
           was[LEDGER_CONTACTS], was[LEDGER_FRICTION], was[LEDGER_STICKS],
           start - ledger_total(&s.world).energy, given[LEDGER_CONTACTS],
           was[LEDGER_INTEGRATE]);
    world_scene_free(&s);
    return 1;
}

int main(void)
{
    printf("# the room of 50 bodies, 6 s: J that contacts, friction and sticks "
           "gave (< 0: took);\n# what was lost in all; what contacts gave in "
           "the frames in which they gave;\n# and what Verlet's step gave\n"
           "# compiler: %s\n# flags: %s\n", __VERSION__, FLAGS);
    return !(print_accounts("forgetting", 0)
             && print_accounts("warm-started", 1));
}
