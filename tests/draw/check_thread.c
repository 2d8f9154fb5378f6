// check_thread.c - is every item of work done once, whichever thread does it?
//
// The pool of threads is that of the figures: figures/measure/thread.c.

#define _POSIX_C_SOURCE 200809L

#include "scarce.h"
#include "random.h"
#include "step.h"
#include "suite.h"
#include "thread.h"
#include "world_scene.h"

#include <check.h>
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

enum { MOST = 8, MOST_ITEMS = 200 };

static long now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

static thread_pool *pool_of(int threads)
{
    thread_pool *pool = thread_pool_new(threads);
    ck_assert_ptr_nonnull(pool);
    return pool;
}

static void sleep_ms(long ms)
{
    struct timespec t = { ms / 1000, ms % 1000 * 1000000 };
    nanosleep(&t, NULL);
}

// ---- Items that count how often they are done ------------------------------

// Plain numbers: what is done twice, or after the call has returned, is found
// by a sanitizer as well.
typedef struct {
    int done[MOST_ITEMS + 1];
    int wait;               // rounds that an item takes
} tally;

static void count(void *data, int item)
{
    tally *t = data;
    for (volatile int k = 0; k < t->wait; k++) continue;
    t->done[item]++;
}

// Without an assert of Check's, which only its own thread may call.
static bool is_each_done_once(tasks run, int items, int wait)
{
    tally t = { .wait = wait };
    tasks_run(run, count, &t, items);
    for (int k = 0; k <= MOST_ITEMS; k++)
        if (t.done[k] != (k < items)) return false;
    return true;
}

static void expect_each_once(tasks run, int items, int wait)
{
    ck_assert_msg(is_each_done_once(run, items, wait), "not each of %d items "
                  "was done once", items);
}

// Rejects: an item that is done twice, or not at all, or not yet done on
// return; a late worker that takes an item of the next call.
START_TEST(every_item_is_done_once)
{
    enum { CALLS = 100000 / MOST };
    thread_pool *pool = pool_of(_i);
    unsigned long long seed = (unsigned long long)_i;
    for (int k = 0; k < CALLS; k++) {
        int items = random_below(&seed, MOST_ITEMS + 1);
        if (k % 4) items %= 6;
        expect_each_once(thread_pool_tasks(pool), items,
                         random_below(&seed, 100));
    }
    thread_pool_free(pool);
}
END_TEST

// Rejects: a bell that is not rung; a worker that has gone to bed for good.
START_TEST(threads_that_sleep_are_woken)
{
    thread_pool *pool = pool_of(3);
    for (int k = 0; k < 100; k++) {
        sleep_ms(k % 10);
        expect_each_once(thread_pool_tasks(pool), MOST_ITEMS, 1000);
    }
    thread_pool_free(pool);
}
END_TEST

// ---- Which thread does it --------------------------------------------------

// An item that waits until another thread has begun one, too.
typedef struct {
    atomic_int begun;
    atomic_bool both;
} meeting;

static void meet(void *data, int item)
{
    meeting *m = data;
    (void)item;
    if (atomic_fetch_add(&m->begun, 1) > 0) atomic_store(&m->both, true);
    // Ten seconds are for a machine that is very busy.
    for (int k = 0; k < 10000 && !atomic_load(&m->both); k++) sleep_ms(1);
}

// Rejects: a pool whose workers never work.
START_TEST(two_threads_work_at_once)
{
    thread_pool *pool = pool_of(2);
    for (int k = 0; k < 10; k++) {
        meeting m = { .begun = 0 };
        tasks_run(thread_pool_tasks(pool), meet, &m, 2);
        ck_assert(m.both && m.begun == 2);
    }
    thread_pool_free(pool);
}
END_TEST

// What item 0 does goes on until all others are done.
static void hold(void *data, int item)
{
    atomic_int *done = data;
    while (item == 0 && atomic_load(done) < 99) sleep_ms(1);
    atomic_fetch_add(done, 1);
}

// Rejects: items that are dealt out beforehand.
START_TEST(one_long_item_holds_up_no_other)
{
    thread_pool *pool = pool_of(2);
    atomic_int done = 0;
    tasks_run(thread_pool_tasks(pool), hold, &done, 100);
    ck_assert_int_eq(done, 100);
    thread_pool_free(pool);
}
END_TEST

// A pool, and how many calls it did wrong.
typedef struct {
    tasks run;
    atomic_int wrong;
} verdict;

static void call_again(void *data, int item)
{
    verdict *v = data;
    (void)item;
    if (!is_each_done_once(v->run, 10, 0)) atomic_fetch_add(&v->wrong, 1);
}

// Rejects: a call inside an item that waits for the call that it is part of.
START_TEST(a_call_within_an_item_is_done)
{
    thread_pool *pool = pool_of(4);
    verdict v = { .run = thread_pool_tasks(pool) };
    for (int k = 0; k < 1000; k++) tasks_run(v.run, call_again, &v, 20);
    ck_assert_int_eq(v.wrong, 0);
    thread_pool_free(pool);
}
END_TEST

static void *call_often(void *data)
{
    for (int k = 0; k < 5000; k++) call_again(data, 0);
    return NULL;
}

// Rejects: two threads whose calls take each other's items.
START_TEST(two_threads_may_share_a_pool)
{
    thread_pool *pool = pool_of(3);
    verdict v = { .run = thread_pool_tasks(pool) };
    pthread_t other;
    ck_assert_int_eq(pthread_create(&other, NULL, call_often, &v), 0);
    call_often(&v);
    pthread_join(other, NULL);
    ck_assert_int_eq(v.wrong, 0);
    thread_pool_free(pool);
}
END_TEST

// Worker and calling thread begin an item each; the worker's goes on for twice
// as long as they took to meet, and more.
typedef struct {
    meeting met;
    pthread_t caller;
    long start;                 // ms
    atomic_int elsewhere;       // items that the calling thread did not do
} delay;

static void meet_late(void *data, int item)
{
    delay *d = data;
    meet(&d->met, item);
    if (!pthread_equal(pthread_self(), d->caller))
        sleep_ms(50 + 2 * (now_ms() - d->start));
}

static void note_thread(void *data, int item)
{
    delay *d = data;
    (void)item;
    sleep_ms(1);
    if (!pthread_equal(pthread_self(), d->caller))
        atomic_fetch_add(&d->elsewhere, 1);
}

// Rejects: a calling thread that waits again and again for one that has lost its
// processor; one that never asks for help again.
START_TEST(a_worker_that_is_late_is_left_alone_for_a_time)
{
    thread_pool *pool = pool_of(2);
    tasks run = thread_pool_tasks(pool);
    delay d = { .caller = pthread_self(), .start = now_ms() };
    tasks_run(run, meet_late, &d, 2);
    ck_assert(d.met.both);
    tasks_run(run, note_thread, &d, 100);
    ck_assert_int_eq(d.elsewhere, 0);
    for (int k = 0; k < 200 && d.elsewhere == 0; k++) {
        sleep_ms(100);
        tasks_run(run, note_thread, &d, 50);
    }
    ck_assert_int_gt(d.elsewhere, 0);
    thread_pool_free(pool);
}
END_TEST

// ---- A world ----------------------------------------------------------------

// Items in an order of its own.
static void last_first(void *context, void (*work)(void *data, int item),
                       void *data, int items)
{
    ++*(long *)context;
    for (int k = items; k-- > 0; ) work(data, k);
}

// A heap after a second: a block or more of every colour.
static unsigned long long bits_of_room(tasks run)
{
    enum { BODIES = 200, FRAMES = 60 };
    world_scene s;
    scene_options what = scene_options_default();
    world_options how = world_scene_options(SCENE_ROOM, 0);
    what.bodies = BODIES;
    how.host.run = run;
    ck_assert(world_scene_build(&s, SCENE_ROOM, what, how).ok);
    for (int k = 0; k < FRAMES; k++) world_step(&s.world);
    ck_assert_int_gt(s.world.report.contacts, BODIES);
    unsigned long long bits = world_hash(&s.world);
    world_scene_free(&s);
    return bits;
}

// Rejects: a number that two items write; one that an item reads and another
// writes; a sum whose order depends on who is ahead.
START_TEST(a_world_has_the_same_bits_in_any_number_of_threads)
{
    long calls = 0;
    unsigned long long bits = bits_of_room((tasks){ .run = NULL });
    ck_assert(bits_of_room((tasks){ last_first, &calls }) == bits);
    ck_assert_int_gt(calls, 60);
    for (int threads = 2; threads <= 4; threads++) {
        thread_pool *pool = pool_of(threads);
        ck_assert(bits_of_room(thread_pool_tasks(pool)) == bits);
        thread_pool_free(pool);
    }
}
END_TEST

// ---- Beginning and end -----------------------------------------------------

// Rejects: an end that waits for a thread that sleeps, or has not begun, or is
// on its way out of a call.
START_TEST(a_pool_ends_at_any_time)
{
    for (int k = 0; k < 400; k++) {
        thread_pool *pool = pool_of(1 + k % MOST);
        for (int calls = k / MOST % 3; calls > 0; calls--)
            expect_each_once(thread_pool_tasks(pool), 5, 10);
        if (k % 50 == 0) sleep_ms(20);
        thread_pool_free(pool);
    }
    thread_pool_free(NULL);
}
END_TEST

START_TEST(a_pool_of_one_is_plain)
{
    thread_pool *pool = pool_of(1);
    ck_assert(!thread_pool_tasks(pool).run);
    ck_assert(!thread_pool_tasks(NULL).run);
    thread_pool_free(pool);
}
END_TEST

// The Makefile puts this in the place of pthread_create.
int __real_pthread_create(pthread_t *, const pthread_attr_t *,
                          void *(*)(void *), void *);
int __wrap_pthread_create(pthread_t *, const pthread_attr_t *,
                          void *(*)(void *), void *);
static int threads_left = INT_MAX;

int __wrap_pthread_create(pthread_t *id, const pthread_attr_t *how,
                          void *(*start)(void *), void *data)
{
    if (threads_left-- <= 0) return EAGAIN;
    return __real_pthread_create(id, how, start, data);
}

// How many blocks of memory are left of a pool of four, which cannot be made
// with so many threads and allocations.
static long left_of_refused(int threads, int mallocs)
{
    long held = blocks_held;
    threads_left = threads;
    mallocs_left = mallocs;
    thread_pool *none = thread_pool_new(4);
    threads_left = mallocs_left = INT_MAX;
    held = blocks_held - held;
    ck_assert_ptr_null(none);
    return held;
}

// Rejects: a pool of fewer threads than were asked for; threads or memory that
// are left behind.
START_TEST(a_refused_thread_or_block_leaves_nothing)
{
    for (int threads = 0; threads < 3; threads++)
        ck_assert_int_eq(left_of_refused(threads, INT_MAX), 0);
    ck_assert_int_eq(left_of_refused(INT_MAX, 0), 0);
}
END_TEST

START_TEST(a_call_asks_for_no_memory)
{
    thread_pool *pool = pool_of(3);
    long made = mallocs_made;
    for (int k = 0; k < 100; k++) {
        tally t = { .wait = 100 };
        tasks_run(thread_pool_tasks(pool), count, &t, 50);
    }
    made = mallocs_made - made;
    ck_assert_int_eq(made, 0);
    thread_pool_free(pool);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        threads_that_sleep_are_woken,
        two_threads_work_at_once,
        one_long_item_holds_up_no_other,
        a_call_within_an_item_is_done,
        two_threads_may_share_a_pool,
        a_world_has_the_same_bits_in_any_number_of_threads,
        a_worker_that_is_late_is_left_alone_for_a_time,
        a_pool_ends_at_any_time,
        a_pool_of_one_is_plain,
        a_refused_thread_or_block_leaves_nothing,
        a_call_asks_for_no_memory,
        NULL
    };
    return suite_run((suite){
        .name = "thread", .tests = tests, .seconds = 60,
        .repeated = { { every_item_is_done_once, 1, MOST + 1 } }
    });
}
