//> push-head
// push.h - contacts of rigid bodies that remember what they have pushed.
//
// Paper: section 6.1 parts bodies once a step, and forgets.  Here: each contact
// keeps the push that held its bodies apart, and begins with it the next time.
// Book: chapter 12.
// Units: metres, kilograms, seconds.  A push is in kg m: what it moves, times
// the mass.  Normals point from B to A.

#ifndef TUMBLE_PUSH_H
#define TUMBLE_PUSH_H

#include "four.h"

typedef struct {
    real friction;      // Coulomb's coefficient
    real restitution;   // 0 to 1
    real mend;          // share of an old overlap that a substep pushes out
    real mend_speed;    // m/s, and the most at which it does
    vec3 fall;          // m, g h^2: what gravity adds to a move in a substep
    real slop;          // of a contact's thickness: an overlap that is let be
} push_options;

// One side of a contact: a point that rides on particles.
typedef struct {
    const four *plan;   // NULL: a single particle
    const vec3 *at;     // [FOUR] where the four were when the frame's contacts
                        // were found
    int  first;         // in the pool
    int  count;         // FOUR, or 1; 0: immovable, the point is `fixed`
    real share[FOUR];   // the point is sum share_k x_k
    vec3 answer[3][FOUR]; // m/(kg m), how the particles answer a unit push
                        // along each direction
} push_side;

// Directions: the normal, and two across it.
enum { NORMAL, ACROSS, ASIDE, DIRECTIONS };

// A contact, for a frame: normal, points and answers stay as they were made.
// All answers of a frame are made for the same places: only then is the table
// of what each push does to each gap symmetric, and the passes over them
// converge.
typedef struct push {
    push_side a, b;
    vec3 fixed;             // m
    vec3 along[DIRECTIONS]; // unit; the normal from B to A
    real thickness;         // m, gap that is kept
    real weight[DIRECTIONS];// 1/kg, how far a unit push parts the points
    real skew[DIRECTIONS];  // 1/kg, how far one along the normal moves them
                            // across it; skew[NORMAL]: one across moves them
                            // aside
    real pushed[DIRECTIONS];// kg m, in this substep; kept from one to the next
    real worn;              // kg m^2, friction's work in this substep, times
                            // its square
    int  ready;             // weights and answers have been made
    real closing;           // m, in a blow: how much nearer they come in a
                            // substep, at the moment when they touch
    real share;             // when that is, as a part of the substep
    real parting;           // m, by how much they part in a substep then
    real most;              // m, the gap that mending may bring, at most
    real from[DIRECTIONS];  // kg m, pushed when the last two passes began,
    real last[DIRECTIONS];  // and after the two before them
} push;
//<

//> push-remember
// What a contact leaves to that of the next frame.
typedef struct {
    int  a, b;              // the bodies
    real share[FOUR];       // of A: which point of it
    vec3 force;             // N, in the world's frame
} push_memory;

// What c pushed in a substep of h (s), as a force: the next substep may be of
// another length.
push_memory push_remember(const push *c, int a, int b, real h);

// Takes over what m remembers, for substeps of h (s), beside what c has taken
// over from others.
void push_recall(push *c, const push_memory *m, real h);
//<

//> push-declare
// The directions across n (unit): fixed by n alone.
void push_directions(push *c, vec3 n);

// Applies what was pushed in the last substep (or frame) once more: what holds
// a pile up is nearly the same from one substep to the next.  Once a substep,
// before push_solve.
void push_again(push *c, particle *p);

// For the ledger: adds to c->worn what friction will do in push_again.
void push_book_again(push *c, const particle *p);

// Mends: a share of an overlap that was there when the substep of h (s) began
// is taken back by moving where the particles are and where they were alike: no
// speed comes of it.  push_limit, of all contacts before push_mend moves one,
// sees to it that those of one pair together do not mend faster than
// options.mend_speed.
void push_limit(push *c, const particle *p, push_options options, real h);
void push_mend(push *c, particle *p, push_options options);

// Parts the points so that their gap, if negative, is no worse than when the
// substep began, and brakes their sliding within Coulomb's cone.  What it has
// pushed in all is in c->pushed; it is never a pull.  Returns the change of
// the gap that it made (m, >= 0 in size), to tell when all are content.
real push_solve(push *c, particle *p, push_options options);

// Momentum between passes (Nesterov 1983): from where the last two passes led,
// on by a share of the way from where those before them had led.
void push_mark(push *c);                        // before the first pass
// Does that lead on, the way that the last two passes took?  Energy-like
// (kg m^2); the sum over all contacts is negative if not.
real push_leads_on(const push *c);
void push_lean(push *c, particle *p, real share);

// The blow: n contacts of one pair of bodies, which met faster than `slowest`
// (m in a substep), part at restitution times their speed; the moment of
// touching within the substep counts.  Returns 1 if there was a blow.
int push_blow(push *c, int n, particle *p, push_options options, real slowest);
//<

//> push-end
#endif
//<
