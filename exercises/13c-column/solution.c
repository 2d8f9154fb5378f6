// solution.c - a substep of a column: warm start, push, move, relax.

#include "column.h"

give column_spring(real h, real omega, real zeta)
{
    real a1 = 2 * zeta + h * omega, a2 = h * omega * a1;
    return (give){ omega / a1, a2 / (1 + a2), 1 / (1 + a2) };
}

// An impulse on box k, and its opposite on what it lies on.
static void apply(crate *c, int k, real impulse)
{
    c[k].velocity += c[k].inverse_mass * impulse;
    if (k > 0) c[k - 1].velocity -= c[k - 1].inverse_mass * impulse;
}

// m/s, that contact k must lose; and the share of its impulse that leaks.
static real closing(const crate *c, int k, give g, real h, real *leak)
{
    real below = k > 0 ? c[k - 1].velocity : 0;
    real gap = c[k].y - (k > 0 ? c[k - 1].y : 0);
    real speed = c[k].velocity - below;
    *leak = 0;
    if (gap > 0) return speed + gap / h;
    *leak = g.leak;
    return g.mass * (speed + real_max(g.rate * gap, -3));
}

static void pass(crate *c, real *push, int count, give g, real h)
{
    for (int k = 0; k < count; k++) {
        real leak, lack = closing(c, k, g, h, &leak);
        real mass = 1 / (c[k].inverse_mass + (k > 0 ? c[k - 1].inverse_mass : 0));
        real wanted = real_max(0, push[k] - mass * lack - leak * push[k]);
        apply(c, k, wanted - push[k]);
        push[k] = wanted;
    }
}

void column_substep(crate *c, real *push, int count, give soft, real h, real gravity)
{
    const give hard = { 0, 1, 0 };
    for (int k = 0; k < count; k++) c[k].velocity -= h * gravity;
    for (int k = 0; k < count; k++) apply(c, k, push[k]);
    pass(c, push, count, soft, h);
    for (int k = 0; k < count; k++) c[k].y += h * c[k].velocity;
    pass(c, push, count, hard, h);
}
