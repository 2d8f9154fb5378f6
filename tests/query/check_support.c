// check_support.c - tests of lib/support: the furthest vertex, either way.

#include "bodies.h"
#include "points.h"

#include <check.h>
#include <stdlib.h>

// A dozen roundings of coordinates up to 4, 4.4e-16 each at most.
static const real rounding = 5e-15;

static void near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static real height(const body *b, int i, vec3 d)
{
    return vec3_dot(d, vec3_sub(b->at[i], b->at[0]));
}

// Two balls of points, turned anyhow, one beside the other.
static void two_balls(body *a, body *b, int level, unsigned long long *seed)
{
    body_icosphere(a, level, 0.5);
    *b = *a;
    body_turn(a, seed);
    body_turn(b, seed);
    body_move(b, random_vector(seed, 0.9, 1.2));
}

// ---- the scan

START_TEST(support_is_the_furthest_and_the_lowest_of_equals)
{
    body c = body_cube(0, 0, 0);
    point_set p = body_points(&c);
    ck_assert_int_eq(support_scan(p, (vec3){ 1, 1, 1 }), 7);
    ck_assert_int_eq(support_scan(p, (vec3){ -1, -1, -1 }), 0);
    ck_assert_int_eq(support_scan(p, (vec3){ 0, 0, 1 }), 4);
    ck_assert_int_eq(support_scan(p, (vec3){ 0, 0, 0 }), 0);
}
END_TEST

// A cube of side 1 so far out that its heights from the world's origin differ
// by less than their rounding.  Rejects: heights from there.
START_TEST(far_out_no_digit_is_lost)
{
    body c = body_cube(0x1p40, 0, 0);
    point_set p = body_points(&c);
    ck_assert_int_eq(support_scan(p, (vec3){ 1, 0x1p-20, 0x1p-30 }), 7);
    ck_assert_int_eq(support_scan(p, (vec3){ -1, -0x1p-20, -0x1p-30 }), 0);
}
END_TEST

// What stands behind the last point is no number.  Rejects: one point too many,
// and the last point left out.
START_TEST(a_set_ends_where_it_ends)
{
    for (int count = 1; count < 20; count++) {
        vec3 *at = malloc((size_t)count * sizeof *at);
        ck_assert(at != NULL);
        for (int i = 0; i < count; i++) at[i] = (vec3){ i, 0, -i };
        point_set p = { at, count, NULL, NULL };
        ck_assert_int_eq(support_scan(p, (vec3){ 1, 0, 0 }), count - 1);
        ck_assert_int_eq(support_scan(p, (vec3){ 0, 0, 1 }), 0);
        free(at);
    }
    vec3 two[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { nan(""), 0, 0 } };
    point_set p = { two, 2, NULL, NULL };
    ck_assert_int_eq(support_scan(p, (vec3){ 1, 0, 0 }), 1);
}
END_TEST

// Rejects: a NaN that loses every comparison and leaves no trace.
START_TEST(what_is_not_finite_is_told)
{
    const real bad[] = { nan(""), HUGE_VAL, -HUGE_VAL };
    for (int n = 0; n < 3 * 8 * 3; n++) {
        body c = body_cube(0, 0, 0), sound = body_cube(3, 0, 0);
        vec3 *v = &c.at[n / 3 % 8], d = { 1, 2, 3 };
        *(n / 24 == 0 ? &v->x : n / 24 == 1 ? &v->y : &v->z) = bad[n % 3];
        point_set p = body_points(&c), q = body_points(&sound);
        ck_assert_int_eq(support_scan(p, d), -1);
        ck_assert_int_eq(support_scan_both(&p, &q, d).a, -1);
        ck_assert_int_eq(support_scan_both(&q, &p, d).b, -1);
    }
}
END_TEST

// ---- the climb

START_TEST(climbing_finds_what_scanning_finds)
{
    unsigned long long seed = 23;
    for (int level = 1; level <= 3; level++) {
        static body b;
        body_icosphere(&b, level, 0.5);
        body_turn(&b, &seed);
        body_move(&b, (vec3){ 100, -200, 300 });
        point_set p = body_points(&b);
        for (int n = 0; n < 3000; n++) {
            vec3 d = random_direction(&seed);
            int from = (int)(b.count * random_unit(&seed));
            int scanned = support_scan(p, d);
            int climbed = support_climb(p, d, from);
            near(height(&b, climbed, d), height(&b, scanned, d), 0);
        }
    }
}
END_TEST

// A grid on each face of a cube: plateaus of level neighbours everywhere.
// Rejects: a climb that takes the middle of the lowest side for the top.
START_TEST(climbing_crosses_plateaus)
{
    enum { SIDE = 5, COUNT = SIDE * SIDE * SIDE };
    vec3 at[COUNT];
    int start[COUNT + 1], ring[COUNT * 26], count = 0, used = 0;
    for (int i = 0; i < COUNT; i++) {
        int x = i % SIDE, y = i / SIDE % SIDE, z = i / SIDE / SIDE;
        int rim = x % (SIDE-1) == 0 || y % (SIDE-1) == 0 || z % (SIDE-1) == 0;
        if (rim) at[count++] = (vec3){ x, y, z };
    }
    for (int i = 0; i < count; i++) {
        start[i] = used;
        for (int j = 0; j < count; j++) {
            vec3 d = vec3_sub(at[i], at[j]);
            if (i != j && fabs(d.x) <= 1 && fabs(d.y) <= 1 && fabs(d.z) <= 1)
                ring[used++] = j;
        }
    }
    start[count] = used;
    point_set p = { at, count, start, ring };
    unsigned long long seed = 29;
    for (int n = 0; n < 3000; n++) {
        vec3 d = random_direction(&seed);
        if (n % 3 == 1) d.x = 0;
        if (n % 3 == 2) d.x = d.z = 0;
        int climbed = support_climb(p, d, (int)(count * random_unit(&seed)));
        near(vec3_dot(d, at[climbed]), vec3_dot(d, at[support_scan(p, d)]),
             rounding);
    }
}
END_TEST

// The point opposite the answer is no number, and a climb that starts beside the
// answer does not pass there.  Rejects: a climb that is a scan.
START_TEST(a_climb_looks_only_where_it_passes)
{
    unsigned long long seed = 31;
    for (int n = 0; n < 100; n++) {
        static body b;
        body_icosphere(&b, 3, 0.5);
        point_set p = body_points(&b);
        vec3 d = random_direction(&seed);
        int top = support_scan(p, d);
        int opposite = support_scan(p, vec3_scale(-1, d));
        if (opposite == 0) continue;        // heights are measured from it
        b.at[opposite].x = nan("");
        ck_assert_int_eq(support_scan(p, d), -1);
        for (int k = p.ring_start[top]; k < p.ring_start[top + 1]; k++)
            ck_assert_int_eq(support_climb(p, d, p.ring[k]), top);
    }
}
END_TEST

// A mesh of which every vertex but one has a higher neighbour: each is met.
START_TEST(climbing_may_visit_every_vertex)
{
    enum { N = 60 };
    vec3 at[N];
    int start[N + 1], ring[2 * N], filled = 0;
    for (int i = 0; i < N; i++) {
        at[i] = (vec3){ i, i * i, 0 };
        start[i] = filled;
        if (i > 0) ring[filled++] = i - 1;
        if (i + 1 < N) ring[filled++] = i + 1;
    }
    start[N] = filled;
    point_set p = { at, N, start, ring };
    ck_assert_int_eq(support_climb(p, (vec3){ 1, 0, 0 }, 0), N - 1);
    ck_assert_int_eq(support_climb(p, (vec3){ -1, 0, 0 }, N - 1), 0);
}
END_TEST

// ---- which of them, and two at once

// Rejects: one of them too many, or a climb without a ring.
START_TEST(forty_eight_points_are_scanned)
{
    vec3 at[1] = { { 0, 0, 0 } };
    int ring[2] = { 0, 0 };
    ck_assert(!support_climbs((point_set){ at, 48, ring, ring }));
    ck_assert(support_climbs((point_set){ at, 49, ring, ring }));
    ck_assert(!support_climbs((point_set){ at, 642, NULL, NULL }));
}
END_TEST

// With a ring, without, and with one on either side: always the same heights.
// Rejects: d for A's and B's vertex alike, and A's vertex given for B's.
START_TEST(two_at_once_are_as_high_as_each_alone)
{
    unsigned long long seed = 43;
    static body a, b;
    for (int n = 0; n < 600; n++) {
        if (n % 50 == 0) two_balls(&a, &b, 1 + n / 50 % 3, &seed);
        vec3 d = random_direction(&seed), back = vec3_scale(-1, d);
        a.has_ring = n % 2;
        b.has_ring = n / 2 % 2;
        point_set p = body_points(&a), q = body_points(&b);
        int climbs = support_climbs(p) || support_climbs(q);
        vertex_pair from = { n % a.count, (7 * n) % b.count };
        vertex_pair both = support_both(&p, &q, d, from, n / 4 % 2 && !climbs);
        near(height(&a, both.a, d), height(&a, support_scan(p, d), d),
             rounding);
        near(height(&b, both.b, d), height(&b, support_scan(q, back), d),
             rounding);
        ck_assert_int_eq(support_point(p, d, from.a), support_climbs(p)
                         ? support_climb(p, d, from.a) : support_scan(p, d));
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("support");
    TCase *t = tcase_create("support");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, support_is_the_furthest_and_the_lowest_of_equals);
    tcase_add_test(t, far_out_no_digit_is_lost);
    tcase_add_test(t, a_set_ends_where_it_ends);
    tcase_add_test(t, what_is_not_finite_is_told);
    tcase_add_test(t, climbing_finds_what_scanning_finds);
    tcase_add_test(t, climbing_crosses_plateaus);
    tcase_add_test(t, a_climb_looks_only_where_it_passes);
    tcase_add_test(t, climbing_may_visit_every_vertex);
    tcase_add_test(t, forty_eight_points_are_scanned);
    tcase_add_test(t, two_at_once_are_as_high_as_each_alone);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
