// check_pairs.c - whom may rigid bodies meet, and who wakes?  Book: chapter 9.

#include <check.h>
#include <stdlib.h>

#include "blocks.h"
#include "pairs.h"

static void find(void)
{
    begin_frame();
    pairs_find(&w);
}

// --- how far they go ---------------------------------------------------------

// Where a particle was tells its speed half a substep ago.
// Rejects: a way in metres a substep; a spin that moves the middle; gravity, or
// the hundredth of a radius, left out; a turn of the four particles instead of
// the corners'.
START_TEST(way_and_turn_are_those_of_a_frame)
{
    const vec3 spin[] = { { 0, 0, 0 }, { 0, 0, 3 } };
    for (int k = 0; k < 2; k++) {
        begin(world_options_default());
        placement p = placement_at(vec3_make(1, 2, 3));
        p.velocity = vec3_make(3, -4, 12);
        p.spin = spin[k];
        int b = add(&box, p);
        ready();
        pairs_look_ahead(&w, &w.body[b]);
        real dt = w.options.dt, h = w.age, g = 9.81;
        vec3 way = vec3_make(3 * dt, -4 * dt + g * dt * h / 2, 12 * dt);
        near_vec3(w.body[b].way, way, ROUNDING * 10);
        real least = g * dt * dt / 2 + box.radius / 100;
        real corners = 3 * sqrt(0.5) * dt * k;
        near_real(w.body[b].turn, least + corners, ROUNDING * 10);
        near_real(w.body[b].reach, vec3_length(way) + w.body[b].turn,
                  ROUNDING * 10);
    }
}
END_TEST

// Rejects: a look at where they are instead of at the way between; a way of one
// instead of the difference; a line that goes on beyond its end; what they turn
// left out.
START_TEST(who_flies_into_whom)
{
    const struct { vec3 from, v; real spin; int into; } shot[] = {
        { { -3, 0, 0 }, { 600, 0, 0 }, 0, 1 },      // 10 m a frame
        { { -3, 0, 0 }, { -600, 0, 0 }, 0, 0 },
        { { -3, 0, 1.3 }, { 600, 0, 0 }, 0, 1 },    // balls of 0.87 and 0.5
        { { -3, 0, 1.6 }, { 600, 0, 0 }, 0, 0 },
        { { -3, 0, 1.6 }, { 600, 0, 0 }, 30, 1 },   // they may turn together
        { { -3, 0, 0 }, { 60, 0, 0 }, 0, 0 },       // 1 m: not there yet
        { { -3, 0, 0 }, { 115, 0, 0 }, 0, 1 },
        { { -1.2, 0, 0 }, { 20, 0, 0 }, 0, 0 },     // too slow to be lost
        { { -3, 0, -3 }, { 600, 0, 600 }, 0, 1 },
    };
    for (size_t k = 0; k < sizeof shot / sizeof *shot; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        begin(o);
        // Seen from each other: half of it each.
        placement p = placement_at(shot[k].from), q = placement_at(ZERO);
        p.velocity = vec3_scale(0.5, shot[k].v);
        q.velocity = vec3_scale(-0.5, shot[k].v);
        q.spin = vec3_make(0, shot[k].spin, 0);
        int a = add(&ball, p), b = add(&box, q);
        ready();
        find();
        int into = shot[k].into;
        const body *x = &w.body[a], *y = &w.body[b];
        ck_assert_msg(pairs_fly_into(&w, x, y) == into, "shot %zu", k);
        ck_assert_int_eq(pairs_fly_into(&w, y, x), into);
    }
}
END_TEST

// --- who may meet whom -------------------------------------------------------

static real distance_of(int a, int b)
{
    vec3 at[2][12];
    hull q[2];
    const int who[2] = { a, b };
    for (int k = 0; k < 2; k++) {
        const body *x = &w.body[who[k]];
        world_vertices(&w, x, at[k]);
        q[k] = (hull){ at[k], x->plan->particles };
    }
    gjk_result g = gjk_distance(q[0], q[1], HUGE_VAL, NULL);
    return g.status == GJK_OVERLAP ? 0 : g.distance;
}

static int is_listed(int a, int b)
{
    for (int k = 0; k < w.pairs.count; k++)
        if (w.pairs.at[k].a == a && w.pairs.at[k].b == b) return 1;
    return 0;
}

// Bodies fly and turn through each other for a frame: whoever touches has been
// listed, and has contacts.
// Rejects: a reach by the centre's way alone; by the four particles' instead of
// the vertices' they carry; a spin, or gravity, left out.
START_TEST(whoever_meets_in_a_frame_was_listed_before)
{
    enum { BODIES = 10 };
    int met = 0, listed = 0;
    real further = 0;
    for (int n = 0; n < 60; n++) {
        world_options o = world_options_default();
        begin(o);
        for (int b = 0; b < BODIES; b++)
            add(b % 2 ? &ball : &box, anywhere(2.5, 20, 30));
        ready();
        find();
        ck_assert_int_eq(w.report.dropped, 0);
        ck_assert_int_eq(w.report.pairs, w.pairs.count);
        for (int k = 1; k < w.pairs.count; k++)
            ck_assert(w.pairs.at[k - 1].a < w.pairs.at[k].a
                      || (w.pairs.at[k - 1].a == w.pairs.at[k].a
                          && w.pairs.at[k - 1].b < w.pairs.at[k].b));
        listed += w.pairs.count;
        vec3 from[BODIES][12], now[12];
        for (int b = 0; b < BODIES; b++)
            world_vertices(&w, &w.body[b], from[b]);
        for (int k = 0; k < o.substeps; k++) {
            integrate();
            relax();
            for (int a = 0; a < BODIES; a++)
                for (int b = a + 1; b < BODIES; b++) {
                    real apart = w.body[a].thickness + w.body[b].thickness;
                    if (distance_of(a, b) > apart) continue;
                    met++;
                    ck_assert_msg(is_listed(a, b), "(%d, %d) meet unlisted", a,
                                  b);
                }
        }
        // Nobody went further than his reach.
        for (int b = 0; b < BODIES; b++) {
            world_vertices(&w, &w.body[b], now);
            for (int i = 0; i < w.body[b].plan->particles; i++)
                further = fmax(further, vec3_distance(now[i], from[b][i])
                                        - w.body[b].reach);
        }
    }
    ck_assert_msg(further <= 0, "%g m further than its reach", further);
    ck_assert_int_gt(met, 300);
    ck_assert_int_lt(listed, 60 * BODIES * (BODIES - 1) / 2);
}
END_TEST

// Rejects: pairs of which neither moves; deformable bodies among rigid ones.
START_TEST(only_pairs_that_can_move_are_listed)
{
    begin(world_options_default());
    int a = add_nailed(&slab, 0, 0, 0), b = add_nailed(&slab, 0, 0.4, 0);
    int c = add_at(&box, 0, 1.1, 0), d = add_at(&box, 0.5, 1.8, 0);
    add_at(&rope, 0, 1, 0);
    int far = add_at(&box, 0, 30, 0);
    ready();
    find();
    ck_assert(!is_listed(a, b) && is_listed(b, c) && is_listed(c, d));
    ck_assert(!is_listed(d, far));
    for (int k = 0; k < w.pairs.count; k++) ck_assert(w.pairs.at[k].b != 4);
    w.rest.asleep[c] = w.rest.asleep[d] = 1;
    w.rest.calm[far] = 1;
    find();
    ck_assert(!is_listed(b, c) && !is_listed(c, d));
    // Each alone is seen by who moves.
    w.rest.asleep[d] = 0;
    w.rest.calm[d] = 1;
    find();
    ck_assert(is_listed(c, d) && !is_listed(b, c));
}
END_TEST

// Rejects: a blow that is passed on to one who looks only as far as he himself
// goes.
START_TEST(who_is_near_a_quick_one_looks_as_far)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
    placement shot = placement_at(vec3_make(-1.05, 0, 0));
    shot.velocity = vec3_make(30, 0, 0);
    add(&box, shot);
    for (int k = 0; k < 3; k++) add_at(&box, 1.2 * k, 0, 0);
    ready();
    find();
    for (int k = 0; k < 3; k++) ck_assert(is_listed(k, k + 1));
    ck_assert(w.body[1].reach >= 30.0 / 60 && w.body[2].reach >= 30.0 / 60);
}
END_TEST

// --- waking ------------------------------------------------------------------

static void nap(int b, int island)
{
    w.rest.asleep[b] = 1;
    w.rest.island[b] = island;
    for (int i = 0; i < body_particles(&w.body[b]); i++)
        w.pool.at[w.body[b].first + i].inverse_mass = 0;
}

// Rejects: a sleeper that a calm one wakes, or a nailed one; one that wakes
// alone, or stays nailed when awake.
START_TEST(sleeper_wakes_for_the_quick_with_all_of_its_island)
{
    begin(world_options_default());
    int quick = add_at(&box, 0, 0, 0), a = add_at(&box, 3, 0, 0);
    int b = add_at(&box, 6, 0, 0), other = add_at(&box, 9, 0, 0);
    int nailed = add_nailed(&box, 12, 0, 0), calm = add_at(&box, 15, 0, 0);
    ready();
    nap(a, a);
    nap(b, a);
    nap(other, other);
    w.rest.calm[calm] = 0.1;
    ck_assert_int_eq(pairs_wake(&w, calm, a), 0);
    ck_assert_int_eq(pairs_wake(&w, a, nailed), 0);
    ck_assert_int_eq(pairs_wake(&w, a, b), 0);
    ck_assert_int_eq(pairs_wake(&w, quick, calm), 0);
    // What never moves is found to lie still, too.
    w.rest.asleep[nailed] = 1;
    ck_assert_int_eq(pairs_wake(&w, quick, nailed), 0);
    ck_assert(w.rest.asleep[nailed]);
    ck_assert(w.rest.asleep[a] && w.rest.asleep[b]);
    w.near.trusted = 5;
    ck_assert_int_eq(pairs_wake(&w, quick, b), 1);
    ck_assert(!w.rest.asleep[a] && !w.rest.asleep[b] && w.rest.asleep[other]);
    ck_assert_int_eq(w.near.trusted, -1);
    for (int i = 0; i < w.pool.count; i++) {
        int k = w.bodies - 1;
        while (w.body[k].first > i) k--;
        real wanted = k == other ? 0 : w.of.inverse_mass[i];
        ck_assert(w.pool.at[i].inverse_mass == wanted);
    }
    // In the other order.
    ck_assert_int_eq(pairs_wake(&w, other, quick), 1);
}
END_TEST

// Rejects: pairs of the woken that are listed a frame too late.
START_TEST(woken_take_part_in_the_same_frame)
{
    begin(world_options_default());
    placement shot = placement_at(vec3_make(-1.2, 0, 0));
    shot.velocity = vec3_make(20, 0, 0);
    int quick = add(&box, shot), a = add_at(&box, 0, 0, 0);
    int b = add_at(&box, 1.01, 0, 0);
    ready();
    nap(a, a);
    nap(b, a);
    find();
    ck_assert(!w.rest.asleep[a] && !w.rest.asleep[b]);
    ck_assert(is_listed(quick, a) && is_listed(a, b));
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        way_and_turn_are_those_of_a_frame,
        who_flies_into_whom,
        whoever_meets_in_a_frame_was_listed_before,
        only_pairs_that_can_move_are_listed,
        who_is_near_a_quick_one_looks_as_far,
        sleeper_wakes_for_the_quick_with_all_of_its_island,
        woken_take_part_in_the_same_frame,
    };
    Suite *s = suite_create("pairs");
    TCase *t = tcase_create("pairs");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++)
        tcase_add_test(t, tests[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
