//> certificate-head
//>   Balls keep layers apart as long as they are not pressed too hard. This
//>   module has the last word: a frame in which cloth would cross cloth does not
//>   end so.
// certificate.h - cloth never crosses cloth, nor a rigid body: a proof for every
// frame, and what is done where there is none.
//
// Paper: not asked.  Book: chapter 16.
// Two convex sets that a plane parts at the start and at the end of a frame,
// the same plane but for its height, do not meet on the straight way between.
// And a patch that a projection spreads out at both ends does not meet itself.
// Units: metres, seconds, in the world's frame.

#pragma once

#include "near.h"
//<

//> certificate-witness
//>   What has been proved, anybody can prove again with dot products.
enum { ENDS = 2 };      // a frame, or a part of it, begins, and ends
enum { WITNESSES = 6 }; // for so many a particle there is room at first

// Cells of a cloth: from here to before there, in columns and rows.
typedef struct {
    int body, left, top, right, bottom;
} cell_range;

// A part of a cloth, and the number of the box around it; -1: none.
typedef struct {
    cell_range cells;
    int box;
} cell_part;

// What a witness speaks of: the box around a part; if there is none, all its
// vertices, or, if they are counted, some: of the pool, of a triangle.
typedef struct {
    cell_part part;
    int count, vertex[3];
} certified_set;

// WITNESS_PLANE: normal[0] . (a - b) > 0 for every vertex a of the first set
// and b of the second, at both ends.  WITNESS_SPREAD, of the range around both:
// of every triangle, with its side e along a row and f along a column,
// x = normal[0] and y = normal[1], at both ends
//     x . e > 0,  y . f > 0,  4 (x . e) (y . f) > (x . f + y . e)^2.
// WITNESS_WINDOW: of the second, likewise; the first is a part in it.
// WITNESS_NONE: the two crossed, or touched, when the way began.
// WITNESS_LOST: what was witness is none now.
typedef enum {
    WITNESS_PLANE, WITNESS_SPREAD, WITNESS_WINDOW, WITNESS_NONE, WITNESS_LOST
} witness_kind;

typedef struct {
    witness_kind kind;
    certified_set set[2];
    vec3 normal[2];
    real slack;         // m: while no two vertices go further from each other
                        // than this, it need not be asked
} witness;
//<

//> certificate-struct
// The box around a part of a cloth, at both ends.
typedef struct {
    aabb at[ENDS];
} swept_box;

// Two facets without a common vertex that no plane parts at both ends.
typedef struct {
    certified_set set[2];
    vec3 normal;        // unit: that parted them when the frame began,
    real gap;           // m, by so much
} facet_clash;

// A facet that no plane parts from a rigid body, at both ends, and was parted from
// it by one when the way began: that body is under `top`, m, along it.
typedef struct {
    certified_set set;
    int  body;
    vec3 normal;        // unit
    real top, gap;      // m
} facet_cut;

typedef struct {
    int  right, bottom; // up to here the patch reaches that has its cell, see
                        // mark_windows; 0: there is none
    bool crossed;       // it is of a pair that crossed at first
    bool moved;         // it is the first of a body that moved in the last look
    bool is_cut;        // it is the first of a body, and a rigid body cut a facet
                        // of that at the end
    int  patch;         // a vertex of what goes as one with it, or itself; that
    int  rides;         // knows the rigid body that it goes with, -1: none,
    bool is_whole;      // if there are others,
    real mass;          // kg, what all weigh,
    vec3 delta;         // kg m, and the sum of their ways
} certified_vertex;

// All but what was prevented, what is kept, and where all was when that was
// proved, is room for one way.
typedef struct {
    vec3 *at[ENDS];             // [particles] of the pool
    certified_vertex *of;       // [particles]
    swept_box *box;             // [2 particles] of parts, see halve
    facet_clash *clash;         // [particles]
    facet_cut *cut;             // [particles]
    int particles;              // for so many there is room
    int vertices;               // of all cloths
    int clashes;                // in this look, that found room or not
    int cuts;                   // in this look, that found room
    int carrier;                // a body with which some went, in this way; -1
    real rounding;              // m, no gap is wrong by as much
    real since;                 // s, since all was where it is at first
    real apart, bent;           // m, no two of them went further from each
                                // other, and no two neighbours
    real *beside;               // [particles] m^2, each from the next of its
                                // row and of its column
    bool is_boxed;              // the boxes are of this look
    vec3 *seen;                 // [particles] where ends were in the last look
    witness *kept;              // [room]: they prove that where
    int keeps;                  // all is at first none crosses; so many, or
                                // would be: 0: nothing is proved
    int room;                   // for so many: it grows with them
    int made;                   // so many there were when all were found
    int prevented;              // clashes of the last look, before they were
                                // parted,
    int left_out;               // and pairs that crossed when it began
} certificate;
//<

//> certificate-declare
// There is room for so many particles.  Fails, changing nothing, for want of
// memory.
status certificate_grow(certificate *c, int kept, int particles);
void   certificate_free(certificate *c);        // a zeroed one is fine

// A way begins: all cloth, and what it may meet, is where it is.
void certificate_begin(certificate *c, const soft_frame *f, const near_lists *near);

// A substep is over.  Has one vertex gone a spacing further than another?  Then
// the ends of the way say little of what is between, and it must end here.
bool certificate_is_due(certificate *c, const soft_frame *f);

// The way ends, and another begins: if no triangle of cloth crossed another of
// that cloth, or of one that it meets, none does now; and if none, and no link of a
// rope, met a rigid body.  Where the end cannot be proved to be so, particles are
// parted, or go as one, or with a body that does not yield; what is free keeps its
// momentum.  Pairs that crossed when the way began are left out, and those beside
// them; so is what is in the way of two bodies.  Where nothing is to be certified,
// only what rigid bodies cut is looked for.  near, view: what rigid bodies may be
// met; NULL: none.
void certificate_end(certificate *c, const soft_frame *f, const near_lists *near,
                     rigid_view *view);

// Did a rigid body cut this deformable one where the last way ended?
bool certificate_is_cut(const certificate *c, const body *soft);

// A particle has been moved at the end of a way: that is a part of all of it.
void certificate_carry(const certificate *c, const soft_frame *f, particle *p,
                       vec3 by);
//<
