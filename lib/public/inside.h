//> inside-head
//>   Behind the pointer stands a world of the engine, a table for each kind of
//>   id, and the first failure.
// inside.h - the struct behind tumble_world, and what the files tumble_*.c share.
//
// Book: chapter 19.
// The files tumble_*.c check the ids and numbers of a program, and leave the work to
// the modules of the engine.

#pragma once

#include "cast.h"
#include "slots.h"
#include "step.h"
#include "store.h"
#include "surface.h"
#include "tumble.h"

typedef struct {
    shape *shape;
    int bodies;             // how many pieces are made of it
} shape_place;

typedef struct {
    int number;             // the engine's
    int shape;              // place of its shape
} body_piece;

// A piece of a surface: a triangle that something has come near.
typedef struct {
    int triangle;
    unsigned used;          // the clearing up to which it was needed
} mesh_piece;

// The sphere in which all triangles are pieces, for a body of the engine that came
// near; radius < 0: none.
typedef struct {
    int body;
    sphere ball;
} mesh_seen;

typedef struct {
    surface surface;        // in the world
    tumble_pose pose;
    int *piece;             // [triangles] the number of its piece; -1: none
    mesh_piece *of;         // [room] each piece; the first always stays
    int  room;
    int  kept;              // pieces after the last clearing
    unsigned clearings;
    int  next;              // 1 + the place of the next such body; 0: none
    mesh_seen *seen;        // [seens] by body
    int  seens, seen_room;
} body_mesh;

typedef struct {
    body_piece *piece;      // [pieces]
    int  pieces;
    body_mesh *mesh;        // NULL: it has no surface
    tumble_kind kind;
    bool is_whole;          // its pieces move as one, and it owns their shapes
    bool is_sensor;         // group and mask are 0 in the engine, and these are
    unsigned group, mask;   // its own
    int  lock;              // 1 + the engine's number of a joint that locks axes; 0
    void *user;
} body_place;

struct tumble_world {
    world world;
    slots shapes;           // of shape_place
    slots bodies;           // of body_place
    slots joints;           // of int: the engine's numbers
    slots planes;           // likewise
    int  first_mesh;        // 1 + the place of a body with a surface; 0: none
    int  *owner;            // [world.bodies] place of the body it belongs to
    int   owners;           // room
    vec3 *scratch;          // [4 * most_vertices] for questions and pictures
    int   most_vertices;    // of a shape
    tumble_contact *touching;   // contacts when tumble_world_events was last called
    int   touchings;
    tumble_contact *sensed;     // likewise for tumble_world_sensor_events; a is the
                                // sensor
    int   senses;
    bool (*meets)(void *context, const tumble_contact *c);
    void *meets_context;    // of tumble_world_choose_contacts
    status failure;         // the first one
    store_spare spare;      // memory of the world before the last restore
};

// Frees everything in a world, but not the struct.
void inside_free(tumble_world *w);

// Keeps a failure, unless there was one before.  Returns s.ok.
bool inside_is_ok(tumble_world *w, status s);
// The same with a sentence, as for status_fail.
#define inside_fail(w, ...) inside_is_ok((w), status_fail(__VA_ARGS__))
// The same for a world that could not be made: NULL has the failure, or none.
void inside_not_made(status s);
// Is w not NULL?  If it is, the failure is kept for tumble_world_failure(NULL).
bool inside_is_world(tumble_world *w);
// Is there a list of n things?  False, with a failure, if it is NULL and n > 0.
bool inside_is_list(tumble_world *w, const void *list, int n, const char *of);

// The thing of this id in a table of w; NULL, with a failure, if there is none.
void *inside_find(tumble_world *w, const slots *s, const char *what,
                  unsigned place, unsigned generation);

// Makes the world's scratch large enough for shapes of so many vertices.  False
// if memory is refused.
bool inside_reserve(tumble_world *w, int vertices);

// Makes room for the owner of one more body.  False, with a failure, if it cannot.
bool inside_reserve_owner(tumble_world *w);

// Gives a shape to w, in a new place, unless `done` says that it could not be made.
tumble_shape inside_keep(tumble_world *w, shape *made, status done);
// Removes it again.
void inside_drop(tumble_world *w, int place);

// The surface of which body b of the engine is a piece; NULL: none.
body_mesh *inside_mesh(const tumble_world *w, int b);
// The next surface after k, both in the form of first_mesh.
int  inside_next_mesh(const tumble_world *w, int k);
void inside_free_mesh(body_mesh *m);    // NULL is fine
// From now on bodies that come near a surface find pieces there.
void inside_watch_meshes(tumble_world *w);

// The thing with this id; NULL, with a failure, if it is gone.
shape_place *inside_shape(tumble_world *w, tumble_shape s);
body_place  *inside_body(tumble_world *w, tumble_body b);
int         *inside_joint(tumble_world *w, tumble_joint j);

// The engine's number of a rope or cloth that has a vertex i; -1, with a
// failure, if it has none.
int inside_vertex(tumble_world *w, tumble_body b, int i);

// Is a velocity good?  False, with a failure, if a number is not finite, or MOST_SPEED
// (m/s, rad/s) or more.
#define MOST_SPEED 1e9
bool inside_is_speed(tumble_world *w, tumble_vec3 v);

// Is a group good?  False, with a failure, if it is 0, as in options of zeros: nothing
// would meet such a body, and no question would find it.
bool inside_is_group(tumble_world *w, unsigned group);

// The body with this id, without a failure.
const body_place *inside_body_of(const tumble_world *w, tumble_body b);

// The engine's number of a body that can be moved by hand: rigid, of one piece.
// -1, with a failure, if it is none, or its numbers are not finite.
int inside_rigid(tumble_world *w, tumble_body b, tumble_vec3 p, tumble_vec3 q);

// Locks axes of a body, from where it stands; 0: none.  False, with a failure, if
// memory is refused; then none are locked.
bool inside_lock(tumble_world *w, body_place *x, unsigned axes);
// The axes that are locked.
unsigned inside_locked(const tumble_world *w, const body_place *x);

// The frame of rigid body b of the engine; b < 0: that of the world.
rigid_frame inside_frame(const tumble_world *w, int b);

// The quaternion of the rotation whose matrix has the columns x, y and z.
tumble_quat inside_quat(vec3 x, vec3 y, vec3 z);

// The id of the body in place k, and of the body to which body b of the engine belongs;
// b < 0: the ground.
tumble_body inside_body_in(const tumble_world *w, int k);
tumble_body inside_owner(const tumble_world *w, int b);

// A contact for a program, of bodies in these frames (b: NULL for a plane): only the
// points that have pushed, with their forces, or all points.
tumble_contact inside_contact(const tumble_world *w, const contact *c,
                              const rigid_frame *a, const rigid_frame *b,
                              bool has_pushed);

// Frees the ids of joints that broke, or were removed with a body.
void inside_forget_joints(tumble_world *w);

// What does a thing meet first that moves straight by `way` (m) without turning?
bool inside_sweep(const tumble_world *w, rounded thing, vec3 delta, unsigned mask,
                  tumble_hit *hit);
// What is nearest to a thing, within `most` (m, > 0), or overlaps it most?  fraction is
// the gap (m, < 0: overlap), and the normal parts the thing from it.
bool inside_near(const tumble_world *w, rounded thing, real most, unsigned mask,
                 tumble_hit *hit);

// Sets the position and axes of p to those of the pose.
void inside_place(placement *p, tumble_pose pose);

static inline int inside_compare(unsigned a, unsigned b)
{
    return (a > b) - (a < b);
}

static inline vec3 from_user(tumble_vec3 v)
{
    return (vec3){ v.x, v.y, v.z };
}

static inline tumble_vec3 to_user(vec3 v)
{
    return (tumble_vec3){ v.x, v.y, v.z };
}
//<
