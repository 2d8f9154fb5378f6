// check_bend.c - tests of lib/soft/bend.c: strands that resist bending.  Each
// names the mistake that it rejects.

#include "bend.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

enum { MOST = 200 };

static particle p[MOST];
static bend_row room[MOST];
static shape rope, cloth;

static void set_up(void)
{
    ck_assert(shape_rope(&rope, 20, 2, 0.3).ok);
    ck_assert(shape_cloth(&cloth, 7, 9, 0.6, 1.6, 0.5, 0.2).ok);
}

static void tear_down(void)
{
    shape_free(&rope);
    shape_free(&cloth);
}

static unsigned long long seed = 5;

static void put(const shape *s, real crumpled)
{
    ck_assert_int_le(s->particles, MOST);
    for (int i = 0; i < s->particles; i++) {
        p[i] = (particle){ .inverse_mass = 1 / s->mass[i] };
        p[i].position = vec3_add(s->at[i], random_vec3(&seed, crumpled));
        p[i].previous = p[i].position;
    }
}

// Half the sum of m d^2, and the sums of m |d|, of m d and of m x times d, of how
// far the particles have come.
typedef struct { real work, pushes; vec3 push, moment; } gone;

static gone gone_since(const shape *s)
{
    gone g = { .work = 0 };
    for (int i = 0; i < s->particles; i++) {
        if (p[i].inverse_mass == 0) continue;
        real m = 1 / p[i].inverse_mass;
        vec3 d = vec3_sub(p[i].position, p[i].previous);
        g.work += m / 2 * vec3_length_squared(d);
        g.pushes += m * vec3_length(d);
        g.push = vec3_add_scaled(g.push, m, d);
        g.moment = vec3_add_scaled(g.moment, m,
                                   vec3_cross(p[i].position, d));
    }
    return g;
}

// A beam of length L is held level at one end: its first two particles are
// pinned.  Under its own weight it comes to rest where particle i bends by
//     C_i = m g / k * (1 + 2 + ... + (n - 1 - i)),  k = E I / l^3,
// and its end hangs by the sum of C_i (n - 1 - i).  Returns how far.
static real sag_of(const shape *s, real stiffness, real *wanted)
{
    int n = s->particles;
    real l = s->spacing, k = stiffness / (l * l * l), weight = s->mass[0];
    put(s, 0);
    p[0].inverse_mass = p[1].inverse_mass = 0;
    for (int step = 0; step < 200; step++) {
        // 1 m/s^2, 0.1 s
        for (int i = 2; i < n; i++) p[i].position.y -= 0.01;
        bend_relax(s, stiffness, p, 0.1, room);
    }
    *wanted = 0;
    for (int i = 1; i < n - 1; i++) {
        real after = n - 1 - i;
        *wanted += weight / k * after * (after + 1) / 2 * after;
    }
    return -p[n - 1].position.y;
}

// Rejects: a stiffness that is not E I, or is divided by another power of the
// spacing; a row that is wrong beside an end, or beside a pin.
START_TEST(beam_sags_as_far_as_theory_says)
{
    const int links[] = { 10, 20, 40, 80 };
    real last = 1;
    for (int k = 0; k < 4; k++) {
        shape beam;
        ck_assert(shape_rope(&beam, links[k], 1, 2).ok);
        real wanted, got = sag_of(&beam, 300, &wanted);
        ck_assert_msg(fabs(got - wanted) <= 1e-8 * wanted, "%d links: %.17g, "
                      "wanted %.17g", links[k], got, wanted);
        // Euler and Bernoulli, in the limit: q L^4 / (8 E I).
        real length = beam.spacing * (links[k] - 1);
        real beside = 2 * pow(length, 4) / (8 * 300);
        real off = fabs(got / beside - 1);
        ck_assert_msg(off < 3.5 / links[k] && off < 0.6 * last, "%d links: off "
                      "by %g", links[k], off);
        last = off;
        shape_free(&beam);
    }
}
END_TEST

// A cloth is as many beams as it has strands, which share its width.
// Rejects: strands that have the whole width each, or none of it; rows and
// columns that change places.
START_TEST(cloth_bends_as_its_strands_do)
{
    put(&cloth, 0);
    // A roof: its ridge runs along x, over the middle of the columns.
    for (int i = 0; i < cloth.particles; i++)
        p[i].position.y = -0.1 * fabs(p[i].position.z);
    real l = 1.6 / 8, width = 0.6, bend = 2 * 0.1 * l;
    // 7 columns, which share six spacings of 0.1 m.
    real wanted = 3 * width / (l * l * l) / 2 * bend * bend;
    real got = bend_energy(&cloth, 3, p);
    ck_assert_msg(fabs(got - wanted) <= 1e-13 * wanted, "%.17g, wanted %.17g",
                  got, wanted);
}
END_TEST

// Rejects: a push that one particle of the three does not answer; a solve that
// stops early.
START_TEST(bending_keeps_momentum)
{
    const shape *s[] = { &rope, &cloth };
    for (int k = 0; k < 60; k++) {
        const shape *x = s[k % 2];
        real stiffness = pow(10, k % 12 - 6);
        put(x, 0.3);
        bend_relax(x, stiffness, p, 0.01, room);
        gone g = gone_since(x);
        ck_assert(g.work > 0);
        ck_assert(vec3_length(g.push) <= 1e-9 * g.pushes);
        // Each direction for itself keeps the angular momentum.
        if (k % 2 == 0) ck_assert(vec3_length(g.moment) <= 1e-9 * g.pushes);
    }
}
END_TEST

// What bending gives back is no more than it had: half the sum of m d^2 / h^2,
// and what is left, are not more than what was stored.
// Rejects: a step that is explicit, or solves another matrix.
START_TEST(bending_never_makes_energy)
{
    const real h = 0.01;
    for (int k = 0; k < 60; k++) {
        real stiffness = pow(10, k % 20 - 6);
        put(&rope, 0.3);
        real before = bend_energy(&rope, stiffness, p);
        bend_relax(&rope, stiffness, p, h, room);
        real after = bend_energy(&rope, stiffness, p);
        real kinetic = gone_since(&rope).work / (h * h);
        ck_assert_msg(after + kinetic <= before * (1 + 1e-9),
                      "%g and %g of %g J", after, kinetic, before);
    }
}
END_TEST

// Rejects: rest that is not straight; rounding that grows with stiffness.
START_TEST(straight_strands_stay)
{
    const shape *s[] = { &rope, &cloth };
    for (int k = 0; k < 20; k++) {
        put(s[k % 2], 0);
        vec3 a = random_vec3(&seed, 1), b = random_vec3(&seed, 1);
        for (int i = 0; i < s[k % 2]->particles; i++) {
            vec3 x = p[i].position;
            p[i].position = vec3_add_scaled(vec3_scale(x.x, a), x.z, b);
            p[i].previous = p[i].position;
        }
        bend_relax(s[k % 2], pow(10, k - 5), p, 0.01, room);
        for (int i = 0; i < s[k % 2]->particles; i++)
            ck_assert(vec3_distance(p[i].position, p[i].previous) <= 1e-12);
    }
}
END_TEST

// Rejects: a pin that is moved; one that is forgotten in the rows of others.
START_TEST(pins_stay_and_all_others_come_to_rest)
{
    put(&rope, 0.2);
    const int pin[] = { 0, 7, 8, 20 };
    for (int k = 0; k < 4; k++) p[pin[k]].inverse_mass = 0;
    for (int step = 0; step < 100; step++) bend_relax(&rope, 1, p, 10, room);
    for (int k = 0; k < 4; k++)
        ck_assert(vec3_distance(p[pin[k]].position, p[pin[k]].previous) == 0);
    // A spline through its pins: no one particle could lower the energy.
    real least = bend_energy(&rope, 1, p);
    for (int i = 0; i < rope.particles; i++) {
        if (p[i].inverse_mass == 0) continue;
        for (int k = 0; k < 6; k++) {
            vec3 was = p[i].position;
            p[i].position = vec3_add(was, random_vec3(&seed, 1e-4));
            ck_assert(bend_energy(&rope, 1, p) >= least);
            p[i].position = was;
        }
    }
}
END_TEST

// Rejects: one lost strand that takes the others along.
START_TEST(lost_strand_is_left)
{
    put(&cloth, 0.05);
    p[10].position.y = (real)NAN;
    bend_relax(&cloth, 1, p, 0.01, room);
    int lost = 0;
    for (int i = 0; i < cloth.particles; i++)
        lost += !vec3_is_finite(p[i].position);
    ck_assert_int_eq(lost, 1);
    ck_assert(vec3_distance(p[0].position, p[0].previous) > 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        beam_sags_as_far_as_theory_says,
        cloth_bends_as_its_strands_do,
        bending_keeps_momentum,
        bending_never_makes_energy,
        straight_strands_stay,
        pins_stay_and_all_others_come_to_rest,
        lost_strand_is_left,
        NULL
    };
    return suite_run((suite){
        .name = "bend", .tests = tests, .set_up = set_up, .tear_down = tear_down
    });
}
