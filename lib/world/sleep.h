//> sleep-head
// sleep.h - bodies that have been still together fall asleep together.
//
// Paper: section 8 mentions, and omits, how it spared stacked objects.
// Book: chapter 18.
// Units: metres, seconds.

#pragma once

#include "status.h"
#include "verlet.h"

// When is a body still?  The numbers are for a radius of 0.5 m (a cube of 1 m) under
// 9.81 m/s^2.  For a radius R under g all lengths are scaled by R and all times by
// sqrt(R / g): a house may take its time, and a pebble must be slower.  But no time is
// shorter than that of the cube.
typedef struct {
    real speed;     // m/s, sleep_speed; 0: no body falls asleep
    real time;      // s, time_to_sleep
    real gravity;   // m/s^2, its magnitude
    real dt;        // s, a frame
    real h;         // s, the particles were at `previous` so long ago
    real lasts;     // s, a body of speed v has still v times this to go; 0: this is
                    // not known
} sleep_rule;

// A speed of that cube, scaled to a body of this radius.
real sleep_scaled(real speed, real gravity, real radius);

// A window of time, half as long as time_to_sleep.
typedef struct {
    real delta;     // m, the largest distance of a particle from where it was when
                    // the window began
    real before;    // m, the same in the window before; -HUGE_VAL: none
} sleep_window;

// How still a body has been.  It has two windows at any time, and when one begins, the
// other is half over.
enum { WINDOWS = 2 };

typedef struct {
    sleep_window window[WINDOWS];
    int frames;     // since the younger window began
    int halves;     // half windows since the body was first observed
    int still;      // half windows for which it has been still
    bool is_moving; // it has moved too far in a window, or is too fast now
    bool stands;    // in this frame, see sleep_stand,
    bool stood[WINDOWS];    // and in all frames of a window
} sleep_watch;

// An island is a set of movable bodies that touch, directly or through others.
typedef struct {
    int  bodies, particles;
    int  room, particle_room;
    int  *parent;       // [bodies] union-find over the contacts of a frame; a body
                        // that takes no part is its own parent
    int  *member;       // [members] bodies that take part, because they were touched
    int  members;       // or observed; of sleepers the one that stands for them
    bool *takes_part;   // [bodies]
    int  *island;       // [bodies] the body that stood for the island with which this
                        // one fell asleep; without meaning while it is awake
    int  *next;         // [bodies] a ring of all that sleep together; of a body that
                        // is awake, itself
    bool *asleep;       // [bodies]
    int  sleepers;
    bool *is_restless;  // [bodies] of the body that stands for an island: a body of it
                        // has not been still for long enough
    sleep_watch *watch; // [bodies]
    vec3 *start[WINDOWS];       // m, [particles] where they were when each window of
                        // their body began
} sleep_state;

// The tables with a place for each body: those that a saved world keeps, and those that
// each frame begins again.
#define SLEEP_TABLES(KEPT, ANEW)                                          \
    KEPT(island) KEPT(next) KEPT(asleep) KEPT(watch)                      \
    ANEW(parent) ANEW(member) ANEW(takes_part) ANEW(is_restless)
//<

//> sleep-declare
//>   A body has two windows at a time, half a window apart, so that a stop is
//>   noticed soon.
// Makes room for so many, if there is less; new bodies are awake.  A zeroed state has
// room for none.  False, changing nothing, if memory is refused.
bool   sleep_grow(sleep_state *s, int bodies, int particles);
void   sleep_free(sleep_state *s);      // an empty or zeroed one is fine

// Begins a frame: every body is an island of its own, but sleepers stay with those with
// which they fell asleep.  The time is that of the last frame's members, so sleepers
// cost nothing.
void sleep_begin(sleep_state *s);

// Unites the islands of bodies a and b, which touch.  Both must be movable.
void sleep_touch(sleep_state *s, int a, int b);

// Says that body b stands: it is held at three points or more, and does not slide
// there.  Such a body may sway further than before, and will not fall.  Call it in each
// frame, before sleep_observe.
void sleep_stand(sleep_state *s, int b);

// Observes a movable body that is awake, once at the end of each frame.  Its particles
// are pool[first] and the n - 1 after it, none further than radius (m) from their
// middle.  A body that is not observed does not fall asleep.
//
// A body is still while it moves no further in a window than at sleep_speed, and also
// either stands, or moves no further than in the window before: a body that slides,
// rolls or tips over from rest moves further and further, however slowly it begins.
// Without gravity only a body that does not move at all is still.  A body that is known
// to move on for longer than a window must be slower by as much.  A body whose
// coordinates are not finite is not still.
void sleep_observe(sleep_state *s, int b, const particle *pool, int first,
                   int n, real radius, const sleep_rule *rule);

// Must sleepers in its way wake for body b?  True if it is awake, and moved in the last
// frame or just before it, or has not been observed since it came, was pushed or woke.
bool sleep_is_moving(const sleep_state *s, int b);

// Puts to sleep every island in which all bodies have been still for
// time_to_sleep.  Returns how many bodies fell asleep.
int sleep_end(sleep_state *s);

// Puts body b to sleep, as an island of its own.
void sleep_put(sleep_state *s, int b);

// Wakes body b and all that fell asleep with it; they are observed from the beginning.
// Does nothing if it is awake.  The islands of this frame stay as they are.
void sleep_wake(sleep_state *s, int b);

// Forgets what was observed of body b, because it was moved from outside.
void sleep_forget(sleep_state *s, int b);
//<
