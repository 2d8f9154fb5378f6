// check_separation.c - who moves, and how far.  Book: chapter 7.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "constraint.h"
#include "separation.h"

// A sum of a dozen products, each rounded once.
#define ROUNDING 1e-14
// Momentum: products of mass and move, in units of the largest of them.
#define MOMENTUM 1e-15

static const vec3 UP = { 0, 1, 0 };
static const vec3 DOWN = { 0, -1, 0 };

// Numbers in [0, 1) from a linear congruence; the same on every machine.
static unsigned long long seed;

static real any(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 9007199254740992.0;
}

static real within(real low, real high)
{
    return low + (high - low) * any();
}

static vec3 any_vec3(real size)
{
    real x = within(-size, size), y = within(-size, size);
    return vec3_make(x, y, within(-size, size));
}

static particle at_rest(vec3 x, real mass)
{
    return (particle){ x, x, mass > 0 ? 1 / mass : 0 };
}

static feature_point vertex(int i)
{
    return (feature_point){ 1, { i }, { 1 } };
}

// Options without friction.
static response_options smooth(share_rule rule)
{
    response_options o = response_options_default();
    o.share = rule;
    o.friction = 0;
    return o;
}

// A random feature of `count` particles from `first` on.
static feature_point any_feature(int first, int count)
{
    feature_point f = { .count = count };
    real sum = 0;
    for (int i = 0; i < count; i++) {
        f.vertex[i] = first + i;
        f.weight[i] = within(0.05, 1);
        sum += f.weight[i];
    }
    for (int i = 0; i < count; i++) f.weight[i] /= sum;
    return f;
}

// Two features of na and nb particles that overlap by a random depth along a
// random normal, A's masses near 1 and B's near `heavy`.
static contact any_contact(particle *p, int na, int nb, real heavy)
{
    contact c = { .a = any_feature(0, na), .b = any_feature(na, nb),
                  .normal = vec3_unit(any_vec3(1)), .mass_a = 1,
                  .mass_b = heavy };
    for (int i = 0; i < na + nb; i++) {
        real mass = within(0.5, 2) * (i < na ? 1 : heavy);
        p[i] = at_rest(any_vec3(1), mass);
    }
    vec3 across = vec3_sub(feature_now(c.a, p), feature_now(c.b, p));
    vec3 wanted = vec3_scale(-within(0.01, 0.2), c.normal);
    vec3 by = vec3_sub(wanted, across);
    for (int i = 0; i < na; i++) {
        p[i].position = vec3_add(p[i].position, by);
        p[i].previous = p[i].position;
    }
    return c;
}

// Two single particles, A at the origin `depth` below B, normal up.
static contact two_points(particle *p, real mass_a, real mass_b, real depth)
{
    p[0] = at_rest(vec3_make(0, -depth, 0), mass_a);
    p[1] = at_rest(vec3_make(0, 0, 0), mass_b);
    return (contact){ .a = vertex(0), .b = vertex(1), .normal = UP,
                      .mass_a = mass_a, .mass_b = mass_b };
}

// A particle on an immovable surface through the origin.
static contact on_surface(vec3 normal)
{
    return (contact){ .a = vertex(0), .normal = normal, .mass_a = 1,
                      .mass_b = HUGE_VAL };
}

// --- the point, the gap ---------------------------------------------------

// Rejects: previous and position mixed up, a weight left out.
START_TEST(feature_is_the_mean_of_its_vertices)
{
    particle p[2] = { { { 0, 0, 0 }, { 1, 0, 0 }, 1 },
                      { { 0, 4, 0 }, { 1, 0, 8 }, 1 } };
    feature_point f = { 2, { 0, 1 }, { 0.75, 0.25 } };
    ck_assert(vec3_distance(feature_now(f, p), vec3_make(0, 1, 0)) == 0);
    ck_assert(vec3_distance(feature_before(f, p), vec3_make(1, 0, 2)) == 0);
}
END_TEST

// Rejects: the normal from A to B; the thickness added.
START_TEST(gap_is_negative_in_overlap)
{
    particle p[2];
    contact c = two_points(p, 1, 1, 0.25);
    ck_assert(contact_gap(&c, p) == -0.25);
    c.thickness = 0.5;
    ck_assert(contact_gap(&c, p) == -0.75);
    p[0].position.y = 2;
    ck_assert(contact_gap(&c, p) == 1.5);
    c.b.count = 0;
    c.fixed = vec3_make(7, 1, 7);
    ck_assert(contact_gap(&c, p) == 0.5);
}
END_TEST

// Rejects: pulling together what is apart.
START_TEST(features_apart_are_left)
{
    particle p[2];
    contact c = two_points(p, 1, 1, -1e-9);
    ck_assert(contact_separate(&c, p, response_options_default()) == 0);
    ck_assert(p[0].position.y == 1e-9 && p[1].position.y == 0);
    ck_assert(c.pushed == 0);
}
END_TEST

// --- the push -------------------------------------------------------------

// p' = q algebraically, for every pair of features and any masses.
// Rejects: a for a^2 in the sum, a forgotten inverse mass.
START_TEST(features_meet_after_one_push)
{
    seed = 7;
    for (int k = 0; k < 900; k++) {
        particle p[6];
        contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 1);
        real depth = -contact_gap(&c, p);
        ck_assert(contact_separate(&c, p, smooth(SHARE_MASS)) == depth);
        vec3 a = feature_now(c.a, p), b = feature_now(c.b, p);
        ck_assert_double_lt(vec3_distance(a, b), ROUNDING);
        ck_assert(c.pushed == depth);
    }
}
END_TEST

// Eqs 8 and 9 for an edge against a surface, and SHARE_BODY for any feature
// whose particles weigh the same: one formula.
// Rejects: 1 - alpha and alpha exchanged, a missing square.
START_TEST(equations_8_and_9_are_the_case_of_equal_masses)
{
    real alpha = 0.3, sum = (1 - alpha) * (1 - alpha) + alpha * alpha;
    for (int rule = SHARE_MASS; rule <= SHARE_PRINTED; rule++) {
        particle p[2] = { at_rest(vec3_make(0, -0.1, 0), 2),
                          at_rest(vec3_make(1, -0.3, 0), 2) };
        contact c = on_surface(UP);
        c.a = (feature_point){ 2, { 0, 1 }, { 1 - alpha, alpha } };
        real depth = 0.1 * (1 - alpha) + 0.3 * alpha;
        contact_separate(&c, p, smooth((share_rule)rule));
        real x1 = -0.1 + (1 - alpha) / sum * depth;
        real x2 = -0.3 + alpha / sum * depth;
        ck_assert_double_eq_tol(p[0].position.y, x1, ROUNDING);
        ck_assert_double_eq_tol(p[1].position.y, x2, ROUNDING);
    }
}
END_TEST

// Sum m dx = 0 for 1:1 up to 1:10,000, with friction at work as well.
// Rejects: the midpoint; body masses in the place of the features'.
START_TEST(push_keeps_momentum)
{
    seed = 11;
    for (real heavy = 1; heavy <= 1e4; heavy *= 10)
        for (int k = 0; k < 300; k++) {
            particle p[6];
            contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, heavy);
            vec3 slide = any_vec3(0.05);
            for (int i = 0; i < c.a.count; i++)
                p[i].previous = vec3_sub(p[i].previous, slide);
            particle old[6];
            for (int i = 0; i < 6; i++) old[i] = p[i];
            response_options o = response_options_default();
            contact_separate(&c, p, o);
            vec3 sum = { 0, 0, 0 };
            real scale = 0;
            for (int i = 0; i < c.a.count + c.b.count; i++) {
                vec3 dx = vec3_sub(p[i].position, old[i].position);
                real m = 1 / p[i].inverse_mass;
                sum = vec3_add_scaled(sum, m, dx);
                // Positions near 1 round by 1e-16, times the mass.
                scale += m * (1 + vec3_length(dx));
            }
            ck_assert_double_lt(vec3_length(sum), MOMENTUM * scale);
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
    contact c = { .a = vertex(0), .normal = UP,
                  .b = { 3, { 1, 2, 3 }, { 1.0 / 3, 1.0 / 3, 1.0 / 3 } } };
    contact_separate(&c, p, smooth(SHARE_MASS));
    ck_assert_double_eq_tol(p[0].position.y, -0.4 + 0.3, ROUNDING);
    for (int i = 1; i < 4; i++)
        ck_assert_double_eq_tol(p[i].position.y, -0.1, ROUNDING);
}
END_TEST

// The fly (1) and the elephant (1000): printed, the elephant jumps aside.
// Rejects: the two rules exchanged, or both alike.
START_TEST(fly_and_elephant)
{
    particle p[2];
    contact c = two_points(p, 1, 1000, 1);
    contact_separate(&c, p, smooth(SHARE_PRINTED));
    ck_assert_double_eq_tol(p[1].position.y, -1000.0 / 1001, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.y, -1000.0 / 1001, ROUNDING);

    c = two_points(p, 1, 1000, 1);
    contact_separate(&c, p, smooth(SHARE_BODY));
    ck_assert_double_eq_tol(p[1].position.y, -1.0 / 1001, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.y, -1.0 / 1001, ROUNDING);

    c = two_points(p, 1, 1000, 1);
    contact_separate(&c, p, smooth(SHARE_MASS));
    ck_assert_double_eq_tol(p[1].position.y, -1.0 / 1001, ROUNDING);
}
END_TEST

// Both points come to q under SHARE_BODY too, whatever their features are.
START_TEST(bodies_meet_at_q)
{
    seed = 5;
    for (int k = 0; k < 90; k++) {
        particle p[6];
        contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 1);
        c.mass_a = 3;
        c.mass_b = 5;
        vec3 a = feature_now(c.a, p), b = feature_now(c.b, p);
        vec3 q = vec3_add(vec3_scale(3.0 / 8, a), vec3_scale(5.0 / 8, b));
        contact_separate(&c, p, smooth(SHARE_BODY));
        a = feature_now(c.a, p);
        ck_assert_double_lt(vec3_distance(a, q), ROUNDING);
        b = feature_now(c.b, p);
        ck_assert_double_lt(vec3_distance(b, q), ROUNDING);
    }
}
END_TEST

// Rejects: stopping at touch when a distance is asked for.
START_TEST(thickness_is_kept)
{
    particle p[2];
    contact c = two_points(p, 1, 3, 0.1);
    c.thickness = 0.25;
    ck_assert_double_eq_tol(
        contact_separate(&c, p, response_options_default()), 0.35, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.y - p[1].position.y, 0.25,
                            ROUNDING);
}
END_TEST

// Rejects: the printed weights, which would leave A inside for ever.
START_TEST(immovable_side_takes_nothing)
{
    for (int rule = SHARE_MASS; rule <= SHARE_PRINTED; rule++) {
        // No feature at all.
        particle p[2];
        contact c = two_points(p, 1, 1, 0.5);
        c.b.count = 0;
        c.mass_b = HUGE_VAL;
        contact_separate(&c, p, smooth((share_rule)rule));
        ck_assert_double_eq_tol(p[0].position.y, 0, ROUNDING);

        // A nailed feature, on either side.
        c = two_points(p, 1, 0, 0.5);
        c.mass_b = 1;
        contact_separate(&c, p, smooth((share_rule)rule));
        ck_assert_double_eq_tol(p[0].position.y, 0, ROUNDING);
        ck_assert(p[1].position.y == 0);
        c = two_points(p, 0, 1, 0.5);
        c.mass_a = 1;
        contact_separate(&c, p, smooth((share_rule)rule));
        ck_assert(p[0].position.y == -0.5);
        ck_assert_double_eq_tol(p[1].position.y, -0.5, ROUNDING);
        if (rule == SHARE_MASS) continue;

        // An infinite mass, on either side, overrules the particles', and
        // friction respects it.
        response_options rough = smooth((share_rule)rule);
        rough.friction = 1;
        c = two_points(p, HUGE_VAL, 1, 0.5);
        p[0].inverse_mass = 1;
        p[0].previous.x = -0.2;
        contact_separate(&c, p, rough);
        ck_assert(p[0].position.y == -0.5 && p[0].position.x == 0);
        ck_assert_double_eq_tol(p[1].position.y, -0.5, ROUNDING);
        ck_assert_double_eq_tol(p[1].position.x, 0.2, ROUNDING);
        c = two_points(p, 1, HUGE_VAL, 0.5);
        p[1].inverse_mass = 1;
        p[0].previous.x = -0.2;
        contact_separate(&c, p, rough);
        ck_assert(vec3_length(p[1].position) == 0);
        ck_assert_double_eq_tol(p[0].position.y, 0, ROUNDING);
        ck_assert_double_eq_tol(p[0].position.x, -0.2, ROUNDING);
    }
}
END_TEST

// Rejects: 0 / 0.
START_TEST(two_immovable_sides_stay)
{
    for (int rule = SHARE_MASS; rule <= SHARE_PRINTED; rule++) {
        particle p[2];
        contact c = two_points(p, 0, 0, 0.5);
        c.mass_a = c.mass_b = HUGE_VAL;
        response_options o = response_options_default();
        o.share = (share_rule)rule;
        ck_assert(contact_separate(&c, p, o) == 0.5);
        ck_assert(c.pushed == 0);
        contact_bounce(&c, p, o, 0.01);
        ck_assert(p[0].position.y == -0.5 && p[1].position.y == 0);
        ck_assert(p[0].previous.y == -0.5 && p[1].previous.y == 0);
    }
}
END_TEST

// A face with one nailed corner still comes out, and the corner stays.
// Rejects: Eq. 8's sum over nailed particles, which stops short.
START_TEST(nailed_corner_stays)
{
    for (int rule = SHARE_MASS; rule <= SHARE_PRINTED; rule++) {
        particle p[3] = { at_rest(vec3_make(0, -1, 0), 1),
                          at_rest(vec3_make(1, -1, 0), 1),
                          at_rest(vec3_make(0, -1, 1), 0) };
        contact c = on_surface(UP);
        c.a = (feature_point){ 3, { 0, 1, 2 }, { 0.5, 0.3, 0.2 } };
        contact_separate(&c, p, smooth((share_rule)rule));
        ck_assert(p[2].position.y == -1);
        ck_assert_double_eq_tol(contact_gap(&c, p), 0, ROUNDING);
    }
}
END_TEST

// Rejects: gain in the account, or in Coulomb's limit.
START_TEST(gain_goes_further_but_does_not_brake_more)
{
    for (int rule = SHARE_MASS; rule <= SHARE_BODY; rule++) {
        particle p[2];
        contact c = two_points(p, 1, 1, 0.1);
        p[0].previous.x = -1;
        response_options o = response_options_default();
        o.share = (share_rule)rule;
        o.gain = 3;
        contact_separate(&c, p, o);
        ck_assert_double_eq_tol(contact_gap(&c, p), 0.2, ROUNDING);
        ck_assert_double_eq_tol(c.pushed, 0.1, ROUNDING);
        // Friction 0.5 takes 0.5 * 0.1 of the sliding, half on each side.
        ck_assert_double_eq_tol(p[0].position.x, -0.025, ROUNDING);
        ck_assert_double_eq_tol(p[1].position.x, 0.025, ROUNDING);
        p[0].position.y = p[1].position.y - 0.3;
        contact_separate(&c, p, o);
        ck_assert_double_eq_tol(c.pushed, 0.4, ROUNDING);
    }
}
END_TEST

// Rejects: sides exchanged when both are pushed.
START_TEST(sides_may_be_exchanged)
{
    seed = 3;
    for (int k = 0; k < 90; k++) {
        particle p[6], q[6];
        contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 4);
        for (int i = 0; i < 6; i++) {
            p[i].previous = vec3_add(p[i].previous, any_vec3(0.1));
            q[i] = p[i];
        }
        contact d = c;
        d.a = c.b;
        d.b = c.a;
        d.mass_a = c.mass_b;
        d.mass_b = c.mass_a;
        d.normal = vec3_scale(-1, c.normal);
        response_options o = response_options_default();
        o.share = (share_rule)(k % 3);
        contact_separate(&c, p, o);
        contact_separate(&d, q, o);
        for (int i = 0; i < c.a.count + c.b.count; i++)
            ck_assert_double_lt(vec3_distance(p[i].position, q[i].position),
                                ROUNDING);
    }
}
END_TEST

// --- friction -------------------------------------------------------------

// Rejects: friction that turns the sliding round.
START_TEST(little_sliding_is_undone_and_no_more)
{
    particle p[2];
    contact c = two_points(p, 1, 4, 0.1);
    p[0].previous = vec3_make(-0.03, 0, 0.02);
    p[1].previous = vec3_make(0.01, 0, 0);
    contact_separate(&c, p, response_options_default());
    vec3 now = vec3_sub(p[0].position, p[1].position);
    vec3 before = vec3_sub(p[0].previous, p[1].previous);
    ck_assert_double_eq_tol(now.x, before.x, ROUNDING);
    ck_assert_double_eq_tol(now.z, before.z, ROUNDING);
    ck_assert_double_eq_tol(now.y, 0, ROUNDING);
}
END_TEST

// Rejects: friction along the axes, each with its own limit.
START_TEST(much_sliding_is_braked_by_mu_times_the_push)
{
    particle p[1] = { { { 3, -0.1, 4 }, { 0, 0, 0 }, 2 } };
    contact c = on_surface(UP);
    contact_separate(&c, p, response_options_default());
    ck_assert_double_eq_tol(p[0].position.x, 3 - 0.05 * 0.6, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.z, 4 - 0.05 * 0.8, ROUNDING);
}
END_TEST

// How far a particle comes from rest in a second, by Verlet and contact alone.
static real slide_down(real degrees, real mu)
{
    real slope = degrees * acos(-1) / 180, dt = 0.01;
    vec3 normal = { sin(slope), cos(slope), 0 };
    vec3 gravity = { 0, -9.81, 0 };
    particle p = particle_start(vec3_make(0, 0, 0), vec3_make(0, 0, 0),
                                vec3_make(0, 0, 0), 1, dt);
    contact c = on_surface(normal);
    response_options o = response_options_default();
    o.friction = mu;
    for (int k = 0; k < 100; k++) {
        verlet_step(&p, 1, gravity, NULL, dt);
        contact_separate(&c, &p, o);
    }
    return vec3_length(p.position);
}

// Coulomb's cone: mu against tan(slope), a degree to either side.
// Rejects: mu times the gained push; friction measured along the gravity.
START_TEST(slope_holds_one_degree_below_and_slips_one_above)
{
    real mu = tan(30 * acos(-1) / 180), slope = 31 * acos(-1) / 180;
    ck_assert_double_lt(slide_down(29, mu), 1e-12);
    real way = slide_down(31, mu);
    real wanted = 9.81 * (sin(slope) - mu * cos(slope)) / 2;
    // 100 steps: the first is one of rest, so the way is (1 + 1 / 100) longer.
    ck_assert_double_eq_tol(way / wanted, 1, 0.02);
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
        contact c = on_surface(UP);
        response_options o = response_options_default();
        o.friction = mu;
        for (int k = 0; k < 4000; k++) {
            verlet_step(&p, 1, gravity, NULL, dt);
            contact_separate(&c, &p, o);
        }
        real way = v * v / (2 * mu * 9.81);
        ck_assert_double_eq_tol(p.position.x / way, 1, 0.01);
        ck_assert(p.position.x - p.previous.x == 0);
    }
}
END_TEST

// --- restitution ----------------------------------------------------------

// Height of the first bounce, of a fall from 1 m.
static real bounce_height(real restitution)
{
    real dt = 2e-4, highest = 0;
    vec3 gravity = { 0, -9.81, 0 };
    particle p = particle_start(vec3_make(0, 1, 0), vec3_make(0, 0, 0),
                                gravity, 1, dt);
    contact c = on_surface(UP);
    response_options o = response_options_default();
    o.restitution = restitution;
    int met = 0;
    for (int k = 0; k < 6000; k++) {
        real speed = (p.position.y - p.previous.y) / dt;
        verlet_step(&p, 1, gravity, NULL, dt);
        if (met && p.position.y > highest) highest = p.position.y;
        if (met || contact_gap(&c, &p) > 0) continue;
        met = 1;
        c.approach = -speed;
        contact_separate(&c, &p, o);
        contact_bounce(&c, &p, o, dt);
    }
    return highest;
}

// Rejects: a bounce by e in height instead of speed; dt forgotten.
START_TEST(ball_bounces_to_e_squared_of_its_height)
{
    for (int k = 0; k < 3; k++) {
        real e = k / 2.0, height = bounce_height(e);
        ck_assert_msg(fabs(height - e * e) <= 1e-6 + 0.01 * e * e, "from 1 m, "
                      "with restitution %g, it bounces to %g m, wanted %g", e,
                      height, e * e);
    }
}
END_TEST

// Rejects: moving the present positions, body masses, A alone.
START_TEST(bounce_keeps_momentum_and_positions)
{
    seed = 23;
    for (int k = 0; k < 90; k++) {
        particle p[6], old[6];
        real dt = 0.01;
        contact c = any_contact(p, 1 + k % 3, 1 + k / 3 % 3, 10);
        c.approach = within(0.1, 3);
        response_options o = response_options_default();
        o.restitution = any();
        contact_separate(&c, p, o);
        for (int i = 0; i < 6; i++) old[i] = p[i];
        contact_bounce(&c, p, o, dt);
        vec3 sum = { 0, 0, 0 };
        for (int i = 0; i < c.a.count + c.b.count; i++) {
            ck_assert_msg(vec3_distance(p[i].position, old[i].position) == 0,
                          "a bounce has moved the position of particle %d", i);
            vec3 dx = vec3_sub(p[i].previous, old[i].previous);
            sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass, dx);
        }
        ck_assert_msg(vec3_length(sum) < 60 * ROUNDING, "a bounce has made "
                      "momentum: %g kg m in a step", vec3_length(sum));
        vec3 now = vec3_sub(feature_now(c.a, p), feature_now(c.b, p));
        vec3 was = vec3_sub(feature_before(c.a, p), feature_before(c.b, p));
        real speed = vec3_dot(vec3_sub(now, was), c.normal) / dt;
        real wanted = o.restitution * c.approach;
        ck_assert_msg(fabs(speed - wanted) < 100 * ROUNDING, "met at %g m/s, "
                      "with restitution %g: they part at %.12g m/s, wanted "
                      "%.12g", c.approach, o.restitution, speed, wanted);
    }
}
END_TEST

// Rejects: a bounce without a push; a pair held back that was parting already.
START_TEST(bounce_is_for_contacts_that_pushed)
{
    particle p[2];
    contact c = two_points(p, 1, 1, -0.1);
    c.approach = 1;
    response_options o = response_options_default();
    o.restitution = 1;
    contact_bounce(&c, p, o, 0.01);
    ck_assert_msg(p[0].previous.y == 0.1 && p[1].previous.y == 0,
                  "a contact that has not pushed has bounced");

    c = two_points(p, 1, 0, 0.1);
    p[0].previous.y = -0.12;
    c.approach = -2;
    contact_separate(&c, p, o);
    contact_bounce(&c, p, o, 0.01);
    real way = p[0].position.y - p[0].previous.y;
    ck_assert_msg(fabs(way - 0.02) <= ROUNDING, "parting already at 0.02 m a "
                  "step: after the bounce at %g, wanted 0.02", way);

    // Rejects: a division by the weight of two nails.
    c = two_points(p, 0, 0, 0.1);
    c.pushed = c.approach = 1;
    particle before[2] = { p[0], p[1] };
    contact_bounce(&c, p, o, 0.01);
    ck_assert(memcmp(before, p, sizeof before) == 0);
}
END_TEST

// --- particles and leaves -------------------------------------------------

// Rejects: half each whatever the masses; a distance not kept.
START_TEST(particles_part_to_their_distance_by_mass)
{
    particle p[2] = { at_rest(vec3_make(0, 0, 0), 1),
                      at_rest(vec3_make(0, 0, 0.6), 3) };
    sphere_contact c = { 0, 1, 1 };
    response_options o = response_options_default();
    o.gain = 5;
    ck_assert_double_eq_tol(sphere_contact_separate(c, p, o), 0.4, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.z, -0.3, ROUNDING);
    ck_assert_double_eq_tol(p[1].position.z, 0.7, ROUNDING);
    p[1].position.z = 2;
    ck_assert(sphere_contact_separate(c, p, o) == 0);
    ck_assert(p[1].position.z == 2);
}
END_TEST

// Rejects: 0 / 0 as a normal.
START_TEST(coincident_particles_and_leaves_are_left)
{
    particle p[2] = { at_rest(vec3_make(1, 2, 3), 1),
                      at_rest(vec3_make(1, 2, 3), 1) };
    response_options o = response_options_default();
    ck_assert(sphere_contact_separate((sphere_contact){ 0, 1, 1 }, p, o) == 0);
    int a = 0, b = 1;
    vec3 x = p[0].position;
    ck_assert(leaves_separate(&a, 1, x, 1, &b, 1, x, 1, p) == 0);
    ck_assert(vec3_distance(p[0].position, x) == 0);
    ck_assert(vec3_distance(p[1].position, x) == 0);
}
END_TEST

// Rejects: pushes on nailed ends; friction beyond the limit.
START_TEST(particles_brake_and_nailed_ones_stay)
{
    particle p[2] = { at_rest(vec3_make(0, 0.9, 0), 2),
                      at_rest(vec3_make(0, 0, 0), 0) };
    p[0].previous = vec3_make(-1, 2, 0);    // fell while it slid
    sphere_contact c = { 0, 1, 1 };
    sphere_contact_separate(c, p, response_options_default());
    ck_assert_double_eq_tol(p[0].position.y, 1, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.x, -0.05, ROUNDING);
    ck_assert(vec3_length(p[1].position) == 0);
    p[0].inverse_mass = 0;
    p[0].position.y = 0.5;
    ck_assert_double_gt(sphere_contact_separate(
        c, p, response_options_default()), 0);
    ck_assert(p[0].position.y == 0.5);
}
END_TEST

// Without friction what slid goes on sliding.
START_TEST(smooth_particles_are_not_braked)
{
    particle p[2] = { at_rest(vec3_make(0, 0.9, 0), 2),
                      at_rest(vec3_make(0, 0, 0), 0) };
    p[0].previous = vec3_make(-1, 0.9, 0);
    sphere_contact c = { 0, 1, 1 };
    sphere_contact_separate(c, p, smooth(SHARE_MASS));
    ck_assert_double_eq_tol(p[0].position.y, 1, ROUNDING);
    ck_assert(p[0].position.x == 0);
}
END_TEST

// A distance whose square is more than that of the particles, and whose root is
// not.  Rejects: a push of 0, that is counted.
START_TEST(particles_that_only_rounding_overlaps_are_left)
{
    real x = 0x1.b15dbeb10ff4p-2, y = 0x1.04d10d670c943p-1;
    particle p[2] = { at_rest(vec3_make(x, y, 0), 1),
                      at_rest(vec3_make(0, 0, 0), 1) };
    sphere_contact c = { 0, 1, 0x1.5315179e3d8f4p-1 };
    ck_assert(sphere_contact_overlaps(&c, p));
    ck_assert(sphere_contact_separate(c, p, response_options_default()) == 0);
    ck_assert(p[0].position.x == x && p[1].position.x == 0);
}
END_TEST

// Eq. 11: radii 1 and 0.5, centres 1 apart: d = 0.5 along x.
// Rejects: the sign of d, d in the place of d / 2, a pushed nail.
START_TEST(leaves_part_as_in_equation_11)
{
    particle p[4];
    for (int i = 0; i < 4; i++)
        p[i] = at_rest(vec3_make(0, i, 0), i == 1 ? 0 : 1 + i);
    int fa[2] = { 0, 1 }, fb[2] = { 2, 3 };
    vec3 ca = { 0, 0, 0 }, cb = { 1, 0, 0 };
    ck_assert(leaves_separate(fa, 2, ca, 1, fb, 2, cb, 0.5, p) == 0.5);
    ck_assert(p[0].position.x == -0.25 && p[1].position.x == 0);
    ck_assert(p[2].position.x == 0.25 && p[3].position.x == 0.25);
    cb.x = 1.5;
    ck_assert(leaves_separate(fa, 2, ca, 1, fb, 2, cb, 0.5, p) == 0);
    ck_assert(p[0].position.x == -0.25);
    // A sphere without end has no way out of it.
    ck_assert(leaves_separate(fa, 2, ca, HUGE_VAL, fb, 2, cb, 0.5, p) == 0);
    ck_assert(p[0].position.x == -0.25);
}
END_TEST

// The leaf's centre lies 1 below the surface y = 0 of a rigid body.
// Rejects: the printed sign as the default, the other way round.
START_TEST(printed_push_goes_deeper_and_ours_comes_out)
{
    int fa = 0;
    vec3 ca = { 0, -1, 0 }, pb = { 0, 0, 0 };
    feature_point none = { 0 };
    response_options o = response_options_default();
    particle p[1] = { at_rest(ca, 1) };
    deformable_separate(&fa, 1, ca, none, pb, p, o);
    ck_assert(p[0].position.y == -0.5);
    p[0].position = ca;
    o.push = PUSH_PRINTED;
    deformable_separate(&fa, 1, ca, none, pb, p, o);
    ck_assert(p[0].position.y == -1.5);
}
END_TEST

// B's point moves to the midpoint of cA pB by Eqs 8 and 9, in both.
START_TEST(surface_feature_moves_to_the_midpoint)
{
    int fa = 3;
    vec3 ca = { 0, -1, 0 }, pb = { 0, 0, 0 };
    for (int push = PUSH_OUT; push <= PUSH_PRINTED; push++) {
        particle p[4] = { at_rest(vec3_make(1, 0, 0), 1),
                          at_rest(vec3_make(-1, 0, 1), 1),
                          at_rest(vec3_make(-1, 0, -1), 1), at_rest(ca, 1) };
        feature_point b = { 3, { 0, 1, 2 }, { 0.5, 0.25, 0.25 } };
        response_options o = response_options_default();
        o.push = (push_rule)push;
        deformable_separate(&fa, 1, ca, b, pb, p, o);
        ck_assert_double_eq_tol(feature_now(b, p).y, -0.5, ROUNDING);
        ck_assert(p[3].position.y == (push == PUSH_OUT ? -0.5 : -1.5));
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

// Pushes particle 0 up by a little against a surface, relaxes the sticks until
// they are straight, and returns what is left of the push.
static real retained(particle *p, int n, const stick *s, int sticks)
{
    const real push = 1e-5;
    vec3 start = p[0].position;
    contact c = on_surface(UP);
    c.fixed = vec3_make(0, start.y + push, 0);
    contact_separate(&c, p, smooth(SHARE_MASS));
    relax_options o = relax_options_pbd();
    o.tolerance = 1e-14;
    sticks_relax(s, sticks, p, n, 10000, o, NULL);
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
    ck_assert_double_eq_tol(retained(cube, 8, s, sticks), 0.25, 1e-4);

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
    ck_assert_double_eq_tol(retained(ico, 12, s, sticks), 1.0 / 12, 1e-4);
}
END_TEST

// --- nothing that is not finite -------------------------------------------

static const real HOSTILE[] = { 0, DBL_TRUE_MIN, DBL_MIN, 1e-200, 1e-20, 1,
                                1e20, 1e150 };
enum { HOSTILE_COUNT = sizeof HOSTILE / sizeof HOSTILE[0] };

static real hostile(void)
{
    return HOSTILE[(int)(any() * HOSTILE_COUNT)];
}

static vec3 hostile_vec3(void)
{
    real sign = any() < 0.5 ? -1 : 1;
    real x = sign * hostile(), y = -sign * hostile();
    return vec3_make(x, y, hostile());
}

// Numbers of every size, zero normals and levers without length: nothing that
// is not finite comes out.
// Rejects: 1 / (a tiny sum), a normal made of a zero length.
START_TEST(finite_input_gives_finite_output)
{
    seed = 99;
    for (int k = 0; k < 40000; k++) {
        particle p[6];
        for (int i = 0; i < 6; i++) {
            real w = hostile();
            p[i] = (particle){ hostile_vec3(), hostile_vec3(),
                               w < 1e100 ? w : 0 };
        }
        contact c = { .a = any_feature(0, 1 + k % 3),
                      .b = any_feature(3, k / 3 % 4),
                      .normal = vec3_unit(any_vec3(any() < 0.1 ? 0 : 1)),
                      .fixed = hostile_vec3(), .thickness = hostile(),
                      .mass_a = hostile(), .mass_b = hostile(),
                      .approach = hostile() };
        if (c.a.count > 1 && any() < 0.3) {
            c.a.weight[0] = hostile() < 1 ? 1e-160 : 1e-20;
            c.a.weight[1] = 1;
        }
        response_options o = { (share_rule)(k % 3), (push_rule)(k % 2),
                               1 + 5 * any(), any(), any() };
        contact_separate(&c, p, o);
        if (c.pushed < 1e100) contact_bounce(&c, p, o, 0.01);
        sphere_contact_separate((sphere_contact){ 1, 2, hostile() }, p, o);
        int fa[2] = { 0, 1 }, fb[2] = { 4, 5 };
        leaves_separate(fa, 2, hostile_vec3(), hostile(), fb, 2,
                        hostile_vec3(), hostile(), p);
        deformable_separate(fa, 2, hostile_vec3(), c.b, hostile_vec3(), p, o);
        int finite = 1;
        for (int i = 0; i < 6; i++)
            finite &= vec3_is_finite(p[i].position) &&
                      vec3_is_finite(p[i].previous);
        ck_assert_msg(finite, "case %d", k);
    }
}
END_TEST

int main(void)
{
    Suite *s = suite_create("response");
    TCase *t = tcase_create("points and gaps");
    tcase_add_test(t, feature_is_the_mean_of_its_vertices);
    tcase_add_test(t, gap_is_negative_in_overlap);
    tcase_add_test(t, features_apart_are_left);
    suite_add_tcase(s, t);

    t = tcase_create("the push");
    tcase_add_test(t, features_meet_after_one_push);
    tcase_add_test(t, equations_8_and_9_are_the_case_of_equal_masses);
    tcase_add_test(t, push_keeps_momentum);
    tcase_add_test(t, vertex_and_face_share_three_to_one);
    tcase_add_test(t, fly_and_elephant);
    tcase_add_test(t, bodies_meet_at_q);
    tcase_add_test(t, thickness_is_kept);
    tcase_add_test(t, immovable_side_takes_nothing);
    tcase_add_test(t, two_immovable_sides_stay);
    tcase_add_test(t, nailed_corner_stays);
    tcase_add_test(t, gain_goes_further_but_does_not_brake_more);
    tcase_add_test(t, sides_may_be_exchanged);
    suite_add_tcase(s, t);

    t = tcase_create("friction and restitution");
    tcase_add_test(t, little_sliding_is_undone_and_no_more);
    tcase_add_test(t, much_sliding_is_braked_by_mu_times_the_push);
    tcase_add_test(t, slope_holds_one_degree_below_and_slips_one_above);
    tcase_add_test(t, sliding_stops_after_v2_over_2_mu_g);
    tcase_add_test(t, ball_bounces_to_e_squared_of_its_height);
    tcase_add_test(t, bounce_keeps_momentum_and_positions);
    tcase_add_test(t, bounce_is_for_contacts_that_pushed);
    suite_add_tcase(s, t);

    t = tcase_create("particles and leaves");
    tcase_add_test(t, particles_part_to_their_distance_by_mass);
    tcase_add_test(t, coincident_particles_and_leaves_are_left);
    tcase_add_test(t, particles_brake_and_nailed_ones_stay);
    tcase_add_test(t, smooth_particles_are_not_braked);
    tcase_add_test(t, particles_that_only_rounding_overlaps_are_left);
    tcase_add_test(t, leaves_part_as_in_equation_11);
    tcase_add_test(t, printed_push_goes_deeper_and_ours_comes_out);
    tcase_add_test(t, surface_feature_moves_to_the_midpoint);
    suite_add_tcase(s, t);

    t = tcase_create("bodies and bad input");
    tcase_add_test(t, sticks_take_back_all_but_a_quarter_or_a_twelfth);
    tcase_add_test(t, finite_input_gives_finite_output);
    suite_add_tcase(s, t);

    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
