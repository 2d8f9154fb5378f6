// 07-response.c - a vertex of one icosahedron stands 2 cm deep in a face of
// another: how much of the overlap is left, after how many pushes, by each way
// of sharing; what the sharing does to momentum as one body grows heavier; and
// how fast an overlap that is pushed apart flies off.

#include "body.h"
#include "clock.h"
#include "random.h"
#include "response.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { PAIRS = 200, CORNERS = 12, BOTH = 2 * CORNERS, MOST = 64, REPEAT = 25 };
static const real RADIUS = 0.5, DEPTH = 0.02;   // m

typedef enum { PRINTED, BY_BODIES, BY_PARTICLES, WAYS } way;

// One overlapping pair: the particles of A, then those of B.
typedef struct {
    particle p[BOTH];
    feature_contact c;
} pair;

static void part(way how, const feature_contact *c, particle *p)
{
    response_errata errata = { .masses_exchanged = how == PRINTED };
    if (how == BY_PARTICLES) response_separate(c, p, 0);
    else                     response_printed(c, p, errata);
}

static unsigned long long seed = 1;

// The shape, turned somehow.
static void turn(const shape *s, particle *p)
{
    vec3 x = random_direction(&seed);
    vec3 y = vec3_unit(vec3_cross(x, random_direction(&seed)));
    vec3 z = vec3_cross(x, y);
    for (int i = 0; i < CORNERS; i++) {
        vec3 v = vec3_scale(s->at[i].x, x);
        v = vec3_add_scaled(v, s->at[i].y, y);
        v = vec3_add_scaled(v, s->at[i].z, z);
        p[i] = (particle){ v, v, CORNERS };
    }
}

// A point of face f of B, somewhere inside it.
static feature_point any_point(const shape *s, int f)
{
    real u = 0.1 + 0.7 * random_fraction(&seed),
         v = (0.9 - u) * random_fraction(&seed) + 0.05;
    const int *corner = &s->face[3 * f];
    return (feature_point){ 3, { CORNERS + corner[0], CORNERS + corner[1],
                                 CORNERS + corner[2] }, { u, v, 1 - u - v } };
}

// A's lowest vertex below a face of B, by DEPTH.
static pair make(const shape *s)
{
    pair q = { .c = { .mass_a = 1, .mass_b = 1 } };
    particle *b = q.p + CORNERS;
    turn(s, q.p);
    turn(s, b);
    int f = (int)(random_fraction(&seed) * s->mesh.faces), low = 0;
    const int *corner = &s->face[3 * f];
    vec3 first = b[corner[0]].position;
    vec3 normal = vec3_cross(vec3_sub(b[corner[1]].position, first),
                             vec3_sub(b[corner[2]].position, first));
    normal = vec3_unit(normal);
    for (int i = 1; i < CORNERS; i++)
        if (vec3_dot(q.p[i].position, normal) < vec3_dot(q.p[low].position,
                                                         normal)) low = i;
    q.c.a = (feature_point){ 1, { low }, { 1 } };
    q.c.b = any_point(s, f);
    q.c.normal = normal;
    vec3 by = vec3_sub(vec3_add_scaled(feature_position(&q.c.b, q.p), -DEPTH,
                                       normal), q.p[low].position);
    for (int i = 0; i < CORNERS; i++)
        q.p[i].position = vec3_add(q.p[i].position, by);
    for (int i = 0; i < BOTH; i++) q.p[i].previous = q.p[i].position;
    return q;
}

// So many iterations over the sticks of both, with a push before each of them,
// or before the first alone.
static void work(pair *q, const shape *s, way how, int iterations, bool once)
{
    relax_options r = relax_options_pbd();
    for (int k = 0; k < iterations; k++) {
        if (!once || k == 0) part(how, &q->c, q->p);
        sticks_iterate(s->stick, s->sticks, q->p, r);
        sticks_iterate(s->stick, s->sticks, q->p + CORNERS, r);
    }
}

// The overlap that is left once the bodies have their shapes again.
static real left(pair *q, const shape *s)
{
    relax_options r = relax_options_pbd();
    r.tolerance = 1e-9;
    sticks_relax(s->stick, s->sticks, q->p, 2000, r);
    sticks_relax(s->stick, s->sticks, q->p + CORNERS, 2000, r);
    return real_max(contact_depth(&q->c, q->p), 0) / DEPTH;
}

// Returns the time in which less than a hundredth is left, us; HUGE_VAL: never.
static real curve(const char *title, const pair *all, const shape *s, way how,
                  bool once)
{
    real us[7], median[7];
    int n = 0;
    static pair copy[PAIRS];
    static real rest[PAIRS];
    printf("\n\n# %s\n# iterations us_a_pair median worst\n", title);
    for (int iterations = 1; iterations <= MOST; iterations *= 2) {
        real best = 1e9;
        for (int again = 0; again < REPEAT; again++) {
            for (int k = 0; k < PAIRS; k++) copy[k] = all[k];
            real start = clock_seconds();
            for (int k = 0; k < PAIRS; k++)
                work(&copy[k], s, how, iterations, once);
            best = real_min(clock_seconds() - start, best);
        }
        for (int k = 0; k < PAIRS; k++) rest[k] = left(&copy[k], s);
        us[n] = best / PAIRS * 1e6;
        median[n] = clock_median(rest, PAIRS);
        printf("%d %.4g %.4g %.4g\n", iterations, us[n], median[n],
               rest[PAIRS - 1]);
        n++;
    }
    return clock_at_error(us, median, n, 0.01);
}

// |sum m dx| / (mass of the light body * overlap), the median over the pairs,
// B being `ratio` times as heavy.
static real momentum(const pair *all, real ratio, way how)
{
    static real made[PAIRS];
    for (int k = 0; k < PAIRS; k++) {
        pair q = all[k];
        q.c.mass_b = ratio;
        for (int i = CORNERS; i < BOTH; i++) q.p[i].inverse_mass /= ratio;
        pair old = q;
        part(how, &q.c, q.p);
        vec3 sum = { 0, 0, 0 };
        for (int i = 0; i < BOTH; i++) {
            vec3 dx = vec3_sub(q.p[i].position, old.p[i].position);
            sum = vec3_add_scaled(sum, 1 / q.p[i].inverse_mass, dx);
        }
        made[k] = vec3_length(sum) / DEPTH;
    }
    return clock_median(made, PAIRS);
}

// ns for one response_separate with friction, of features that overlap, and of
// features that are apart.
static void time_one(const pair *all)
{
    enum { ROUNDS = 20, AGAIN = 200 };
    static pair copy[PAIRS];
    real best[2] = { 1e9, 1e9 };
    for (int again = 0; again < AGAIN; again++)
        for (int apart = 0; apart < 2; apart++) {
            real took = 0;
            for (int r = 0; r < ROUNDS; r++) {
                for (int k = 0; k < PAIRS; k++) {
                    copy[k] = all[k];
                    copy[k].c.apart = apart ? -1 : 0;
                    for (int i = 0; i < CORNERS; i++)
                        copy[k].p[i].previous.x += 0.1;
                }
                real start = clock_seconds();
                for (int k = 0; k < PAIRS; k++)
                    response_separate(&copy[k].c, copy[k].p, 0.5);
                took += clock_seconds() - start;
            }
            best[apart] = real_min(took / ((real)ROUNDS * PAIRS), best[apart]);
        }
    printf("# response_separate: %.0f ns with friction, %.0f ns where nothing "
           "overlaps\n", best[0] * 1e9, best[1] * 1e9);
}

// A particle that lies at rest DEPTH deep in a floor, pushed out in one step:
// its speed after, and the height to which that carries it.
static void fly_off(void)
{
    printf("\n\n# steps in 1/60 s, speed after the push in m/s, height in m\n");
    for (int steps = 1; steps <= 8; steps *= 2) {
        real dt = 1.0 / 60 / steps;
        particle p = { { 0, -DEPTH, 0 }, { 0, -DEPTH, 0 }, 1 };
        feature_contact c = { .a = { 1, { 0 }, { 1 } }, .normal = { 0, 1, 0 } };
        response_separate(&c, &p, 0);
        real speed = (p.position.y - p.previous.y) / dt;
        printf("%d %.4g %.3g\n", steps, speed, speed * speed / (2 * 9.81));
    }
}

int main(void)
{
    static pair all[PAIRS];
    shape s;
    if (!shape_icosahedron(&s, RADIUS, 1).ok) return 1;
    for (int k = 0; k < PAIRS; k++) all[k] = make(&s);

    printf("# %d pairs of icosahedra (radius %g m, 1 kg): a vertex of one is "
           "%g m deep\n# in a face of the other.  An iteration: one push (or "
           "none), then once over\n# the 72 sticks; then what is left of the "
           "overlap, sticks straight\n# %s, %s\n", PAIRS, RADIUS, DEPTH,
           __VERSION__, FLAGS);
    time_one(all);

    real once = curve("push once, then iterate", all, &s, BY_PARTICLES, true);
    curve("Eq. 10 mended, in turns", all, &s, BY_BODIES, false);
    real turns = curve("the least move, in turns", all, &s, BY_PARTICLES,
                       false);
    clock_print_row("response", "icosahedra parted", "1 % left",
                    "pushed in turns", "pushed once", once / turns);

    printf("\n\n# B heavier: momentum made from nothing (light mass * overlap)"
           "\n# ratio, Eq. 10 printed, Eq. 10 mended, least move\n");
    for (real ratio = 1; ratio < 2e4; ratio *= sqrt(10))
        printf("%.5g %.3g %.3g %.3g\n", ratio, momentum(all, ratio, PRINTED),
               momentum(all, ratio, BY_BODIES),
               momentum(all, ratio, BY_PARTICLES));
    fly_off();
    shape_free(&s);
    return 0;
}
