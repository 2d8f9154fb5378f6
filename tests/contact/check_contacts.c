// check_contacts.c - what of contacts is written down, and kept?  Chapter 13.

#include <check.h>
#include <stdlib.h>

#include "blocks.h"
#include "contacts.h"

static feature_point any_feature(int count, int vertices)
{
    feature_point f = { .count = count };
    real sum = 0;
    for (int v = 0; v < count; v++) {
        f.vertex[v] = (int)((any() + 1) / 2 * (vertices / count))
                    + v * (vertices / count);
        f.weight[v] = 0.1 + (any() + 1) / 2;
        sum += f.weight[v];
    }
    for (int v = 0; v < count; v++) f.weight[v] /= sum;
    return f;
}

static vec3 feature_of(int b, const feature_point *f)
{
    vec3 at[MOST_VERTICES], sum = ZERO;
    world_vertices(&w, &w.body[b], at);
    for (int v = 0; v < f->count; v++)
        sum = vec3_add_scaled(sum, f->weight[v], at[f->vertex[v]]);
    return sum;
}

// Rejects: weights of one vertex where there are three; those of the other
// body; the plan's place instead of the body's.
START_TEST(push_has_the_points_of_its_contact)
{
    begin(world_options_default());
    int a = add(&ball, anywhere(3, 5, 5)), b = add(&box, anywhere(3, 5, 5));
    placement still = anywhere(3, 0, 0);
    still.is_static = 1;
    int c = add(&ball, still), r = add_at(&rope, 0, 9, 0);
    ready();
    for (int n = 0; n < 200; n++) {
        int rigid = n % 2 ? b : c;
        contact_point x = { .normal = any_unit(), .thickness = 0.1 + any() / 20,
                      .fixed = any_vec3() };
        x.a = any_feature(1 + n % 3, 12);
        x.b = any_feature(1 + n / 3 % 3, n % 2 ? 8 : 12);
        push p = contacts_push(&w, &x, a, rigid);
        near_vec3(point_of(&p.a), feature_of(a, &x.a), ROUNDING * 10);
        near_vec3(point_of(&p.b), feature_of(rigid, &x.b), ROUNDING * 10);
        near_vec3(p.along[NORMAL], x.normal, 0);
        ck_assert(p.thickness == x.thickness && p.a.ways == &w.pushes.ways[a]);
        for (int d = 0; d < DIRECTIONS; d++) ck_assert(p.pushed[d] == 0);
        ck_assert(!p.ready && p.worn == 0);
        // A plane is nobody: its point is fixed.
        x.b.count = 0;
        p = contacts_push(&w, &x, a, -1);
        ck_assert_int_eq(p.b.count, 0);
        near_vec3(p.fixed, x.fixed, 0);
        // A deformable body touches with one particle, numbered in the pool.
        x.a = (feature_point){ 1, { w.body[r].first + n % 6 }, { 1 } };
        p = contacts_push(&w, &x, r, a);
        ck_assert(p.a.count == 1 && p.a.ways == NULL && p.a.share[0] == 1);
        ck_assert_int_eq(p.a.first, w.body[r].first + n % 6);
    }
}
END_TEST

// Rejects: a speed that is the same for a grain and a house; the longest stick.
START_TEST(blow_is_a_third_of_a_small_fall)
{
    begin(world_options_default());
    int a = add_at(&box, 0, 0, 0), b = add_at(&slab, 0, 9, 0);
    near_real(contacts_blow_speed(&w, &w.body[a]), sqrt(2 * 9.81) / 3,
              ROUNDING);
    near_real(contacts_blow_speed(&w, &w.body[b]), sqrt(9.81) / 3, ROUNDING);
    w.options.gravity = ZERO;
    ck_assert(contacts_blow_speed(&w, &w.body[a]) == 0);
}
END_TEST

// A box on a nailed slab, above a plane; nothing is asked where they touch.
static void stand(world_options o)
{
    begin(o);
    add_nailed(&slab, 0, -0.25, 0);
    add_at(&box, 0, 0.5, 0);
    add_floor();
    ready();
    w.report = (step_report){ .substeps = o.substeps };
    w.flags.moves[1] = 1;
}

// Two contacts between corners of the slab and of the box.
static const contact_point FOUND[2] = {
    { .a = { 1, { 0 }, { 1 } }, .b = { 1, { 0 }, { 1 } }, .normal.y = 1 },
    { .a = { 1, { 1 }, { 1 } }, .b = { 1, { 1 }, { 1 } }, .normal.y = 1 },
};

// They have been found between box and slab, and one of the box's with the
// plane.
static void have_found(void)
{
    w.pairs.count = 1;
    w.pairs.at[0] = (body_pair){ .a = 0, .b = 1 };
    w.pairs.at[0].is = (inquiry){ .ask = ASK_NEAREST, .found = 2, .margin = 1 };
    for (int k = 0; k < 2; k++) contacts_of_pair(&w, w.pairs.at)[k] = FOUND[k];
    w.narrow.wall[1].is = (inquiry){ .ask = ASK_NEAREST, .found = 1,
                                     .margin = 2 };
    w.narrow.wall[1].at[0] = 1;
    contacts_of_planes(&w, 1)[0] = FOUND[1];
    contacts_of_planes(&w, 1)[0].b.count = 0;
}

static void write_down(int again)
{
    contacts_place(&w, again);
    if (!again) contacts_write_planes(&w, 1);
    contacts_write_pair(&w, w.pairs.at);
}

// Rejects: an immovable body that is A; a plane that is a body; planes that
// come after pairs.
START_TEST(contacts_are_written_down_with_the_immovable_as_b)
{
    stand(world_options_default());
    have_found();
    write_down(0);
    ck_assert_int_eq(w.pushes.count, 3);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(w.pushes.between[k][0], k > 0 ? 0 : 1);
        ck_assert_int_eq(w.pushes.between[k][1], k > 0 ? 1 : w.bodies);
        ck_assert_int_eq(w.pushes.at[k].a.body, 1);
        ck_assert_int_eq(w.pushes.at[k].b.body, -1);
    }
    const contact_run *run = &w.pairs.at[0].is.run;
    ck_assert(run->first == 1 && run->count == 2);
    ck_assert(run->margin == 1);
}
END_TEST

// Rejects: a write past the end; contacts that are lost without a word, or
// taken for all that there are.
START_TEST(contacts_get_the_room_there_is)
{
    for (int room = 0; room < 4; room++) {
        stand(world_options_default());
        have_found();
        w.pushes.capacity = room;
        write_down(0);
        ck_assert_int_eq(w.pushes.count, room < 3 ? room : 3);
        ck_assert_int_eq(w.report.dropped, 3 - w.pushes.count);
        if (room < 3) ck_assert(w.pairs.at[0].is.run.margin == 0);
        ck_assert_int_eq(w.pairs.at[0].is.run.count, room > 1 ? room - 1 : 0);
    }
}
END_TEST

// Rejects: quick pairs that stand before the lasting contacts, or throw them
// away; that are good for another frame.
START_TEST(contacts_of_quick_pairs_come_last_and_are_replaced)
{
    stand(world_options_default());
    have_found();
    w.pairs.at[0].quick = 1;
    write_down(0);
    for (int found = 2; found >= 0; found--) {
        ck_assert_int_eq(w.pushes.lasting, 1);
        ck_assert_int_eq(w.pushes.count, 1 + w.pairs.at[0].is.found);
        ck_assert(w.pairs.at[0].is.run.margin == 0);
        w.pairs.at[0].is.found = found;
        write_down(1);
        ck_assert_int_eq(w.pushes.count, 1 + found);
    }
}
END_TEST

// Rejects: contacts that stay where one of two moved, or the nearer the farther
// they look; that have no margin at all.
START_TEST(contacts_may_stay_until_their_slack_is_used_up)
{
    stand(world_options_default());
    real slack = contacts_slack(&w, 0, 1), alone = contacts_slack(&w, 1, 2);
    real stay = w.options.stay;
    near_real(slack, 2 * stay * (slab.radius + box.radius), ROUNDING);
    near_real(alone, 2 * stay * box.radius, ROUNDING);
    contact_run run = { 0, 2, 1 };
    w.flags.fresh[0] = w.flags.fresh[1] = 0;
    ck_assert(contacts_may_stay(&w, &run, 0, 1, 1 - 1.01 * slack));
    ck_assert(!contacts_may_stay(&w, &run, 0, 1, 1 - 0.99 * slack));
    ck_assert(contacts_may_stay(&w, &run, 1, 2, 1 - 1.01 * alone));
    for (int b = 0; b < 2; b++) {
        w.flags.fresh[b] = 1;
        ck_assert(!contacts_may_stay(&w, &run, 0, 1, 0));
        w.flags.fresh[b] = 0;
    }
    run.margin = 0;
    ck_assert(!contacts_may_stay(&w, &run, 0, 1, -1));
}
END_TEST

// Rejects: a push in metres of another substep; one that is kept where nothing
// is to be remembered; contacts whose places are those of the old list.
START_TEST(contacts_that_stay_push_on_as_hard)
{
    for (int memory = 0; memory < 2; memory++) {
        world_options o = world_options_default();
        o.memory = memory;
        stand(o);
        have_found();
        write_down(0);
        inquiry *is = &w.pairs.at[0].is;
        for (int k = 0; k < 2; k++) {
            w.pushes.old[5 + k] = w.pushes.at[1 + k];
            w.pushes.old[5 + k].pushed[NORMAL] = k + 1;
            w.pushes.old_between[5 + k][0] = 0;
            w.pushes.old_between[5 + k][1] = 1;
        }
        vec3 at[2] = { point_of(&w.pushes.at[1].a),
                       point_of(&w.pushes.at[2].a) };
        *is = (inquiry){ .ask = ASK_STAYS, .was = { 5, 2, 1 } };
        w.age = 2 * o.dt / o.substeps;
        write_down(0);
        ck_assert(is->run.first == 1 && is->run.count == 2);
        ck_assert(w.pushes.count == 3);
        ck_assert(is->run.margin == 1);
        for (int k = 0; k < 2; k++) {
            near_real(w.pushes.at[1 + k].pushed[NORMAL], memory * (k + 1) / 4.0,
                      ROUNDING);
            near_vec3(point_of(&w.pushes.at[1 + k].a), at[k], 0);
            ck_assert(w.pushes.between[1 + k][0] == 0);
            ck_assert(w.pushes.between[1 + k][1] == 1);
        }
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        push_has_the_points_of_its_contact,
        contacts_may_stay_until_their_slack_is_used_up,
        contacts_that_stay_push_on_as_hard,
        blow_is_a_third_of_a_small_fall,
        contacts_are_written_down_with_the_immovable_as_b,
        contacts_get_the_room_there_is,
        contacts_of_quick_pairs_come_last_and_are_replaced,
    };
    Suite *s = suite_create("contacts");
    TCase *t = tcase_create("contacts");
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
