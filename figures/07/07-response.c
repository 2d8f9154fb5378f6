// 07-separation.c - two icosahedra overlap by 2 cm: how much of it is left, after
// how much work, by each way of sharing the push; and what the sharing does to
// momentum as one body grows heavier.

#include "body.h"
#include "clock.h"
#include "separation.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { PAIRS = 200, CORNERS = 12, BOTH = 2 * CORNERS, MOST = 64, REPEAT = 25 };
static const real RADIUS = 0.5, DEPTH = 0.02;

// One overlapping pair: the particles of A, then those of B.
typedef struct {
    particle p[BOTH];
    contact  c;
} pair;

static real any(void)
{
    static unsigned long long seed = 1;
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 9007199254740992.0 * 2 - 1;
}

static vec3 any_direction(void)
{
    vec3 v;
    do {
        real x = any(), y = any();
        v = vec3_make(x, y, any());
    } while (vec3_length_squared(v) > 1 || vec3_length_squared(v) < 0.01);
    return vec3_unit(v);
}

// The shape, turned somehow, with its middle at `centre`.
static void put(const shape *s, vec3 centre, vec3 *at)
{
    vec3 x = any_direction();
    vec3 y = vec3_unit(vec3_cross(x, any_direction()));
    vec3 z = vec3_cross(x, y);
    for (int i = 0; i < CORNERS; i++) {
        vec3 v = vec3_add_scaled(centre, s->at[i].x, x);
        v = vec3_add_scaled(v, s->at[i].y, y);
        at[i] = vec3_add_scaled(v, s->at[i].z, z);
    }
}

static penetration_result query(const vec3 *at, penetration_scratch *scratch)
{
    point_set a = { at, CORNERS, NULL, NULL };
    point_set b = { at + CORNERS, CORNERS, NULL, NULL };
    distance_cache carried = { .count = 0 };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    if (r.status != DISTANCE_OVERLAP) return (penetration_result){ .status = PENETRATION_APART };
    return penetration_find(a, b, &r.last, scratch);
}

// Two at random, moved along the normal until they overlap by DEPTH.
static pair make(const shape *s, penetration_scratch *scratch)
{
    vec3 at[BOTH], zero = { 0, 0, 0 };
    penetration_result h;
    do {
        put(s, zero, at);
        put(s, vec3_scale(0.85, any_direction()), at + CORNERS);
        h = query(at, scratch);
        if (h.status != PENETRATION_FOUND) continue;
        for (int i = 0; i < CORNERS; i++)
            at[i] = vec3_add_scaled(at[i], h.depth - DEPTH, h.normal);
        h = query(at, scratch);
    } while (h.status != PENETRATION_FOUND || fabs(h.depth - DEPTH) > 1e-9);

    pair q = { .c = { .a = h.a, .b = h.b, .normal = h.normal,
                      .mass_a = 1, .mass_b = 1 } };
    for (int i = 0; i < q.c.b.count; i++) q.c.b.vertex[i] += CORNERS;
    for (int i = 0; i < BOTH; i++)
        q.p[i] = (particle){ at[i], at[i], CORNERS };
    return q;
}

// passes times: push, sweep the sticks of both; or push once, then sweep.
static void work(pair *q, const shape *s, response_options o, int passes,
                 int once)
{
    relax_options r = relax_options_pbd();
    for (int k = 0; k < passes; k++) {
        if (!once || k == 0) contact_separate(&q->c, q->p, o);
        sticks_iterate(s->stick, s->sticks, q->p, r);
        sticks_iterate(s->stick, s->sticks, q->p + CORNERS, r);
    }
}

// The overlap that is left once the bodies have their shapes again.
static real left(pair *q, const shape *s)
{
    relax_options r = relax_options_pbd();
    r.tolerance = 1e-9;
    sticks_relax(s->stick, s->sticks, q->p, CORNERS, 2000, r, NULL);
    sticks_relax(s->stick, s->sticks, q->p + CORNERS, CORNERS, 2000, r, NULL);
    real gap = contact_gap(&q->c, q->p);
    return gap < 0 ? -gap / DEPTH : 0;
}

static int compare(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

// Returns the time in which less than a hundredth is left, us; HUGE_VAL: never.
static real curve(const char *title, const pair *all, const shape *s,
                  response_options o, int once)
{
    real us[7], median[7];
    int n = 0;
    static pair copy[PAIRS];
    static real rest[PAIRS];
    printf("\n\n# %s\n# passes us_a_pair median worst\n", title);
    for (int passes = 1; passes <= MOST; passes *= 2) {
        real best = 1e9;
        for (int again = 0; again < REPEAT; again++) {
            for (int k = 0; k < PAIRS; k++) copy[k] = all[k];
            real start = clock_seconds();
            for (int k = 0; k < PAIRS; k++)
                work(&copy[k], s, o, passes, once);
            real took = clock_seconds() - start;
            if (took < best) best = took;
        }
        for (int k = 0; k < PAIRS; k++) rest[k] = left(&copy[k], s);
        qsort(rest, PAIRS, sizeof *rest, compare);
        us[n] = best / PAIRS * 1e6;
        median[n++] = rest[PAIRS / 2];
        printf("%d %.4g %.4g %.4g\n", passes, best / PAIRS * 1e6,
               rest[PAIRS / 2], rest[PAIRS - 1]);
    }
    return clock_at_error(us, median, n, 0.01);
}

// |sum m dx| / (mass of the light body * overlap), the median over the pairs,
// and the heavy body's part of the way, B being `ratio` times as heavy.
static void momentum(const pair *all, real ratio, share_rule rule,
                     real *error, real *part)
{
    static real lost[PAIRS], moved[PAIRS];
    response_options o = response_options_default();
    o.share = rule;
    o.friction = 0;
    for (int k = 0; k < PAIRS; k++) {
        pair q = all[k];
        q.c.mass_b = ratio;
        vec3 sum = { 0, 0, 0 };
        for (int i = CORNERS; i < BOTH; i++) q.p[i].inverse_mass /= ratio;
        pair old = q;
        contact_separate(&q.c, q.p, o);
        for (int i = 0; i < BOTH; i++) {
            vec3 dx = vec3_sub(q.p[i].position, old.p[i].position);
            sum = vec3_add_scaled(sum, 1 / q.p[i].inverse_mass, dx);
        }
        vec3 b = vec3_sub(feature_now(q.c.b, q.p), feature_now(q.c.b, old.p));
        lost[k] = vec3_length(sum) / DEPTH;
        moved[k] = vec3_length(b) / DEPTH;
    }
    qsort(lost, PAIRS, sizeof *lost, compare);
    qsort(moved, PAIRS, sizeof *moved, compare);
    *error = lost[PAIRS / 2];
    *part = moved[PAIRS / 2];
}

// ns for one contact_separate that pushes, with friction, and one that finds
// its features apart.
static void time_one(const pair *all)
{
    enum { ROUNDS = 20, AGAIN = 400 };
    static pair copy[PAIRS];
    response_options o = response_options_default();
    real best[2] = { 1e9, 1e9 };
    for (int again = 0; again < AGAIN; again++)
        for (int apart = 0; apart < 2; apart++) {
            for (int k = 0; k < PAIRS; k++) {
                copy[k] = all[k];
                // All slide; the push is made too small to part them.
                for (int i = 0; i < BOTH; i++) {
                    copy[k].p[i].previous.x += 0.1;
                    copy[k].p[i].previous.y += 0.1 * (i < CORNERS);
                }
                copy[k].c.thickness = apart ? -1 : 0;
            }
            o.gain = 1e-9;
            o.friction = 1e-9;
            real start = clock_seconds();
            for (int r = 0; r < ROUNDS; r++)
                for (int k = 0; k < PAIRS; k++)
                    contact_separate(&copy[k].c, copy[k].p, o);
            real took = (clock_seconds() - start) / ((real)ROUNDS * PAIRS);
            if (took < best[apart]) best[apart] = took;
        }
    printf("# contact_separate: %.1f ns with push and friction, %.1f ns "
           "apart\n", best[0] * 1e9, best[1] * 1e9);
}

int main(void)
{
    static pair all[PAIRS];
    shape s;
    penetration_scratch *scratch = penetration_scratch_new();
    if (!scratch || !shape_icosahedron(&s, RADIUS, 1).ok) return 1;
    for (int k = 0; k < PAIRS; k++) all[k] = make(&s, scratch);

    printf("# %d pairs of icosahedra (radius %g m, 1 kg) that overlap by %g m\n"
           "# a pass: one push and a sweep over the 72 sticks; then what is "
           "left of the overlap, sticks straight\n# %s, %s\n", PAIRS, RADIUS,
           DEPTH, __VERSION__, FLAGS);
    time_one(all);

    response_options o = response_options_default();
    o.friction = 0;
    o.share = SHARE_BODY;
    real once = curve("the paper: push once, then sweep", all, &s, o, 1);
    curve("push by bodies, every pass", all, &s, o, 0);
    o.share = SHARE_MASS;
    real mass = curve("push by mass, every pass", all, &s, o, 0);
    o.gain = 2;
    curve("push by mass, gain 2", all, &s, o, 0);
    o.gain = 4;
    real gain = curve("push by mass, gain 4", all, &s, o, 0);
    clock_print_row("response", "icosahedra parted", "1 % left",
                    "interleaved with gain 4", "interleaved", mass / gain);
    clock_print_row("response", "icosahedra parted", "1 % left",
                    "interleaved with gain 4", "pushed once", once / gain);

    printf("\n\n# B heavier: momentum made from nothing (light mass * overlap)"
           "\n# ratio printed body mass  heavy's way: printed body mass\n");
    for (real ratio = 1; ratio < 2e4; ratio *= sqrt(10)) {
        real error[3], part[3];
        momentum(all, ratio, SHARE_PRINTED, &error[0], &part[0]);
        momentum(all, ratio, SHARE_BODY, &error[1], &part[1]);
        momentum(all, ratio, SHARE_MASS, &error[2], &part[2]);
        printf("%.5g %.3g %.3g %.3g  %.4g %.4g %.4g\n", ratio, error[0],
               error[1], error[2], part[0], part[1], part[2]);
    }
    penetration_scratch_free(scratch);
    shape_free(&s);
    return 0;
}
