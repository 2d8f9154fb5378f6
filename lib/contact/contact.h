//> contact-head
// contact.h - where two rigid bodies touch, and the impulses that part them.
//
// Paper: section 6.1 parts bodies at one point, once a step, and forgets it.
// Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals are unit vectors from B to A.

#ifndef TUMBLE_CONTACT_H
#define TUMBLE_CONTACT_H

#include "motion.h"

enum { CONTACT_POINTS = 4 };

// A point of A and a point of B that must not pass each other along the normal.
typedef struct {
    vec3 local_a, local_b;  // where they ride: in the frames of the two bodies;
                            // of one that is round, on its core
    real offset;            // m, the gap that is kept between them
    real own;               // 1: they push where A's point is, a vertex on a
                            // face of B; 0: where B's is; 1/2: halfway
} contact_point;

// All contact of one pair of bodies: up to four points with one normal, and one
// friction for all of them.
typedef struct {
    int  a, b;              // bodies; b < 0: plane -1 - b
    int  piece_a, piece_b;  // those that touch: the bodies, or pieces of them
    int  count;             // points; 0: none as near as they were asked for
    bool is_ahead;          // found where the bodies meet later in the frame, not
                            // where they are
    bool is_floor;          // found with the plane of a floor: with a face of one
                            // piece, or of several
    long found;             // when it was, as a number that no other has
    real round_a, round_b;  // m, so far from the points of A and of B, along
                            // the normal, are their surfaces; offsets hold it
    vec3 normal;
    real impulse[CONTACT_POINTS];   // N s, of each point in the last substep,
                            // along the normal, >= 0
    vec3 friction;          // N s, across the normal, in the last substep
    real twist;             // N m s, about the normal
    contact_point point[CONTACT_POINTS];
} contact;
//<

//> contact-declare
//>   What a frame asks of contacts: their gaps, their arms, and what they
//>   inherit.
static inline int contact_with_plane(int number)
{
    return -1 - number;
}

// The gaps (m) of all points beside their offsets, when the bodies stand as
// their frames say; < 0: overlap.  For a plane b is NULL, and height (m) the
// plane's offset along its normal.
void contact_gaps(const contact *c, const rigid_frame *a, const rigid_frame *b,
                  real height, real gap[CONTACT_POINTS]);

// Where the impulses of a point act: m, from the centres.
typedef struct {
    vec3 a, b;
} contact_arms;

// Those of point k, when the bodies stand as their frames say.  For a plane b
// is NULL, and its arm 0.
contact_arms contact_arms_of(const contact *c, int k, const rigid_frame *a,
                             const rigid_frame *b);

// Where it is on each of them: at one place only when they touch.
contact_arms contact_sides_of(const contact *c, int k, const rigid_frame *a,
                              const rigid_frame *b);

// The sum of the impulses along the normal (N s): 0 if they do not touch.
real contact_load(const contact *c);

// It carries nothing.
static inline void contact_clear(contact *c)
{
    for (int k = 0; k < c->count; k++) c->impulse[k] = 0;
    c->friction = vec3_make(0, 0, 0);
    c->twist = 0;
}

// Which point of A, or of B, is the nearest to that place on it.
int contact_nearest(const contact *c, bool is_a, vec3 local);

// Contact `now` of the same bodies, found again, takes over the impulses of
// `was`: each old point hands its own to the new point nearest to it (warm
// starting).  None, if the normal has turned by more: by 45 degrees, whose cosine
// this is.
static const real CONTACT_SAME = 0.7;       // tuned, 1
void contact_inherit(contact *now, const contact *was);

// When and where bodies will touch is sought in so many rounds at most, each from
// what the one before has found; so is what an impact passes on.
enum { CONTACT_ROUNDS = 8 };                // tuned, rounds

// By how much what bears may give way, of the smaller radius: so many substeps a
// frame takes (substeps.c).
static const real CONTACT_GIVES = 0.0035;   // tuned, radii

// Two points touch whose gap is less than this, of the smaller radius: more than
// rounding leaves of one that has just closed.
static const real CONTACT_TOUCHES = 1e-9;

// An overlap is deep that is more than this, of the smaller radius: it is reported,
// and so deep inside of a face nothing has come through it.
static const real CONTACT_DEEP = 0.1;       // tuned, radii

// Contact c will be read soon: a processor may fetch it already.
static inline void contact_expect(const contact *c)
{
#ifdef __GNUC__
    const char *at = (const char *)c;
    for (int k = 0; k < (int)sizeof *c; k += 64) __builtin_prefetch(at + k);
#else
    (void)c;
#endif
}
//<

//> contact-end-of-header
//>   The header ends.
#endif
//<
