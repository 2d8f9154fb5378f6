// check.c - tests of the exercise 11/names.

#include "names.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static feature_point on_corner(int v)
{
    return (feature_point){ 1, { v, 77, 78 }, { 1, 5, 5 } };
}

static feature_point on_edge(int v, int w, real t)
{
    return (feature_point){ 2, { v, w, 79 }, { 1 - t, t, 5 } };
}

static feature_point on_face(int u, int v, int w)
{
    return (feature_point){ 3, { u, v, w }, { 0.25, 0.25, 0.5 } };
}

static void expect(const char *what, touch s, touch t, int same)
{
    int there = touch_same(&s, &t), back = touch_same(&t, &s);
    ck_assert_msg(there == same, "%s: got %d, wanted %d", what, there, same);
    ck_assert_msg(back == same, "%s, exchanged: got %d, wanted %d", what, back,
                  same);
}

START_TEST(vertex_is_the_same_over_whatever_face)
{
    // Rejects: both features asked; the gap or the weights asked.
    expect("A's corner 5 slides to the next triangle",
           (touch){ on_corner(5), on_face(0, 1, 2), -0.01 },
           (touch){ on_corner(5), on_face(0, 2, 3), 0.02 }, 1);
    expect("corners 5 and 6 of A over the same face",
           (touch){ on_corner(5), on_face(0, 1, 2), 0 },
           (touch){ on_corner(6), on_face(0, 1, 2), 0 }, 0);
    expect("B's corner 5 under another triangle",
           (touch){ on_face(0, 1, 2), on_corner(5), 0 },
           (touch){ on_face(0, 2, 3), on_corner(5), 0 }, 1);
    expect("A's corner 5 and B's corner 5",
           (touch){ on_corner(5), on_face(0, 1, 2), 0 },
           (touch){ on_face(0, 1, 2), on_corner(5), 0 }, 0);
    expect("A's corner 5 comes to a rim",
           (touch){ on_corner(5), on_face(0, 1, 2), 0 },
           (touch){ on_corner(5), on_edge(1, 2, 0.5), 0 }, 1);
    expect("A's corner 5 comes to a corner",
           (touch){ on_corner(5), on_face(0, 1, 2), 0 },
           (touch){ on_corner(5), on_corner(1), 0 }, 1);
    expect("B's corner 1 was under a corner, and is under a face",
           (touch){ on_corner(5), on_corner(1), 0 },
           (touch){ on_face(4, 5, 6), on_corner(1), 0 }, 1);
}
END_TEST

START_TEST(edges_are_known_by_both)
{
    // Rejects: an edge that is another when it is named from its other end;
    // vertices behind the count.
    touch s = { on_edge(3, 7, 0.5), on_edge(0, 1, 0.25), 0 };
    expect("the same two", s,
           (touch){ on_edge(3, 7, 0.4), on_edge(0, 1, 0.3), 0 }, 1);
    expect("from their other ends", s,
           (touch){ on_edge(7, 3, 0.5), on_edge(1, 0, 0.75), 0 }, 1);
    expect("another edge of A", s,
           (touch){ on_edge(3, 2, 0.5), on_edge(0, 1, 0.25), 0 }, 0);
    expect("another edge of B", s,
           (touch){ on_edge(3, 7, 0.5), on_edge(0, 4, 0.25), 0 }, 0);
    expect("A's edge on B's, and B's on A's", s,
           (touch){ on_edge(0, 1, 0.5), on_edge(3, 7, 0.25), 0 }, 0);
    touch rubbish = { on_edge(7, 3, 0.5), on_edge(1, 0, 0.5), 0 };
    rubbish.a.vertex[2] = rubbish.b.vertex[2] = -1;
    expect("rubbish behind the count", s, rubbish, 1);
    expect("an edge and a face of it", s,
           (touch){ on_face(3, 7, 79), on_edge(0, 1, 0.25), 0 }, 0);
    expect("an edge and its end", s,
           (touch){ on_corner(3), on_edge(0, 1, 0.25), 0 }, 0);
}
END_TEST

START_TEST(faces_are_known_in_any_order)
{
    expect("face on face", (touch){ on_face(4, 5, 6), on_face(1, 2, 3), 0 },
           (touch){ on_face(6, 4, 5), on_face(3, 2, 1), 0 }, 1);
    expect("another face", (touch){ on_face(4, 5, 6), on_face(1, 2, 3), 0 },
           (touch){ on_face(6, 4, 7), on_face(3, 2, 1), 0 }, 0);
}
END_TEST

static void carry(const touch *old, const real *pushed, int olds,
                  const touch *now, int n, const real *wanted)
{
    // Memory that ends behind the last, and holds rubbish.
    touch *o = malloc((size_t)(olds ? olds : 1) * sizeof *o);
    real *p = malloc((size_t)(olds ? olds : 1) * sizeof *p);
    real *begin = malloc((size_t)(n ? n : 1) * sizeof *begin);
    ck_assert(o && p && begin);
    for (int k = 0; k < olds; k++) { o[k] = old[k]; p[k] = pushed[k]; }
    for (int i = 0; i < n; i++) begin[i] = 99;
    names_carry(o, p, olds, now, begin, n);
    for (int i = 0; i < n; i++)
        ck_assert_msg(begin[i] == wanted[i], "touch %d of %d begins with %g, "
                      "wanted %g", i, n, begin[i], wanted[i]);
    free(o);
    free(p);
    free(begin);
}

static const touch OVER[4] = {
    { { 1, { 0 }, { 1 } }, { 1, { 9 }, { 1 } }, 0 },
    { { 1, { 1 }, { 1 } }, { 1, { 8 }, { 1 } }, 0 },
    { { 1, { 4 }, { 1 } }, { 1, { 7 }, { 1 } }, 0 },
    { { 1, { 5 }, { 1 } }, { 1, { 6 }, { 1 } }, 0 },
};
static const real PUSHED[4] = { 1, 2, 3, 4 };

START_TEST(another_order_changes_nothing)
{
    // Rejects: numbers in the list in the place of names.
    const touch now[4] = { OVER[2], OVER[0], OVER[3], OVER[1] };
    carry(OVER, PUSHED, 4, now, 4, (const real[]){ 3, 1, 4, 2 });
}
END_TEST

START_TEST(who_is_new_begins_with_nothing)
{
    // Rejects: rubbish that nobody clears; one past the end of a list.
    const touch one = { on_corner(6), on_face(1, 2, 3), 0 };
    const touch now[3] = { one, OVER[1], one };
    carry(OVER, PUSHED, 4, now, 3, (const real[]){ 0, 2, 0 });
    carry(OVER, PUSHED, 2, OVER, 4, (const real[]){ 1, 2, 0, 0 });
    carry(OVER, PUSHED, 0, OVER, 4, (const real[]){ 0, 0, 0, 0 });
    carry(OVER, PUSHED, 4, OVER, 0, NULL);
}
END_TEST

START_TEST(push_is_handed_on_once)
{
    // Corner on corner; then each of them over a side of the other.
    // Rejects: a push for both, which makes the pile jump.
    const touch now[2] = { { on_corner(1), on_face(6, 7, 9), 0 },
                           { on_face(0, 2, 4), on_corner(8), 0 } };
    carry(OVER, PUSHED, 4, now, 2, (const real[]){ 2, 0 });
    const touch twice[2] = { OVER[3], OVER[3] };
    carry(OVER, PUSHED, 4, twice, 2, (const real[]){ 4, 0 });
    carry(twice, PUSHED, 2, twice, 2, (const real[]){ 1, 2 });
}
END_TEST

START_TEST(box_slides_and_keeps_its_corners)
{
    // A box of 20 cm on one of 2 m, 1 m further and half around in 200 frames.
    // It rocks, so that now one corner comes first, now another.
    shape small, large;
    ck_assert(shape_box(&small, (vec3){ 0.2, 0.2, 0.2 }, 1).ok);
    ck_assert(shape_box(&large, (vec3){ 2, 2, 2 }, 1).ok);
    touch old[MANIFOLD_POINTS];
    real pushed[MANIFOLD_POINTS], begin[MANIFOLD_POINTS];
    int olds = 0, moved = 0, another = 0, first = -1;
    for (int k = 0; k <= 200; k++) {
        real turn = k * acos(-1.0) / 200, c = cos(turn), s = sin(turn);
        real rock = 0.01 * sin(0.7 * k), tip = 0.01 * cos(0.4 * k);
        vec3 at[8];
        int low = 0;
        for (int v = 0; v < 8; v++) {
            vec3 x = small.at[v];
            at[v] = (vec3){ c * x.x + s * x.z + 0.005 * k - 0.5,
                            1.105 + x.y + rock * x.x + tip * x.z,
                            c * x.z - s * x.x + 0.003 * k };
            if (at[v].y < at[low].y) low = v;
        }
        query_result nearest = { true, { 0, 1, 0 },
            { { 1, { low }, { 1 } }, { 1, { 2 }, { 1 } }, at[low].y - 1 } };
        collider a = { &small, at, false }, b = { &large, large.at, false };
        manifold m = manifold_find(&a, &b, &nearest, 0.05, 0);
        const touch *now = m.point;
        int n = m.count;
        ck_assert_int_eq(n, 4);
        if (k > 0) names_carry(old, pushed, olds, now, begin, n);
        for (int i = 0; i < n; i++) {
            int v = now[i].a.vertex[0];
            ck_assert_int_eq(now[i].a.count, 1);
            if (k == 0) begin[i] = 10 + v;
            else moved += now[i].b.vertex[0] != old[i].b.vertex[0]
                       || now[i].b.vertex[1] != old[i].b.vertex[1];
            ck_assert_msg(begin[i] == 10 + v, "frame %d: corner %d begins with "
                          "%g, wanted %d", k, v, begin[i], 10 + v);
        }
        another += now[0].a.vertex[0] != first;
        first = now[0].a.vertex[0];
        olds = n;
        memcpy(old, m.point, sizeof old);
        memcpy(pushed, begin, sizeof pushed);
    }
    ck_assert_msg(moved > 3, "no corner came to another triangle");
    ck_assert_msg(another > 10, "the deepest was always the same");
    shape_free(&small);
    shape_free(&large);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        vertex_is_the_same_over_whatever_face,
        edges_are_known_by_both,
        faces_are_known_in_any_order,
        another_order_changes_nothing,
        who_is_new_begins_with_nothing,
        push_is_handed_on_once,
        box_slides_and_keeps_its_corners,
        NULL
    };
    return suite_run((suite){ .name = "names", .tests = tests });
}
