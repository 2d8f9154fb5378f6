// check_penetration.c - tests of lib/query/penetration: depth, normal, points, features.

#include "bodies.h"
#include "hit_face.h"
#include "penetration.h"
#include "oracle.h"
#include "points.h"
#include "scarce.h"

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef PAIRS
#define PAIRS "tests/data/pairs.txt"
#endif

// The grid is 2^-50 of the reach of A - B; a dozen roundings beside it.
static const real rounding = 1e-14;
// The same where the reference, too, is rounded (long double may be double).
static const real reference = 1e-13;

static penetration_scratch *scratch;

static void setup(void) { scratch = penetration_scratch_new(); }
static void teardown(void) { penetration_scratch_free(scratch); }

static penetration_result hit(const body *a, const body *b)
{
    point_set pa = body_points(a), pb = body_points(b);
    distance_result g = distance_find(pa, pb, distance_options_default(), NULL);
    return penetration_find(pa, pb, &g.last, scratch);
}

static void near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void same_bits(real got, real wanted)
{
    ck_assert_msg(memcmp(&got, &wanted, sizeof got) == 0,
                  "got %.17g, wanted %.17g", got, wanted);
}

static vec3 sum_of(const body *b, const feature_point *f)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < f->count; k++)
        sum = vec3_add_scaled(sum, f->weight[k], b->at[f->vertex[k]]);
    return sum;
}

static void check_feature(const body *b, const feature_point *f, vec3 on,
                          real tolerance)
{
    real sum = 0;
    ck_assert_msg(f->count >= 1 && f->count <= 3, "a feature has %d vertices, "
                  "wanted 1 to 3", f->count);
    for (int k = 0; k < f->count; k++) {
        ck_assert(f->weight[k] >= 0);
        for (int l = 0; l < k; l++)
            ck_assert_msg(vec3_distance(b->at[f->vertex[k]],
                                        b->at[f->vertex[l]]) > 0,
                          "two vertices of a feature are at one place, and are "
                          "not merged");
        sum += f->weight[k];
    }
    ck_assert_msg(fabs(sum - 1) <= rounding, "the weights of a feature of %d "
                  "add up to %.17g, wanted 1", f->count, sum);
    real off = vec3_distance(sum_of(b, f), on);
    ck_assert_msg(off <= tolerance, "a feature's point is %g m from where its "
                  "weights put it", off);
}

// Everything that must hold of an answer, without a reference: the normal is a
// unit vector, the points differ by depth along it, and the width of A - B
// along it is the depth.  size: m, of the coordinates.
static void check_answer(const body *a, const body *b, penetration_result r, real size)
{
    vec3 gap = vec3_sub(r.on_b, r.on_a);
    near(vec3_length(r.normal), 1, rounding);
    ck_assert(r.depth >= 0);
    real off = vec3_distance(gap, vec3_scale(r.depth, r.normal));
    ck_assert_msg(off <= rounding * size, "on_b - on_a is to be depth times "
                  "normal, and is off by %g m", off);
    check_feature(a, &r.a, r.on_a, rounding * size);
    check_feature(b, &r.b, r.on_b, rounding * size);
    if (r.status == PENETRATION_FOUND)
        near((real)oracle_width(body_hull(a), body_hull(b),
                                vec3_scale(-1, r.normal)), r.depth,
             rounding * size);
}

// ---- answers that can be had by hand

// Rejects: a normal from A to B, a depth along the wrong axis.
START_TEST(a_cube_pushed_in_comes_out_the_short_way)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.75, 0.125, -0.25);
    penetration_result r = hit(&a, &b);
    ck_assert_int_eq(r.status, PENETRATION_FOUND);
    same_bits(r.depth, 0.25);
    same_bits(r.normal.x, -1);
    check_answer(&a, &b, r, 1);
}
END_TEST

START_TEST(moved_by_the_depth_they_only_touch)
{
    unsigned long long seed = 1;
    for (int n = 0; n < 300; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_icosahedron(&b, 0.7);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0, 0.8));
        penetration_result r = hit(&a, &b);
        if (r.status != PENETRATION_FOUND) continue;
        body out = a, not_quite = a;
        body_move(&out, vec3_scale(1.001 * r.depth, r.normal));
        body_move(&not_quite, vec3_scale(0.999 * r.depth, r.normal));
        distance_options o = distance_options_default();
        point_set pb = body_points(&b);
        ck_assert_int_eq(distance_find(body_points(&out), pb, o, NULL).status,
                         DISTANCE_APART);
        ck_assert_int_eq(distance_find(body_points(&not_quite), pb, o,
                                      NULL).status, DISTANCE_OVERLAP);
    }
}
END_TEST

START_TEST(touching_is_depth_zero_with_a_proper_normal)
{
    body a = body_cube(0, 0, 0), f = body_cube(1, 0.25, 0.125),
         e = body_cube(1, 1, 0.25);
    body v = body_cube(-1, 1, 1);
    penetration_result r = hit(&a, &f);
    ck_assert_int_eq(r.status, PENETRATION_FOUND);
    same_bits(r.depth, 0);
    same_bits(r.normal.x, -1);
    const body *others[3] = { &f, &e, &v };
    for (int k = 0; k < 3; k++) {
        r = hit(&a, others[k]);
        ck_assert_int_eq(r.status, PENETRATION_FOUND);
        same_bits(r.depth, 0);
        check_answer(&a, others[k], r, 1);
    }
}
END_TEST

// Rejects: an expansion that a flat side or a tie leads astray.
START_TEST(identical_and_concentric_cubes)
{
    body a = body_cube(0, 0, 0), small = a, turned = a;
    unsigned long long seed = 9;
    same_bits(hit(&a, &a).depth, 1);
    body_scale(&small, 0.25);
    same_bits(hit(&a, &small).depth, 0.625);
    same_bits(hit(&small, &a).depth, 0.625);
    for (int n = 0; n < 50; n++) {
        body_turn(&turned, &seed);
        penetration_result r = hit(&a, &turned);
        near(r.depth, (real)oracle_depth(body_hull(&a),
                                         body_hull(&turned)), reference);
        check_answer(&a, &turned, r, 1);
    }
}
END_TEST

START_TEST(stacked_cubes_at_every_depth)
{
    for (int k = 0; k <= 50; k++) {
        real depth = k == 0 ? 0 : 1 / (real)(1ULL << k);
        body a = body_cube(0, 0, 0), b = body_cube(0, 1 - depth, 0);
        penetration_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, PENETRATION_FOUND);
        near(r.depth, depth, 2e-15);
        near(r.normal.y, -1, 1e-15);
        check_answer(&a, &b, r, 1);
    }
}
END_TEST

START_TEST(a_vertex_a_face_and_two_edges_are_named)
{
    body floor, tipped, up = body_cube(0, 0, 0), down;
    body_box(&floor, (vec3){ -2, -2, -1 }, (vec3){ 2, 2, 0 });
    tipped = up;
    // A cube on its corner: its diagonal along z, the lowest vertex 0.1 deep.
    vec3 z = vec3_unit((vec3){ 1, 1, 1 }), x = vec3_unit((vec3){ 1, -1, 0 });
    vec3 y = vec3_cross(z, x);
    for (int i = 0; i < 8; i++) {
        vec3 p = tipped.at[i];
        tipped.at[i] = (vec3){ vec3_dot(x, p), vec3_dot(y, p),
                               vec3_dot(z, p) + sqrt(0.75) - 0.1 };
    }
    penetration_result r = hit(&tipped, &floor);
    ck_assert_int_eq(r.kind, TOUCH_VERTEX_FACE);
    ck_assert_int_eq(r.a.count, 1);
    ck_assert_int_eq(r.a.vertex[0], 0);
    near(r.depth, 0.1, rounding);
    near(r.normal.z, 1, rounding);
    r = hit(&floor, &tipped);
    ck_assert_int_eq(r.kind, TOUCH_FACE_VERTEX);
    ck_assert_int_eq(r.b.count, 1);
    near(r.normal.z, -1, rounding);

    // Two square prisms, edges down and up, crossing at a right angle.
    for (int i = 0; i < 8; i++) {
        vec3 p = up.at[i];
        down.at[i] = (vec3){ (p.x - p.z) / 2, 2 * p.y, (p.x + p.z) / 2 };
        up.at[i] = (vec3){ 2 * p.y, (p.x - p.z) / 2, (p.x + p.z) / 2 - 0.875 };
    }
    down.count = 8;
    down.has_ring = 0;
    r = hit(&down, &up);
    ck_assert_int_eq(r.kind, TOUCH_EDGE_EDGE);
    near(r.depth, 0.125, rounding);
    near(r.normal.z, 1, rounding);
    near(r.on_a.x, 0, rounding);
    near(r.on_b.y, 0, rounding);
}
END_TEST

// ---- against every direction

START_TEST(random_pairs_agree_with_every_direction)
{
    unsigned long long seed = 2005;
    int found = 0;
    for (int n = 0; n < 1200; n++) {
        body a, b;
        body_any(&a, n % 4, &seed);
        body_any(&b, n / 4 % 4, &seed);
        if (a.count * b.count > 100) continue;      // the oracle is slow
        body_move(&b, random_vector(&seed, 0, 0.9));
        penetration_result r = hit(&a, &b);
        real truth = (real)oracle_depth(body_hull(&a), body_hull(&b));
        ck_assert_int_eq(r.status, truth > 0 ? PENETRATION_FOUND : PENETRATION_APART);
        if (r.status != PENETRATION_FOUND) continue;
        found++;
        near(r.depth, truth, reference);
        check_answer(&a, &b, r, 1);
    }
    ck_assert_int_ge(found, 500);
}
END_TEST

// Boxes and hulls beside their own copies, turned alike: every side of one is
// parallel to a side of the other, but for rounding, and most sides of A - B
// are cut in many triangles.  Rejects: signs that rounding decides.
START_TEST(equal_bodies_side_by_side)
{
    unsigned long long seed = 51;
    for (int n = 0; n < 600; n++) {
        body a, b;
        body_any(&a, n % 3 == 1 ? 2 : n % 3, &seed);
        if (n % 3 == 2)
            body_scale(&a, 1e-3 + random_unit(&seed));
        b = a;
        if (n % 2) body_scale(&b, 1 + 1e-15 * (n % 7));
        body_move(&b, random_vector(&seed, 0, n % 5 ? 0.3 : 1e-12));
        penetration_result r = hit(&a, &b);
        real truth = (real)oracle_depth(body_hull(&a), body_hull(&b));
        if (truth <= 0) continue;
        ck_assert_int_eq(r.status, PENETRATION_FOUND);
        near(r.depth, truth, reference);
        check_answer(&a, &b, r, 1);
    }
}
END_TEST

// Prisms of 40 sides, one on the other: rims of 40 corners in one plane.
START_TEST(prisms_stand_on_prisms)
{
    unsigned long long seed = 52;
    for (int n = 0; n < 200; n++) {
        body a = { .count = 80 }, b;
        real depth = 1 / (real)(1ULL << (n % 48));
        for (int i = 0; i < 80; i++) {
            real turn = (i / 2) * 0.15707963267948966;
            a.at[i] = (vec3){ 2 * cos(turn), 2 * sin(turn), i % 2 - 0.5 };
        }
        b = a;
        body_move(&b, (vec3){ 0.1 * (n % 10), 0.2, -1 + depth });
        unsigned long long same = seed;
        body_turn(&a, &seed);
        body_turn(&b, &same);
        penetration_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, PENETRATION_FOUND);
        // Heights that differ by four steps of the grid are the same: 2.8e-14 m
        // of an A - B that reaches to 8 m.
        near(r.depth, depth, 6 * rounding);
        check_answer(&a, &b, r, 6);
    }
}
END_TEST

// Rejects: a start that needs the origin inside its tetrahedron, or four
// corners, or the final simplex of gjk.
START_TEST(any_start_will_do)
{
    unsigned long long seed = 21;
    for (int n = 0; n < 600; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0, 0.8));
        penetration_result best = hit(&a, &b);
        distance_cache start = { .count = n % 5 };
        for (int c = 0; c < start.count; c++) {
            start.a[c] = (int)(a.count * random_unit(&seed));
            start.b[c] = (int)(b.count * random_unit(&seed));
            start.weight[c] = 1 / (real)start.count;
        }
        penetration_result r = penetration_find(body_points(&a), body_points(&b), &start,
                                     scratch);
        ck_assert_int_eq(r.status, best.status);
        if (r.status != PENETRATION_FOUND) continue;
        near(r.depth, best.depth, rounding);
        check_answer(&a, &b, r, 1);
    }
}
END_TEST

// Without a simplex the search begins on the side of the way out.  Rejects:
// first corners on the far side, or a fourth that is not behind them.
START_TEST(beginning_with_nothing_asks_no_more)
{
    const distance_cache none = { .count = 0 };
    unsigned long long seed = 22;
    int with = 0, without = 0;
    for (int n = 0; n < 600; n++) {
        body a, b;
        body_icosahedron(&a, 0.5);
        body_icosahedron(&b, 0.5);
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0.5, 0.8));
        penetration_result r = hit(&a, &b);
        if (r.status != PENETRATION_FOUND) continue;
        with += r.iterations;
        without += penetration_find(body_points(&a), body_points(&b), &none,
                                 scratch).iterations;
    }
    ck_assert_msg(without <= with, "%d, with gjk's %d", without, with);
}
END_TEST

START_TEST(stored_pairs_have_their_exact_depth)
{
    FILE *file = fopen(PAIRS, "r");
    ck_assert_msg(file != NULL, "cannot open %s", PAIRS);
    static pair_known p;
    int read, found = 0, named = 0;
    static const char *const name[3] = { "VF", "FV", "EE" };
    while ((read = pair_read(file, &p)) == 1) {
        real size = 0;
        for (int i = 0; i < p.a.count; i++)
            size = fmax(size, vec3_distance(p.a.at[0], p.a.at[i]));
        for (int i = 0; i < p.b.count; i++)
            size = fmax(size, vec3_distance(p.b.at[0], p.b.at[i]));
        penetration_result r = hit(&p.a, &p.b);
        ck_assert(r.status != PENETRATION_CAPPED && r.status != PENETRATION_NOT_FINITE);
        if (p.kind == 'S' && p.value > 1e-14 * size)
            ck_assert_msg(r.status == PENETRATION_APART, "%s: status %d", p.family,
                          (int)r.status);
        if (p.kind == 'S') continue;
        found++;
        real error = fabs(r.depth - p.value);
        ck_assert_msg(error <= 1e-6 * p.value || error <= 1e-14 * size,
                      "%s: got %.17g, wanted %.17g", p.family, r.depth,
                      p.value);
        int plain = strcmp(p.feature, "VF") == 0 || strcmp(p.feature, "FV") == 0
                 || strcmp(p.feature, "EE") == 0;
        // The label is certain where the next facet is more than rounding
        // deeper.
        if (p.kind != 'P' || !plain || !p.unique || p.gap < 1e-6
            || p.gap * p.value < 1e-14 * size)
            continue;
        named++;
        ck_assert_msg(strcmp(name[r.kind], p.feature) == 0, "%s: %s, not %s",
                      p.family, name[r.kind], p.feature);
    }
    fclose(file);
    ck_assert_int_eq(read, 0);
    ck_assert_int_ge(found, 30);
    ck_assert_int_ge(named, 15);
}
END_TEST

// ---- where it is hard

START_TEST(far_from_the_origin_nothing_more_is_lost)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.75, 0.5, 0.25);
    penetration_result home = hit(&a, &b);
    vec3 far = { 16777216, -8388608, 16777216 };
    body_move(&a, far);
    body_move(&b, far);
    penetration_result away = hit(&a, &b);
    same_bits(away.depth, home.depth);
    same_bits(away.normal.x, home.normal.x);
    same_bits(away.on_a.z - far.z, home.on_a.z);
}
END_TEST

// Rejects: every absolute tolerance.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100, 0x1p-900,
                           0x1p990 };
    unsigned long long seed = 11;
    for (int n = 0; n < 100; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 0.5));
        penetration_result one = hit(&a, &b);
        for (int s = 0; s < 6; s++) {
            body c = a, d = b;
            body_scale(&c, scale[s]);
            body_scale(&d, scale[s]);
            penetration_result r = hit(&c, &d);
            ck_assert_int_eq(r.status, one.status);
            same_bits(r.depth, one.depth * scale[s]);
            same_bits(r.normal.y, one.normal.y);
        }
    }
}
END_TEST

// A - B has no volume: depth 0, and a move along the normal parts them.
START_TEST(flat_on_flat_is_flat)
{
    unsigned long long seed = 15;
    for (int n = 0; n < 100; n++) {
        body a, b;
        body_square(&a);
        b = a;
        body_move(&b, (vec3){ random_unit(&seed) - 0.5, 0.25, 0 });
        penetration_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, PENETRATION_FLAT);
        same_bits(r.depth, 0);
        near(fabs(r.normal.z), 1, rounding);
        near(vec3_distance(r.on_a, r.on_b), 0, rounding);
        check_feature(&a, &r.a, r.on_a, rounding);
    }
}
END_TEST

START_TEST(points_and_segments_are_flat)
{
    vec3 s[2] = { { -1, 1, 0.5 }, { 1, 0, 0.5 } }, half = { 0, 0.5, 0.5 };
    point_set segment = { s, 2, NULL, NULL }, point = { &half, 1, NULL, NULL };
    distance_cache start = { .count = 1, .weight = { 1 } };
    penetration_result r = penetration_find(point, point, &start, scratch);
    ck_assert_int_eq(r.status, PENETRATION_FLAT);
    near(vec3_length(r.normal), 1, rounding);
    start = distance_find(segment, point, distance_options_default(), NULL).last;
    r = penetration_find(segment, point, &start, scratch);
    ck_assert_int_eq(r.status, PENETRATION_FLAT);
    near(vec3_dot(r.normal, vec3_sub(s[1], s[0])), 0, rounding);
}
END_TEST

START_TEST(a_point_inside_a_cube)
{
    body c = body_cube(0, 0, 0);
    vec3 in = { 0.375, -0.25, 0.125 };
    point_set p = { &in, 1, NULL, NULL };
    distance_cache none = { .count = 0 };
    penetration_result r = penetration_find(p, body_points(&c), &none, scratch);
    same_bits(r.depth, 0.125);
    same_bits(r.normal.x, 1);
    ck_assert_int_eq(r.kind, TOUCH_VERTEX_FACE);
    near(vec3_distance(r.on_b, (vec3){ 0.5, -0.25, 0.125 }), 0, rounding);
}
END_TEST

START_TEST(what_is_apart_is_called_apart)
{
    body a = body_cube(0, 0, 0), b = body_cube(1.25, 1.25, 0.25);
    ck_assert_int_eq(hit(&a, &b).status, PENETRATION_APART);
    body s, t;
    body_square(&s);
    t = s;
    body_move(&t, (vec3){ 0, 0, 0.125 });
    ck_assert_int_eq(hit(&s, &t).status, PENETRATION_APART);
    t = s;
    body_move(&t, (vec3){ 1.125, 0, 0 });
    ck_assert_int_eq(hit(&s, &t).status, PENETRATION_APART);
}
END_TEST

// 42 points each: the same depth by climbing (level 2) and scanning.
START_TEST(balls_scanned_and_climbed)
{
    unsigned long long seed = 33;
    for (int n = 0; n < 20; n++) {
        static body a, b;
        body_icosphere(&a, 2 + n % 2, 0.5);
        b = a;
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0.3, 0.9));
        penetration_result climbed = hit(&a, &b);
        a.has_ring = b.has_ring = 0;
        penetration_result scanned = hit(&a, &b);
        ck_assert_int_eq(climbed.status, PENETRATION_FOUND);
        near(climbed.depth, scanned.depth, rounding);
        check_answer(&a, &b, climbed, 1);
    }
}
END_TEST

// Small bodies are written in columns, large ones not.  Rejects: a column too
// many, or too few.
START_TEST(repeated_vertices_change_nothing)
{
    unsigned long long seed = 71;
    for (int n = 0; n < 200; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0.1, 0.6));
        penetration_result once = hit(&a, &b);
        a.has_ring = b.has_ring = 0;
        for (int i = 0; a.count < 60 + n % 10; i++) a.at[a.count++] = a.at[i];
        for (int i = 0; b.count < 62 + n % 7; i++) b.at[b.count++] = b.at[i];
        penetration_result again = hit(&a, &b);
        ck_assert_int_eq(again.status, once.status);
        if (once.status != PENETRATION_FOUND) continue;
        near(again.depth, once.depth, rounding);
        check_answer(&a, &b, again, 1);
    }
}
END_TEST

// Two concentric balls of 642 points: every face is nearly the nearest, and the
// polytope is full before the best is found.  The upper bound that comes out
// parts them all the same, and is less than a thousandth too deep.
START_TEST(a_full_polytope_still_answers)
{
    static body a;
    body_icosphere(&a, 2, 0.5);
    penetration_result r = hit(&a, &a);
    ck_assert_int_eq(r.status, PENETRATION_FOUND);      // of 162 points: it fits
    body_icosphere(&a, 3, 0.5);
    r = hit(&a, &a);
    ck_assert_int_eq(r.status, PENETRATION_CAPPED);
    real width = (real)oracle_width(body_hull(&a), body_hull(&a),
                                    vec3_scale(-1, r.normal));
    near(width, r.depth, rounding);
    ck_assert(r.depth > 0.99 && r.depth < 1.001);
}
END_TEST

START_TEST(what_is_not_finite_gets_a_status)
{
    const real poison[3] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    distance_cache none = { .count = 0 };
    for (int kind = 0; kind < 3; kind++)
        for (int i = 0; i < 8; i++) {
            body a = body_cube(0, 0, 0), b = body_cube(0.2, 0.1, 0.3);
            b.at[i].y = poison[kind];
            point_set pa = body_points(&a), pb = body_points(&b);
            penetration_result r = penetration_find(pa, pb, &none, scratch);
            ck_assert_int_eq(r.status, PENETRATION_NOT_FINITE);
            r = penetration_find(pb, pa, &none, scratch);
            ck_assert_int_eq(r.status, PENETRATION_NOT_FINITE);
            same_bits(r.depth, 0);
        }
}
END_TEST

// ---- what the fuzzer found

// Rejects: sums of coordinates that overflow, and no vertex, -1, for the
// furthest.
START_TEST(what_is_beyond_all_sums_gets_a_status)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.25, 0, 0);
    body_scale(&a, 0x1p1015);
    body_scale(&b, 0x1p1015);
    same_bits(hit(&a, &b).depth, 0.75 * 0x1p1015);
    distance_cache none = { .count = 0 };
    body_scale(&a, 64);
    penetration_result r = penetration_find(body_points(&a), body_points(&b), &none,
                                 scratch);
    ck_assert_int_eq(r.status, PENETRATION_NOT_FINITE);
    same_bits(r.depth, 0);
}
END_TEST

// A - B has next to no volume, and the origin lies in its plane, beside it.
// Rejects: a depth of 0, because no vertex is beyond that plane.
START_TEST(thin_bodies_side_by_side_are_apart)
{
    unsigned long long seed = 51;
    for (int n = 0; n < 1000; n++) {
        // Flat but for a few dozen steps of the grid, and 2 to 3 sides apart.
        body a, b;
        body_square(&a);
        for (int i = 0; i < 4; i++) a.at[i].z = ldexp(random_unit(&seed), -42);
        body_turn(&a, &seed);
        b = a;
        vec3 across = vec3_sub(a.at[1], a.at[0]);
        body_move(&b, vec3_scale(2 + random_unit(&seed), across));
        distance_cache start = { .count = n % 5 };
        for (int c = 0; c < start.count; c++) {
            start.a[c] = c;
            start.b[c] = 3 - c;
            start.weight[c] = 1 / (real)start.count;
        }
        penetration_result r = penetration_find(body_points(&a), body_points(&b), &start,
                                     scratch);
        ck_assert_int_eq(r.status, PENETRATION_APART);
    }
}
END_TEST

// Rejects: a normal across a short edge where A - B is a long line.
START_TEST(the_normal_stands_on_the_line)
{
    vec3 p = { -11.25, -11.25, -11.249999999999922 };
    vec3 q[3] = { { -11.250000000000352, -11.250000000000075,
                    -11.249999999999691 },
                  { -11.25, -11.249999999999616, -11.249999999999321 },
                  { -64, -64, -64 } };
    point_set a = { &p, 1, NULL, NULL }, b = { q, 3, NULL, NULL };
    distance_cache start = { .count = 2, .b = { 1, 0 }, .weight = { 0.25, 0.75 } };
    penetration_result r = penetration_find(a, b, &start, scratch);
    ck_assert_int_eq(r.status, PENETRATION_FLAT);
    near(vec3_dot(r.normal, vec3_unit(vec3_sub(q[2], q[0]))), 0, rounding);
    near((real)oracle_width(hull_of(a), hull_of(b), r.normal), 0, rounding * 64);
}
END_TEST

// Two bodies that touch in a corner of a needle of a face.  Rejects: points of
// it that are 1e-3 m apart, for want of a plane to weigh them in.
START_TEST(points_on_a_needle_meet)
{
    vec3 p[8] = { { -23.75, -23.75, -23.75 },
                  { -23.749999999999766, -51.25, -63.25 }, { -64, -64, -64 },
                  { -64.000000000000767, -64.000000000001521,
                    -64.000000000002274 },
                  { -64.000000000003041, -64.000000000003809,
                    -64.000000000004562 } };
    vec3 q[5] = { { -64.000000000005315, -64.000000000006082,
                    -64.00000000000685 },
                  { -64.000000000007603, -64.000000000008356,
                    -64.000000000009123 },
                  { -64.000000000009891, -64.000000000010644,
                    -64.000000000011397 },
                  { -64.000000000012164, -64.000000000012932,
                    -64.000000000013557 }, { -64, -64, -64 } };
    point_set a = { p, 5, NULL, NULL }, b = { q, 5, NULL, NULL };
    distance_cache start = distance_find(a, b, distance_options_default(), NULL).last;
    penetration_result r = penetration_find(a, b, &start, scratch);
    ck_assert(r.status == PENETRATION_FOUND || r.status == PENETRATION_FLAT);
    near(r.depth, 0, 1e-12);
    near(vec3_distance(r.on_a, r.on_b), 0, 1e-11);
}
END_TEST

// A simplex that says nothing, or too much: without corners, of four, or with
// weights that are all 0.
START_TEST(flat_sets_take_any_start)
{
    body a, b;
    body_square(&a);
    b = a;
    body_move(&b, (vec3){ 0.25, 0.125, 0 });
    for (int count = 0; count <= 4; count++)
        for (int kind = 0; kind < 2; kind++) {
            distance_cache start = { .count = count, .a = { 3, 2, 1, 0 },
                              .b = { 0, 1, 2, 3 } };
            for (int c = 0; c < count; c++)
                start.weight[c] = kind ? 1 / (real)count : 0;
            penetration_result r = penetration_find(body_points(&a), body_points(&b),
                                         &start, scratch);
            ck_assert(r.status == PENETRATION_FLAT || r.status == PENETRATION_APART);
            near(fabs(r.normal.z), 1, rounding);
            same_bits(r.depth, 0);
            check_feature(&a, &r.a, r.on_a, rounding);
            check_feature(&b, &r.b, r.on_b, rounding);
        }
}
END_TEST

// Chapter 05's hit face, which shares no line with this one.  Rejects: a depth
// or a move that only the fast way believes in.
START_TEST(the_fast_depth_is_the_plain_one)
{
    unsigned long long seed = 505;
    int overlapping = 0;
    for (int n = 0; n < 20000; n++) {
        static body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0, 1));
        penetration_result fast = hit(&a, &b);
        hull p = { a.at, a.count }, q = { b.at, b.count };
        gjk_result apart = gjk_distance(p, q, HUGE_VAL, NULL);
        ck_assert_int_eq(apart.status == GJK_OVERLAP,
                         fast.status != PENETRATION_APART);
        if (apart.status != GJK_OVERLAP) continue;
        hit_result plain = hit_face_find(p, q, &apart.last);
        overlapping++;
        near(fast.depth, plain.depth, reference);
        near(vec3_dot(vec3_sub(fast.on_b, fast.on_a), fast.normal), plain.depth,
             reference);
    }
    ck_assert_int_ge(overlapping, 5000);
}
END_TEST

START_TEST(refused_memory_leaves_no_scratch)
{
    mallocs_left = 0;
    penetration_scratch *none = penetration_scratch_new();
    mallocs_left = INT_MAX;
    ck_assert_ptr_null(none);
    penetration_scratch_free(none);
}
END_TEST

// The number was printed by this test itself; gcc and clang agree on it at -O0,
// -O2 and -O3.  A change of it is a change of answers.
static const unsigned long long known_digest = 0x2f161899024fd69dULL;

START_TEST(the_same_bits_everywhere)
{
    unsigned long long seed = 41, h = 0;
    for (int n = 0; n < 2000; n++) {
        body a, b;
        body_any(&a, n % 4, &seed);
        body_any(&b, n / 4 % 4, &seed);
        body_move(&b, random_vector(&seed, 0, 1));
        penetration_result r = hit(&a, &b);
        const real part[] = { r.depth, r.normal.x, r.normal.y, r.normal.z,
                              r.on_a.x, r.on_a.y, r.on_a.z, r.on_b.x };
        unsigned char bytes[sizeof part];
        memcpy(bytes, part, sizeof part);
        for (size_t i = 0; i < sizeof part; i++)
            h = (h ^ bytes[i]) * 1099511628211ULL;
        h += (unsigned long long)r.status + (unsigned long long)r.kind;
    }
    ck_assert_msg(h == known_digest, "the digest is 0x%llxULL", h);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("hit_face");
    TCase *t = tcase_create("hit_face");
    tcase_add_checked_fixture(t, setup, teardown);
    tcase_set_timeout(t, 60);
    tcase_add_test(t, a_cube_pushed_in_comes_out_the_short_way);
    tcase_add_test(t, moved_by_the_depth_they_only_touch);
    tcase_add_test(t, touching_is_depth_zero_with_a_proper_normal);
    tcase_add_test(t, identical_and_concentric_cubes);
    tcase_add_test(t, stacked_cubes_at_every_depth);
    tcase_add_test(t, a_vertex_a_face_and_two_edges_are_named);
    tcase_add_test(t, random_pairs_agree_with_every_direction);
    tcase_add_test(t, equal_bodies_side_by_side);
    tcase_add_test(t, prisms_stand_on_prisms);
    tcase_add_test(t, any_start_will_do);
    tcase_add_test(t, beginning_with_nothing_asks_no_more);
    tcase_add_test(t, stored_pairs_have_their_exact_depth);
    tcase_add_test(t, far_from_the_origin_nothing_more_is_lost);
    tcase_add_test(t, size_does_not_matter);
    tcase_add_test(t, flat_on_flat_is_flat);
    tcase_add_test(t, points_and_segments_are_flat);
    tcase_add_test(t, a_point_inside_a_cube);
    tcase_add_test(t, what_is_apart_is_called_apart);
    tcase_add_test(t, balls_scanned_and_climbed);
    tcase_add_test(t, repeated_vertices_change_nothing);
    tcase_add_test(t, a_full_polytope_still_answers);
    tcase_add_test(t, what_is_not_finite_gets_a_status);
    tcase_add_test(t, what_is_beyond_all_sums_gets_a_status);
    tcase_add_test(t, thin_bodies_side_by_side_are_apart);
    tcase_add_test(t, the_normal_stands_on_the_line);
    tcase_add_test(t, points_on_a_needle_meet);
    tcase_add_test(t, flat_sets_take_any_start);
    tcase_add_test(t, the_fast_depth_is_the_plain_one);
    tcase_add_test(t, refused_memory_leaves_no_scratch);
    if (bits_are_ours()) tcase_add_test(t, the_same_bits_everywhere);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
