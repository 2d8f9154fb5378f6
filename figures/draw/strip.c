#include "strip.h"
#include "example_paint.h"
#include "play.h"

#include <stdio.h>

enum { WIDE = 420, HIGH = 320, GAP = 8, LAMPS = 5 };

// The scene, seen from the camera where its body is now.
static example seen(const example *s, const tumble_world *w,
                    const strip_camera *c)
{
    example from = *s;
    if (!c) return from;
    tumble_body all[64];
    if (tumble_world_bodies(w, all, 64) <= c->body) return from;
    tumble_vec3 at = tumble_body_position(w, all[c->body]);
    from.eye    = tumble_v(c->eye.x + at.x, c->eye.y, c->eye.z + at.z);
    from.target = tumble_v(c->target.x + at.x, c->target.y, c->target.z + at.z);
    return from;
}

static status paint(const example *s, const double *moment,
                    const strip_camera *c, tumble_world *w, picture *out)
{
    status done = status_ok();
    int taken = 0;
    s->build(w);
    while (tumble_world_time(w) < s->seconds && done.ok) {
        if (s->act) s->act(w);
        tumble_world_step(w);
        if (taken == STRIP_PICTURES || tumble_world_time(w) < moment[taken])
            continue;
        example from = seen(s, w, c);
        done = example_paint(&from, w, LAMPS, out, taken * (WIDE + GAP), 0, WIDE,
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
    return strip_along(arguments, argument, scene, moment, NULL);
}

int strip_along(int arguments, char **argument, const char *scene,
                const double moment[STRIP_PICTURES], const strip_camera *c)
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
    if (done.ok) done = paint(s, moment, c, w, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    tumble_world_free(w);
    if (!done.ok) fprintf(stderr, "%s: %s\n", scene, done.why);
    return done.ok ? 0 : 1;
}
