// family_towers.c - rows 135 to 139: towers of all sizes, and a paddle in a bin.

#include "family.h"

#include <stddef.h>

const hard_case family_towers[] = {
    { 0, NULL, 0, NULL }
};
