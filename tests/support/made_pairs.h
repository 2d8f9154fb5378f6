// made_pairs.h - pairs of small convex bodies in sixteen families, each hard for
// a query in its own way.

#ifndef TUMBLE_MADE_PAIRS_H
#define TUMBLE_MADE_PAIRS_H

#include "gjk.h"

enum { MADE_POINTS = 16, MADE_FAMILIES = 16 };

typedef struct {
    int  count;
    vec3 at[MADE_POINTS];
    real round;             // m, the radius around these
} made;

extern const char *const MADE_NAME[MADE_FAMILIES];

// Two bodies of that family.
void made_pair(made *a, made *b, int family, unsigned long long *seed);

// The same two, a little before: each moved by up to a hundredth of its size, and
// sheared as little.
void made_before(made *m, const made *now, unsigned long long *seed);

#endif
