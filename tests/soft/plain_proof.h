//> plain-proof-head
// plain_proof.h - triangles that never cross: slow, and short.
//
// The oracle of lib/soft/certificate.c, which proves whole patches of cloth at
// once, remembers its proofs, and keeps more of the moves.  Book: chapter 16.
// Units: metres.

#ifndef TUMBLE_PLAIN_PROOF_H
#define TUMBLE_PLAIN_PROOF_H

#include "gjk.h"

// Particles go straight, each from one place to another.  No triangle crosses
// another one where they begin.
typedef struct {
    int  particles, faces;
    const int (*face)[3];       // [faces]
    const vec3 *from;           // [particles]
    vec3 *to;                   // [particles]
} plain_cloth;

// Shortens moves until it is proved that no triangle crosses another one on the
// way.  Returns how often two features had their moves halved.
int plain_proof(plain_cloth *c);

#endif
//<
