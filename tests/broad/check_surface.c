// check_surface.c - tests of lib/broad/surface: which triangles are where?

#include "surface.h"
#include "rigid4.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 24, POINTS = N * N, MOST = 2 * POINTS };

static vec3 point[POINTS];
static int triangle[MOST][3];
static int triangles;
static surface s;

// A rough square of N x N points, 2 m wide, from -1 to 1.
static void rough(void)
{
    unsigned long long r = 5;
    triangles = 0;
    for (int k = 0; k < POINTS; k++) {
        point[k] = vec3_make(2.0 * (k % N) / (N - 1) - 1,
                             0.05 * random_real(&r),
                             2.0 * (k / N) / (N - 1) - 1);
        if (k % N == N - 1 || k / N == N - 1) continue;
        int two[2][3] = { { k, k + N, k + N + 1 }, { k, k + N + 1, k + 1 } };
        memcpy(triangle[triangles], two, sizeof two);
        triangles += 2;
    }
    status done = surface_make(&s, point, POINTS, (const int (*)[3])triangle,
                               triangles, vec3_make(0, 0, 0), 0.05);
    ck_assert_msg(done.ok, "%s", done.why);
}

static void gone(void)
{
    surface_free(&s);
}

// --- the tree ----------------------------------------------------------------

typedef struct {
    bool is_met[MOST];
    int  count;
} list;

static real note(void *context, int k)
{
    list *l = context;
    ck_assert(!l->is_met[k]);
    l->is_met[k] = true;
    l->count++;
    return 1;
}

// Samples of the way: is a corner of the prism in the box then?
static bool has_corner(int k, const surface_query *q)
{
    vec3 at[PRISM_CORNERS];
    surface_prism(&s, k, at);
    for (int t = 0; t <= 50; t++)
        for (int i = 0; i < PRISM_CORNERS; i++) {
            vec3 x = vec3_add_scaled(at[i], -t / 50.0, q->delta);
            vec3 a = vec3_sub(x, q->thing.low), b = vec3_sub(q->thing.high, x);
            if (a.x >= 0 && a.y >= 0 && a.z >= 0 && b.x >= 0 && b.y >= 0
                && b.z >= 0) return true;
        }
    return false;
}

// Rejects: a leaf that is left out, an axis without a way that is not looked at.
START_TEST(no_triangle_in_the_way_is_left_out)
{
    unsigned long long r = 9;
    int all = 0;
    for (int k = 0; k < 300; k++) {
        list l = { { false }, 0 };
        vec3 x = { random_real(&r), 0.2 * random_real(&r), random_real(&r) };
        real size = 0.1 * random_fraction(&r);
        surface_query q = { .thing = { vec3_sub(x, vec3_make(size, size, size)),
                                       vec3_add(x, vec3_make(size, size, size)) },
                            .most = 1, .meets = note, .context = &l };
        if (k % 3) q.delta = vec3_make(random_real(&r), 0, random_real(&r));
        if (k % 3 == 2) q.delta.y = random_real(&r);
        surface_visit(&s, &q);
        for (int t = 0; t < triangles; t++)
            ck_assert(l.is_met[t] || !has_corner(t, &q));
        all += l.count;
    }
    // A tree that answers with everything would be right, and useless.
    ck_assert_int_lt(all, 300 * triangles / 8);
}
END_TEST

static real measure(void *context, int k)
{
    real *least = context;
    vec3 at[PRISM_CORNERS];
    surface_prism(&s, k, at);
    for (int i = 0; i < PRISM_CORNERS; i++)
        *least = real_min(*least, vec3_distance(at[i], vec3_make(0.3, 1, 0.1)));
    return *least;
}

// Rejects: a box that is left out, though something in it is nearer than what
// was found; `most` that is not taken over.
START_TEST(what_is_nearest_is_found_by_distance)
{
    real least = HUGE_VAL, wanted = HUGE_VAL;
    vec3 x = { 0.3, 1, 0.1 };
    surface_query q = { .thing = { x, x }, .by_distance = true,
                        .most = HUGE_VAL, .meets = measure, .context = &least };
    surface_visit(&s, &q);
    for (int t = 0; t < triangles; t++) measure(&wanted, t);
    ck_assert(least == wanted);
}
END_TEST

// --- ways through it -----------------------------------------------------------

static int entries(vec3 from, vec3 to)
{
    int n = 0;
    for (int t = 0; t < triangles; t++)
        n += surface_entry(&s, t, from, to) <= 1;
    return n;
}

// Points on edges and on corners, and ways that are not straight down.
// Rejects: a way between two triangles; a way through the back.
START_TEST(no_way_goes_through_an_edge)
{
    unsigned long long r = 11;
    for (int k = 0; k < 2000; k++) {
        int a = random_below(&r, triangles), i = random_below(&r, 3);
        const int *v = triangle[a];
        real share = k % 4 ? random_fraction(&r) : 0;
        vec3 x = vec3_add_scaled(point[v[i]], share,
                                 vec3_sub(point[v[(i + 1) % 3]], point[v[i]]));
        if (!(fabs(x.x) < 0.9 && fabs(x.z) < 0.9)) continue;
        vec3 way = { 0.05 * random_real(&r), -1, 0.05 * random_real(&r) };
        vec3 from = vec3_sub(x, way), to = vec3_add(x, way);
        ck_assert_int_ge(entries(from, to), 1);
        ck_assert_int_eq(entries(to, from), 0);
        ck_assert_int_eq(entries(from, vec3_add_scaled(from, 0.5, way)), 0);
    }
}
END_TEST

// Halfway down, over the middle of a flat triangle.
// Rejects: a share that is measured from the wrong end.
START_TEST(the_share_of_the_way_is_where_it_enters)
{
    vec3 p[3] = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 } };
    int v[1][3] = { { 0, 1, 2 } };
    surface one;
    ck_assert(surface_make(&one, p, 3, (const int (*)[3])v, 1,
                           vec3_make(0, 0, 0), 0.1).ok);
    vec3 from = { 0.2, 3, 0.2 }, to = { 0.2, -1, 0.2 };
    ck_assert(surface_entry(&one, 0, from, to) == 0.75);
    plane top = surface_plane(&one, 0), side;
    ck_assert(top.normal.y == 1 && top.offset == 0);
    ck_assert(surface_entry_below(&one, 0, from, to, &side) == HUGE_VAL);
    ck_assert(fabs(surface_entry_below(&one, 0, to, from, &side) - 0.225) < 1e-12);
    ck_assert(side.normal.y == -1 && fabs(side.offset - 0.1) < 1e-12);
    to = vec3_make(0.2, -0.05, 0.2);
    ck_assert(surface_entry_below(&one, 0, to, from, &side) == -1);
    from = vec3_make(-0.3, -0.05, 0.2);
    // Its sides lean in: this one is 1/6 m in where it is 0.1 m deep.
    real in = (0.3 + 1.0 / 12) / 0.5;
    ck_assert(fabs(surface_entry_below(&one, 0, from, to, &side) - in) < 1e-12);
    ck_assert(fabs(side.normal.y / side.normal.x - 1 / 0.6) < 1e-12);
    aabb all = one.prisms.node[1];
    ck_assert(fabs(all.low.y + 0.1) < 1e-9 && fabs(all.high.x - 1) < 1e-9);
    surface_free(&one);
}
END_TEST

// --- prisms --------------------------------------------------------------------

// That of a pyramid without its tip, about the mean of its corners.
// Rejects: a face that looks inside; a height that is not across the face.
START_TEST(the_prism_of_a_triangle_has_its_volume)
{
    for (int k = 0; k < triangles; k += 37) {
        shape made;
        rigid4 body;
        vec3 center, at[PRISM_CORNERS], sum = { 0, 0, 0 };
        surface_prism(&s, k, at);
        ck_assert(surface_shape(&s, k, &made, &center).ok);
        real area = vec3_length(vec3_cross(vec3_sub(at[1], at[0]),
                                           vec3_sub(at[2], at[0]))) / 2;
        real volume = 0;
        for (int f = 0; f < made.mesh.faces; f++) {
            const int *v = &made.face[3 * f];
            volume += vec3_dot(made.at[v[0]], vec3_cross(made.at[v[1]],
                                                         made.at[v[2]])) / 6;
        }
        for (int i = 0; i < PRISM_CORNERS; i++) sum = vec3_add(sum, made.at[i]);
        // A third of the depth, by the areas of both ends and their mean.
        real wanted = 0.05 / 3 * (1 + 0.25 + 0.5) * area;
        ck_assert(fabs(volume / wanted - 1) < 1e-9);
        ck_assert(vec3_length(sum) < 1e-12);
        ck_assert(rigid4_build(&body, &made).ok);
        rigid4_free(&body);
        shape_free(&made);
    }
}
END_TEST

// Two squares that look away from each other, 4 cm apart; one that nothing is
// behind; and two at one place.
// Rejects: a wall that is thicker on its other side than it is.
START_TEST(what_is_solid_ends_halfway_to_what_is_behind)
{
    const real wall[3] = { 0.04, 9, 0 }, wanted[3] = { 0.02, 0.3, 0.003 };
    for (int k = 0; k < 3; k++) {
        vec3 p[8];
        int v[4][3] = { { 0, 1, 2 }, { 1, 3, 2 }, { 4, 6, 5 }, { 5, 6, 7 } };
        surface two;
        for (int i = 0; i < 8; i++)
            p[i] = vec3_make(i & 2 ? 1 : 0, i & 4 ? -wall[k] : 0, i & 1 ? 1 : 0);
        ck_assert(surface_make(&two, p, 8, (const int (*)[3])v, 4,
                               vec3_make(0, 0, 0), 0.3).ok);
        for (int i = 0; i < 4; i++)
            ck_assert_msg(fabs(two.deep[i] - wanted[k]) < 1e-6, "%g, not %g",
                          two.deep[i], wanted[k]);
        surface_free(&two);
    }
}
END_TEST

// Rejects: a slope that is less deep than the flat.
START_TEST(with_a_way_down_the_prisms_stand_side_by_side)
{
    vec3 down = { 0, -0.3, 0 }, at[PRISM_CORNERS];
    surface hill;
    ck_assert(surface_make(&hill, point, POINTS, (const int (*)[3])triangle,
                           triangles, down, 0).ok);
    surface_prism(&hill, 100, at);
    for (int k = 0; k < 3; k++)
        ck_assert(at[k + 3].x == at[k].x && at[k + 3].z == at[k].z
                  && fabs(at[k].y - 0.3 - at[k + 3].y) < 1e-15);
    surface_free(&hill);
}
END_TEST

// --- bad input -------------------------------------------------------------------

static void is_refused(int points, int faces, vec3 down, real thickness,
                       const char *why)
{
    surface bad;
    status done = surface_make(&bad, point, points, (const int (*)[3])triangle,
                               faces, down, thickness);
    ck_assert(!done.ok && bad.points == 0 && !bad.prisms.node);
    ck_assert_msg(strstr(done.why, why) != NULL, "%s", done.why);
}

// Rejects: a tree of nothing, an index that is believed.
START_TEST(bad_surfaces_are_refused)
{
    vec3 none = { 0, 0, 0 }, up = { 0, 1, 0 };
    is_refused(2, 1, none, 1, "2 points");
    is_refused(POINTS, 0, none, 1, "0 triangles");
    is_refused(N, triangles, none, 1, "names point");
    is_refused(POINTS, triangles, none, 1e-9, "too thin");
    is_refused(POINTS, triangles, up, 0, "too thin");
    for (int k = 0; k < POINTS; k++) point[k].x += 1e9;
    is_refused(POINTS, triangles, none, 1, "too small to be");
    point[3].y = HUGE_VAL;
    is_refused(POINTS, triangles, none, 1, "point 3");
}
END_TEST

// Rejects: a prism without a volume.
START_TEST(triangles_without_an_area_are_left_out)
{
    surface few;
    for (int k = 0; k < triangles; k++)
        if (k != 7) triangle[k][1] = triangle[k][0];
    ck_assert(surface_make(&few, point, POINTS, (const int (*)[3])triangle,
                           triangles, vec3_make(0, 0, 0), 0.1).ok);
    ck_assert_int_eq(few.prisms.things, 1);
    ck_assert_int_eq(few.prisms.number[0], 7);
    surface_free(&few);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        no_triangle_in_the_way_is_left_out,
        what_is_nearest_is_found_by_distance,
        no_way_goes_through_an_edge,
        the_share_of_the_way_is_where_it_enters,
        the_prism_of_a_triangle_has_its_volume,
        what_is_solid_ends_halfway_to_what_is_behind,
        with_a_way_down_the_prisms_stand_side_by_side,
        bad_surfaces_are_refused,
        triangles_without_an_area_are_left_out,
        NULL
    };
    return suite_run((suite){ .name = "surface", .tests = tests,
                              .set_up = rough, .tear_down = gone,
                              .seconds = 20 });
}
