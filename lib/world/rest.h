//> rest-head
// rest.h - bodies that lie still together may sleep together.
//
// Paper: section 8 mentions, and omits, how it spared stacked objects.
// Book: chapter 16.

#ifndef TUMBLE_REST_H
#define TUMBLE_REST_H

#include "status.h"
#include "vec3.h"

// An island is a set of movable bodies that touch, directly or through others.
typedef struct {
    int  bodies;
    int  *parent;       // [bodies] union-find over the contacts of a frame
    int  *island;       // [bodies] the island it fell asleep with, by the body
                        // that stood for it; means nothing while awake
    real *calm;         // [bodies] s since it last moved faster than allowed
    char *asleep;       // [bodies]
    char *restless;     // [bodies] of the body that stands for an island: one
                        // in it is not calm yet
} rest_state;
//<

//> rest-declare
// Everybody awake.  Fails, leaving *r empty, if memory is refused.
status rest_init(rest_state *r, int bodies);
void   rest_free(rest_state *r);        // an empty or zeroed one is fine

// A new frame: every body an island of its own, but sleepers stay with those
// that they fell asleep with.
void rest_begin(rest_state *r);

// Bodies a and b touch.  Both must be movable.
void rest_touch(rest_state *r, int a, int b);

// How long each body has been calm: slow[b] says whether body b was slow enough
// throughout a frame of dt (s).  Then puts to sleep every island in which all
// have been calm for `patience` (s).
void rest_end(rest_state *r, const char *slow, real dt, real patience);

// Wakes body b and all that fell asleep with it.  Nothing happens if it is
// awake.  The islands of this frame stay as they are.
void rest_wake(rest_state *r, int b);
//<

//> rest-end-of-header
#endif
//<
