// check_obstacle.c - convex bodies, as particles meet them.
// Book: chapter 16.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "axes.h"
#include "convex.h"
#include "expect.h"
#include "obstacle.h"
#include "suite.h"
#include "swept.h"

// Bodies of size 1 near the origin; a corner is turned, a foot is a mean of
// three: a few dozen roundings.
#define ROUNDING 1e-13
// The heights over planes against the searches of GJK, which stop at their own
// bound.
#define ORACLE 1e-11

static const vec3 UP = { 0, 1, 0 };

// --- bodies that stand somewhere ---------------------------------------------

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

// The body under test: where its vertices are, and its planes.
static vec3 place[20];
static plane walls[20];

static void stand(const shape *s, axes f, vec3 at)
{
    for (int i = 0; i < s->particles; i++)
        place[i] = vec3_add(at, turned(f, s->at[i]));
}

static obstacle look_at(const shape *s)
{
    return (obstacle){ { place, s->particles }, walls,
                       hull_planes(s, place, walls), s->radius,
                       s->round };
}

static obstacle put(const shape *s, axes f, vec3 at)
{
    stand(s, f, at);
    return look_at(s);
}

static gjk_result distance_to(const obstacle *b, vec3 x)
{
    hull point = { &x, 1 };
    return gjk_distance(point, b->vertices, HUGE_VAL, NULL);
}

static bool ask(const obstacle *b, vec3 x, real reach, surface_point *p)
{
    return obstacle_nearest(b, x, b->planes, reach, p);
}

// m, how far x is in front of the point; < 0: behind it.
static real height_over(const surface_point *p, vec3 x)
{
    return vec3_dot(vec3_sub(x, p->at), p->normal);
}

// The point lies on the surface, and x straight over it, or under it.
static void is_sound(const obstacle *b, const surface_point *p, vec3 x)
{
    ck_assert(fabs(vec3_length(p->normal) - 1) <= ROUNDING);
    real up = height_over(p, x), most = -HUGE_VAL;
    near_vec3(vec3_add_scaled(p->at, up, p->normal), x, ORACLE);
    for (int k = 0; k < b->planes; k++)
        most = fmax(most, plane_height(b->plane[k], p->at));
    ck_assert(fabs(most) <= ORACLE);
}

// --- the planes of a hull ----------------------------------------------------

// Rejects: two planes for one side; normals inwards; a plane that some corner
// is in front of.
START_TEST(cube_has_six_planes_and_icosahedron_twenty)
{
    const shape *s[2] = { &cube, &ball };
    for (int k = 0; k < 200; k++) {
        const shape *now = s[k % 2];
        vec3 spot = random_vec3(&seed, 5);
        obstacle b = put(now, any_axes(), spot);
        ck_assert_int_eq(b.planes, k % 2 ? 20 : 6);
        for (int i = 0; i < b.planes; i++) {
            ck_assert(fabs(vec3_length(walls[i].normal) - 1) <= ROUNDING);
            real low = 0;
            int on = 0;
            for (int j = 0; j < now->particles; j++) {
                real up = vec3_dot(place[j], walls[i].normal)
                        - walls[i].offset;
                ck_assert(up <= ORACLE);
                on += up >= -ORACLE;
                low = fmin(low, up);
            }
            ck_assert(low < -0.5);
            ck_assert_int_eq(on, k % 2 ? 3 : 4);
        }
    }
}
END_TEST

// Rejects: the top and the bottom of a leaf taken for one plane.
START_TEST(thin_leaf_has_a_plane_on_either_side)
{
    stand(&cube, UPRIGHT, vec3_make(0, 0, 0));
    for (int i = 0; i < 8; i++) place[i].y *= 1e-10;
    obstacle b = look_at(&cube);
    int up = 0, down = 0;
    for (int k = 0; k < b.planes; k++) {
        up += walls[k].normal.y > 0.9;
        down += walls[k].normal.y < -0.9;
    }
    ck_assert_int_eq(up, 1);
    ck_assert_int_eq(down, 1);
}
END_TEST

// Rejects: the first plane that x is in front of; the nearest plane for one
// that is behind all; ties that go to the last.
START_TEST(plane_ahead_is_the_one_furthest_behind)
{
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    for (int k = 0; k < 500; k++) {
        vec3 x = random_vec3(&seed, k % 2 ? 2 : 0.4);
        int ahead = hull_ahead(x, walls, b.planes);
        for (int i = 0; i < b.planes; i++) {
            real up = plane_height(walls[i], x);
            ck_assert(up == vec3_dot(x, walls[i].normal) - walls[i].offset);
            ck_assert(up <= plane_height(walls[ahead], x));
        }
    }
    ck_assert_int_eq(hull_ahead(vec3_make(0, 0, 0), walls, b.planes), 0);
}
END_TEST

// --- a particle at a convex body ---------------------------------------------

// Rejects: the way out through the face that is furthest.
START_TEST(particle_inside_leaves_by_the_nearest_face)
{
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    surface_point p;
    vec3 x = { 0.1, 0.45, -0.2 };
    ck_assert(ask(&b, x, 0, &p));
    is_sound(&b, &p, x);
    near_vec3(p.normal, UP, ROUNDING);
    near_vec3(p.at, vec3_make(0.1, 0.5, -0.2), ROUNDING);
    x = vec3_make(0.2, 0.1, -0.3);
    ck_assert(ask(&b, x, 0, &p));
    near_vec3(p.normal, vec3_make(0, 0, -1), ROUNDING);
    near_vec3(p.at, vec3_make(0.2, 0.1, -0.5), ROUNDING);
}
END_TEST

// Of a cube with a radius of 0.2.  Rejects: the planes of the core, or of the box
// around the body, for its surface; a way out of the core to its own face.
START_TEST(particle_at_a_rounded_body_is_out_from_its_core)
{
    shape round = cube;
    int inside = 0, over = 0;
    round.round = 0.2;
    near(shape_inner(&round), 0.7, ROUNDING);
    for (int k = 0; k < 2000; k++) {
        obstacle b = put(&round, any_axes(), vec3_make(1, 2, 3));
        vec3 x = vec3_add(vec3_make(1, 2, 3), random_vec3(&seed, 0.9));
        gjk_result g = distance_to(&b, x);
        real reach = 0.15, gap = g.distance - 0.2;
        surface_point p;
        bool is_near = ask(&b, x, reach, &p);
        if (g.status == GJK_OVERLAP) {
            real most = plane_height(walls[hull_ahead(x, walls, 6)], x);
            ck_assert(is_near && most <= -0.2);
            is_sound(&b, &p, x);
            near(height_over(&p, x), most, ORACLE);
            inside++;
            continue;
        }
        if (fabs(gap - reach) > ORACLE) ck_assert_int_eq(is_near, gap < reach);
        if (!is_near) continue;
        near(height_over(&p, x), gap, ORACLE);
        near(distance_to(&b, p.at).distance, 0.2, ORACLE);
        near_vec3(vec3_add_scaled(p.at, gap, p.normal), x, ORACLE);
        over++;
    }
    ck_assert(inside > 200 && over > 200);
}
END_TEST

// Rejects: reach compared with the depth; a particle beyond reach that counts.
START_TEST(particle_over_a_face_stands_on_its_foot)
{
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    surface_point p;
    vec3 x = { -0.3, 0.2, 0.6 };
    ck_assert(!ask(&b, x, 0.09, &p));
    ck_assert(!ask(&b, x, 0, &p));
    ck_assert(ask(&b, x, 0.11, &p));
    is_sound(&b, &p, x);
    near_vec3(p.normal, vec3_make(0, 0, 1), ROUNDING);
    near_vec3(p.at, vec3_make(-0.3, 0.2, 0.5), ROUNDING);
}
END_TEST

// Rejects: the plane's height taken for the distance, which is longer here: the
// particle at (0.3, 0.4) off the edge is 0.5 away, and 0.4 over a plane.
START_TEST(particle_over_an_edge_is_pushed_away_from_the_edge)
{
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    surface_point p;
    vec3 x = { 0.8, 0.9, 0.1 };
    ck_assert(!ask(&b, x, 0.49, &p));
    ck_assert(ask(&b, x, 0.51, &p));
    is_sound(&b, &p, x);
    near_vec3(p.normal, vec3_make(0.6, 0.8, 0), ORACLE);
    near_vec3(p.at, vec3_make(0.5, 0.5, 0.1), ORACLE);
}
END_TEST

// Rejects: an edge's line that is taken beyond its end.
START_TEST(particle_over_a_corner_is_pushed_away_from_the_corner)
{
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    surface_point p;
    // Off the corner by (2, 3, 6) tenths: 0.7 away.
    vec3 x = { 0.7, -0.8, 1.1 };
    ck_assert(!ask(&b, x, 0.69, &p));
    ck_assert(ask(&b, x, 0.71, &p));
    is_sound(&b, &p, x);
    near_vec3(p.normal, vec3_scale(1 / 0.7, vec3_make(0.2, -0.3, 0.6)), ORACLE);
    near_vec3(p.at, vec3_make(0.5, -0.5, 0.5), ORACLE);
}
END_TEST

// m, how deep x is in the body.
static real depth_of(const obstacle *b, vec3 x)
{
    real depth = DBL_MAX;
    for (int i = 0; i < b->planes; i++)
        depth = fmin(depth, walls[i].offset - vec3_dot(x, walls[i].normal));
    return depth;
}

static int planes_before(const obstacle *b, vec3 x)
{
    int n = 0;
    for (int i = 0; i < b->planes; i++)
        n += vec3_dot(x, walls[i].normal) > walls[i].offset;
    return n;
}

// Rejects: an answer that is not the distance; a face taken where an edge is
// nearest (blunt edges: x in front of three planes; a sharp edge: over one face
// alone, but beside it).
START_TEST(particle_finds_what_the_search_finds)
{
    const shape *const solid[] = { &cube, &ball, &slab, &wedge };
    int faces = 0, edges = 0, insides = 0;
    for (int k = 0; k < 20000; k++) {
        const shape *s = solid[k % 4];
        vec3 spot = random_vec3(&seed, 1);
        obstacle b = put(s, any_axes(), spot);
        vec3 x = vec3_add(spot, random_vec3(&seed, s == &slab ? 2.5 : 1.5));
        gjk_result g = distance_to(&b, x);
        bool is_outside = g.status == GJK_APART;
        surface_point p;
        bool near = ask(&b, x, 0.6, &p);
        ck_assert(near == (!is_outside || g.distance <= 0.6));
        if (!near) continue;
        is_sound(&b, &p, x);
        real wanted = is_outside ? g.distance : -depth_of(&b, x);
        ck_assert(fabs(height_over(&p, x) - wanted) <= ORACLE);
        if (is_outside) near_vec3(p.at, g.on_b, ORACLE);
        insides += !is_outside;
        faces += is_outside && planes_before(&b, x) == 1;
        edges += is_outside && planes_before(&b, x) > 1;
    }
    ck_assert_int_gt(faces, 50);
    ck_assert_int_gt(edges, 150);
    ck_assert_int_gt(insides, 100);
}
END_TEST

// The search may have ended before it knows that the reach is passed.
// Rejects: what it found then taken for near.
START_TEST(reach_counts_to_the_last_digit)
{
    int inside = 0, beyond = 0;
    for (int k = 0; k < 5000; k++) {
        obstacle b = put(k % 2 ? &ball : &wedge, any_axes(),
                         vec3_make(0, 0, 0));
        vec3 x = vec3_scale(1.2, vec3_unit(random_vec3(&seed, 1)));
        gjk_result g = distance_to(&b, x);
        if (g.status != GJK_APART) continue;
        for (int i = -1; i < 2; i++) {
            real reach = g.distance * (1 + i * DBL_EPSILON);
            surface_point p;
            bool is_near = ask(&b, x, reach, &p);
            inside += is_near;
            beyond += !is_near;
            if (is_near) ck_assert(vec3_distance(p.at, x) <= reach + ROUNDING);
        }
        surface_point p;
        ck_assert(!ask(&b, x, (1 - 1e-9) * g.distance, &p));
        ck_assert(ask(&b, x, (1 + 1e-9) * g.distance, &p));
    }
    ck_assert(inside > 1000 && beyond > 1000);
}
END_TEST

// Where a particle was when it was listed says where to look first, and no
// more: since then it may have come round to any face.
// Rejects: the plane that it was in front of taken for the one it is at.
START_TEST(plane_known_before_changes_nothing)
{
    const shape *const solid[] = { &cube, &ball, &wedge };
    int near = 0;
    for (int k = 0; k < 5000; k++) {
        vec3 spot = random_vec3(&seed, 1);
        obstacle b = put(solid[k % 3], any_axes(), spot);
        vec3 x = vec3_add(spot, random_vec3(&seed, 0.9));
        surface_point wanted, got;
        bool is_near = ask(&b, x, 0.1, &wanted);
        near += is_near;
        for (int ahead = 0; ahead <= b.planes + 1; ahead++) {
            ck_assert(obstacle_nearest(&b, x, ahead, 0.1, &got) == is_near);
            if (!is_near) continue;
            near_vec3(got.at, wanted.at, ROUNDING);
            near_vec3(got.normal, wanted.normal, ROUNDING);
        }
    }
    ck_assert_int_gt(near, 500);
}
END_TEST

// A body is never quite its shape: sticks leave a strain.  Then the two faces
// of a side have a plane each, and one of them reaches over the other.
// Rejects: a face that is not found because its plane lies under another's.
START_TEST(particle_on_a_strained_face_is_near_it)
{
    const real STRAIN = 1e-4;
    for (int k = 0; k < 2000; k++) {
        vec3 spot = random_vec3(&seed, 1);
        stand(&cube, any_axes(), spot);
        for (int i = 0; i < 8; i++)
            place[i] = vec3_add(place[i], random_vec3(&seed, STRAIN));
        obstacle b = look_at(&cube);
        const int *v = &cube.face[3 * (k % 12)];
        real u = random_fraction(&seed),
             w = random_fraction(&seed) * (1 - u);
        vec3 x = vec3_add(vec3_scale(1 - u - w, place[v[0]]),
                 vec3_add(vec3_scale(u, place[v[1]]),
                          vec3_scale(w, place[v[2]])));
        surface_point p;
        ck_assert(ask(&b, x, 0.01, &p));
        ck_assert_msg(vec3_distance(p.at, x) <= 10 * STRAIN,
                      "a point %g m away", vec3_distance(p.at, x));
    }
}
END_TEST

// Two faces of a side that is strained outwards are an edge so blunt that the
// two planes tell nothing of where it runs.
// Rejects: an edge found by dividing by almost nothing.
START_TEST(particle_over_the_fold_of_a_strained_side_finds_the_fold)
{
    for (int k = 0; k < 2000; k++) {
        vec3 spot = random_vec3(&seed, 1);
        stand(&cube, any_axes(), spot);
        const int *v = &cube.face[3 * (k % 12)];
        int side = k % 3;
        vec3 p = place[v[side]], q = place[v[(side + 1) % 3]];
        vec3 up = vec3_unit(vec3_sub(vec3_scale(0.5, vec3_add(p, q)), spot));
        // Both ends of the fold, or of the edge, are drawn outwards.
        for (int i = 0; i < 2; i++) {
            int end = v[(side + i) % 3];
            place[end] = vec3_add_scaled(place[end], 1e-5, up);
        }
        obstacle b = look_at(&cube);
        real u = random_fraction(&seed);
        vec3 x = vec3_add(vec3_scale(u, p), vec3_scale(1 - u, q));
        x = vec3_add_scaled(x, 0.05, up);
        gjk_result g = distance_to(&b, x);
        surface_point found;
        ck_assert(ask(&b, x, 0.1, &found));
        ck_assert(fabs(height_over(&found, x) - g.distance) <= ORACLE);
        near_vec3(found.at, g.on_b, 1e-9);
    }
}
END_TEST

// Rejects: NaN that passes every comparison and becomes a contact.
START_TEST(particle_that_is_not_finite_touches_nothing)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    obstacle b = put(&cube, UPRIGHT, vec3_make(0, 0, 0));
    for (int k = 0; k < 9; k++)
        for (int ahead = 0; ahead <= b.planes; ahead++) {
            real x[3] = { 0.1, 0.2, 0.3 };
            x[k / 3] = bad[k % 3];
            surface_point p;
            ck_assert(!obstacle_nearest(&b, vec3_make(x[0], x[1], x[2]), ahead,
                                        1, &p));
        }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        cube_has_six_planes_and_icosahedron_twenty,
        plane_ahead_is_the_one_furthest_behind,
        particle_inside_leaves_by_the_nearest_face,
        particle_at_a_rounded_body_is_out_from_its_core,
        particle_over_a_face_stands_on_its_foot,
        particle_over_an_edge_is_pushed_away_from_the_edge,
        particle_over_a_corner_is_pushed_away_from_the_corner,
        particle_finds_what_the_search_finds,
        plane_known_before_changes_nothing,
        reach_counts_to_the_last_digit,
        thin_leaf_has_a_plane_on_either_side,
        particle_on_a_strained_face_is_near_it,
        particle_over_the_fold_of_a_strained_side_finds_the_fold,
        particle_that_is_not_finite_touches_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "obstacle", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
