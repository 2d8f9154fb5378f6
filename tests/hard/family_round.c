// family_round.c - rows 110 to 114: hulls with round faces, coins and drums.

#include "family.h"

#include <stddef.h>

const hard_case family_round[] = {
    { 0, NULL, 0, NULL }
};
