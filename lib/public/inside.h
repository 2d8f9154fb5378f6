//> inside-head
// inside.h - what stands behind the handle that a program holds.
//
// Book: chapter 19.
// The files tumble_*.c check what a program hands in, and leave the work to the
// modules of the engine.  Numbers are checked there or here, ids here.

#ifndef TUMBLE_INSIDE_H
#define TUMBLE_INSIDE_H

#include "slots.h"
#include "step.h"
#include "tumble.h"

typedef struct {
    shape *shape;
    int bodies;             // that are made of it
} shape_place;

typedef struct {
    int  *piece;            // [pieces] its bodies in the engine
    int   pieces;
    int   only;             // piece points here, if there is one
    void *user;
} body_place;

struct tumble_world {
    world world;
    slots shapes;           // of shape_place
    slots bodies;           // of body_place
    slots joints;           // of joint_place
    int  *owner;            // [world.bodies] place of the body it belongs to
    int   owners;           // room
    status failure;         // the first one
};

// The world w could not do something.  Returns false.
bool inside_fail(tumble_world *w, const char *format, ...);
bool inside_fails(tumble_world *w, status s);   // if !s.ok; returns s.ok

// The thing with this id; NULL, with a failure, if it is gone.
shape_place *inside_shape(tumble_world *w, tumble_shape s);
body_place  *inside_body(tumble_world *w, tumble_body b);
// The same, without a failure.
const body_place *inside_look(const tumble_world *w, tumble_body b);

// The id of the body that body b of the engine belongs to; b < 0: the ground.
tumble_body inside_owner(const tumble_world *w, int b);

static inline vec3 from_user(tumble_vec3 v)
{
    return (vec3){ v.x, v.y, v.z };
}

static inline tumble_vec3 to_user(vec3 v)
{
    return (tumble_vec3){ v.x, v.y, v.z };
}

#endif
//<
