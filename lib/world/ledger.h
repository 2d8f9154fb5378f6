//> ledger-head
// ledger.h - who gave energy and momentum to the world, and who took them?
//
// Paper: not asked.  Book: chapter 16.
// Units: joules, kg m/s, kg m^2/s about the origin, in the world's frame.

#ifndef TUMBLE_LEDGER_H
#define TUMBLE_LEDGER_H

#include "world.h"
//<

//> ledger-declare
// What the world has: kinetic energy by the velocities half a substep ago, and
// potential energy, momentum and angular momentum about the places of that
// moment.  Under gravity alone Verlet's step changes none of this sum's energy,
// and momentum by gravity's share.  Nailed particles do not count.
ledger_entry ledger_total(const world *w);

// Opens the account: books nothing, and counts from here.  At the start of a
// step: what was done to the particles between steps is nobody's.
void ledger_open(world *w);

// Books what has changed since the last call to `who`.  Costs nothing unless
// options.ledger is set.
void ledger_book(world *w, int who);

// Moves `energy` (J) that friction gave (< 0: took) from the contacts' account
// to its own.
void ledger_friction(world *w, real energy);

// Empties all accounts.
void ledger_clear(world *w);
//<

//> ledger-end
#endif
//<
