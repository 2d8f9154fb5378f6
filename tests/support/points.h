// points.h - the bodies of the tests as the fast queries of chapter 10 take them:
// point sets, which may have a ring to climb.

#ifndef TUMBLE_POINTS_H
#define TUMBLE_POINTS_H

#include "bodies.h"
#include "distance.h"

static inline point_set body_points(const body *b)
{
    point_set p = { .at = b->at, .count = b->count };
    if (b->has_ring) {
        p.ring_start = b->ring_start;
        p.ring = b->ring;
    }
    return p;
}

static inline hull hull_of(point_set p)
{
    return (hull){ p.at, p.count };
}

#endif
