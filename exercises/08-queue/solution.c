// solution.c - a ring of sticks that wait.

#include "queue.h"

// The line, in a ring of n places.
typedef struct {
    int  *line;
    char *waits;        // 1: stands in the line
    int   n, begin, count;
} queue;

static void join(queue *q, int k)
{
    if (q->waits[k]) return;
    q->waits[k] = 1;
    q->line[(q->begin + q->count) % q->n] = k;
    q->count++;
}

// All sticks of particle v, but one.
static void join_all(queue *q, const stick_lists *sticks_at, int v, int but)
{
    for (int i = sticks_at->start[v]; i < sticks_at->start[v + 1]; i++)
        if (sticks_at->stick[i] != but) join(q, sticks_at->stick[i]);
}

// Each stick waits at most once, so n places are enough.
queue_result queue_relax(const stick *s, int n, particle *p,
                         const stick_lists *sticks_at, int from,
                         real tolerance, int budget, int *line, char *waits)
{
    queue q = { line, waits, n, 0, 0 };
    queue_result r = { 0, 0 };
    for (int k = 0; k < n; k++) waits[k] = 0;
    join_all(&q, sticks_at, from, -1);
    while (q.count > 0 && r.relaxed < budget) {
        int k = q.line[q.begin];
        q.begin = (q.begin + 1) % n;
        q.count--;
        q.waits[k] = 0;

        r.tested++;
        if (!(stick_strain(s[k], p) > tolerance)) continue;
        if (!stick_relax(s[k], p, relax_options_pbd()).moved) continue;
        r.relaxed++;
        join_all(&q, sticks_at, s[k].a, k);
        join_all(&q, sticks_at, s[k].b, k);
    }
    return r;
}
