// check_separation.c - are particles kept apart?  Book: chapter 16.

#include <check.h>
#include <float.h>
#include <stdlib.h>

#include "separation.h"
#include "hostile.h"
#include "random.h"
#include "suite.h"

// A sum of a dozen products, each rounded once.
#define ROUNDING 1e-14
// Momentum: products of mass and move, in units of the largest of them.
#define MOMENTUM 1e-15

static const vec3 UP = { 0, 1, 0 };
static const vec3 ORIGIN = { 0, 0, 0 };

static unsigned long long seed;

static particle at_rest(vec3 x, real mass)
{
    return (particle){ x, x, mass > 0 ? 1 / mass : 0 };
}

// --- two particles --------------------------------------------------------

// Rejects: half each whatever the masses; a distance not kept.
START_TEST(particles_part_to_their_distance_by_mass)
{
    particle p[2] = { at_rest(vec3_make(0, 0, 0), 1),
                      at_rest(vec3_make(0, 0, 0.6), 3) };
    particle_contact c = { 0, 1, 1 };
    ck_assert_double_eq_tol(particle_contact_separate(c, p, 0.5), 0.4,
                            ROUNDING);
    ck_assert_double_eq_tol(p[0].position.z, -0.3, ROUNDING);
    ck_assert_double_eq_tol(p[1].position.z, 0.7, ROUNDING);
    p[1].position.z = 2;
    ck_assert(particle_contact_separate(c, p, 0.5) == 0);
    ck_assert(p[1].position.z == 2);
}
END_TEST

// Rejects: friction, or a push, that acts on one side alone.
START_TEST(parted_particles_keep_their_momentum)
{
    seed = 5;
    for (int k = 0; k < 1000; k++) {
        particle p[2];
        for (int i = 0; i < 2; i++)
            p[i] = (particle){ random_vec3(&seed, 0.4), random_vec3(&seed, 0.4),
                               random_between(&seed, 0.1, 10) };
        vec3 before[2] = { p[0].position, p[1].position };
        ck_assert(particle_contact_separate((particle_contact){ 0, 1, 2 }, p,
                                            random_fraction(&seed)) > 0);
        vec3 a = vec3_scale(1 / p[0].inverse_mass,
                            vec3_sub(p[0].position, before[0]));
        vec3 b = vec3_scale(1 / p[1].inverse_mass,
                            vec3_sub(p[1].position, before[1]));
        ck_assert_double_le(vec3_length(vec3_add(a, b)),
                            20 * MOMENTUM * (1 + vec3_length(a)));
    }
}
END_TEST

// Rejects: 0 / 0 as a normal.
START_TEST(coincident_particles_are_left)
{
    particle p[2] = { at_rest(vec3_make(1, 2, 3), 1),
                      at_rest(vec3_make(1, 2, 3), 1) };
    vec3 x = p[0].position;
    ck_assert(particle_contact_separate((particle_contact){ 0, 1, 1 }, p, 0.5)
              == 0);
    ck_assert(vec3_distance(p[0].position, x) == 0);
    ck_assert(vec3_distance(p[1].position, x) == 0);
}
END_TEST

// Rejects: pushes on pinned particles; friction beyond the limit.
START_TEST(particles_brake_and_pinned_ones_stay)
{
    particle p[2] = { at_rest(vec3_make(0, 0.9, 0), 2),
                      at_rest(vec3_make(0, 0, 0), 0) };
    p[0].previous = vec3_make(-1, 2, 0);    // fell while it slid
    particle_contact c = { 0, 1, 1 };
    particle_contact_separate(c, p, 0.5);
    ck_assert_double_eq_tol(p[0].position.y, 1, ROUNDING);
    ck_assert_double_eq_tol(p[0].position.x, -0.05, ROUNDING);
    ck_assert(vec3_length(p[1].position) == 0);
    p[0].inverse_mass = 0;
    p[0].position.y = 0.5;
    ck_assert_double_gt(particle_contact_separate(c, p, 0.5), 0);
    ck_assert(p[0].position.y == 0.5);
}
END_TEST

// Without friction what slid goes on sliding.
START_TEST(smooth_particles_are_not_braked)
{
    particle p[2] = { at_rest(vec3_make(0, 0.9, 0), 2),
                      at_rest(vec3_make(0, 0, 0), 0) };
    p[0].previous = vec3_make(-1, 0.9, 0);
    particle_contact_separate((particle_contact){ 0, 1, 1 }, p, 0);
    ck_assert_double_eq_tol(p[0].position.y, 1, ROUNDING);
    ck_assert(p[0].position.x == 0);
}
END_TEST

// Two in touch, of 3 and 1 kg: the first slid by 0.3 m, and its strands will draw
// it by 0.1 m more.  All of that is taken back, by their masses, or as much of it as
// is allowed; nothing along the line between them.
// Rejects: sliding that is taken back alone, which lets a cloth creep off a rope; a
// brake without a bound; momentum from nothing.
START_TEST(what_slid_and_will_be_drawn_is_taken_back)
{
    for (int k = 0; k < 2; k++) {
        particle p[2] = { at_rest(vec3_make(0, 1, 0), 3),
                          at_rest(vec3_make(0, 0, 0), 1) };
        p[0].previous = vec3_make(-0.3, 2, 0);
        real most = k == 0 ? 1 : 0.2, takes = k == 0 ? 0.4 : 0.2;
        particle_contact_brake((particle_contact){ 0, 1, 1 }, p,
                               vec3_make(0.1, -5, 0), most);
        ck_assert_double_eq_tol(p[0].position.x, -0.25 * takes, ROUNDING);
        ck_assert_double_eq_tol(p[1].position.x, 0.75 * takes, ROUNDING);
        ck_assert(p[0].position.y == 1 && p[1].position.y == 0);
    }
}
END_TEST

// A distance whose square is more than that of the particles, and whose root is
// not.  Rejects: a push of 0, that is counted.
START_TEST(particles_that_only_rounding_overlaps_are_left)
{
    real x = 0x1.b15dbeb10ff4p-2, y = 0x1.04d10d670c943p-1;
    particle p[2] = { at_rest(vec3_make(x, y, 0), 1),
                      at_rest(vec3_make(0, 0, 0), 1) };
    particle_contact c = { 0, 1, 0x1.5315179e3d8f4p-1 };
    ck_assert(particle_contact_overlaps(&c, p));
    ck_assert(particle_contact_separate(c, p, 0.5) == 0);
    ck_assert(p[0].position.x == x && p[1].position.x == 0);
}
END_TEST

// --- a particle and a surface ---------------------------------------------

// Rejects: a distance that is left out, or kept along y.
START_TEST(particle_is_kept_off_a_surface)
{
    const vec3 normal = { 0.6, 0.8, 0 };
    particle p = at_rest(vec3_scale(-0.25, normal), 3);
    ck_assert_double_eq_tol(surface_separate(&p, ORIGIN, normal, 0.5, 0.5),
                            0.75, ROUNDING);
    ck_assert_double_lt(vec3_distance(p.position, vec3_scale(0.5, normal)),
                        ROUNDING);
    vec3 was = p.position = vec3_scale(0.75, normal);
    ck_assert(surface_separate(&p, ORIGIN, normal, 0.5, 0.5) == 0);
    ck_assert(vec3_distance(p.position, was) == 0);
    // A pinned one stays, and its overlap is said all the same.
    p = at_rest(ORIGIN, 0);
    ck_assert(surface_separate(&p, ORIGIN, normal, 0.5, 0.5) == 0.5);
    ck_assert(vec3_length(p.position) == 0);
}
END_TEST

// --- friction -------------------------------------------------------------

// Rejects: friction that turns the sliding round.
START_TEST(little_sliding_is_undone_and_no_more)
{
    particle p = { { 0.03, -0.1, -0.02 }, { 0, 0, 0 }, 1 };
    surface_separate(&p, ORIGIN, UP, 0, 0.5);
    ck_assert_double_lt(vec3_length(p.position), ROUNDING);
}
END_TEST

// Rejects: friction along the axes, each with its own limit.
START_TEST(much_sliding_is_braked_by_mu_times_the_push)
{
    particle p = { { 3, -0.1, 4 }, { 0, 0, 0 }, 2 };
    surface_separate(&p, ORIGIN, UP, 0, 0.5);
    ck_assert_double_eq_tol(p.position.x, 3 - 0.05 * 0.6, ROUNDING);
    ck_assert_double_eq_tol(p.position.z, 4 - 0.05 * 0.8, ROUNDING);
}
END_TEST

// How far a particle comes from rest in a second, by Verlet and contact alone.
static real slide_down(real degrees, real mu)
{
    real slope = degrees * acos(-1) / 180, dt = 0.01;
    vec3 normal = { sin(slope), cos(slope), 0 };
    vec3 gravity = { 0, -9.81, 0 };
    particle p = particle_start(ORIGIN, ORIGIN, ORIGIN, 1, dt);
    for (int k = 0; k < 100; k++) {
        verlet_step(&p, 1, gravity, NULL, dt);
        surface_separate(&p, ORIGIN, normal, 0, mu);
    }
    return vec3_length(p.position);
}

// Coulomb's cone: mu against tan(slope), a degree to either side.
// Rejects: friction measured along the gravity.
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
        particle p = particle_start(ORIGIN, vec3_make(v, 0, 0), ORIGIN, 1, dt);
        for (int k = 0; k < 4000; k++) {
            verlet_step(&p, 1, gravity, NULL, dt);
            surface_separate(&p, ORIGIN, UP, 0, mu);
        }
        real way = v * v / (2 * mu * 9.81);
        ck_assert_double_eq_tol(p.position.x / way, 1, 0.01);
        ck_assert(p.position.x - p.previous.x == 0);
    }
}
END_TEST

// --- nothing that is not finite -------------------------------------------

// Numbers of every size, and zero normals: nothing that is not finite comes
// out.
// Rejects: 1 / (a tiny sum), a normal made of a zero length.
START_TEST(finite_input_gives_finite_output)
{
    seed = 99;
    for (int k = 0; k < 40000; k++) {
        particle p[2];
        for (int i = 0; i < 2; i++) {
            real w = hostile(&seed);
            p[i] = (particle){ hostile_vec3(&seed), hostile_vec3(&seed),
                               w < 1e100 ? w : 0 };
        }
        particle_contact_separate((particle_contact){ 0, 1, hostile(&seed) }, p,
                                  random_fraction(&seed));
        particle_contact_brake((particle_contact){ 0, 1, 1 }, p,
                               hostile_vec3(&seed), hostile(&seed));
        surface_separate(&p[k % 2], hostile_vec3(&seed),
                         hostile_normal(&seed), hostile(&seed),
                         random_fraction(&seed));
        for (int i = 0; i < 2; i++)
            ck_assert_msg(vec3_is_finite(p[i].position), "case %d", k);
    }
}
END_TEST

// A static rope is never moved, and so keeps a lost `previous` for ever beside a
// good position.
// Rejects: friction from a sliding that is no number.
START_TEST(particle_that_lost_a_number_touches_nothing)
{
    const real lost[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 6; k++) {
        particle p[2] = { at_rest(ORIGIN, 0), at_rest(vec3_make(0, 0, .1), 1) };
        const particle before = p[1];
        particle_contact c = { k % 2, 1 - k % 2, 1 };
        p[0].previous.x = lost[k / 2];
        ck_assert(particle_contact_separate(c, p, 0.5) == 0);
        ck_assert(vec3_distance(p[1].position, before.position) == 0);
        ck_assert(vec3_distance(p[1].previous, before.previous) == 0);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        particles_part_to_their_distance_by_mass,
        parted_particles_keep_their_momentum,
        coincident_particles_are_left,
        particles_brake_and_pinned_ones_stay,
        smooth_particles_are_not_braked,
        what_slid_and_will_be_drawn_is_taken_back,
        particles_that_only_rounding_overlaps_are_left,
        particle_is_kept_off_a_surface,
        little_sliding_is_undone_and_no_more,
        much_sliding_is_braked_by_mu_times_the_push,
        slope_holds_one_degree_below_and_slips_one_above,
        sliding_stops_after_v2_over_2_mu_g,
        finite_input_gives_finite_output,
        particle_that_lost_a_number_touches_nothing,
        NULL
    };
    return suite_run((suite){ .name = "separation", .tests = tests });
}
