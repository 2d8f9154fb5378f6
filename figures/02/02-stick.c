// 02-stick.c - what one relaxation costs: a rope in list order, where each
// stick waits for the one before it, and with its even sticks first, where none
// waits; beside a bare loop that can do nothing but PBD with the exact root.

#include "clock.h"
#include "constraint.h"
#include "interleave.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { LINKS = 400, ITERATIONS = 200, ROUNDS = 60, WAYS = 4 };

static const char *const way_name[WAYS] = {
    "bare loop", "PBD, exact root", "PBD, approximate root", "SHAKE"
};

// The least that a stick can be: no kind, no stiffness, no guard, no strain.
static void bare_iteration(const stick *s, int n, particle *p)
{
    for (int i = 0; i < n; i++) {
        particle *a = &p[s[i].a], *b = &p[s[i].b];
        vec3 along = vec3_sub(b->position, a->position);
        real length = vec3_length(along);
        real k = (length - s[i].rest_length)
               / (length * (a->inverse_mass + b->inverse_mass));
        a->position = vec3_add_scaled(a->position, k * a->inverse_mass, along);
        b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, along);
    }
}

static void rope(particle *p)
{
    for (int i = 0; i <= LINKS; i++) {
        p[i].previous = (vec3){ i * 0.01, 0, 0 };
        p[i].position = (vec3){ i * 0.01, 1e-3 * (i * 7 % 13) / 13,
                                1e-3 * (i * 5 % 17) / 17 };
        p[i].inverse_mass = 1;
    }
}

static relax_options options_of(int way)
{
    relax_options o = relax_options_pbd();
    if (way == 2) o.root = ROOT_APPROXIMATE;
    if (way == 3) o.gradient = GRADIENT_OLD;
    return o;
}

// The best of the rounds, ns a stick.
static double cost(int way, const stick *s, particle *p)
{
    relax_options o = options_of(way);
    double best = 1e9;
    for (int k = 0; k < ROUNDS; k++) {
        rope(p);
        double begin = clock_seconds();
        for (int i = 0; i < ITERATIONS; i++)
            if (way == 0) bare_iteration(s, LINKS, p);
            else          sticks_iterate(s, LINKS, p, o);
        best = fmin(best, (clock_seconds() - begin) * 1e9
                          / (ITERATIONS * LINKS));
    }
    return best;
}

int main(void)
{
    static particle p[LINKS + 1];
    static stick listed[LINKS], apart[LINKS];
    for (int i = 0; i < LINKS; i++)
        listed[i] = apart[i] = (stick){ i, i + 1, 0.01, 1, STICK_EXACT };
    if (!interleave(apart, LINKS, LINKS + 1)) return 1;

    printf("# One relaxation of a stick, ns, and as a fraction of the bare "
           "loop in list order\n# %s, %s\n# way listed_ns apart_ns listed "
           "apart\n", __VERSION__, FLAGS);
    double unit = cost(0, listed, p);
    for (int way = 0; way < WAYS; way++) {
        double a = cost(way, listed, p), b = cost(way, apart, p);
        printf("\"%s\" %.2f %.2f %.3f %.3f\n", way_name[way], a, b, a / unit,
               b / unit);
    }
    return 0;
}
