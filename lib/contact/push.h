//> push-head
// push.h - contacts of rigid bodies that remember what they have pushed.
//
// Paper: section 6.1 parts bodies once a step, and forgets.  Here: each contact
// keeps the push that held its bodies apart, and begins with it the next time.
// Book: chapter 13.
// Units: metres, kilograms, seconds.  A push is in kg m: what it moves, times
// the mass.  Normals point from B to A.

#ifndef TUMBLE_PUSH_H
#define TUMBLE_PUSH_H

#include "rigid4.h"

typedef struct {
    real friction;      // Coulomb's coefficient
    real restitution;   // 0 to 1
    real mend;          // share of an old overlap that a substep pushes out
    real mend_speed;    // m/s, and the most at which it does
    vec3 fall;          // m, g h^2: what gravity adds to a move in a substep
    real slop;          // of a contact's thickness: an overlap that is let be
    int  book;          // 1: friction's work is kept in `worn`
} push_options;

// One side of a contact: a point that rides on particles.
typedef struct {
    const rigid4_ways *ways;  // of the four, where they were when the frame's
                            // contacts were found; NULL: a single particle
    int  first;             // in the pool
    int  count;             // FOUR, or 1; 0: immovable, the point is `fixed`
    int  body;              // its number in a pile; -1: it does not move
    real share[FOUR];       // the point is sum share_k x_k
} push_side;

// Directions: the normal, and two across it.
enum { NORMAL, ACROSS, ASIDE, DIRECTIONS };

// A contact, for a frame: normal, points and rows stay as they were made.  All
// rows of a frame are made for the same places: only then is the table of what
// each push does to each gap symmetric, and the passes over them converge.
typedef struct push {
    // What passes look at.
    real row[2][DIRECTIONS][FOUR_WAYS]; // kg^(-1/2), how far the points part
                            // along each direction as A, or B, goes along each
                            // way; and how far a unit push moves the body so;
                            // 0 for what does not move
    real length;            // kg^(-1/2), of the longest row, A's and B's as one
    vec3 undo[DIRECTIONS];  // kg, which pushes part the points along each
    real weight[DIRECTIONS];// 1/kg, how far a unit push parts the points
    real skew[DIRECTIONS];  // 1/kg, how far one along the normal moves them
                            // across it; skew[NORMAL]: one across moves them
                            // aside
    real pushed[DIRECTIONS];// kg m, in this substep; kept from one to the next
    real from[DIRECTIONS];  // kg m, pushed when the last two passes began,
    real last[DIRECTIONS];  // and after the two before them
    real apart[DIRECTIONS]; // m, before pushes: the gap, and how far the points
                            // have slid across it in this substep
    real before;            // m, the gap when the substep began
    real worn;              // kg m^2, friction's work in this substep, times
                            // its square
    int  ready;             // rows and weights have been made
    int  holds;             // and so has `undo`

    // What is looked at once a substep, or less.
    push_side a, b;
    vec3 fixed;             // m
    vec3 along[DIRECTIONS]; // unit; the normal from B to A
    real thickness;         // m, gap that is kept
    real near;              // m, a gap that is wider stays one in this substep;
                            // in one it shrinks by no more than half of that
    int  far;               // substeps for which it will surely be wider
    real most;              // m, the gap that mending may bring, at most
    real closing;           // m, in a blow: how much nearer they come in a
                            // substep, at the moment when they touch
    real share;             // when that is, as a part of the substep
    real parting;           // m, by how much they part in a substep then
} push;
//<

//> push-remember
// What a contact leaves to that of the next frame.
typedef struct {
    real share[FOUR];       // of A: which point of it
    vec3 force;             // N, in the world's frame
} push_memory;

// What c pushed in a substep of h (s), as a force: the next substep may be of
// another length.
push_memory push_remember(const push *c, real h);

// Takes over what m remembers, for substeps of h (s), beside what c has taken
// over from others.
void push_recall(push *c, const push_memory *m, real h);
//<

//> push-declare
// The directions across n (unit): fixed by n alone.
void push_directions(push *c, vec3 n);

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

// The blow: n contacts of one pair of bodies, which met faster than `slowest`
// (m in a substep), part at restitution times their speed; the moment of
// touching within the substep counts.  Returns 1 if there was a blow.
int push_blow(push *c, int n, particle *p, push_options options, real slowest);
//<

//> push-pile-head
// Many contacts at once.  While they are solved no particle moves: a body is
// where it is, and so far pushed along each of its ways.
//
// They are in three parts: no body of one that is left is pushed by one that is
// right.  So these two parts may be worked on at the same time, and the order
// of the pushes that a body feels stays the same.  Those across come after both
// of them, or before, and touch anybody.
enum { PILE_LEFT, PILE_RIGHT, PILE_ACROSS, PILE_PARTS };

typedef struct {
    real pushed[FOUR_WAYS];      // m kg^(1/2), in this substep
    real mended[FOUR_WAYS];      // and without making speed
    real stirred;           // m kg^(1/2), its contacts' pushes have taken it no
                            // further along its ways, there and back
    int  is_mended;         // 0: `mended` is zero
} push_drift;

// A contact that may touch in this substep: all that tells whether it has to be
// looked at.  A pass that leaves out most of them hardly reads any push.
typedef struct {
    push_drift *a, *b;      // its bodies'; the part's own for one that does not
                            // move
    int  push;              // its number
    int  leans;             // it has changed since momentum was last given
    real solved;            // m kg^(1/2), how much both its bodies had been
                            // stirred when it was solved
    real room;              // the same: as long as they are stirred by no more,
                            // there is nothing to solve; < 0: there is
    real leads_on;          // kg m^2, see pile_leads_on
} push_near;

typedef struct {
    struct push *push;
    const int *order;       // numbers of pushes, part after part
    int   end[PILE_PARTS];  // where they end there
    push_drift *drift;      // [bodies + PILE_PARTS] the last: of who does not
                            // move, as each part sees him
    int   bodies;
    push_near *near;        // room for all pushes
    int   nears[PILE_PARTS];
} push_pile;
//<

//> push-pile-declare
// A substep of h (s) begins, and no body has been pushed yet: finds who of a
// part is near, and applies what each pushed in the last substep (or frame)
// once more, for what holds a pile up is nearly the same from one substep to
// the next.  Returns 1 if there may be anything to mend.
int pile_begin(push_pile *s, int part, const particle *p, push_options options,
               real h);

// Then mends, the last contact first, so those across before the others.
// Returns 1 if anything was mended: then, after all parts, pile_settle.
int  pile_mend(push_pile *s, int part, push_options options);
void pile_settle(push_pile *s, int part);

// One pass over a part, forward (step 1) or backward (-1): push_solve for each,
// but for those whose bodies have not been stirred by more than `enough` (m)
// since they were solved.  Returns the largest change of a gap (m).
real pile_pass(push_pile *s, int part, int step, real enough,
               push_options options);

// Does momentum lead on, the way that the last two passes took?  Energy-like
// (kg m^2); negative, summed over all parts, if not.
real pile_leads_on(const push_pile *s, int part);

// Momentum between passes (Nesterov 1983): from where the last two passes led,
// on by a share of the way from where those before them had led.
void pile_lean(push_pile *s, int part, real share, push_options options);

// A body's four particles go where it was pushed.
void drift_apply(const push_drift *d, const rigid4_ways *ways, particle *p);
//<

//> push-end
#endif
//<
