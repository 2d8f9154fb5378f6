// families.h - point sets of twelve families: what the tests of spheres and of
// their trees share.

#ifndef TUMBLE_FAMILIES_H
#define TUMBLE_FAMILIES_H

#include "random.h"

static unsigned long long seed;

enum { N = 12, FAMILIES = 12 };

// Point sets that break a solver of four equations, each in its own way.
static void family(int kind, vec3 *at, int n)
{
    for (int i = 0; i < n; i++) {
        vec3 p = random_vec3(&seed, 1);
        real t = random_real(&seed);
        switch (kind) {
        case 1: p = vec3_scale(t, vec3_make(1, 2, -3)); break;      // in line
        case 2: p.z = 2 * p.x - p.y; break;                         // flat
        case 3: p = vec3_unit(p); break;                            // a sphere
        case 4: p = vec3_make(i & 1, i >> 1 & 1, i >> 2 & 1); break;// a cube
        case 5: if (i > 2) p = at[i % 3]; break;                    // repeated
        case 6: p.z *= 1e-9; break;                                 // a sliver
        case 7: p = vec3_unit(vec3_make(p.x, p.y, 0)); break;       // a circle
        case 8: p = vec3_scale(i ? 1e-9 : 1, p); break;             // one far
        case 9: p.y *= 1e-8; p.z *= 1e-5; break;                    // a needle
        case 10: p = vec3_add(vec3_make(0, 0, 1e-7 * p.z),          // a disc
                              vec3_unit(vec3_make(p.x, p.y, 0))); break;
        case 11: p = vec3_make(i % 3, i / 3, 0); break;             // a grid
        default: break;                                             // a cloud
        }
        at[i] = p;
    }
}

#endif
