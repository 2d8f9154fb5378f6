//> pairs-holds
#include "pairs.h"

#include <stddef.h>
#include <stdlib.h>

static bool holds(const pair_list *l, const pair_query *q)
{
    if (l->lists == 0 || l->is_cut) return false;
    for (int b = 0; b < l->bodies; b++) {
        const sphere *was = &l->listed[b];
        if (!q->moves[b]) continue;
        real room = was->radius - q->ball[b].radius - q->reach[b];
        vec3 way = vec3_sub(q->ball[b].center, was->center);
        if (q->ball[b].radius < 0) continue;
        if (!(room >= 0 && vec3_length_squared(way) <= room * room))
            return false;
    }
    return true;
}
//<

//> pairs-update
// A tenth of its radius, and once more what it may move: wide enough that the
// list holds for some frames, narrow enough that it is short.
static void enlarge(pair_list *l, const pair_query *q)
{
    for (int b = 0; b < l->bodies; b++) {
        l->listed[b] = q->ball[b];
        if (q->ball[b].radius < 0) continue;
        l->listed[b].radius += 0.1 * q->ball[b].radius + 2 * q->reach[b];
    }
}

// Room for half as many again; the list is made again, so nothing is kept.
static bool grow(pair_list *l, int need)
{
    if (need > 1 << 28) return false;
    int room = need + need / 2;
    int (*more)[2] = malloc((size_t)room * sizeof *more);
    if (!more) return false;
    free(l->pair);
    l->pair = more;
    l->capacity = room;
    return true;
}

bool pair_list_update(pair_list *l, const pair_query *q, int *lost)
{
    *lost = 0;
    if (holds(l, q)) return false;
    enlarge(l, q);
    int n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    if (n > l->capacity && grow(l, n))
        n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    l->count = int_min(n, l->capacity);
    *lost = n - l->count;
    l->is_cut = *lost > 0;
    l->lists++;
    return true;
}
//<

//> pairs-init
status pair_list_init(pair_list *l, int bodies)
{
    size_t n = bodies > 0 ? (size_t)bodies : 1;
    *l = (pair_list){ .bodies = bodies };
    status done = broad_init(&l->broad, bodies);
    if (!done.ok) return done;
    l->listed = malloc(n * sizeof *l->listed);
    l->pair = malloc(8 * n * sizeof *l->pair);
    l->capacity = 8 * (int)n;
    if (l->listed && l->pair) return status_ok();
    pair_list_free(l);
    return status_out_of_memory();
}

void pair_list_free(pair_list *l)
{
    broad_free(&l->broad);
    free(l->pair);
    free(l->listed);
    *l = (pair_list){ .bodies = 0 };
}
//<
