//> solver-head
// solver.h - the impulses of all contacts at once.
//
// Paper: section 6.1 parts one pair after the other, once a step.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#ifndef TUMBLE_SOLVER_H
#define TUMBLE_SOLVER_H

#include "passes.h"
//<

//> solver-declare
// Room for so many bodies, if there was less: s->room, in the end.  A zeroed solver
// has none.  Fails, changing nothing, for want of memory.
status solver_grow(contact_solver *s, int bodies);
void   solver_free(contact_solver *s);      // an empty or zeroed one is fine

// Looks at n contacts: which of their points come within reach[k] (m) of each
// other, and what they carried, in s->active.  (Of the frame it needs no h.)
// Allocates only if there are more contacts than ever before; where memory is
// refused it takes none, and returns false.
bool solver_activate(contact_solver *s, const solver_frame *f,
                     const contact *const *table, const real *reach, int n);

// From now on only contacts `first` to before `end` of the table are solved: no
// body that moves has contacts among them and among the others.
void solver_take(contact_solver *s, int first, int end);

// Makes their blocks.  Allocates, and fails, as solver_activate does.
bool solver_prepare(contact_solver *s, const solver_frame *f,
                    const contact *const *table);

// Between two substeps, for contacts that are found again: active[k].is_new says
// which.  First their blocks give the impulses back to the contacts.
void solver_store_new(contact_solver *s, contact *const *table);
// Then they are looked at, and their blocks filled again; all blocks are made
// again where one has no room for more points.  Allocates, and fails, as
// solver_activate does.
bool solver_take_new(contact_solver *s, const solver_frame *f,
                     contact *const *table, const real *reach);

// One substep, in this order.  velocity and moved are [s->room + 1]: the last is
// spare, for lanes that are left over.  moved: since a body got its frame and
// basis; no further than rows stay good.
//
// Gives every body the impulses of the last substep once more (warm starting).
void solver_warm(contact_solver *s, const solver_frame *f, motion *velocity);
// Solves the normals: gaps close at most, and overlaps are pushed out.
void solver_push(contact_solver *s, const solver_frame *f, motion *velocity,
                 const motion *moved);
// After it: which blocks of a heavy and a light body still close fast (blow.h).
void solver_find_strikes(contact_solver *s, const solver_frame *f,
                         motion *velocity);
// After the bodies have moved: makes the rows of those that f->fresh names for
// where they stand now, or f->rows_at says.
void solver_renew(contact_solver *s, const solver_frame *f);
// Takes back the speed of pushing out, and solves
// friction.  Points that have not touched yet, and close fast, are left to the
// impacts of the next substep, if there are any (restitution.h).
void solver_relax(contact_solver *s, const solver_frame *f, motion *velocity,
                  const motion *moved);
// After impacts, before solver_warm: `moved` has changed, and with it the gaps.
void solver_update_gaps(contact_solver *s, const solver_frame *f,
                        const motion *moved);
// The next substep is so many times as long: its impulses are, too.
void solver_scale(contact_solver *s, real times);

// Writes the impulses of the last substep to the contacts that were prepared,
// and their loads to s->active.
void solver_store(contact_solver *s, tasks run, contact *const *table);

// After it: the impulses of contact k did not solve the frame, and are not kept.
void solver_forget(contact_solver *s, contact *const *table, int k);
//<

//> solver-end
//>   The header ends.
#endif
//<
