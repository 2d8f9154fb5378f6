// solution.c - stretches of a rope are its tree.

#include "necklace.h"

typedef struct {
    int first, last;
} stretch;

typedef struct {
    const necklace *n;
    real near;
    int  apart;
    leaf_pair *out;
    int  capacity;
    tree_result result;
} search;

sphere stretch_ball(const necklace *n, int first, int last)
{
    int m = (first + last) / 2;
    int links = last - m > m - first ? last - m : m - first;
    return (sphere){ n->at[m], links * n->link };
}

static int come_near(const search *k, stretch s, stretch t)
{
    sphere a = stretch_ball(k->n, s.first, s.last);
    sphere b = stretch_ball(k->n, t.first, t.last);
    real near = a.radius + b.radius + k->near;
    return vec3_length_squared(vec3_sub(a.center, b.center)) < near * near;
}

// s lies before t.  The longer one is halved until both are single beads.
static void search_two(search *k, stretch s, stretch t)
{
    if (t.last - s.first <= k->apart) return;
    k->result.visited++;
    if (!come_near(k, s, t)) return;
    int beads_s = s.last - s.first, beads_t = t.last - t.first;
    int m = (s.first + s.last) / 2, h = (t.first + t.last) / 2;
    if (beads_s == 0 && beads_t == 0) {
        if (k->result.pairs < k->capacity)
            k->out[k->result.pairs] = (leaf_pair){ s.first, t.first };
        k->result.pairs++;
    } else if (beads_s >= beads_t) {
        search_two(k, (stretch){ s.first, m }, t);
        search_two(k, (stretch){ m + 1, s.last }, t);
    } else {
        search_two(k, s, (stretch){ t.first, h });
        search_two(k, s, (stretch){ h + 1, t.last });
    }
}

static void search_self(search *k, stretch s)
{
    if (s.last <= s.first) return;
    int m = (s.first + s.last) / 2;
    search_self(k, (stretch){ s.first, m });
    search_self(k, (stretch){ m + 1, s.last });
    search_two(k, (stretch){ s.first, m }, (stretch){ m + 1, s.last });
}

tree_result necklace_pairs(const necklace *n, real near, int apart,
                           leaf_pair *out, int capacity)
{
    search k = { n, near, apart, out, capacity, { 0, 0, 0 } };
    search_self(&k, (stretch){ 0, n->beads - 1 });
    return k.result;
}
