// thread.h - a second thread, for world_options.both.
//
//     thread *t = thread_new();
//     how.both = thread_both;
//     how.both_context = t;
//     ...
//     thread_free(t);
//
// The library itself knows nothing of threads: it divides its work, and whoever
// calls it says who does the halves.

#ifndef TUMBLE_THREAD_H
#define TUMBLE_THREAD_H

typedef struct thread thread;

// A thread that waits for work; NULL if there is none to be had.
thread *thread_new(void);
void    thread_free(thread *t);     // NULL is fine

// Does work(data, 0) here and work(data, 1) in thread t; returns when both are
// done.  If t has not begun when the first half is done, for the machine has
// other things to do, the second is done here as well.
void thread_both(void *t, void (*work)(void *data, int half), void *data);

#endif
