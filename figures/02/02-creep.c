// 02-creep.c - how error leaves a chain of sticks that are all too long: at its
// ends alone.  Then the largest error of the chain against the number of
// iterations, beside cos^2(pi / (n + 1)) an iteration.

#include "constraint.h"

#include <math.h>
#include <stdio.h>

enum { LINKS = 50, MOST = 2000 };

static const real FIRST = 1e-6;     // so small that the chain is linear
static const real PI = 3.14159265358979323846;

typedef struct {
    particle p[LINKS + 1];
    stick s[LINKS];
} chain;

static chain chain_start(void)
{
    chain c;
    for (int i = 0; i <= LINKS; i++) {
        vec3 x = { i * (1 + FIRST), 0, 0 };
        c.p[i] = (particle){ x, x, 1 };
    }
    for (int i = 0; i < LINKS; i++)
        c.s[i] = (stick){ i, i + 1, 1, 1, STICK_EXACT };
    return c;
}

static real error_of(const chain *c, int k)
{
    return (vec3_distance(c->p[k].position, c->p[k + 1].position) - 1) / FIRST;
}

static real largest(const chain *c)
{
    real most = 0;
    for (int k = 0; k < LINKS; k++) most = fmax(most, fabs(error_of(c, k)));
    return most;
}

int main(void)
{
    const int look[] = { 0, 10, 100, 300, 1000 };
    chain c = chain_start();
    int done = 0;
    printf("# The error of each stick, as a fraction of the first\n");
    for (int i = 0; i < (int)(sizeof look / sizeof *look); i++) {
        for (; done < look[i]; done++)
            sticks_iterate(c.s, LINKS, c.p, relax_options_pbd());
        printf("%s# after %d iterations: stick error\n", i ? "\n\n" : "",
               done);
        for (int k = 0; k < LINKS; k++)
            printf("%d %.5f\n", k + 1, error_of(&c, k));
    }

    c = chain_start();
    real rho = pow(cos(PI / (LINKS + 1)), 2), before = 1;
    printf("\n\n# iterations, largest error\n");
    for (int k = 0; k <= MOST; k++) {
        if (k % 20 == 0) printf("%d %.6f\n", k, largest(&c));
        if (k == MOST) break;
        before = largest(&c);
        sticks_iterate(c.s, LINKS, c.p, relax_options_pbd());
    }
    printf("# the last iteration left %.5f of the error; the law: %.5f\n",
           largest(&c) / before, rho);
    return 0;
}
