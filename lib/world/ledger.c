//> ledger-total
#include "ledger.h"

// A particle between two places: its velocity is that of the moment halfway,
// so its height and its lever arm are taken there, too.  A free fall then keeps
// kinetic and potential energy in balance exactly:
//     v^2/2 + g (x + x_previous)/2, with v' = v - g h and x' = x + v' h,
// changes by -v g h + (g h)^2/2 + g (v' + v) h/2 = 0.  Both places lie on the
// parabola, their middle (g h^2)/8 under it: with that added, h may change.
ledger_entry ledger_total(const world *w)
{
    ledger_entry sum = { 0, { 0, 0, 0 }, { 0, 0, 0 } };
    real h = w->age, g2 = vec3_length_squared(w->options.gravity);
    for (int i = 0; i < w->pool.count; i++) {
        const particle *p = &w->pool.at[i];
        if (w->of.inverse_mass[i] == 0) continue;
        real mass = 1 / w->of.inverse_mass[i];
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        vec3 x = vec3_scale(0.5, vec3_add(p->position, p->previous));
        sum.energy += mass * (vec3_length_squared(v) / 2 + g2 * h * h / 8
                              - vec3_dot(w->options.gravity, x));
        sum.momentum = vec3_add_scaled(sum.momentum, mass, v);
        sum.angular = vec3_add_scaled(sum.angular, mass, vec3_cross(x, v));
    }
    return sum;
}
//<

//> ledger-book
void ledger_open(world *w)
{
    if (w->options.ledger) w->ledger_now = ledger_total(w);
}

void ledger_book(world *w, int who)
{
    if (!w->options.ledger) return;
    ledger_entry now = ledger_total(w), *was = &w->ledger_now;
    ledger_entry *account = &w->ledger[who];
    account->energy += now.energy - was->energy;
    account->momentum = vec3_add(account->momentum,
                                 vec3_sub(now.momentum, was->momentum));
    account->angular = vec3_add(account->angular,
                                vec3_sub(now.angular, was->angular));
    *was = now;
}

void ledger_friction(world *w, real energy)
{
    if (!w->options.ledger) return;
    w->ledger[LEDGER_FRICTION].energy += energy;
    w->ledger[LEDGER_CONTACTS].energy -= energy;
}

void ledger_clear(world *w)
{
    for (int who = 0; who < LEDGERS; who++)
        w->ledger[who] = (ledger_entry){ 0, { 0, 0, 0 }, { 0, 0, 0 } };
}
//<
