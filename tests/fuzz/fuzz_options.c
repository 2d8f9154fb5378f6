// fuzz_options.c - the command line, and the options of worlds and scenes, from
// any bytes.  See fuzz.h.
//
// The first byte says which: words for settings_read, one a line; or a world's
// options with numbers put into them wherever.  What is accepted is built, if
// it is small, and takes a step.

#define _POSIX_C_SOURCE 200809L

#include "fuzz.h"
#include "options.h"
#include "step.h"
#include "thread.h"

static FILE *nowhere;

static void check_refused(status r)
{
    MUST(r.why[0] && memchr(r.why, 0, sizeof r.why), "no sentence");
}

// Every position of a world that was built is a number.
static void check_places(const world *w)
{
    for (int i = 0; i < w->pool.count; i++)
        MUST(vec3_is_finite(w->pool.at[i].position)
             && vec3_is_finite(w->pool.at[i].previous), "particle %d", i);
}

// Builds what is small, and lets it take a step.
static void build(scene_kind kind, scene_options what, world_options how)
{
    world_scene s;
    if (what.bodies > 12 || what.cloth > 8) return;
    memset(&s, 0x55, sizeof s);
    status r = world_scene_build(&s, kind, what, how);
    if (!r.ok) {
        check_refused(r);
        MUST(s.world.pool.count == 0 && !s.world.pool.at && !s.world.body,
             "something is left");
    } else {
        check_places(&s.world);
        if (how.substeps <= 4 && how.iterations <= 4
            && how.most_substeps <= 100) world_step(&s.world);
    }
    world_scene_free(&s);
}

// What was accepted is within its range.
static void check_settings(const settings *s)
{
    MUST(s->bodies >= 1 && s->bodies <= 20000, "%d bodies", s->bodies);
    MUST(s->cloth >= 2 && s->cloth <= 512, "a cloth of %d", s->cloth);
    MUST(s->substeps >= 0 && s->substeps <= 10000, "%d", s->substeps);
    MUST(s->iterations >= 0 && s->iterations <= 10000, "%d", s->iterations);
    MUST(s->threads >= 1 && s->threads <= MOST_THREADS, "%d", s->threads);
    MUST(s->dt >= 1e-9 && s->dt <= 1, "dt %g", s->dt);
    MUST(s->tolerance <= 1, "tolerance %g", s->tolerance);
}

static void read_words(bytes *in)
{
    enum { WORDS = 64, LETTERS = 4096 };
    static char text[LETTERS];
    char *argument[WORDS] = { text };
    int arguments = 1;
    size_t length = in->left < LETTERS - 2 ? in->left : LETTERS - 2;
    text[0] = 0;
    memcpy(text + 1, in->at, length);
    text[length + 1] = 0;
    for (char *c = text + 1; *c && arguments < WORDS; ) {
        argument[arguments++] = c;
        c += strcspn(c, "\n");
        if (*c) *c++ = 0;
    }

    settings s;
    memset(&s, 0x55, sizeof s);
    status r = settings_read(&s, arguments, argument);
    if (!r.ok) { check_refused(r); return; }
    check_settings(&s);
    if (s.help) settings_print_help(nowhere);
    if (s.list) settings_print_list(nowhere);
    if (s.help || s.list || s.version || s.replay || s.sweep)
        return;
    MUST(s.scene >= 0 && s.scene < SCENES, "scene %d", (int)s.scene);
    long steps = settings_steps(&s);
    MUST(steps >= 0 && steps <= 10000000, "%ld steps", steps);
    settings_print_notes(&s, nowhere);
    build(s.scene, settings_scene(&s), settings_world(&s));
}

// Numbers, and bytes as they come, over any part of the options.
static void read_numbers(bytes *in)
{
    scene_kind kind = (scene_kind)take_count(in, 0, SCENES - 1);
    scene_options what = { .bodies = take_count(in, 0, 13),
                           .cloth = take_count(in, 1, 9),
                           .seed = (unsigned)take_byte(in), .diagonal = 0.2 };
    world_options how = world_scene_options(kind, 40);
    how.substeps = take_count(in, 0, 5);
    how.iterations = take_count(in, 0, 5);
    how.most_substeps = take_count(in, 0, 9);
    for (int n = take_count(in, 0, 8); n > 0; n--) {
        size_t at = (size_t)take_byte(in) * 4;
        int whole = take_count(in, -2, 4);
        real x = take_real(in);
        size_t size = take_byte(in) & 1 ? sizeof whole : sizeof x;
        if (at + size > sizeof how) continue;
        const void *from = size == sizeof x ? (void *)&x : (void *)&whole;
        memcpy((char *)&how + at, from, size);
    }
    // No program is asked to call any bytes, or to read a bool from them.
    how.host = (world_host){ .clock = NULL };
    how.warm_start = how.ledger = how.relax.dead_band = take_byte(in) & 1;
    build(kind, what, how);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    bytes in = { .at = data, .left = size };
    if (!nowhere) nowhere = fopen("/dev/null", "w");
    if (take_byte(&in) & 1) read_numbers(&in);
    else read_words(&in);
    return 0;
}
