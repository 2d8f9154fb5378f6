//> solver-strike
#include "solver.h"
#include "contacts.h"
#include "halves.h"
#include "ledger.h"

#include <stddef.h>

// How many contacts from k on, forward or backward, are of one pair.
static int of_one_pair(const push_tables *t, int k, int step)
{
    int n = 1;
    for (int i = k + step; i >= 0 && i < t->count
         && t->between[i][0] == t->between[k][0]
         && t->between[i][1] == t->between[k][1]; i += step) n++;
    return n;
}

static int strike_in_turn(world *w, int step, push_options how, real h)
{
    const push_tables *t = &w->pushes;
    int again = 0;
    for (int k = step > 0 ? 0 : t->count - 1, n; k >= 0 && k < t->count;
         k += step * n) {
        n = of_one_pair(t, k, step);
        push *first = &t->at[step > 0 ? k : k - n + 1];
        real slow = contacts_blow_speed(w, &w->body[t->between[k][0]]) * h;
        again |= push_blow(first, n, w->pool.at, how, slow);
    }
    return again;
}

// Every pair in turn, until none strikes again: a blow that is passed on, as in
// Newton's cradle, is one more blow.  Forward and backward, so that one round
// takes it through a row, whichever way that is numbered.
static void strike_all(world *w, push_options how, real h)
{
    enum { ROUNDS = 8 };
    int again = how.restitution > 0;
    for (int round = 0; again && round < ROUNDS; round++)
        again = strike_in_turn(w, round % 2 ? -1 : 1, how, h);
}
//<

//> solver-parts
// A substep's contacts, and what is done with all of them.
typedef struct {
    world *w;
    push_pile pile;
    push_options how;
    real h, enough;
    int  step;              // of the pass: 1 forward, -1 backward
    real share;             // of the lean
    int  overlaps[PILE_PARTS], mended[PILE_PARTS];
    real change[PILE_PARTS], leads_on[PILE_PARTS];
} pushing;

// Both sides of the cut at once, then what lies across it; or that first.
static void do_parts(pushing *s, void (*work)(void *s, int part), int step)
{
    if (step < 0) work(s, PILE_ACROSS);
    halves_do(s->w, work, s);
    if (step > 0) work(s, PILE_ACROSS);
}

static void begin_part(void *data, int part)
{
    pushing *s = data;
    const world *w = s->w;
    int n = 0;
    const int *mine = part < PILE_ACROSS ? halves_bodies(w, part, &n) : NULL;
    for (int i = 0; i < n; i++)
        w->pushes.drift[mine[i]] = (push_drift){ .stirred = 0 };
    s->overlaps[part] = pile_begin(&s->pile, part, w->pool.at, s->how, s->h);
}

static void mend_part(void *data, int part)
{
    pushing *s = data;
    s->mended[part] = pile_mend(&s->pile, part, s->how);
}

static void settle_part(void *data, int part)
{
    pushing *s = data;
    pile_settle(&s->pile, part);
}

static void pass_part(void *data, int part)
{
    pushing *s = data;
    s->change[part] = pile_pass(&s->pile, part, s->step, s->enough, s->how);
    if (s->step < 0) s->leads_on[part] = pile_leads_on(&s->pile, part);
}

static void lean_part(void *data, int part)
{
    pushing *s = data;
    pile_lean(&s->pile, part, s->share, s->how);
}

static void apply_part(void *data, int part)
{
    const world *w = ((pushing *)data)->w;
    int n;
    const int *mine = halves_bodies(w, part, &n);
    for (int i = 0; i < n; i++) {
        int b = mine[i];
        if (!body_is_soft(&w->body[b]) && body_moves(w, b))
            drift_apply(&w->pushes.drift[b], &w->pushes.ways[b],
                        w->pool.at + w->body[b].first);
    }
}
//<

//> solver-passes
// m, the largest change of a gap in a pass.
static real pass(pushing *s, int step)
{
    const real *x = s->change;
    s->step = step;
    do_parts(s, pass_part, step);
    return fmax(fmax(x[PILE_LEFT], x[PILE_RIGHT]), x[PILE_ACROSS]);
}

// One pass forward, one backward, for only both together converge without
// swinging.
static real pass_twice(pushing *s)
{
    real forward = pass(s, 1);
    return fmax(forward, pass(s, -1));
}

// Passes shrink what is wrong in a stack of n by 1 - 1/n^2 a time, with m under
// M by 1 - m/M.  With Nesterov's momentum these are 1 - 1/n and 1 - sqrt(m/M):
// each pair begins a little further on than the last one ended, by more and
// more, until that leads back: then it begins anew (O'Donoghue, Candes 2015).
static real lean_on(pushing *s, real pace)
{
    const real *x = s->leads_on;
    if (x[PILE_LEFT] + x[PILE_RIGHT] + x[PILE_ACROSS] < 0) pace = 1;
    real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
    s->share = (pace - 1) / next;
    do_parts(s, lean_part, 1);
    return next;
}

static void mend_all(pushing *s)
{
    const int *x = s->overlaps, *y = s->mended;
    if (!x[PILE_LEFT] && !x[PILE_RIGHT] && !x[PILE_ACROSS]) return;
    do_parts(s, mend_part, -1);
    if (y[PILE_LEFT] || y[PILE_RIGHT] || y[PILE_ACROSS])
        do_parts(s, settle_part, 1);
}

// A frame of fewer substeps has as many passes in all: each gives what it has
// saved, and only those that are needed are made.
static int passes_of(const world *w)
{
    const world_options *o = &w->options;
    int n = w->report.substeps;
    return n < o->substeps ? (o->passes * o->substeps + n - 1) / n : o->passes;
}

static void solve_all(world *w, push_options how, real h)
{
    const push_tables *t = &w->pushes;
    pushing s = { .w = w, .how = how, .h = h,
        .pile = { .push = t->at, .order = t->in_parts, .drift = t->drift,
                  .bodies = w->bodies, .near = t->near },
        .enough = w->options.content * w->least_radius };
    real pace = 1;
    for (int part = 0; part < PILE_PARTS; part++)
        s.pile.end[part] = t->end[part];
    do_parts(&s, begin_part, 1);
    const int *n = s.pile.nears;
    if (n[PILE_LEFT] + n[PILE_RIGHT] + n[PILE_ACROSS] == 0) return;
    mend_all(&s);
    for (int k = 0; k < passes_of(w); k += 2) {
        if (k > 0) pace = lean_on(&s, pace);
        if (!(pass_twice(&s) > s.enough)) break;
    }
    halves_do(w, apply_part, &s);
}
//<

//> solver-separate
// Bodies at rest overlap by so much of what keeps them apart, which is no
// overlap of the bodies themselves: their skins only.
static const real SLOP = 0.05;

static push_options options_of(const world *w, real h)
{
    const world_options *o = &w->options;
    return (push_options){ o->friction, o->restitution, o->mend,
                           o->mend_speed, vec3_scale(h * h, o->gravity), SLOP,
                           o->ledger };
}

static void book_friction(world *w, real h)
{
    real worn = 0;
    if (!w->options.ledger) return;
    for (int k = 0; k < w->pushes.count; k++) {
        worn += w->pushes.at[k].worn;
        w->pushes.at[k].worn = 0;
    }
    ledger_friction(w, worn / (h * h));
}

void solver_separate(world *w, real h)
{
    push_options how = options_of(w, h);
    strike_all(w, how, h);
    if (w->pushes.count > 0) solve_all(w, how, h);
    book_friction(w, h);
}
//<

//> solver-end
static void note_touch(world *w, int a, int b)
{
    if (b >= w->bodies) return;
    if (!body_is_nailed(&w->body[a]) && !body_is_nailed(&w->body[b]))
        rest_touch(&w->rest, a, b);
}

void solver_end(world *w)
{
    w->report.pushing = 0;
    for (int k = 0; k < w->pushes.count; k++) {
        if (!(w->pushes.at[k].pushed[NORMAL] > 0)) continue;
        note_touch(w, w->pushes.between[k][0], w->pushes.between[k][1]);
        w->report.pushing++;
    }
    w->report.contacts = w->pushes.count;
}
//<
