//> support-scan
#include "support.h"

#include <assert.h>

// The point furthest along d; heights are measured from `base`.
static inline int scan(point_set p, vec3 d, vec3 base)
{
    real best = vec3_dot(d, vec3_sub(p.at[0], base)), sum = best;
    int furthest = 0;
    for (int i = 1; i < p.count; i++) {
        real along = vec3_dot(d, vec3_sub(p.at[i], base));
        // Two selections rather than a branch, which nobody could foretell.
        furthest = along > best ? i : furthest;
        best = along > best ? along : best;
        sum += along;
    }
    // One NaN or infinity among the points has made the sum another.
    return sum - sum == 0 ? furthest : -1;
}

// Measured from the first point, not from the world's origin, a body a thousand
// kilometres out loses no digit.
int support_scan(point_set p, vec3 d)
{
    assert(p.count >= 1);
    return scan(p, d, p.at[0]);
}
//<

//> support-climb
// 1 if no neighbour of v is clearly higher or lower than v along d.
static int is_level(point_set p, vec3 d, int v)
{
    const real slope = 0x1p-30;
    real steepest = slope * slope * vec3_length_squared(d);
    for (int k = p.ring_start[v]; k < p.ring_start[v + 1]; k++) {
        vec3 edge = vec3_sub(p.at[p.ring[k]], p.at[v]);
        real rise = vec3_dot(d, edge);
        if (rise * rise > steepest * vec3_length_squared(edge)) return 0;
    }
    return 1;
}

// From vertex `stand`, at height *best along d, to its highest neighbour; to
// itself, if that is not higher.
static inline int climb_step(point_set p, vec3 d, int stand, real *best)
{
    vec3 base = p.at[0];
    real highest = *best;
    int here = stand;
    for (int k = p.ring_start[stand]; k < p.ring_start[stand + 1]; k++) {
        real along = vec3_dot(d, vec3_sub(p.at[p.ring[k]], base));
        here = along > highest ? p.ring[k] : here;
        highest = along > highest ? along : highest;
    }
    *best = highest;
    return here;
}

// No neighbour of `here` is higher.  At a corner of a convex mesh that is the
// top.  Amid a flat side it may be the bottom as well: then all are level.
static int top_or_scan(point_set p, vec3 d, int here)
{
    return is_level(p, d, here) ? support_scan(p, d) : here;
}

int support_climb(point_set p, vec3 d, int from)
{
    assert(p.ring && p.ring_start && from >= 0 && from < p.count);
    int here = from;
    real best = vec3_dot(d, vec3_sub(p.at[here], p.at[0]));
    // Each move gains height, so no vertex is met twice.
    for (int moves = 1; moves < p.count; moves++) {
        int stand = here;
        here = climb_step(p, d, stand, &best);
        if (here == stand) break;
    }
    return top_or_scan(p, d, here);
}
//<

//> support-point
int support_point(point_set p, vec3 d, int from)
{
    return support_climbs(p) ? support_climb(p, d, from) : support_scan(p, d);
}
//<

//> support-abreast
// Two climbs abreast: while one waits for its vertices to come from memory, the
// other goes on.
vertex_pair support_climb_both(const point_set *a, const point_set *b, vec3 d,
                               vertex_pair from)
{
    vec3 back = vec3_scale(-1, d);
    vertex_pair here = from;
    real best_a = vec3_dot(d, vec3_sub(a->at[from.a], a->at[0]));
    real best_b = vec3_dot(back, vec3_sub(b->at[from.b], b->at[0]));
    for (int moves = 2; moves < a->count + b->count; moves++) {
        vertex_pair stand = here;
        here.a = climb_step(*a, d, stand.a, &best_a);
        here.b = climb_step(*b, back, stand.b, &best_b);
        if (here.a == stand.a && here.b == stand.b) break;
    }
    here.a = top_or_scan(*a, d, here.a);
    here.b = top_or_scan(*b, back, here.b);
    return here;
}

// With the base 0 a scan subtracts nothing: that saves a third of its work.
vertex_pair support_scan_both(const point_set *a, const point_set *b, vec3 d)
{
    const vec3 home = { 0, 0, 0 };
    return (vertex_pair){ scan(*a, d, home),
                          scan(*b, vec3_scale(-1, d), home) };
}
//<
