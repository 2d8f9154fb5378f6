#include "strip.h"
#include "example_paint.h"
#include "play.h"

#include <stdio.h>

enum { WIDE = 420, HIGH = 320, GAP = 8, LAMPS = 5 };

static status paint(const example *s, const double *moment, tumble_world *w,
                    picture *out)
{
    status done = status_ok();
    int taken = 0;
    s->build(w);
    while (tumble_world_time(w) < s->seconds && done.ok) {
        if (s->act) s->act(w);
        tumble_world_step(w);
        if (taken == STRIP_PICTURES || tumble_world_time(w) < moment[taken])
            continue;
        done = example_paint(s, w, LAMPS, out, taken * (WIDE + GAP), 0, WIDE,
                             HIGH);
        taken++;
    }
    if (!done.ok) return done;
    if (tumble_world_failure(w))
        return status_fail("%s", tumble_world_failure(w));
    return example_error(s, w) <= s->most ? status_ok()
         : status_fail("it is not so: %s", s->claim);
}

int strip_main(int arguments, char **argument, const char *scene,
               const double moment[STRIP_PICTURES])
{
    const example *s = play_find(scene);
    if (arguments != 2 || !s) {
        fprintf(stderr, "usage: %s FILE.png\n", argument[0]);
        return 2;
    }
    tumble_options o = s->options ? s->options() : tumble_options_default();
    tumble_world *w = tumble_world_make(&o);
    picture p;
    status done = picture_init(&p, STRIP_PICTURES * (WIDE + GAP) - GAP, HIGH,
                               colour_hex(0xffffff));
    if (done.ok && !w) done = status_fail("%s", tumble_world_failure(NULL));
    if (done.ok) done = paint(s, moment, w, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    tumble_world_free(w);
    if (!done.ok) fprintf(stderr, "%s: %s\n", scene, done.why);
    return done.ok ? 0 : 1;
}
