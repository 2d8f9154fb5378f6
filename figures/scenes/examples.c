// examples.c - the scenes, in the order of the book.
#include "example.h"

#include <stddef.h>

const example *const examples[] = {
    &pyramid, &dominoes, &cradle, &bridge, &ragdoll, &wrecker, &marbles, &flag,
    &curtain, &blanket, NULL };
