//> scene-head
//>   A system has no scene built in. It starts from a description: shapes,
//>   where bodies of these shapes are placed and how they move, planes, and
//>   particles that are pinned.
// scene.h - what a simulation starts from: shapes, and where they are placed.
//
// Paper: section 7, Figure 8.  Book: chapter 9.
// One description for every system: the paper's (system.h) reads it, and so
// does the engine of Part II, so that both can run the same scene.
// Units: metres, seconds, kilograms.  Frame: the world's, y up.

#pragma once

#include "body.h"

#include <stdbool.h>
//<

//> scene-types
//>   The engine of Part II reads the same description. So the two can be put
//>   side by side on the same scene.
// Where a body starts, and how it moves.
typedef struct {
    vec3 position;      // m, of the shape's origin
    vec3 x, y, z;       // the shape's axes: unit, perpendicular, right-handed
    vec3 velocity;      // m/s, of the centre of mass
    vec3 spin;          // rad/s, about it
    bool is_static;     // it never moves
} placement;

// The free side of a plane: x . normal >= offset.
typedef struct plane {
    vec3 normal;        // unit, into the free side
    real offset;        // m
} plane;

typedef struct {
    int       shape;    // number of its shape
    placement where;
    vec3     *start;    // [particles] m, where its particles start, in the
                        // world, at rest; NULL: as its shape, placed
} scene_body;

// A particle of a body that never moves.
typedef struct {
    int body, particle;
} scene_pin;

// All lists grow as they are added to; the scene owns them, and the shapes.
typedef struct scene {
    int shapes, bodies, planes, pins;
    shape      *shape;
    scene_body *body;
    plane      *plane;
    scene_pin  *pin;
    real size;          // m, of the paper's scenes: side of the room or the
                        // cube, span of the rope
} scene;
//<

//> scene-declare
//>   Each of these is added by a function that may refuse it.
void   scene_init(scene *s);        // empty, owns nothing
void   scene_free(scene *s);        // and its shapes; an empty one is fine

// Takes over a shape, which is the scene's from then on, and leaves *moved
// empty; its number is what s->shapes was before.  Fails if memory is refused:
// then *moved is as it was.
status scene_add_shape(scene *s, shape *moved);

// Can a body of that shape stand there?  Fails, with its number, if a number is
// not finite, the axes are not perpendicular units, or the place is further
// from the origin than MOST_AWAY of the shape's shortest stick, whose length
// would lose its seventh digit there.
#define MOST_AWAY 1e9
status placement_check(const placement *p, const shape *s, int body);

// A body of that shape; its number is what s->bodies was before.  Fails, and
// adds nothing, if placement_check does, or memory is refused.
status scene_add(scene *s, int shape_number, placement where);

// A plane, with a normal of any length > 0, in which offset is measured, too.
// Fails if it has no finite normal and offset, or memory is refused.
status scene_add_plane(scene *s, vec3 normal, real offset);

// Pins a particle of a body.  Requires that both are there; fails if memory is
// refused.
status scene_add_pin(scene *s, int body, int pinned);

// At rest at this place, its axes those of the world.
placement placement_at(vec3 position);

const shape *scene_shape(const scene *s, int body);

// Where particle i of a body starts (m), and how fast (m/s).
vec3 scene_position(const scene *s, int body, int i);
vec3 scene_velocity(const scene *s, int body, int i);
//<
