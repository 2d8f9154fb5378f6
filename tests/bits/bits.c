// bits.c - prints the bits of short films, so that compilers can be compared,
// and numbers of threads: make bits.

#include <stdio.h>

#include "system.h"
#include "world_scene.h"
#include "step.h"
#include "thread.h"

// MANY are enough that several threads have something to share.
enum { FEW = 20, MANY = 150 };

// Runs a scene for so many frames and prints the hash of where it ends.
static int film(scene_kind kind, world_options how, int bodies, int frames,
                const char *way)
{
    world_scene s;
    scene_options what = scene_options_default();
    what.bodies = bodies;
    what.cloth = 12;
    status done = world_scene_build(&s, kind, what, how);
    if (!done.ok) {
        fprintf(stderr, "bits: %s: %s\n", scene_name(kind), done.why);
        return 1;
    }
    for (int k = 0; k < frames; k++) world_step(&s.world);
    printf("%s %s %016llx\n", scene_name(kind), way, world_hash(&s.world));
    world_scene_free(&s);
    return 0;
}

// The same with the paper's system.
static int system_film(scene_kind kind, system_options how, int frames,
                       const char *way)
{
    scene start;
    particle_system s;
    scene_options what = scene_options_default();
    what.bodies = FEW;
    what.cloth = 12;
    status done = scene_build(&start, kind, what);
    if (done.ok) done = system_init(&s, &start, how);
    if (!done.ok) {
        fprintf(stderr, "bits: %s: %s\n", scene_name(kind), done.why);
        return 1;
    }
    for (int k = 0; k < frames; k++) system_step(&s);
    unsigned long long hash = 0xcbf29ce484222325ULL;
    for (int i = 0; i < s.pool.count; i++) {
        const unsigned char *b = (const unsigned char *)&s.pool.at[i].position;
        for (size_t k = 0; k < sizeof(vec3); k++)
            hash = (hash ^ b[k]) * 0x100000001b3ULL;
    }
    printf("%s %s %016llx\n", scene_name(kind), way, hash);
    system_free(&s);
    scene_free(&start);
    return 0;
}

static int film_in_threads(int threads)
{
    char way[20];
    snprintf(way, sizeof way, "in threads %d", threads);
    thread_pool *pool = thread_pool_new(threads);
    if (!pool) {
        fprintf(stderr, "bits: there are no %d threads\n", threads);
        return 1;
    }
    world_options how = world_scene_options(SCENE_ROOM, 0);
    how.host.run = thread_pool_tasks(pool);
    int failed = film(SCENE_ROOM, how, MANY, 60, way);
    thread_pool_free(pool);
    return failed;
}

int main(void)
{
    const int frames[SCENES] = { 60, 30, 30 };
    int failed = 0;
    for (int threads = 1; threads <= 4; threads *= 2)
        failed |= film_in_threads(threads);
    for (int k = 0; k < SCENES; k++) {
        scene_kind kind = (scene_kind)k;
        failed |= film(kind, world_scene_options(kind, 40), FEW, frames[k],
                       "ours");
        failed |= system_film(kind, system_options_mended(), frames[k],
                              "plain");
        failed |= system_film(kind, system_options_printed(), frames[k],
                              "as printed");
    }
    return failed;
}
