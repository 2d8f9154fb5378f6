// 19-scenes.c - the ten scenes, each at a moment that shows what it is.
//   19-scenes FILE.png
//
// Prints what each claims, and by how much it holds.

#include "example_paint.h"

#include <stdio.h>

enum { ACROSS = 5, DOWN = 2, WIDE = 400, HIGH = 330, GAP = 8, LAMPS = 5 };

static const double MOMENT[ACROSS * DOWN] = {   // s
    1, 3, 0.6, 8, 1.2, 1.6, 1.3, 4, 2, 3 };

static status show(int k, picture *out)
{
    const example *s = examples[k];
    tumble_options o = s->options ? s->options() : tumble_options_default();
    tumble_world *w = tumble_world_make(&o);
    if (!w) return status_fail("%s", tumble_world_failure(NULL));
    int left = k % ACROSS * (WIDE + GAP), top = k / ACROSS * (HIGH + GAP);
    status done = status_ok();
    bool is_painted = false;
    s->build(w);
    while (tumble_world_time(w) < s->seconds && done.ok) {
        if (s->act) s->act(w);
        tumble_world_step(w);
        if (is_painted || tumble_world_time(w) < MOMENT[k]) continue;
        is_painted = true;
        done = example_paint(s, w, LAMPS, out, left, top, WIDE, HIGH);
    }
    picture_text(out, left + 14, top + 30, 20, colour_hex(0x30353c), s->name);
    printf("%s: %s: %.3g of %.3g\n", s->name, s->claim, example_error(s, w),
           s->most);
    if (done.ok && tumble_world_failure(w))
        done = status_fail("%s", tumble_world_failure(w));
    tumble_world_free(w);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 19-scenes FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, ACROSS * (WIDE + GAP) - GAP,
                               DOWN * (HIGH + GAP) - GAP,
                               colour_hex(0xffffff));
    for (int k = 0; k < ACROSS * DOWN && done.ok; k++) done = show(k, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "19-scenes: %s\n", done.why);
    return done.ok ? 0 : 1;
}
