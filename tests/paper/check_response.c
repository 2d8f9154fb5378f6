// check_response.c - who moves, and how far.  Book: chapter 7.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "constraint.h"
#include "expect.h"
#include "hostile.h"
#include "random.h"
#include "response.h"
#include "suite.h"

// A sum of a dozen products, each rounded once.
#define ROUNDING 1e-14
// Momentum: products of mass and move, in units of the largest of them.
#define MOMENTUM 1e-15

static const vec3 UP = { 0, 1, 0 };
static const vec3 DOWN = { 0, -1, 0 };
static const response_errata MENDED = { false, false };
static const response_errata PRINTED = { true, true };

static unsigned long long seed;

static particle at_rest(vec3 x, real mass)
{
    return (particle){ x, x, mass > 0 ? 1 / mass : 0 };
}

static feature_point vertex(int i)
{
    return (feature_point){ 1, { i }, { 1 } };
}

// A random feature of `count` particles from `first` on.
static feature_point any_feature(int first, int count)
{
    feature_point f = { .count = count };
    real sum = 0;
    for (int i = 0; i < count; i++) {
        f.vertex[i] = first + i;
        f.weight[i] = random_between(&seed, 0.05, 1);
        sum += f.weight[i];
    }
    for (int i = 0; i < count; i++) f.weight[i] /= sum;
    return f;
}

// Two features of na and nb particles that overlap by a random depth along a
// random normal, A's masses near 1 and B's near `heavy`.
static feature_contact any_contact(particle *p, int na, int nb, real heavy)
{
    feature_contact c = { .a = any_feature(0, na), .b = any_feature(na, nb),
                          .normal = vec3_unit(random_vec3(&seed, 1)),
                          .mass_a = 1, .mass_b = heavy };
    for (int i = 0; i < na + nb; i++) {
        real mass = random_between(&seed, 0.5, 2) * (i < na ? 1 : heavy);
        p[i] = at_rest(random_vec3(&seed, 1), mass);
    }
    vec3 across = vec3_sub(feature_position(&c.a, p),
                           feature_position(&c.b, p));
    vec3 by = vec3_sub(vec3_scale(-random_between(&seed, 0.01, 0.2), c.normal),
                       across);
    for (int i = 0; i < na; i++) {
        p[i].position = vec3_add(p[i].position, by);
        p[i].previous = p[i].position;
    }
    return c;
}

// Two single particles, A at the origin `depth` below B, normal up.
static feature_contact two_points(particle *p, real mass_a, real mass_b,
                                  real depth)
{
    p[0] = at_rest(vec3_make(0, -depth, 0), mass_a);
    p[1] = at_rest(vec3_make(0, 0, 0), mass_b);
    return (feature_contact){ .a = vertex(0), .b = vertex(1), .normal = UP,
                              .mass_a = mass_a > 0 ? mass_a : HUGE_VAL,
                              .mass_b = mass_b > 0 ? mass_b : HUGE_VAL };
}

// A particle on a static plane through the origin.
static feature_contact on_plane(vec3 normal)
{
    return (feature_contact){ .a = vertex(0), .normal = normal, .mass_a = 1,
                              .mass_b = HUGE_VAL };
}

// --- the point, the overlap -----------------------------------------------

// Rejects: previous and position mixed up, a weight left out.
START_TEST(feature_is_the_mean_of_its_particles)
{
    particle p[2] = { { { 0, 0, 0 }, { 1, 0, 0 }, 1 },
                      { { 0, 4, 0 }, { 1, 0, 8 }, 1 } };
    feature_point f = { 2, { 0, 1 }, { 0.75, 0.25 } };
    ck_assert(vec3_distance(feature_position(&f, p), UP) == 0);
    f.vertex[0] = 1;
    f.vertex[1] = 0;
    ck_assert(vec3_distance(feature_position(&f, p),
                            vec3_make(0, 3, 0)) == 0);
}
END_TEST

// A particle of 2 kg has 1/2; the middle of a face of three of 1 kg has 1/3;
// what is pinned adds nothing.
// Rejects: a in the place of a^2; masses in the place of inverse masses.
START_TEST(face_is_three_times_as_heavy_as_its_corner)
{
    particle p[3];
    for (int i = 0; i < 3; i++) p[i] = at_rest(UP, 1);
    real third = 1.0 / 3;
    feature_point corner = vertex(0);
    feature_point face = { 3, { 0, 1, 2 }, { third, third, third } };
    near(feature_inverse_mass(&face, p), third, ROUNDING, "face, 1/kg");
    p[1].inverse_mass = 0;
    near(feature_inverse_mass(&face, p), 2.0 / 9, ROUNDING,
         "face with a pinned corner, 1/kg");
    p[0].inverse_mass = 0.5;
    near(feature_inverse_mass(&corner, p), 0.5, 0, "particle of 2 kg, 1/kg");
    feature_point none = { .count = 0 };
    near(feature_inverse_mass(&none, p), 0, 0, "no feature, 1/kg");
}
END_TEST

// Rejects: the normal from A to B; `apart` subtracted; a plane's offset lost.
START_TEST(depth_is_positive_in_overlap)
{
    particle p[2];
    feature_contact c = two_points(p, 1, 1, 0.25);
    near(contact_depth(&c, p), 0.25, 0, "overlap");
    c.apart = 0.5;
    near(contact_depth(&c, p), 0.75, 0, "overlap of points to be kept apart");
    p[0].position.y = 2;
    near(contact_depth(&c, p), -1.5, 0, "overlap of points that are apart");
    c.b.count = 0;
    c.apart = 3;
    near(contact_depth(&c, p), 1, 0, "overlap with the plane y = 3");
}
END_TEST

// Rejects: pulling together what is apart; braking what does not touch.
START_TEST(features_apart_are_left)
{
    particle p[2];
    for (int k = 0; k < 2; k++) {
        feature_contact c = two_points(p, 1, 1, k ? 0 : -1e-9);
        real y = p[0].position.y;
        p[0].previous.x = -1;
        near(response_separate(&c, p, 0.5), 0, 0, "overlap");
        near(response_printed(&c, p, MENDED), 0, 0, "overlap");
        ck_assert(vec3_distance(p[0].position, vec3_make(0, y, 0)) == 0);
        ck_assert(vec3_length(p[1].position) == 0);
    }
}
END_TEST

// --- the move ---------------------------------------------------------------

// p' = q algebraically, for every pair of features and any masses.
// Rejects: a for a^2 in the sum, a forgotten inverse mass, the sign.
START_TEST(features_meet_after_one_push)
{
    seed = 7;
    for (int k = 0; k < 900; k++) {
        particle p[6];
        feature_contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 1);
        real depth = contact_depth(&c, p);
        near(response_separate(&c, p, 0), depth, 0, "overlap before");
        near(vec3_distance(feature_position(&c.a, p),
                           feature_position(&c.b, p)), 0, ROUNDING,
             "distance of the two points after");
    }
}
END_TEST

// Of all moves that close the gap, the least sum of m |dx|^2 is
// depth^2 / (K_A + K_B); and it is the only one.
// Rejects: moves that close the gap and cost more: a part for each particle
// that does not depend on its mass, or on its weight.
START_TEST(no_move_closes_the_gap_for_less)
{
    seed = 13;
    for (int k = 0; k < 900; k++) {
        particle p[6], old[6];
        feature_contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 3);
        for (int i = 0; i < 6; i++) old[i] = p[i];
        real depth = response_separate(&c, p, 0), cost = 0;
        for (int i = 0; i < c.a.count + c.b.count; i++)
            cost += vec3_length_squared(vec3_sub(p[i].position,
                                                 old[i].position))
                  / p[i].inverse_mass;
        real inverse_mass = feature_inverse_mass(&c.a, p)
                          + feature_inverse_mass(&c.b, p);
        near(cost * inverse_mass / (depth * depth), 1, 1e-11,
             "cost of the move, the least being 1");
    }
}
END_TEST

// Eqs 8 and 9 for an edge against a plane, whose particles weigh the same: both
// ways are one formula.
// Rejects: 1 - alpha and alpha exchanged, a missing square.
START_TEST(equations_8_and_9_are_the_case_of_equal_masses)
{
    real alpha = 0.3, sum = (1 - alpha) * (1 - alpha) + alpha * alpha;
    real depth = 0.1 * (1 - alpha) + 0.3 * alpha;
    for (int printed = 0; printed < 2; printed++) {
        particle p[2] = { at_rest(vec3_make(0, -0.1, 0), 2),
                          at_rest(vec3_make(1, -0.3, 0), 2) };
        feature_contact c = on_plane(UP);
        c.a = (feature_point){ 2, { 0, 1 }, { 1 - alpha, alpha } };
        if (printed) response_printed(&c, p, PRINTED);
        else         response_separate(&c, p, 0);
        near(p[0].position.y, -0.1 + (1 - alpha) / sum * depth, ROUNDING,
             "Eq. 8, height of x1");
        near(p[1].position.y, -0.3 + alpha / sum * depth, ROUNDING,
             "Eq. 9, height of x2");
    }
}
END_TEST

// Sum m dx = 0 for 1:1 up to 1:10,000, with friction at work as well.
// Rejects: the midpoint; body masses in the place of the features'; friction
// on one side only.
START_TEST(push_keeps_momentum)
{
    seed = 11;
    for (real heavy = 1; heavy <= 1e4; heavy *= 10)
        for (int k = 0; k < 300; k++) {
            particle p[6];
            feature_contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, heavy);
            vec3 slide = random_vec3(&seed, 0.05);
            for (int i = 0; i < c.a.count; i++)
                p[i].previous = vec3_sub(p[i].previous, slide);
            particle old[6];
            for (int i = 0; i < 6; i++) old[i] = p[i];
            response_separate(&c, p, 0.5);
            vec3 sum = { 0, 0, 0 };
            real scale = 0;
            for (int i = 0; i < c.a.count + c.b.count; i++) {
                vec3 dx = vec3_sub(p[i].position, old[i].position);
                real m = 1 / p[i].inverse_mass;
                sum = vec3_add_scaled(sum, m, dx);
                // Positions near 1 round by 1e-16, times the mass.
                scale += m * (1 + vec3_length(dx));
            }
            near(vec3_length(sum), 0, MOMENTUM * scale, "momentum made, kg m");
        }
}
END_TEST

// A vertex and the middle of a face share 3:1, not 1:1: the face offers only a
// third of a particle's inverse mass.
// Rejects: Eq. 10 with equal bodies.
START_TEST(vertex_and_face_share_three_to_one)
{
    particle p[4];
    for (int i = 0; i < 4; i++) p[i] = at_rest(vec3_make(i, 0, i * i), 1);
    p[0].position = vec3_make(2, -0.4, 14.0 / 3);
    feature_contact c = { .a = vertex(0), .normal = UP,
                          .b = { 3, { 1, 2, 3 },
                                { 1.0 / 3, 1.0 / 3, 1.0 / 3 } } };
    response_separate(&c, p, 0);
    near(p[0].position.y, -0.4 + 0.3, ROUNDING, "height of the vertex");
    for (int i = 1; i < 4; i++)
        near(p[i].position.y, -0.1, ROUNDING, "height of the face");
}
END_TEST

// Rejects: stopping at touch when a distance is asked for.
START_TEST(distance_is_kept)
{
    particle p[2];
    feature_contact c = two_points(p, 1, 3, 0.1);
    c.apart = 0.25;
    near(response_separate(&c, p, 0.5), 0.35, ROUNDING, "overlap before");
    near(p[0].position.y - p[1].position.y, 0.25, ROUNDING, "distance after");
}
END_TEST

// A push moves positions only, and so makes speed: the overlap in a step.
// Rejects: a previous position that goes along.
START_TEST(push_leaves_the_previous_positions)
{
    particle p[2];
    feature_contact c = two_points(p, 1, 0, 0.1);
    response_separate(&c, p, 0.5);
    near(p[0].position.y - p[0].previous.y, 0.1, ROUNDING, "m in a step");
    c = two_points(p, 1, 0, 0.1);
    response_printed(&c, p, PRINTED);
    near(p[0].position.y - p[0].previous.y, 0.1, ROUNDING, "m in a step");
}
END_TEST

// --- what cannot move -------------------------------------------------------

// Rejects: a share for the side that is pinned or static; a side that moves
// half of the way because the other one should have moved the rest.
START_TEST(static_side_takes_nothing)
{
    for (int printed = 0; printed < 2; printed++)
        for (int side = 0; side < 3; side++) {
            particle p[2];
            feature_contact c = two_points(p, side != 1, side == 1, 0.5);
            if (side == 2) c.b.count = 0;
            real depth = printed ? response_printed(&c, p, PRINTED)
                                 : response_separate(&c, p, 0.5);
            near(depth, 0.5, 0, "overlap before");
            near(p[0].position.y, side == 1 ? -0.5 : 0, ROUNDING, "A");
            near(p[1].position.y, side == 1 ? -0.5 : 0, ROUNDING, "B");
        }
}
END_TEST

// Rejects: 0 / 0.
START_TEST(two_static_sides_stay)
{
    particle p[2];
    feature_contact c = two_points(p, 0, 0, 0.5);
    near(response_separate(&c, p, 0.5), 0.5, 0, "overlap before");
    near(response_printed(&c, p, PRINTED), 0.5, 0, "overlap before");
    ck_assert(p[0].position.y == -0.5 && p[1].position.y == 0);
}
END_TEST

// A face with one pinned corner still comes out, and the corner stays.
// Rejects: Eq. 8's sum over pinned particles, which stops short.
START_TEST(pinned_corner_stays)
{
    for (int printed = 0; printed < 2; printed++) {
        particle p[3] = { at_rest(vec3_make(0, -1, 0), 1),
                          at_rest(vec3_make(1, -1, 0), 1),
                          at_rest(vec3_make(0, -1, 1), 0) };
        feature_contact c = on_plane(UP);
        c.a = (feature_point){ 3, { 0, 1, 2 }, { 0.5, 0.3, 0.2 } };
        if (printed) response_printed(&c, p, PRINTED);
        else         response_separate(&c, p, 0);
        near(p[2].position.y, -1, 0, "height of the pinned corner");
        near(contact_depth(&c, p), 0, ROUNDING, "overlap after");
    }
}
END_TEST

// Rejects: A and B exchanged somewhere.
START_TEST(sides_may_be_exchanged)
{
    seed = 3;
    for (int k = 0; k < 180; k++) {
        particle p[6], q[6];
        feature_contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 4);
        for (int i = 0; i < 6; i++) {
            p[i].previous = vec3_add(p[i].previous, random_vec3(&seed, 0.1));
            q[i] = p[i];
        }
        feature_contact d = c;
        d.a = c.b;
        d.b = c.a;
        d.mass_a = c.mass_b;
        d.mass_b = c.mass_a;
        d.normal = vec3_scale(-1, c.normal);
        if (k % 2) {
            response_separate(&c, p, 0.5);
            response_separate(&d, q, 0.5);
        } else {
            response_printed(&c, p, PRINTED);
            response_printed(&d, q, PRINTED);
        }
        for (int i = 0; i < c.a.count + c.b.count; i++)
            near(vec3_distance(p[i].position, q[i].position), 0, ROUNDING,
                 "difference of the two results");
    }
}
END_TEST

// --- friction -------------------------------------------------------------

// Rejects: friction that turns the sliding round.
START_TEST(little_sliding_is_undone_and_no_more)
{
    particle p[2];
    feature_contact c = two_points(p, 1, 4, 0.1);
    p[0].previous = vec3_make(-0.03, 0, 0.02);
    p[1].previous = vec3_make(0.01, 0, 0);
    response_separate(&c, p, 0.5);
    vec3 now = vec3_sub(p[0].position, p[1].position);
    vec3 before = vec3_sub(p[0].previous, p[1].previous);
    near(now.x - before.x, 0, ROUNDING, "slid along x");
    near(now.z - before.z, 0, ROUNDING, "slid along z");
    near(now.y, 0, ROUNDING, "overlap after");
}
END_TEST

// Rejects: friction along the axes, each with its own limit; a fall that is
// taken for sliding.
START_TEST(much_sliding_is_braked_by_mu_times_the_push)
{
    particle p[1] = { { { 3, -0.1, 4 }, { 0, 9, 0 }, 2 } };
    feature_contact c = on_plane(UP);
    response_separate(&c, p, 0.5);
    near(p[0].position.x, 3 - 0.05 * 0.6, ROUNDING, "x");
    near(p[0].position.y, 0, ROUNDING, "y");
    near(p[0].position.z, 4 - 0.05 * 0.8, ROUNDING, "z");
}
END_TEST

// Rejects: friction without a coefficient; 0 / 0 where nothing slides.
START_TEST(smooth_features_are_not_braked)
{
    particle p[2];
    for (int k = 0; k < 2; k++) {
        feature_contact c = two_points(p, 1, 1, 0.1);
        p[0].previous.x = -k;
        response_separate(&c, p, 0);
        near(p[0].position.x, 0, 0, "x");
        near(p[0].position.y, -0.05, ROUNDING, "y");
    }
}
END_TEST

// How far a particle comes from rest in a second, by Verlet and contact alone.
static real slide_down(real degrees, real mu)
{
    real slope = degrees * acos(-1) / 180, dt = 0.01;
    vec3 normal = { sin(slope), cos(slope), 0 };
    vec3 gravity = { 0, -9.81, 0 };
    particle p = at_rest(vec3_make(0, 0, 0), 1);
    feature_contact c = on_plane(normal);
    for (int k = 0; k < 100; k++) {
        verlet_step(&p, 1, gravity, NULL, dt);
        response_separate(&c, &p, mu);
    }
    return vec3_length(p.position);
}

// Coulomb's cone: mu against tan(slope), a degree to either side.
// Rejects: friction measured along gravity; a limit that forgets mu.
START_TEST(slope_holds_one_degree_below_and_slips_one_above)
{
    real mu = tan(30 * acos(-1) / 180), slope = 31 * acos(-1) / 180;
    near(slide_down(29, mu), 0, 1e-12, "way at 29 degrees, m");
    real wanted = 9.81 * (sin(slope) - mu * cos(slope)) / 2;
    // 100 steps: the first is one of rest, so the way is (1 + 1 / 100) longer.
    near(slide_down(31, mu) / wanted, 1, 0.02, "way at 31 degrees / wanted");
}
END_TEST

// v^2 / (2 mu g), to 1 %.
// Rejects: half the friction, or twice.
START_TEST(sliding_stops_after_v2_over_2_mu_g)
{
    for (real mu = 0.1; mu < 1; mu += 0.2) {
        real dt = 1e-3, v = 3;
        vec3 gravity = { 0, -9.81, 0 };
        particle p = particle_start(vec3_make(0, 0, 0), vec3_make(v, 0, 0),
                                    vec3_make(0, 0, 0), 1, dt);
        feature_contact c = on_plane(UP);
        for (int k = 0; k < 4000; k++) {
            verlet_step(&p, 1, gravity, NULL, dt);
            response_separate(&c, &p, mu);
        }
        near(p.position.x / (v * v / (2 * mu * 9.81)), 1, 0.01, "way / wanted");
        near(p.position.x - p.previous.x, 0, ROUNDING, "moves at the end by");
    }
}
END_TEST

// --- the paper's way --------------------------------------------------------

// The fly (1) and the elephant (1000): printed, the elephant jumps aside.
// Rejects: the two readings of Eq. 10 exchanged, or both alike.
START_TEST(fly_and_elephant)
{
    for (int way = 0; way < 3; way++) {
        particle p[2];
        feature_contact c = two_points(p, 1, 1000, 1);
        if (way == 0) response_printed(&c, p, PRINTED);
        if (way == 1) response_printed(&c, p, MENDED);
        if (way == 2) response_separate(&c, p, 0);
        real q = way == 0 ? -1000.0 / 1001 : -1.0 / 1001;
        near(p[0].position.y, q, ROUNDING, "the fly");
        near(p[1].position.y, q, ROUNDING, "the elephant");
    }
}
END_TEST

// Both points come to q = (mA pA + mB pB) / (mA + mB), whatever their features.
// Rejects: Eq. 10 with the particles' masses.
START_TEST(bodies_meet_at_q)
{
    seed = 5;
    for (int k = 0; k < 90; k++) {
        particle p[6];
        feature_contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 1);
        c.mass_a = 3;
        c.mass_b = 5;
        vec3 q = vec3_add(vec3_scale(3.0 / 8, feature_position(&c.a, p)),
                          vec3_scale(5.0 / 8, feature_position(&c.b, p)));
        response_printed(&c, p, MENDED);
        near(vec3_distance(feature_position(&c.a, p), q), 0, ROUNDING, "pA q");
        near(vec3_distance(feature_position(&c.b, p), q), 0, ROUNDING, "pB q");
    }
}
END_TEST

// Eq. 11: a triangle of cloth (radius 1) and a link of rope (radius 0.5), whose
// spheres have centres 1 apart: d = 0.5 along x, and every particle moves by
// half of it, whatever the masses.
// Rejects: the sign of d, d in the place of d / 2, masses.
START_TEST(leaves_part_as_in_equation_11)
{
    particle p[5];
    for (int i = 0; i < 5; i++)
        p[i] = at_rest(vec3_make(0, i, 0), 1 + i);
    real third = 1.0 / 3;
    feature_contact c = { .a = { 3, { 0, 1, 2 }, { third, third, third } },
                          .b = { 2, { 3, 4 }, { 0.5, 0.5 } },
                          .normal = { -1, 0, 0 },
                          .apart = 0.5, .mass_a = 2, .mass_b = 70,
                          .soft_a = true, .soft_b = true };
    near(response_printed(&c, p, PRINTED), 0.5, 0, "overlap");
    for (int i = 0; i < 5; i++)
        near(p[i].position.x, i < 3 ? -0.25 : 0.25, ROUNDING, "x");
}
END_TEST

// A leaf of cloth 1 below the surface y = 0 of a rigid body: as printed it goes
// down by half of that, mended up.  The surface comes to the midpoint in both.
// Rejects: the printed sign where it was not asked for; a plane that sucks.
START_TEST(printed_direction_goes_deeper)
{
    for (int inwards = 0; inwards < 2; inwards++) {
        particle p[4] = { at_rest(vec3_make(1, 0, 0), 1),
                          at_rest(vec3_make(-1, 0, 1), 1),
                          at_rest(vec3_make(-1, 0, -1), 1),
                          at_rest(DOWN, 1) };
        response_errata errata = { .pushed_inwards = inwards };
        feature_contact c = { .a = vertex(3), .normal = UP, .mass_a = 1,
                              .mass_b = 30,
                              .b = { 3, { 0, 1, 2 }, { 0.5, 0.25, 0.25 } },
                              .soft_a = true };
        near(response_printed(&c, p, errata), 1, 0, "overlap");
        near(p[3].position.y, inwards ? -1.5 : -0.5, ROUNDING, "the leaf");
        near(feature_position(&c.b, p).y, -0.5, ROUNDING, "the surface");

        c.b.count = 0;
        c.mass_b = HUGE_VAL;
        p[3] = at_rest(DOWN, 1);
        response_printed(&c, p, errata);
        near(p[3].position.y, 0, ROUNDING, "the leaf, out of a plane");
    }
}
END_TEST

// --- what the sticks leave of a push --------------------------------------

// Sticks along all pairs nearer than `reach`, or as far apart as can be.
static int join(const particle *p, int n, real reach, real across, stick *s)
{
    int sticks = 0;
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            real d = vec3_distance(p[i].position, p[j].position);
            if (d < reach || d > across)
                s[sticks++] = (stick){ i, j, d, 1, STICK_EXACT };
        }
    return sticks;
}

// Pushes particle 0 up by a little out of a plane, relaxes the sticks until
// they are straight, and returns what is left of the push.
static real retained(particle *p, const stick *s, int sticks)
{
    const real push = 1e-5;
    vec3 start = p[0].position;
    feature_contact c = on_plane(UP);
    c.apart = start.y + push;
    response_separate(&c, p, 0);
    relax_options o = relax_options_pbd();
    o.tolerance = 1e-14;
    sticks_relax(s, sticks, p, 10000, o);
    return (p[0].position.y - start.y) / push;
}

// m K: a corner of a cube, pushed along an edge, keeps 1/4; a vertex of an
// icosahedron, pushed through the centre, 1/12.
// Rejects: weights that are not those of the least move.
START_TEST(sticks_take_back_all_but_a_quarter_or_a_twelfth)
{
    stick s[66];
    particle cube[8];
    for (int i = 0; i < 8; i++)
        cube[i] = at_rest(vec3_make(i & 1, i >> 1 & 1, i >> 2 & 1), 1);
    int sticks = join(cube, 8, 1.5, 1.5, s);    // 12 + 12 + 4: rigid
    ck_assert_int_eq(sticks, 28);
    near(retained(cube, s, sticks), 0.25, 1e-4, "left at a cube's corner");

    // Two of the twelve on the y axis, two rings of five between.
    real height = 1 / sqrt(5), ring = 2 / sqrt(5), turn = acos(-1) / 5;
    particle ico[12];
    for (int i = 0; i < 10; i++)
        ico[i + 1] = at_rest(vec3_make(ring * cos(turn * i),
                                       i % 2 ? height : -height,
                                       ring * sin(turn * i)), 1);
    ico[0] = at_rest(DOWN, 1);
    ico[11] = at_rest(UP, 1);
    sticks = join(ico, 12, 1.2, 1.9, s);
    ck_assert_int_eq(sticks, 36);
    near(retained(ico, s, sticks), 1.0 / 12, 1e-4,
         "left at a vertex of an icosahedron");
}
END_TEST

// --- nothing that is not finite -------------------------------------------

// Numbers of every size, zero normals and levers without length: nothing that
// is not finite comes out.
// Rejects: 1 / (a tiny sum), a normal made of a zero length.
START_TEST(finite_input_gives_finite_output)
{
    seed = 99;
    for (int k = 0; k < 40000; k++) {
        particle p[6];
        for (int i = 0; i < 6; i++) {
            real w = hostile(&seed);
            p[i] = (particle){ hostile_vec3(&seed), hostile_vec3(&seed),
                               w < 1e100 ? w : 0 };
        }
        feature_contact c = { .a = any_feature(0, 1 + k % 3),
                              .b = any_feature(3, k / 3 % 4),
                              .normal = hostile_normal(&seed),
                              .apart = hostile(&seed), .mass_a = 1e-20 + hostile(&seed),
                              .mass_b = k % 5 ? 1e-20 + hostile(&seed) : HUGE_VAL,
                              .soft_a = k % 2, .soft_b = k % 7 < 3 };
        if (c.a.count > 1 && random_fraction(&seed) < 0.3) {
            c.a.weight[0] = hostile(&seed) < 1 ? 1e-160 : 1e-20;
            c.a.weight[1] = 1;
        }
        response_separate(&c, p, random_fraction(&seed));
        response_printed(&c, p, k % 3 ? PRINTED : MENDED);
        int finite = 1;
        for (int i = 0; i < 6; i++)
            finite &= vec3_is_finite(p[i].position) &&
                      vec3_is_finite(p[i].previous);
        ck_assert_msg(finite, "case %d: an infinite number, or NaN", k);
    }
}
END_TEST

// Rejects: NaN of one body handed on to the other.
START_TEST(nan_is_not_an_overlap)
{
    particle p[2];
    feature_contact c = two_points(p, 1, 1, 0.1);
    p[0].position.x = (real)NAN;
    near(response_separate(&c, p, 0.5), 0, 0, "overlap");
    near(response_printed(&c, p, PRINTED), 0, 0, "overlap");
    near(vec3_length(p[1].position), 0, 0, "B moved by");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Points and overlaps.
        feature_is_the_mean_of_its_particles,
        face_is_three_times_as_heavy_as_its_corner,
        depth_is_positive_in_overlap,
        features_apart_are_left,
        // The move.
        features_meet_after_one_push,
        no_move_closes_the_gap_for_less,
        equations_8_and_9_are_the_case_of_equal_masses,
        push_keeps_momentum,
        vertex_and_face_share_three_to_one,
        distance_is_kept,
        push_leaves_the_previous_positions,
        static_side_takes_nothing,
        two_static_sides_stay,
        pinned_corner_stays,
        sides_may_be_exchanged,
        // Friction.
        little_sliding_is_undone_and_no_more,
        much_sliding_is_braked_by_mu_times_the_push,
        smooth_features_are_not_braked,
        slope_holds_one_degree_below_and_slips_one_above,
        sliding_stops_after_v2_over_2_mu_g,
        // The paper's way.
        fly_and_elephant,
        bodies_meet_at_q,
        leaves_part_as_in_equation_11,
        printed_direction_goes_deeper,
        // Bodies and bad input.
        sticks_take_back_all_but_a_quarter_or_a_twelfth,
        finite_input_gives_finite_output,
        nan_is_not_an_overlap,
        NULL
    };
    return suite_run((suite){ .name = "response", .tests = tests });
}
