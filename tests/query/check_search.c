// check_search.c - tests of lib/query/search: the quick answers are those of
// chapter 4, which has its own tests.

#include "bodies.h"
#include "expect.h"
#include "hit_face.h"
#include "random.h"
#include "search.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stddef.h>

// Of the distance, and of coordinates and sizes: gjk_distance's relative 1e-13 of the
// squared distance, and some dozens of roundings.
static const real ALIKE = 1e-12, ROUNDING = 1e-14;

static hull_mesh bare(const body *b)
{
    return hull_bare(body_hull(b));
}

static gjk_result nearest(const body *a, const body *b, simplex *carried)
{
    const hull_mesh ha = bare(a), hb = bare(b);
    return search_nearest(&ha, &hb, HUGE_VAL, carried);
}

static bool apart(const body *a, const body *b, real margin,
                  separating_axis *axis)
{
    const hull_mesh ha = bare(a), hb = bare(b);
    return search_apart(&ha, &hb, margin, axis);
}

static real reach(const body *a, const body *b)
{
    real most = 0;
    for (int i = 0; i < a->count; i++)
        most = fmax(most, vec3_length(a->at[i]));
    for (int i = 0; i < b->count; i++)
        most = fmax(most, vec3_length(b->at[i]));
    return most;
}

// The same status, if more than rounding parts them, value, and points that lie in the bodies that far apart.
static void same_answer(const body *a, const body *b, const gjk_result *fast,
                        const gjk_result *plain)
{
    real fine = ALIKE * plain->distance + ROUNDING * reach(a, b);
    real finest = ALIKE * plain->distance + ROUNDING * pair_size(a, b);
    vec3 on_b = { 0, 0, 0 };
    if (fast->distance > finest || plain->distance > finest)
        ck_assert_int_eq(fast->status, plain->status);
    if (fast->status != GJK_APART || plain->status != GJK_APART) return;
    near(fast->distance, plain->distance, finest);
    near(vec3_length(fast->axis), plain->distance, fine);
    for (int k = 0; k < fast->last.count; k++) {
        ck_assert(fast->last.weight[k] > 0);
        on_b = vec3_add_scaled(on_b, fast->last.weight[k],
                               b->at[fast->last.of[k].b]);
    }
    near_vec3(on_b, fast->on_b, fine);
    near_vec3(vec3_sub(fast->on_a, fast->on_b), fast->axis, fine);
}

// A pair of any kind and place: near or far, near the origin or not, small or
// large.
static void any_pair(body *a, body *b, int n, unsigned long long *seed)
{
    const real from[4] = { 0.3, 1, 1.5, 2 };
    pair_any(a, b, n, 5, from[n / 25 % 4], from[n / 25 % 4] + 0.5, seed);
    if (n / 100 % 4 == 1) pair_move(a, b, random_vector(seed, 1e6, 1e6));
    if (n / 100 % 4 == 2) pair_scale(a, b, 1e-20);
    if (n / 100 % 4 == 3) pair_scale(a, b, 1e20);
}

// Rejects: an end that is not proved; a sliver's weights; an inside that is not.
START_TEST(quick_answers_are_those_of_chapter_4)
{
    unsigned long long seed = 5;
    int outside = 0, inside = 0;
    for (int n = 0; n < 20000; n++) {
        body a, b;
        any_pair(&a, &b, n, &seed);
        gjk_result plain = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                        NULL);
        gjk_result fast = nearest(&a, &b, NULL);
        same_answer(&a, &b, &fast, &plain);
        outside += plain.status == GJK_APART;
        inside += plain.status == GJK_OVERLAP;
    }
    ck_assert_int_gt(outside, 5000);
    ck_assert_int_gt(inside, 2000);
}
END_TEST

// Rejects: a carried simplex of which one side, or the base, is never tried.
START_TEST(carried_answers_are_those_of_chapter_4)
{
    unsigned long long seed = 6;
    for (int n = 0; n < 400; n++) {
        body a, b;
        simplex carried = { .count = 0 };
        any_pair(&a, &b, n, &seed);
        vec3 step = vec3_scale(0.1 * pair_size(&a, &b),
                               random_direction(&seed));
        for (int k = 0; k < 20; k++) {
            gjk_result plain = gjk_distance(body_hull(&a), body_hull(&b),
                                            HUGE_VAL, NULL);
            gjk_result fast = nearest(&a, &b, &carried);
            same_answer(&a, &b, &fast, &plain);
            body_move(&b, step);
        }
    }
}
END_TEST

// Rejects: apart where the guess was right once, or by a bound that rounding
// made; a margin that is forgotten.
START_TEST(apart_is_what_the_distance_says)
{
    unsigned long long seed = 7;
    int yes = 0;
    for (int n = 0; n < 10000; n++) {
        body a, b;
        any_pair(&a, &b, n, &seed);
        gjk_result g = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                    NULL);
        const real part[4] = { 0, 0.5, 1 - 1e-6, 1 + 1e-6 };
        separating_axis axis = { random_direction(&seed), -1, -1 };
        if (n % 3 == 0) axis = (separating_axis){ .a = 0 };
        for (int k = 0; k < 4; k++) {
            real margin = part[k] * g.distance;
            bool is_apart = g.status == GJK_APART && k < 3;
            ck_assert_int_eq(apart(&a, &b, margin, &axis),
                             is_apart);
            if (!is_apart) continue;
            corner w = hull_support(body_hull(&a), body_hull(&b),
                                    vec3_scale(-1, axis.axis));
            real by = vec3_dot(axis.axis, w.at) / vec3_length(axis.axis);
            ck_assert(by > margin * (1 - ALIKE));
            yes++;
        }
    }
    ck_assert_int_gt(yes, 5000);
}
END_TEST

// A cube's side is a metre, and its corners are on the lattice: what is between
// two is exact.  Rejects: a plane that rounding alone puts between two bodies.
START_TEST(a_last_bit_between_two_cubes_is_a_gap_and_none_is_none)
{
    separating_axis axis[3] = { { { -1, 0, 0 }, 3, 4 }, { .a = 0 },
                                { { -1, 0.1, 0.2 }, -1, -1 } };
    for (int k = 0; k < 3; k++) {
        body a = body_cube(0, 0, 0), b = body_cube(1, 0, 0);
        ck_assert(!apart(&a, &b, 0, &axis[k]));
        body c = body_cube(1 + 0x1p-30, 0.25, 0);
        ck_assert(apart(&a, &c, 0, &axis[k]));
        ck_assert(!apart(&a, &c, 0x1p-30, &axis[k]));
    }
}
END_TEST

// The vertices p and q - r / 2, q + r / 2 of two bodies stand in one point, which
// all numbers name exactly, a kilometre away.  Rejects: a plane between the
// bodies that rounding made.
START_TEST(a_corner_in_the_middle_of_an_edge_touches_it)
{
    unsigned long long seed = 9;
    for (int n = 0; n < 2000; n++) {
        vec3 p = { 1000 + n, 500, -700 }, half = random_vector(&seed, 0.5, 1);
        half = vec3_make(rint(half.x * 0x1p20) * 0x1p-20,
                         rint(half.y * 0x1p20) * 0x1p-20,
                         rint(half.z * 0x1p20) * 0x1p-20);
        vec3 up = vec3_unit(vec3_cross(half, random_direction(&seed)));
        vec3 a[2] = { p, vec3_add(p, up) };
        vec3 b[3] = { vec3_add(p, half), vec3_sub(p, half), vec3_sub(p, up) };
        hull_mesh ha = hull_bare((hull){ a, 2 }), hb = hull_bare((hull){ b, 3 });
        separating_axis axis = { up, -1, -1 };
        ck_assert(!search_apart(&ha, &hb, 0, &axis));
    }
}
END_TEST

// Rejects: a climb that is believed, though it ended in front of a dent.
START_TEST(a_climb_that_ends_at_a_dent_is_not_believed)
{
    unsigned long long seed = 8;
    struct mesh m;
    ck_assert(table_mesh(&m, TABLE_FOOT).ok);
    for (int n = 0; n < 200; n++) {
        body uneven;
        vec3 fly = random_vector(&seed, 0.1, 0.2);
        body_table(&uneven, TABLE_FOOT, 1e-9, &seed);
        fly.z = 0.1;
        hull table = body_hull(&uneven), point = { &fly, 1 };
        hull_mesh a = hull_bare(point), b = hull_bare(table);
        b.mesh = &m;
        gjk_result plain = gjk_distance(point, table, HUGE_VAL, NULL);
        gjk_result fast = search_nearest(&a, &b, HUGE_VAL, NULL);
        near(fast.distance, plain.distance, 1e-14);
        separating_axis axis = { plain.axis, 0, 0 };
        ck_assert(search_apart(&a, &b, plain.distance * (1 - 1e-11), &axis));
        ck_assert(!search_apart(&a, &b, plain.distance * (1 + 1e-11), &axis));
    }
    mesh_free(&m);
}
END_TEST

// Tables that are flat, uneven, or a dome, and any other body: the vertices that
// are carried may be any, on the far side, too.  Rejects: the end of a climb as
// the highest vertex; a plane believed because it parted the bodies once.  The mean of some vertices is in the
// plane of the top, or below.
static void expect_axes(int foot, int *yes, int *no)
{
    const real rough[3] = { 0, 1e-9, -1 }, place[3] = { 0, 0, 1e5 };
    unsigned long long seed = 12;
    struct mesh m;
    ck_assert(table_mesh(&m, foot).ok);
    for (int n = 0; n < 3000; n++) {
        body a, b;
        body_table(&a, foot, rough[n % 3], &seed);
        body_any(&b, n % 5, &seed);
        body_move(&b, random_vector(&seed, 1, 4));
        pair_turn(&a, &b, &seed);
        pair_move(&a, &b, random_vector(&seed, place[n / 3 % 3], 1));
        hull_mesh ha = hull_bare(body_hull(&a)), hb = hull_bare(body_hull(&b));
        ha.mesh = &m;
        gjk_result g = gjk_distance(ha.hull, hb.hull, HUGE_VAL, NULL);
        vec3 axis = vec3_add_scaled(g.axis, n % 4 * 1e-3, random_direction(&seed));
        if (n % 4 == 1) axis = random_direction(&seed);
        if (n % 4 == 3) axis = vec3_cross(vec3_sub(a.at[2], a.at[1]),
                                          vec3_sub(a.at[9], a.at[1]));
        const real part[4] = { 0, 0.5, 1 - 1e-6, 1 + 1e-6 };
        for (int k = 0; k < 4; k++) {
            separating_axis carried = { axis, random_below(&seed, a.count),
                                        random_below(&seed, b.count) };
            bool is_apart = g.status == GJK_APART && k < 3;
            ck_assert_int_eq(search_apart(&ha, &hb, part[k] * g.distance,
                                          &carried), is_apart);
            *yes += is_apart, *no += !is_apart;
        }
    }
    mesh_free(&m);
}

START_TEST(a_carried_axis_and_any_vertices_prove_nothing_false)
{
    int yes = 0, no = 0;
    expect_axes(TABLE_FOOT, &yes, &no);
    expect_axes(0, &yes, &no);
    ck_assert_int_gt(yes, 5000);
    ck_assert_int_gt(no, 5000);
}
END_TEST

// Rejects: the same where EPA believes the end of a climb.
START_TEST(many_vertices_are_as_deep_as_if_all_were_looked_at)
{
    const real rough[3] = { 0, 1e-9, -1 };
    unsigned long long seed = 13;
    struct mesh m;
    int deep = 0;
    ck_assert(table_mesh(&m, TABLE_FOOT).ok);
    for (int n = 0; n < 3000; n++) {
        body a, b;
        body_table(&a, TABLE_FOOT, rough[n % 3], &seed);
        body_any(&b, n % 4, &seed);
        body_move(&b, random_vector(&seed, 1, 3));
        pair_turn(&a, &b, &seed);
        hull_mesh ha = hull_bare(body_hull(&a)), hb = hull_bare(body_hull(&b));
        ha.mesh = &m;
        gjk_result g = gjk_distance(ha.hull, hb.hull, 0, NULL);
        if (g.status != GJK_OVERLAP) continue;
        hit_result all = hit_face_find(ha.hull, hb.hull, &g.last);
        hit_result few = hit_face_climb(&ha, &hb, &g.last);
        ck_assert_int_eq(few.status, all.status);
        near(few.depth, all.depth, 1e-13 * pair_size(&a, &b));
        corner w = hull_support(ha.hull, hb.hull, vec3_scale(-1, few.normal));
        near(-vec3_dot(few.normal, w.at), few.depth,
             1e-13 * pair_size(&a, &b));
        deep++;
    }
    mesh_free(&m);
    ck_assert_int_gt(deep, 1000);
}
END_TEST

// Rejects: an inside of a tetrahedron that has none.
START_TEST(squares_in_one_plane_answer_as_in_chapter_4)
{
    unsigned long long seed = 10;
    for (int n = 0; n < 2000; n++) {
        body a, b;
        body_square(&a);
        body_square(&b);
        vec3 by = random_vector(&seed, 0.2, 1.5);
        by.z = 0;
        body_move(&b, by);
        pair_turn(&a, &b, &seed);
        gjk_result plain = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                        NULL);
        gjk_result fast = nearest(&a, &b, NULL);
        same_answer(&a, &b, &fast, &plain);
    }
}
END_TEST

// Two cubes apart, turned anyhow.  Rejects: a search that begins with one corner,
// and takes as many rounds as chapter 4's.
START_TEST(two_vertices_of_each_body_spare_the_first_rounds)
{
    unsigned long long seed = 11;
    int rounds = 0, plain = 0;
    for (int n = 0; n < 1000; n++) {
        body a = body_cube(0, 0, 0), b = body_cube(0, 0, 0);
        body_turn(&b, &seed);
        body_move(&b, vec3_scale(2.2, random_direction(&seed)));
        pair_turn(&a, &b, &seed);
        rounds += nearest(&a, &b, NULL).iterations;
        plain += gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                              NULL).iterations;
    }
    ck_assert_msg(3 * rounds < 2 * plain, "%d rounds, and chapter 4 takes %d",
                  rounds, plain);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        quick_answers_are_those_of_chapter_4,
        carried_answers_are_those_of_chapter_4,
        apart_is_what_the_distance_says,
        a_last_bit_between_two_cubes_is_a_gap_and_none_is_none,
        a_corner_in_the_middle_of_an_edge_touches_it,
        a_climb_that_ends_at_a_dent_is_not_believed,
        a_carried_axis_and_any_vertices_prove_nothing_false,
        many_vertices_are_as_deep_as_if_all_were_looked_at,
        squares_in_one_plane_answer_as_in_chapter_4,
        two_vertices_of_each_body_spare_the_first_rounds,
        NULL
    };
    return suite_run((suite){ .name = "search", .tests = tests });
}
