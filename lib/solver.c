//> solver-forgetful
#include "solver.h"
#include "contacts.h"
#include "ledger.h"

static void touch_again(world *w, int a, int b)
{
    w->collided[a] = 1;
    if (b < 0 || b >= w->bodies) return;
    w->collided[b] = 1;
    if (!body_is_nailed(&w->body[a]) && !body_is_nailed(&w->body[b]))
        rest_touch(&w->rest, a, b);
}

static void separate_contacts(world *w)
{
    for (int k = 0; k < w->contacts; k++) {
        w->contact[k].pushed = w->contact[k].worn = 0;
        if (contact_separate(&w->contact[k], w->pool.at,
                             w->options.response) > 0)
            touch_again(w, w->between[k][0], w->between[k][1]);
    }
}
//<

//> solver-strike
// How many contacts from k on, forward or backward, are of one pair.
static int of_one_pair(const world *w, int k, int step)
{
    int n = 1;
    for (int i = k + step; i >= 0 && i < w->pushes
         && w->pushed[i][0] == w->pushed[k][0]
         && w->pushed[i][1] == w->pushed[k][1]; i += step) n++;
    return n;
}

static int strike_in_turn(world *w, int step, push_options how, real h)
{
    int again = 0;
    for (int k = step > 0 ? 0 : w->pushes - 1, n; k >= 0 && k < w->pushes;
         k += step * n) {
        n = of_one_pair(w, k, step);
        push *first = &w->push[step > 0 ? k : k - n + 1];
        real slow = contacts_blow_speed(w, &w->body[w->pushed[k][0]]) * h;
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

//> solver-passes
// One pass forward, one backward, for only both together converge without
// swinging.  Returns the largest change of a gap (m).
static real pass_twice(push_pile *s, real enough, push_options how)
{
    real forward = pile_pass(s, 1, enough, how);
    return fmax(forward, pile_pass(s, -1, enough, how));
}

// Passes shrink what is wrong in a stack of n by 1 - 1/n^2 a time, with m under
// M by 1 - m/M.  With Nesterov's momentum these are 1 - 1/n and 1 - sqrt(m/M):
// each pair begins a little further on than the last one ended, by more and
// more, until that leads back: then it begins anew (O'Donoghue, Candes 2015).
static real lean_on(push_pile *s, real pace, push_options how)
{
    if (pile_leads_on(s) < 0) pace = 1;
    real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
    pile_lean(s, (pace - 1) / next, how);
    return next;
}

static void solve_all(world *w, push_options how, real h)
{
    push_pile s = { w->push, w->pushes, w->drift, w->bodies, w->near_push, 0 };
    real enough = w->options.content * w->least_radius, pace = 1;
    pile_begin(&s, w->pool.at, how, h);
    if (s.nears == 0) return;
    for (int pass = 0; pass < w->options.passes; pass += 2) {
        if (pass > 0) pace = lean_on(&s, pace, how);
        if (!(pass_twice(&s, enough, how) > enough)) break;
    }
    for (int b = 0; b < w->bodies; b++)
        if (w->body[b].four && body_moves(w, b))
            drift_apply(&w->drift[b], &w->ways[b],
                        w->pool.at + w->body[b].first);
}
//<

//> solver-separate
// Bodies at rest overlap by so much of what keeps them apart, which is no
// overlap of the bodies themselves: their skins only.
static const real SLOP = 0.05;

static push_options options_of(const world *w, real h)
{
    const world_options *o = &w->options;
    return (push_options){ o->response.friction, o->response.restitution,
                           o->mend, o->mend_speed,
                           vec3_scale(h * h, o->gravity), SLOP, o->ledger };
}

static void book_friction(world *w, real h)
{
    real worn = 0;
    if (!w->options.ledger) return;
    for (int k = 0; k < w->pushes; k++) {
        worn += w->push[k].worn;
        w->push[k].worn = 0;
    }
    for (int k = 0; k < w->contacts; k++) worn += w->contact[k].worn;
    ledger_friction(w, worn / (h * h));
}

void solver_separate(world *w, real h)
{
    push_options how = options_of(w, h);
    separate_contacts(w);
    strike_all(w, how, h);
    if (w->pushes > 0) solve_all(w, how, h);
    book_friction(w, h);
}
//<

//> solver-remember
void solver_remember(world *w)
{
    for (int k = 0; k < w->pushes; k++)
        if (w->push[k].pushed[NORMAL] > 0)
            touch_again(w, w->pushed[k][0], w->pushed[k][1]);
    w->memories = 0;
    contacts_remember(w, 0, w->lasting_pushes);
    w->lasting_memories = w->memories;
    contacts_remember(w, w->lasting_pushes, w->pushes);
    w->report.contacts = w->contacts + w->pushes;
    w->report.pushing = w->memories;
}
//<

//> solver-bounce
static void slow_sticks(world *w, int b)
{
    if (b < 0 || !w->moves[b]) return;
    const shape *plan = w->body[b].plan;
    sticks_sweep_speeds(plan->stick, plan->sticks,
                        w->pool.at + w->body[b].first);
}

// Did this contact, in this substep, part bodies that met in a blow?
static int is_blow(const contact *c)
{
    return c->pushed > 0 && c->approach > 0;
}

// A push moves places, and so gives a speed as well that nobody asked for.
// After a blow the features part at restitution times the speed at which they
// met: contact_bounce gives that speed to the features alone, and the sticks
// spread it over the bodies: in turn, so often that both nearly agree.
void solver_bounce(world *w, real h)
{
    enum { ROUNDS = 40 };
    int blows = 0;
    for (int k = 0; k < w->contacts; k++) blows += is_blow(&w->contact[k]);
    for (int round = 0; blows > 0 && round < ROUNDS; round++)
        for (int k = 0; k < w->contacts; k++) {
            if (!is_blow(&w->contact[k])) continue;
            contact_bounce(&w->contact[k], w->pool.at, w->options.response, h);
            slow_sticks(w, w->between[k][0]);
            slow_sticks(w, w->between[k][1]);
        }
    for (int k = 0; blows > 0 && k < w->contacts; k++)
        if (is_blow(&w->contact[k])) w->contact[k].approach = 0;
}
//<
