// check.c - tests of the exercise 12/tree.

#include "tree.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

// Of places of some metres, and systems whose pivots are not small.
static const real ROUNDING = 1e-11;

enum { MOST = 24 };

static particle p[MOST], q[MOST];
static int parent[MOST];
static real rest[MOST];

static unsigned long long seed = 13;

// A step in memory that ends behind the last particle.
static real step(int n)
{
    particle *mine = malloc((size_t)n * sizeof *mine);
    tree_node *node = malloc((size_t)n * sizeof *node);
    ck_assert(mine && node);
    memcpy(mine, p, (size_t)n * sizeof *mine);
    real worst = tree_step(mine, n, parent, rest, node);
    memcpy(p, mine, (size_t)n * sizeof *mine);
    free(mine);
    free(node);
    return worst;
}

static real strain(int n)
{
    real worst = 0;
    for (int i = 1; i < n; i++) {
        real d = vec3_distance(p[i].position, p[parent[i]].position);
        worst = fmax(worst, fabs(d / rest[i] - 1));
    }
    return worst;
}

// Any tree, its sticks off by up to `most` of a metre.
static void grow(int n, real most)
{
    p[0] = (particle){ { 0, 0, 0 }, { 0, 0, 0 }, 1 };
    for (int i = 0; i < n; i++) {
        parent[i] = i ? (int)(random_fraction(&seed) * i) : -7;
        vec3 way = vec3_unit(random_vec3(&seed, 1));
        if (i) p[i].position = vec3_add(p[parent[i]].position, way);
        p[i].inverse_mass = 1.5 + random_real(&seed);
        rest[i] = i ? 1 : -7;
    }
    for (int i = 0; i < n; i++) {
        p[i].position = vec3_add(p[i].position, random_vec3(&seed, most));
        p[i].previous = p[i].position;
    }
}

START_TEST(one_stick_takes_herons_step)
{
    // From d to (d^2 + L^2) / (2 d), shared by inverse mass.
    // Rejects: a sign; a root that stays; a child that mends all.
    p[0] = (particle){ { 0, 0, 0 }, { 0, 0, 0 }, 3 };
    p[1] = (particle){ { 0, 1.5, 0 }, { 0, 1.5, 0 }, 1 };
    parent[1] = 0;
    rest[1] = 1;
    near(step(2), (1.5 * 1.5 - 1) / 2, ROUNDING, "the error before");
    near(vec3_distance(p[0].position, p[1].position), (1.5 * 1.5 + 1) / 3,
         ROUNDING, "length");
    near(p[0].position.y, 3 * (1.5 - p[1].position.y), ROUNDING, "shares");
}
END_TEST

// How much a push of 1 by stick j changes stick i.
static real push_on(int i, int j, vec3 si, vec3 sj)
{
    real w = 0;
    if (i == j) w += q[i].inverse_mass;
    if (i == parent[j]) w -= q[i].inverse_mass;
    if (parent[i] == j) w -= q[j].inverse_mass;
    if (parent[i] == parent[j]) w += q[parent[i]].inverse_mass;
    return w * vec3_dot(si, sj);
}

// The same step by Gauss's elimination of the full system, on q.
static void step_in_full(int n)
{
    static real m[MOST][MOST + 1];
    vec3 stick[MOST] = { { 0, 0, 0 } };
    for (int i = 1; i < n; i++)
        stick[i] = vec3_sub(q[i].position, q[parent[i]].position);
    for (int i = 1; i < n; i++) {
        for (int j = 1; j < n; j++) m[i][j] = push_on(i, j, stick[i], stick[j]);
        m[i][n] = (vec3_dot(stick[i], stick[i]) - rest[i] * rest[i]) / 2;
    }
    for (int k = 1; k < n; k++)
        for (int i = 1; i < n; i++) {
            real share = i == k ? 0 : m[i][k] / m[k][k];
            for (int j = k; j <= n && i != k; j++) m[i][j] -= share * m[k][j];
        }
    for (int i = 1; i < n; i++) {
        real pull = m[i][n] / m[i][i];
        particle *a = &q[i], *b = &q[parent[i]];
        a->position = vec3_add_scaled(a->position, -pull * a->inverse_mass,
                                      stick[i]);
        b->position = vec3_add_scaled(b->position, pull * b->inverse_mass,
                                      stick[i]);
    }
}

START_TEST(tree_step_is_that_of_the_full_system)
{
    // Rejects: whatever is not told to those above, or those below.
    for (int round = 0; round < 400; round++) {
        int n = 2 + round % (MOST - 2);
        grow(n, 0.05);
        if (round % 3 == 0) p[round % n].inverse_mass = 0;
        memcpy(q, p, sizeof q);
        step_in_full(n);
        step(n);
        for (int i = 0; i < n; i++)
            near(vec3_distance(p[i].position, q[i].position), 0, 100 * ROUNDING,
                 "how far a particle is from where the full system puts it");
    }
}
END_TEST

START_TEST(centre_of_mass_stays_and_the_error_is_squared)
{
    for (int round = 0; round < 100; round++) {
        vec3 moved = { 0, 0, 0 };
        grow(MOST, 1e-4);
        real e = strain(MOST);
        step(MOST);
        for (int i = 0; i < MOST; i++)
            moved = vec3_add_scaled(moved, 1 / p[i].inverse_mass,
                                    vec3_sub(p[i].position, p[i].previous));
        near(vec3_length(moved), 0, ROUNDING, "momentum");
        ck_assert_msg(strain(MOST) < 1000 * e * e, "a strain of %g becomes %g",
                      e, strain(MOST));
    }
}
END_TEST

START_TEST(nails_stay_and_none_is_lost)
{
    // A leaf that is nailed, beside its nailed parent and at a free one; a
    // stick without length.  Rejects: 0 / 0.
    for (int round = 0; round < 4; round++) {
        grow(8, 0.01);
        parent[7] = 3;
        parent[3] = 1;
        p[7].inverse_mass = 0;
        if (round & 1) p[3].inverse_mass = 0;
        if (round & 2) p[5].position = p[parent[5]].position;
        memcpy(q, p, sizeof q);
        real before = fabs(vec3_distance(p[7].position, p[3].position) - 1);
        step(8);
        for (int i = 0; i < 8; i++) {
            ck_assert_msg(vec3_is_finite(p[i].position), "particle %d is at %g",
                          i, p[i].position.x);
            if (p[i].inverse_mass == 0)
                near(vec3_distance(p[i].position, q[i].position), 0, 0,
                     "way of a nail");
        }
        real after = fabs(vec3_distance(p[7].position, p[3].position) - 1);
        if (round == 0)
            ck_assert_msg(after <= 10 * before * before + ROUNDING, "the stick "
                          "at the nailed leaf: off by %g, before by %g", after,
                          before);
    }
}
END_TEST

START_TEST(straight_rope_between_nails_is_not_lost)
{
    // Its nails are a thousandth too far apart.  What is straight gives nothing
    // along itself once one end is held: what is left of it is rounding.
    for (int round = 0; round < 50; round++) {
        vec3 way = vec3_unit(random_vec3(&seed, 1));
        for (int i = 0; i < MOST; i++) {
            vec3 x = vec3_scale(1.001 * i, way);
            p[i] = (particle){ x, x, i > 0 && i < MOST - 1 };
            parent[i] = i - 1;
            rest[i] = 1;
        }
        memcpy(q, p, sizeof q);
        for (int k = 0; k < 5; k++) step(MOST);
        for (int i = 0; i < MOST; i++)
            near(vec3_distance(p[i].position, q[i].position), 0, 1,
                 "way of a particle that is off by some centimetres at most");
    }
}
END_TEST

START_TEST(chandelier_hangs_still)
{
    // A rope of 5 from the ceiling, three arms, and from each a rope with a
    // lamp of 1000 kg.
    const int n = 6 + 3 * 6;
    for (int i = 0; i < 6; i++) {
        vec3 x = { 0, -0.1 * i, 0 };
        p[i] = (particle){ x, x, i > 0 };
        parent[i] = i - 1;
        rest[i] = 0.1;
    }
    for (int arm = 0; arm < 3; arm++)
        for (int k = 0; k < 6; k++) {
            int i = 6 + 6 * arm + k;
            real turn = 2.0943951023931953 * arm;
            parent[i] = k ? i - 1 : 5;
            rest[i] = k ? 0.1 : 0.2;
            vec3 x = vec3_add(p[parent[i]].position,
                              vec3_make(0, k ? -0.1 : -0.2, 0));
            x = vec3_add(x, vec3_make(1e-3 * cos(turn), 0, 1e-3 * sin(turn)));
            p[i] = (particle){ x, x, k == 5 ? 1e-3 : 1 };
        }
    for (int k = 0; k < 3000; k++) {
        verlet_step(p, n, vec3_make(0, -9.81, 0), NULL, 1.0 / 3000);
        step(n);
        step(n);
        ck_assert_msg(strain(n) < 1e-6, "step %d: a strain of %g", k,
                      strain(n));
    }
}
END_TEST

START_TEST(long_rope_bears_its_weight)
{
    // 200 links, 10,000 times a particle's mass; then 100,000 particles in a
    // tree with two children each.  Rejects: n^2.
    enum { LINKS = 200, MANY = 100000 };
    particle *at = calloc(MANY, sizeof *at);
    tree_node *node = calloc(MANY, sizeof *node);
    int *up = calloc(MANY, sizeof *up);
    real *length = calloc(MANY, sizeof *length), worst = 0;
    ck_assert(at && node && up && length);
    for (int i = 0; i <= LINKS; i++) {
        vec3 x = { 0, -0.01 * i, 0 };
        at[i] = (particle){ x, x, i == 0 ? 0 : i < LINKS ? 1 : 1e-4 };
        up[i] = i - 1;
        length[i] = 0.01;
    }
    for (int k = 0; k < 60; k++) {
        verlet_step(at, LINKS + 1, vec3_make(0, -9.81, 0), NULL, 1.0 / 60);
        for (int i = 0; i < 6; i++)
            worst = tree_step(at, LINKS + 1, up, length, node);
    }
    ck_assert_msg(worst < 1e-8, "a strain of %g", worst);
    for (int i = 0; i < MANY; i++) {
        vec3 x = { i % 7, i % 11, i };
        at[i] = (particle){ x, x, 1 };
        up[i] = (i - 1) / 2;
        length[i] = i / 2 + 1;
    }
    worst = tree_step(at, MANY, up, length, node);
    ck_assert(worst < HUGE_VAL && vec3_is_finite(at[MANY - 1].position));
    free(at);
    free(node);
    free(up);
    free(length);
}
END_TEST

START_TEST(particle_alone_stays)
{
    p[0] = (particle){ { 1, 2, 3 }, { 0, 0, 0 }, 1 };
    near(step(1), 0, 0, "the worst of no stick");
    near(p[0].position.y, 2, 0, "its place");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        one_stick_takes_herons_step,
        tree_step_is_that_of_the_full_system,
        centre_of_mass_stays_and_the_error_is_squared,
        nails_stay_and_none_is_lost,
        straight_rope_between_nails_is_not_lost,
        chandelier_hangs_still,
        long_rope_bears_its_weight,
        particle_alone_stays,
        NULL
    };
    return suite_run((suite){ .name = "tree", .tests = tests });
}
