// moving.c - the three scenes side by side, a frame for each of their steps, or one
// of them, larger.   moving FOLDER [SCENE]  writes FOLDER/frame-00.png and so on;
// moving.sh makes one moving picture of them.

#include "film.h"
#include "step.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 316, HEIGHT = 300, GAP = 6, LAMPS = 2, FRAMES = 96 };
enum { WIDTH_ALONE = 480, HEIGHT_ALONE = 300 };

// The scenes first to last, each so large.
typedef struct {
    world_scene scene[SCENES];
    int first, last, width, height;
} show;

// All scenes, or the one of this name; false if there is none.
static bool choose(show *s, const char *name)
{
    *s = (show){ .last = SCENES - 1, .width = WIDTH, .height = HEIGHT };
    if (!name) return true;
    for (int k = 0; k < SCENES; k++)
        if (!strcmp(name, scene_name((scene_kind)k)))
            *s = (show){ .first = k, .last = k, .width = WIDTH_ALONE, .height = HEIGHT_ALONE };
    return s->first == s->last;
}

static status build(show *s)
{
    status done = status_ok();
    for (int k = s->first; k <= s->last && done.ok; k++)
        done = world_scene_build(&s->scene[k], (scene_kind)k, scene_options_default(),
                           world_scene_options((scene_kind)k, 40));
    return done;
}

static status write_frame(const show *s, const char *name)
{
    int count = s->last - s->first + 1;
    picture p;
    status done = picture_init(&p, count * (s->width + GAP) - GAP, s->height,
                               colour_hex(0xffffff));
    for (int k = 0; k < count && done.ok; k++)
        done = film_paint(&s->scene[s->first + k], LAMPS, &p, k * (s->width + GAP), 0,
                          s->width, s->height);
    if (done.ok) done = picture_write(&p, name);
    picture_free(&p);
    return done;
}

static status write_frames(show *s, const char *folder)
{
    status done = status_ok();
    for (int i = 0; i < FRAMES && done.ok; i++) {
        char name[1024];
        snprintf(name, sizeof name, "%.999s/frame-%02d.png", folder, i);
        done = write_frame(s, name);
        for (int k = s->first; k <= s->last; k++) world_step(&s->scene[k].world);
    }
    return done;
}

int main(int arguments, char **argument)
{
    show s;
    if (arguments < 2 || arguments > 3 || !choose(&s, argument[2])) {
        fprintf(stderr, "usage: moving FOLDER [SCENE]\n");
        return 2;
    }
    status done = build(&s);
    if (done.ok) done = write_frames(&s, argument[1]);
    for (int k = s.first; k <= s.last; k++) world_scene_free(&s.scene[k]);
    if (!done.ok) fprintf(stderr, "moving: %s\n", done.why);
    return done.ok ? 0 : 1;
}
