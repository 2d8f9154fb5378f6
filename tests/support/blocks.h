// blocks.h - the bodies of the tests that follow a pair through its stages.
//
// Needs check.h before it.

#ifndef TUMBLE_BLOCKS_H
#define TUMBLE_BLOCKS_H

#include "stage.h"

// A few products of numbers near 1.
#define ROUNDING 1e-13

static shape box, slab, ball, rope;

static inline void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(4, 0.5, 4), 8).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 2).ok);
    ck_assert(shape_rope(&rope, 5, 1, 1).ok);
}

static inline void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&slab);
    shape_free(&ball);
    shape_free(&rope);
}

#endif
