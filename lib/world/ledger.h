//> ledger-head
//>   After each phase the ledger adds up all energy, and books the difference
//>   to that phase. Verlet's velocity is that of the moment halfway between
//>   two positions, so height and lever arm are taken there, too. Then a free
//>   fall books nothing (`free_fall_books_no_energy_and_gravitys_momentum`).
// ledger.h - what gave energy and momentum to the world, and what took them?
//
// Paper: not asked.  Book: chapter 18.
// Units: joules, kg m/s, kg m^2/s about the origin, in the world's frame.

#ifndef TUMBLE_LEDGER_H
#define TUMBLE_LEDGER_H

#include "world.h"
//<

//> ledger-declare
//>   Without the option `ledger` none of this runs. With it, no bit of the
//>   motion changes.
// What the bodies have: kinetic energy by the velocities in the
// middle of a substep, and potential energy, momentum and angular momentum at
// the places of that moment; and what is stored in bends and links.  Under gravity alone a step changes none of this
// sum's energy, and momentum by gravity's share.  Static bodies and pinned
// particles do not count.
ledger_entry ledger_total(const world *w);

// Opens the account: books nothing, and counts from here.  At the start of a
// step: what is done to the particles between steps is in no account.
void ledger_open(world *w);

// Books what has changed since the last call to account LEDGER_...  Costs
// nothing unless options.ledger is set.
void ledger_book(world *w, int account);

// From where the bodies that are awake have been moved to, the middle of the
// move that their velocities are of is so far away (s); 0: their particles say.
void ledger_halfway(world *w, real seconds);
//<

//> ledger-end
//>   The header ends.
#endif
//<
