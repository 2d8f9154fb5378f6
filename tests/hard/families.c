// families.c - the second list, 101 and up: a row is a property, through
// tumble.h alone, at its defaults, over ranges of size, speed, shape and step.

#include "family.h"

#include <stddef.h>

extern const hard_case family_seams[], family_round[], family_ground[],
    family_momentum[], family_impact[], family_towers[], family_symmetry[],
    family_motion[], family_joints[], family_cloth[], family_state[],
    family_cost[];

// A new file of rows is entered here.
static const hard_case *const list[] = {
    family_seams, family_round, family_ground, family_momentum, family_impact,
    family_towers, family_symmetry, family_motion, family_joints, family_cloth,
    family_state, family_cost, NULL
};

const hard_catalogue hard_all = {
    "families", "Families: of each property the worst number beside its target",
    list
};
