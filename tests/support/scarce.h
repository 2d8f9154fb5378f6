// scarce.h - memory that is counted and runs out, for tests of what happens then.
//
// A program that is linked with scarce.c and
// -Wl,--wrap=malloc and so on, of calloc, realloc, aligned_alloc and free (the
// Makefile names such programs) asks here for all its memory.

#ifndef TUMBLE_SCARCE_H
#define TUMBLE_SCARCE_H

#include <limits.h>

extern int  mallocs_left;   // allocations still granted; INT_MAX: all
extern long mallocs_made;   // asked for so far
extern long blocks_held;    // granted and not freed yet; look at it before you
                            // assert: Check frees what was not asked for here

#endif
