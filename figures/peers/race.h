// race.h - one scene, several engines: what is in it, what moves it, and what
// judges it.
//
// A scene is written once, in numbers; an engine is a mover, which builds the
// scene with its own public interface.  Errors are taken from positions alone, by
// code that no engine shares.
// Units: metres, seconds, kilograms.  Frame: y points up.  Also read as C++.

#ifndef TUMBLE_RACE_H
#define TUMBLE_RACE_H

#include "vec3.h"

#include <stdio.h>

// ---- A scene ---------------------------------------------------------------

// Where a body is: its middle, and its three axes.
typedef struct {
    vec3 middle, x, y, z;
} pose;

enum { FORM_CORNERS = 12, FORMS = 6, WALLS = 6 };
typedef enum { FORM_BOX, FORM_ICOSAHEDRON, FORM_BALL } form_kind;

// A convex body about its middle, which is its own mirror image there: of two
// directions that are opposite, one is listed.
typedef struct {
    form_kind kind;
    vec3 half;              // m, of a box
    real radius;            // m, from the middle to a corner, or of a ball
    real mass;
    int  corners, normals, edges;
    vec3 corner[FORM_CORNERS / 2], normal[10], edge[15];    // m; unit; unit
} body_form;

typedef struct {
    int  form;
    pose at;
    vec3 velocity, spin;    // m/s, rad/s
} body_start;

// A point of body a and one of body b stay together; b = -1: of the world.
typedef struct {
    int  a, b;
    vec3 at;
} ball_joint;

// A square cloth of side x side vertices in the plane y = middle.y, pinned at its
// first `pins` corners.  Vertex (i, j), i along x, is number j side + i.
typedef struct {
    int  side, pins;
    real width, mass;
    vec3 middle;
} cloth_sheet;

// Runs that a scene has: with sleeping switched off, as it comes, or both.
typedef enum { RUN_AWAKE = 1, RUN_DEFAULT = 2, RUN_BOTH = 3 } run_kinds;

typedef struct {
    const char *name;
    int    bodies, fixed;       // the first `fixed` of them are static
    int    frames, timed_from;  // frames before that are not timed
    run_kinds runs;
    int    forms, joints, walls;
    body_form form[FORMS];
    body_start *body;           // [bodies]
    ball_joint *joint;          // [joints]
    vec3   normal[WALLS];       // unit, to the free side
    real   offset[WALLS];       // m, x . normal of the wall
    cloth_sheet sheet;               // side = 0: there is none
    real   friction, dt;
    bool   is_built;            // to stand as it is
} scene;

// Another throw, or another small displacement, for every seed.
typedef scene scene_maker(int size, int seed);
scene_maker make_thrown, make_pyramid, make_tower, make_drop, make_stacks,
    make_dolls, make_chain, make_sizes, make_hard_pair, make_rolling,
    make_cloth_on_cube, make_flag, make_cloth_with_boxes;
void scene_free(scene *s);

// The number of a vertex of the sheet that is a corner of it.
static inline int sheet_corner(const cloth_sheet *c, int k)
{
    return (k & 1 ? c->side - 1 : 0) + (k & 2 ? c->side * (c->side - 1) : 0);
}

// ---- What moves it ---------------------------------------------------------

// setting 0: every option as it comes.  may_sleep = false: sleeping is switched
// off, all else as it comes.
typedef struct {
    void *(*begin)(const scene *s, int setting, bool may_sleep);
    void (*step)(void *self);
    pose (*look)(const void *self, int body);
    void (*vertices)(const void *self, vec3 *at);   // of the sheet
    int  (*asleep)(const void *self);               // bodies
    void (*end)(void *self);
} mover;

#ifdef __cplusplus
#define NEVER_RETURNS [[noreturn]]
extern "C" {
#else
#define NEVER_RETURNS _Noreturn
#endif
extern const mover tumble_mover;    // setting: substeps, and at most so many
extern const mover box3d_mover;     // setting: substeps
extern const mover jolt_mover;      // setting: collision steps; below 0: as many
                                    // iterations, of joints, contacts, cloth
NEVER_RETURNS void give_up(const char *why);
#ifdef __cplusplus
}
#endif

// ---- A race ----------------------------------------------------------------

enum { CONTENDERS = 8 };

typedef struct {
    const mover *is;
    const char  *name;
    int setting;
} contender;

// How it is run.  A race is one against the first of its list; throws have the
// seeds 1, 2, ...
typedef struct {
    int   throws;
    bool  is_quick;         // a fifth of the frames
    FILE *times[2];         // awake; as it comes
    FILE *errors, *cloths;
} race_form;

// Opens the tables PEER.csv, PEER-times.csv, PEER-default.csv and PEER-cloth.csv in
// a folder.  throws = 0: a quick race.
race_form race_begin(const char *folder, const char *peer, int throws,
                     bool has_cloth);
void race_end(race_form *f);
void race_scene(const race_form *f, scene_maker *make, int size,
                const contender *list, int count);

// ---- The judge -------------------------------------------------------------

// What was found in the frames that were judged.
typedef struct {
    real overlap;           // m, deepest of two bodies, or of one in a wall
    real gap;               // m, widest of a joint
    real strain;            // largest |length - rest| / rest of a thread
    real strain_now;        // the same, in the frame judged last
    real into;              // m, deepest vertex of the sheet in a body
    int  lost;              // bodies or vertices that are no number
    pose a, b;              // the two bodies that were deepest
    int  form_a, form_b;
    real pair;              // m, so deep
    real *depth;            // m, [depths] of all that overlapped
    int  depths, room;
} verdict;

// m, how deep two bodies are in each other; 0 or less: they are apart.  What is
// less than `known` may be said to be 0.
real forms_depth(const body_form *f, const pose *a, const body_form *g, const pose *b,
                 real known);

// Looks at all bodies and joints; with all_pairs it keeps every depth.
void judge_bodies(const scene *s, const pose *at, bool all_pairs, verdict *v);
void judge_sheet(const scene *s, const pose *at, const vec3 *vertex, verdict *v);

// Pairs of triangles of the sheet that cross.
long judge_crossings(const scene *s, const vec3 *vertex);

// Holds the deepest pair against the slow oracle; gives up if they differ.
void judge_the_judge(const scene *s, const verdict *v);

#endif
