//> soft-step-wake
//>   The view holds pointers to what the cloth may read and move, and nothing
//>   else.
#include "soft_step.h"
#include "ledger.h"
#include "pin.h"

#include <stddef.h>

soft_frame soft_frame_of(world *w, real h)
{
    const world_options *o = &w->options;
    rigid_tables *t = &w->rigid;
    return (soft_frame){
        .body = w->body, .asleep = w->sleep.asleep, .bodies = w->bodies,
        .soft = w->soft.near.soft, .softs = w->soft.near.softs,
        .particle = w->pool.at, .hold = w->soft.hold, .now = t->now, .moved = t->moved,
        .velocity = t->velocity, .ball = t->ball, .ahead = t->ahead,
        .tied = w->joints.tied, .ties = w->joints.ties,
        .plane = w->plane, .planes = w->planes, .gravity = o->gravity,
        .material = t->material, .wall = w->wall, .owner = w->owner,
        .sunk = w->soft.sunk, .owed = w->soft.owed,
        .iterations = o->iterations, .certified = o->certified,
        .relax = o->relax, .substeps = o->substeps,
        .stiff_substeps = world_usual(w, true),
        .most_substeps = o->most_substeps, .frame = w->frame,
        .whole = o->dt, .age = w->age,
        .h = h };
}

// A pin holds a particle inside of a body, or nearer than the two may come.  When
// it lets go, they must have been apart before they meet again: they would be
// thrown apart.
static void forget_ties(world *w)
{
    soft_frame f = soft_frame_of(w, w->age);
    for (int k = w->joints.ties - 1; k >= 0; k--) {
        const body_tie *t = &w->joints.tied[k];
        if (t->pins > 0 || !touch_is_clear(&w->soft.view, &f, t->soft, t->rigid))
            continue;
        linkage_untie(&w->joints, k);
        w->soft.near.is_stale = true;
    }
}

static void find_hung(world *w)
{
    bool *held = w->soft.held;
    for (int b = 0; b < w->bodies; b++) held[b] = false;
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        if (j->kind == JOINT_PIN && !j->is_broken) held[j->a] = true;
    }
}

bool soft_wake(world *w)
{
    bool woke = false;
    forget_ties(w);
    find_hung(w);
    soft_frame f = soft_frame_of(w, w->age);
    soft_begin(&w->soft, &f);
    for (int n = 0; n < f.softs; n++) {
        int a = f.soft[n];
        for (int b = 0; b < w->bodies && !body_is_static(&w->body[a]); b++) {
            int of = body_whole(&w->body[b], b);
            if (b == a || !soft_may_touch(&w->soft, a, b)
                || body_is_fixed(&w->body[b])
                || !body_meets(&w->body[a], &w->body[b])) continue;
            woke |= world_wake_near(w, a, of);
            if (body_is_dynamic(&w->body[of])) sleep_touch(&w->sleep, a, of);
        }
    }
    return woke;
}
//<

//> soft-step
//>   The cloth says how many substeps it needs, takes them, and reports.
int soft_need(world *w)
{
    soft_frame f = soft_frame_of(w, w->age);
    return soft_substeps(&w->soft, &f);
}

void soft_step(world *w, real h)
{
    soft_frame f = soft_frame_of(w, h);
    soft_move(&w->soft, &f);
    pins_begin(&w->joints, &f);
    w->age = h;
    ledger_book(w, LEDGER_INTEGRATE);
    soft_draw(&w->soft, &f);
    ledger_book(w, LEDGER_STICKS);
    soft_separate(&w->soft, &f);
    ledger_book(w, LEDGER_CONTACTS);
    soft_relax(&w->soft, &f);
    ledger_book(w, LEDGER_STICKS);
    soft_hold(&w->soft, &f);
    pins_end(&w->joints, &f);
    // It is asked in any case, for it counts the time of the way.
    if (certificate_is_due(&w->soft.proof, &f) && f.certified) soft_prove(w);
    soft_calm(&w->soft, &f);
    ledger_book(w, LEDGER_CONTACTS);
}

void soft_prove(world *w)
{
    soft_frame f = soft_frame_of(w, w->age);
    soft_certify(&w->soft, &f);
    soft_calm(&w->soft, &f);
    w->report.prevented += w->soft.proof.prevented;
    w->report.crossed = int_max(w->report.crossed, w->soft.proof.left_out);
}

void soft_report(world *w)
{
    soft_solver *s = &w->soft;
    step_report *r = &w->report;
    soft_frame f = soft_frame_of(w, w->age);
    r->near = s->near.pairs + s->near.points;
    r->touching = s->touching;
    r->rebuilt += s->near.made;
    r->dropped += s->near.dropped;
    r->tested += s->tested;
    r->relaxed += s->relaxed;
    r->fell_back += s->fell_back;
    r->unconverged += soft_unconverged(s, &f);
}
//<
