// 07-friction.c - Coulomb's law in positions: a particle has fallen into a
// floor while it slid, by little and by much.  Where does it end?

#include "response.h"

#include <stdio.h>

static const real MU = 0.6, DEPTH = 1;          // depth in units of itself

int main(void)
{
    static const real SLID[2] = { 0.4, 1.9 };
    printf("# the overlap is 1, mu = %g\n# x y: previous position, position, "
           "position after\n", MU);
    for (int k = 0; k < 2; k++) {
        particle p = { { 0, -DEPTH, 0 }, { -SLID[k], 0.75, 0 }, 1 };
        feature_contact c = { .a = { 1, { 0 }, { 1 } }, .normal = { 0, 1, 0 } };
        printf("%.4f %.4f\n%.4f %.4f\n", p.previous.x, p.previous.y,
               p.position.x, p.position.y);
        response_separate(&c, &p, MU);
        printf("%.4f %.4f\n\n\n", p.position.x, p.position.y);
    }
    printf("# mu\n%g 0\n", MU);
    return 0;
}
