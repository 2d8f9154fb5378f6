// 08-orders.c - a vertex of a body is displaced: how many relaxations, looks
// and microseconds until every stick is within a tolerance, in four orders?

#include "clock.h"
#include "ordering.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { LISTED, BREADTH, REPEATED, LARGEST, ORDERS };
enum { CORNERS = 162, STICKS = 600, BLOWS = 24, STEPS = 11,
       MOST_ITERATIONS = 20000 };
static const char *const NAME[ORDERS] = { "listed", "breadth first",
                                          "repeated", "largest first" };
// A fifth of the radius: a bad blow, no vertex through its neighbours' plane.
static const real BLOW = 0.2;

typedef struct {
    int particles, sticks;
    particle p[CORNERS];
    stick s[STICKS];
    stick_lists breadth, repeated;
} solid;

typedef struct {
    double relaxed, tested, us;
} cost;

static unsigned long long seed = 1;

static void add_corner(solid *b, vec3 v)
{
    v = vec3_unit(v);
    for (int i = 0; i < b->particles; i++)
        if (vec3_distance(b->p[i].position, v) < 1e-6) return;
    b->p[b->particles++] = (particle){ v, v, 1 };
}

// The corners of an icosahedron, and `depth` times the middles of all edges,
// blown up to the sphere.
static void corners(solid *b, int depth)
{
    const real golden = (1 + sqrt(5)) / 2;
    for (int i = 0; i < 4; i++) {
        real u = i & 1 ? 1 : -1, v = i & 2 ? golden : -golden;
        add_corner(b, vec3_make(0, u, v));
        add_corner(b, vec3_make(u, v, 0));
        add_corner(b, vec3_make(v, 0, u));
    }
    real reach = 1.1;   // longest edge of an icosahedron: 1.05
    for (; depth > 0; depth--, reach *= 0.58) {
        int n = b->particles;
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++) {
                vec3 u = b->p[i].position, v = b->p[j].position;
                if (vec3_distance(u, v) < reach) add_corner(b, vec3_add(u, v));
            }
    }
}

// Sticks along the edges (all pairs nearer than reach) and through the middle.
static int solid_make(solid *b, int depth)
{
    *b = (solid){ .particles = 0 };
    corners(b, depth);
    real reach = depth == 0 ? 1.1 : 0.36;
    for (int i = 0; i < b->particles; i++)
        for (int j = i + 1; j < b->particles; j++) {
            real d = vec3_distance(b->p[i].position, b->p[j].position);
            if (d > reach && d < 1.999999) continue;
            if (b->sticks == STICKS) return 0;
            b->s[b->sticks++] = (stick){ i, j, d, 1, STICK_EXACT };
        }
    return stick_lists_build(&b->breadth, b->s, b->sticks, b->particles,
                             false).ok &&
           stick_lists_build(&b->repeated, b->s, b->sticks, b->particles,
                             true).ok;
}

static void solid_free(solid *b)
{
    stick_lists_free(&b->breadth);
    stick_lists_free(&b->repeated);
}

static relax_result relax(const solid *b, int order, int from, particle *p,
                          relax_options o)
{
    const stick_lists *lists = order == REPEATED ? &b->repeated : &b->breadth;
    if (order == LARGEST)
        return sticks_relax_largest(b->s, b->sticks, p, MOST_ITERATIONS, o);
    return sticks_relax_from(lists, order == LISTED ? -1 : from, b->s,
                             b->sticks, p, MOST_ITERATIONS, o);
}

// The mean over all blows; the time is the least of `again` runs of each.
static cost measure(const solid *b, int order, real tolerance,
                    const int *struck, const vec3 *blow, int again)
{
    static particle p[CORNERS];
    cost sum = { 0, 0, 0 };
    relax_options o = relax_options_pbd();
    o.dead_band = true;
    o.tolerance = tolerance;
    for (int k = 0; k < BLOWS; k++) {
        real best = 1e9;
        relax_result r = { .worst = 0 };
        for (int t = 0; t < again; t++) {
            for (int i = 0; i < b->particles; i++) p[i] = b->p[i];
            vec3 *x = &p[struck[k]].position;
            *x = vec3_add_scaled(*x, BLOW, blow[k]);
            real start = clock_seconds();
            r = relax(b, order, struck[k], p, o);
            best = real_min(clock_seconds() - start, best);
        }
        if (!(r.worst <= tolerance)) fprintf(stderr, "did not converge\n");
        sum.relaxed += r.relaxed;
        sum.tested += r.tested;
        sum.us += best * 1e6;
    }
    return (cost){ sum.relaxed / BLOWS, sum.tested / BLOWS, sum.us / BLOWS };
}

// Which order is the quickest at this tolerance, and how much longer the
// listed one takes.
static void print_row(const char *title, real tolerance, const cost *c)
{
    int best = 0;
    char at[32];
    for (int i = 1; i < ORDERS; i++)
        if (c[i].us < c[best].us) best = i;
    snprintf(at, sizeof at, "strain %g", tolerance);
    clock_print_row("ordering", title, at, NAME[best],
                    best ? NAME[0] : NAME[2],
                    c[best ? 0 : 2].us / c[best].us);
}

static void table(const char *title, solid *b, int again)
{
    cost all[ORDERS];
    static const real TO[STEPS] = { 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4,
                                    3e-5, 1e-5, 3e-6, 1e-6 };
    int struck[BLOWS];
    vec3 blow[BLOWS];
    for (int k = 0; k < BLOWS; k++) {
        real x = random_real(&seed), y = random_real(&seed);
        blow[k] = vec3_unit(vec3_make(x, y, random_real(&seed)));
        struck[k] = k * b->particles / BLOWS;
    }
    printf("\n\n# %s: %d particles, %d sticks\n# tolerance", title,
           b->particles, b->sticks);
    for (int i = 0; i < ORDERS; i++)
        printf(" | %s: relaxed tested us", NAME[i]);
    printf("\n");
    for (int t = 0; t < STEPS; t++) {
        printf("%g", TO[t]);
        for (int i = 0; i < ORDERS; i++) {
            int few = i == LARGEST ? 1 : 5;
            int runs = TO[t] >= 1e-3 && i != LARGEST ? again : few;
            cost c = measure(b, i, TO[t], struck, blow, runs);
            printf("  %.1f %.1f %.3g", c.relaxed, c.tested, c.us);
            all[i] = c;
        }
        printf("\n");
        if (t % 4 == 2) print_row(title, TO[t], all);
    }
}

int main(void)
{
    static solid small, large;
    if (!solid_make(&small, 0) || !solid_make(&large, 2)) return 1;
    printf("# one vertex displaced by %g of the radius; mean of %d blows\n"
           "# %s, %s\n", BLOW, BLOWS, __VERSION__, FLAGS);
    table("icosahedron", &small, 100);
    table("sphere of 162 vertices", &large, 8);
    solid_free(&small);
    solid_free(&large);
    return 0;
}
