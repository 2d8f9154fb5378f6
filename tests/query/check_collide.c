// check_collide.c - where do two rigid bodies touch?  Book: chapter 15.

#include <check.h>
#include <stdlib.h>

#include "axes.h"
#include "collide.h"
#include "convex.h"
#include "expect.h"
#include "hull.h"
#include "suite.h"

// Bodies of size 1 near the origin; a corner is turned, a foot is a mean of
// three: a few dozen roundings.
#define ROUNDING 1e-13
// Corners nearer than a billionth of the bodies are one; the manifold takes the
// first.
#define SLACK 2e-9
// The closed forms against the searches of GJK, which stop at their own bound.
#define ORACLE 1e-11

enum { ROOM = 32 };             // vertices of two bodies

static const vec3 UP = { 0, 1, 0 };

// --- bodies that stand somewhere ---------------------------------------------

// Two places for bodies.
enum { A, B };
static vec3 place[2][ROOM / 2];

static collider stand(const shape *s, int where, axes f, vec3 at)
{
    for (int i = 0; i < s->particles; i++)
        place[where][i] = vec3_add(at, turned(f, s->at[i]));
    return (collider){ s, place[where], false };
}

static shape cube, slab, ball;

static void set_up(void)
{
    seed = 9;
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(4, 1, 4), 1).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
}

static void tear_down(void)
{
    shape_free(&cube);
    shape_free(&slab);
    shape_free(&ball);
}

static manifold touches(collider a, collider b, real margin)
{
    query_cache fresh = { .count = 0 };
    return collide_rigid(&a, &b, margin, 0, &fresh);
}

// Everything that a manifold promises: a unit normal; points that are points of
// their bodies; gaps that are those of the points.
static void is_sound(const manifold *m, collider a, collider b)
{
    const collider *side[2] = { &a, &b };
    ck_assert(fabs(vec3_length(m->normal) - 1) <= ROUNDING);
    ck_assert_int_ge(m->count, 1);
    ck_assert_int_le(m->count, MANIFOLD_POINTS);
    for (int k = 0; k < m->count; k++) {
        const feature_point *f[2] = { &m->point[k].a, &m->point[k].b };
        vec3 at[2];
        for (int s = 0; s < 2; s++) {
            real sum = 0;
            for (int i = 0; i < f[s]->count; i++) {
                ck_assert_int_ge(f[s]->vertex[i], 0);
                ck_assert_int_lt(f[s]->vertex[i], side[s]->shape->particles);
                ck_assert(f[s]->weight[i] >= 0);
                sum += f[s]->weight[i];
            }
            ck_assert(f[s]->count >= 1 && fabs(sum - 1) <= ROUNDING);
            at[s] = feature_at(f[s], side[s]->at);
        }
        real gap = vec3_dot(vec3_sub(at[0], at[1]), m->normal);
        ck_assert(fabs(gap - m->point[k].gap) <= ORACLE);
    }
}

static vec3 on_a(const manifold *m, int k, collider a)
{
    return feature_at(&m->point[k].a, a.at);
}

static vec3 on_b(const manifold *m, int k, collider b)
{
    return feature_at(&m->point[k].b, b.at);
}

// --- the nearest points ------------------------------------------------------

// A cube that stands on a corner: its diagonal is upright.
static axes on_a_corner(void)
{
    axes f = axes_up(vec3_make(1, 1, 1));
    // The turn that takes (1, 1, 1) to y is the inverse of the one that takes y
    // there.
    return (axes){ { f.x.x, f.y.x, f.z.x }, { f.x.y, f.y.y, f.z.y },
                   { f.x.z, f.y.z, f.z.z } };
}

// Rejects: the feature of A and B exchanged; a face's point that is not under
// the corner.
START_TEST(corner_over_a_face_is_one_vertex_against_a_point_of_the_face)
{
    // Half the diagonal of the cube is sqrt(3) / 2; the slab's top is y = 0.5.
    real height = 0.5 + 0.05 + sqrt(3) / 2;
    collider a = stand(&cube, A, on_a_corner(), vec3_make(0.3, height, -0.2));
    collider b = stand(&slab, B, UPRIGHT, vec3_make(0, 0, 0));
    manifold m = touches(a, b, 0.1);
    ck_assert_int_eq(m.count, 1);
    is_sound(&m, a, b);
    near_vec3(m.normal, UP, ORACLE);
    ck_assert_int_eq(m.point[0].a.count, 1);
    near_vec3(on_a(&m, 0, a), vec3_make(0.3, 0.55, -0.2), ORACLE);
    near_vec3(on_b(&m, 0, b), vec3_make(0.3, 0.5, -0.2), ORACLE);
    ck_assert(fabs(m.point[0].gap - 0.05) <= ORACLE);
}
END_TEST

// Rejects: a manifold that invents corners where two edges cross; a normal of
// the wrong sign.
START_TEST(crossed_edges_touch_in_their_middles)
{
    const real h = sqrt(0.5), gap[] = { 0.03, -0.03 };
    axes about_x = { { 1, 0, 0 }, { 0, h, h }, { 0, -h, h } };
    axes about_z = { { h, h, 0 }, { -h, h, 0 }, { 0, 0, 1 } };
    collider b = stand(&cube, B, about_z, vec3_make(0, 0, 0));
    for (int k = 0; k < 2; k++) {
        collider a = stand(&cube, A, about_x, vec3_make(0, 2 * h + gap[k], 0));
        manifold m = touches(a, b, 0.1);
        ck_assert_int_eq(m.count, 1);
        is_sound(&m, a, b);
        near_vec3(m.normal, UP, ORACLE);
        ck_assert_int_eq(m.point[0].a.count, 2);
        ck_assert_int_eq(m.point[0].b.count, 2);
        near_vec3(on_b(&m, 0, b), vec3_make(0, h, 0), ORACLE);
        near_vec3(on_a(&m, 0, a), vec3_make(0, h + gap[k], 0), ORACLE);
    }
}
END_TEST

// The least distance that parts a from b along n, by all pairs of corners.
static real parting(collider a, collider b, vec3 n)
{
    real least = HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i < a.shape->particles; i++)
        least = fmin(least, vec3_dot(a.at[i], n));
    for (int i = 0; i < b.shape->particles; i++)
        most = fmax(most, vec3_dot(b.at[i], n));
    return most - least;
}

// Rejects: a normal from A to B; a point of the wrong body; a manifold that
// begins with another point than the nearest or deepest; one with a point
// beyond the margin.
START_TEST(first_touch_is_the_distance_or_the_depth)
{
    int apart = 0, overlapping = 0, many = 0;
    for (int k = 0; k < 3000; k++) {
        // Drawn before the call: C leaves open which argument comes first.
        vec3 spot = random_vec3(&seed, 0.8);
        collider a = stand(k % 2 ? &ball : &cube, A, any_axes(), spot);
        collider b = stand(k % 3 ? &cube : &ball, B, any_axes(),
                           vec3_make(0, 0, 0));
        gjk_result g = gjk_distance(query_hull(&a), query_hull(&b), HUGE_VAL,
                                    NULL);
        manifold m = touches(a, b, 0.1);
        ck_assert_int_eq(m.count > 0, g.distance <= 0.1);
        if (!m.count) continue;
        is_sound(&m, a, b);
        // The gap is what it says, and it parts the bodies: no corner of A is
        // left below any of B.
        real gap = m.point[0].gap;
        ck_assert(fabs(parting(a, b, m.normal) + gap) <= SLACK);
        for (int i = 0; i < m.count; i++) {
            ck_assert(m.point[i].gap >= gap - ORACLE);
            ck_assert(m.point[i].gap <= 0.1 + ORACLE);
        }
        if (g.status == GJK_APART) {
            ck_assert(fabs(gap - g.distance) <= SLACK);
            apart++;
        } else {
            ck_assert(gap <= SLACK);
            overlapping++;
        }
        many += m.count > 1;
    }
    ck_assert_msg(apart > 100 && overlapping > 300 && many > 200,
                  "%d, %d, %d", apart, overlapping, many);
}
END_TEST

// Rejects: a margin that is compared the wrong way round, or added twice.
START_TEST(margin_is_where_touches_begin)
{
    collider b = stand(&slab, B, UPRIGHT, vec3_make(0, 0, 0));
    for (int k = 0; k < 2; k++) {
        axes f = k ? on_a_corner() : UPRIGHT;
        real low = k ? sqrt(3) / 2 : 0.5;
        collider a = stand(&cube, A, f,
                           vec3_make(0.1, 0.5 + low + 0.0999, 0.2));
        ck_assert_int_ge(touches(a, b, 0.1).count, 1);
        a = stand(&cube, A, f, vec3_make(0.1, 0.5 + low + 0.1001, 0.2));
        ck_assert_int_eq(touches(a, b, 0.1).count, 0);
        ck_assert_int_eq(touches(a, b, 0).count, 0);
    }
}
END_TEST

// Rejects: NaN that becomes a contact, and from there a position; an assert
// about a margin that was made of such numbers.
START_TEST(bodies_that_are_not_finite_have_no_touch)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 3; k++) {
        collider a = stand(&cube, A, UPRIGHT, vec3_make(0, 0.9, 0));
        collider b = stand(&cube, B, UPRIGHT, vec3_make(0, 0, 0));
        ck_assert_int_eq(touches(b, a, (real)NAN).count, 0);
        place[A][3].y = bad[k];
        ck_assert_int_eq(touches(a, b, 0.1).count, 0);
        ck_assert_int_eq(touches(b, a, 0.1).count, 0);
    }
}
END_TEST

// --- a full polytope ---------------------------------------------------------

enum { FINE = 642 };            // vertices of a ball of 1280 faces
static vec3 fine_at[FINE];
static int fine_face[1280][3];

// The vertex between p and q on the unit ball: new, or there already.
static int vertex_between(int p, int q, int *count)
{
    vec3 x = vec3_unit(vec3_add(fine_at[p], fine_at[q]));
    for (int i = 0; i < *count; i++)
        if (vec3_distance(fine_at[i], x) < 1e-6) return i;
    fine_at[*count] = x;
    return (*count)++;
}

static int fine_faces;

static void add_face(int p, int q, int r)
{
    const int v[3] = { p, q, r };
    for (int i = 0; i < 3; i++) fine_face[fine_faces][i] = v[i];
    fine_faces++;
}

// Cuts face f into four: the middle one takes its place.
static void cut_face(int f, int *vertices)
{
    int v[3], m[3];
    for (int k = 0; k < 3; k++) v[k] = fine_face[f][k];
    for (int k = 0; k < 3; k++)
        m[k] = vertex_between(v[k], v[(k + 1) % 3], vertices);
    for (int k = 0; k < 3; k++) add_face(v[k], m[k], m[(k + 2) % 3]);
    for (int k = 0; k < 3; k++) fine_face[f][k] = m[k];
}

// An icosahedron, each face of which is cut in four `rounds` times.
static void make_fine_ball(shape *s, int rounds, int corners)
{
    int vertices = ball.particles;
    fine_faces = 0;
    for (int i = 0; i < vertices; i++) fine_at[i] = vec3_unit(ball.at[i]);
    for (int f = 0; f < ball.mesh.faces; f++)
        add_face(ball.face[3 * f], ball.face[3 * f + 1], ball.face[3 * f + 2]);
    for (int round = 0; round < rounds; round++)
        for (int f = fine_faces - 1; f >= 0; f--) cut_face(f, &vertices);
    ck_assert_int_eq(vertices, corners);
    status done = shape_convex(s, vertices, fine_at, fine_faces,
                               (const int (*)[3])fine_face, 1);
    ck_assert_msg(done.ok, "%s", done.why);
}

// Two balls at one place: every face is nearly the nearest, and the polytope is
// full before the best is found.
// Rejects: a query that ran into its cap and is thrown away.  The balls would
// stay in each other for good.
START_TEST(balls_in_one_place_are_parted_all_the_same)
{
    shape fine;
    make_fine_ball(&fine, 3, FINE);
    collider a = { &fine, fine.at, false };
    hull p = query_hull(&a);
    gjk_result g = gjk_distance(p, p, HUGE_VAL, NULL);
    ck_assert_int_eq(hit_face_find(p, p, &g.last).status, HIT_CAPPED);
    manifold m = touches(a, a, 0);
    is_sound(&m, a, a);
    // The least way out is through two faces.  A full polytope's last face lies
    // under them.  Along its normal they are no deeper than both are wide there.
    real least = 2 * shape_inner(&fine), gap = m.point[0].gap, wide = 0;
    for (int v = 0; v < fine.particles; v++)
        wide = fmax(wide, 2 * vec3_dot(m.normal, fine.at[v]));
    ck_assert_msg(-gap > 0.97 * least && -gap < (1 + ROUNDING) * wide,
                  "gap %g, the least way out %g", gap, least);
    shape_free(&fine);
}
END_TEST

// Rejects: corners of the patch alone, of which none is as deep as the nearest
// pair between them: depths up to 8 % too small.
START_TEST(of_round_bodies_the_deepest_point_is_kept)
{
    static vec3 at[2][FINE];
    shape fine;
    make_fine_ball(&fine, 2, 162);
    for (int k = 0; k < 300; k++) {
        vec3 off = vec3_scale(1.5 + 0.5 * random_fraction(&seed),
                              random_direction(&seed));
        axes f = any_axes(), g = any_axes();
        for (int i = 0; i < fine.particles; i++) {
            at[A][i] = vec3_add(off, turned(f, fine.at[i]));
            at[B][i] = turned(g, fine.at[i]);
        }
        collider a = { &fine, at[A], false }, b = { &fine, at[B], false };
        query_cache fresh = { .count = 0 };
        query_result q = query_nearest(&a, &b, 0.1, &fresh);
        manifold m = touches(a, b, 0.1);
        real least = HUGE_VAL;
        for (int i = 0; i < m.count; i++)
            least = fmin(least, m.point[i].gap);
        near(least, q.at.gap, SLACK);
    }
    shape_free(&fine);
}
END_TEST

// Rejects: the difference of two points a nanometre apart as the normal, which
// rounding tilts by some 1e-8.
START_TEST(aligned_boxes_a_nanometre_apart_have_the_normal_of_their_faces)
{
    for (int k = 0; k < 1000; k++) {
        axes f = any_axes();
        vec3 off = vec3_make(k % 4 ? random_fraction(&seed) - 0.5 : 0, 1 + 1e-9,
                             k % 3 ? random_fraction(&seed) - 0.5 : 0);
        collider b = stand(&cube, B, f, vec3_make(0.3, 0.1, 0.2));
        collider a = stand(&cube, A, f, vec3_add(vec3_make(0.3, 0.1, 0.2),
                                                 turned(f, off)));
        manifold m = touches(a, b, 0.05);
        ck_assert_int_eq(m.count, 4);
        near_vec3(m.normal, turned(f, UP), ROUNDING);
    }
}
END_TEST

// A roof upside down, whose ridge is bent by a third of a degree in its middle,
// lies along the ridge of a box on its edge.
// Rejects: a bent ridge taken for a straight edge, so that touches lie below
// the surface.
START_TEST(touches_on_a_bent_ridge_lie_on_it)
{
    const real bent = 0.003;
    const vec3 corners[] = { { 0, 0, 0 }, { 1, bent, 0 }, { -1, bent, 0 },
        { 1, 1, 1 }, { 1, 1, -1 }, { -1, 1, 1 }, { -1, 1, -1 } };
    const real s = sqrt(0.5);
    const axes on_edge = { { 1, 0, 0 }, { 0, s, s }, { 0, -s, s } };
    shape roof;
    ck_assert(shape_hull(&roof, corners, 7, 1).ok);
    vec3 lift = vec3_sub(corners[0], roof.at[0]);
    collider a = stand(&roof, A, UPRIGHT, lift);
    collider b = stand(&cube, B, on_edge, vec3_make(0.1, -s - 0.001, 0));
    manifold m = touches(a, b, 0.05);
    ck_assert_int_ge(m.count, 1);
    near(m.point[0].gap, 0.001, SLACK);
    for (int k = 0; k < m.count; k++) {
        vec3 x = feature_at(&m.point[k].a, a.at);
        near(x.y, bent * fabs(x.x), SLACK);
    }
    shape_free(&roof);
}
END_TEST

// --- on their way ------------------------------------------------------------

static swept_status sweep(collider a, collider b, vec3 way, real apart,
                          manifold *m)
{
    static vec3 room[ROOM];
    const swept_motion goes = { .delta = way }, stays = { .out = 0 };
    return collide_swept(&a, &goes, &b, &stays, apart, room, m);
}

// A cube comes corner down from above, and will be far below; or the slab comes
// up to it.
// Rejects: a touch of where they are, or would be, instead of where they first
// meet; features of the wrong body; the gap of another moment.
START_TEST(cube_on_its_way_touches_where_it_first_will)
{
    const real high = 3;
    const vec3 way = { 0.5, -100, 0 };
    collider b = stand(&slab, B, UPRIGHT, vec3_make(0, -0.5, 0));
    collider a = stand(&cube, A, on_a_corner(),
                       vec3_make(0.1, high + sqrt(0.75), 0.2));
    for (int swap = 0; swap < 2; swap++) {
        manifold m;
        ck_assert_int_eq(swap ? sweep(b, a, vec3_scale(-1, way), 0.01, &m)
                              : sweep(a, b, way, 0.01, &m), SWEPT_TOUCHES);
        ck_assert_int_eq(m.count, 1);
        if (swap) is_sound(&m, b, a);
        else      is_sound(&m, a, b);
        near_vec3(m.normal, swap ? vec3_scale(-1, UP) : UP, 1e-6);
        const feature_point *corner_of = swap ? &m.point[0].b : &m.point[0].a;
        const feature_point *face_of = swap ? &m.point[0].a : &m.point[0].b;
        ck_assert_int_eq(corner_of->count, 1);
        near_vec3(feature_at(corner_of, a.at), vec3_make(0.1, high, 0.2), 1e-9);
        // 3 m of the 100 are 3 % of what it goes aside, to 1e-3 of a radius.
        real aside = 0.1 + 0.5 * (high - 0.01) / 100;
        near_vec3(feature_at(face_of, b.at), vec3_make(aside, 0, 0.2), 1e-3);
        ck_assert(fabs(m.point[0].gap - high) <= 1e-6);
    }
}
END_TEST

// Rejects: a touch with what is passed; one that is written all the same.
START_TEST(bodies_that_pass_or_overlap_have_no_touch_on_their_way)
{
    collider b = stand(&slab, B, UPRIGHT, vec3_make(0, -0.5, 0));
    collider a = stand(&cube, A, UPRIGHT, vec3_make(0, 3, 0));
    manifold m = { .count = 7 };
    ck_assert_int_eq(sweep(a, b, vec3_make(100, -10, 0), 0, &m), SWEPT_PASSES);
    ck_assert_int_eq(sweep(a, b, UP, 0, &m), SWEPT_PASSES);
    ck_assert_int_eq(sweep(b, b, UP, 0, &m), SWEPT_OVERLAP);
    ck_assert_int_eq(sweep(a, b, vec3_make(0, (real)NAN, 0), 0, &m),
                     SWEPT_NOT_FINITE);
    ck_assert_int_eq(m.count, 7);
}
END_TEST

// --- the manifold ------------------------------------------------------------

// The touch that is corner i of one body alone: of A (side 0) or of B (1).
static const touch *with_corner(const manifold *m, int side, int i)
{
    for (int k = 0; k < m->count; k++) {
        const feature_point *f = side ? &m->point[k].b : &m->point[k].a;
        if (f->count == 1 && f->vertex[0] == i) return &m->point[k];
    }
    return NULL;
}

static vec3 middle(const vec3 *at)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < 8; k++) sum = vec3_add(sum, at[k]);
    return vec3_scale(0.125, sum);
}

// Rejects: one point that lets the body tip; corners of the far face; a
// corner's foot in the wrong triangle; a corner twice, which doubles its load.
START_TEST(face_on_a_face_stands_on_its_four_corners)
{
    for (int k = 0; k < 50; k++) {
        axes f = any_axes();
        real gap = 0.04 * random_real(&seed);
        collider b = stand(&slab, B, f, random_vec3(&seed, 2));
        vec3 up = vec3_make(random_real(&seed), 1 + gap, random_real(&seed));
        vec3 over = turned(f, up);
        collider a = stand(&cube, A, f, vec3_add(middle(b.at), over));
        manifold m = touches(a, b, 0.05);
        ck_assert_int_eq(m.count, 4);
        is_sound(&m, a, b);
        near_vec3(m.normal, f.y, ORACLE);
        for (int i = 0; i < 8; i++) {
            const touch *at = with_corner(&m, 0, i);
            // Bit 1 of a corner's number: the upper ones.
            if (i & 2) { ck_assert_ptr_null(at); continue; }
            ck_assert_ptr_nonnull(at);
            ck_assert(fabs(at->gap - gap) <= ORACLE);
            near_vec3(feature_at(&at->b, b.at),
                      vec3_add_scaled(a.at[i], -gap, f.y), ORACLE);
        }
    }
}
END_TEST

// Rejects: corners of B that are forgotten, or whose normal or sign is A's.
START_TEST(corners_of_the_lower_body_carry_a_wide_one)
{
    collider b = stand(&cube, B, UPRIGHT, vec3_make(0.3, 0, 0.4));
    collider a = stand(&slab, A, UPRIGHT, vec3_make(0, 1.01, 0));
    manifold m = touches(a, b, 0.05);
    ck_assert_int_eq(m.count, 4);
    is_sound(&m, a, b);
    near_vec3(m.normal, UP, ORACLE);
    for (int i = 0; i < 8; i++) {
        const touch *at = with_corner(&m, 1, i);
        if (!(i & 2)) { ck_assert_ptr_null(at); continue; }
        ck_assert_ptr_nonnull(at);
        near_vec3(feature_at(&at->a, a.at),
                  vec3_add_scaled(b.at[i], 0.01, UP), ORACLE);
    }
}
END_TEST

// Rejects: corners that stand beside the other face and not over it; edges
// that cross, left out.
START_TEST(shifted_boxes_share_one_corner_each_and_two_crossings)
{
    collider b = stand(&cube, B, UPRIGHT, vec3_make(0, 0, 0));
    collider a = stand(&cube, A, UPRIGHT, vec3_make(0.4, 0.99, 0.3));
    manifold m = touches(a, b, 0.05);
    int corners_a = 0, corners_b = 0;
    ck_assert_int_eq(m.count, 4);
    is_sound(&m, a, b);
    for (int i = 0; i < m.count; i++) {
        vec3 x = on_b(&m, i, b);
        ck_assert(fabs(m.point[i].gap + 0.01) <= ORACLE);
        ck_assert(x.x >= -0.1 - ORACLE && x.x <= 0.5 + ORACLE);
        ck_assert(x.z >= -0.2 - ORACLE && x.z <= 0.5 + ORACLE);
    }
    for (int i = 0; i < 8; i++) {
        corners_a += with_corner(&m, 0, i) != NULL;
        corners_b += with_corner(&m, 1, i) != NULL;
    }
    // A's lowest corner with x, z least (number 0); B's with all most (7).
    ck_assert(corners_a == 1 && corners_b == 1);
    ck_assert_ptr_nonnull(with_corner(&m, 0, 0));
    ck_assert_ptr_nonnull(with_corner(&m, 1, 7));
}
END_TEST

// Rejects: a vertex that two touches share where two equal faces have 4 + 4
// corners; a corner lost where vertices lie on vertices.
START_TEST(no_vertex_touches_twice)
{
    for (int k = 0; k < 400; k++) {
        axes f = k % 2 ? any_axes() : UPRIGHT;
        vec3 off = k % 4 < 2 ? vec3_make(0, 0, 0) : random_vec3(&seed, 0.01);
        collider b = stand(&cube, B, f, vec3_make(0, 0, 0));
        collider a = stand(&cube, A, f,
            turned(f, vec3_add(vec3_make(0, 0.99, 0), off)));
        manifold m = touches(a, b, 0.05);
        ck_assert_int_eq(m.count, 4);
        is_sound(&m, a, b);
        for (int i = 0; i < m.count; i++)
            for (int j = 0; j < i; j++) {
                const touch *x = &m.point[i], *y = &m.point[j];
                if (x->a.count == 1 && y->a.count == 1)
                    ck_assert_int_ne(x->a.vertex[0], y->a.vertex[0]);
                if (x->b.count == 1 && y->b.count == 1)
                    ck_assert_int_ne(x->b.vertex[0], y->b.vertex[0]);
            }
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        corner_over_a_face_is_one_vertex_against_a_point_of_the_face,
        crossed_edges_touch_in_their_middles,
        first_touch_is_the_distance_or_the_depth,
        margin_is_where_touches_begin,
        bodies_that_are_not_finite_have_no_touch,
        balls_in_one_place_are_parted_all_the_same,
        of_round_bodies_the_deepest_point_is_kept,
        aligned_boxes_a_nanometre_apart_have_the_normal_of_their_faces,
        touches_on_a_bent_ridge_lie_on_it,
        cube_on_its_way_touches_where_it_first_will,
        bodies_that_pass_or_overlap_have_no_touch_on_their_way,
        face_on_a_face_stands_on_its_four_corners,
        corners_of_the_lower_body_carry_a_wide_one,
        shifted_boxes_share_one_corner_each_and_two_crossings,
        no_vertex_touches_twice,
        NULL
    };
    return suite_run((suite){
        .name = "collide", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
