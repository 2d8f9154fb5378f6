// solution.c - what was near is asked, and nobody else.

#include "list.h"

static int is_within(vec3 a, vec3 b, real reach)
{
    return vec3_length_squared(vec3_sub(a, b)) <= reach * reach;
}

// Two points come nearer by no more than both have moved.  The two largest
// moves are enough: no two others can have done worse.
int list_is_good(const near_list *l, const vec3 *at)
{
    real most = 0, next = 0;
    if (l->made == 0) return 0;
    for (int i = 0; i < l->points; i++) {
        real moved = vec3_distance(at[i], l->from[i]);
        if (!(moved < HUGE_VAL)) return 0;
        if (moved > most) {
            next = most;
            most = moved;
        } else if (moved > next) {
            next = moved;
        }
    }
    return most + next <= l->margin;
}

// All pairs within a distance, in order.  Counts on when there is no room.
static int gather_all(const vec3 *at, int n, real reach, int (*out)[2],
                      int room)
{
    int found = 0;
    for (int a = 0; a < n; a++)
        for (int b = a + 1; b < n; b++) {
            if (!is_within(at[a], at[b], reach)) continue;
            if (found < room) {
                out[found][0] = a;
                out[found][1] = b;
            }
            found++;
        }
    return found;
}

void list_make(near_list *l, const vec3 *at)
{
    for (int i = 0; i < l->points; i++) l->from[i] = at[i];
    l->pairs = gather_all(at, l->points, l->reach + l->margin, l->pair,
                          l->capacity);
    if (l->pairs > l->capacity) l->pairs = -1;
    l->made++;
}

int list_pairs(near_list *l, const vec3 *at, int (*out)[2], int room)
{
    int found = 0;
    if (!list_is_good(l, at)) list_make(l, at);
    if (l->pairs < 0) return gather_all(at, l->points, l->reach, out, room);
    for (int k = 0; k < l->pairs; k++) {
        int a = l->pair[k][0], b = l->pair[k][1];
        if (!is_within(at[a], at[b], l->reach)) continue;
        if (found < room) {
            out[found][0] = a;
            out[found][1] = b;
        }
        found++;
    }
    return found;
}
