// handles.h - what a mesh looks like, without looking.

#ifndef TUMBLE_HANDLES_H
#define TUMBLE_HANDLES_H

#include "mesh.h"

// Requires: a mesh that mesh_build made.  All: -1 if memory is refused.

// Rings of half-edges that have no face.
int count_rims(const mesh *m);

// Pieces that are not joined by any edge.  Vertices without an edge do not
// count.
int count_pieces(const mesh *m);

// Handles of all pieces together: 0 for a ball or a cloth, 1 for a torus.
int count_handles(const mesh *m);

#endif
