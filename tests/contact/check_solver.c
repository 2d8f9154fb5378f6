// check_solver.c - are bodies parted, and do contacts last?  Chapters 9, 13.

#include <check.h>
#include <stdlib.h>

#include "blocks.h"
#include "narrow.h"
#include "pairs.h"
#include "solver.h"

static void find(void)
{
    begin_frame();
    pairs_find(&w);
    narrow_find(&w);
}

// A whole frame without its end.
static void frame(void)
{
    real h = w.options.dt / w.options.substeps;
    find();
    for (int k = 0; k < w.options.substeps; k++) {
        integrate();
        if (k > 0) narrow_find_again(&w, k);
        solver_separate(&w, h);
        relax();
    }
    solver_end(&w);
}

static int is_pair(const int of[2], int a, int b)
{
    return (of[0] == a && of[1] == b) || (of[0] == b && of[1] == a);
}

// Did the two push each other in this frame?
static int pushes(int a, int b)
{
    int sum = 0;
    for (int k = 0; k < w.pushes.count; k++)
        sum += is_pair(w.pushes.between[k], a, b)
               && w.pushes.at[k].pushed[NORMAL] > 0;
    return sum > 0;
}

static int is_listed(int a, int b)
{
    for (int k = 0; k < w.pairs.count; k++)
        if (w.pairs.at[k].a == a && w.pairs.at[k].b == b) return 1;
    return 0;
}

// Rejects: a body that sinks a little in every frame; a push of one corner for
// all four.
START_TEST(separated_box_stands_on_its_skin)
{
    begin(world_options_default());
    int b = add_at(&box, 0, 0.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    for (int f = 0; f < 240; f++) frame();
    vec3 at[8];
    world_vertices(&w, &w.body[b], at);
    real least = HUGE_VAL, skin = w.body[b].thickness;
    for (int i = 0; i < 8; i++) least = fmin(least, at[i].y);
    ck_assert_msg(least > 0 && least < 1.5 * skin, "at %g, skin %g", least,
                  skin);
    ck_assert_int_gt(w.report.contacts, 3);
}
END_TEST

// Rejects: bodies that lie on each other asleep apart; nailed ones that join
// what stands on them; neighbours that are near and do not push.
START_TEST(bodies_that_push_each_other_are_one_island)
{
    begin(world_options_default());
    int s = add_nailed(&slab, 0, -0.25, 0);
    int a = add_at(&box, 0, 0.52, 0), b = add_at(&box, 0, 1.56, 0);
    int c = add_at(&box, -1.02, 0.52, 0);
    ready();
    for (int f = 0; f < 600; f++) frame();
    ck_assert(pushes(a, b));
    // Every frame looks a little beyond the skins.
    ck_assert_int_ge(w.pushes.count, 16);
    char still[4] = { 1, 1, 1, 1 };
    rest_end(&w.rest, still, 1, 0.5);
    ck_assert(w.rest.asleep[a] && w.rest.asleep[b] && w.rest.asleep[c]);
    ck_assert_int_eq(w.rest.island[a], w.rest.island[b]);
    ck_assert_int_ne(w.rest.island[a], w.rest.island[c]);
    ck_assert(body_is_nailed(&w.body[s]));
}
END_TEST

// Rejects: NaN that meets everybody.
START_TEST(lost_body_touches_nobody)
{
    begin(world_options_default());
    int a = add_at(&ball, 0, 0.5, 0), b = add_at(&ball, 0.9, 0.5, 0);
    int c = add_at(&box, 5, 0.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    w.pool.at[w.body[a].first + 2].position.x = (real)NAN;
    for (int f = 0; f < 10; f++) frame();
    const int fine[2] = { b, c };
    for (int k = 0; k < 2; k++) {
        const body *x = &w.body[fine[k]];
        for (int i = x->first; i < x->first + body_particles(x); i++)
            ck_assert(vec3_is_finite(w.pool.at[i].position));
    }
}
END_TEST

// --- memory ------------------------------------------------------------------

// What the contacts of all but one body have pushed.
static vec3 pushed_but_by(int b)
{
    vec3 sum = ZERO;
    for (int k = 0; k < w.pushes.count; k++) {
        if (w.pushes.between[k][0] == b || w.pushes.between[k][1] == b)
            continue;
        for (int d = 0; d < DIRECTIONS; d++)
            sum = vec3_add_scaled(sum, w.pushes.at[k].pushed[d],
                                  w.pushes.at[k].along[d]);
    }
    return sum;
}

// Rejects: a memory of another pair, or of another point of this one; one that
// is lost where pairs come and go before it in the list.
START_TEST(new_contacts_begin_with_what_the_old_ones_pushed)
{
    for (int memory = 0; memory < 2; memory++) {
        world_options o = world_options_default();
        o.memory = memory;
        begin(o);
        add_nailed(&slab, 0, -0.25, 0);
        for (int k = 0; k < 3; k++) add_at(&box, 0.02 * k, 0.51 + 1.01 * k, 0);
        int passing = add_at(&ball, 9, 0.5, 0);
        add_at(&box, -1.8, 0.51, 0);
        ck_assert(world_add_plane(&w, UP, -2).ok);
        ready();
        for (int f = 0; f < 200; f++) frame();
        int pushing = 0;
        for (int k = 0; k < w.pushes.count; k++)
            pushing += w.pushes.at[k].pushed[NORMAL] > 0;
        ck_assert_int_eq(w.report.pushing, pushing);
        vec3 was = pushed_but_by(passing);
        ck_assert(was.y > 0);
        // The ball comes by: new pairs stand between the old ones.
        for (int i = 0; i < FOUR; i++) {
            particle *x = &w.pool.at[w.body[passing].first + i];
            x->position = x->previous = vec3_add(vec3_make(1.06, 0.5, 0),
                                                 w.body[passing].four->at[i]);
        }
        find();
        ck_assert(is_listed(1, passing));
        near_vec3(pushed_but_by(passing), memory ? was : ZERO, 1e-3 * was.y);
    }
}
END_TEST

// A pile of three lies still: its contacts of the last frame are those of this
// one.  One box moves, a little or more.
// Rejects: contacts that stay when their body has gone; the ones of a neighbour
// that nobody touches thrown away with them; a push that is lost, or begins
// anew; a list of pairs that misses whoever comes near.
START_TEST(who_lies_where_he_lay_keeps_his_contacts)
{
    const struct { real by; int stays; } way[] = { { 0.0005, 1 }, { 0.01, 0 } };
    for (int k = 0; k < 2; k++) {
        begin(world_options_default());
        w.options.resting = 0;
        for (int b = 0; b < 3; b++) add_at(&box, 0, 0.505 + 1.01 * b, 0);
        int far = add_at(&box, 5, 0.505, 0);
        ck_assert(world_add_plane(&w, UP, 0).ok);
        ready();
        for (int f = 0; f < 120; f++) frame();
        find();
        int all = w.pushes.count;
        const push *one = &w.pushes.at[0];
        vec3 was = one->along[ACROSS], at = point_of(&one->a);
        real load = w.pushes.at[0].pushed[NORMAL];
        ck_assert(load > 0);
        for (int b = 0; b <= far; b++) ck_assert(!w.flags.fresh[b]);
        for (int i = 0; i < FOUR; i++) {
            particle *x = &w.pool.at[w.body[0].first + i];
            real by = way[k].by * box.radius;
            x->position.x += by;
            x->previous.x += by;
        }
        find();
        ck_assert_int_eq(w.flags.fresh[0], !way[k].stays);
        const char *fresh = w.flags.fresh;
        ck_assert(!fresh[1] && !fresh[2] && !fresh[far]);
        ck_assert_int_eq(w.pushes.count, all);
        // Found anew, nobody has needed it yet.
        for (int i = 0; i < all; i++) {
            int moved = w.pushes.between[i][0] == 0 && !way[k].stays;
            if (w.pushes.at[i].pushed[NORMAL] > 0)
                ck_assert_int_eq(w.pushes.at[i].ready, !moved);
        }
        near_real(w.pushes.at[0].pushed[NORMAL], load, 1e-9 * load);
        near_vec3(w.pushes.at[0].along[ACROSS], was, ROUNDING);
        near_vec3(point_of(&w.pushes.at[0].a), at, 0.011 * box.radius);
        ck_assert(is_listed(0, 1) && is_listed(1, 2) && !is_listed(0, 2));
    }
}
END_TEST

// Two boxes lie still, and one of them is moved: the contacts of the other
// would stay, but there is no room.  Rejects: a write past the end.
START_TEST(contacts_that_stay_without_room_are_counted)
{
    begin(world_options_default());
    w.options.resting = 0;
    add_at(&box, 0, 0.505, 0);
    add_at(&box, 5, 0.505, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    for (int f = 0; f < 120; f++) frame();
    for (int i = 0; i < FOUR; i++)
        w.pool.at[w.body[0].first + i].position.x += 0.01;
    w.pushes.capacity = 6;
    find();
    ck_assert(w.flags.fresh[0] && !w.flags.fresh[1]);
    ck_assert_int_eq(w.pushes.count, 6);
    ck_assert_int_eq(w.report.dropped, 2);
    ck_assert(w.narrow.wall[1].is.run.margin == 0);
}
END_TEST

// Rejects: a gap, or a push, that is that of another frame.
START_TEST(pile_stands_alike_whether_contacts_stay_or_not)
{
    vec3 top[2];
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.stay = k ? 0.001 : 0;
        o.resting = 0;
        begin(o);
        for (int b = 0; b < 3; b++)
            add_at(&box, 0.1 * b, 0.505 + 1.01 * b, -0.05 * b);
        ck_assert(world_add_plane(&w, UP, 0).ok);
        ready();
        for (int f = 0; f < 240; f++) frame();
        top[k] = w.pool.at[w.body[2].first].position;
        real load = 0;
        for (int i = 0; i < w.pushes.count
                        && w.pushes.between[i][1] >= w.bodies; i++)
            load += w.pushes.at[i].pushed[NORMAL];
        real weight = 3 * w.body[0].mass * 9.81 * w.age * w.age;
        near_real(load, weight, 1e-3 * weight);
    }
    near_vec3(top[0], top[1], 0.002);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        new_contacts_begin_with_what_the_old_ones_pushed,
        who_lies_where_he_lay_keeps_his_contacts,
        contacts_that_stay_without_room_are_counted,
        pile_stands_alike_whether_contacts_stay_or_not,
        separated_box_stands_on_its_skin,
        bodies_that_push_each_other_are_one_island,
        lost_body_touches_nobody,
    };
    Suite *s = suite_create("solver");
    TCase *t = tcase_create("solver");
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
