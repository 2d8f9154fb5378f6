//> ledger-head
//>   After each phase the ledger adds up all energy, and books the difference
//>   to that phase. Verlet's velocity is that of the moment halfway between
//>   two positions, so height and lever arm are taken there, too. Then a free
//>   fall books nothing (`free_fall_books_no_energy_and_gravitys_momentum`).
// ledger.h - accounts of energy and momentum: which phase gave and took them.
//
// Paper: not asked.  Book: chapter 18.
// Units: joules, kg m/s, kg m^2/s about the origin, in the world's frame.

#pragma once

#include "world.h"
//<

//> ledger-declare
//>   Without the option `ledger` none of this runs. With it, no bit of the
//>   motion changes.
// The sum over all bodies, at the middle of their last substeps: kinetic and potential
// energy, momentum and angular momentum, and the energy stored in bends and links.
// Under gravity alone a step keeps this energy, and changes momentum by what gravity
// gives.  Static bodies and pinned particles do not count.
ledger_entry ledger_total(const world *w);

// Counts from here, and books nothing.  Call it at the start of a step: what a program
// does between steps is in no account.
void ledger_open(world *w);

// Books what has changed since the last call, to an account LEDGER_...  Costs nothing
// unless options.ledger is set.
void ledger_book(world *w, int account);

// Remembers what is booked so far, and goes back to it when a frame is begun again.
typedef struct {
    ledger_entry account[LEDGERS], now;
} ledger_page;

ledger_page ledger_mark(const world *w);
void ledger_rewind(world *w, const ledger_page *to);

// Says how long (s) ago the bodies that are awake were in the middle of the move that
// their velocities are of; 0: as their particles say.
void ledger_halfway(world *w, real seconds);
//<
