// thread.h - a pool of threads, for world_options.host.run.
//
//     thread_pool *pool = thread_pool_new(4);
//     options.host.run = thread_pool_tasks(pool);
//     ...
//     thread_pool_free(pool);
//
// The library itself knows nothing of threads: it divides its work into items,
// and its caller says which thread does which item.

#ifndef TUMBLE_THREAD_H
#define TUMBLE_THREAD_H

#include "task.h"

enum { MOST_THREADS = 64 };

typedef struct thread_pool thread_pool;

// A pool of so many threads, 1 to MOST_THREADS: the calling thread is one of
// them, the others wait for work.  Returns NULL for want of memory or threads.
thread_pool *thread_pool_new(int threads);

// Ends the pool's threads.  Requires that none of its tasks runs.  NULL is
// fine.
void thread_pool_free(thread_pool *pool);

// Tasks that the pool does: each thread takes the next item that none has
// taken.  The calling thread waits for no thread to begin: if the machine is
// busy with other things, it does all items alone.  One call at a time is
// shared; a call from inside an item, or from another thread meanwhile, is done
// one item after the other.  Nothing is allocated.  NULL, or a pool of one
// thread: always one after the other.
tasks thread_pool_tasks(thread_pool *pool);

#endif
