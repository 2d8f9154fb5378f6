// check_crossings.c - do the counters of cloth see what a drawing shows?

#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "body.h"
#include "crossings.h"
#include "random.h"
#include "suite.h"

static unsigned long long seed = 5;

static patch triangle(const vec3 at[3], int first)
{
    const int vertex[3] = { 0, 1, 2 };
    return patch_make(at, vertex, first);
}

static solid box;

static void set_up(void)
{
    shape s;
    ck_assert(shape_box(&s, vec3_make(1, 1, 1), 1).ok);
    solid_make(&box, s.at, s.particles, s.face, s.mesh.faces);
    shape_free(&s);
}

// ---- a slow form of the cut: thirteen axes ---------------------------------

// Does the shadow of the triangle on this axis overlap that of the box, which
// stands on the axes about the origin?  Touching is no overlap.  An axis that
// is none, where two were parallel, parts nothing.
static bool shadows_overlap(const vec3 t[3], vec3 half, vec3 axis)
{
    real reach = half.x * fabs(axis.x) + half.y * fabs(axis.y)
               + half.z * fabs(axis.z);
    real a = vec3_dot(t[0], axis), b = vec3_dot(t[1], axis);
    real c = vec3_dot(t[2], axis);
    if (vec3_length_squared(axis) == 0) return true;
    return fmin(a, fmin(b, c)) < reach && fmax(a, fmax(b, c)) > -reach;
}

// They have a point in common unless one of thirteen axes parts them: those of
// the box, the triangle's normal, and what is perpendicular to an axis of the
// box and an edge.
static bool triangle_cuts_box(const vec3 t[3], vec3 half)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int k = 0; k < 3; k++)
        if (!shadows_overlap(t, half, axis[k])) return false;
    vec3 edge[3];
    for (int k = 0; k < 3; k++) edge[k] = vec3_sub(t[(k + 1) % 3], t[k]);
    if (!shadows_overlap(t, half, vec3_cross(edge[0], edge[1]))) return false;
    for (int k = 0; k < 9; k++)
        if (!shadows_overlap(t, half, vec3_cross(axis[k / 3], edge[k % 3])))
            return false;
    return true;
}

// ---- known cases -----------------------------------------------------------

static const vec3 FLAT[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };

// A triangle beside FLAT, and in a unit box about the origin.
static const struct { vec3 t[3]; bool cross, cut; } KNOWN[] = {
    // Through its inside; beside it; above it; parallel to it.
    { { { .2, -1, .2 }, { .2, 1, .2 }, { 2, 1, 2 } }, 1, 1 },
    { { { .8, -1, .8 }, { .8, 1, .8 }, { 2, 1, 2 } }, 0, 0 },
    { { { .2, .1, .2 }, { .2, 1, .2 }, { 2, 1, 2 } }, 0, 1 },
    { { { 0, .1, 0 }, { 1, .1, 0 }, { 0, .1, 1 } }, 0, 1 },
    // An edge of FLAT passes through this one, none of its own through.
    { { { .5, -9, -9 }, { .5, 9, -9 }, { .5, 0, 9 } }, 1, 0 },
    // Near a corner of the box, no vertex in it: cuts it off, or not.
    { { { 1.4, 0, 0 }, { 0, 1.4, 0 }, { 0, 0, 1.4 } }, 0, 1 },
    { { { 1.6, 0, 0 }, { 0, 1.6, 0 }, { 0, 0, 1.6 } }, 0, 0 },
    // On the box's top; a finger above it; a finger below it.
    { { { -9, .5, -9 }, { 9, .5, -9 }, { 0, .5, 9 } }, 0, 0 },
    { { { -9, .51, -9 }, { 9, .51, -9 }, { 0, .51, 9 } }, 0, 0 },
    { { { -9, .49, -9 }, { 9, .49, -9 }, { 0, .49, 9 } }, 0, 1 },
};
enum { KNOWNS = sizeof KNOWN / sizeof *KNOWN };

// The same triangle, beginning at another corner.
static patch turned(const vec3 t[3], int by, int first)
{
    const vec3 at[3] = { t[by % 3], t[(by + 1) % 3], t[(by + 2) % 3] };
    return triangle(at, first);
}

// Rejects: edges of one triangle only; two edges of three; a plane for a
// triangle.
START_TEST(known_triangles_cross_or_do_not)
{
    for (int i = 0; i < 9 * KNOWNS; i++) {
        int k = i / 9;
        patch flat = turned(FLAT, i % 3, 0), p = turned(KNOWN[k].t, i / 3, 3);
        ck_assert_msg(patches_cross(&flat, &p) == KNOWN[k].cross, "%d", k);
        ck_assert_msg(patches_cross(&p, &flat) == KNOWN[k].cross, "%d", k);
    }
}
END_TEST

// Rejects: neighbours that count, which a fold bends onto each other.
START_TEST(neighbours_do_not_cross)
{
    patch flat = triangle(FLAT, 0), p = triangle(KNOWN[0].t, 2);
    ck_assert(!patches_cross(&flat, &p));
}
END_TEST

// Rejects: a link that is no triangle, and so crosses nothing.
START_TEST(link_crosses_a_triangle_and_no_link)
{
    const vec3 at[4] = { { .2, -1, .2 }, { .2, 1, .2 }, { .1, 0, .2 },
                         { .3, 0, .2 } };
    const int up[3] = { 0, 1, 1 }, across[3] = { 2, 3, 3 };
    patch flat = triangle(FLAT, 10), a = patch_make(at, up, 0),
          b = patch_make(at, across, 0);
    ck_assert(patches_cross(&flat, &a));
    ck_assert(patches_cross(&a, &flat));
    ck_assert(!patches_cross(&a, &b));
}
END_TEST

// Rejects: pairs that no strip has, or two; a sweep that ends too early.
START_TEST(quick_count_is_the_slow_count)
{
    enum { MANY = 600 };
    static patch x[MANY];
    long all = 0;
    for (int round = 0; round < 8; round++) {
        real size = round % 4 == 0 ? 0.02 : round % 4 == 1 ? 0.1 : 0.5;
        for (int i = 0; i < MANY; i++) {
            vec3 middle = random_vec3(&seed, 1), at[3];
            if (round == 7) middle.z = 0;
            for (int k = 0; k < 3; k++)
                at[k] = vec3_add_scaled(middle, size, random_vec3(&seed, 1));
            // Some are neighbours.
            x[i] = triangle(at, 2 * i);
        }
        x[3].corner[1].x = (real)NAN;
        long slow = crossings_count_slowly(x, MANY);
        ck_assert_int_eq(crossings_count(x, MANY), slow);
        all += slow;
    }
    ck_assert_int_gt(all, 1000);
    ck_assert_int_eq(crossings_count(x, 0), 0);
}
END_TEST

// Two sheets of 2 x 10 x 10 triangles, one through the other like an X: along
// the line of meeting each of the 20 triangles that it passes crosses others.
// Rejects: a count that finds none.
START_TEST(sheets_through_each_other_cross_all_along)
{
    shape s;
    ck_assert(shape_cloth(&s, 11, 11, 1, 1, 1, 1).ok);
    static patch x[400];
    static vec3 at[121];
    int n = 0;
    for (int tilt = 0; tilt < 2; tilt++) {
        for (int i = 0; i < s.particles; i++) {
            vec3 p = s.at[i];
            at[i] = tilt ? vec3_make(p.y + .013, p.x + .017, p.z + .011) : p;
        }
        for (int f = 0; f < s.mesh.faces; f++)
            x[n++] = patch_make(at, &s.face[3 * f], 121 * tilt);
    }
    ck_assert_int_eq(n, 400);
    long count = crossings_count(x, n);
    ck_assert_int_eq(count, crossings_count_slowly(x, n));
    ck_assert_int_ge(count, 20);
    ck_assert_int_eq(crossings_count(x, 200), 0);
    shape_free(&s);
}
END_TEST

// ---- solids ----------------------------------------------------------------

// Rejects: planes that look inwards; a triangle that only touches.
START_TEST(known_triangles_cut_a_box_or_do_not)
{
    for (int k = 0; k < KNOWNS; k++) {
        patch p = triangle(KNOWN[k].t, 0);
        ck_assert_msg(solid_is_cut(&box, &p) == KNOWN[k].cut, "%d", k);
    }
}
END_TEST

// Rejects: corners for triangles: most of these have none in the box.
START_TEST(cut_is_that_of_thirteen_axes)
{
    const vec3 half = { .5, .5, .5 };
    int cuts = 0, without_corner = 0;
    for (int i = 0; i < 20000; i++) {
        vec3 at[3];
        for (int k = 0; k < 3; k++) at[k] = random_vec3(&seed, 1.5);
        patch p = triangle(at, 0);
        bool cut = triangle_cuts_box(at, half);
        ck_assert_msg(solid_is_cut(&box, &p) == cut, "triangle %d", i);
        cuts += cut;
        without_corner += cut && solid_depth(&box, at[0]) < 0
                       && solid_depth(&box, at[1]) < 0
                       && solid_depth(&box, at[2]) < 0;
    }
    ck_assert_int_gt(cuts, 5000);
    ck_assert_int_gt(without_corner, 1000);
}
END_TEST

START_TEST(depth_is_the_way_to_the_nearest_side)
{
    ck_assert_double_eq_tol(solid_depth(&box, vec3_make(.4, .1, -.2)), .1,
                            1e-15);
    ck_assert_double_eq_tol(solid_depth(&box, vec3_make(0, -.8, .2)), -.3,
                            1e-15);
    ck_assert(solid_depth(&box, vec3_make((real)NAN, 0, 0)) < 0);
}
END_TEST

// A triangle that the four upright edges of the box pass through; one that two
// of them do, and the diagonals of two sides; one within the box.
// Rejects: an edge that counts twice, once for each triangle.
START_TEST(edges_that_pass_through_are_counted_once)
{
    const vec3 wide[3] = { { -9, .2, -9 }, { 9, .2, -9 }, { 0, .2, 9 } };
    const vec3 half[3] = { { 0.1, .2, -9 }, { 9, .2, 0 }, { 0.1, .2, 9 } };
    const vec3 small[3] = { { .1, .2, .1 }, { .3, .2, .1 }, { .1, .2, .3 } };
    patch p = triangle(wide, 0);
    ck_assert_int_eq(solid_edges_through(&box, &p), 4 + 4);
    p = triangle(half, 0);
    int edges = solid_edges_through(&box, &p);
    ck_assert_int_ge(edges, 2 + 1);
    ck_assert_int_le(edges, 2 + 3);
    p = triangle(small, 0);
    ck_assert_int_eq(solid_edges_through(&box, &p), 0);
    ck_assert(solid_is_cut(&box, &p));
}
END_TEST

// A link through the box, and one beside it.
START_TEST(link_cuts_a_box)
{
    const vec3 at[4] = { { -1, .1, .1 }, { 1, .1, .1 }, { -1, .6, 0 },
                         { 1, .51, 0 } };
    const int in[3] = { 0, 1, 1 }, by[3] = { 2, 3, 3 };
    patch a = patch_make(at, in, 0), b = patch_make(at, by, 0);
    ck_assert(solid_is_cut(&box, &a));
    ck_assert(!solid_is_cut(&box, &b));
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        known_triangles_cross_or_do_not,
        neighbours_do_not_cross,
        link_crosses_a_triangle_and_no_link,
        quick_count_is_the_slow_count,
        sheets_through_each_other_cross_all_along,
        known_triangles_cut_a_box_or_do_not,
        cut_is_that_of_thirteen_axes,
        depth_is_the_way_to_the_nearest_side,
        edges_that_pass_through_are_counted_once,
        link_cuts_a_box,
        NULL
    };
    return suite_run((suite){
        .name = "crossings", .tests = tests, .set_up = set_up, .seconds = 30
    });
}
