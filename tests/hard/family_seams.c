// family_seams.c - rows 101 to 109: floors of pieces, and bodies that slide over their seams.

#include "family.h"

#include <stddef.h>

const hard_case family_seams[] = {
    { 0, NULL, 0, NULL }
};
