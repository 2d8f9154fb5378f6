// thread.c - a second thread that waits for halves of work.

#define _POSIX_C_SOURCE 200809L

#include "thread.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

// Whose turn it is with the second half.
enum { NOTHING, OFFERED, TAKEN, DONE, STOP };

struct thread {
    pthread_t id;
    void (*work)(void *data, int half);
    void *data;
    atomic_int state;
    atomic_int sleepers;            // how many wait for `changed`
    pthread_mutex_t lock;
    pthread_cond_t  changed;
};

// The next half comes within microseconds, or not at all soon: so whoever waits
// looks again and again, and sleeps only if nothing has come for a while.
enum { LOOKS = 1 << 16 };

static int is_waiting(const thread *t, int wanted)
{
    int s = atomic_load(&t->state);
    return s != wanted && s != STOP;
}

static void wait_for(thread *t, int wanted)
{
    for (int k = 0; k < LOOKS; k++)
        if (!is_waiting(t, wanted)) return;
    pthread_mutex_lock(&t->lock);
    atomic_fetch_add(&t->sleepers, 1);
    while (is_waiting(t, wanted)) pthread_cond_wait(&t->changed, &t->lock);
    atomic_fetch_sub(&t->sleepers, 1);
    pthread_mutex_unlock(&t->lock);
}

// (Whoever sleeps has said so before it looked at the state for the last time,
// and we look whether anybody does after having changed it.)
static void change(thread *t, int state)
{
    atomic_store(&t->state, state);
    if (atomic_load(&t->sleepers) == 0) return;
    pthread_mutex_lock(&t->lock);
    pthread_cond_broadcast(&t->changed);
    pthread_mutex_unlock(&t->lock);
}

static int take(thread *t, int to)
{
    int offered = OFFERED;
    return atomic_compare_exchange_strong(&t->state, &offered, to);
}

static void *serve(void *data)
{
    thread *t = data;
    while (atomic_load(&t->state) != STOP) {
        wait_for(t, OFFERED);
        if (!take(t, TAKEN)) continue;
        t->work(t->data, 1);
        change(t, DONE);
    }
    return NULL;
}

void thread_both(void *context, void (*work)(void *data, int half), void *data)
{
    thread *t = context;
    t->work = work;
    t->data = data;
    change(t, OFFERED);
    work(data, 0);
    if (take(t, NOTHING)) {
        work(data, 1);
        return;
    }
    wait_for(t, DONE);
    atomic_store(&t->state, NOTHING);
}

thread *thread_new(void)
{
    thread *t = malloc(sizeof *t);
    if (!t) return NULL;
    atomic_init(&t->state, NOTHING);
    atomic_init(&t->sleepers, 0);
    pthread_mutex_init(&t->lock, NULL);
    pthread_cond_init(&t->changed, NULL);
    if (pthread_create(&t->id, NULL, serve, t) == 0) return t;
    pthread_cond_destroy(&t->changed);
    pthread_mutex_destroy(&t->lock);
    free(t);
    return NULL;
}

void thread_free(thread *t)
{
    if (!t) return;
    change(t, STOP);
    pthread_join(t->id, NULL);
    pthread_cond_destroy(&t->changed);
    pthread_mutex_destroy(&t->lock);
    free(t);
}
