// check_obstacle.c - planes and convex bodies, as points meet them.
// Book: chapter 16.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "convex.h"
#include "obstacle.h"

// Bodies of size 1 near the origin; a corner is turned, a foot is a mean of
// three: a few dozen roundings.
#define ROUNDING 1e-13
// The closed forms against the searches of GJK, which stop at their own bound.
#define ORACLE 1e-11
// Where body A and body B begin in the pool: not 0, so that a feature that
// forgets to count in the pool is seen.
enum { FIRST_A = 7, FIRST_B = 40, POOL = 100 };

static const vec3 UP = { 0, 1, 0 };

// Numbers in [-1, 1) from a linear congruence; the same on every machine.
static unsigned long long seed;

static real any(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static vec3 any_vec3(real size)
{
    real x = any(), y = any();
    return vec3_scale(size, vec3_make(x, y, any()));
}

// --- bodies that stand somewhere ---------------------------------------------

typedef struct {
    vec3 x, y, z;
} axes;

static const axes UPRIGHT = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

// Axes of which y is this direction.
static axes axes_up(vec3 y)
{
    axes f = { .y = vec3_unit(y) };
    vec3 other = fabs(f.y.x) < 0.7 ? vec3_make(1, 0, 0) : vec3_make(0, 0, 1);
    f.x = vec3_unit(vec3_cross(other, f.y));
    f.z = vec3_cross(f.x, f.y);
    return f;
}

static axes any_axes(void)
{
    axes f = axes_up(any_vec3(1));
    real by = any() * 3, c = cos(by), s = sin(by);
    vec3 x = vec3_add(vec3_scale(c, f.x), vec3_scale(s, f.z));
    return (axes){ x, f.y, vec3_cross(x, f.y) };
}

static vec3 turned(axes f, vec3 r)
{
    return vec3_add(vec3_scale(r.x, f.x),
           vec3_add(vec3_scale(r.y, f.y), vec3_scale(r.z, f.z)));
}

static particle pool[POOL];
static vec3 place[POOL];

// Puts body `first` there: in the pool, and where the queries look.
static pooled stand(const shape *s, int first, real mass, axes f, vec3 at)
{
    for (int i = 0; i < s->particles; i++) {
        vec3 x = vec3_add(at, turned(f, s->at[i]));
        place[first + i] = x;
        pool[first + i] = (particle){ x, x, mass < HUGE_VAL ? 1 : 0 };
    }
    return (pooled){ s, first, place + first, mass };
}

// A prism, with an edge of 45 degrees along z (top and slope) and an end that
// leans outward by 45 (the edge of top and end is blunt).
static const vec3 WEDGE[6] = {
    { 0, 0, -1 }, { -1, 0, -1 }, { -1, -1, -1 },
    { 0, 0, 1 }, { -1, 0, 1 }, { -1, -1, 2 },
};
static const int WEDGE_FACE[8][3] = {
    { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4 }, { 0, 4, 3 },
    { 1, 2, 5 }, { 1, 5, 4 }, { 0, 3, 5 }, { 0, 5, 2 },
};

static shape cube, slab, ball, wedge;

static void set_up(void)
{
    seed = 9;
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(4, 1, 4), 1).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
    ck_assert(shape_convex(&wedge, 6, WEDGE, 8, WEDGE_FACE, 1).ok);
}

static void tear_down(void)
{
    shape_free(&cube);
    shape_free(&slab);
    shape_free(&ball);
    shape_free(&wedge);
}

static gjk_result distance_to(pooled b, vec3 x)
{
    hull point = { &x, 1 }, body = { b.at, b.plan->particles };
    return gjk_distance(point, body, HUGE_VAL, NULL);
}

// Where the point is that f stands for.
static vec3 feature_now(feature_point f, const particle *p)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < f.count; i++)
        sum = vec3_add_scaled(sum, f.weight[i], p[f.vertex[i]].position);
    return sum;
}

static vec3 point_on_b(const contact_point *c)
{
    return c->b.count > 0 ? feature_now(c->b, pool) : c->fixed;
}

static real gap_of(const contact_point *c)
{
    vec3 across = vec3_sub(feature_now(c->a, pool), point_on_b(c));
    return vec3_dot(across, c->normal) - c->thickness;
}

static void near_vec3(vec3 got, vec3 wanted, real error)
{
    ck_assert_msg(vec3_distance(got, wanted) <= error,
                  "got (%g, %g, %g), wanted (%g, %g, %g)",
                  got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
}

// Everything that a contact promises wherever it comes from.
static void is_sound(const contact_point *c, pooled a, pooled b)
{
    ck_assert(fabs(vec3_length(c->normal) - 1) <= ROUNDING);
    ck_assert_int_ge(c->a.count, 1);
    const feature_point *side[2] = { &c->a, &c->b };
    const pooled *body[2] = { &a, &b };
    for (int k = 0; k < 2; k++) {
        real sum = 0;
        for (int i = 0; i < side[k]->count; i++) {
            ck_assert(side[k]->weight[i] >= 0);
            ck_assert(side[k]->weight[i] <= 1 + ROUNDING);
            ck_assert_int_ge(side[k]->vertex[i], body[k]->first);
            ck_assert_int_lt(side[k]->vertex[i],
                             body[k]->first + body[k]->plan->particles);
            sum += side[k]->weight[i];
        }
        if (side[k]->count > 0) ck_assert(fabs(sum - 1) <= ROUNDING);
    }
    ck_assert(c->thickness == 0);
}

// The hull under test, and the question.
static plane walls[20];
static int wall_face[20], wall_count;

static pooled stand_hull(const shape *s, real mass, axes f, vec3 at)
{
    pooled b = stand(s, FIRST_B, mass, f, at);
    wall_count = hull_planes(s, b.at, walls, wall_face);
    return b;
}

// A single particle as a body of its own: number `FIRST_A + 2` of the pool.
static int ask(pooled b, vec3 x, real reach, contact_point *c)
{
    vec3 *at = place + FIRST_A;
    at[2] = x;
    pool[FIRST_A + 2] = (particle){ x, x, 1 };
    pooled a = { &cube, FIRST_A, at, 1 };
    return collide_point(&a, 2, &b, walls, wall_face, wall_count, reach, c);
}

// --- planes ------------------------------------------------------------------

// Rejects: margin without thickness; a contact without the thickness that it is
// to keep; a fixed point that is not on the plane.
START_TEST(plane_meets_what_is_nearer_than_margin_and_thickness)
{
    const plane floor_ = { { 0, 1, 0 }, 2 };
    const real h = 0.5;
    pooled a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 2.7 + h, 0));
    contact_point c[8];
    // The lower four corners are 0.7 above the plane.
    ck_assert_int_eq(collide_plane(&a, floor_, 0.5, 0.19, c, 8), 0);
    ck_assert_int_eq(collide_plane(&a, floor_, 0.5, 0.21, c, 8), 4);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(c[i].a.count, 1);
        ck_assert_int_eq(c[i].b.count, 0);
        ck_assert(c[i].a.weight[0] == 1);
        vec3 low = feature_now(c[i].a, pool);
        ck_assert(fabs(low.y - 2.7) <= ROUNDING);
        near_vec3(c[i].fixed, vec3_make(low.x, 2, low.z), ROUNDING);
        near_vec3(c[i].normal, UP, 0);
        ck_assert(c[i].thickness == 0.21);
        ck_assert(fabs(gap_of(&c[i]) - 0.49) <= ROUNDING);
    }
    ck_assert_int_eq(collide_plane(&a, floor_, 2, 0, c, 8), 8);
}
END_TEST

// Rejects: a write past the buffer; a count that hides what found no room.
START_TEST(plane_counts_what_finds_no_room)
{
    const plane floor_ = { { 0, 1, 0 }, 2 };
    pooled a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 2, 0));
    contact_point c[4];
    c[3].thickness = -7;
    ck_assert_int_eq(collide_plane(&a, floor_, 0, 0, c, 3), 4);
    ck_assert(c[3].thickness == -7);
    ck_assert_int_eq(collide_plane(&a, floor_, 0, 0, NULL, 0), 4);
}
END_TEST

// Rejects: a height that is measured from the origin, or along y.
START_TEST(slanted_plane_pushes_along_its_normal)
{
    const plane wall = { { 0.6, 0.8, 0 }, -1 };
    pooled a = stand(&cube, FIRST_A, 1, UPRIGHT,
                       vec3_scale(-1.6, wall.normal));
    contact_point c[8];
    int n = collide_plane(&a, wall, 0, 0, c, 8);
    ck_assert_int_eq(n, 6);
    for (int i = 0; i < n; i++) {
        ck_assert(fabs(vec3_dot(c[i].fixed, wall.normal) + 1) <= ROUNDING);
        vec3 x = feature_now(c[i].a, pool);
        ck_assert(vec3_length(vec3_cross(vec3_sub(x, c[i].fixed),
                                         wall.normal)) <= ROUNDING);
        ck_assert(gap_of(&c[i]) <= 0);
    }
}
END_TEST

// --- the planes of a hull ----------------------------------------------------

// Rejects: two planes for one side; normals inwards; a plane that some corner
// is in front of; the second face of a side instead of the first.
START_TEST(cube_has_six_planes_and_icosahedron_twenty)
{
    plane p[20];
    int face[20];
    const shape *s[2] = { &cube, &ball };
    for (int k = 0; k < 200; k++) {
        const shape *now = s[k % 2];
        vec3 spot = any_vec3(5);
        pooled a = stand(now, FIRST_A, 1, any_axes(), spot);
        int n = hull_planes(now, a.at, p, face);
        ck_assert_int_eq(n, k % 2 ? 20 : 6);
        for (int i = 0; i < n; i++) {
            ck_assert(fabs(vec3_length(p[i].normal) - 1) <= ROUNDING);
            const int *v = &now->face[3 * face[i]];
            real on = 0;
            for (int j = 0; j < now->particles; j++) {
                real up = vec3_dot(a.at[j], p[i].normal) - p[i].offset;
                ck_assert(up <= ORACLE);
                on = fmin(on, up);
            }
            ck_assert(on < -0.5);
            for (int j = 0; j < 3; j++)
                ck_assert(fabs(vec3_dot(a.at[v[j]], p[i].normal)
                               - p[i].offset) <= ORACLE);
            if (i > 0) ck_assert_int_gt(face[i], face[i - 1]);
        }
        ck_assert_int_eq(face[0], 0);
    }
}
END_TEST

// Rejects: the first plane that x is in front of; the nearest plane for one
// that is behind all; ties that go to the last.
START_TEST(plane_ahead_is_the_one_furthest_behind)
{
    plane p[6];
    int face[6];
    pooled a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 0, 0));
    int n = hull_planes(&cube, a.at, p, face);
    for (int k = 0; k < 500; k++) {
        vec3 x = any_vec3(k % 2 ? 2 : 0.4);
        int ahead = hull_ahead(x, p, n);
        for (int i = 0; i < n; i++) {
            real up = plane_height(p[i], x);
            ck_assert(up == vec3_dot(x, p[i].normal) - p[i].offset);
            ck_assert(up <= plane_height(p[ahead], x));
        }
    }
    ck_assert_int_eq(hull_ahead(vec3_make(0, 0, 0), p, n), 0);
}
END_TEST

// --- a particle at a convex body ---------------------------------------------

static void is_sound_point(const contact_point *c, pooled b)
{
    pooled a = { &cube, FIRST_A, place + FIRST_A, 1 };
    is_sound(c, a, b);
    ck_assert_int_eq(c->a.count, 1);
    ck_assert_int_eq(c->a.vertex[0], FIRST_A + 2);
    ck_assert_int_eq(c->b.count > 0, b.mass < HUGE_VAL);
    if (c->b.count > 0)
        near_vec3(feature_now(c->b, pool), c->fixed, ORACLE);
}

static const real MASS[2] = { 2, HUGE_VAL };

// Rejects: the way out through the face that is furthest; a gap that is not
// minus the depth.
START_TEST(particle_inside_leaves_by_the_nearest_face)
{
    for (int m = 0; m < 2; m++) {
        pooled b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
        contact_point c;
        ck_assert_int_eq(ask(b, vec3_make(0.1, 0.45, -0.2), 0, &c), 1);
        is_sound_point(&c, b);
        near_vec3(c.normal, UP, ROUNDING);
        near_vec3(c.fixed, vec3_make(0.1, 0.5, -0.2), ROUNDING);
        ck_assert(fabs(gap_of(&c) + 0.05) <= ROUNDING);
        ck_assert_int_eq(ask(b, vec3_make(0.2, 0.1, -0.3), 0, &c), 1);
        near_vec3(c.normal, vec3_make(0, 0, -1), ROUNDING);
        ck_assert(fabs(gap_of(&c) + 0.2) <= ROUNDING);
    }
}
END_TEST

// Rejects: reach compared with the depth; a particle beyond reach that counts.
START_TEST(particle_over_a_face_stands_on_its_foot)
{
    for (int m = 0; m < 2; m++) {
        pooled b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
        contact_point c;
        vec3 x = vec3_make(-0.3, 0.2, 0.6);
        ck_assert_int_eq(ask(b, x, 0.09, &c), 0);
        ck_assert_int_eq(ask(b, x, 0, &c), 0);
        ck_assert_int_eq(ask(b, x, 0.11, &c), 1);
        is_sound_point(&c, b);
        near_vec3(c.normal, vec3_make(0, 0, 1), ROUNDING);
        near_vec3(c.fixed, vec3_make(-0.3, 0.2, 0.5), ROUNDING);
        ck_assert(fabs(gap_of(&c) - 0.1) <= ROUNDING);
    }
}
END_TEST

// Rejects: the plane's height taken for the distance, which is longer here: the
// particle at (0.3, 0.4) off the edge is 0.5 away, and 0.4 over a plane.
START_TEST(particle_over_an_edge_is_pushed_away_from_the_edge)
{
    for (int m = 0; m < 2; m++) {
        pooled b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
        contact_point c;
        vec3 x = vec3_make(0.8, 0.9, 0.1);
        ck_assert_int_eq(ask(b, x, 0.49, &c), 0);
        ck_assert_int_eq(ask(b, x, 0.51, &c), 1);
        is_sound_point(&c, b);
        near_vec3(c.normal, vec3_make(0.6, 0.8, 0), ORACLE);
        near_vec3(c.fixed, vec3_make(0.5, 0.5, 0.1), ORACLE);
        ck_assert(fabs(gap_of(&c) - 0.5) <= ORACLE);
    }
}
END_TEST

// Rejects: an edge's line that is taken beyond its end.
START_TEST(particle_over_a_corner_is_pushed_away_from_the_corner)
{
    for (int m = 0; m < 2; m++) {
        pooled b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
        contact_point c;
        // Off the corner by (2, 3, 6) tenths: 0.7 away.
        vec3 x = vec3_make(0.7, -0.8, 1.1);
        ck_assert_int_eq(ask(b, x, 0.69, &c), 0);
        ck_assert_int_eq(ask(b, x, 0.71, &c), 1);
        is_sound_point(&c, b);
        near_vec3(c.normal, vec3_scale(1 / 0.7, vec3_make(0.2, -0.3, 0.6)),
                  ORACLE);
        near_vec3(c.fixed, vec3_make(0.5, -0.5, 0.5), ORACLE);
    }
}
END_TEST

// Rejects: an answer of collide_point that is not the distance; the closed form
// used where it does not hold (blunt edges: x in front of three planes; a sharp
// edge: over one face alone, but beside it; an edge between the two planes that
// are in front, of which x is over neither end).
START_TEST(particle_finds_what_the_search_finds)
{
    const shape *const solid[] = { &cube, &ball, &slab, &wedge };
    int faces = 0, edges = 0, insides = 0;
    for (int k = 0; k < 20000; k++) {
        const shape *s = solid[k % 4];
        vec3 spot = any_vec3(1);
        pooled b = stand_hull(s, MASS[k % 3 == 0], any_axes(), spot);
        vec3 x = vec3_add(spot, any_vec3(s == &slab ? 2.5 : 1.5));
        gjk_result g = distance_to(b, x);
        real reach = 0.6;
        contact_point c;
        int near = ask(b, x, reach, &c);
        if (g.status == GJK_APART) {
            ck_assert_int_eq(near, g.distance <= reach);
            if (!near) continue;
            is_sound_point(&c, b);
            ck_assert(fabs(gap_of(&c) - g.distance) <= ORACLE);
            near_vec3(c.fixed, g.on_b, ORACLE);
            int front = 0;
            for (int i = 0; i < wall_count; i++)
                front += vec3_dot(x, walls[i].normal) > walls[i].offset;
            faces += front == 1;
            edges += front > 1;
            continue;
        }
        ck_assert_int_eq(near, 1);
        is_sound_point(&c, b);
        real depth = DBL_MAX;
        for (int i = 0; i < wall_count; i++)
            depth = fmin(depth, walls[i].offset - vec3_dot(x, walls[i].normal));
        ck_assert(fabs(gap_of(&c) + depth) <= ORACLE);
        insides++;
    }
    ck_assert_int_gt(faces, 50);
    ck_assert_int_gt(edges, 150);
    ck_assert_int_gt(insides, 100);
}
END_TEST

// Rejects: a foot on the line between two triangles, which rounding leaves
// outside both, that becomes a corner of the face far away: the push would act
// there.
START_TEST(particle_over_a_diagonal_pushes_the_diagonal)
{
    for (int k = 0; k < 2000; k++) {
        const shape *s = k % 2 ? &ball : &cube;
        vec3 spot = any_vec3(1);
        pooled b = stand_hull(s, 2, any_axes(), spot);
        const int *v = &s->face[3 * (k % s->mesh.faces)];
        int side = k % 3;
        real u = (any() + 1) / 2;
        vec3 p = b.at[v[side]], q = b.at[v[(side + 1) % 3]];
        vec3 x = vec3_add(vec3_scale(u, p), vec3_scale(1 - u, q));
        plane face;
        vec3 m = vec3_unit(vec3_cross(vec3_sub(b.at[v[1]], b.at[v[0]]),
                                      vec3_sub(b.at[v[2]], b.at[v[0]])));
        face = (plane){ m, vec3_dot(m, b.at[v[0]]) };
        contact_point c;
        int near = ask(b, vec3_add_scaled(x, k % 5 ? -0.01 : 0.01, face.normal),
                       0.1, &c);
        ck_assert_int_eq(near, 1);
        is_sound_point(&c, b);
    }
}
END_TEST

// A body is never quite its plan: sticks leave a strain.  Then the two faces of
// a side have a plane each, and one of them reaches over the other.
// Rejects: the face under a particle looked for among the later faces only.
START_TEST(particle_over_a_strained_face_pushes_what_is_under_it)
{
    const real STRAIN = 1e-4;
    for (int k = 0; k < 2000; k++) {
        vec3 spot = any_vec3(1);
        pooled b = stand(&cube, FIRST_B, 2, any_axes(), spot);
        for (int i = 0; i < 8; i++) {
            place[FIRST_B + i] = vec3_add(place[FIRST_B + i],
                                          any_vec3(STRAIN));
            pool[FIRST_B + i].position = place[FIRST_B + i];
        }
        wall_count = hull_planes(&cube, b.at, walls, wall_face);
        const int *v = &cube.face[3 * (k % 12)];
        real u = (any() + 1) / 2, w = (any() + 1) / 2 * (1 - u);
        vec3 x = vec3_add(vec3_scale(1 - u - w, b.at[v[0]]),
                 vec3_add(vec3_scale(u, b.at[v[1]]),
                          vec3_scale(w, b.at[v[2]])));
        contact_point c;
        ck_assert_int_eq(ask(b, x, 0.01, &c), 1);
        ck_assert_int_eq(c.a.vertex[0], FIRST_A + 2);
        vec3 under = feature_now(c.b, pool);
        ck_assert_msg(vec3_distance(under, x) <= 10 * STRAIN,
                      "pushes a point %g m away", vec3_distance(under, x));
    }
}
END_TEST

// Two faces of a side that is strained outwards are an edge so blunt that the
// two planes tell nothing of where it runs.
// Rejects: the closed form of an edge divided by almost nothing.
START_TEST(particle_over_the_fold_of_a_strained_side_finds_the_fold)
{
    for (int k = 0; k < 2000; k++) {
        vec3 spot = any_vec3(1);
        pooled b = stand(&cube, FIRST_B, MASS[k % 2], any_axes(), spot);
        const int *v = &cube.face[3 * (k % 12)];
        int side = k % 3;
        vec3 p = b.at[v[side]], q = b.at[v[(side + 1) % 3]];
        vec3 up = vec3_unit(vec3_sub(vec3_scale(0.5, vec3_add(p, q)), spot));
        // Both ends of the fold, or of the edge, are drawn outwards.
        for (int i = 0; i < 2; i++) {
            int end = FIRST_B + v[(side + i) % 3];
            place[end] = vec3_add_scaled(place[end], 1e-5, up);
            pool[end].position = place[end];
        }
        wall_count = hull_planes(&cube, b.at, walls, wall_face);
        real u = (any() + 1) / 2;
        vec3 x = vec3_add(vec3_scale(u, p), vec3_scale(1 - u, q));
        x = vec3_add_scaled(x, 0.05, up);
        gjk_result g = distance_to(b, x);
        contact_point c;
        ck_assert_int_eq(ask(b, x, 0.1, &c), 1);
        is_sound_point(&c, b);
        ck_assert(fabs(gap_of(&c) - g.distance) <= ORACLE);
        near_vec3(c.fixed, g.on_b, 1e-9);
    }
}
END_TEST

// Rejects: NaN that passes every comparison and becomes a contact.
START_TEST(particle_that_is_not_finite_touches_nothing)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < 9; k++) {
            pooled b = stand_hull(&cube, MASS[m], UPRIGHT,
                                    vec3_make(0, 0, 0));
            real x[3] = { 0.1, 0.2, 0.3 };
            x[k / 3] = bad[k % 3];
            contact_point c;
            ck_assert_int_eq(ask(b, vec3_make(x[0], x[1], x[2]), 1, &c), 0);
        }
}
END_TEST

static Suite *suite(void)
{
    const TTest *const test[] = {
        plane_meets_what_is_nearer_than_margin_and_thickness,
        plane_counts_what_finds_no_room,
        slanted_plane_pushes_along_its_normal,
        cube_has_six_planes_and_icosahedron_twenty,
        plane_ahead_is_the_one_furthest_behind,
        particle_inside_leaves_by_the_nearest_face,
        particle_over_a_face_stands_on_its_foot,
        particle_over_an_edge_is_pushed_away_from_the_edge,
        particle_over_a_corner_is_pushed_away_from_the_corner,
        particle_finds_what_the_search_finds,
        particle_over_a_diagonal_pushes_the_diagonal,
        particle_over_a_strained_face_pushes_what_is_under_it,
        particle_over_the_fold_of_a_strained_side_finds_the_fold,
        particle_that_is_not_finite_touches_nothing,
    };
    Suite *s = suite_create("obstacle");
    TCase *t = tcase_create("obstacle");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof test / sizeof *test; i++)
        tcase_add_test(t, test[i]);
    suite_add_tcase(s, t);
    return s;
}

int main(void)
{
    SRunner *runner = srunner_create(suite());
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
