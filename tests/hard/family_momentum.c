// family_momentum.c - rows 120 to 124: both momenta of bodies that collide.

#include "family.h"

#include <stddef.h>

const hard_case family_momentum[] = {
    { 0, NULL, 0, NULL }
};
