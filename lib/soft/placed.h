//> placed-head
//>   A body is a shape, and a range of particles in the world's one pool.
// placed.h - bodies: shapes that were placed, with their particles in one pool.
//
// Book: chapter 16.
// Units: metres, seconds, kilograms.

#pragma once

#include "body.h"
#include "line.h"
#include "rigid4.h"
//<

//> placed
//>   Its material, what it may meet, and whether it moves are said when it is
//>   added.
// A body: a shape, which it may share, and a range of the pool.  The place of a body
// that was removed has a shape without particles: static, and neither rigid nor
// anywhere.
typedef struct body {
    const struct shape *shape;
    const rigid4 *rigid;    // its four particles; NULL: it is a rope or cloth, with a
                            // particle at every vertex
    line_scratch *line;     // of a rope or cloth; shared, as the shape is
    int  entry;         // of its shape, see world.h
    int  first;         // its particles: first .. first + body_particles - 1
    int  room;          // how many places of the pool are kept for it
    real mass;          // kg; HUGE_VAL: static, as a whole
    real thickness;     // m, the radius of the particles of a rope or cloth; else 0
    real bending;       // N m^2 of a rope, N m of a cloth, see bend.h
    real compliance;    // 1/N of a rope, m/N of a cloth, see line.h
    real taut;          // m/N, the compliance of a cloth's threads while it is pinned
    real inner;         // m, the inner radius of a rigid body,
    real round;         // m, and from its core to its surface; of pieces 0
    real damping;       // 1/s, the share of its velocity that it loses,
    real spin_damping;  // 1/s, and of its spin, if it is rigid
    bool is_weighed;    // its shape has a weight of its own
    real gravity;       // 1, times the world's gravity, of a rigid body
    bool is_kinematic;  // rigid, and moved by the program
    bool is_part;       // of a surface, see world_add_part
    int  family;        // pieces of one floor have the same number; 0: none
    int  rides;         // 1 + the body that has the motion of all pieces, for a piece
                        // and for that body itself; 0: it is of one piece
    int  next;          // 1 + the next piece of the same body; 0: none
    unsigned group, mask;   // bits: two bodies meet if the mask of each has a bit of
                        // the other's group
} body;

static inline bool body_is_soft(const body *b)
{
    return !b->rigid;
}
// The number of its particles in the pool: four, or one at every vertex.
static inline int body_particles(const body *b)
{
    return body_is_soft(b) ? b->shape->particles : FOUR;
}
static inline bool body_is_gone(const body *b)
{
    return b->shape->particles == 0;
}
static inline bool body_is_static(const body *b)
{
    return !(b->mass < HUGE_VAL);
}
// Can it be pushed?
static inline bool body_is_dynamic(const body *b)
{
    return b->mass < HUGE_VAL && !b->is_kinematic;
}
// The body that has the motion of body b, at number k.
static inline int body_whole(const body *b, int k)
{
    return b->rides > 0 ? b->rides - 1 : k;
}
// Is it a piece, without particles of its own?
static inline bool body_rides(const body *b)
{
    return b->rides > 0 && body_is_static(b);
}
// Does it never move?
static inline bool body_is_fixed(const body *b)
{
    return body_is_static(b) && !b->rides;
}
// Can it be pushed, or the body of which it is a piece?
static inline bool body_yields(const body *b)
{
    return body_is_dynamic(b) || body_rides(b);
}
static inline bool body_meets(const body *a, const body *b)
{
    return (a->mask & b->group) && (b->mask & a->group)
        && (body_yields(a) || body_yields(b))
        && !(a->rides && a->rides == b->rides);
}
// Does it meet nothing, not even planes, because group and mask are 0?
static inline bool body_meets_none(const body *b)
{
    return b->group == 0 && b->mask == 0;
}

// A rope or cloth and a rigid body that do not meet, because particles are pinned to
// the body, or were, and the two have not been apart since.
typedef struct {
    int soft, rigid;
    int pins;
} body_tie;
//<
