// scarce.h - memory that runs out, for tests of what happens then.
//
// Linked with -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc (see the Makefile),
// a program asks here for all its memory.

#ifndef TUMBLE_SCARCE_H
#define TUMBLE_SCARCE_H

#include <limits.h>

// How many more allocations are granted; INT_MAX: all.
extern int mallocs_left;

#endif
