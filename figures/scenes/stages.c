// stages.c - the scenes, in the order of the book.
#include "stage.h"

#include <stddef.h>

const stage *const stages[] = {
    &pyramid, &dominoes, &cradle, &bridge, &ragdoll, &wrecker, &marbles, &flag,
    &curtain, &blanket, NULL };
