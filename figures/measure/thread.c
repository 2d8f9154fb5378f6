// thread.c - a pool of threads that take items of work.

#define _POSIX_C_SOURCE 200809L

#include "thread.h"

#include <assert.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

// Where threads sleep until something has changed.
typedef struct {
    atomic_int sleepers;
    pthread_mutex_t lock;
    pthread_cond_t  changed;
} bell;

// A call is a door.  It stands open while there may be items to take; the
// calling thread shuts it when all are taken, and returns when no worker is
// inside any more: then all items are done.  A worker that comes too late finds
// the door shut.
enum { OPEN = 1 << 8, INSIDE = OPEN - 1 };      // INSIDE: how many workers are

struct thread_pool {
    // The call that is on.
    void (*work)(void *data, int item);
    void *data;
    int items;
    atomic_int next;                // item
    atomic_int door;
    atomic_uint calls;              // so far: a worker enters each call once
    atomic_bool busy;               // a call is on
    double alone_until;             // s, see wait_for_workers
    atomic_bool stop;
    bell workers, caller;
    int threads;                    // workers, the calling thread not counted
    pthread_t id[MOST_THREADS];
};

// ---- Waiting ---------------------------------------------------------------

// How a thread waits: it looks so often, then lets other threads pass between
// two looks, so often, then sleeps.
typedef struct {
    int looks, passes;
} patience;

// A frame hands out work every few microseconds, so a worker is back at once, or
// gives way.  The calling thread waits for what is in hand already: it gives its
// processor up only when that takes longer than any item should, a tenth of a
// millisecond.
static const patience WORKER = { 1000, 200 }, CALLER = { 50000, 0 };

// Returns when is_so(pool, number) is true.
static void wait_until(bool (*is_so)(const thread_pool *, unsigned),
                       const thread_pool *pool, unsigned number, bell *b,
                       patience until)
{
    for (int k = 0; k < until.looks + until.passes; k++) {
        if (is_so(pool, number)) return;
        if (k >= until.looks) sched_yield();
    }
    pthread_mutex_lock(&b->lock);
    atomic_fetch_add(&b->sleepers, 1);
    while (!is_so(pool, number)) pthread_cond_wait(&b->changed, &b->lock);
    atomic_fetch_sub(&b->sleepers, 1);
    pthread_mutex_unlock(&b->lock);
}

// Wakes those who sleep.  A sleeper counts itself before its last look, and the
// bell is rung after the change: one of the two sees the other.
static void bell_ring(bell *b)
{
    if (atomic_load(&b->sleepers) == 0) return;
    pthread_mutex_lock(&b->lock);
    pthread_cond_broadcast(&b->changed);
    pthread_mutex_unlock(&b->lock);
}

static bool is_called(const thread_pool *pool, unsigned last)
{
    return atomic_load(&pool->calls) != last;
}

static bool is_empty(const thread_pool *pool, unsigned unused)
{
    (void)unused;
    return (atomic_load(&pool->door) & INSIDE) == 0;
}

// ---- Working ---------------------------------------------------------------

static void take_items(thread_pool *pool)
{
    int k;
    while ((k = atomic_fetch_add(&pool->next, 1)) < pool->items)
        pool->work(pool->data, k);
}

static bool door_enter(thread_pool *pool)
{
    int door = atomic_load(&pool->door);
    while (door & OPEN)
        if (atomic_compare_exchange_weak(&pool->door, &door, door + 1))
            return true;
    return false;
}

// The last one out wakes the calling thread, which has shut the door.
static void door_leave(thread_pool *pool)
{
    if (atomic_fetch_sub(&pool->door, 1) == 1) bell_ring(&pool->caller);
}

static void *serve(void *data)
{
    thread_pool *pool = data;
    unsigned last = 0;
    for (;;) {
        wait_until(is_called, pool, last, &pool->workers, WORKER);
        last = atomic_load(&pool->calls);
        if (atomic_load(&pool->stop)) return NULL;
        if (!door_enter(pool)) continue;
        take_items(pool);
        door_leave(pool);
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// A worker that holds the call up for longer than an item takes has lost its
// processor to another program.  The machine is busy, then: for fifty times as
// long the calling thread works alone, and so waits a fiftieth of the time at
// most.
static void wait_for_workers(thread_pool *pool, double began)
{
    if (is_empty(pool, 0)) return;
    double shut = now();
    wait_until(is_empty, pool, 0, &pool->caller, CALLER);
    double end = now(), waited = end - shut;
    if (waited > 2e-5 && waited > shut - began)
        pool->alone_until = end + 50 * waited;
}

static void share(thread_pool *pool, int items)
{
    double began = now();
    pool->items = items;
    atomic_store(&pool->next, 0);
    atomic_store(&pool->door, OPEN);
    atomic_fetch_add(&pool->calls, 1);
    bell_ring(&pool->workers);
    take_items(pool);
    atomic_fetch_sub(&pool->door, OPEN);
    wait_for_workers(pool, began);
}

static void run(void *context, void (*work)(void *data, int item), void *data,
                int items)
{
    thread_pool *pool = context;
    if (atomic_exchange(&pool->busy, true)) {
        for (int k = 0; k < items; k++) work(data, k);
        return;
    }
    if (pool->alone_until > 0 && now() < pool->alone_until) {
        for (int k = 0; k < items; k++) work(data, k);
    } else {
        pool->work = work;
        pool->data = data;
        share(pool, items);
    }
    atomic_store(&pool->busy, false);
}

tasks thread_pool_tasks(thread_pool *pool)
{
    if (!pool || pool->threads == 0) return (tasks){ .run = NULL };
    return (tasks){ .run = run, .context = pool };
}

// ---- Making ----------------------------------------------------------------

static void bell_init(bell *b)
{
    atomic_init(&b->sleepers, 0);
    pthread_mutex_init(&b->lock, NULL);
    pthread_cond_init(&b->changed, NULL);
}

static void bell_free(bell *b)
{
    pthread_cond_destroy(&b->changed);
    pthread_mutex_destroy(&b->lock);
}

thread_pool *thread_pool_new(int threads)
{
    assert(threads >= 1 && threads <= MOST_THREADS);
    thread_pool *pool = calloc(1, sizeof *pool);
    if (!pool) return NULL;
    atomic_init(&pool->next, 0);
    atomic_init(&pool->door, 0);
    atomic_init(&pool->calls, 0);
    atomic_init(&pool->busy, false);
    atomic_init(&pool->stop, false);
    bell_init(&pool->workers);
    bell_init(&pool->caller);
    while (pool->threads < threads - 1) {
        pthread_t *id = &pool->id[pool->threads];
        if (pthread_create(id, NULL, serve, pool) != 0) break;
        pool->threads++;
    }
    if (pool->threads == threads - 1) return pool;
    thread_pool_free(pool);
    return NULL;
}

void thread_pool_free(thread_pool *pool)
{
    if (!pool) return;
    atomic_store(&pool->stop, true);
    atomic_fetch_add(&pool->calls, 1);
    bell_ring(&pool->workers);
    for (int k = 0; k < pool->threads; k++) pthread_join(pool->id[k], NULL);
    bell_free(&pool->workers);
    bell_free(&pool->caller);
    free(pool);
}
