//> four-head
// four.h - any rigid body is four particles and six sticks.
//
// Paper: section 4 puts a particle at every vertex, whose inertia is 2.3 to 5
// times the solid's.  Here: Routh's four equal masses, with the mass, the
// centre and the inertia of the solid (Laus and Selig 2020).
// Book: chapter 13.
// Units: metres, kilograms.

#ifndef TUMBLE_FOUR_H
#define TUMBLE_FOUR_H

#include "body.h"

enum { FOUR = 4, FOUR_STICKS = 6, FOUR_AXES = 3 };

// The plan of a body of four particles.  The vertices of the mesh ride on them:
// vertex v is the weighted mean of the four, by fixed weights.
typedef struct four {
    vec3  at[FOUR];         // m, at rest, in the frame of the shape
    vec3  center;           // m, the solid's centre of mass, in that frame
    real  mass;             // kg, of each of the four
    real  radius;           // m, their largest distance from the centre
    real  reach;            // m, the vertices' largest distance from it
    struct stick stick[FOUR_STICKS];        // every pair
    real  square[FOUR_AXES];        // m^2, of the frame's vectors
    real  per_sum[FOUR_STICKS];     // 1/m^2, of two of them: 00 11 22 01 02 12
    int   turns_right;      // 1, 2 and 3 at rest, as seen from 0
    real (*weight)[FOUR];   // [shape->particles] their sum is 1
    real  middle[FOUR];     // the weights of the mean of all vertices
    real  swing;            // when no particle goes further than 1 m no vertex
                            // goes further than this
} four;
//<

//> four-ways-head
// How four particles can move while their sticks hold: all alike along x, y
// and z, and in three turns.  Every way is as long as 1 m kg^(1/2) (the sum of
// mass times move squared is 1), and perpendicular to the others.
enum { TURNS = 3, FOUR_WAYS = 3 + TURNS };

typedef struct {
    real along;             // m, how far all four go along an axis
    vec3 turn[TURNS][FOUR]; // m, how each goes in a turn
} four_ways;
//<

//> four-declare
// The four particles of the solid that the closed mesh of s encloses, filled
// evenly with the mass of s.  Fails, leaving *f empty, if s has no volume (or
// one so thin that rounding loses it), or memory is refused.
status four_build(four *f, const shape *s);
void   four_free(four *f);      // an empty or zeroed one is fine

// Where the n vertices stand, when the particles stand at p.
void four_ride(const four *f, const particle *p, vec3 *at, int n);

// What one solve did, or several: as a relax_result, and how many were relaxed
// one stick after the other in the end.
typedef struct {
    real worst;
    int  tested, relaxed, iterations;
    int  fell_back;
} four_result;

// Brings the six sticks to their lengths at once: Newton's step for all of
// them, until none is off by more than options.tolerance, at most `steps` times
// (at least 1).  Told as a frame of three vectors along the solid's axes, the
// six can be solved one by one: there is no matrix to be inverted.
// Gradients as options.gradient says; where this fails (violent turning), the
// sticks are relaxed one by one (fell_back = 1).  Nailed bodies stay.
four_result four_relax(const four *f, particle *p, int steps,
                        relax_options options);

// The same for several bodies, whose particles begin at p + first[0] and so on:
// the same bits, in less time, for it takes some at once.  Counts are sums,
// `worst` and `sweeps` the largest.
four_result four_relax_all(const four *f, particle *p, const int *first,
                            int bodies, int steps, relax_options options);

//<

//> four-ways-declare
// The ways of four particles, of `inverse_mass` (1/kg) each, that stand at
// `at`.  None for a nailed body: all zero.
void four_find_ways(const vec3 at[FOUR], real inverse_mass, four_ways *w);

// How far the point with these shares goes along each of three directions d
// when the body goes 1 m kg^(1/2) along each way.
void four_rows(const four_ways *w, const real share[FOUR], const vec3 d[3],
               real row[3][FOUR_WAYS]);

// How far apart two points are along each of three directions, when they were
// `was`, and the bodies they ride on have gone by a and b along their ways:
// rows as above, those of b for the opposite directions.  `apart` is an array of
// its own.
void four_part(const real (*row_a)[FOUR_WAYS], const real (*row_b)[FOUR_WAYS],
               const real *was, const real *a, const real *b, real *apart);

// Pushes of l along the three directions (kg m) take the body along its ways.
void four_go(const real (*row)[FOUR_WAYS], const real *l, real *way);

// Where the particles go, when the body goes so far along each way: move, m.
void four_move(const four_ways *w, const real along[FOUR_WAYS],
               vec3 move[FOUR]);

// Do the particles stand as in a mirror?  (No stick can tell.)
int four_is_mirrored(const four *f, const particle *p);
//<

//> four-end
#endif
//<
