// tree.h - a tree of sticks, solved at one stroke.
//
// Units: metres, inverse masses in 1/kg.

#ifndef TUMBLE_TREE_H
#define TUMBLE_TREE_H

#include "verlet.h"

// What a particle is, seen from above, with all that hangs on it.  (Yours to
// use as you like; tree_step wants one for each particle, and nothing more.)
typedef struct {
    vec3 give[3];   // 1/kg, columns of a symmetric matrix: where it goes by a
                    // push of 1 kg m along x, y, z
    vec3 free;      // m, where it would go if nothing held it from above
    vec3 stick;     // m, from the one it hangs on to it
    real yield;     // m^2/kg, stick . (give stick); 0: none
    real wrong;     // m^2, what is left of the stick's error once it has gone
                    // where it would
} tree_node;

// One step of Newton for all sticks of a tree of n >= 1 particles.  Particle i,
// i > 0, hangs on particle parent[i] < i by a stick that ought to be rest[i]
// (m) long; particle 0 hangs on nothing.  (parent[0] and rest[0] are not looked
// at.)  A particle of inverse mass 0 stays.  A stick whose lower end, with all
// that hangs there, gives way by less than 1e-9 of what its lower end alone
// would, gives nothing: its upper end has to go.  Returns the largest
// |length^2 - rest^2| / (2 rest^2) as it was before.
real tree_step(particle *p, int n, const int *parent, const real *rest,
               tree_node *node);

#endif
