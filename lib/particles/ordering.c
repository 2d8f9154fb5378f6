//> ordering-distances
// ordering.c - the lists of section 6.2, and relaxation by them.
#include "ordering.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// A body's constraint graph: particles are its corners, sticks its edges.
typedef struct {
    const stick *s;
    int  sticks, particles;
    int *away;          // [particles] see find_paths
    int *distance;      // [sticks] see find_distances
} graph;

// away[i]: the number of sticks on the shortest path from v to particle i, or
// more than there are sticks while no path is known.  A path to one end of a
// stick is, one stick longer, a path to the other.  Ends, because each round
// shortens a whole number that cannot fall below 0.
static void find_paths(const graph *g, int v)
{
    for (int i = 0; i < g->particles; i++)
        g->away[i] = i == v ? 0 : g->sticks + 1;
    for (bool shorter = true; shorter; ) {
        shorter = false;
        for (int k = 0; k < g->sticks; k++) {
            int *a = &g->away[g->s[k].a], *b = &g->away[g->s[k].b];
            if (*a > *b + 1) *a = *b + 1, shorter = true;
            if (*b > *a + 1) *b = *a + 1, shorter = true;
        }
    }
}

// distance[k]: the number of sticks on the shortest path that starts at v and
// ends with stick k.  Where there is none: one more than n, the largest that
// is reached, which is returned.
static int find_distances(const graph *g, int v)
{
    int n = 0, *distance = g->distance;
    find_paths(g, v);
    for (int k = 0; k < g->sticks; k++) {
        distance[k] = 1 + int_min(g->away[g->s[k].a], g->away[g->s[k].b]);
        if (distance[k] <= g->sticks) n = int_max(n, distance[k]);
    }
    for (int k = 0; k < g->sticks; k++)
        distance[k] = int_min(distance[k], n + 1);
    return n;
}
//<

//> ordering-list
//>   The ruler is `has_turn`. A list is then three loops, one inside the other:
//>   rounds, distances, sticks.
// Has a stick of distance d a turn in round r of n?  Distance 1 has one in
// every round, 2 in every second, 3 in every fourth: n / 2^(d - 1) in all.  A
// stick without a turn by then has one in the last round.
static bool has_turn(int d, int r, int n)
{
    int every = 1;
    for (int i = 1; i < d && every <= n; i++) every *= 2;
    return every <= n ? r % every == 0 : r == n;
}

// Writes the list of particle v to out, or only counts if out is NULL.  Returns
// its length.
static int write_list(const graph *g, int v, bool repeated, int *out)
{
    int n = find_distances(g, v), rounds = repeated && n > 1 ? n : 1;
    int length = 0;
    for (int r = 1; r <= rounds; r++)
        for (int d = 1; d <= n + 1; d++) {
            if (!has_turn(d, r, rounds)) continue;
            for (int k = 0; k < g->sticks; k++) {
                if (g->distance[k] != d) continue;
                if (out) out[length] = k;
                length++;
            }
        }
    return length;
}
//<

//> ordering-lists
// The most entries whose bytes an int can count.
enum { MOST_ENTRIES = INT_MAX / (int)sizeof(int) - 1 };

static status too_long(int sticks)
{
    return status_fail("the lists of %d sticks are too long to number", sticks);
}

// All lists one behind the other: counted first, then written.
static status fill_lists(stick_lists *l, const graph *g, bool repeated)
{
    long long total = 0;
    for (int v = 0; v < g->particles; v++) {
        l->start[v] = (int)total;
        total += write_list(g, v, repeated, NULL);
        if (total > MOST_ENTRIES) return too_long(g->sticks);
    }
    l->start[g->particles] = (int)total;
    l->stick = malloc(((size_t)total + 1) * sizeof *l->stick);
    if (!l->stick) return status_out_of_memory();
    for (int v = 0; v < g->particles; v++)
        write_list(g, v, repeated, l->stick + l->start[v]);
    return status_ok();
}

status stick_lists_build(stick_lists *l, const stick *s, int sticks,
                         int particles, bool repeated)
{
    assert(sticks >= 0 && particles >= 0);
    *l = (stick_lists){ 0, NULL, NULL };
    for (int k = 0; k < sticks; k++)
        assert(int_min(s[k].a, s[k].b) >= 0
               && int_max(s[k].a, s[k].b) < particles);
    if ((long long)sticks * particles > MOST_ENTRIES) return too_long(sticks);
    size_t points = (size_t)particles + 1, edges = (size_t)sticks + 1;
    graph g = { s, sticks, particles, malloc(points * sizeof(int)),
                malloc(edges * sizeof(int)) };
    l->particles = particles;
    l->start = malloc(points * sizeof *l->start);
    status done = g.away && g.distance && l->start
                ? fill_lists(l, &g, repeated) : status_out_of_memory();
    free(g.away);
    free(g.distance);
    if (!done.ok) stick_lists_free(l);
    return done;
}

void stick_lists_free(stick_lists *l)
{
    free(l->start);
    free(l->stick);
    *l = (stick_lists){ 0, NULL, NULL };
}
//<

//> most-moved
//>   The list that is used is that of the particle that moved most.
int most_moved(const particle *p, const vec3 *before, int n)
{
    int most = -1;
    real furthest = 0;
    for (int i = 0; i < n; i++) {
        vec3 moved = vec3_sub(p[i].position, before[i]);
        real square = vec3_length_squared(moved);
        if (square > furthest) furthest = square, most = i;
    }
    return most;
}
//<

//> sticks-relax-from
//>   Relaxation along the list of one particle. With lists that repeat it is
//>   the paper's way, with lists that do not, breadth first, with no list,
//>   Jakobsen's.
// Relaxes one stick, and counts it in *r.
static void relax_one(stick s, particle *p, relax_options options,
                      relax_result *r)
{
    stick_result done = stick_relax(s, p, options);
    r->worst = real_max(fabs(done.error) / s.rest_length, r->worst);
    r->tested++;
    r->relaxed += done.moved;
}

relax_result sticks_relax_from(const stick_lists *l, int from,
                               const stick *s, int n, particle *p,
                               int max_iterations, relax_options options)
{
    assert(n >= 0 && (from < 0 || from < l->particles));
    const int *list = from < 0 ? NULL : l->stick + l->start[from];
    int entries = from < 0 ? n : l->start[from + 1] - l->start[from];
    relax_result r = { .worst = 0 };
    while (r.iterations < max_iterations) {
        int relaxed_before = r.relaxed;
        r.worst = 0;
        for (int i = 0; i < entries; i++)
            relax_one(s[list ? list[i] : i], p, options, &r);
        r.iterations++;
        if (r.worst <= options.tolerance || r.relaxed == relaxed_before) break;
    }
    return r;
}
//<

//> sticks-relax-largest
//>   Southwell's way: find the largest strain, relax that stick, find again.
// The stick with the largest strain, the first of equals; -1 if none has any.
static int most_strained(const stick *s, int n, const particle *p, real *worst)
{
    int most = -1;
    *worst = 0;
    for (int k = 0; k < n; k++) {
        real strain = stick_strain(s[k], p);
        if (strain > *worst) *worst = strain, most = k;
    }
    return most;
}

relax_result sticks_relax_largest(const stick *s, int n, particle *p,
                                  int max_iterations, relax_options options)
{
    relax_result r = { .worst = 0 };
    for (r.iterations = 0; r.iterations < max_iterations; r.iterations++)
        for (int i = 0; i < n; i++) {
            int k = most_strained(s, n, p, &r.worst);
            r.tested += n;
            if (!(r.worst > options.tolerance)) return r;
            if (!stick_relax(s[k], p, options).moved) return r;
            r.relaxed++;
        }
    return r;
}
//<
