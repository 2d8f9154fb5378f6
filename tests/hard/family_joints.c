// family_joints.c - rows 160 to 169: joints.

#include "family.h"

#include <stddef.h>

const hard_case family_joints[] = {
    { 0, NULL, 0, NULL }
};
