// batch.c - many worlds at once: episodes of an arm of three links, some worlds a
// thread, each put back to its start at the end of an episode.
//
//     cc -O2 -pthread tests/public/batch.c $(pkg-config --cflags --libs tumble)
//     ./a.out 64 2         64 worlds, 2 threads
//
// Prints how many steps a second all threads did together, and a hash of all ends,
// which does not depend on the number of threads.

#define _POSIX_C_SOURCE 199309L

#include "tumble.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { EPISODES = 4, STEPS = 120, MOST_THREADS = 64, LINKS = 3 };

typedef struct {
    tumble_world *w;
    tumble_joint joint[LINKS];
    void *start;
    size_t size;
    unsigned long long end;
} arena;

typedef struct {
    arena *all;
    int worlds, first, stride;
} share;

static void build(arena *a)
{
    tumble_world *w = a->w = tumble_world_make(NULL);
    tumble_shape link = tumble_shape_capsule(w, 0.5, 0.05, 1);
    tumble_body last = tumble_body_ground();
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < LINKS; k++) {
        tumble_body b = tumble_body_add(w, link,
                                        tumble_body_at(0, 0.5 + 0.6 * k, 0));
        a->joint[k] = tumble_joint_hinge(w, last, b,
                                         tumble_v(0, 0.2 + 0.6 * k, 0),
                                         tumble_v(0, 0, 1));
        last = b;
    }
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.2, 0.2, 0.2), 0.5),
                    tumble_body_at(0.8, 0.1, 0));
    a->size = tumble_world_save(w, NULL, 0);
    a->start = malloc(a->size);
    if (a->start) tumble_world_save(w, a->start, a->size);
}

static void play(arena *a, int number)
{
    for (int episode = 0; episode < EPISODES && a->start; episode++) {
        tumble_world_restore(a->w, a->start, a->size);
        for (int step = 0; step < STEPS; step++) {
            for (int k = 0; k < LINKS; k++)
                tumble_joint_set_motor(a->w, a->joint[k],
                                       (number + episode + k) % 5 - 2, 20);
            tumble_world_step(a->w);
        }
        a->end = 31 * a->end + tumble_world_hash(a->w);
    }
}

static void *work(void *data)
{
    const share *s = data;
    for (int k = s->first; k < s->worlds; k += s->stride) play(&s->all[k], k);
    return NULL;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char **argument)
{
    int worlds = count > 1 ? atoi(argument[1]) : 64;
    int threads = count > 2 ? atoi(argument[2]) : 2;
    if (worlds < 1 || threads < 1 || threads > MOST_THREADS)
        return fprintf(stderr, "batch: worlds, and 1 to 64 threads\n"), 2;
    arena *all = calloc((size_t)worlds, sizeof *all);
    pthread_t thread[MOST_THREADS];
    share of[MOST_THREADS];
    unsigned long long end = 0;
    if (!all) return 1;
    for (int k = 0; k < worlds; k++) build(&all[k]);
    double since = now();
    for (int k = 0; k < threads; k++) {
        of[k] = (share){ all, worlds, k, threads };
        if (pthread_create(&thread[k], NULL, work, &of[k]) != 0) return 1;
    }
    for (int k = 0; k < threads; k++) pthread_join(thread[k], NULL);
    double seconds = now() - since;
    for (int k = 0; k < worlds; k++) {
        const char *why = tumble_world_failure(all[k].w);
        if (why) fprintf(stderr, "world %d: %s\n", k, why);
        end = 31 * end + all[k].end;
        tumble_world_free(all[k].w);
        free(all[k].start);
    }
    free(all);
    printf("%d worlds, %d threads: %.0f steps a second, ends %016llx\n", worlds,
           threads, worlds * EPISODES * (double)STEPS / seconds, end);
    return 0;
}
