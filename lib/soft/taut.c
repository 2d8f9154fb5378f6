//> taut-step
//>   A string that is taken where it will be: Thomas, with three right-hand sides.
// taut.c - a string under tension, stepped by the pull at the substep's end.
//
// Paper: nothing.  Book: chapter 12.

#include "taut.h"

// At m / 4 the links alone take the zigzag away in one substep.  Directions
// share that.
real taut_most(real inverse_mass, int directions)
{
    return 1 / (4 * directions * inverse_mass);
}

// Thomas's elimination of
//     x_k - w_k (a_k (x_(k+1) - x_k) - a_(k-1) (x_k - x_(k-1))) = x*_k,
// a: the stiffness.  In x_k = g_k + h_k x_(k+1) room keeps h and g, for x, y
// and z.
static void eliminate_string(taut_string s, real *h, real *g)
{
    real before = 0;                    // a_(k-1) (1 - h_(k-1))
    for (int k = 0; k < s.particles; k++) {
        int i = k * s.along;
        real w = s.weight[i], a = k + 1 < s.particles ? s.stiffness[k] : 0;
        real last = k > 0 ? w * s.stiffness[k - 1] : 0;
        real scale = 1 / (1 + w * (before + a));
        const real at[3] = { s.x[i], s.y[i], s.z[i] };
        for (int c = 0; c < 3; c++)
            g[3 * k + c] = scale * (k > 0 ? at[c] + last * g[3 * k - 3 + c]
                                          : at[c]);
        h[k] = scale * w * a;
        before = a * (1 - h[k]);
    }
}

void taut_step(taut_string s, real *room)
{
    real *h = room, *g = room + s.particles, x[3] = { 0, 0, 0 };
    eliminate_string(s, h, g);
    for (int k = s.particles - 1; k >= 0; k--) {
        int i = k * s.along;
        for (int c = 0; c < 3; c++) x[c] = g[3 * k + c] + h[k] * x[c];
        s.x[i] = x[0];
        s.y[i] = x[1];
        s.z[i] = x[2];
    }
}
//<
