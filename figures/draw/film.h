// film.h - pictures of a scene while it runs: a strip of three, or one.

#ifndef TUMBLE_FILM_H
#define TUMBLE_FILM_H

#include "painter.h"
#include "world_scene.h"

// A scene, and where its vertices are at a moment.
typedef struct {
    scene_kind   kind;
    const scene *scene;
    const vec3  *at;            // body after body
    real         time;          // s
} pose;

// Paints it into that box of the picture, from where the scene's camera stands.
// lamps: see painter.h.  Fails only for want of memory.
status film_paint_pose(pose s, int lamps, picture *out,
                       int left, int top, int width, int height);

// The same of the engine's world as it stands.
status film_paint(const world_scene *s, int lamps, picture *out,
                  int left, int top, int width, int height);

enum { STRIP_PANELS = 3 };

// Pictures side by side, each with its time.
typedef struct {
    long step[STRIP_PANELS];    // after which each picture is taken
    int  taken;
    picture panel[STRIP_PANELS];
} strip;

// Chooses the moments of a run of so many steps: while most of it happens, and
// the last.
strip  strip_begin(scene_kind kind, long steps, real dt);
void   strip_free(strip *t);

// Takes the pictures that are due after that step (0: before the first).
status strip_look(strip *t, pose s, long step);

// Writes the pictures taken so far side by side; none: writes nothing.
status strip_write(const strip *t, const char *path);

// Writes one picture, with its time.
status film_write(pose s, const char *path);

#endif
