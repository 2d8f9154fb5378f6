//> line-head
//>   A line has two strides: how far apart its particles are in the list, and
//>   how far apart neighbouring lines are. So ropes, columns and rows are one
//>   thing to the solver.
// line.h - ropes, and the columns and rows of a cloth, solved at one stroke.
//
// Paper: section 3.2 relaxes them stick by stick.  Here: Newton's step for all
// links of a line at once, a tridiagonal system (Thomas 1949).
// Book: chapter 12.
// Units: metres, inverse masses in 1/kg.

#pragma once

#include "body.h"

#include <stddef.h>

// Lines side by side: particle k of line l is number l * across + k * along.
// All their links are equally long.
typedef struct {
    int  lines, particles;      // how many; in each
    int  across, along;
    real rest_length;           // m
} strands;

// It is free; it meets what moves, and is as free, but its pull is remembered; or it
// touches what does not move.
typedef enum { LINE_FREE, LINE_MEETS, LINE_TOUCHES, LINE_CORNERED } line_state;

typedef struct {
    line_state state;
    vec3 normal;        // unit, out of what it touches
    vec3 pull;          // m, how far the strands would have moved it, free: a mean
    real push[2];       // kg m, T h^2 of the links that begin at it, one in
                        // each direction, in the last substep; or 0
} line_hold;

// What touches something that does not move gives way to the strands by this share of
// what a free particle would, as if it were heavier.
static const real GIVE_SHARE = 0.3;         // tuned, 1

static inline real hold_share(const line_hold *h)
{
    return h->state < LINE_TOUCHES ? 1 : GIVE_SHARE;
}

// Memory for lines: one for each thread that solves.
typedef struct line_scratch line_scratch;

// What one call did.
typedef struct {
    real worst;         // largest |length^2 - rest^2| / (2 rest^2) met BEFORE
                        // the last step: e + e^2 / 2 for a strain e.  HUGE_VAL
                        // for NaN
    int  steps;         // Newton steps done
    int  fell_back;     // 1: GRADIENT_OLD failed, GRADIENT_NEW finished
} line_result;
//<

//> line-declare
// What is off by more, of its length, or of the radius of the smaller of two that a
// joint holds, or (an axis) in radians, is not held: it is reported, and takes more
// substeps.
static const real STRAINED = 0.01;          // tuned, 1

// In how many directions s has strands: 1 for a rope, 2 for a cloth, 0 for a
// rigid shape; and those of one direction, of a cloth the columns first.
int     shape_directions(const shape *s);
strands shape_strands(const shape *s, int direction);

// How many sticks, the first of the shape's, are links of the strands.
int shape_links(const shape *s);

// m of a cloth's width that each strand of a direction has for itself; of a
// rope 1, without unit.
real shape_width(const shape *s, int direction);

// J, what is stored in the links of a body whose compliance is such: by how
// much, of a metre, a newton stretches a rope (1/N); a newton for each metre of
// width a cloth (m/N).
real links_energy(const shape *s, real compliance, const particle *p);

// Room for the strands of s, in so many bytes: filled, or found as well.  NULL if
// memory is refused.
size_t        line_scratch_size(const shape *s);
void          line_scratch_init(line_scratch *scratch, const shape *s);
line_scratch *line_scratch_new(const shape *s);
void          line_scratch_free(line_scratch *scratch);

// Brings every link of the strands (all lines of one direction, solved side by
// side) to its rest length: Newton steps until no link is off by more than
// options.tolerance, at most `steps` (>= 1) of them.  With one step the error
// falls from e to about e^2.  p is the first particle of the body.  Gradients
// as options.gradient says; GRADIENT_OLD keeps momentum and angular momentum;
// where it fails (it leaves a line more than an eighth of its error and more
// than options.tolerance, or numbers that are not finite) that line is restored
// and solved along GRADIENT_NEW.
// Nailed particles stay.  A link between two nails, or one without length or
// direction, is left.  No step moves a particle farther than half a link and
// the sum of its line's errors.  Never NaN for finite places: a line whose
// numbers are lost stays as it is, and shows in `worst`.
line_result line_solve(strands s, particle *p, int steps,
                       relax_options options, line_scratch *scratch);

// All strands of a body, one direction after the other, one step each, until
// none met an error above options.tolerance, but at least `fewest` and at most
// `sweeps` (>= 1) times.
// The result: worst of the last sweep, sweeps in the place of steps.  As if by
// line_solve for each direction, but along the new gradient all sweeps but the
// last (and, where threads give, the first) ask for 1.2 times what is wrong, and the
// places are fetched and brought back only once.  After the first sweep a block of
// eight lines of a cloth is left out if all of them are good, measured as if threads
// did not give.
// (A lost line goes back to where it was before them all.)
// hold: [particles], or NULL: nothing is touched; writes the pull of each, and the
// pushes of ropes and of strands that give.  A strand
// that pushed too hard for an explicit step is stepped as a string first
// (taut.h).
// give: compliance / h^2 in a substep of h (s).  0: the links keep their
// length.  Else each ends as long as what it then pulls stretches it, which is
// Euler's implicit step, always along the new gradient; an error is what is
// left of that.
line_result lines_relax(const shape *s, particle *p, int fewest, int sweeps,
                        relax_options options, line_hold *hold, real give,
                        line_scratch *scratch);
//<
