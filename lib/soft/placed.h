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
// A body: a range of the pool, built to a shape that it may share.  The place of
// one that was taken away is left to one of a shape without particles: static,
// deformable, and nowhere.
typedef struct body {
    const struct shape *shape;
    const rigid4 *rigid;    // its four particles; NULL: it is deformable, with
                            // a particle at every vertex
    line_scratch *line;     // of a deformable one; shared, as the shape is
    int  entry;         // of its shape, see world.h
    int  first;         // its particles: first .. first + body_particles - 1
    int  room;          // so many of the pool are kept for it
    real mass;          // kg; HUGE_VAL: static, as a whole
    real thickness;     // m, the radius of a deformable body's particles; 0 of
                        // a rigid one
    real bending;       // N m^2, or N m, of a deformable one: see bend.h
    real compliance;    // 1/N, or m/N, of a deformable one: see line.h; and, m/N,
    real taut;          // what the threads of a cloth give by where it is pinned
    real inner;         // m, the inner radius of a rigid one,
    real round;         // and from its core to its surface; of pieces: 0
    real damping;       // 1/s, the share of its velocity that it loses,
    real spin_damping;  // 1/s, and of its spin, if it is rigid
    bool is_weighed;    // its shape has a weight of its own
    real gravity;       // 1, so many times the world's acts on it, if it is rigid
    bool is_kinematic;  // rigid, and moves as a program says
    bool is_part;       // of something that is larger, see world_add_part
    int  family;        // pieces of one body have one number; 0: it is alone
    int  rides;         // 1 + the body that has all of its pieces' motion, for a
                        // piece and for that body itself; 0: it is all of one
    int  next;          // 1 + the next piece that rides with it; 0: none
    unsigned group, mask;   // bits: two meet if the mask of each has a bit of
                        // the other's group
} body;

static inline bool body_is_soft(const body *b)
{
    return !b->rigid;
}
// How many particles body b has in the pool: four, or one at every vertex.
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
// It may be pushed.
static inline bool body_is_dynamic(const body *b)
{
    return b->mass < HUGE_VAL && !b->is_kinematic;
}
// The body that has the motion of body b, at number k.
static inline int body_whole(const body *b, int k)
{
    return b->rides > 0 ? b->rides - 1 : k;
}
// It has the particles of another one.
static inline bool body_rides(const body *b)
{
    return b->rides > 0 && body_is_static(b);
}
// It never moves.
static inline bool body_is_fixed(const body *b)
{
    return body_is_static(b) && !b->rides;
}
// It may be pushed, or what it rides on.
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
// What is in no group and looks for none: planes it does not meet, either.
static inline bool body_meets_none(const body *b)
{
    return b->group == 0 && b->mask == 0;
}

// A deformable body and a rigid one that do not meet: particles are pinned to
// it; or none is any more, but the two have not been apart since.
typedef struct {
    int soft, rigid;
    int pins;
} body_tie;
//<
