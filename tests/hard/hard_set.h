// hard_set.h - the hard cases 14 to 20, built: for hard_bodies.c, which
// measures them, and for the figures of chapter 20, which show them.
//
// Units: metres, seconds, kilograms.  Frame: y points up.

#ifndef TUMBLE_HARD_SET_H
#define TUMBLE_HARD_SET_H

#include "world.h"

enum { PLANS = 3, MOST_BODIES = 64 };

// A world with its plans.  The first thing that fails says why; the rest is not
// tried any more.  Not to be copied: the bodies point to the plans.
typedef struct {
    world  w;
    shape  plan[PLANS];
    int    plans;
    status ok;
    vec3   start[MOST_BODIES];      // m, where the bodies' middles began
} setting;

void setting_start(setting *s, world_options o);
void setting_free(setting *s);
const shape *add_box(setting *s, vec3 sides, real mass);
int  add_body(setting *s, const shape *plan, placement where);  // its number
void add_ground(setting *s);                                    // y = 0

// After all is in.  Says what failed first.
status setting_begin(setting *s);
void run_for(setting *s, real seconds);

// The middle of the particles of body b, which all have one mass; and its
// velocity (m/s) over the last substep.
vec3 middle(const world *w, int b);
vec3 velocity(const world *w, int b);

// Turned in any way: two random axes, made perpendicular.
placement turned_anyhow(vec3 position, unsigned long long *seed);

// Our best, with so many substeps; without sleep; for a pile, with friction;
// without gravity.
world_options best(int substeps);
world_options kept_awake(world_options o, bool is_awake);
world_options standing(int substeps, real friction, bool is_awake);
world_options weightless(world_options o);

// Five cubes of a metre, `gap` apart; `flying` of them
// come in from 0.3 m away: from the left (side -1) or from the right (1).
enum { CRADLE = 5, CRADLE_SPEED = 2 };                          // m/s
void build_cradle(setting *s, world_options o, real gap, int flying, int side);

// A cube of a metre, let go 1 m above the ground.
void build_bounce(setting *s, world_options o);

// A block of 1 x 0.5 x 1 m on a plane that falls along x by `tilt` (rad), with
// friction mu; `speed` down it.
void build_slope(setting *s, world_options o, real tilt, real mu, real speed);

// Cubes of a metre, one on the other; all of 1 kg but the last one.
void build_stack(setting *s, world_options o, int cubes, real last);

// Cards of 1 x 0.02 x 0.7 m: floors of tents that lean by `lean` (rad), one
// less on each, and cards across their tips between them.
void build_card_house(setting *s, world_options o, int floors, real lean);

// Half a ring of wedges on the ground, with an inner radius of
// 1 m and this outer one; and the outer one for a thickness that is this part
// of the mean radius.
void build_arch(setting *s, world_options o, int stones, real outer);
real outer_radius(real thickness);

// Two cubes of a metre, the second one's middle at `offset` from that of the
// first, which is the origin.
void build_overlap(setting *s, world_options o, vec3 offset);

#endif
