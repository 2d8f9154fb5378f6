// solution.c - two carts on a rail: what momentum decides, and what it does not.

#include "collision.h"

#include <assert.h>

// (m_a v_a + m_b v_b) / (m_a + m_b), times w_a w_b above and below: a mass of
// infinity then is a w of 0, and nothing is divided by it.
real common_velocity(cart a, cart b)
{
    real both = a.inverse_mass + b.inverse_mass;
    if (both == 0) return 0;
    return (b.inverse_mass * a.velocity + a.inverse_mass * b.velocity) / both;
}

// An impulse of 1 N s changes the speed of approach by w_a + w_b.
collision collide(cart *a, cart *b, real e)
{
    assert(e >= 0 && e <= 1);
    collision r = { 0, 0 };
    real approach = a->velocity - b->velocity;
    real both = a->inverse_mass + b->inverse_mass;
    if (approach <= 0 || both == 0) return r;
    r.impulse = (1 + e) * approach / both;
    r.lost = (1 - e * e) * approach * approach / (2 * both);
    a->velocity -= a->inverse_mass * r.impulse;
    b->velocity += b->inverse_mass * r.impulse;
    return r;
}
