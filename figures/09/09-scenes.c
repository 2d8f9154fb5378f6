// 09-scenes.c - Figure 8 of the paper: icosahedra in a room, a cloth on a cube
// and on a rope, three moments of each.  09-scenes FILE.png

#include "film.h"
#include "step.h"

#include <stdio.h>

enum { WIDTH = 560, HEIGHT = 480, GAP = 6, LAMPS = 6 };

// When each scene is looked at, s.
static const real moment[SCENES][STRIP_PANELS] = {
    { 0, 0.5, 10 }, { 0.1, 0.4, 5 }, { 0.2, 0.7, 5 }
};

static status paint_scene(scene_kind kind, picture *out)
{
    world_scene s;
    status done = world_scene_build(&s, kind, scene_options_default(),
                              world_scene_options(kind, 40));
    if (!done.ok) return done;
    for (int k = 0; k < STRIP_PANELS && done.ok; k++) {
        while (s.world.time < moment[kind][k] - 1e-9) world_step(&s.world);
        done = film_paint(&s, LAMPS, out, k * (WIDTH + GAP),
                          (int)kind * (HEIGHT + GAP), WIDTH, HEIGHT);
    }
    world_scene_free(&s);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 09-scenes FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, STRIP_PANELS * (WIDTH + GAP) - GAP,
                               SCENES * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    for (int k = 0; k < SCENES && done.ok; k++)
        done = paint_scene((scene_kind)k, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "09-scenes: %s\n", done.why);
    return done.ok ? 0 : 1;
}
