#include "play.h"
#include "example_frames.h"
#include "example_paint.h"
#include "frames.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PANELS = 3, WIDE = 560, HIGH = 460, GAP = 8, LAMPS = 5 };

typedef struct {
    double seconds;
    const char *film;
    frames pictures, meshes;
} wishes;

const example *play_find(const char *name)
{
    for (int k = 0; examples[k]; k++)
        if (strcmp(examples[k]->name, name) == 0) return examples[k];
    return NULL;
}

void play_list(void)
{
    for (int k = 0; examples[k]; k++)
        printf("  %-14s %s\n", examples[k]->name, examples[k]->about);
}

static status read_seconds(const char *word, double *seconds)
{
    char *end;
    *seconds = strtod(word, &end);
    if (!*end && *seconds > 0 && *seconds <= 3600) return status_ok();
    return status_fail("--seconds %s: it must be a number above 0, at most "
                       "3600", word);
}

static status read_wishes(const example *e, int words, char **word, wishes *to)
{
    *to = (wishes){ .seconds = e->seconds,
                    .pictures = { .ending = ".png", .write = example_picture },
                    .meshes = { .ending = ".obj", .write = example_obj } };
    status done = status_ok();
    for (int k = 0; k < words && done.ok; k += 2) {
        const char *value = word[k + 1];        // argv ends with NULL
        if (!value)
            return status_fail("%s: what comes behind it?", word[k]);
        for (int before = 0; before < k; before += 2)
            if (strcmp(word[before], word[k]) == 0)
                return status_fail("%s is given twice", word[k]);
        if (strcmp(word[k], "--film") == 0) to->film = value;
        else if (strcmp(word[k], "--frames") == 0) to->pictures.folder = value;
        else if (strcmp(word[k], "--obj") == 0) to->meshes.folder = value;
        else if (strcmp(word[k], "--seconds") == 0)
            done = read_seconds(value, &to->seconds);
        else
            return status_fail("%s: the scene %s takes --seconds, --film, "
                               "--frames and --obj", word[k], e->name);
    }
    return done;
}

// What cannot be written is told before anything is drawn.
static status check_files(wishes *to)
{
    status done = to->film ? picture_check(to->film) : status_ok();
    if (done.ok && to->pictures.folder) done = frames_begin(&to->pictures);
    if (done.ok && to->meshes.folder) done = frames_begin(&to->meshes);
    return done;
}

static status add_frames(const example *e, wishes *to, const tumble_world *w)
{
    example_moment now = { e, w };
    status done = status_ok();
    if (to->pictures.folder) done = frames_add(&to->pictures, &now);
    if (done.ok && to->meshes.folder) done = frames_add(&to->meshes, &now);
    return done;
}

// Runs the scene, and takes a picture after each third of it.
static status run(const example *e, wishes *to, tumble_world *w, picture *film)
{
    int taken = 0;
    e->build(w);
    status done = add_frames(e, to, w);
    while (tumble_world_time(w) < to->seconds && !tumble_world_failure(w)
           && done.ok) {
        if (e->act) e->act(w);
        tumble_world_step(w);
        done = add_frames(e, to, w);
        bool is_due = tumble_world_time(w) >= to->seconds * (taken + 1)
            / PANELS;
        if (!done.ok || !to->film || !is_due || taken == PANELS) continue;
        done = example_paint(e, w, LAMPS, film, taken * (WIDE + GAP), 0, WIDE,
                             HIGH);
        taken++;
    }
    return done;
}

static void tell_frames(const frames *f)
{
    if (f->folder) printf("wrote %s: %ld frames\n", f->folder, f->count);
}

static bool tell(const example *e, const wishes *to, tumble_world *w)
{
    double error = example_error(e, w);
    bool is_whole = to->seconds >= e->seconds, holds = error <= e->most;
    tumble_report r = tumble_world_last_step(w);
    printf("%s: %s\n", e->name, e->about);
    printf("after %.3g s: %d bodies, %d asleep\n", tumble_world_time(w),
           r.bodies, r.asleep);
    if (is_whole)
        printf("%s: %s (%.3g, at most %.3g)\n", holds ? "holds" : "FAILS",
               e->claim, error, e->most);
    if (to->film) printf("wrote %s: %d pictures\n", to->film, PANELS);
    tell_frames(&to->pictures);
    tell_frames(&to->meshes);
    return holds || !is_whole;
}

static int help(const example *e)
{
    printf("tumble %s [--seconds S] [--film FILE.png] [--frames DIR] "
           "[--obj DIR]\n\n%s (%g s)\n", e->name, e->about, e->seconds);
    return 0;
}

int play(const example *e, int words, char **word)
{
    if (words > 0 && (!strcmp(word[0], "--help") || !strcmp(word[0], "-h")))
        return help(e);
    wishes to;
    bool holds = false;
    picture film = { 0 };
    tumble_options o = e->options ? e->options() : tumble_options_default();
    status done = read_wishes(e, words, word, &to);
    if (!done.ok) {
        fprintf(stderr, "tumble: %s\n", done.why);
        return 2;
    }
    tumble_world *w = tumble_world_make(&o);
    if (!w) done = status_fail("%s", tumble_world_failure(NULL));
    if (done.ok && to.film)
        done = picture_init(&film, PANELS * (WIDE + GAP) - GAP, HIGH,
                            colour_hex(0xffffff));
    if (done.ok) done = check_files(&to);
    if (done.ok) done = run(e, &to, w, &film);
    if (done.ok && tumble_world_failure(w))
        done = status_fail("%s", tumble_world_failure(w));
    if (done.ok && to.film) done = picture_write(&film, to.film);
    if (done.ok) holds = tell(e, &to, w);
    else fprintf(stderr, "tumble: %s\n", done.why);
    frames_end(&to.pictures);
    frames_end(&to.meshes);
    picture_free(&film);
    tumble_world_free(w);
    return holds ? 0 : 1;
}
