// solution.c - a binary tree of winners.

#include "tournament.h"

// -1 is no stick.
static int better(const tournament *t, int left, int right)
{
    if (left < 0 || right < 0) return left < 0 ? right : left;
    return t->value[right] > t->value[left] ? right : left;
}

void tournament_begin(tournament *t)
{
    for (int k = 0; k < t->leaves; k++)
        t->winner[t->leaves + k] = k < t->n ? k : -1;
    if (t->leaves == 1) return;
    for (int node = t->leaves - 1; node >= 1; node--)
        t->winner[node] = better(t, t->winner[2 * node],
                                 t->winner[2 * node + 1]);
}

void tournament_change(tournament *t, int k)
{
    for (int node = (t->leaves + k) / 2; node >= 1; node /= 2)
        t->winner[node] = better(t, t->winner[2 * node],
                                 t->winner[2 * node + 1]);
}

static void measure(tournament *t, real *strain, const stick *s,
                    const particle *p, int k, relax_result *r)
{
    strain[k] = stick_strain(s[k], p);
    tournament_change(t, k);
    r->tested++;
}

// The sticks of particle v, which stand first in its list.
static void measure_around(tournament *t, real *strain,
                           const stick_lists *around, const stick *s,
                           const particle *p, int v, relax_result *r)
{
    for (int i = around->start[v]; i < around->start[v + 1]; i++) {
        int k = around->stick[i];
        if (s[k].a != v && s[k].b != v) break;
        measure(t, strain, s, p, k, r);
    }
}

relax_result tournament_relax(tournament *t, real *strain,
                              const stick_lists *around, const stick *s,
                              particle *p, int most, relax_options options)
{
    relax_result r = { .tested = t->n };
    for (int k = 0; k < t->n; k++) strain[k] = stick_strain(s[k], p);
    tournament_begin(t);
    while (t->n > 0 && r.relaxed < most) {
        int k = t->winner[1];
        if (!(strain[k] > options.tolerance)) break;
        if (!stick_relax(s[k], p, options).moved) break;
        r.relaxed++;
        measure_around(t, strain, around, s, p, s[k].a, &r);
        measure_around(t, strain, around, s, p, s[k].b, &r);
    }
    r.worst = t->n > 0 ? strain[t->winner[1]] : 0;
    return r;
}
