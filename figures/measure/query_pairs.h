// query_pairs.h - many distinct pairs of icosahedra at a chosen gap, and a clock;
// for the figures of chapters 10 and 21.
//
// 20,000 pairs, because a loop over few pairs teaches the branch predictor the
// answers.  The second of a pair is moved by up to 0.5 degree and 2.5 mm.

#ifndef FIGURE_PAIRS_H
#define FIGURE_PAIRS_H

#include "clock.h"
#include "gjk.h"
#include "random.h"

#include <stddef.h>

enum { PAIRS = 20000, BLOCK = 500, CORNERS = 12 };

typedef struct { vec3 at[CORNERS]; } icosahedron;
typedef struct { icosahedron a, b, moved_a, moved_b; } pair_at_gap;

static unsigned long long seed = 1;

// Turned by `angle` about a unit axis (Rodrigues).
static vec3 turned(vec3 p, vec3 axis, real angle)
{
    real c = cos(angle), s = sin(angle), along = (1 - c) * vec3_dot(axis, p);
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(c, p), s,
                                           vec3_cross(axis, p)), along, axis);
}

static icosahedron icosahedron_turned(vec3 axis, real angle)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    const real k = 0.5 / sqrt(1 + golden * golden);
    icosahedron body;
    int n = 0;
    for (int s = -1; s < 2; s += 2)
        for (int t = -1; t < 2; t += 2) {
            real one = k * s, phi = k * t * golden;
            body.at[n++] = turned((vec3){ 0, one, phi }, axis, angle);
            body.at[n++] = turned((vec3){ one, phi, 0 }, axis, angle);
            body.at[n++] = turned((vec3){ phi, 0, one }, axis, angle);
        }
    return body;
}

static hull hull_of(const icosahedron *body)
{
    return (hull){ body->at, CORNERS };
}

static void shift(icosahedron *body, vec3 by)
{
    for (int i = 0; i < CORNERS; i++) body->at[i] = vec3_add(body->at[i], by);
}

static gjk_result ask_pair(const icosahedron *a, const icosahedron *b)
{
    return gjk_distance(hull_of(a), hull_of(b), HUGE_VAL, NULL);
}

static icosahedron nudged(const icosahedron *body)
{
    const real degree = 3.14159265358979 / 180;
    vec3 axis = random_direction(&seed), centre = { 0, 0, 0 };
    real angle = 0.5 * degree * random_fraction(&seed);
    vec3 by =
        vec3_scale(0.0025 * random_fraction(&seed), random_direction(&seed));
    icosahedron out;
    for (int i = 0; i < CORNERS; i++)
        centre = vec3_add_scaled(centre, 1.0 / CORNERS, body->at[i]);
    for (int i = 0; i < CORNERS; i++) {
        vec3 r = turned(vec3_sub(body->at[i], centre), axis, angle);
        out.at[i] = vec3_add(vec3_add(centre, by), r);
    }
    return out;
}

static void nudge(pair_at_gap *pair)
{
    pair->moved_a = nudged(&pair->a);
    pair->moved_b = nudged(&pair->b);
}

// Pairs at this distance (m); a negative one: brought to a gap of a micrometre,
// and then pushed in by so much along the axis.
static inline void make_pairs(pair_at_gap *pair, int n, real gap)
{
    real wanted = gap > 1e-6 ? gap : 1e-6;
    for (int i = 0; i < n; i++) {
        vec3 axis = random_direction(&seed), way = random_direction(&seed);
        pair[i].a =
            icosahedron_turned(axis, 6.28318530718 * random_fraction(&seed));
        axis = random_direction(&seed);
        pair[i].b =
            icosahedron_turned(axis, 6.28318530718 * random_fraction(&seed));
        shift(&pair[i].b, vec3_scale(1.5, way));
        gjk_result r = ask_pair(&pair[i].a, &pair[i].b);
        for (int tries = 0; tries < 60; tries++) {
            if (fabs(r.distance - wanted) < 1e-9) break;
            // Newton towards A's middle: the distance falls, convex, along it.
            real slope = -vec3_dot(r.axis, way) / r.distance;
            shift(&pair[i].b, vec3_scale((wanted - r.distance) / slope, way));
            r = ask_pair(&pair[i].a, &pair[i].b);
        }
        if (gap < 0)
            shift(&pair[i].b, vec3_scale(-gap / r.distance, r.axis));
        nudge(&pair[i]);
    }
}

static inline double now(void)                 // ns
{
    return 1e9 * clock_seconds();
}

// Nanoseconds of one query: every block of pairs at its quickest pass.
typedef struct { double best[PAIRS / BLOCK]; } stopwatch;

static inline void stopwatch_reset(stopwatch *w)
{
    for (int k = 0; k < PAIRS / BLOCK; k++) w->best[k] = HUGE_VAL;
}

static inline void stopwatch_note(stopwatch *w, int block, double ns)
{
    if (ns < w->best[block]) w->best[block] = ns;
}

static inline double stopwatch_mean(const stopwatch *w)
{
    double sum = 0;
    for (int k = 0; k < PAIRS / BLOCK; k++) sum += w->best[k];
    return sum / PAIRS;
}

#ifndef FLAGS
#define FLAGS "unknown"
#endif

#endif
