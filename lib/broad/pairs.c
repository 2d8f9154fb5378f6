//> pairs-holds
//>   Does the list still hold? That takes one distance a body. The comparison
//>   is again written with a *not*, so that a body at NaN makes a new list.
#include "pairs.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>

static bool holds(const pair_list *l, const pair_query *q)
{
    if (l->lists == 0 || l->is_cut) return false;
    for (int b = 0; b < l->bodies; b++) {
        const sphere *was = &l->listed[b];
        if (!q->moves[b] || l->is_new[b]) continue;
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
static void enlarge(pair_list *l, const pair_query *q, bool all)
{
    for (int b = 0; b < l->bodies; b++) {
        if (!all && !l->is_new[b]) continue;
        l->is_new[b] = false;
        l->listed[b] = q->ball[b];
        if (q->ball[b].radius < 0) continue;
        l->listed[b].radius += 0.1 * q->ball[b].radius + 2 * q->reach[b];
    }
}

// Room for half as many again; the list is made again, so nothing is kept.
static bool grow(int (**list)[2], int *capacity, int need)
{
    if (need <= *capacity) return true;
    if (need > 1 << 28) return false;
    int room = need + need / 2 + 64;
    int (*more)[2] = malloc((size_t)room * sizeof *more);
    if (!more) return false;
    free(*list);
    *list = more;
    *capacity = room;
    return true;
}

// Which planes is each ball near?  Returns how many, stored or not.
static int find_walls(pair_list *l, const pair_query *q)
{
    int n = 0;
    for (int b = 0; b < l->bodies; b++) {
        sphere ball = l->listed[b];
        if (!q->moves[b] || ball.radius < 0) continue;
        for (int k = 0; k < q->planes; k++) {
            real height = vec3_dot(q->plane[k].normal, ball.center)
                        - q->plane[k].offset;
            if (height > ball.radius) continue;
            if (n < l->wall_capacity) {
                l->wall[n][0] = b;
                l->wall[n][1] = k;
            }
            n++;
        }
    }
    return n;
}

bool pair_list_update(pair_list *l, const pair_query *q, int *lost)
{
    bool is_good = holds(l, q);
    *lost = 0;
    if (is_good && !l->has_new) return false;
    enlarge(l, q, !is_good);
    int n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    if (n > l->capacity && grow(&l->pair, &l->capacity, n))
        n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    int walls = find_walls(l, q);
    if (walls > l->wall_capacity && grow(&l->wall, &l->wall_capacity, walls))
        walls = find_walls(l, q);
    l->count = int_min(n, l->capacity);
    l->walls = int_min(walls, l->wall_capacity);
    *lost = n - l->count + walls - l->walls;
    l->is_cut = *lost > 0;
    l->has_new = false;
    l->lists++;
    return true;
}

void pair_list_renew(pair_list *l, int b)
{
    l->has_new = true;
    if (b >= 0) l->is_new[b] = true;
}
//<

//> pairs-init
//>   The rest is memory. The list of pairs grows by half when it is too short,
//>   and keeps nothing, because it is about to be made again.
status pair_list_init(pair_list *l, int bodies)
{
    *l = (pair_list){ .bodies = 0 };
    status done = pair_list_grow(l, bodies);
    if (!done.ok) pair_list_free(l);
    return done;
}

static bool make_room(pair_list *l, int bodies)
{
    int room = table_room(bodies, l->room), n = int_max(room, 1);
    bool ok = true;
    if (l->pair && bodies <= l->room) return true;
    TABLE_GROW(ok, l->listed, l->bodies, n);
    TABLE_GROW(ok, l->is_new, l->bodies, n);
    if (!l->pair) ok = ok && grow(&l->pair, &l->capacity, 8 * n);
    if (ok) l->room = room;
    return ok;
}

status pair_list_grow(pair_list *l, int bodies)
{
    if (!make_room(l, bodies)) return status_out_of_memory();
    status done = broad_grow(&l->broad, bodies);
    for (; done.ok && l->bodies < bodies; l->bodies++)
        pair_list_renew(l, l->bodies);
    return done;
}

void pair_list_free(pair_list *l)
{
    broad_free(&l->broad);
    free(l->pair);
    free(l->wall);
    free(l->listed);
    free(l->is_new);
    *l = (pair_list){ .bodies = 0 };
}
//<
