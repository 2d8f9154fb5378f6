// family_state.c - rows 180 to 184: save and load.

#include "family.h"

#include <stddef.h>

const hard_case family_state[] = {
    { 0, NULL, 0, NULL }
};
