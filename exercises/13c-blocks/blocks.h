// blocks.h - contacts that can be solved four at a time.

#ifndef TUMBLE_BLOCKS_OF_FOUR_H
#define TUMBLE_BLOCKS_OF_FOUR_H

#include "vec3.h"

enum { LANES = 4 };

typedef struct {
    int a, b;               // two bodies that differ; -1: what does not move
} meeting;

// Puts every contact into a lane of a block, so that no body is in two lanes of
// one block.  lane[LANES k + i] becomes the index of the contact in lane i of
// block k, or -1.  There is room for `count` blocks, and at scratch for bodies +
// count numbers.  Returns the number of blocks: at most count / 4 + 2 d, if no
// body has more than d contacts.
int blocks_fill(const meeting *m, int count, int bodies, int *lane, int *scratch);

#endif
