//> contact-head
// contact.h - where two rigid bodies touch, and the impulses that part them.
//
// Paper: section 6.1 parts bodies at one point, once a step, and forgets it.
// Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals are unit vectors from B to A.

#pragma once

#include "motion.h"

enum { CONTACT_POINTS = 4 };

// A point of A and a point of B that must not pass each other along the normal.
typedef struct {
    vec3 local_a, local_b;  // in the frames of the two bodies; of a round body a
                            // point of its core
    real own;               // where the impulse acts: 1: at A's point, a vertex on
                            // a face of B; 0: at B's; 1/2: halfway
} contact_point;

// The contact of a pair of bodies: up to four points with one normal, and one friction
// for all of them.
typedef struct {
    int  a, b;              // bodies; b < 0: plane -1 - b
    int  piece_a, piece_b;  // the pieces of them that touch, or the bodies
    int  count;             // points; 0: none within the margin of the query
    bool is_ahead;          // found where the bodies meet later in the frame, not
                            // where they are
    bool is_floor;          // found with the plane of a floor, which is a face of
                            // one piece, or of several
    long found;             // a number that no other contact has
    real round_a, round_b;  // m, how far outside of the points of A and of B their
                            // surfaces are, along the normal
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

// The gaps (m) of all points, between the surfaces, when the bodies stand as their
// frames say; < 0: overlap.  For a plane b is NULL, and height (m) the
// plane's offset along its normal.
void contact_gaps(const contact *c, const rigid_frame *a, const rigid_frame *b,
                  real height, real gap[CONTACT_POINTS]);

// Where the impulse of a point acts: m, from the two centres.
typedef struct {
    vec3 a, b;
} contact_arms;

// The arms of point k, with the bodies in these frames.  For a plane b is NULL, and its
// arm 0.
contact_arms contact_arms_of(const contact *c, int k, const rigid_frame *a,
                             const rigid_frame *b);

// The two points themselves, one on each body; they coincide when the bodies touch.
contact_arms contact_sides_of(const contact *c, int k, const rigid_frame *a,
                              const rigid_frame *b);

// N s, the sum of the impulses along the normal; 0 if the bodies do not touch.
real contact_load(const contact *c);

// Forgets all impulses.
static inline void contact_clear(contact *c)
{
    for (int k = 0; k < c->count; k++) c->impulse[k] = 0;
    c->friction = vec3_make(0, 0, 0);
    c->twist = 0;
}

// The number of the point that is nearest to a place on A, or on B.
int contact_nearest(const contact *c, bool is_a, vec3 local);

// Warm starting: contact `now` takes over the impulses of `was`, of the same bodies,
// each old point's to the new point nearest to it.  It takes none if the normal has
// turned by more than 45 degrees, whose cosine this is.
static const real CONTACT_SAME = 0.7;       // tuned, 1
void contact_inherit(contact *now, const contact *was);

// The most rounds in which the time and place of a touch are sought, each from the last
// one's answer, and in which an impact is passed on.
enum { CONTACT_ROUNDS = 8 };                // tuned, rounds

// The most by which a contact that bears a load may give way, of the smaller radius; a
// frame takes as many substeps as that needs (substeps.c).
static const real CONTACT_GIVES = 0.0035;   // tuned, radii

// Two points touch whose gap is less than this, of the smaller radius: more than
// rounding leaves of one that has just closed.
static const real CONTACT_TOUCHES = 1e-9;

// An overlap of more than this part of the smaller radius is deep: it is reported, and
// a body so deep inside of a face has not come through that face.
static const real CONTACT_DEEP = 0.1;       // tuned, radii

// Lets a processor fetch contact c, which will be read soon.
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
