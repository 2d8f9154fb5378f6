// hard_list.c - the hard cases of the engine, 1 to 36.

#include "hard.h"

#include <stddef.h>

extern const hard_case hard_particles[], hard_turning[], hard_queries[],
    hard_trees[], hard_bodies[], hard_thin[], hard_cloth[], hard_room[],
    hard_drape[];

// A new file of cases is entered here.
static const hard_case *const list[] = {
    hard_particles, hard_turning, hard_queries, hard_trees, hard_bodies,
    hard_thin, hard_cloth, hard_room, hard_drape, NULL
};

const hard_catalogue hard_all = {
    "hard", "The hard cases: of each the worst number beside its target", list
};
