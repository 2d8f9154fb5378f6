// 20-ropes.c - hard cases 7, 8 and 9: a chain that whips, a rope with a load, a
// chain at rest.  Blocks for gnuplot: places of the chain's particles, and of
// its end; the strain of the rope against the load, for sweeps, small steps and
// the line solved; the chain at rest, solved, swept, and as it should be.

#include "line.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif
#ifndef CHAIN
#define CHAIN "tests/data/chain50.txt"
#endif

static const vec3 GRAVITY = { 0, -9.81, 0 }, ORIGIN = { 0, 0, 0 };

typedef struct {
    shape plan;
    line_scratch *scratch;
    particle *p;
    int n;
} rope;

static void rope_make(rope *r, int links, real length)
{
    *r = (rope){ .n = links + 1 };
    if (shape_rope(&r->plan, links, length, r->n).ok) {
        r->scratch = line_scratch_new(&r->plan);
        r->p = calloc((size_t)r->n, sizeof *r->p);
    }
    if (r->scratch && r->p) return;
    fprintf(stderr, "20-ropes: out of memory\n");
    exit(1);
}

static void rope_free(rope *r)
{
    line_scratch_free(r->scratch);
    free(r->p);
    shape_free(&r->plan);
}

// Straight from the origin, nailed there; particles of 1 kg.
static void rope_lay(rope *r, vec3 down, vec3 acceleration, real dt)
{
    real link = shape_strands(&r->plan, 0).rest_length;
    for (int i = 0; i < r->n; i++)
        r->p[i] = particle_start(vec3_scale(i * link, down), ORIGIN,
                                 acceleration, i > 0, dt);
}

// One way to keep a rope together: substeps of a sixtieth of a second, and in
// each of them steps of Newton's for the line, or sweeps over its links.
typedef struct {
    int substeps, newton, sweeps;
} recipe;

static void substep(rope *r, recipe way)
{
    relax_options o = relax_options_default();
    o.tolerance = 0;
    o.gradient = way.newton > 0 ? GRADIENT_OLD : GRADIENT_NEW;
    verlet_step(r->p, r->n, GRAVITY, NULL, 1.0 / 60 / way.substeps);
    if (way.newton > 0)
        line_solve(shape_strands(&r->plan, 0), r->p, way.newton, o, r->scratch);
    for (int k = 0; k < way.sweeps; k++)
        sticks_iterate(r->plan.stick, r->plan.sticks, r->p, o);
}

static real rope_strain(const rope *r)
{
    real worst = 0;
    for (int i = 0; i < r->plan.sticks; i++)
        worst = fmax(worst, stick_strain(r->plan.stick[i], r->p));
    return worst;
}

// ---- 7: a chain from the horizontal ----------------------------------------

static void print_chain(void)
{
    enum { LINKS = 20, SUBSTEPS = 30, FRAMES = 56 };
    rope q;
    rope_make(&q, LINKS, 1);
    vec3 end[FRAMES * SUBSTEPS + 1];
    rope_lay(&q, vec3_make(1, 0, 0), GRAVITY, 1.0 / 60 / SUBSTEPS);
    printf("\n\n# the chain, every 60th of a second\n# x y t\n");
    for (int n = 0; n <= FRAMES * SUBSTEPS; n++) {
        end[n] = q.p[LINKS].position;
        for (int i = 0; i <= LINKS && n % SUBSTEPS == 0; i++)
            printf("%.5g %.5g %.4g%s\n", q.p[i].position.x, q.p[i].position.y,
                   n / (60.0 * SUBSTEPS), i == LINKS ? "\n" : "");
        substep(&q, (recipe){ SUBSTEPS, 2, 0 });
    }
    printf("\n\n# its end\n# x y t speed\n");
    real h = 1.0 / 60 / SUBSTEPS;
    int fastest = 1;
    for (int n = 1; n <= FRAMES * SUBSTEPS; n++) {
        real speed = vec3_distance(end[n], end[n - 1]) / h;
        printf("%.5g %.5g %.5g %.4g\n", end[n].x, end[n].y, n * h, speed);
        if (speed > vec3_distance(end[fastest], end[fastest - 1]) / h)
            fastest = n;
    }
    printf("\n\n# where its end is fastest\n# x y speed\n%.5g %.5g %.1f\n",
           end[fastest].x, end[fastest].y,
           vec3_distance(end[fastest], end[fastest - 1]) / h);
    rope_free(&q);
}

// ---- 8: a load -------------------------------------------------------------

// The largest strain in the second second of a rope of 50 links that hangs.
static real loaded_strain(real load, recipe way)
{
    rope q;
    real worst = 0;
    rope_make(&q, 50, 1);
    rope_lay(&q, vec3_make(0, -1, 0), ORIGIN, 1.0 / 60 / way.substeps);
    q.p[50].inverse_mass = 1 / load;
    for (int n = 0; n < 120 * way.substeps; n++) {
        substep(&q, way);
        if (n >= 60 * way.substeps) worst = fmax(worst, rope_strain(&q));
    }
    rope_free(&q);
    return worst;
}

static void print_loads(void)
{
    const recipe way[3] = { { 1, 0, 10 }, { 10, 0, 1 }, { 1, 3, 0 } };
    for (int k = 0; k < 3; k++) {
        printf("\n\n# 60 Hz; %d substeps of %d Newton steps, %d sweeps\n"
               "# load strain\n", way[k].substeps, way[k].newton,
               way[k].sweeps);
        for (real load = 1; load < 2e6; load *= sqrt(10))
            printf("%.6g %.4g\n", load, loaded_strain(load, way[k]));
    }
}

// ---- 9: at rest ------------------------------------------------------------

// 2 m between nails 1 m apart, slowed by 5 % a step until it rests.
static void hang(rope *r, recipe way)
{
    const real deep = sqrt(0.75);
    for (int i = 0; i < r->n; i++) {
        real s = (real)i / (r->n - 1);
        vec3 x = { s, -deep * (1 - fabs(2 * s - 1)), 0 };
        r->p[i] = (particle){ x, x, i > 0 && i < r->n - 1 };
    }
    for (int n = 0; n < 6000; n++) {
        substep(r, way);
        for (int i = 0; i < r->n; i++) {
            vec3 move = vec3_sub(r->p[i].position, r->p[i].previous);
            r->p[i].previous = vec3_add_scaled(r->p[i].position, -0.95, move);
        }
    }
}

// The stored chain; returns how many nodes there are.
static int chain_known(vec3 *at, int room)
{
    FILE *file = fopen(CHAIN, "r");
    char line[200];
    int node, read = 0;
    real x, y;
    while (file && read < room && fgets(line, sizeof line, file))
        if (sscanf(line, "%d %lf %lf", &node, &x, &y) == 3 && node == read)
            at[read++] = vec3_make(x, y, 0);
    if (file) fclose(file);
    return read;
}

static void print_rest(void)
{
    const recipe way[2] = { { 4, 4, 0 }, { 4, 0, 10 } };
    vec3 known[51] = { { 0, 0, 0 } };
    int nodes = chain_known(known, 51);
    printf("\n\n# the chain at rest: as it should be\n# x y\n");
    for (int i = 0; i < nodes; i++)
        printf("%.6g %.6g\n", known[i].x, known[i].y);
    for (int k = 0; k < 2; k++) {
        rope q;
        real worst = 0;
        rope_make(&q, 50, 2);
        hang(&q, way[k]);
        printf("\n\n# at rest, 240 Hz; %d Newton steps, %d sweeps\n# x y\n",
               way[k].newton, way[k].sweeps);
        for (int i = 0; i < q.n; i++) {
            vec3 x = q.p[i].position;
            printf("%.6g %.6g\n", x.x, x.y);
            if (i < nodes) worst = fmax(worst, vec3_distance(x, known[i]));
        }
        printf("# off by up to %.2g m\n", worst);
        rope_free(&q);
    }
}

int main(void)
{
    printf("# Hard cases 7, 8 and 9: a chain that whips, a rope with a load, a "
           "chain at rest\n# %s, %s\n", __VERSION__, FLAGS);
    print_chain();
    print_loads();
    print_rest();
    return 0;
}
