// piles.h - boxes in piles: the same scenes for this library and for others, and
// one judge of them all.
//
// Units: metres, seconds, kilograms.  Frame: y points up.  Also read as C++.

#ifndef TUMBLE_PILES_H
#define TUMBLE_PILES_H

#include "vec3.h"

// ---- A scene ---------------------------------------------------------------

// Where a box lies: its middle, and its three axes.
typedef struct {
    vec3 middle, x, y, z;
} pose;

typedef struct {
    pose at;
    vec3 velocity, spin;    // m/s, rad/s
} start;

enum { PILE_WALLS = 6, PILE_CORNERS = 12 };

// A convex body about its middle, which is its own mirror image there: of two
// directions that are opposite, one is listed.
typedef struct {
    int  corners, normals, edges;
    vec3 corner[PILE_CORNERS / 2], normal[10], edge[15];    // m; unit; unit
} solid;

// Cubes of 1 kg that are all the same size, on y = 0 or in a pit or a room.
typedef struct {
    const char *name;
    int    boxes, frames;
    solid  body;
    real   half;            // m, half an edge
    real   radius;          // m, from the middle to a corner
    start *box;             // [boxes]
    vec3   normal[PILE_WALLS];      // unit, to the free side
    real   offset[PILE_WALLS];      // m, x . normal of the wall
    int    walls;
    real   friction, dt;
    bool   is_built;        // to stand as it is
} pile;

pile pile_pyramid(int rows);
pile pile_tower(int boxes);
pile pile_drop(int boxes);      // in a grid over a pit, turned at random
pile pile_thrown(int boxes);    // into a closed room
void pile_free(pile *p);

// ---- What moves it ---------------------------------------------------------

// Several of one kind may run at a time.
typedef struct {
    const char *name;
    void *(*begin)(const pile *p, int setting, bool may_sleep);
    void (*step)(void *self);
    pose (*look)(const void *self, int box);
    int  (*asleep)(const void *self);   // boxes
    void (*end)(void *self);
} mover;

#ifdef __cplusplus
#define NEVER_RETURNS [[noreturn]]
extern "C" {
#else
#define NEVER_RETURNS _Noreturn
#endif
extern const mover mover_tumble;    // setting: substeps
extern const mover mover_ode;       // iterations of quickstep; 0: dWorldStep
extern const mover mover_bullet;    // iterations
NEVER_RETURNS void give_up(const char *why);
#ifdef __cplusplus
}
#endif

// ---- A run -----------------------------------------------------------------

enum { SETTINGS = 6 };

// A mover with the settings of its curve.  The one in `as_it_comes` is what its
// users get who set nothing.
typedef struct {
    const mover *is;
    const char  *name, *unit;
    real longest;       // s, a run that takes more is cut off
    int  settings, setting[SETTINGS], as_it_comes;
    bool may_sleep;     // once more, as it comes
} contender;

// Runs and judges a scene by all of them in turn, prints a block for each and
// the rows of the table, and frees the scene.
void run_scene(pile p, const contender *list, int count);

// ---- The judge -------------------------------------------------------------

// Over the frames that were judged.
typedef struct {
    real overlap;           // m, deepest of two boxes, or of one in a wall
    real moved;             // m, farthest from its start, at the end
    real crept;             // m, farthest that one went in the time from 5 s
                            // to the end
    int  outside;           // boxes that are behind a wall, or no number
    pose a, b;              // the two boxes that were deepest
    real pair;              // m, so deep
} verdict;

// m, how deep two bodies are in each other; negative: so far apart at least.
real solids_depth(const solid *s, const pose *a, const pose *b);

// Looks at all boxes.
void judge_overlap(const pile *p, const pose *at, verdict *v);

// Holds the deepest pair against the slow oracle; gives up if they differ.
void judge_the_judge(const pile *p, const verdict *v);

#endif
