// 05-bounds.c - the bounds of the depth against iterations and time.
//
// Columns, separated by commas: iterations at most; ns of gjk and hit_face;
// mean relative error of the lower bound (the closest face) and of the upper
// one (how far A - B reaches along its normal); share of pairs that are done, %.
// 5,000 pairs of icosahedra, 10 cm deep; their radius is 0.5 m.

#include "clock.h"
#include "hit_face.h"
#include "random.h"

#include <stdio.h>

enum { PAIRS = 5000, CORNERS = 12, PASSES = 8, MOST = 10 };

hit_result hit_face_find_1(hull a, hull b, const simplex *start);
int hit_face_most;

typedef struct { vec3 at[CORNERS]; } icosahedron;

static struct { icosahedron a, b; real truth; } pair[PAIRS];

static unsigned long long seed = 1;

static icosahedron make_icosahedron(void)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    const real k = 0.5 / sqrt(1 + golden * golden);
    vec3 z = random_direction(&seed), other = random_direction(&seed);
    vec3 x = vec3_unit(vec3_cross(z, other)), y = vec3_cross(z, x);
    icosahedron body;
    int n = 0;
    for (int s = -1; s < 2; s += 2)
        for (int t = -1; t < 2; t += 2) {
            real one = s * k, phi = t * k * golden;
            body.at[n++] = vec3_add_scaled(vec3_scale(one, x), phi, y);
            body.at[n++] = vec3_add_scaled(vec3_scale(one, y), phi, z);
            body.at[n++] = vec3_add_scaled(vec3_scale(one, z), phi, x);
        }
    return body;
}

static hull hull_of(const icosahedron *b) { return (hull){ b->at, CORNERS }; }

static void shift(icosahedron *b, vec3 by)
{
    for (int k = 0; k < CORNERS; k++) b->at[k] = vec3_add(b->at[k], by);
}

// b is brought to a micrometre from a, and then pushed in by 0.1 m.
static void make_pair(icosahedron *a, icosahedron *b)
{
    vec3 way = random_direction(&seed);
    *a = make_icosahedron();
    *b = make_icosahedron();
    shift(b, vec3_scale(1.5, way));
    gjk_result r = gjk_distance(hull_of(a), hull_of(b), HUGE_VAL, NULL);
    for (int k = 0; k < 60 && fabs(r.distance - 1e-6) > 1e-9; k++) {
        real slope = -vec3_dot(r.axis, way) / r.distance;
        shift(b, vec3_scale((1e-6 - r.distance) / slope, way));
        r = gjk_distance(hull_of(a), hull_of(b), HUGE_VAL, NULL);
    }
    shift(b, vec3_scale(0.1 / r.distance, r.axis));
}

static hit_result ask(int k)
{
    hull a = hull_of(&pair[k].a), b = hull_of(&pair[k].b);
    gjk_result g = gjk_distance(a, b, HUGE_VAL, NULL);
    return hit_face_find_1(a, b, &g.last);
}

int main(void)
{
    for (int k = 0; k < PAIRS; k++) {
        make_pair(&pair[k].a, &pair[k].b);
        hit_face_most = 100;
        pair[k].truth = ask(k).depth;
    }
    printf("iterations at most,ns,lower bound is below by,"
           "upper bound is above by,pairs done %%\n");
    for (hit_face_most = 1; hit_face_most <= MOST; hit_face_most++) {
        real best = HUGE_VAL, low = 0, high = 0;
        int done = 0;
        for (int pass = 0; pass < PASSES; pass++) {
            double start = clock_seconds();
            real sum = 0;
            for (int k = 0; k < PAIRS; k++) sum += ask(k).depth;
            real ns = 1e9 * (clock_seconds() - start) / PAIRS;
            if (sum > 0) best = real_min(best, ns);
        }
        for (int k = 0; k < PAIRS; k++) {
            hit_result r = ask(k);
            hull a = hull_of(&pair[k].a), b = hull_of(&pair[k].b);
            vec3 n = vec3_scale(-1, r.normal);
            corner w = hull_support(a, b, n);
            real truth = pair[k].truth;
            low += fabs(truth - r.depth) / truth / PAIRS;
            high += fabs(vec3_dot(n, w.at) - truth) / truth / PAIRS;
            done += r.status == HIT_FOUND;
        }
        printf("%d,%.0f,%.1e,%.1e,%.1f\n", hit_face_most, best, low, high,
               100.0 * done / PAIRS);
    }
    return 0;
}
