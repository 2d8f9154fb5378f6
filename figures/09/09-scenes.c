// 09-scenes.c - Figure 8 of the paper: icosahedra in a room, a cloth on a cube
// and on a rope, by the paper's system: as printed, and two moments as mended.
// 09-scenes FILE.png

#include "film.h"
#include "runner.h"

#include <stdio.h>

enum { WIDTH = 560, HEIGHT = 480, GAP = 6, LAMPS = 4, COLUMNS = 3 };

// When each scene is looked at, s: as printed, as mended, as mended.
static const real moment[SCENES][COLUMNS] = {
    { 10, 0.5, 10 }, { 0.15, 0.4, 10 }, { 0.5, 0.7, 10 }
};

static status paint_moment(scene_kind which, int column, picture *out)
{
    runner r;
    runner_kind kind = column == 0 ? AS_PRINTED : BY_PLAIN;
    int left = column * (WIDTH + GAP), top = (int)which * (HEIGHT + GAP);
    char text[64];
    status done = runner_begin(&r, kind, which, scene_options_default());
    if (!done.ok) return done;
    while (r.time < moment[which][column] - 1e-9) runner_step(&r);
    pose now = { which, &r.scene, r.at, r.time };
    done = film_paint_pose(now, LAMPS, out, left, top, WIDTH, HEIGHT);
    snprintf(text, sizeof text, "%s, %.2f s", runner_name(kind), r.time);
    picture_text(out, left + 14, top + HEIGHT - 14.0, 14,
                 colour_hex(column ? 0x0072b2 : 0xd55e00), text);
    runner_free(&r);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 09-scenes FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, COLUMNS * (WIDTH + GAP) - GAP,
                               SCENES * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    for (int k = 0; k < SCENES * COLUMNS && done.ok; k++)
        done = paint_moment((scene_kind)(k / COLUMNS), k % COLUMNS, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "09-scenes: %s\n", done.why);
    return done.ok ? 0 : 1;
}
