// check_narrow.c - where do rigid bodies touch?  Book: chapter 9.

#include <check.h>
#include <stdlib.h>

#include "blocks.h"
#include "narrow.h"
#include "pairs.h"

static void find(void)
{
    begin_frame();
    pairs_find(&w);
    narrow_find(&w);
}

// Rejects: an immovable body that is A; contacts that keep no skin, or one skin
// of two; a normal into the body.
START_TEST(box_on_a_slab_touches_with_its_corners)
{
    for (int order = 0; order < 2; order++) {
        begin(world_options_default());
        int s = -1;
        if (!order) s = add_nailed(&slab, 0, 0, 0);
        int b = add_at(&box, 0.2, 0.76, 0.1);
        if (order) s = add_nailed(&slab, 0, 0, 0);
        ready();
        find();
        ck_assert_int_eq(w.pushes.count, 4);
        real skins = w.body[s].thickness + w.body[b].thickness;
        for (int k = 0; k < 4; k++) {
            const push *c = &w.pushes.at[k];
            near_vec3(c->along[NORMAL], UP, ROUNDING);
            ck_assert(c->thickness == skins);
            ck_assert_int_eq(c->a.first, w.body[b].first);
            vec3 on_b = c->b.count > 0 ? point_of(&c->b) : c->fixed;
            near_vec3(vec3_sub(point_of(&c->a), on_b), vec3_make(0, 0.01, 0),
                      ROUNDING * 10);
        }
    }
}
END_TEST

// Rejects: planes that are met by particles that are no vertices; a corner that
// will touch before the frame ends, left out; one far away, kept.
START_TEST(corners_near_a_plane_are_contacts)
{
    begin(world_options_default());
    placement p = placement_at(vec3_make(0, 0.75, 0));
    p.velocity = vec3_make(0, -20, 0);
    add(&box, p);
    add_at(&box, 5, 2, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    find();
    // 0.25 m high, it falls by a third of a metre in a frame.
    ck_assert_int_eq(w.pushes.count, 4);
    for (int k = 0; k < 4; k++) {
        ck_assert(w.pushes.between[k][0] == 0
                  && w.pushes.between[k][1] == w.bodies);
        near_real(point_of(&w.pushes.at[k].a).y, 0.25, ROUNDING);
        ck_assert_int_eq(w.pushes.at[k].b.count, 0);
    }
}
END_TEST

// Rejects: a write past the end; contacts that are lost without a word.
START_TEST(contacts_without_room_are_counted)
{
    world_options o = world_options_default();
    o.stay = 0;
    begin(o);
    add_at(&box, 0, 0.5, 0);
    add_at(&box, 0, 1.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    find();
    int all = w.pushes.count;
    ck_assert_int_eq(w.report.dropped, 0);
    ck_assert_int_eq(all, 8);
    for (int room = 0; room < all; room++) {
        w.pushes.capacity = room;
        find();
        ck_assert_int_eq(w.pushes.count, room);
        ck_assert_int_eq(w.report.dropped, all - room);
    }
    w.pairs.capacity = 0;
    find();
    ck_assert_int_eq(w.pairs.count, 0);
    ck_assert_int_ge(w.report.dropped, 1);
}
END_TEST

// The small one shot at the slab, or the slab at the small one, nailed.
static void shoot(int at_small)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
    placement small = placement_at(vec3_make(0.2, 2, 0.1));
    placement large = placement_at(ZERO);
    small.is_static = at_small;
    large.is_static = !at_small;
    if (at_small) large.velocity = vec3_make(0, 300, 0);
    else          small.velocity = vec3_make(0, -300, 0);
    add(&ball, small);
    add(&slab, large);
    ready();
    find();
}

// A bullet of 300 m/s, 5 m a frame, from 2 m above a slab: it has one contact,
// there where it will touch.  Its middle keeps in front of the slab as well.
// Rejects: a guard that stands at the slab's middle, or keeps no inner radius
// away; a guard of what is nailed.
START_TEST(bullet_has_a_touch_and_a_guard)
{
    shoot(0);
    ck_assert_int_eq(w.pushes.count, 2);
    const push *touch = &w.pushes.at[0], *guard = &w.pushes.at[1];
    near_vec3(touch->along[NORMAL], UP, 1e-9);
    near_vec3(guard->along[NORMAL], touch->along[NORMAL], 0);
    near_vec3(guard->fixed, touch->fixed, 0);
    real skins = w.body[0].thickness + w.body[1].thickness;
    near_real(touch->thickness, skins, 0);
    near_real(guard->thickness, skins + shape_inner(&ball), ROUNDING);
    near_vec3(point_of(&guard->a), vec3_make(0.2, 2, 0.1), ROUNDING * 10);
    ck_assert(point_of(&touch->a).y < 2 - shape_inner(&ball) / 2);
    shoot(1);
    ck_assert_int_eq(w.pushes.count, 1);
}
END_TEST

// In the first of four substeps, in the second of eight.
// Rejects: contacts that are kept where they change, or found anew in each of
// many substeps; those of slow pairs and of planes thrown away with them.
START_TEST(quick_pairs_are_looked_at_again)
{
    world_options o = world_options_default();
    if (_i) o.substeps = 8;
    begin(o);
    placement p = placement_at(vec3_make(0, 1.2, 0));
    p.velocity = vec3_make(0, -25, 0);
    p.spin = vec3_make(3, 0, 20);
    add(&box, p);
    add_nailed(&slab, 0, 0.25, 0);
    int calm = add_at(&box, 5, -1.5, 0);
    ck_assert(world_add_plane(&w, UP, -2).ok);
    ready();
    find();
    w.report.substeps = o.substeps;
    ck_assert_int_gt(w.pushes.count, 4);
    vec3 point[MOST_VERTICES][2];
    for (int k = 1; k < 3; k++) {
        for (int again = 0; again < 2; again++) {
            for (int i = 0; i < w.pushes.count; i++)
                point[i][again] = point_of(&w.pushes.at[i].a);
            if (again) break;
            integrate();
            relax();
            for (int i = 0; i < w.pushes.count; i++)
                point[i][0] = point_of(&w.pushes.at[i].a);
            narrow_find_again(&w, k);
        }
        int calms = 0, changed = 0;
        for (int i = 0; i < w.pushes.count; i++) {
            int who = w.pushes.between[i][0];
            real moved = vec3_distance(point[i][0], point[i][1]);
            calms += who == calm;
            if (who == calm) ck_assert(moved == 0);
            else             changed |= moved > 0.01;
        }
        ck_assert_int_eq(calms, 4);
        ck_assert_int_eq(changed, k == (_i == 0 ? 1 : 2));
    }
}
END_TEST

// --- memory ------------------------------------------------------------------

// Rejects: a memory that goes to a point far from its own, or to all of them.
START_TEST(memory_goes_to_the_point_that_it_is_of)
{
    world_options o = world_options_default();
    o.stay = 0;
    begin(o);
    add_nailed(&slab, 0, -0.25, 0);
    add_at(&box, 0.1, 0.505, 0.2);
    ready();
    for (int kept = 0; kept < 4; kept++) {
        find();
        ck_assert_int_eq(w.pushes.count, 4);
        vec3 at = point_of(&w.pushes.at[kept].a);
        for (int k = 0; k < 4; k++) w.pushes.at[k].pushed[NORMAL] = k == kept;
        find();
        ck_assert_int_eq(w.pushes.count, 4);
        for (int k = 0; k < 4; k++) {
            int same = vec3_distance(point_of(&w.pushes.at[k].a), at) < 0.1;
            near_real(w.pushes.at[k].pushed[NORMAL], same, ROUNDING);
        }
        // That of another body, or of a plane, is nobody's here.
        for (int k = 0; k < 4; k++) w.pushes.between[k][1] = 2;
        find();
        for (int k = 0; k < 4; k++)
            ck_assert(w.pushes.at[k].pushed[NORMAL] == 0);
    }
}
END_TEST

// Four contacts leave what they pushed, and four are found again.
// Rejects: a load that nobody bears, for its contact is gone; one that is taken
// over twice, or with another sign.
START_TEST(every_memory_is_handed_over_once)
{
    world_options o = world_options_default();
    o.stay = 0;
    begin(o);
    add_nailed(&slab, 0, -0.25, 0);
    add_at(&box, 0.1, 0.505, 0.2);
    ready();
    find();
    ck_assert_int_eq(w.pushes.count, 4);
    for (int k = 0; k < 4; k++) w.pushes.at[k].pushed[NORMAL] = k + 1;
    for (int again = 0; again < 2; again++) {
        find();
        ck_assert_int_eq(w.pushes.count, 4);
        real sum = 0;
        for (int k = 0; k < w.pushes.count; k++)
            sum += w.pushes.at[k].pushed[NORMAL];
        near_real(sum, 10, ROUNDING * 10);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        memory_goes_to_the_point_that_it_is_of,
        every_memory_is_handed_over_once,
        box_on_a_slab_touches_with_its_corners,
        corners_near_a_plane_are_contacts,
        contacts_without_room_are_counted,
        bullet_has_a_touch_and_a_guard,
    };
    Suite *s = suite_create("narrow");
    TCase *t = tcase_create("narrow");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++)
        tcase_add_test(t, tests[i]);
    tcase_add_loop_test(t, quick_pairs_are_looked_at_again, 0, 2);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
