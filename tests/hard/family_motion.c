// family_motion.c - rows 150 to 159: motions with a formula.

#include "family.h"

#include <stddef.h>

const hard_case family_motion[] = {
    { 0, NULL, 0, NULL }
};
