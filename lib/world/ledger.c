//> ledger-total
//>   Before the move of a rigid body the halfway position is half a substep
//>   ahead, and after it half a substep behind.
#include "ledger.h"

#include <string.h>

// A mass that goes from one place to the next has its velocity at the moment
// halfway, so its height and its lever arm are taken there, too.  A free fall
// then keeps kinetic and potential energy in balance exactly:
//     v^2/2 + g (x + x_previous)/2, with v' = v - g h and x' = x + v' h,
// changes by -v g h + (g h)^2/2 + g (v' + v) h/2 = 0.  Both places lie on the
// parabola, their middle (g h^2)/8 under it: with that added, h may change.
static void add_mass(ledger_entry *sum, real mass, vec3 middle, vec3 v,
                     vec3 gravity, real h)
{
    real under = vec3_length_squared(gravity) * h * h / 8;
    sum->energy += mass * (under - vec3_dot(gravity, middle));
    sum->momentum = vec3_add_scaled(sum->momentum, mass, v);
    sum->angular = vec3_add_scaled(sum->angular, mass, vec3_cross(middle, v));
}

// What is asleep stands where it is, and not between two places.
static void add_particles(ledger_entry *sum, const world *w, const body *b,
                          bool is_asleep)
{
    real h = body_age(w, w->owner[b->first]), apart = is_asleep ? 0 : h;
    vec3 gravity = body_gravity(w, w->owner[b->first]);
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        const particle *p = &w->pool.at[i];
        if (w->inverse_mass[i] == 0) continue;
        real mass = 1 / w->inverse_mass[i];
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        vec3 middle = vec3_scale(0.5, vec3_add(p->position, p->previous));
        add_mass(sum, mass, middle, v, gravity, apart);
        sum->energy += mass * vec3_length_squared(v) / 2;
    }
}

// In a frame: a rigid body has its velocity, and has been moved, in the
// coordinates of its motion basis, and its particles wait.
static void add_rigid(ledger_entry *sum, const world *w, int b)
{
    const solver_body *now = &w->rigid.now[b];
    real ahead = w->rigid.halfway[b];
    vec3 v = motion_straight(&w->rigid.velocity[b]);
    vec3 moved = motion_straight(&w->rigid.moved[b]);
    vec3 middle = vec3_add_scaled(vec3_add(now->frame.center, moved), ahead, v);
    add_mass(sum, w->body[b].mass, middle, v, body_gravity(w, b), 2 * ahead);
    sum->energy += motion_energy(&now->basis, &w->rigid.velocity[b]);
    sum->angular = vec3_add(sum->angular, motion_angular(&now->basis,
                                                &w->rigid.velocity[b]));
}

ledger_entry ledger_total(const world *w)
{
    ledger_entry sum = { 0, { 0, 0, 0 }, { 0, 0, 0 } };
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        bool is_asleep = w->sleep.asleep[b];
        if (!body_is_dynamic(x)) continue;
        if (body_is_soft(x))
            sum.energy += soft_energy(x, w->pool.at);
        if (body_is_soft(x) || is_asleep || w->rigid.halfway[b] == 0)
            add_particles(&sum, w, x, is_asleep);
        else
            add_rigid(&sum, w, b);
    }
    return sum;
}
//<

//> ledger-book
//>   All accounts together give what has changed, to rounding
//>   (`books_balance_whatever_happens`).
void ledger_open(world *w)
{
    if (w->options.ledger) w->ledger_now = ledger_total(w);
}

void ledger_book(world *w, int account)
{
    if (!w->options.ledger) return;
    ledger_entry now = ledger_total(w), *was = &w->ledger_now;
    ledger_entry *entry = &w->ledger[account];
    entry->energy += now.energy - was->energy;
    entry->momentum = vec3_add(entry->momentum,
                               vec3_sub(now.momentum, was->momentum));
    entry->angular = vec3_add(entry->angular,
                              vec3_sub(now.angular, was->angular));
    *was = now;
}

void ledger_halfway(world *w, real seconds)
{
    for (int k = 0; k < w->rigid.awakes && w->options.ledger; k++)
        w->rigid.halfway[w->rigid.awake[k]] = seconds;
}

ledger_page ledger_mark(const world *w)
{
    ledger_page page = { .now = w->ledger_now };
    memcpy(page.account, w->ledger, sizeof page.account);
    return page;
}

void ledger_rewind(world *w, const ledger_page *to)
{
    memcpy(w->ledger, to->account, sizeof w->ledger);
    w->ledger_now = to->now;
}
//<
