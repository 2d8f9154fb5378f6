//> feature-head
// feature.h - which part of a body is touched: a point of a vertex, of an edge
// or of a face, as a weighted mean of vertices.
//
// Paper: section 5.1, the features of the hit face.  Book: chapter 5.

#pragma once

#include "vec3.h"

// How two features meet.
typedef enum {
    TOUCH_VERTEX_FACE,  // a vertex of A against a face of B
    TOUCH_FACE_VERTEX,  // a face of A against a vertex of B
    TOUCH_EDGE_EDGE     // and what is between: vertex and vertex, flat on flat
} touch_kind;

// A point of a vertex (count 1), an edge (2) or a face (3).  The weights are
// its barycentric coordinates: >= 0, sum 1.
typedef struct {
    int  count;
    int  vertex[3];
    real weight[3];
} feature_point;

// Adds a vertex with its weight; a vertex that is there already gains weight.
// Requires: at most three different vertices.
void feature_add(feature_point *f, int vertex, real weight);

// The point itself, in the frame of `at`, the positions of all vertices.
vec3 feature_at(const feature_point *f, const vec3 *at);
//<
