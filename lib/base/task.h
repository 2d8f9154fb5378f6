//> task-head
//>   Blocks of a colour do not touch each other's bodies, so any thread may
//>   solve any of them, at any time: the bits are the same
//>   (`any_order_of_the_work_gives_the_same_bits`).
// task.h - work on n items, which several threads may do.
//
// Paper: not asked.  Book: chapter 18.

#pragma once

// run must call work(data, 0) ... work(data, items - 1), in any order or at once, and
// return when all are done; NULL: one after the other.  No item may touch what another
// one writes, so the bits do not depend on the threads.
typedef struct {
    void (*run)(void *context, void (*work)(void *data, int item), void *data,
                int items);
    void *context;
} tasks;

// Small things, such as bodies or contacts, are handed out by the chunk, so that an
// item takes a few microseconds: item k has those from k `each` to before task_last.
static inline int task_items(int n, int each)
{
    return (n + each - 1) / each;
}

static inline int task_last(int item, int n, int each)
{
    int end = (item + 1) * each;
    return end < n ? end : n;
}

// Fewer cost more to hand out than to do; more leave threads idle at the end.
enum { TASK_CHUNK = 32 };                   // tuned, items

static inline int task_chunks(int n)
{
    return task_items(n, TASK_CHUNK);
}

static inline int task_first(int item)
{
    return item * TASK_CHUNK;
}

static inline int task_end(int item, int n)
{
    return task_last(item, n, TASK_CHUNK);
}

static inline void tasks_run(tasks t, void (*work)(void *data, int item),
                             void *data, int items)
{
    if (t.run && items > 1) {
        t.run(t.context, work, data, items);
        return;
    }
    for (int k = 0; k < items; k++) work(data, k);
}
//<
