// check_hit_face.c - tests of lib/paper/hit_face: depth, normal, points,
// features.  They ask for what is right, not for which of several right answers
// comes out, nor after how many iterations.

#include "bodies.h"
#include "expect.h"
#include "hit_face.h"
#include "known_pairs.h"
#include "oracle.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

// Of the bodies' size: some dozen roundings.
static const real ROUNDING = 1e-13;
// The same, to which the closest face was told from the next best.
static const real CLOSE = 1e-12;

static hit_result hit(const body *a, const body *b)
{
    gjk_result g = gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL);
    ck_assert_int_eq(g.status, GJK_OVERLAP);
    return hit_face_find(body_hull(a), body_hull(b), &g.last);
}

static bool overlap(const body *a, const body *b)
{
    return gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL).status
        == GJK_OVERLAP;
}

static vec3 sum_of(const body *b, const feature_point *f)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < f->count; k++)
        sum = vec3_add_scaled(sum, f->weight[k],
                              vec3_sub(b->at[f->vertex[k]], b->at[0]));
    return vec3_add(b->at[0], sum);
}

static void check_feature(const body *b, const feature_point *f, vec3 on,
                          real tolerance)
{
    real sum = 0;
    ck_assert_msg(f->count >= 1 && f->count <= 3,
                  "a feature has %d vertices, wanted 1 to 3", f->count);
    for (int k = 0; k < f->count; k++) {
        ck_assert_msg(f->weight[k] >= 0, "a weight is %g", f->weight[k]);
        for (int l = 0; l < k; l++)
            ck_assert_msg(f->vertex[k] != f->vertex[l],
                          "vertex %d stands in a feature twice", f->vertex[k]);
        sum += f->weight[k];
    }
    near(sum, 1, ROUNDING);
    real off = vec3_distance(sum_of(b, f), on);
    ck_assert_msg(off <= tolerance, "a feature's point is %g m from where its "
                  "weights put it", off);
}

static void check_hit(const body *a, const body *b, const hit_result *r)
{
    for (int k = 0; k < 3; k++) {
        corner c = r->hit[k];
        ck_assert(c.a >= 0 && c.a < a->count && c.b >= 0 && c.b < b->count);
        vec3 at = vec3_sub(a->at[c.a], b->at[c.b]);
        ck_assert_msg(vec3_distance(c.at, at) == 0,
                      "corner %d of the hit face is not the difference of its "
                      "vertices", k);
    }
}

// Everything that must hold of an answer, without a reference: the normal is a
// unit vector; the points differ by the depth along it; A - B reaches as far
// along it, so that the move parts the bodies.
static void check_answer(const body *a, const body *b, hit_result r)
{
    real far = vec3_length(a->at[0]), size = pair_size(a, b);
    vec3 gap = vec3_sub(r.on_b, r.on_a);
    near(vec3_length(r.normal), 1, ROUNDING);
    ck_assert(r.depth >= 0);
    real off = vec3_distance(gap, vec3_scale(r.depth, r.normal));
    ck_assert_msg(off <= CLOSE * size + 1e-15 * far,
                  "on_b - on_a is to be depth times normal, and is off by %g m",
                  off);
    check_feature(a, &r.a, r.on_a, ROUNDING * size + 1e-15 * far);
    check_feature(b, &r.b, r.on_b, ROUNDING * size + 1e-15 * far);
    if (r.status != HIT_FOUND) return;
    check_hit(a, b, &r);
    near(width_along(a, b, r.normal), r.depth, CLOSE * size);
}

// ---- answers that can be had by hand

// Rejects: a normal from A to B, a depth along the wrong axis, the outward
// normal of A - B for the way in which A moves.
START_TEST(a_cube_pushed_in_comes_out_the_short_way)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.75, 0.125, -0.25);
    hit_result r = hit(&a, &b);
    ck_assert_int_eq(r.status, HIT_FOUND);
    near(r.depth, 0.25, ROUNDING);
    near(r.normal.x, -1, ROUNDING);
    check_answer(&a, &b, r);
    r = hit(&b, &a);
    near(r.depth, 0.25, ROUNDING);
    near(r.normal.x, 1, ROUNDING);
    check_answer(&b, &a, r);
}
END_TEST

// The middles say sideways; the shortest way is up.  Rejects: the line between
// the middles for the way out.
START_TEST(a_box_at_the_edge_of_a_floor_comes_out_at_the_top)
{
    body box = body_cube(3.5, 0, 0.25), floor;
    body_box(&floor, (vec3){ -4, -4, -1 }, (vec3){ 4, 4, 0 });
    hit_result r = hit(&box, &floor);
    near(r.depth, 0.25, ROUNDING);
    near(r.normal.z, 1, ROUNDING);
    near(r.on_b.z, 0, ROUNDING);
    near(r.on_a.z, -0.25, ROUNDING);
    check_answer(&box, &floor, r);
}
END_TEST

static body turned_to_stand_on_a_corner(void)
{
    body c = body_cube(0, 0, 0);
    vec3 z = vec3_unit((vec3){ 1, 1, 1 }), x = vec3_unit((vec3){ 1, -1, 0 });
    vec3 y = vec3_cross(z, x);
    for (int i = 0; i < 8; i++) {
        vec3 p = c.at[i];
        c.at[i] = (vec3){ vec3_dot(x, p), vec3_dot(y, p),
                          vec3_dot(z, p) + sqrt(0.75) - 0.1 };
    }
    return c;
}

static void check_kind(touch_kind got, touch_kind wanted)
{
    static const char *name[] = { "a vertex of A and a face of B",
                                  "a face of A and a vertex of B",
                                  "edge and edge" };
    ck_assert_msg(got == wanted, "the kind: got %s, wanted %s", name[got],
                  name[wanted]);
}

// Rejects: A's features given to B; vertices that are not merged; the label the
// other way round.
START_TEST(a_vertex_and_a_face_are_named)
{
    body c = turned_to_stand_on_a_corner(), floor;
    body_box(&floor, (vec3){ -2, -2, -1 }, (vec3){ 2, 2, 0 });
    hit_result r = hit(&c, &floor);
    check_kind(r.kind, TOUCH_VERTEX_FACE);
    ck_assert_int_eq(r.a.count, 1);
    ck_assert_int_eq(r.a.vertex[0], 0);
    near(r.a.weight[0], 1, ROUNDING);
    near(r.depth, 0.1, ROUNDING);
    near(r.normal.z, 1, ROUNDING);
    check_answer(&c, &floor, r);
    r = hit(&floor, &c);
    check_kind(r.kind, TOUCH_FACE_VERTEX);
    ck_assert_int_eq(r.b.count, 1);
    ck_assert_int_eq(r.b.vertex[0], 0);
    near(r.normal.z, -1, ROUNDING);
    check_answer(&floor, &c, r);
}
END_TEST

// Two square prisms, edges down and up, that cross at a right angle.
START_TEST(two_edges_are_named)
{
    body down = body_cube(0, 0, 0), up = down;
    for (int i = 0; i < 8; i++) {
        vec3 p = up.at[i];
        down.at[i] = (vec3){ (p.x - p.z) / 2, 2 * p.y, (p.x + p.z) / 2 };
        up.at[i] = (vec3){ 2 * p.y, (p.x - p.z) / 2, (p.x + p.z) / 2 - 0.875 };
    }
    hit_result r = hit(&down, &up);
    check_kind(r.kind, TOUCH_EDGE_EDGE);
    ck_assert_int_eq(r.a.count, 2);
    ck_assert_int_eq(r.b.count, 2);
    near(r.depth, 0.125, ROUNDING);
    near(r.normal.z, 1, ROUNDING);
    near(r.on_a.x, 0, ROUNDING);
    near(r.on_b.y, 0, ROUNDING);
    check_answer(&down, &up, r);
}
END_TEST

START_TEST(a_point_inside_a_cube)
{
    body c = body_cube(0, 0, 0), p = { .count = 1 };
    p.at[0] = (vec3){ 0.375, -0.25, 0.125 };
    hit_result r = hit(&p, &c);
    near(r.depth, 0.125, ROUNDING);
    near(r.normal.x, 1, ROUNDING);
    check_kind(r.kind, TOUCH_VERTEX_FACE);
    near(vec3_distance(r.on_b, (vec3){ 0.5, -0.25, 0.125 }), 0, ROUNDING);
    check_answer(&p, &c, r);
}
END_TEST

// ---- what it is for

// Rejects: a depth that is too small to part them, or more than it takes.
START_TEST(moved_by_the_depth_they_only_touch)
{
    unsigned long long seed = 1;
    for (int n = 0; n < 500; n++) {
        body a, b;
        pair_any(&a, &b, n, 3, 0, 0.8, &seed);
        if (!overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        body out = a, not_quite = a;
        body_move(&out, vec3_scale(r.depth + 1e-6, r.normal));
        body_move(&not_quite, vec3_scale(r.depth - 1e-6, r.normal));
        ck_assert(!overlap(&out, &b));
        if (r.depth > 1e-5) ck_assert(overlap(&not_quite, &b));
    }
}
END_TEST

// ---- against every direction

// Rejects: a search that stops a face too early; one that loses faces.
START_TEST(random_pairs_agree_with_every_direction)
{
    unsigned long long seed = 2005;
    int found = 0;
    for (int n = 0; n < 1200; n++) {
        body a, b;
        pair_any(&a, &b, n, 4, 0, 0.9, &seed);
        if (a.count * b.count > 100) continue;      // the oracle is slow
        if (!overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        if (r.status == HIT_FLAT) continue;
        ck_assert_int_eq(r.status, HIT_FOUND);
        found++;
        near(r.depth, true_depth(&a, &b), ROUNDING);
        check_answer(&a, &b, r);
    }
    ck_assert_int_ge(found, 500);
}
END_TEST

// Boxes and hulls beside their own copies: every face of one is parallel to a
// face of the other, but for rounding, and faces of A - B are cut in many
// triangles.  Rejects: faces removed or kept by the sign of a rounding error,
// so that a new one is turned inside out.
START_TEST(equal_bodies_side_by_side)
{
    unsigned long long seed = 51;
    for (int n = 0; n < 1500; n++) {
        body a, b;
        body_any(&a, n % 3 == 1 ? 2 : n % 3, &seed);
        if (n % 3 == 2) body_scale(&a, 1e-3 + random_fraction(&seed));
        b = a;
        if (n % 2) body_scale(&b, 1 + 1e-15 * (n % 7));
        body_move(&b, random_vector(&seed, 0, n % 5 ? 0.3 : 1e-12));
        if (!overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, HIT_FOUND);
        near(r.depth, true_depth(&a, &b), ROUNDING);
        check_answer(&a, &b, r);
    }
}
END_TEST

// Copies that are turned by angles from a degree to nothing: edges nearly
// parallel, triangles that are slivers.  Rejects: normals and weights of
// slivers taken as they come; heights of their planes in place of distances.
START_TEST(copies_turned_by_next_to_nothing)
{
    unsigned long long seed = 53;
    for (int n = 0; n < 1500; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        b = a;
        real angle = 0.02, by = 1;
        for (int k = n % 50; k > 0; k--) angle /= 2;
        for (int k = n / 50 % 50; k > 0; k--) by /= 2;
        vec3 axis = random_direction(&seed);
        for (int i = 0; i < b.count; i++)
            b.at[i] = vec3_add_scaled(b.at[i], angle,
                                      vec3_cross(axis, b.at[i]));
        body_move(&b, random_vector(&seed, 0, 0.4 * by));
        if (a.count * b.count > 150 || !overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, HIT_FOUND);
        near(r.depth, true_depth(&a, &b), ROUNDING);
        near(width_along(&a, &b, r.normal), r.depth, CLOSE);
    }
}
END_TEST

// Copies in nearly the same place: faces of A - B meet at edges so flat that
// they are equally close, and the origin projects into one of them only.
// Rejects: any of the equals.
START_TEST(of_equal_faces_the_one_with_the_projection_counts)
{
    unsigned long long seed = 54;
    for (int n = 0; n < 3000; n++) {
        body a, b;
        body_any(&a, n % 2, &seed);
        b = a;
        vec3 axis = random_direction(&seed);
        real angle = random_fraction(&seed) / (1 << (20 + n % 10));
        for (int i = 0; i < b.count; i++)
            b.at[i] = vec3_add_scaled(b.at[i], angle,
                                      vec3_cross(axis, b.at[i]));
        hit_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, HIT_FOUND);
        vec3 gap = vec3_sub(r.on_b, r.on_a);
        near(vec3_distance(gap, vec3_scale(r.depth, r.normal)), 0, 1e-11);
        near(width_along(&a, &b, r.normal), r.depth, CLOSE);
    }
}
END_TEST

// Two roofs, ridge on ridge at a small angle, one deep in the other by less
// than that: A - B has faces that are slivers.  Rejects: weights as they come
// from quotients of tiny areas.
START_TEST(ridges_that_are_nearly_parallel)
{
    unsigned long long seed = 55;
    for (int n = 0; n < 2000; n++) {
        body a = body_cube(0, 0, 0), b;
        real angle = 0.1, deep = 0.1;
        for (int k = n % 40; k > 0; k--) angle /= 2;
        for (int k = n / 40; k > 0; k--) deep /= 2;
        for (int i = 0; i < 8; i++) {
            vec3 p = a.at[i];
            real x = 2 * p.y, y = (p.x - p.z) / 2, z = (p.x + p.z) / 2;
            a.at[i] = (vec3){ x - angle * y, y + angle * x, z + 1 - deep };
            b.at[i] = (vec3){ x + 0.3, y, z };
        }
        b.count = 8;
        pair_turn(&a, &b, &seed);
        if (!overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        real truth = true_depth(&a, &b);
        near(r.depth, truth, 1e-6 * truth + CLOSE);
        vec3 gap = vec3_sub(r.on_b, r.on_a);
        near(vec3_distance(gap, vec3_scale(r.depth, r.normal)), 0, 1e-10);
    }
}
END_TEST

static int known_found, known_named;

// The label is certain where the next face is more than rounding further away,
// and no vertex stands twice at one place.
static bool is_label_certain(const pair_known *p)
{
    if (strcmp(p->family, "dup_vertices") == 0 || p->kind != 'P' || !p->unique)
        return false;
    bool is_plain = strcmp(p->feature, "VF") == 0
        || strcmp(p->feature, "FV") == 0 || strcmp(p->feature, "EE") == 0;
    return is_plain && p->gap >= 1e-6
        && p->gap * p->value >= 1e-14 * pair_size(&p->a, &p->b);
}

static void judge_depth(const pair_known *p)
{
    static const char *const name[3] = { "VF", "FV", "EE" };
    if (p->kind == 'S') return;
    // Bodies that touch may be a rounding error apart.
    if (p->value < 1e-14 * pair_size(&p->a, &p->b) && !overlap(&p->a, &p->b))
        return;
    hit_result r = hit(&p->a, &p->b);
    ck_assert(r.status == HIT_FOUND || r.status == HIT_FLAT);
    known_found++;
    expect_known(p, r.depth);
    if (!is_label_certain(p)) return;
    known_named++;
    ck_assert_msg(strcmp(name[r.kind], p->feature) == 0, "%s: %s, not %s",
                  p->family, name[r.kind], p->feature);
}

// Rejects: an answer in the best of the directions seen so far.
START_TEST(stored_pairs_have_their_exact_depth)
{
    each_known_pair(judge_depth);
    ck_assert_int_ge(known_found, 600);
    ck_assert_int_ge(known_named, 300);
}
END_TEST

// ---- where it is hard

// Rejects: growing from the simplex that GJK ends with where bodies touch.
START_TEST(touching_is_depth_zero_with_a_proper_normal)
{
    body a = body_cube(0, 0, 0), f = body_cube(1, 0.25, 0.125),
         e = body_cube(1, 1, 0.25);
    body v = body_cube(-1, 1, 1);
    const body *others[3] = { &f, &e, &v };
    hit_result r = hit(&a, &f);
    near(r.normal.x, -1, ROUNDING);
    for (int k = 0; k < 3; k++) {
        r = hit(&a, others[k]);
        ck_assert_int_eq(r.status, HIT_FOUND);
        near(r.depth, 0, ROUNDING);
        check_answer(&a, others[k], r);
    }
}
END_TEST

START_TEST(identical_and_concentric_cubes)
{
    body a = body_cube(0, 0, 0), small = a, turned = a;
    unsigned long long seed = 9;
    near(hit(&a, &a).depth, 1, ROUNDING);
    body_scale(&small, 0.25);
    near(hit(&a, &small).depth, 0.625, ROUNDING);
    near(hit(&small, &a).depth, 0.625, ROUNDING);
    for (int n = 0; n < 100; n++) {
        body_turn(&turned, &seed);
        hit_result r = hit(&a, &turned);
        near(r.depth, true_depth(&a, &turned), ROUNDING);
        check_answer(&a, &turned, r);
    }
}
END_TEST

// GJK ends with one corner, which is the origin itself.  Rejects: asking from
// the origin which faces look inwards, when it lies on the surface.
START_TEST(a_body_in_its_own_place)
{
    unsigned long long seed = 10;
    for (int n = 0; n < 300; n++) {
        body a;
        body_any(&a, n % 3, &seed);
        hit_result r = hit(&a, &a);
        ck_assert_int_eq(r.status, HIT_FOUND);
        check_answer(&a, &a, r);
        if (a.count < 10)
            near(r.depth, true_depth(&a, &a), ROUNDING);
    }
}
END_TEST

// A box and its copy, moved by 20 micrometres and tilted by rounding: A - B is
// full of corners in one plane, up to rounding.  Where w "sees" every face at a
// corner of the polytope by nothing but rounding, that corner is lost inside,
// and the search goes round in circles until the polytope is full.
// Rejects: faces that count as seen because of a rounding error.
START_TEST(boxes_a_hair_apart_leave_no_corner_inside)
{
    const body a = { .count = 8, .at = {
        { -0x1.737fd6b1dec8ap-1, -0x1.1e568872f612p-5,
          0x1.ef27dcd8197fp-4 },
        { -0x1.5953bd8be0992p-1, 0x1.bfea5068502f4p-3,
          -0x1.9763cfa0d1ba8p-3 },
        { 0x1.65510f041d65p-6, 0x1.b059df757814ep-2,
          0x1.34b7a79d526dep-1 },
        { 0x1.2ab50cf0f8d5cp-4, 0x1.5a0cec5bff776p-1,
          0x1.21f37034359ecp-2 },
        { -0x1.2ab50cf0f8d5cp-4, -0x1.5a0cec5bff776p-1,
          -0x1.21f37034359ecp-2 },
        { -0x1.65510f041d65p-6, -0x1.b059df757814ep-2,
          -0x1.34b7a79d526dep-1 },
        { 0x1.5953bd8be0992p-1, -0x1.bfea5068502f4p-3,
          0x1.9763cfa0d1ba8p-3 },
        { 0x1.737fd6b1dec8ap-1, 0x1.1e568872f612p-5,
          -0x1.ef27dcd8197fp-4 },
    } }, b = { .count = 8, .at = {
        { -0x1.7397ec381b19cp-1, -0x1.1e89654f03e35p-5,
          0x1.ef58576a29bdap-4 },
        { -0x1.596bd3121cea4p-1, 0x1.bfdd99314cbafp-3,
          -0x1.974b9257c99b3p-3 },
        { 0x1.624e5e3c93414p-6, 0x1.b05383d9f65abp-2,
          0x1.34bdb6ef9475bp-1 },
        { 0x1.29f460bf164cdp-4, 0x1.5a09be8e3e9a5p-1,
          0x1.21ff8ed8b9ae6p-2 },
        { -0x1.2b75b922db5ebp-4, -0x1.5a101a29c0547p-1,
          -0x1.21e7518fb18f2p-2 },
        { -0x1.6853bfcba788cp-6, -0x1.b0603b10f9cf1p-2,
          -0x1.34b1984b10661p-1 },
        { 0x1.593ba805a448p-1, -0x1.bff7079f53a39p-3,
          0x1.977c0ce9d9d9dp-3 },
        { 0x1.7367c12ba2778p-1, 0x1.1e23ab96e840bp-5,
          -0x1.eef7624609406p-4 },
    } };
    hit_result r = hit(&a, &b);
    ck_assert_int_eq(r.status, HIT_FOUND);
    near(r.depth, true_depth(&a, &b), ROUNDING);
    check_answer(&a, &b, r);
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
        pair_turn(&a, &b, &seed);
        if (!overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, HIT_FOUND);
        near(r.depth, depth, 4 * ROUNDING);
        check_answer(&a, &b, r);
    }
}
END_TEST

// Rejects: weights that are spoilt because a corner lies far from the origin.
START_TEST(far_from_the_origin_nothing_more_is_lost)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.75, 0.5, 0.25);
    pair_move(&a, &b, FAR_AWAY);
    hit_result r = hit(&a, &b);
    near(r.depth, 0.25, ROUNDING);
    near(r.normal.x, -1, ROUNDING);
    near(r.on_a.x - FAR_AWAY.x, 0.5, ROUNDING);
}
END_TEST

// Rejects: every absolute tolerance.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100 };
    unsigned long long seed = 11;
    for (int n = 0; n < 100; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 0.5));
        if (!overlap(&a, &b)) continue;
        hit_result one = hit(&a, &b);
        for (int s = 0; s < COUNT(scale); s++) {
            body c = a, d = b;
            pair_scale(&c, &d, scale[s]);
            hit_result r = hit(&c, &d);
            ck_assert_int_eq(r.status, one.status);
            near(r.depth / scale[s], one.depth, ROUNDING);
        }
    }
}
END_TEST

// A small body deep in a large one, and a large one over a small one.
START_TEST(a_grain_in_a_boulder)
{
    unsigned long long seed = 12;
    for (int n = 0; n < 300; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_scale(&b, n % 2 ? 1e-4 : 1e-6);
        body_move(&b, random_vector(&seed, 0, 0.2));
        if (a.count * b.count > 100 || !overlap(&a, &b)) continue;
        hit_result r = hit(&a, &b);
        near(r.depth, true_depth(&a, &b), ROUNDING);
        check_answer(&a, &b, r);
    }
}
END_TEST

// A - B has no volume.
START_TEST(squares_in_one_plane_are_flat)
{
    unsigned long long seed = 15;
    for (int n = 0; n < 100; n++) {
        body a, b;
        body_square(&a);
        b = a;
        body_move(&b, (vec3){ random_fraction(&seed) - 0.5, 0.25, 0 });
        hit_result r = hit(&a, &b);
        ck_assert_int_eq(r.status, HIT_FLAT);
        near(r.depth, 0, 0);
        near(fabs(r.normal.z), 1, ROUNDING);
        near(vec3_distance(r.on_a, r.on_b), 0, ROUNDING);
        check_answer(&a, &b, r);
    }
}
END_TEST

// Rejects: a normal along the segment, or of no length.
START_TEST(points_and_segments_are_flat)
{
    body s = { .count = 2 }, p = { .count = 1 };
    p.at[0] = (vec3){ 0, 0.5, 0.5 };
    hit_result r = hit(&p, &p);
    ck_assert_int_eq(r.status, HIT_FLAT);
    near(vec3_length(r.normal), 1, ROUNDING);
    const vec3 end[4] = { { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, -2, 1 } };
    for (int k = 0; k < 4; k++) {
        s.at[0] = vec3_add(p.at[0], end[k]);
        s.at[1] = vec3_sub(p.at[0], end[k]);
        r = hit(&s, &p);
        ck_assert_int_eq(r.status, HIT_FLAT);
        near(vec3_length(r.normal), 1, ROUNDING);
        near(vec3_dot(r.normal, end[k]), 0, ROUNDING);
        check_answer(&s, &p, r);
    }
}
END_TEST

START_TEST(repeated_vertices_change_nothing)
{
    unsigned long long seed = 71;
    for (int n = 0; n < 200; n++) {
        body a, b;
        pair_any(&a, &b, n, 3, 0.1, 0.6, &seed);
        if (!overlap(&a, &b)) continue;
        hit_result once = hit(&a, &b);
        for (int i = 0; a.count < 60 + n % 10; i++) a.at[a.count++] = a.at[i];
        for (int i = 0; b.count < 62 + n % 7; i++) b.at[b.count++] = b.at[i];
        hit_result again = hit(&a, &b);
        near(again.depth, once.depth, ROUNDING);
        check_answer(&a, &b, again);
    }
}
END_TEST

// Two concentric balls: nearly every face is the closest, and the polytope may
// be full before the best is found.  Rejects: memory overrun; an answer that
// claims to be exact and is not; a loop without an end.
START_TEST(a_full_polytope_says_so)
{
    static body a;
    for (int level = 1; level <= 3; level++) {
        body_icosphere(&a, level, 0.5);
        hit_result r = hit(&a, &a);
        real width = width_along(&a, &a, r.normal);
        ck_assert(r.status == HIT_FOUND || r.status == HIT_CAPPED);
        if (r.status == HIT_FOUND) near(width, r.depth, CLOSE);
        ck_assert(r.depth > 0.8 && r.depth <= width + CLOSE);
        ck_assert(width < 1.001);
    }
}
END_TEST

START_TEST(what_is_not_finite_gets_a_status)
{
    const real poison[3] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int kind = 0; kind < 3; kind++)
        for (int i = 0; i < 8; i++) {
            body a = body_cube(0, 0, 0), b = body_cube(0.2, 0.1, 0.3);
            gjk_result g = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                        NULL);
            b.at[i].y = poison[kind];
            hit_result r = hit_face_find(body_hull(&a), body_hull(&b), &g.last);
            ck_assert_int_eq(r.status, HIT_NOT_FINITE);
            near(r.depth, 0, 0);
            r = hit_face_find(body_hull(&b), body_hull(&a), &g.last);
            ck_assert_int_eq(r.status, HIT_NOT_FINITE);
            near(vec3_length(r.normal), 0, 0);
        }
}
END_TEST

// Products of four lengths are 0, or too large.  Rejects: a normal of no length
// that claims to be one.
START_TEST(what_is_out_of_range_is_said_or_right)
{
    const real scale[] = { 1e-150, 1e-90, 1e90, 1e150 };
    for (int k = 0; k < COUNT(scale); k++) {
        body a = body_cube(0, 0, 0), b = body_cube(0.2, 0.1, 0.3);
        gjk_result g = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                    NULL);
        pair_scale(&a, &b, scale[k]);
        for (int c = 0; c < g.last.count; c++)
            g.last.of[c].at = vec3_scale(scale[k], g.last.of[c].at);
        hit_result r = hit_face_find(body_hull(&a), body_hull(&b), &g.last);
        if (r.status == HIT_NOT_FINITE) near(r.depth, 0, 0);
        else near(vec3_length(r.normal), 1, ROUNDING);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_cube_pushed_in_comes_out_the_short_way,
        a_box_at_the_edge_of_a_floor_comes_out_at_the_top,
        a_vertex_and_a_face_are_named,
        two_edges_are_named,
        a_point_inside_a_cube,
        moved_by_the_depth_they_only_touch,
        random_pairs_agree_with_every_direction,
        equal_bodies_side_by_side,
        copies_turned_by_next_to_nothing,
        of_equal_faces_the_one_with_the_projection_counts,
        ridges_that_are_nearly_parallel,
        stored_pairs_have_their_exact_depth,
        touching_is_depth_zero_with_a_proper_normal,
        identical_and_concentric_cubes,
        a_body_in_its_own_place,
        boxes_a_hair_apart_leave_no_corner_inside,
        prisms_stand_on_prisms,
        far_from_the_origin_nothing_more_is_lost,
        size_does_not_matter,
        a_grain_in_a_boulder,
        squares_in_one_plane_are_flat,
        points_and_segments_are_flat,
        repeated_vertices_change_nothing,
        a_full_polytope_says_so,
        what_is_not_finite_gets_a_status,
        what_is_out_of_range_is_said_or_right,
        NULL
    };
    return suite_run((suite){
        .name = "hit_face", .tests = tests, .seconds = 60
    });
}
