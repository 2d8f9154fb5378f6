// runner.h - a scene, and the system that moves it: the engine, or the paper's
// as mended or as printed.  What it gives is the same for all three.

#ifndef TUMBLE_RUNNER_H
#define TUMBLE_RUNNER_H

#include "poses.h"
#include "system.h"
#include "world_scene.h"

typedef enum {
    BY_ENGINE,          // chapter 18
    BY_PLAIN,           // chapter 9, as mended
    AS_PRINTED,         // chapter 9, as printed
    RUNNERS
} runner_kind;

// Not to be copied or moved: the bodies point to the scene's shapes.
typedef struct {
    runner_kind kind;
    scene_kind  scene_kind;
    scene  scene;
    world  world;               // BY_ENGINE
    particle_system plain;      // the others
    int    particles;           // a particle at every vertex
    vec3  *at;                  // [particles] m, body after body
    vec3  *before;              // [particles] m, a substep ago
    real   time;                // s
    long   relaxed, tested;     // distance constraints in the last step
    int    contacts;            // at its end
    int    lost;                // bodies that are not finite
    int    unconverged;         // contacts and bodies that the last step left
                                // far from right
    long   dropped, capped;     // in all steps: contacts that found no room,
                                // queries that were cut off
} runner;

// "engine", "as mended", "as printed".
const char *runner_name(runner_kind kind);

// The options that the kind runs a scene with, unless it is told others.
system_options runner_options(runner_kind kind);

// Builds one of the paper's scenes.  As printed the cloth's diagonals are as
// stiff as the rest.  Fails with a sentence, leaving *r empty.
status runner_begin(runner *r, runner_kind kind, scene_kind which,
                    scene_options what);
// The same with options of one's own: the engine's, or the system's.
status runner_begin_world(runner *r, scene_kind which, scene_options what,
                          world_options how);
status runner_begin_system(runner *r, runner_kind kind, scene_kind which,
                           scene_options what, system_options how);
// Any scene, which becomes the runner's (*taken is empty afterwards, whatever
// happens), with default options.
status runner_begin_scene(runner *r, runner_kind kind, scene *taken);
void   runner_free(runner *r);

void   runner_step(runner *r);

// The engine's own measures; of the paper's system the same, without
// `potential` and `angular`.
measures runner_measure(runner *r);
poses    runner_poses(const runner *r);
// m: the mean of a body's vertices.
vec3     runner_middle(const runner *r, int b);

// FNV-1a over the bytes of all positions.
unsigned long long runner_hash(const runner *r);

#endif
