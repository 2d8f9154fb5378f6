// hard_drape_set.h - the hard cases of cloth and rope, built: for hard_cloth.c
// and hard_drape.c, which measure them, and for drape.c, which prints a table.
//
// Units: metres, seconds, kilograms.  Frame: y points up.

#ifndef TUMBLE_HARD_DRAPE_SET_H
#define TUMBLE_HARD_DRAPE_SET_H

#include "hard_judge.h"
#include "hard_set.h"

// Uniform in [-1, 1).
real any_signed(unsigned long long *seed);

// A start by chance: body `number`, deformable, turned about y by up to 5
// degrees, moved by up to 2 % of its width, every particle off by up to a thousandth of the
// spacing, unless it is pinned; no speeds.
void perturb(world *w, int number, unsigned long long seed);

// A static box whose top is at y = 0, and the paper's cloth of n x n particles:
// body 1.
void lay_table(setting *s, world_options o, vec3 sides, int n,
               placement where);

// How a cloth of n x n comes to be folded; it is body 1.
typedef enum {
    FOLD_LETTER,        // in three, laid on a table
    FOLD_OVER_CUBE,     // in three, dropped on a cube that it hangs over
    FOLD_UPRIGHT,       // stood on its edge, it crumples
    FOLDS
} fold_kind;
void build_fold(setting *s, fold_kind kind, int n);

// One row of the table: a scene, for how long it is watched, and what it must
// not exceed.
typedef struct drape {
    const char *name;
    int  hard;          // the number of its hard case
    void (*build)(setting *s, const struct drape *d);
    int  n;             // particles along a side of the cloth, or links
    real with;          // what the scene is built with: a speed (m/s), a kind
    int  frames, starts;
    real floor;         // m, see watch_plan
    real strain, end;   // targets: in every frame; in the last
    real rest, speed;   // in the last second; m/s.  With a target of speed the
                        // first two thirds of the frames are calmed
    real slowest;       // the slowest frame / the median
} drape;

// The last row has no name.  No target: HUGE_VAL.
extern const drape drape_table[];

// How a row is watched, see hard_judge.h.
watch_plan drape_plan(const drape *d);

// The same as judge_watch, for a world that drape_build has just made; and says
// by how much the cloth must be stretched (hard_springs.h).
bool drape_watch(const drape *d, world *w, verdict *v);

// Do bodies fall on it, so that it must be stretched?
bool drape_is_struck(const drape *d);

// The world of a row, begun; start 0: as it is; 1, 2, ...: perturbed, each in
// its own way.
void drape_build(setting *s, const drape *d, int start);

#endif
