// family_ground.c - rows 115 to 119: ground that turns, lifts and moves.

#include "family.h"

#include <stddef.h>

const hard_case family_ground[] = {
    { 0, NULL, 0, NULL }
};
