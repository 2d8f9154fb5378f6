// check_swept.c - tests of lib/swept: when do bodies on their way first touch,
// and do those that do not, pass?

#include "bodies.h"
#include "expect.h"
#include "oracle.h"
#include "random.h"
#include "suite.h"
#include "swept.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// m, for bodies of about 1 m on ways of a few metres: fine beside both, and a
// hundred thousand times what rounding makes of them.
static const real fine = 1e-9;
// A few dozen roundings of such coordinates.
static const real rounding = 1e-14;
// A body that passes, or clips, by so much of its size is to do so.
static const real graze = 1e-9;

// A reader's code (exercises/judge.h) is slowed down by sanitizers.
#ifdef TUMBLE_JUDGE_H
enum { WAYS = 10000 };
#else
enum { WAYS = 100000 };
#endif

typedef long double wide;

static vec3 *scratch_for(hull a, hull b)
{
    // Exactly as much as is asked for: the sanitizers see one point more.
    vec3 *s = malloc((size_t)(a.count + b.count) * sizeof *s);
    ck_assert(s != NULL);
    return s;
}

static swept_result sweep_sets(hull a, vec3 way, hull b, real apart,
                               real tolerance)
{
    vec3 *scratch = scratch_for(a, b);
    swept_result r = swept_first_touch(a, way, b, apart, tolerance, scratch);
    free(scratch);
    return r;
}

static swept_result sweep(const body *a, vec3 way, const body *b, real apart,
                          real tolerance)
{
    return sweep_sets(body_hull(a), way, body_hull(b), apart, tolerance);
}

static void same_bits(real got, real wanted)
{
    ck_assert_msg(memcmp(&got, &wanted, sizeof got) == 0,
                  "got %.17g, wanted %.17g", got, wanted);
}

static body body_point(real x, real y, real z)
{
    return (body){ .count = 1, .at = { { x, y, z } } };
}

static body body_segment(vec3 p, vec3 q)
{
    return (body){ .count = 2, .at = { p, q } };
}

// Where a is after the share t of its way.
static body body_later(const body *a, vec3 way, real t)
{
    body b = *a;
    body_move(&b, vec3_scale(t, way));
    return b;
}

static real truth_at(const body *a, vec3 way, real t, const body *b)
{
    body later = body_later(a, way, t);
    return (real)oracle_distance(body_hull(&later), body_hull(b));
}

// ---- answers that can be had by hand

// Rejects: times in metres, a normal from A to B, points in a moved frame.
START_TEST(point_meets_plate_at_an_angle)
{
    body p = body_point(-2, 0.25, 3), plate;
    body_square(&plate);
    body_scale(&plate, 4);
    swept_result r = sweep(&p, (vec3){ 4, 0, -4 }, &plate, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_TOUCHES);
    near(r.time, 0.75, fine / 4);       // closing at 4 m a way
    near(r.normal.z, 1, rounding);
    near(r.on_b.x, 1, fine);
    near(r.on_b.y, 0.25, rounding);
    near(r.on_a.x, 1, fine);
    ck_assert(r.on_a.z > 0 && r.on_a.z <= fine);
}
END_TEST

// Rejects: a gap that is left out of the time, or taken twice.
START_TEST(apart_is_a_distance_to_be_kept)
{
    body p = body_point(0.125, 0.25, 3), plate;
    body_square(&plate);
    swept_result r = sweep(&p, (vec3){ 0, 0, -4 }, &plate, 0.5, fine);
    ck_assert_int_eq(r.status, SWEPT_TOUCHES);
    near(r.time, 2.5 / 4, fine / 4);
    near(r.on_a.z, 0.5, fine);
    ck_assert(r.on_a.z >= 0.5);
}
END_TEST

START_TEST(cubes_meet_face_edge_and_corner_on)
{
    body b = body_cube(0, 0, 0), face = body_cube(3, 0.25, -0.25);
    body edge = body_cube(3, 3, 0.25), tip = body_cube(3, -3, 3);
    swept_result f = sweep(&face, (vec3){ -4, 0, 0 }, &b, 0, fine);
    swept_result e = sweep(&edge, (vec3){ -4, -4, 0 }, &b, 0, fine);
    swept_result c = sweep(&tip, (vec3){ -4, 4, -4 }, &b, 0, fine);
    ck_assert_int_eq(f.status, SWEPT_TOUCHES);
    ck_assert_int_eq(e.status, SWEPT_TOUCHES);
    ck_assert_int_eq(c.status, SWEPT_TOUCHES);
    near(f.time, 0.5, fine / 4);
    near(e.time, 0.5, fine / 4);
    near(c.time, 0.5, fine / 4);
    near(f.normal.x, 1, rounding);
    near(e.normal.x, sqrt(0.5), 1e-6);
    near(c.normal.y, -sqrt(1.0 / 3), 1e-6);
}
END_TEST

// Two segments at right angles: an edge on an edge.
START_TEST(crossing_edges_meet_where_they_cross)
{
    body s = body_segment((vec3){ -1, 0, 2 }, (vec3){ 1, 0, 2 });
    body t = body_segment((vec3){ 0.5, -1, 0 }, (vec3){ 0.5, 1, 0 });
    swept_result r = sweep(&s, (vec3){ 0, 0, -8 }, &t, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_TOUCHES);
    near(r.time, 0.25, fine / 8);
    near(r.normal.z, 1, rounding);
    near(r.on_b.x, 0.5, rounding);
    ck_assert_int_eq(r.last.count, 3);      // of A - B, a flat parallelogram
}
END_TEST

// A ball is a point with a radius: |x + t way| = radius is a quadratic.
// Rejects: steps that pass over the near side, far sides, wrong roots.
START_TEST(balls_meet_where_the_quadratic_says)
{
    unsigned long long seed = 3;
    body b = body_point(0.5, -0.25, 0.125);
    int touched = 0, passed = 0;
    for (int n = 0; n < 10000; n++) {
        vec3 x = random_vector(&seed, 1.5, 3);
        vec3 aim = random_vector(&seed, 0, 1.5);
        real by = 0.5 + 2 * random_fraction(&seed);
        vec3 way = vec3_scale(by, vec3_sub(aim, x));
        real ww = vec3_length_squared(way), xw = vec3_dot(x, way);
        real root = xw * xw - ww * (vec3_length_squared(x) - 1);
        body a = body_point(x.x, x.y, x.z);
        body_move(&a, b.at[0]);
        swept_result r = sweep(&a, way, &b, 1, fine);
        real t = root > 0 ? (-xw - sqrt(root)) / ww : 2;
        if (fabs(root) < 1e-7 || fabs(t - 1) < 1e-7) continue;
        ck_assert_int_eq(r.status, t <= 1 ? SWEPT_TOUCHES : SWEPT_PASSES);
        passed += t > 1;
        if (t > 1) continue;
        touched++;
        // At the slope of the distance there, of which root is a measure.
        near(r.time, t, 2 * fine / sqrt(root) + rounding);
    }
    ck_assert_int_ge(touched, 3000);
    ck_assert_int_ge(passed, 1000);
}
END_TEST

START_TEST(balls_of_points_meet_tip_to_tip)
{
    static body a, b;
    body_icosphere(&a, 2, 0.5);
    b = a;
    vec3 tip = a.at[0];     // opposite vertices exist: the ball is symmetric
    body_move(&a, vec3_scale(6, tip));
    swept_result r = sweep(&a, vec3_scale(-8, tip), &b, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_TOUCHES);
    near(r.time, 0.5, fine);
    near(vec3_dot(r.normal, tip), 0.5, 1e-6);
}
END_TEST

// ---- who passes, and who does not

// Rejects: ghost hits by the plane through the nearest point; a way that is
// taken for a line without an end, or one that goes backwards too.
START_TEST(whoever_passes_beside_or_turns_away_passes)
{
    body plate, p = body_point(2, 0, 1);
    body_square(&plate);
    ck_assert_int_eq(sweep(&p, (vec3){ 0, 0, -2 }, &plate, 0, fine).status,
                     SWEPT_PASSES);
    p = body_point(0, 0, 1);
    vec3 up = { 0, 0, 5 }, along = { 1, 1, 0 }, low = { 0, 0, -0.999 };
    ck_assert_int_eq(sweep(&p, up, &plate, 0, fine).status, SWEPT_PASSES);
    ck_assert_int_eq(sweep(&p, along, &plate, 0, fine).status, SWEPT_PASSES);
    swept_result r = sweep(&p, low, &plate, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_PASSES);
    same_bits(r.time, 1);
}
END_TEST

// A cube over the top of another, which it clears, or clips, by so much.
static swept_status graze_face(real gap, real size, real sizes_a_way)
{
    body a = body_cube(-0.75 * sizes_a_way, 1 + gap, 0.125);
    body b = body_cube(0.25, 0, 0);
    body_scale(&a, size);
    body_scale(&b, size);
    return sweep(&a, (vec3){ 1.5 * sizes_a_way * size, 0, 0 }, &b, 0,
                 graze / 4 * size).status;
}

// The same askew: an edge of one against an edge of the other.
static swept_status graze_edge(real gap, real size, real sizes_a_way)
{
    body a = body_segment((vec3){ -1, -1, gap }, (vec3){ 1, -1, gap });
    body b = body_segment((vec3){ 0.3, -0.2, 0 }, (vec3){ 0.1, 0.9, 0 });
    vec3 way = vec3_scale(sizes_a_way * size, (vec3){ 0.25, 2, 0 });
    body_move(&a, vec3_scale(-sizes_a_way / 2, (vec3){ 0.25, 2, 0 }));
    body_scale(&a, size);
    body_scale(&b, size);
    return sweep(&a, way, &b, 0, graze / 4 * size).status;
}

// A ball past a ball.
static swept_status graze_ball(real gap, real size, real sizes_a_way)
{
    body a = body_point(-0.6 * sizes_a_way * size, (0.5 + gap) * size, 0);
    body b = body_point(0, 0, 0);
    return sweep(&a, (vec3){ sizes_a_way * size, 0, 0 }, &b, 0.5 * size,
                 graze / 4 * size).status;
}

// Rejects: absolute tolerances; bounds that are a little too generous, or that
// stop a hair too far off; giving up on a way of 100,000 sizes.
START_TEST(a_graze_of_a_billionth_passes_and_a_clip_touches)
{
    const real size[] = { 1e-6, 1, 1e6 }, far[] = { 3, 1e3, 1e5 };
    for (int s = 0; s < 3; s++)
        for (int f = 0; f < 3; f++) {
            real l = size[s], w = far[f];
            ck_assert_int_eq(graze_face(graze, l, w), SWEPT_PASSES);
            ck_assert_int_eq(graze_face(-graze, l, w), SWEPT_TOUCHES);
            ck_assert_int_eq(graze_edge(graze, l, w), SWEPT_PASSES);
            ck_assert_int_eq(graze_edge(0, l, w), SWEPT_TOUCHES);
            ck_assert_int_eq(graze_ball(graze, l, w), SWEPT_PASSES);
            ck_assert_int_eq(graze_ball(-graze, l, w), SWEPT_TOUCHES);
        }
}
END_TEST

// Past a corner, at every angle: a point passes a cube's edge by a billionth on
// one side, and meets it on the other.
START_TEST(a_corner_is_passed_or_met_at_every_angle)
{
    unsigned long long seed = 5;
    body cube = body_cube(-0.5, -0.5, 0);   // an edge at x = y = 0
    for (int n = 0; n < 20000; n++) {
        // Down to the right: its normal is the diagonal's side of the edge.
        vec3 d = { 0.05 + random_fraction(&seed),
                   -0.05 - random_fraction(&seed),
                   random_fraction(&seed) - 0.5 };
        vec3 side = vec3_unit((vec3){ -d.y, d.x, 0 });
        real back = 0.5 + 3 * random_fraction(&seed);
        for (int sign = -1; sign < 2; sign += 2) {
            vec3 at = vec3_add_scaled((vec3){ 0, 0, 0 }, sign * graze, side);
            vec3 from = vec3_add_scaled(at, -0.4 * back, d);
            body a = body_point(from.x, from.y, 0);
            vec3 way = vec3_scale(back, (vec3){ d.x, d.y, 0 });
            swept_result r = sweep(&a, way, &cube, 0, graze / 4);
            ck_assert_int_eq(r.status,
                             sign > 0 ? SWEPT_PASSES : SWEPT_TOUCHES);
        }
    }
}
END_TEST

// A sheet without thickness, and points, segments and squares that cross it at
// up to 100,000 sizes a way, with tolerances that no double can hold.
// Rejects: steps that land behind the sheet.
START_TEST(nothing_flat_is_ever_crossed)
{
    unsigned long long seed = 7;
    body plate;
    for (int n = 0; n < 20000; n++) {
        body a;
        real far = n % 3 == 0 ? 1e5 : n % 3 == 1 ? 1e2 : 2;
        body_square(&plate);
        body_turn(&plate, &seed);
        body_any(&a, n % 2 ? 4 : 3, &seed);
        body_scale(&a, 0.1);
        vec3 d = random_direction(&seed);
        // Its first point goes through a place well within the sheet.
        body_move(&a, vec3_scale(-1, a.at[0]));
        vec3 x = vec3_scale(0.9 * random_fraction(&seed), plate.at[0]);
        vec3 way = vec3_scale(far, d);
        body_move(&a, vec3_add_scaled(x, -0.3 - 0.4 * far, d));
        swept_result r = sweep(&a, way, &plate, 0, 1e-30);
        ck_assert_msg(r.status == SWEPT_TOUCHES || r.status == SWEPT_OVERLAP,
                      "case %d: status %d", n, (int)r.status);
    }
}
END_TEST

// ---- against oracles

// Between which shares of the way do the hulls overlap?  For bodies with a
// volume.  A - B is the room between pairs of planes, whose normals are among
// those of all triangles of points and the crossings of all segments: the way
// is clipped by each.
typedef struct {
    wide enter, leave;
} interval;

typedef struct { wide x, y, z; } vec;

static vec vec_between(vec3 a, vec3 b)
{
    return (vec){ (wide)b.x - (wide)a.x, (wide)b.y - (wide)a.y,
                  (wide)b.z - (wide)a.z };
}

static void clip(const body *a, vec way, const body *b, vec e, vec f,
                 interval *t)
{
    vec n = { e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z,
              e.x * f.y - e.y * f.x };
    wide low = (wide)HUGE_VAL, high = -low, b_low = low, b_high = high;
    if (!(n.x * n.x + n.y * n.y + n.z * n.z > 1e-12L)) return;
    for (int i = 0; i < a->count; i++) {
        wide h = n.x * (wide)a->at[i].x + n.y * (wide)a->at[i].y
               + n.z * (wide)a->at[i].z;
        low = h < low ? h : low;
        high = h > high ? h : high;
    }
    for (int j = 0; j < b->count; j++) {
        wide h = n.x * (wide)b->at[j].x + n.y * (wide)b->at[j].y
               + n.z * (wide)b->at[j].z;
        b_low = h < b_low ? h : b_low;
        b_high = h > b_high ? h : b_high;
    }
    low -= b_high;
    high -= b_low;
    wide speed = n.x * way.x + n.y * way.y + n.z * way.z;
    if (speed < 0) {
        wide swap = low;
        low = -high;
        high = -swap;
        speed = -speed;
    }
    // low + t speed <= 0 <= high + t speed
    wide first = speed > 0 ? -high / speed : high < 0 ? 9 : -9;
    wide last = speed > 0 ? -low / speed : low > 0 ? -9 : 9;
    t->enter = first > t->enter ? first : t->enter;
    t->leave = last < t->leave ? last : t->leave;
}

static void clip_faces(const body *a, vec way, const body *b, const body *of,
                       interval *t)
{
    for (int i = 0; i < of->count; i++)
        for (int j = i + 1; j < of->count; j++)
            for (int k = j + 1; k < of->count; k++)
                clip(a, way, b, vec_between(of->at[i], of->at[j]),
                     vec_between(of->at[i], of->at[k]), t);
}

static interval overlap_of(const body *a, vec3 w, const body *b)
{
    interval t = { -9, 9 };
    vec way = vec_between((vec3){ 0, 0, 0 }, w);
    clip_faces(a, way, b, a, &t);
    clip_faces(a, way, b, b, &t);
    for (int i = 0; i < a->count; i++)
        for (int j = i + 1; j < a->count; j++)
            for (int k = 0; k < b->count; k++)
                for (int l = k + 1; l < b->count; l++)
                    clip(a, way, b, vec_between(a->at[i], a->at[j]),
                         vec_between(b->at[k], b->at[l]), &t);
    return t;
}

// A pair of bodies with a volume on a random way that may meet.
static void random_case(int n, unsigned long long *seed, body *a, body *b,
                        vec3 *way)
{
    int any = n % 25 == 0;
    body_any(a, any ? n / 25 % 3 : 2, seed);
    body_any(b, any ? n / 75 % 3 : 2, seed);
    if (!any) a->count = b->count = 4;
    vec3 from = random_vector(seed, 0.5, 4), to = random_vector(seed, 0, 2);
    *way = vec3_scale(0.25 + 2 * random_fraction(seed), vec3_sub(to, from));
    body_move(a, from);
}

static void agrees(const swept_result *r, const interval *t, const body *a,
                   vec3 way, const body *b, int look)
{
    wide slack = (wide)rounding / (wide)vec3_length(way);
    int meet = t->enter <= t->leave;
    if (meet && t->enter <= 0 && t->leave >= 0) {
        ck_assert_int_eq(r->status, SWEPT_OVERLAP);
        return;
    }
    if (r->status == SWEPT_OVERLAP)
        ck_assert(truth_at(a, way, 0, b) <= fine + rounding);
    // Whoever meets must touch, and not later.
    if (meet && t->enter > 0 && t->enter <= 1) {
        ck_assert(r->status == SWEPT_TOUCHES || t->enter < 1e-8L);
        ck_assert((wide)r->time <= t->enter + slack);
    }
    // Whoever touches must be that near, and was not before: the distance on a
    // straight way is convex, and at that time it still falls.
    if (r->status != SWEPT_TOUCHES || !look) return;
    real d = truth_at(a, way, r->time, b);
    ck_assert_msg(d > 0 && d <= fine + rounding, "%g m apart", d);
    ck_assert(vec3_dot(way, r->normal) < 0);
}

// Rejects: any bound that is too bold, in 100,000 ways.
START_TEST(random_ways_agree_with_the_clipped_way)
{
    unsigned long long seed = 2004;
    int touched = 0, passed = 0, overlapped = 0;
    static body a, b;
    for (int n = 0; n < WAYS; n++) {
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        interval t = overlap_of(&a, way, &b);
        swept_result r = sweep(&a, way, &b, 0, fine);
        agrees(&r, &t, &a, way, &b, n % 10 == 1);
        touched += r.status == SWEPT_TOUCHES;
        passed += r.status == SWEPT_PASSES;
        overlapped += r.status == SWEPT_OVERLAP;
        // Whoever passes must not come near.
        if (r.status == SWEPT_PASSES)
            ck_assert(!(t.enter <= t.leave && t.enter <= 1 && t.leave >= 0));
    }
    ck_assert_int_eq(touched + passed + overlapped, WAYS);
    ck_assert_int_ge(touched, WAYS / 5);
    ck_assert_int_ge(passed, WAYS / 5);
    ck_assert_int_ge(overlapped, 3 * (WAYS / 100));
}
END_TEST

// When are they nearest?  The distance is convex in time: golden sections.
static real nearest_time(const body *a, vec3 way, const body *b)
{
    const real part = 0.6180339887498949;
    real low = 0, high = 1;
    real s = high - part, t = low + part;
    real at_s = truth_at(a, way, s, b), at_t = truth_at(a, way, t, b);
    for (int k = 0; k < 45; k++) {
        if (at_s <= at_t) {
            high = t;
            t = s;
            at_t = at_s;
            s = high - part * (high - low);
            at_s = truth_at(a, way, s, b);
        } else {
            low = s;
            s = t;
            at_s = at_t;
            t = low + part * (high - low);
            at_t = truth_at(a, way, t, b);
        }
    }
    return (low + high) / 2;
}

// Points, segments, triangles, plates and bodies, and a distance to be kept.
START_TEST(ways_past_flat_and_thin_agree_with_the_least_distance)
{
    // The square root of a rounding error: how well a minimum is found.
    const real found = 1e-7;
    unsigned long long seed = 1996;
    int touched = 0, passed = 0;
    for (int n = 0; n < 600; n++) {
        static body a, b;
        body_any(&a, 2 + n % 3, &seed);
        body_any(&b, 2 + n / 3 % 3, &seed);
        if (a.count > 4) a.count = 4;
        if (b.count > 4) b.count = 4;
        vec3 from = random_vector(&seed, 2.5, 4);
        vec3 way = vec3_sub(random_vector(&seed, 0, 2.5), from);
        real apart = 0.3 * random_fraction(&seed);
        body_move(&a, from);
        way = vec3_scale(0.5 + 1.5 * random_fraction(&seed), way);
        swept_result r = sweep(&a, way, &b, apart, fine);
        real t = nearest_time(&a, way, &b), least = truth_at(&a, way, t, &b);
        if (r.status == SWEPT_TOUCHES) {
            touched++;
            real d = truth_at(&a, way, r.time, &b);
            ck_assert_msg(d >= apart - rounding && d <= apart + fine + rounding,
                          "case %d: %.17g m apart, not %.17g", n, d, apart);
            ck_assert(r.time <= t + found);
        } else if (r.status == SWEPT_PASSES) {
            passed++;
            ck_assert_msg(least > apart - found, "case %d comes as near as %g",
                          n, least);
        } else {
            ck_assert_int_eq(r.status, SWEPT_OVERLAP);
        }
    }
    ck_assert_int_ge(touched, 150);
    ck_assert_int_ge(passed, 100);
}
END_TEST

// ---- what must not matter, and what must

// Rejects: a gap with the wrong sign somewhere.
START_TEST(the_further_to_keep_apart_the_sooner_they_touch)
{
    unsigned long long seed = 13;
    for (int n = 0; n < 2000; n++) {
        static body a, b;
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        real before = 1;
        for (int k = 0; k < 6; k++) {
            swept_result r = sweep(&a, way, &b, 0.1 * k, fine);
            ck_assert(r.time <= before);
            before = r.time;
        }
    }
}
END_TEST

// Rejects: places that are rounded at the world's origin.  The coordinates are
// of a grid that the move leaves exact, so every bit must stay.
START_TEST(far_from_the_origin_nothing_more_is_lost)
{
    vec3 far = { 16777216, -8388608, 16777216 };
    unsigned long long seed = 17;
    for (int n = 0; n < 2000; n++) {
        body a = body_cube(2, 0, 0), b = body_cube(0, 0, 0);
        for (int i = 0; i < 8; i++) {
            a.at[i].x += floor(1024 * random_fraction(&seed)) / 1024;
            b.at[i].y += floor(1024 * random_fraction(&seed)) / 1024;
        }
        vec3 way = random_vector(&seed, 1, 4);
        swept_result home = sweep(&a, way, &b, 0, fine);
        body_move(&a, far);
        body_move(&b, far);
        swept_result away = sweep(&a, way, &b, 0, fine);
        ck_assert_int_eq(away.status, home.status);
        same_bits(away.time, home.time);
        same_bits(away.normal.y, home.normal.y);
    }
    // 8,000 km out, by one unit in the last place: 1.9 nm.
    for (int sign = -1; sign < 2; sign += 2) {
        body a = body_cube(-3, 1, 0), b = body_cube(0, 0, 0);
        vec3 out = { 8388608, 8388608, -8388608 };
        body_move(&a, out);
        body_move(&b, out);
        for (int i = 0; i < 8; i++) a.at[i].y += sign * 0x1p-29;
        swept_result r = sweep(&a, (vec3){ 6, 0, 0 }, &b, 0, 1e-10);
        ck_assert_int_eq(r.status, sign > 0 ? SWEPT_PASSES : SWEPT_TOUCHES);
    }
}
END_TEST

// Rejects: every absolute tolerance; axes whose squares are lost.  Powers of
// two round nothing.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100, 0x1p-150,
                           0x1p150 };
    unsigned long long seed = 19;
    for (int n = 0; n < 300; n++) {
        static body a, b, c, d;
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        real apart = n % 2 ? 0.0625 : 0;
        swept_result one = sweep(&a, way, &b, apart, fine);
        for (int s = 0; s < 6; s++) {
            c = a;
            d = b;
            body_scale(&c, scale[s]);
            body_scale(&d, scale[s]);
            swept_result r = sweep(&c, vec3_scale(scale[s], way), &d,
                                   apart * scale[s], fine * scale[s]);
            ck_assert_int_eq(r.status, one.status);
            same_bits(r.time, one.time);
            same_bits(r.normal.z, one.normal.z);
        }
    }
}
END_TEST

// The same event, seen from the other body.
START_TEST(swapped_roles_give_the_mirror_image)
{
    unsigned long long seed = 23;
    for (int n = 0; n < 3000; n++) {
        static body a, b;
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        swept_result r = sweep(&a, way, &b, 0.125, fine);
        swept_result q = sweep(&b, vec3_scale(-1, way), &a, 0.125, fine);
        // Whoever grazes may be told either way.
        if (r.status != q.status) {
            ck_assert(truth_at(&a, way, fmin(r.time, q.time), &b)
                      <= 0.125 + 2 * fine);
            continue;
        }
        // As near, at its speed, as the two stops may differ.
        real closing = fabs(vec3_dot(way, r.normal));
        ck_assert(fabs(r.time - q.time) * closing <= 2 * fine);
        if (r.status == SWEPT_TOUCHES && closing > 1e-3)
            near(vec3_dot(r.normal, q.normal), -1, 1e-5);
    }
}
END_TEST

START_TEST(at_the_start_there_may_be_nothing_left_to_find)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.5, 0, 0);
    vec3 way = { 3, 0, 0 }, zero = { 0, 0, 0 };
    swept_result same = sweep(&a, way, &a, 0, fine);
    ck_assert_int_eq(same.status, SWEPT_OVERLAP);
    same_bits(same.time, 0);
    same_bits(vec3_length(same.normal), 0);
    ck_assert_int_eq(sweep(&a, way, &b, 0, fine).status, SWEPT_OVERLAP);
    // As near as apart already: it has a normal, even when they part.
    body c = body_cube(-1.25, 0, 0);
    swept_result r = sweep(&c, vec3_scale(-1, way), &a, 0.5, fine);
    ck_assert_int_eq(r.status, SWEPT_OVERLAP);
    near(r.normal.x, -1, rounding);
    // Nobody moves.
    r = sweep(&c, zero, &a, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_PASSES);
    ck_assert_int_eq(r.iterations, 1);
    ck_assert_int_eq(sweep(&c, zero, &a, 0.25, fine).status, SWEPT_OVERLAP);
}
END_TEST

START_TEST(what_is_not_finite_gets_a_status)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 3; k++)
        for (int where = 0; where < 3; where++) {
            static body a, b;
            body_icosphere(&a, 2, 0.5);
            body_icosphere(&b, 2, 0.5);
            body_move(&a, (vec3){ 3, 0, 0 });
            vec3 way = { -4, 0, 0 };
            if (where == 0) a.at[161].y = bad[k];
            if (where == 1) b.at[77].z = bad[k];
            if (where == 2) way.x = bad[k];
            swept_result r = sweep(&a, way, &b, 0, fine);
            ck_assert_int_eq(r.status, SWEPT_NOT_FINITE);
            ck_assert(vec3_is_finite(r.normal) && vec3_is_finite(r.on_a));
            ck_assert(vec3_is_finite(r.on_b) && r.time - r.time == 0);
        }
}
END_TEST

// Beyond what gjk computes with, 1e60 m, and a little short of it.
// Rejects: a distance of what could not be measured taken for one.
START_TEST(what_is_beyond_measure_gets_a_status)
{
    const real far = 0x1p202;
    body p = body_point(0, far, 0), q = body_point(0, 0, 0);
    swept_result r = sweep(&p, (vec3){ 0, -1, 0 }, &q, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_NOT_FINITE);
    ck_assert(vec3_is_finite(r.normal) && vec3_is_finite(r.on_a));
    ck_assert(vec3_is_finite(r.on_b) && r.time == 0);
    p = body_point(0, far / 16, 0);
    r = sweep(&p, (vec3){ 0, -far / 8, 0 }, &q, 0, fine);
    ck_assert_int_eq(r.status, SWEPT_TOUCHES);
}
END_TEST

// The smallest number there is, along two axes: a distance that rounds to
// nothing, along no axis.
// Rejects: a direction divided by its length, 0.
START_TEST(smallest_numbers_give_no_nan)
{
    const real least = 0x1p-1074;
    body p = body_point(0, 0, 0);
    body q = body_segment((vec3){ least, 0, 0 }, (vec3){ 0, least, 0 });
    for (int k = 0; k < 3; k++) {
        vec3 way = { k * least, 0, 0 };
        swept_result r = k == 2 ? sweep(&q, way, &p, 0, least)
                                : sweep(&p, way, &q, 0, least);
        ck_assert_int_eq(r.status, SWEPT_OVERLAP);
        ck_assert(vec3_is_finite(r.normal) && vec3_is_finite(r.on_a));
        ck_assert(vec3_is_finite(r.on_b) && r.time == 0);
    }
}
END_TEST

// ---- what it costs

// Over 30,000 random ways, and the grazing ones, which are the slowest: each
// step halves what a ball that only just touches has left to go.
// Rejects: bounds that are too timid.
START_TEST(few_distances_are_asked_for)
{
    unsigned long long seed = 29;
    long asked = 0;
    int most = 0, most_grazing = 0;
    for (int n = 0; n < 30000; n++) {
        static body a, b;
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        swept_result r = sweep(&a, way, &b, n % 2 ? 0.1 : 0, fine);
        asked += r.iterations;
        most = r.iterations > most ? r.iterations : most;
        ck_assert_int_ge(r.supports, r.iterations);
    }
    for (int n = 0; n < 3000; n++) {
        real gap = (n % 3 - 1) * 1e-15 * exp2(random_fraction(&seed) * 40);
        body p = body_point(-1.2, 0.5 + gap, 0), q = body_point(0, 0, 0);
        swept_result r = sweep(&p, (vec3){ 3 * random_fraction(&seed), 0, 0 },
                               &q, 0.5, 1e-15);
        ck_assert_int_ne(r.status, SWEPT_CAPPED);
        most_grazing = r.iterations > most_grazing ? r.iterations
                                                   : most_grazing;
    }
    ck_assert_msg(asked <= 3 * 30000L, "%ld distances", asked);
    ck_assert_msg(most <= 10, "%d distances", most);
    ck_assert_msg(most_grazing <= 32, "%d distances", most_grazing);
}
END_TEST

// ---- the same bits

// The number was printed by this test itself; gcc and clang agree on it at -O0,
// -O2 and -O3.  A change of it is a change of answers.
static const unsigned long long known_digest = 0xeddbd999f85c9de1ULL;

static unsigned long long digest(unsigned long long h, const swept_result *r)
{
    const real part[] = { r->time, r->normal.x, r->normal.y, r->normal.z,
                          r->on_a.x, r->on_a.y, r->on_b.y, r->on_b.z };
    unsigned char bytes[sizeof part];
    memcpy(bytes, part, sizeof part);
    for (size_t i = 0; i < sizeof part; i++)
        h = (h ^ bytes[i]) * 1099511628211ULL;
    return h + (unsigned long long)r->status;
}

START_TEST(the_same_bits_everywhere)
{
    unsigned long long seed = 31, h = 0;
    for (int n = 0; n < 3000; n++) {
        static body a, b;
        vec3 way;
        random_case(n, &seed, &a, &b, &way);
        swept_result r = sweep(&a, way, &b, 0.0625, fine);
        h = digest(h, &r);
    }
    ck_assert_msg(h == known_digest, "the digest is 0x%llxULL", h);
}
END_TEST

// Half a rod of 1 m, .5 m above a plate: its end is down after sin = .5, 30 degrees
// of 90.  Either way round, and when the plate turns with the rod.
// Rejects: bodies that go straight; a turn by the other hand; a bound on the speed
// that leaves turning out.
START_TEST(end_of_a_rod_that_turns_meets_the_plate)
{
    vec3 rod[2], plate[8], scratch[10];
    rod[0] = vec3_make(-1, .5, 0);
    rod[1] = vec3_make(1, .5, 0);
    for (int i = 0; i < 8; i++)
        plate[i] = vec3_make(i & 1 ? 5 : -5, i & 2 ? 0 : -1, i & 4 ? 5 : -5);
    const swept_motion stays = { .out = 0 };
    for (int sign = -1; sign < 2; sign += 2) {
        swept_motion turns = { .center = { 0, .5, 0 }, .out = 1,
                               .turn = { 0, 0, sign * acos(0) } };
        swept_result r = swept_turning((hull){ rod, 2 }, &turns,
                                       (hull){ plate, 8 }, &stays, 0, 1e-9,
                                       scratch);
        ck_assert_int_eq(r.status, SWEPT_TOUCHES);
        near(r.time, 1 / 3., 1e-8, "30 of 90 degrees");
        near(r.normal.y, 1, 1e-9, "normal");
        turns.turn.z = sign * acos(0) * 29 / 90;
        r = swept_turning((hull){ rod, 2 }, &turns, (hull){ plate, 8 }, &stays, 0,
                          1e-9, scratch);
        ck_assert_int_eq(r.status, SWEPT_PASSES);
    }
}
END_TEST

// Points of a hull keep their distances and come where sine and cosine say, however
// far it turns.  Rejects: the series alone, which is good to three radians.
START_TEST(hull_turns_about_its_centre_as_a_sine_says)
{
    const vec3 at[2] = { { 6, 5, 7 }, { 5, 5, 7 } };
    vec3 out[2];
    for (real by = -3; by < 3.1; by += .5) {
        swept_motion m = { .center = { 5, 5, 5 }, .delta = { 8, 0, 0 },
                           .turn = { 0, 0, by } };
        swept_place((hull){ at, 2 }, &m, .5, out);
        near(out[0].x, 9 + cos(by / 2), 1e-9, "along x");
        near(out[0].y, 5 + sin(by / 2), 1e-9, "along y");
        near(out[1].x, 9, 1e-12, "what lies on the axis stays on it");
        swept_place((hull){ at, 2 }, &m, 1, out);
        near(out[0].y, 5 + sin(by), 1e-8, "at the end");
    }
    for (real by = 3.5; by < 1000; by *= 1.5) {
        swept_motion m = { .center = { 5, 5, 5 }, .turn = { 0, 0, by } };
        swept_place((hull){ at, 2 }, &m, 1, out);
        near(out[0].x, 5 + cos(by), 1e-8, "far along x");
        near(out[0].y, 5 + sin(by), 1e-8, "far along y");
    }
}
END_TEST

// Rods that fly and turn at random: at 40 moments before they are said to touch, and
// at all moments if they pass, there is a gap.
START_TEST(nobody_who_turns_has_touched_before)
{
    unsigned long long seed = 5;
    int touches = 0;
    for (int n = 0; n < 400; n++) {
        vec3 at[2][3], scratch[6];
        swept_motion m[2];
        for (int k = 0; k < 2; k++) {
            m[k] = (swept_motion){ .center = vec3_make(1.5 * k, 0, 0), .out = 0,
                                   .delta = vec3_make(1 - 2 * k, 0, 0),
                                   .turn = random_vec3(&seed, 1.5) };
            for (int i = 0; i < 3; i++) {
                vec3 r = random_vec3(&seed, .7);
                at[k][i] = vec3_add(m[k].center, r);
                m[k].out = real_max(m[k].out, vec3_length(r));
            }
        }
        const hull a = { at[0], 3 }, b = { at[1], 3 };
        swept_result r = swept_turning(a, &m[0], b, &m[1], 0, 1e-6, scratch);
        if (r.status == SWEPT_OVERLAP || r.status == SWEPT_CAPPED) continue;
        touches += r.status == SWEPT_TOUCHES;
        real end = r.status == SWEPT_TOUCHES ? r.time : 1;
        for (int k = 0; k < 40; k++) {
            vec3 x[3], y[3];
            simplex last = { .count = 0 };
            swept_place(a, &m[0], end * k / 40, x);
            swept_place(b, &m[1], end * k / 40, y);
            gjk_result g = gjk_distance((hull){ x, 3 }, (hull){ y, 3 }, HUGE_VAL,
                                        &last);
            ck_assert_msg(g.distance > 0, "%d: they overlap at %g", n, end * k / 40);
        }
    }
    ck_assert_int_gt(touches, 100);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        point_meets_plate_at_an_angle,
        apart_is_a_distance_to_be_kept,
        cubes_meet_face_edge_and_corner_on,
        crossing_edges_meet_where_they_cross,
        balls_meet_where_the_quadratic_says,
        balls_of_points_meet_tip_to_tip,
        whoever_passes_beside_or_turns_away_passes,
        a_graze_of_a_billionth_passes_and_a_clip_touches,
        a_corner_is_passed_or_met_at_every_angle,
        nothing_flat_is_ever_crossed,
        random_ways_agree_with_the_clipped_way,
        ways_past_flat_and_thin_agree_with_the_least_distance,
        the_further_to_keep_apart_the_sooner_they_touch,
        far_from_the_origin_nothing_more_is_lost,
        size_does_not_matter,
        swapped_roles_give_the_mirror_image,
        at_the_start_there_may_be_nothing_left_to_find,
        what_is_not_finite_gets_a_status,
        what_is_beyond_measure_gets_a_status,
        smallest_numbers_give_no_nan,
        few_distances_are_asked_for,
        end_of_a_rod_that_turns_meets_the_plate,
        hull_turns_about_its_centre_as_a_sine_says,
        nobody_who_turns_has_touched_before,
        bits_are_ours() ? the_same_bits_everywhere : NULL,
        NULL
    };
    return suite_run((suite){ .name = "swept", .tests = tests, .seconds = 60 });
}
