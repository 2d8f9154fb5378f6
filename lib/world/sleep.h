//> sleep-head
// sleep.h - bodies that have been still together fall asleep together.
//
// Paper: section 8 mentions, and omits, how it spared stacked objects.
// Book: chapter 18.
// Units: metres, seconds.

#pragma once

#include "status.h"
#include "verlet.h"

// What counts as still, for a body of 0.5 m in radius (a cube of 1 m) under
// 9.81 m/s^2.  Another one, of the radius R under g, is still if it would be,
// seen with all lengths as R and all times as sqrt(R / g): a house may take its
// time, and a pebble must be slower.  But no time is shorter than that of the
// cube.
typedef struct {
    real speed;     // m/s, sleep_speed; 0: nothing falls asleep
    real time;      // s, time_to_sleep
    real gravity;   // m/s^2, its size
    real dt;        // s, a frame
    real h;         // s: the particles were at `previous` so long ago
    real lasts;     // s: at a speed v it has still v times this to go; 0: no one
                    // knows
} sleep_rule;

// Such a speed of the cube, for a body of that radius.
real sleep_scaled(real speed, real gravity, real radius);

// A window of time, half as long as time_to_sleep.
typedef struct {
    real way;       // m, the furthest that a particle has been in it from where
                    // it was when the window began
    real before;    // m, the same in the window before; -HUGE_VAL: none
} sleep_window;

// How still a body has been.  It has two windows at any time: one begins, and
// the other is half over.
enum { WINDOWS = 2 };

typedef struct {
    sleep_window window[WINDOWS];
    int frames;     // since the younger window began
    int halves;     // half windows since the body was first observed
    int still;      // half windows for which it has been still
    bool is_moving; // too far in a window that is not over, or too fast now
    bool stands;    // see sleep_stand: in this frame
    bool stood[WINDOWS];    // in all frames of that window
} sleep_watch;

// An island is a set of movable bodies that touch, directly or through others.
typedef struct {
    int  bodies, particles;
    int  room, particle_room;
    int  *parent;       // [bodies] union-find over the contacts of a frame; of
                        // one that takes no part in it: itself
    int  *member;       // [members] what takes part: what was touched or
    int  members;       // observed; of sleepers the one that stands for them
    bool *takes_part;   // [bodies]
    int  *island;       // [bodies] the island it fell asleep with, by the body
                        // that stood for it; means nothing while awake
    int  *next;         // [bodies] what sleeps together is a ring; of one that
                        // is awake: itself
    bool *asleep;       // [bodies]
    int  sleepers;
    bool *is_restless;  // [bodies] of the body that stands for an island: one
                        // in it has not been still for long enough
    sleep_watch *watch; // [bodies]
    vec3 *start[WINDOWS];       // m, [particles] where they were when each
                        // window of their body began
} sleep_state;

// All that have a place for each body: what a saved world keeps of them, and what
// each frame begins anew.
#define SLEEP_TABLES(KEPT, ANEW)                                          \
    KEPT(island) KEPT(next) KEPT(asleep) KEPT(watch)                      \
    ANEW(parent) ANEW(member) ANEW(takes_part) ANEW(is_restless)
//<

//> sleep-declare
//>   A body has two windows at a time, half a window apart, so that a stop is
//>   noticed soon.
// Room for so many, if there were fewer; these are awake.  A zeroed state has none.
// Fails, with the room that there was, if memory is refused.
status sleep_grow(sleep_state *s, int bodies, int particles);
void   sleep_free(sleep_state *s);      // an empty or zeroed one is fine

// A new frame: every body is an island of its own, but sleepers stay with those
// that they fell asleep with.  Takes as long as the last frame had members: what
// sleeps costs nothing.
void sleep_begin(sleep_state *s);

// Bodies a and b hold each other.  Both must be movable.
void sleep_touch(sleep_state *s, int a, int b);

// Body b stands: what it lies on holds it at three points or more, and it does not
// slide there.  Such a body may sway, further now than before, and will not fall.
// To be said in each frame, before it is observed.
void sleep_stand(sleep_state *s, int b);

// At the end of a frame, once for every movable body that is awake: its
// particles are pool[first] and the n - 1 after it, none further than radius
// (m) from their middle.  A body that is not observed does not fall asleep.
//
// A body is still while it goes no further than sleep_speed would take it, and
// stands, or goes no further than in the window before: what slides, rolls or tips
// over from rest goes further and further, however slowly it begins.  Without gravity,
// only what does not move at all is still.  What is known to go on for longer than
// a window must be slower by as much.  Coordinates that are not finite are not
// still.
void sleep_observe(sleep_state *s, int b, const particle *pool, int first,
                   int n, real radius, const sleep_rule *rule);

// True if body b, awake, was seen to move in the last frame or just before it, or
// was not seen yet, for it came, was pushed or woke since: what sleeps, and is in
// its way, must wake.
bool sleep_is_moving(const sleep_state *s, int b);

// Puts to sleep every island in which all bodies have been still for
// time_to_sleep.  Returns how many bodies fell asleep.
int sleep_end(sleep_state *s);

// Puts body b to sleep, as an island of its own.
void sleep_put(sleep_state *s, int b);

// Wakes body b and all that fell asleep with it: these begin to be observed
// again.  Nothing happens if it is awake.  The islands of this frame stay as
// they are.
void sleep_wake(sleep_state *s, int b);

// Body b has been moved by hand: what was observed of it is forgotten.
void sleep_forget(sleep_state *s, int b);
//<
