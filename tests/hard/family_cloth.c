// family_cloth.c - rows 170 to 179: rope and cloth.

#include "family.h"

#include <stddef.h>

const hard_case family_cloth[] = {
    { 0, NULL, 0, NULL }
};
