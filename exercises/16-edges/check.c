// check.c - tests of the exercise 16/edges.

#include "edges.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Of the sizes: some roundings, and what is left of parallel edges.
static const real ROUNDING = 1e-12;

// Below this angle edges may count as parallel; the slope is no larger then.
static const real PARALLEL = 2e-7;

static edge_meeting nearest(vec3 p0, vec3 p1, vec3 q0, vec3 q1)
{
    edge_meeting m = edges_nearest(p0, p1, q0, q1);
    ck_assert_msg(m.s >= 0 && m.s <= 1, "s is %g: not on the first edge", m.s);
    ck_assert_msg(m.t >= 0 && m.t <= 1, "t is %g: not on the second edge", m.t);
    vec3 on_p = vec3_add_scaled(p0, m.s, vec3_sub(p1, p0));
    vec3 on_q = vec3_add_scaled(q0, m.t, vec3_sub(q1, q0));
    real size = vec3_length(p0) + vec3_length(p1) + vec3_length(q0) + vec3_length(q1);
    near_vec3(m.way, vec3_sub(on_p, on_q), ROUNDING * size, "the way",
              "It leads from the second edge's point to the first's.");
    return m;
}

START_TEST(edges_that_cross_are_nearest_in_the_middle)
{
    // Rejects: a sign in either share, the way from the first to the second.
    edge_meeting m = nearest(vec3_make(-1, 2, 0), vec3_make(3, 2, 0), vec3_make(0, 0, -3), vec3_make(0, 0, 1));
    near(m.s, 0.25, ROUNDING, "share of the first edge", "It passes x = 0 after one of four metres.");
    near(m.t, 0.75, ROUNDING, "share of the second edge", "It passes z = 0 after three of four metres.");
    near_vec3(m.way, vec3_make(0, 2, 0), ROUNDING, "the way");
}
END_TEST

START_TEST(what_is_cut_from_one_edge_moves_the_other)
{
    // The lines meet at (0, 0, 0), where the second edge has ended: its end is
    // (1, 1, 0), and right below it lies (1, 0, 0).
    // Rejects: the s of the lines, kept when t was cut.
    edge_meeting m = nearest(vec3_make(0, 0, 0), vec3_make(1, 0, 0), vec3_make(1, 1, 0), vec3_make(3, 3, 0));
    near(m.s, 1, ROUNDING, "share of the first edge", "t was cut to 0; the best s for that t is another one.");
    near(m.t, 0, ROUNDING, "share of the second edge");
    near(vec3_length(m.way), 1, ROUNDING, "distance (m)");
}
END_TEST

START_TEST(edges_apart_are_nearest_at_their_ends)
{
    // Rejects: shares that are not cut.
    edge_meeting m = nearest(vec3_make(0, 0, 0), vec3_make(1, 0, 0), vec3_make(4, 4, 0), vec3_make(4, 9, 0));
    near(m.s, 1, ROUNDING, "share of the first edge");
    near(m.t, 0, ROUNDING, "share of the second edge");
    near(vec3_length(m.way), 5, ROUNDING, "distance (m)");
}
END_TEST

START_TEST(parallel_edges_have_a_distance)
{
    // Side by side, one behind the other, and one within the other's length.
    // Rejects: 0 / 0 where the lines have no one crossing.
    edge_meeting m = nearest(vec3_make(0, 0, 0), vec3_make(4, 0, 0), vec3_make(1, 3, 0), vec3_make(9, 3, 0));
    near(vec3_length(m.way), 3, ROUNDING, "distance (m) side by side");
    m = nearest(vec3_make(0, 0, 0), vec3_make(4, 0, 0), vec3_make(7, 4, 0), vec3_make(9, 4, 0));
    near(vec3_length(m.way), 5, ROUNDING, "distance (m), one behind the other");
    m = nearest(vec3_make(9, 3, 0), vec3_make(-9, 3, 0), vec3_make(7, 0, 0), vec3_make(8, 0, 0));
    near(vec3_length(m.way), 3, ROUNDING, "distance (m) in opposite directions");
}
END_TEST

START_TEST(edge_without_length_is_a_point)
{
    // Rejects: division by a length of 0.
    const vec3 p = { 1, 2, 0 }, a = { 0, 0, 0 }, b = { 4, 0, 0 };
    edge_meeting m = nearest(p, p, a, b);
    near(m.t, 0.25, ROUNDING, "share of the edge below a point");
    near(vec3_length(m.way), 2, ROUNDING, "distance (m) of point and edge");
    m = nearest(a, b, p, p);
    near(m.s, 0.25, ROUNDING, "share of the edge below a point");
    m = nearest(p, p, a, a);
    near(vec3_length(m.way), sqrt(5.0), ROUNDING, "distance (m) of two points");
}
END_TEST

// An edge from p that is nearly parallel to another, now and then, or a point.
static vec3 other_end(unsigned long long *seed, vec3 p, vec3 along, int kind)
{
    if (kind == 0) return p;
    if (kind > 3) return random_vec3(seed, 1);
    real off = kind == 1 ? 0 : random_fraction(seed) * (kind == 2 ? 1e-9 : 1e-4);
    vec3 way = vec3_add_scaled(along, off, random_vec3(seed, 1));
    return vec3_add_scaled(p, random_real(seed), way);
}

// At a share inside the edge there is no slope; at an end it leads out.
static void slope(real share, real rises, real tolerance, const char *what)
{
    if (share > 0) ck_assert_msg(rises <= tolerance, "%s is %g, and a smaller one is nearer (slope %g)", what, share, rises);
    if (share < 1) ck_assert_msg(rises >= -tolerance, "%s is %g, and a larger one is nearer (slope %g)", what, share, rises);
}

START_TEST(neither_share_can_be_made_better)
{
    // Rejects: tolerances that are lengths, the ends alone, one cut too few.
    unsigned long long seed = 16;
    for (int k = 0; k < 40000; k++) {
        real size = k % 4 ? 1 : k % 8 ? 1e-9 : 1e9;
        vec3 p0 = random_vec3(&seed, 1), p1 = random_vec3(&seed, 1), q0 = random_vec3(&seed, 1);
        vec3 q1 = other_end(&seed, q0, vec3_sub(p1, p0), k % 10);
        edge_meeting m = nearest(vec3_scale(size, p0), vec3_scale(size, p1), vec3_scale(size, q0), vec3_scale(size, q1));
        vec3 way = vec3_scale(1 / size, m.way);
        slope(m.s, vec3_dot(vec3_sub(p1, p0), way), PARALLEL, "s");
        slope(m.t, -vec3_dot(vec3_sub(q1, q0), way), PARALLEL, "t");
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        edges_that_cross_are_nearest_in_the_middle,
        what_is_cut_from_one_edge_moves_the_other,
        edges_apart_are_nearest_at_their_ends,
        parallel_edges_have_a_distance,
        edge_without_length_is_a_point,
        neither_share_can_be_made_better,
        NULL
    };
    return suite_run((suite){ .name = "edges", .tests = tests });
}
