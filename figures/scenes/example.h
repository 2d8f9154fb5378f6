// example.h - what a scene tells the command, and the test that holds its claim.
//
// Book: chapters 19 and 19b.  A scene is a file that includes this and tumble.h,
// and nothing else of the library.

#ifndef TUMBLE_EXAMPLE_H
#define TUMBLE_EXAMPLE_H

#include "tumble.h"

enum { EXAMPLE_LAWS = 4 };

// A number that a formula gives, or that is wanted, and the one measured.
typedef struct {
    const char *what;
    double law, measured;
} example_law;

static inline example_law example_is(const char *what, double law,
                                     double measured)
{
    example_law is = { what, law, measured };
    return is;
}

typedef struct {
    const char *name, *about;
    double seconds;
    bool has_floor;                     // at height 0
    tumble_vec3 eye, target;            // m, where a picture is taken from
    tumble_options (*options)(void);    // NULL: the defaults
    void (*build)(tumble_world *w);
    void (*act)(tumble_world *w);       // before every step; NULL: nothing
    const char *claim;                  // what must be true at the end,
    double (*error)(tumble_world *w);   // by how much it is not,
    // or in its place the laws of the scene: it writes EXAMPLE_LAWS at most, and
    // returns how many, and each may be missed by a part of its number;
    int (*laws)(tumble_world *w, example_law *out);
    double most;                        // and by how much it may not be
} example;

extern const example pyramid, dominoes, cradle, bridge, ragdoll, wrecker, marbles,
    flag, curtain, blanket;

// Chapter 19b: those of figures/manual.
extern const example car_scene, crane, terrain, walker_scene, belt_scene,
    cape_scene;

// All of them; the last is NULL.
extern const example *const examples[];

// By how much the claim of a scene is not true: its error, or of its laws the one
// that is missed the furthest, as a part of its number (where it is 0: by what).
double example_error(const example *s, tumble_world *w);

#endif
