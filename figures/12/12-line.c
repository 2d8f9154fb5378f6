// 12-line.c - a rope of 50 links hangs, with 1, 100 and 10,000 times the mass
// of a particle at its end: how far it stretches, against the cost, for sweeps,
// small steps and lines solved directly.  And what a taut rope does when it is
// touched: how much a zigzag has grown after 200 steps.  In the head: how long
// one link takes, in a cloth and in a rope.

#include "clock.h"
#include "line.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { LINKS = 50, FRAMES = 300, LAST = 60, REPEAT = 30, CLOTH = 40 };
static const vec3 GRAVITY = { 0, -9.81, 0 };

static _Noreturn void give_up(void)
{
    fprintf(stderr, "12-line: out of memory\n");
    exit(1);
}

static relax_options along(gradient_kind gradient)
{
    relax_options o = relax_options_default();
    o.gradient = gradient;
    o.tolerance = 0;
    return o;
}

// A rope 1 m long, nailed at its upper end; every particle but the last has
// 1 kg.
typedef struct {
    shape plan;
    line_scratch *scratch;
    particle p[LINKS + 1];
} rope;

static void rope_hang(rope *r, real end_mass)
{
    if (!shape_rope(&r->plan, LINKS, 1, 1).ok) give_up();
    r->scratch = line_scratch_new(&r->plan);
    if (!r->scratch) give_up();
    for (int i = 0; i <= LINKS; i++) {
        vec3 x = { 0, -(real)i / LINKS, 0 };
        r->p[i] = (particle){ x, x, i > 0 };
    }
    r->p[LINKS].inverse_mass = 1 / end_mass;
}

static void rope_free(rope *r)
{
    line_scratch_free(r->scratch);
    shape_free(&r->plan);
}

// One way to keep a rope together, for one frame.
typedef struct {
    int substeps, sweeps, steps;    // sweeps, or steps of the line solve
} recipe;

static void frame(rope *r, recipe way)
{
    real h = 1.0 / 60 / way.substeps;
    relax_options o = along(GRADIENT_NEW);
    for (int k = 0; k < way.substeps; k++) {
        verlet_step(r->p, LINKS + 1, GRAVITY, NULL, h);
        for (int i = 0; i < way.sweeps; i++)
            sticks_iterate(r->plan.stick, LINKS, r->p, o);
        if (way.steps > 0)
            line_solve(shape_strands(&r->plan, 0), r->p, way.steps, o, r->scratch);
    }
}

// The largest strain of the last second, and the time of the fastest frame: the
// others were interrupted.
typedef struct {
    real strain;
    double seconds;
} outcome;

static outcome run(real end_mass, recipe way)
{
    rope r;
    outcome out = { 0, 1e9 };
    rope_hang(&r, end_mass);
    for (int f = 0; f < FRAMES; f++) {
        double begin = clock_seconds();
        frame(&r, way);
        out.seconds = fmin(out.seconds, clock_seconds() - begin);
        for (int k = 0; k < LINKS && f >= FRAMES - LAST; k++)
            out.strain = fmax(out.strain,
                              stick_strain(r.plan.stick[k], r.p));
    }
    rope_free(&r);
    return out;
}

static void print_row(int n, outcome o, double unit)
{
    printf("%d %.4g %.4g\n", n, o.seconds / unit, o.strain);
}

static void print_load(real load, double unit)
{
    printf("\n\n# load %g: n sweeps of one step a frame\n"
           "# n cost strain\n", load);
    for (int n = 1; n <= 1024; n *= 2)
        print_row(n, run(load, (recipe){ 1, n, 0 }), unit);
    printf("\n\n# load %g: n substeps of one sweep\n# n cost strain\n", load);
    for (int n = 1; n <= 1024; n *= 2)
        print_row(n, run(load, (recipe){ n, 1, 0 }), unit);
    printf("\n\n# load %g: the line solved, n steps of Newton a frame\n"
           "# n cost strain\n", load);
    for (int n = 1; n <= 4; n++)
        print_row(n, run(load, (recipe){ 1, 0, n }), unit);
}

// How much a zigzag of 1e-12 m to either side has grown after 200 steps of
// sqrt(share m L / T) seconds, T the pull (N) of the load.
static real growth(real share, gradient_kind gradient)
{
    const real load = 10000, start = 1e-12;
    real h = sqrt(share / (load * 9.81 * LINKS)), most = 0;
    rope r;
    rope_hang(&r, load);
    for (int i = 1; i < LINKS; i++)
        r.p[i].position.x = r.p[i].previous.x = i % 2 ? start : -start;
    for (int k = 0; k < 200; k++) {
        verlet_step(r.p, LINKS + 1, GRAVITY, NULL, h);
        line_solve(shape_strands(&r.plan, 0), r.p, 2, along(gradient), r.scratch);
    }
    for (int i = 1; i <= LINKS; i++) most = fmax(most, fabs(r.p[i].position.x));
    rope_free(&r);
    return most / start;
}

static void print_string(void)
{
    for (int old = 0; old < 2; old++) {
        printf("\n\n# a zigzag after 200 steps, %s gradient\n"
               "# T_h^2/(m_L) growth\n", old ? "old" : "new");
        for (real share = 0.02; share < 1.5; share *= 1.06)
            printf("%.4g %.4g\n", share,
                   growth(share, old ? GRADIENT_OLD : GRADIENT_NEW));
    }
}

// Time (s) of one link of p's columns and rows, of a substep of three rounds
// (a rope has one): swept; solved; solved, and the particles fetched and
// brought back for each direction of each round.
typedef enum { SWEPT, SOLVED, FETCHED } link_way;

static double time_links(const shape *s, particle *p, link_way how,
                         relax_options o, line_scratch *scratch)
{
    double best = 1e9;
    const int rounds = shape_directions(s) > 1 ? 3 : 1;
    const int turns = 2000000 / REPEAT / rounds / shape_links(s) + 1;
    for (int k = 0; k < REPEAT; k++) {
        double begin = clock_seconds();
        for (int i = 0; i < turns; i++) {
            for (int r = 0; r < rounds && how == SWEPT; r++)
                sticks_iterate(s->stick, shape_links(s), p, o);
            for (int r = 0; r < rounds && how == FETCHED; r++)
                for (int d = 0; d < shape_directions(s); d++)
                    line_solve(shape_strands(s, d), p, 1, o, scratch);
            if (how == SOLVED) lines_relax(s, p, 1, rounds, o, NULL, 0, scratch);
        }
        best = fmin(best, clock_seconds() - begin);
    }
    return best / turns / rounds / shape_links(s);
}

static void print_times(const char *name, shape s)
{
    particle *p = malloc((size_t)s.particles * sizeof *p);
    line_scratch *scratch = line_scratch_new(&s);
    if (!p || !scratch) give_up();
    for (int i = 0; i < s.particles; i++) {
        p[i] = (particle){ s.at[i], s.at[i], 1 / s.mass[i] };
        p[i].position.y += 1e-4 * (i % 7);
    }
    printf("# ns a link, %s:", name);
    const struct { const char *name; link_way how; gradient_kind along; } way[6] = {
        { "swept, exact root", SWEPT, GRADIENT_NEW },
        { "approximate root", SWEPT, GRADIENT_NEW },
        { "old gradient", SWEPT, GRADIENT_OLD },
        { "line, new gradient", SOLVED, GRADIENT_NEW },
        { "fetched each time", FETCHED, GRADIENT_NEW },
        { "line, old gradient", SOLVED, GRADIENT_OLD },
    };
    for (int k = 0; k < 6; k++) {
        relax_options o = along(way[k].along);
        if (k == 1) o.root = ROOT_APPROXIMATE;
        printf(" %s %.1f%s", way[k].name,
               1e9 * time_links(&s, p, way[k].how, o, scratch),
               k < 5 ? "," : "\n");
    }
    line_scratch_free(scratch);
    free(p);
    shape_free(&s);
}

int main(void)
{
    shape cloth, line;
    if (!shape_cloth(&cloth, CLOTH, CLOTH, 2, 2, 1, 0.2).ok
        || !shape_rope(&line, LINKS, 1, 1).ok) give_up();
    printf("# A rope of 50 links hangs, 60 frames a second, 5 s: strain, cost; "
           "a taut rope\n# %s, %s\n", __VERSION__, FLAGS);
    double unit = run(1, (recipe){ 1, 10, 0 }).seconds;
    printf("# cost 1 = a frame of 10 sweeps with the exact root = %.2f us\n",
           unit * 1e6);
    print_times("cloth of 40 x 40", cloth);
    print_times("rope of 50", line);
    for (real load = 1; load < 1e5; load *= 100) print_load(load, unit);
    print_string();
    return 0;
}
