// 18-threads.c - rooms in one thread, in two and in four, frame by frame in
// turn, with the same bits.  No body sleeps.
//
// Columns: bodies; the share of one thread's time that lies in items of work;
// what would be left of that time with two threads, and with four, if each took
// the next item at no cost (one thread, which looks at the clock at every item,
// tells); the time on the wall in two threads, and in four, in parts of that in
// one, frame beside frame, the median (the wall belongs to all programs: believe
// it on a quiet machine; NaN where there are fewer processors than threads);
// items in a frame; microseconds of an item.  Columns are separated by spaces;
// lines that open with #threads are the table of chapter 18.

#define _POSIX_C_SOURCE 200809L

#include "clock.h"
#include "world_scene.h"
#include "step.h"
#include "thread.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SIZES = 4, FRAMES = 120, SKIPPED = 60, WAYS = 3, MOST = 4 };
static const int BODIES[SIZES] = { 100, 300, 1000, 3000 };
static const int THREADS[WAYS] = { 1, 2, 4 };

static real now(clockid_t which)
{
    struct timespec t;
    clock_gettime(which, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

// s, of this thread alone: what other programs do to it does not count.
static real cpu(void)
{
    return now(CLOCK_THREAD_CPUTIME_ID);
}

// s, that it takes to ask that clock.
static real cost_of_cpu(void)
{
    enum { TIMES = 10000 };
    real start = cpu();
    for (int k = 1; k < TIMES; k++) cpu();
    return (cpu() - start) / TIMES;
}

// ---- One thread that looks at the clock --------------------------------------

typedef struct {
    real cost;              // s, of a look
    long items;
    real inside;            // s, in all items
    real left[WAYS];        // s, that so many threads would take for them
} item_times;

// Who is free first takes the next item; when all are done the call is over.
static void hand_out(real *busy, int threads, real took)
{
    int first = 0;
    for (int t = 1; t < threads; t++)
        if (busy[t] < busy[first]) first = t;
    busy[first] += took;
}

static void in_turn(void *context, void (*work)(void *data, int item),
                    void *data, int items)
{
    item_times *t = context;
    real busy[WAYS][MOST] = { { 0 } };
    for (int k = 0; k < items; k++) {
        real start = cpu();
        work(data, k);
        real took = real_max(cpu() - start - t->cost, 0);
        t->inside += took;
        for (int i = 0; i < WAYS; i++) hand_out(busy[i], THREADS[i], took);
    }
    t->items += items;
    for (int i = 0; i < WAYS; i++) {
        real longest = 0;
        for (int k = 0; k < THREADS[i]; k++)
            longest = real_max(longest, busy[i][k]);
        t->left[i] += longest;
    }
}

// ---- The race ------------------------------------------------------------------

static void room(world_scene *s, int bodies, tasks run)
{
    scene_options what = scene_options_default();
    world_options how = world_scene_options(SCENE_ROOM, 0);
    what.bodies = bodies;
    how.sleep_speed = 0;
    how.host.run = run;
    if (!world_scene_build(s, SCENE_ROOM, what, how).ok) exit(1);
}

static real step(world_scene *s)
{
    real start = now(CLOCK_MONOTONIC);
    world_step(&s->world);
    return now(CLOCK_MONOTONIC) - start;
}

// In parts of the frame's time in one thread.
typedef struct {
    real share, left[WAYS], wall[WAYS];
    real items, each;           // in a frame; s
} outcome;

static real median_of(real (*column)[WAYS], int way)
{
    real x[FRAMES];
    for (int k = 0; k < FRAMES; k++) x[k] = column[k][way];
    return clock_median(x, FRAMES);
}

static outcome race_rooms(int bodies, tasks *run)
{
    static real share[FRAMES][WAYS], wall[FRAMES][WAYS], left[FRAMES][WAYS];
    static real size[FRAMES][WAYS];
    real cost = cost_of_cpu();
    item_times t;
    world_scene timed, other[WAYS];
    outcome o;
    room(&timed, bodies, (tasks){ in_turn, &t });
    for (int i = 0; i < WAYS; i++) room(&other[i], bodies, run[i]);
    for (int k = -SKIPPED; k < FRAMES; k++) {
        int at = k < 0 ? 0 : k;
        t = (item_times){ .cost = cost };
        real start = cpu();
        world_step(&timed.world);
        real all = cpu() - start - 2 * cost * (real)t.items;
        for (int i = 0; i < WAYS; i++) {
            left[at][i] = 1 - (t.inside - t.left[i]) / all;
            wall[at][i] = step(&other[i]);
        }
        for (int i = WAYS; i-- > 0; ) wall[at][i] /= wall[at][0];
        share[at][0] = t.inside / all;
        size[at][0] = (real)t.items;
        size[at][1] = t.inside / (real)t.items;
    }
    for (int i = 0; i < WAYS; i++) {
        o.left[i] = median_of(left, i);
        o.wall[i] = median_of(wall, i);
        if (world_hash(&other[i].world) != world_hash(&timed.world)) exit(1);
        world_scene_free(&other[i]);
    }
    world_scene_free(&timed);
    o.share = median_of(share, 0);
    o.items = median_of(size, 0);
    o.each = median_of(size, 1);
    return o;
}

static void print_outcome(int bodies, const outcome *o, long processors)
{
    real four = processors < 4 ? (real)NAN : o->wall[2];
    printf("%d %.3f %.3f %.3f %.3f %.3f %.0f %.1f\n", bodies, o->share,
           o->left[1], o->left[2], o->wall[1], four, o->items, 1e6 * o->each);
    printf("#threads| %d,%.0f,%.1f,%.2f,%.2f,%.2f,%.2f\n", bodies, o->items,
           1e6 * o->each, o->share, o->left[1], o->left[2], o->wall[1]);
}

int main(void)
{
    thread_pool *pool[WAYS];
    tasks run[WAYS];
    for (int i = 0; i < WAYS; i++) {
        pool[i] = thread_pool_new(THREADS[i]);
        if (!pool[i]) return 1;
        run[i] = thread_pool_tasks(pool[i]);
    }
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    clock_print_head("18-threads: a room in several threads beside one", FLAGS);
    printf("# %ld processors\n", processors);
    printf("#threads| bodies,items of work,\"each, µs\",share of the frame,"
           "\"left with 2\",\"left with 4\",\"2, on the wall\"\n");
    for (int k = 0; k < SIZES; k++) {
        outcome o = race_rooms(BODIES[k], run);
        print_outcome(BODIES[k], &o, processors);
        fflush(stdout);
    }
    for (int i = 0; i < WAYS; i++) thread_pool_free(pool[i]);
    return 0;
}
