//> plain-strand-head
// plain_strand.h - one strand, solved by Thomas's algorithm: slow, and short.
//
// The oracle of lib/soft/line.c, which does the same with eight strands side by
// side.  Book: chapter 12.
// Units: metres, inverse masses in 1/kg.

#ifndef TUMBLE_PLAIN_STRAND_H
#define TUMBLE_PLAIN_STRAND_H

#include "vec3.h"

#include <stdbool.h>

typedef struct {
    vec3 at;        // m
    real weight;    // 1/kg, inverse mass
    vec3 hold;      // m of the chapter, in 1/sqrt(kg): along the normal of what
                    // it touches; 0: it is free
} plain_particle;

enum { PLAIN_LINKS = 200 };

// One Newton step towards links that are all `rest` (m) long, for a strand of
// `links` of them, 1 to PLAIN_LINKS, and links + 1 particles.
void plain_strand(plain_particle *p, int links, real rest);

// m, how far a pull (kg m) moves a particle.
vec3 plain_move(const plain_particle *p, vec3 pull);

#endif
//<
