// example.h - what a scene tells the command, and the test that holds its claim.
//
// Book: chapter 19.  A scene is a file that includes this and tumble.h, and
// nothing else of the library.

#ifndef TUMBLE_EXAMPLE_H
#define TUMBLE_EXAMPLE_H

#include "tumble.h"

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
    double most;                        // and by how much it may not be
} example;

extern const example pyramid, dominoes, cradle, bridge, ragdoll, wrecker, marbles,
    flag, curtain, blanket;

// All of them; the last is NULL.
extern const example *const examples[];

#endif
