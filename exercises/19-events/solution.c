// solution.c - two sorted lists, side by side.

#include "events.h"

#include <stdlib.h>

static int pair_order(id_pair x, id_pair y)
{
    if (x.a != y.a) return x.a < y.a ? -1 : 1;
    return (x.b > y.b) - (x.b < y.b);
}

static int pair_order_of(const void *x, const void *y)
{
    return pair_order(*(const id_pair *)x, *(const id_pair *)y);
}

int pairs_tidy(id_pair *p, int count)
{
    int left = 0;
    for (int i = 0; i < count; i++)
        if (p[i].a > p[i].b) p[i] = (id_pair){ p[i].b, p[i].a };
    if (count > 0) qsort(p, (size_t)count, sizeof *p, pair_order_of);
    for (int i = 0; i < count; i++) {
        if (p[i].a == p[i].b) continue;
        if (left > 0 && pair_order(p[left - 1], p[i]) == 0) continue;
        p[left++] = p[i];
    }
    return left;
}

// At the end of one list, the other's pairs are smaller than anything.
int events_between(const id_pair *before, int olds, const id_pair *now, int news,
                   event *out, int room)
{
    int i = 0, k = 0, events = 0;
    while (i < olds || k < news) {
        int order = i == olds ? 1 : k == news ? -1 : pair_order(before[i], now[k]);
        if (order == 0) {
            i++;
            k++;
            continue;
        }
        event e = { order < 0 ? before[i] : now[k], order > 0 };
        if (events < room) out[events] = e;
        events++;
        if (order < 0) i++;
        else k++;
    }
    return events;
}
