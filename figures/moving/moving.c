// moving.c - the three scenes side by side, a frame for each of their steps.
// moving FOLDER writes FOLDER/frame-00.png and so on; moving.sh makes one
// moving picture of them.

#include "film.h"
#include "step.h"

#include <stdio.h>

enum { WIDTH = 316, HEIGHT = 300, GAP = 6, LAMPS = 2, FRAMES = 96 };

static status build(world_scene all[SCENES])
{
    status done = status_ok();
    for (int k = 0; k < SCENES && done.ok; k++)
        done = world_scene_build(&all[k], (scene_kind)k, scene_options_default(),
                           world_scene_options((scene_kind)k, 40));
    return done;
}

static status write_frame(const world_scene all[SCENES], const char *name)
{
    picture p;
    status done = picture_init(&p, SCENES * (WIDTH + GAP) - GAP, HEIGHT,
                               colour_hex(0xffffff));
    for (int k = 0; k < SCENES && done.ok; k++)
        done = film_paint(&all[k], LAMPS, &p, k * (WIDTH + GAP), 0,
                          WIDTH, HEIGHT);
    if (done.ok) done = picture_write(&p, name);
    picture_free(&p);
    return done;
}

static status write_frames(world_scene all[SCENES], const char *folder)
{
    status done = status_ok();
    for (int i = 0; i < FRAMES && done.ok; i++) {
        char name[1024];
        snprintf(name, sizeof name, "%.999s/frame-%02d.png", folder, i);
        done = write_frame(all, name);
        for (int k = 0; k < SCENES; k++) world_step(&all[k].world);
    }
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: moving FOLDER\n");
        return 2;
    }
    world_scene all[SCENES] = { 0 };
    status done = build(all);
    if (done.ok) done = write_frames(all, argument[1]);
    for (int k = 0; k < SCENES; k++) world_scene_free(&all[k]);
    if (!done.ok) fprintf(stderr, "moving: %s\n", done.why);
    return done.ok ? 0 : 1;
}
