//> solver-head
// solver.h - the impulses of all contacts at once.
//
// Paper: section 6.1 parts one pair after the other, once a step.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "passes.h"
//<

//> solver-declare
// Makes room for so many bodies (s->room), if there is less.  A zeroed solver has room
// for none.  False, changing nothing, if memory is refused.
bool solver_grow(contact_solver *s, int bodies);
void   solver_free(contact_solver *s);      // an empty or zeroed one is fine

// Takes n contacts: computes which points of contact k may come together within
// reach[k] (m), and the impulses that they bring along, in s->active.  It needs no h of
// the frame.  Allocates only if there are more contacts than ever before; if memory is
// refused, it takes none and returns false.
bool solver_activate(contact_solver *s, const solver_frame *f,
                     const contact *const *table, const real *reach, int n);

// From now on only contacts `first` to before `end` are solved.  Requires: no moving
// body has contacts both among them and among the others.
void solver_take(contact_solver *s, int first, int end);

// Makes blocks of these contacts.  Allocates, and fails, as solver_activate does.
bool solver_prepare(contact_solver *s, const solver_frame *f,
                    const contact *const *table);

// Between two substeps, for contacts that are to be found again (active[k].is_new):
// before that, gives the impulses of their blocks back to them;
void solver_store_new(contact_solver *s, contact *const *table);
// and after that, takes them again and fills their blocks.  If a block has no room for
// more points, all blocks are made again.  Allocates, and fails, as solver_activate
// does.
bool solver_take_new(contact_solver *s, const solver_frame *f,
                     contact *const *table, const real *reach);

// One substep, in this order.  velocity and moved are [s->room + 1]; the last element
// is for lanes that are left over.  moved is the displacement since a body got its
// frame and basis, no further than its rows are good for.
//
// Warm starting: gives every body the impulses of the last substep once more.
void solver_warm(contact_solver *s, const solver_frame *f, motion *velocity);
// Solves the normal rows: gaps close at most, and overlaps are pushed out.
void solver_push(contact_solver *s, const solver_frame *f, motion *velocity,
                 const motion *moved);
// Finds the blocks of a heavy and a light body that still close fast (blow.h).
void solver_find_strikes(contact_solver *s, const solver_frame *f,
                         motion *velocity);
// After the bodies have moved: makes the rows of those that f->fresh names again, for
// their frames now, or for f->rows_at.
void solver_renew(contact_solver *s, const solver_frame *f);
// Takes back the speed with which overlaps were pushed out, and solves friction.
// Points that have not touched yet and close fast are left to the impacts of the next
// substep, if there are any (restitution.h).
void solver_relax(contact_solver *s, const solver_frame *f, motion *velocity,
                  const motion *moved);
// After impacts, before solver_warm: computes the gaps again, for `moved` has changed.
void solver_update_gaps(contact_solver *s, const solver_frame *f,
                        const motion *moved);
// Remembers the impulses before a substep that may have to be done again; and restores
// them.
void solver_mark(contact_solver *s);
void solver_rewind(contact_solver *s);
// Multiplies all impulses, when the next substep is so many times as long.
void solver_scale(contact_solver *s, real times);

// Writes the impulses of the last substep to the contacts, and their loads to
// s->active.
void solver_store(contact_solver *s, tasks run, contact *const *table);

// After solver_store: sets the impulses of contact k, which did not solve the frame, to
// 0.
void solver_forget(contact_solver *s, contact *const *table, int k);
//<
