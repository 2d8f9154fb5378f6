// 16-threads.c - rooms in one thread and in two, frame by frame in turn, with
// the same bits.  Nobody sleeps.
//
// bodies; the share of one thread's time that lies in halves; how much of its
// time would be left if the halves cost nothing but the longer one; the time on
// the wall in two threads, in parts of that in one, frame beside frame, the
// median.  (The wall is everybody's: believe it on a quiet machine.)  Columns are separated by spaces; lines that open with #threads
// are the table of chapter 14.

#define _POSIX_C_SOURCE 200809L

#include "clock.h"
#include "world_scene.h"
#include "step.h"
#include "thread.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SIZES = 4, FRAMES = 120, SKIPPED = 60 };
static const int BODIES[SIZES] = { 100, 300, 1000, 3000 };

static real now(clockid_t which)
{
    struct timespec t;
    clock_gettime(which, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

static real cpu(void)
{
    return now(CLOCK_THREAD_CPUTIME_ID);
}

// s, in both halves, and in the longer one of each call.
typedef struct {
    real both, longer;
} halves_time;

// One thread, which looks at the clock.
static void in_turn(void *context, void (*work)(void *data, int half),
                    void *data)
{
    halves_time *t = context;
    real start = cpu();
    work(data, 0);
    real middle = cpu();
    work(data, 1);
    real end = cpu();
    t->both += end - start;
    t->longer += fmax(middle - start, end - middle);
}

static void room(world_scene *s, int bodies,
                 void (*both)(void *, void (*)(void *, int), void *),
                 void *context)
{
    scene_options what = scene_options_default();
    world_options how = world_scene_options(SCENE_ROOM, 0);
    what.bodies = bodies;
    how.resting = 0;
    how.both = both;
    how.both_context = context;
    if (!world_scene_build(s, SCENE_ROOM, what, how).ok) exit(1);
}

static real step(world_scene *s)
{
    real start = now(CLOCK_MONOTONIC);
    world_step(&s->world);
    return now(CLOCK_MONOTONIC) - start;
}

static void race_rooms(int bodies, thread *second)
{
    real ratio[FRAMES];
    halves_time t = { 0, 0 };
    real all = 0;
    world_scene one, two;
    room(&one, bodies, in_turn, &t);
    room(&two, bodies, thread_both, second);
    for (int k = -SKIPPED; k < FRAMES; k++) {
        real start = cpu(), alone = step(&one);
        all = k < 0 ? 0 : all + cpu() - start;
        if (k < 0) t = (halves_time){ 0, 0 };
        real together = step(&two);
        if (k >= 0) ratio[k] = together / alone;
    }
    if (world_hash(&one.world) != world_hash(&two.world)) exit(1);
    real share = t.both / all, bound = 1 - share + t.longer / all;
    real wall = clock_median(ratio, FRAMES);
    printf("%d %.3f %.3f %.3f\n", bodies, share, bound, wall);
    printf("#threads| %d,%.2f,%.2f,%.2f,%.2f\n", bodies, share,
           1 - share / 2, bound, wall);
    world_scene_free(&one);
    world_scene_free(&two);
}

int main(void)
{
    thread *second = thread_new();
    if (!second) return 1;
    clock_print_head("16-threads: a room in two threads beside one", FLAGS);
    printf("#threads| bodies,share of time in halves,left if they were equal,"
           "left as they are,on the wall\n");
    for (int k = 0; k < SIZES; k++) race_rooms(BODIES[k], second);
    thread_free(second);
    return 0;
}
