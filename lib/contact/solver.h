//> solver-head
// solver.h - the impulses of all contacts at once.
//
// Paper: section 6.1 parts one pair after the other, once a step.  Here:
// projected Gauss-Seidel with soft contacts (Catto 2011, 2024), four contacts
// side by side.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#ifndef TUMBLE_SOLVER_H
#define TUMBLE_SOLVER_H

#include "contact.h"
#include "real4.h"
#include "task.h"

// How an overlap is pushed out: as a spring and a damper would, so strongly
// that the substep can follow.
typedef struct {
    real rate;          // 1/s, at which an overlap goes
    real mass;          // share of the effective mass that answers
    real impulse;       // share of the old impulse that is given up
} softness;

// A rigid body as the solver reads it.
typedef struct {
    motion_basis basis; // zero: immovable
    rigid_frame frame;  // where it stands at the start of the frame
    real radius;        // m, around its centre
} solver_body;

// What the solver is told about a frame.
typedef struct {
    const solver_body *body;    // [bodies]
    int  bodies;
    const plane *plane;         // those that contacts with planes name
    real h;                     // s, a substep
    real friction;              // Coulomb's coefficient
    real hertz;                 // 1/s, of the contacts' springs, at most
    real damping;               // ratio, of their dampers
    real max_speed;             // m/s, at which overlaps are pushed out, at most
    tasks run;
} solver_frame;
//<

//> solver-block
// Four contacts side by side: each number of each kind stands in a lane of its
// own.  The contacts of a block share no body.
typedef struct {
    real4 turn_a[TURNS], turn_b[TURNS]; // kg^(-1/2), Jacobian row of the turns
    real4 gap;          // m, at the start of the frame
    real4 mass;         // kg, effective, along the normal
    real4 impulse;      // N s
    real4 lever;        // m, from the point where friction acts
} block_point;

typedef struct {
    real4 normal[3];
    real4 across[2][3];                 // two unit vectors across it
    real4 inverse_a, inverse_b;         // 1/kg
    real4 across_a[2][TURNS], across_b[2][TURNS];   // rows of friction
    real4 twist_a[TURNS], twist_b[TURNS];
    real4 across_mass[3];               // kg: inverse of the 2 x 2 matrix K
    real4 twist_mass;                   // kg m^2
    real4 across_impulse[2], twist_impulse;
    int   a[REAL4], b[REAL4];           // bodies; lanes left over: the spare
    int   contact[REAL4];               // -1: left over
    int   points;                       // of the contact that has most
    block_point point[CONTACT_POINTS];
} block;
//<

//> solver-struct
// Blocks of one colour share no body, so that they may be solved in any order,
// or at once.  Contacts with what does not move have colours of their own, and
// come last: what is immovable has the last word.
enum { COLORS = 64, SIDES = 2 };

typedef struct {
    int  contact;       // in the table of contacts
    int  count;         // points that may touch in this frame
    int  color, sides;  // SIDES - 1: one side does not move
    int  swap;          // A does not move: the block's A is the contact's B
    signed char point[CONTACT_POINTS];  // which
    real gap[CONTACT_POINTS];
} active_contact;

typedef struct {
    active_contact *active;
    int  actives, capacity;
    int  *order;                        // [actives] by colour and points
    block *block;
    int  blocks, block_capacity;
    int  colors;                        // in use, of both kinds
    struct { int first, count, sides; bool alone; } color[SIDES * COLORS];
    unsigned long long (*taken)[SIDES]; // [bodies] colours of each
    motion *before;                     // [bodies + 1] see solver_begin
    int  bodies;
    softness soft[SIDES];               // of two that move; of one
} contact_solver;
//<

//> solver-declare
// An empty solver for so many bodies.  Fails, leaving *s empty, for want of
// memory.
status solver_init(contact_solver *s, int bodies);
void   solver_free(contact_solver *s);      // an empty or zeroed one is fine

// Takes up the n contacts table[list[0]] ... whose points come within reach[k]
// (m) of each other; makes their blocks.  Returns how many found no memory.
int solver_prepare(contact_solver *s, const solver_frame *f,
                   const contact *const *table, const real *reach, int n);

// One substep, in this order.  velocity and moved are [bodies + 1]: the last is
// spare, for lanes that are left over.
//
// solver_begin gives every body the impulses of the last substep, or frame
// (first), once more: warm starting.
void solver_begin(contact_solver *s, const solver_frame *f, motion *velocity,
                  bool first);
// Solves the normals, and pushes out overlaps with the speed of f's springs.
void solver_push(contact_solver *s, const solver_frame *f, motion *velocity,
                 const motion *moved);
// After the bodies have moved: takes back that speed, and solves friction.
void solver_relax(contact_solver *s, const solver_frame *f, motion *velocity,
                  const motion *moved);
// Ends the substep: what the contacts did to each body is kept for the next.
void solver_end(contact_solver *s, const motion *velocity);

// Writes the impulses of the last substep to contact k of those that were
// prepared.
void solver_store(const contact_solver *s, contact *const *table);
//<

//> solver-end
#endif
//<
