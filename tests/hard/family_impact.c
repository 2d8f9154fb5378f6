// family_impact.c - rows 125 to 134: restitution, blades that turn, and thin plates.

#include "family.h"

#include <stddef.h>

const hard_case family_impact[] = {
    { 0, NULL, 0, NULL }
};
