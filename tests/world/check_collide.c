// check_collide.c - which contacts do two bodies have?  Book: chapter 9.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "collide.h"
#include "convex.h"

// Bodies of size 1 near the origin; a corner is turned, a foot is a mean of
// three: a few dozen roundings.
#define ROUNDING 1e-13
// Corners nearer than a billionth of the bodies are one; the manifold takes the
// first.
#define SLACK 2e-9
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
static penetration_scratch *scratch;

// Puts body `first` there: in the pool, and where the queries look.
static collider stand(const shape *s, int first, real mass, axes f, vec3 at)
{
    for (int i = 0; i < s->particles; i++) {
        vec3 x = vec3_add(at, turned(f, s->at[i]));
        place[first + i] = x;
        pool[first + i] = (particle){ x, x, mass < HUGE_VAL ? 1 : 0 };
    }
    return (collider){ s, first, place + first, mass, { NULL, NULL } };
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
    scratch = penetration_scratch_new();
    ck_assert_ptr_nonnull(scratch);
}

static void tear_down(void)
{
    penetration_scratch_free(scratch);
    shape_free(&cube);
    shape_free(&slab);
    shape_free(&ball);
    shape_free(&wedge);
}

static int touch(collider a, collider b, real margin,
                 contact_point out[PAIR_CONTACTS])
{
    distance_cache fresh = { .count = 0 };
    return collide_rigid(&a, &b, margin, &fresh, scratch, out);
}

static point_set points_of(collider c)
{
    return (point_set){ c.at, c.plan->particles, NULL, NULL };
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
static void is_sound(const contact_point *c, collider a, collider b)
{
    ck_assert(fabs(vec3_length(c->normal) - 1) <= ROUNDING);
    ck_assert_int_ge(c->a.count, 1);
    const feature_point *side[2] = { &c->a, &c->b };
    const collider *body[2] = { &a, &b };
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
static plane hull[20];
static int hull_face[20], hull_count;

static collider stand_hull(const shape *s, real mass, axes f, vec3 at)
{
    collider b = stand(s, FIRST_B, mass, f, at);
    hull_count = hull_planes(s, b.at, hull, hull_face);
    return b;
}

// A single particle as a body of its own: number `FIRST_A + 2` of the pool.
static int ask(collider b, vec3 x, real reach, contact_point *c)
{
    vec3 *at = place + FIRST_A;
    at[2] = x;
    pool[FIRST_A + 2] = (particle){ x, x, 1 };
    collider a = { &cube, FIRST_A, at, 1, { NULL, NULL } };
    return collide_point(&a, 2, &b, hull, hull_face, hull_count, reach, c);
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
// the corner; vertices that count from the body instead of the pool.
START_TEST(corner_over_a_face_is_one_vertex_against_a_point_of_the_face)
{
    // Half the diagonal of the cube is sqrt(3) / 2; the slab's top is y = 0.5.
    real height = 0.5 + 0.05 + sqrt(3) / 2;
    collider a = stand(&cube, FIRST_A, 1, on_a_corner(),
                       vec3_make(0.3, height, -0.2));
    collider b = stand(&slab, FIRST_B, 2, UPRIGHT, vec3_make(0, 0, 0));
    contact_point c[PAIR_CONTACTS];
    ck_assert_int_eq(touch(a, b, 0.1, c), 1);
    is_sound(&c[0], a, b);
    near_vec3(c[0].normal, UP, ORACLE);
    ck_assert_int_eq(c[0].a.count, 1);
    near_vec3(feature_now(c[0].a, pool), vec3_make(0.3, 0.55, -0.2), ORACLE);
    near_vec3(point_on_b(&c[0]), vec3_make(0.3, 0.5, -0.2), ORACLE);
    ck_assert(fabs(gap_of(&c[0]) - 0.05) <= ORACLE);
}
END_TEST

// Rejects: a manifold that invents corners where two edges cross; normal of the
// wrong sign.
START_TEST(crossed_edges_touch_in_their_middles)
{
    const real h = sqrt(0.5);
    axes about_x = { { 1, 0, 0 }, { 0, h, h }, { 0, -h, h } };
    axes about_z = { { h, h, 0 }, { -h, h, 0 }, { 0, 0, 1 } };
    collider b = stand(&cube, FIRST_B, 1, about_z, vec3_make(0, 0, 0));
    real gap[] = { 0.03, -0.03 };
    for (int k = 0; k < 2; k++) {
        collider a = stand(&cube, FIRST_A, 1, about_x,
                           vec3_make(0, 2 * h + gap[k], 0));
        contact_point c[PAIR_CONTACTS];
        ck_assert_int_eq(touch(a, b, 0.1, c), 1);
        is_sound(&c[0], a, b);
        near_vec3(c[0].normal, UP, ORACLE);
        ck_assert_int_eq(c[0].a.count, 2);
        ck_assert_int_eq(c[0].b.count, 2);
        near_vec3(point_on_b(&c[0]), vec3_make(0, h, 0), ORACLE);
        near_vec3(feature_now(c[0].a, pool), vec3_make(0, h + gap[k], 0),
                  ORACLE);
    }
}
END_TEST

// The least distance that parts a from b along n, by all pairs of corners.
static real parting(collider a, collider b, vec3 n)
{
    real least_a = DBL_MAX, most_b = -DBL_MAX;
    for (int i = 0; i < a.plan->particles; i++)
        least_a = fmin(least_a, vec3_dot(a.at[i], n));
    for (int i = 0; i < b.plan->particles; i++)
        most_b = fmax(most_b, vec3_dot(b.at[i], n));
    return most_b - least_a;
}

// Rejects: a normal from A to B; a point of the wrong body; weights of the
// distance_cache that belong to other vertices; a gap that is not the distance, or not
// the depth.
START_TEST(first_contact_is_the_distance_or_the_depth)
{
    int apart = 0, overlapping = 0;
    for (int k = 0; k < 3000; k++) {
        // Drawn before the call: C leaves open which argument comes first.
        vec3 spot = any_vec3(0.8);
        collider a = stand(k % 2 ? &ball : &cube, FIRST_A, 1, any_axes(),
                           spot);
        collider b = stand(k % 3 ? &cube : &ball, FIRST_B, 3, any_axes(),
                           vec3_make(0, 0, 0));
        distance_result g = distance_find(points_of(a), points_of(b),
                                    distance_options_default(), NULL);
        contact_point c[PAIR_CONTACTS];
        int n = touch(a, b, 0.5, c);
        if (g.status == DISTANCE_APART && g.distance > 0.5) {
            ck_assert_int_eq(n, 0);
            continue;
        }
        ck_assert_int_ge(n, 1);
        is_sound(&c[0], a, b);
        // What the contact says is -gap, and it parts the bodies: no corner of
        // A is left below any of B.
        ck_assert(fabs(parting(a, b, c[0].normal) + gap_of(&c[0])) <= SLACK);
        if (g.status == DISTANCE_APART) {
            apart++;
            ck_assert(fabs(gap_of(&c[0]) - g.distance) <= SLACK);
        } else {
            overlapping++;
            ck_assert(gap_of(&c[0]) <= SLACK);
        }
    }
    ck_assert_int_gt(apart, 300);
    ck_assert_int_gt(overlapping, 300);
}
END_TEST

// Rejects: a margin that is compared the wrong way round, or added twice.
START_TEST(margin_is_where_contacts_begin)
{
    collider b = stand(&slab, FIRST_B, HUGE_VAL, UPRIGHT, vec3_make(0, 0, 0));
    contact_point c[PAIR_CONTACTS];
    for (int k = 0; k < 2; k++) {
        axes f = k ? on_a_corner() : UPRIGHT;
        real low = k ? sqrt(3) / 2 : 0.5;
        collider a = stand(&cube, FIRST_A, 1, f,
                           vec3_make(0.1, 0.5 + low + 0.0999, 0.2));
        ck_assert_int_ge(touch(a, b, 0.1, c), 1);
        a = stand(&cube, FIRST_A, 1, f,
                  vec3_make(0.1, 0.5 + low + 0.1001, 0.2));
        ck_assert_int_eq(touch(a, b, 0.1, c), 0);
        ck_assert_int_eq(touch(a, b, 0, c), 0);
    }
}
END_TEST

// The search may have ended before it knows that the margin is passed.
// Rejects: whatever it found then taken for a contact.
START_TEST(margin_counts_to_the_last_digit)
{
    int inside = 0, beyond = 0;
    for (int k = 0; k < 3000; k++) {
        vec3 spot = vec3_scale(1.5, vec3_unit(any_vec3(1)));
        collider b = stand_hull(&ball, 1, any_axes(), vec3_make(0, 0, 0));
        collider a = stand(&cube, FIRST_A, 1, any_axes(), spot);
        distance_result g = distance_find(points_of(a), points_of(b),
                                    distance_options_default(), NULL);
        if (g.status != DISTANCE_APART) continue;
        const real margin[] = { nextafter(g.distance, 0), g.distance,
                                nextafter(g.distance, 9) };
        contact_point c[PAIR_CONTACTS];
        for (int i = 0; i < 3; i++) {
            int n = touch(a, b, margin[i], c);
            inside += n > 0;
            beyond += n == 0;
            if (n) ck_assert(fabs(gap_of(&c[0]) - margin[i]) <= SLACK);
        }
        point_set point = { &spot, 1, NULL, NULL };
        g = distance_find(point, points_of(b), distance_options_default(), NULL);
        for (int i = -1; i < 2; i++) {
            real reach = g.distance + i * DBL_EPSILON * g.distance;
            int n = ask(b, spot, reach, c);
            if (n) ck_assert(fabs(gap_of(&c[0]) - reach) <= ORACLE);
        }
    }
    ck_assert(inside > 1000 && beyond > 1000);
}
END_TEST

// Rejects: NaN that becomes a contact, and from there a position; an assert
// about a margin that was made of such numbers.
START_TEST(bodies_that_are_not_finite_have_no_contact)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 3; k++) {
        collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 0.9, 0));
        collider b = stand(&cube, FIRST_B, 1, UPRIGHT, vec3_make(0, 0, 0));
        place[FIRST_A + 3].y = bad[k];
        contact_point c[PAIR_CONTACTS];
        ck_assert_int_eq(touch(a, b, 0.1, c), 0);
        ck_assert_int_eq(touch(b, a, 0.1, c), 0);
        ck_assert_int_eq(touch(b, a, (real)NAN, c), 0);
    }
}
END_TEST

// --- who is A ----------------------------------------------------------------

// Rejects: an immovable A, of which contact_separate would push the wrong side;
// a feature of an immovable body; a normal that is not turned with the swap.
START_TEST(immovable_body_is_always_b)
{
    collider still = stand(&slab, FIRST_B, HUGE_VAL, UPRIGHT,
                           vec3_make(0, 0, 0));
    collider free_ = stand(&cube, FIRST_A, 1, UPRIGHT,
                           vec3_make(0.2, 0.99, 0.1));
    for (int k = 0; k < 2; k++) {
        contact_point c[PAIR_CONTACTS];
        int n = k ? touch(still, free_, 0.1, c)
                  : touch(free_, still, 0.1, c);
        ck_assert_int_ge(n, 4);
        for (int i = 0; i < n; i++) {
            is_sound(&c[i], free_, still);
            ck_assert_int_eq(c[i].b.count, 0);
            near_vec3(c[i].normal, UP, ORACLE);
            ck_assert(fabs(c[i].fixed.y - 0.5) <= ORACLE);
            ck_assert(fabs(gap_of(&c[i]) + 0.01) <= ORACLE);
        }
    }
}
END_TEST

// Rejects: a contact that nobody can mend.
START_TEST(two_immovable_bodies_never_touch)
{
    collider a = stand(&cube, FIRST_A, HUGE_VAL, UPRIGHT, vec3_make(0, 0, 0));
    collider b = stand(&cube, FIRST_B, HUGE_VAL, UPRIGHT, vec3_make(0, 0.5, 0));
    contact_point c[PAIR_CONTACTS];
    ck_assert_int_eq(touch(a, b, 1, c), 0);
}
END_TEST

// --- who cannot be told apart ------------------------------------------------

// What is left of two cubes that were pressed flat into one plane overlaps, and
// has no way out.
// Rejects: a contact along no normal.
START_TEST(bodies_pressed_flat_into_one_plane_have_no_contact)
{
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0.2, 0, 0.1));
    collider b = stand(&cube, FIRST_B, 1, UPRIGHT, vec3_make(0, 0, 0));
    for (int i = 0; i < 8; i++)
        place[FIRST_A + i].y = place[FIRST_B + i].y = 0;
    contact_point c[PAIR_CONTACTS];
    ck_assert_int_eq(touch(a, b, 0.1, c), 0);
}
END_TEST

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

// An icosahedron, each face of which is cut three times.
static void make_fine_ball(shape *s)
{
    int vertices = ball.particles;
    fine_faces = 0;
    for (int i = 0; i < vertices; i++) fine_at[i] = vec3_unit(ball.at[i]);
    for (int f = 0; f < ball.mesh.faces; f++)
        add_face(ball.face[3 * f], ball.face[3 * f + 1], ball.face[3 * f + 2]);
    for (int round = 0; round < 3; round++)
        for (int f = fine_faces - 1; f >= 0; f--) cut_face(f, &vertices);
    ck_assert_int_eq(vertices, FINE);
    ck_assert_int_eq(fine_faces, 1280);
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
    make_fine_ball(&fine);
    collider a = { &fine, 0, fine.at, 1, { NULL, NULL } };
    collider b = { &fine, FINE, fine.at, 1, { NULL, NULL } };
    distance_cache fresh = { .count = 0 };
    rings ring;
    ck_assert(rings_build(&ring, &fine.mesh).ok);
    a.ring = b.ring = ring;
    point_set p = { fine.at, FINE, ring.start, ring.list };
    distance_result g = distance_find(p, p, distance_options_default(), NULL);
    ck_assert_int_eq(penetration_find(p, p, &g.last, scratch).status, PENETRATION_CAPPED);
    contact_point c[PAIR_CONTACTS];
    ck_assert_int_ge(collide_rigid(&a, &b, 0, &fresh, scratch, c), 1);
    vec3 on_a = { 0, 0, 0 }, on_b = { 0, 0, 0 };
    for (int i = 0; i < c[0].a.count; i++)
        on_a = vec3_add_scaled(on_a, c[0].a.weight[i],
                               fine.at[c[0].a.vertex[i]]);
    for (int i = 0; i < c[0].b.count; i++)
        on_b = vec3_add_scaled(on_b, c[0].b.weight[i],
                               fine.at[c[0].b.vertex[i] - FINE]);
    real gap = vec3_dot(vec3_sub(on_a, on_b), c[0].normal);
    // The least way out is through two faces.  A full polytope's last face
    // lies under them: the contact parts the balls to a hundredth.
    real least = 2 * shape_inner(&fine);
    ck_assert_msg(-gap > 0.99 * least && -gap < 1.001 * least,
                  "gap %g, the least way out %g", gap, least);
    rings_free(&ring);
    shape_free(&fine);
}
END_TEST

// --- on their way ------------------------------------------------------------

static swept_status sweep(collider a, collider b, vec3 way, real apart,
                          contact_point *c)
{
    static vec3 room[POOL];
    return collide_swept(&a, &b, way, apart, room, c);
}

// A cube comes corner down from above, and will be far below.
// Rejects: a contact of where they are, or would be, instead of where they
// first meet; features of the wrong body; a way that is not turned round when
// the immovable one comes first.
START_TEST(cube_on_its_way_touches_where_it_first_will)
{
    const real high = 3, mass[] = { 2, HUGE_VAL };
    for (int k = 0; k < 4; k++) {
        collider b = stand(&slab, FIRST_B, mass[k / 2], UPRIGHT,
                           vec3_make(0, -0.5, 0));
        collider a = stand(&cube, FIRST_A, 1, on_a_corner(),
                           vec3_make(0.1, high + sqrt(0.75), 0.2));
        const vec3 way = { 0.5, -100, 0 };
        contact_point c;
        // The slab comes up to the cube as the cube to it.
        int swap = k % 2;
        ck_assert_int_eq(swap ? sweep(b, a, vec3_scale(-1, way), 0.01, &c)
                              : sweep(a, b, way, 0.01, &c), SWEPT_TOUCHES);
        int turned_round = swap && b.mass < HUGE_VAL;
        near_vec3(c.normal, turned_round ? vec3_scale(-1, UP) : UP, 1e-6);
        const feature_point *corner = turned_round ? &c.b : &c.a;
        const feature_point *face = turned_round ? &c.a : &c.b;
        ck_assert_int_eq(corner->count, 1);
        near_vec3(feature_now(*corner, pool), vec3_make(0.1, high, 0.2), 1e-9);
        // 3 m of the 100 are 3 % of what it goes aside, to 1e-3 of a radius.
        real aside = 0.1 + 0.5 * (high - 0.01) / 100;
        vec3 met = turned_round ? feature_now(*face, pool) : point_on_b(&c);
        near_vec3(met, vec3_make(aside, 0, 0.2), 1e-3);
        ck_assert_int_eq(face->count > 0, b.mass < HUGE_VAL);
        ck_assert(c.thickness == 0);
    }
}
END_TEST

// Rejects: a contact with what is passed; one that is written all the same; one
// that nobody can mend.
START_TEST(who_passes_or_overlaps_has_no_contact_on_its_way)
{
    collider b = stand(&slab, FIRST_B, 1, UPRIGHT, vec3_make(0, -0.5, 0));
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 3, 0));
    contact_point kept = { .thickness = 7 }, c = kept;
    ck_assert_int_eq(sweep(a, b, vec3_make(100, -10, 0), 0, &c), SWEPT_PASSES);
    ck_assert_int_eq(sweep(a, b, UP, 0, &c), SWEPT_PASSES);
    ck_assert_int_eq(sweep(b, b, UP, 0, &c), SWEPT_OVERLAP);
    ck_assert_int_eq(sweep(a, b, vec3_make(0, (real)NAN, 0), 0, &c),
                     SWEPT_NOT_FINITE);
    a.mass = b.mass = HUGE_VAL;
    ck_assert_int_eq(sweep(a, b, vec3_make(0, -100, 0), 0, &c), SWEPT_PASSES);
    ck_assert(c.thickness == kept.thickness && c.a.count == 0);
}
END_TEST

// --- the manifold ------------------------------------------------------------

// Does one of the contacts push corner i of A alone (side 0), or of B (1)?
static const contact_point *with_corner(const contact_point *c, int n, int side, int i)
{
    for (int k = 0; k < n; k++) {
        const feature_point *f = side ? &c[k].b : &c[k].a;
        if (f->count == 1 && f->vertex[0] == i) return &c[k];
    }
    return NULL;
}

// Rejects: one point that lets the body tip; corners of the far face; a
// corner's foot in the wrong triangle; a corner twice, which doubles its push.
START_TEST(face_on_a_face_stands_on_its_four_corners)
{
    for (int k = 0; k < 50; k++) {
        axes f = any_axes();
        real gap = 0.04 * any();
        collider b = stand(&slab, FIRST_B, 5, f, any_vec3(2));
        vec3 middle = vec3_add(vec3_scale(0.125, vec3_add(
            vec3_add(vec3_add(b.at[0], b.at[1]), vec3_add(b.at[2], b.at[3])),
            vec3_add(vec3_add(b.at[4], b.at[5]), vec3_add(b.at[6], b.at[7])))),
            turned(f, vec3_make(any(), 1 + gap, any())));
        collider a = stand(&cube, FIRST_A, 1, f, middle);
        contact_point c[PAIR_CONTACTS];
        int n = touch(a, b, 0.05, c);
        ck_assert_int_eq(n, 4);
        for (int i = 0; i < n; i++) {
            is_sound(&c[i], a, b);
            near_vec3(c[i].normal, f.y, ORACLE);
            ck_assert(fabs(gap_of(&c[i]) - gap) <= ORACLE);
        }
        for (int i = 0; i < 8; i++) {
            const contact_point *at = with_corner(c, n, 0, FIRST_A + i);
            // Bit 1 of a corner's number: the upper ones.
            if (i & 2) { ck_assert_ptr_null(at); continue; }
            ck_assert_ptr_nonnull(at);
            near_vec3(point_on_b(at),
                      vec3_add_scaled(a.at[i], -gap, f.y), ORACLE);
        }
    }
}
END_TEST

// Rejects: corners of B that are forgotten, or whose normal or sign is A's.
START_TEST(corners_of_the_lower_body_carry_a_wide_one)
{
    collider b = stand(&cube, FIRST_B, 1, UPRIGHT, vec3_make(0.3, 0, 0.4));
    collider a = stand(&slab, FIRST_A, 5, UPRIGHT, vec3_make(0, 1.01, 0));
    contact_point c[PAIR_CONTACTS];
    int n = touch(a, b, 0.05, c);
    ck_assert_int_eq(n, 4);
    for (int i = 0; i < 8; i++) {
        const contact_point *at = with_corner(c, n, 1, FIRST_B + i);
        if (!(i & 2)) { ck_assert_ptr_null(at); continue; }
        ck_assert_ptr_nonnull(at);
        is_sound(at, a, b);
        near_vec3(at->normal, UP, ORACLE);
        near_vec3(feature_now(at->a, pool),
                  vec3_add_scaled(b.at[i], 0.01, UP), ORACLE);
    }
}
END_TEST

// Rejects: corners that stand beside the other face and not over it; edges
// that cross, left out.
START_TEST(shifted_boxes_share_one_corner_each_and_two_crossings)
{
    collider b = stand(&cube, FIRST_B, 1, UPRIGHT, vec3_make(0, 0, 0));
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0.4, 0.99, 0.3));
    contact_point c[PAIR_CONTACTS];
    int n = touch(a, b, 0.05, c);
    int corners_a = 0, corners_b = 0;
    for (int i = 0; i < n; i++) {
        is_sound(&c[i], a, b);
        ck_assert(fabs(gap_of(&c[i]) + 0.01) <= ORACLE);
        vec3 x = point_on_b(&c[i]);
        ck_assert(x.x >= -0.1 - ORACLE && x.x <= 0.5 + ORACLE);
        ck_assert(x.z >= -0.2 - ORACLE && x.z <= 0.5 + ORACLE);
    }
    for (int i = 0; i < 8; i++) {
        corners_a += with_corner(c, n, 0, FIRST_A + i) != NULL;
        corners_b += with_corner(c, n, 1, FIRST_B + i) != NULL;
    }
    // A's lowest corner with x, z least (number 0); B's with all most (7).
    ck_assert_int_eq(corners_a, 1);
    ck_assert_int_eq(corners_b, 1);
    ck_assert_ptr_nonnull(with_corner(c, n, 0, FIRST_A + 0));
    ck_assert_ptr_nonnull(with_corner(c, n, 1, FIRST_B + 7));
    ck_assert_int_eq(n, 4);
}
END_TEST

// Rejects: a buffer overrun where two equal faces have 4 + 4 corners; a vertex
// that two contacts push; a corner lost where vertices lie on vertices.
START_TEST(manifold_keeps_to_its_room_and_pushes_no_vertex_twice)
{
    for (int k = 0; k < 400; k++) {
        axes f = k % 2 ? any_axes() : UPRIGHT;
        vec3 off = k % 4 < 2 ? vec3_make(0, 0, 0) : any_vec3(0.01);
        collider b = stand(&cube, FIRST_B, 1, f, vec3_make(0, 0, 0));
        collider a = stand(&cube, FIRST_A, 1, f,
            turned(f, vec3_add(vec3_make(0, 0.99, 0), off)));
        contact_point c[PAIR_CONTACTS + 1];
        c[PAIR_CONTACTS].thickness = -7;
        int n = touch(a, b, 0.05, c);
        ck_assert_int_eq(n, 4);
        ck_assert(c[PAIR_CONTACTS].thickness == -7);
        for (int i = 0; i < n; i++) {
            is_sound(&c[i], a, b);
            for (int j = 0; j < i; j++) {
                if (c[i].a.count == 1 && c[j].a.count == 1)
                    ck_assert_int_ne(c[i].a.vertex[0], c[j].a.vertex[0]);
                if (c[i].b.count == 1 && c[j].b.count == 1)
                    ck_assert_int_ne(c[i].b.vertex[0], c[j].b.vertex[0]);
            }
        }
    }
}
END_TEST

// Rejects: a manifold that puts the deepest point elsewhere than first; a touch
// whose point on B is not where its feature is.
START_TEST(manifold_begins_with_the_nearest_or_deepest_point)
{
    int many = 0;
    for (int k = 0; k < 1000; k++) {
        vec3 spot = any_vec3(0.7);
        collider a = stand(k % 2 ? &ball : &cube, FIRST_A, 1, any_axes(), spot);
        collider b = stand(&cube, FIRST_B, 1, any_axes(), vec3_make(0, 0, 0));
        contact_point all[PAIR_CONTACTS];
        int m = touch(a, b, 0.1, all);
        distance_result g = distance_find(points_of(a), points_of(b),
                                    distance_options_default(), NULL);
        vec3 normal = vec3_scale(1 / g.distance, g.axis);
        real gap = g.distance;
        if (g.status == DISTANCE_OVERLAP) {
            penetration_result h = penetration_find(points_of(a), points_of(b), &g.last,
                                         scratch);
            normal = h.normal;
            gap = -h.depth;
        }
        ck_assert_int_eq(gap <= 0.1, m > 0);
        for (int i = 0; i < m; i++) {
            is_sound(&all[i], a, b);
            near_vec3(all[i].normal, normal, ORACLE);
            near_vec3(all[i].fixed, feature_now(all[i].b, pool), ROUNDING);
            ck_assert(gap_of(&all[i]) >= gap - ORACLE);
            ck_assert(gap_of(&all[i]) <= 0.1 + ORACLE);
        }
        if (m) ck_assert(fabs(gap_of(&all[0]) - gap) <= SLACK);
        many += m > 1;
    }
    ck_assert_int_gt(many, 200);
}
END_TEST

// --- planes ------------------------------------------------------------------

// Rejects: margin without thickness; a contact without the thickness that it is
// to keep; a fixed point that is not on the plane.
START_TEST(plane_meets_what_is_nearer_than_margin_and_thickness)
{
    const plane floor_ = { { 0, 1, 0 }, 2 };
    const real h = 0.5;
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 2.7 + h, 0));
    contact_point c[8];
    // The lower four corners are 0.7 above the plane.
    ck_assert_int_eq(collide_plane(&a, floor_, 0.5, 0.19, c, 8), 0);
    ck_assert_int_eq(collide_plane(&a, floor_, 0.5, 0.21, c, 8), 4);
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(c[i].a.count, 1);
        ck_assert_int_eq(c[i].b.count, 0);
        ck_assert(c[i].a.weight[0] == 1);
        vec3 corner = feature_now(c[i].a, pool);
        ck_assert(fabs(corner.y - 2.7) <= ROUNDING);
        near_vec3(c[i].fixed, vec3_make(corner.x, 2, corner.z), ROUNDING);
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
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 2, 0));
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
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT,
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
        collider a = stand(now, FIRST_A, 1, any_axes(), spot);
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
    collider a = stand(&cube, FIRST_A, 1, UPRIGHT, vec3_make(0, 0, 0));
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

static void is_sound_point(const contact_point *c, collider b)
{
    collider a = { &cube, FIRST_A, place + FIRST_A, 1, { NULL, NULL } };
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
        collider b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
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
        collider b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
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
        collider b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
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
        collider b = stand_hull(&cube, MASS[m], UPRIGHT, vec3_make(0, 0, 0));
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
        collider b = stand_hull(s, MASS[k % 3 == 0], any_axes(), spot);
        vec3 x = vec3_add(spot, any_vec3(s == &slab ? 2.5 : 1.5));
        point_set point = { &x, 1, NULL, NULL };
        distance_result g = distance_find(point, points_of(b), distance_options_default(),
                                    NULL);
        real reach = 0.6;
        contact_point c;
        int near = ask(b, x, reach, &c);
        if (g.status == DISTANCE_APART) {
            ck_assert_int_eq(near, g.distance <= reach);
            if (!near) continue;
            is_sound_point(&c, b);
            ck_assert(fabs(gap_of(&c) - g.distance) <= ORACLE);
            near_vec3(c.fixed, g.on_b, ORACLE);
            int front = 0;
            for (int i = 0; i < hull_count; i++)
                front += vec3_dot(x, hull[i].normal) > hull[i].offset;
            faces += front == 1;
            edges += front > 1;
            continue;
        }
        ck_assert_int_eq(near, 1);
        is_sound_point(&c, b);
        real depth = DBL_MAX;
        for (int i = 0; i < hull_count; i++)
            depth = fmin(depth, hull[i].offset - vec3_dot(x, hull[i].normal));
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
        collider b = stand_hull(s, 2, any_axes(), spot);
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
        collider b = stand(&cube, FIRST_B, 2, any_axes(), spot);
        for (int i = 0; i < 8; i++) {
            place[FIRST_B + i] = vec3_add(place[FIRST_B + i],
                                          any_vec3(STRAIN));
            pool[FIRST_B + i].position = place[FIRST_B + i];
        }
        hull_count = hull_planes(&cube, b.at, hull, hull_face);
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
        collider b = stand(&cube, FIRST_B, MASS[k % 2], any_axes(), spot);
        const int *v = &cube.face[3 * (k % 12)];
        int side = k % 3;
        vec3 p = b.at[v[side]], q = b.at[v[(side + 1) % 3]];
        vec3 up = vec3_unit(vec3_sub(vec3_scale(0.5, vec3_add(p, q)), spot));
        // Both ends of the fold, or of the edge, are drawn outwards.
        for (int i = 0; i < 2; i++) {
            int corner = FIRST_B + v[(side + i) % 3];
            place[corner] = vec3_add_scaled(place[corner], 1e-5, up);
            pool[corner].position = place[corner];
        }
        hull_count = hull_planes(&cube, b.at, hull, hull_face);
        real u = (any() + 1) / 2;
        vec3 x = vec3_add(vec3_scale(u, p), vec3_scale(1 - u, q));
        x = vec3_add_scaled(x, 0.05, up);
        point_set point = { &x, 1, NULL, NULL };
        distance_result g = distance_find(point, points_of(b), distance_options_default(),
                                    NULL);
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
            collider b = stand_hull(&cube, MASS[m], UPRIGHT,
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
        corner_over_a_face_is_one_vertex_against_a_point_of_the_face,
        crossed_edges_touch_in_their_middles,
        first_contact_is_the_distance_or_the_depth,
        margin_is_where_contacts_begin,
        margin_counts_to_the_last_digit,
        bodies_that_are_not_finite_have_no_contact,
        immovable_body_is_always_b,
        two_immovable_bodies_never_touch,
        bodies_pressed_flat_into_one_plane_have_no_contact,
        balls_in_one_place_are_parted_all_the_same,
        cube_on_its_way_touches_where_it_first_will,
        who_passes_or_overlaps_has_no_contact_on_its_way,
        face_on_a_face_stands_on_its_four_corners,
        corners_of_the_lower_body_carry_a_wide_one,
        shifted_boxes_share_one_corner_each_and_two_crossings,
        manifold_keeps_to_its_room_and_pushes_no_vertex_twice,
        manifold_begins_with_the_nearest_or_deepest_point,
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
    Suite *s = suite_create("collide");
    TCase *t = tcase_create("collide");
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
