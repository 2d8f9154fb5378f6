// check_halves.c - is a world cut in two halves that do not meet?  Chapter 14.

#include <check.h>
#include <stdlib.h>

#include "halves.h"
#include "stage.h"

enum { MANY = 300 };

static shape ball;

static void set_up(void)
{
    ck_assert(shape_icosahedron(&ball, 0.5, 2).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&ball);
}

// n balls anywhere in a box, as the step has looked at them.
static void scatter(int n, vec3 size)
{
    begin(world_options_default());
    for (int b = 0; b < n; b++) {
        vec3 x = any_vec3();
        add_at(&ball, x.x * size.x, x.y * size.y, x.z * size.z);
    }
    ready();
    for (int b = 0; b < n; b++) {
        w.flags.moves[b] = 1;
        w.pairs.ball[b].radius = 0.5;
        w.pairs.ball[b].center = particle_of(b, 0)->position;
    }
}

static void rightmost(void *context, void (*work)(void *data, int half),
                      void *data)
{
    ++*(int *)context;
    work(data, 1);
    work(data, 0);
}

static void note(void *data, int half)
{
    int *done = data;
    done[2 + half] = ++done[0];
}

// Rejects: a half that is done twice, or not; a caller who is not asked.
START_TEST(both_halves_are_done_once)
{
    int asked = 0;
    for (int k = 0; k < 2; k++) {
        int done[4] = { 0 };
        world_options o = world_options_default();
        if (k) o.both = rightmost;
        o.both_context = &asked;
        begin(o);
        halves_do(&w, note, done);
        ck_assert(done[0] == 2 && done[2] == 1 + k && done[3] == 2 - k);
        ck_assert_int_eq(asked, k);
    }
}
END_TEST

static real along(int b, int axis)
{
    vec3 c = w.pairs.ball[b].center;
    return axis == 0 ? c.x : axis == 1 ? c.y : c.z;
}

// Rejects: a cut along x always; one in the middle of the room instead of the
// bodies; sleepers that count; a body on neither side, or on both.
START_TEST(cut_has_half_of_those_that_move_on_either_side)
{
    const vec3 size[3] = { { 9, 4, 4 }, { 4, 9, 4 }, { 4, 4, 9 } };
    for (int axis = 0; axis < 3; axis++) {
        scatter(MANY, size[axis]);
        // The right third sleeps.
        int moving = 0, seen[MANY] = { 0 }, count[2] = { 0 };
        for (int b = 0; b < MANY; b++) {
            w.flags.moves[b] = along(b, axis) < 3;
            moving += w.flags.moves[b];
        }
        halves_cut(&w);
        real most = -HUGE_VAL, least = HUGE_VAL;
        for (int side = 0; side < 2; side++) {
            int n;
            const int *of = halves_bodies(&w, side, &n);
            for (int i = 0; i < n; i++) {
                real x = along(of[i], axis);
                seen[of[i]]++;
                ck_assert_int_eq(w.cut.side[of[i]], side);
                count[side] += w.flags.moves[of[i]];
                if (side) least = fmin(least, x);
                else      most = fmax(most, x);
            }
        }
        for (int b = 0; b < MANY; b++) ck_assert_int_eq(seen[b], 1);
        ck_assert(most < least);
        ck_assert_int_le(abs(count[0] - count[1]), 4);
        ck_assert_int_eq(count[0] + count[1], moving);
    }
}
END_TEST

// Rejects: a cut through a stack of ten; one that a lost body, or a deformable
// one, leads astray.
START_TEST(few_bodies_are_left_whole_and_lost_ones_do_not_count)
{
    scatter(100, vec3_make(9, 4, 4));
    halves_cut(&w);
    for (int b = 0; b < 100; b++) ck_assert_int_eq(w.cut.side[b], 0);
    ck_assert_int_eq(w.cut.lefts, 100);
    scatter(MANY, vec3_make(9, 4, 4));
    w.pairs.ball[7].center.x = (real)NAN;
    w.pairs.ball[8].center.x = HUGE_VAL;
    w.pairs.ball[9] = (sphere){ { 1000, 0, 0 }, -1 };
    halves_cut(&w);
    int lefts = 0;
    for (int b = 10; b < MANY; b++) lefts += !w.cut.side[b];
    ck_assert_int_ge(lefts, (MANY - 10) / 2 - 6);
    ck_assert_int_le(lefts, (MANY - 10) / 2 + 6);
}
END_TEST

static void join(int a, int b)
{
    w.pushes.between[w.pushes.count][0] = a;
    w.pushes.between[w.pushes.count][1] = b;
    w.pushes.count++;
}

// Rejects: a body that both of two parts push; a contact that is in none, or in
// two; an order that is not that of the list.
START_TEST(no_body_is_pushed_by_left_and_right)
{
    scatter(MANY, vec3_make(9, 4, 4));
    for (int b = 0; b < MANY; b += 10) w.flags.moves[b] = 0;
    halves_cut(&w);
    for (int k = 0; k < 1000; k++) {
        int a = (int)((any() + 1) / 2 * (MANY - 1)), b = a + 1 + k % 7;
        if (!w.flags.moves[a] && (b >= MANY || !w.flags.moves[b])) continue;
        join(a, b < MANY ? b : MANY + k % 6);
    }
    halves_sort(&w);
    int part[MANY], seen[1000] = { 0 }, n[PILE_PARTS] = { 0 };
    for (int b = 0; b < MANY; b++) part[b] = -1;
    ck_assert_int_eq(w.pushes.end[PILE_ACROSS], w.pushes.count);
    for (int p = 0, i = 0; p < PILE_PARTS; p++)
        for (int last = -1; i < w.pushes.end[p]; i++) {
            int k = w.pushes.in_parts[i];
            ck_assert_int_gt(k, last);
            last = k;
            seen[k]++;
            n[p]++;
            for (int s = 0; s < 2 && p < PILE_ACROSS; s++) {
                int b = w.pushes.between[k][s];
                if (b >= MANY || !w.flags.moves[b]) continue;
                ck_assert(part[b] < 0 || part[b] == p);
                part[b] = p;
            }
        }
    for (int k = 0; k < w.pushes.count; k++) ck_assert_int_eq(seen[k], 1);
    ck_assert(n[PILE_LEFT] > 100 && n[PILE_RIGHT] > 100);
    // Those across are what must be: both move, on different sides.
    for (int i = w.pushes.end[PILE_RIGHT]; i < w.pushes.count; i++) {
        const int *of = w.pushes.between[w.pushes.in_parts[i]];
        ck_assert(of[1] < MANY && w.flags.moves[of[0]] && w.flags.moves[of[1]]);
        ck_assert_int_ne(w.cut.side[of[0]], w.cut.side[of[1]]);
    }
}
END_TEST

int main(void)
{
    const TTest *const test[] = {
        both_halves_are_done_once,
        cut_has_half_of_those_that_move_on_either_side,
        few_bodies_are_left_whole_and_lost_ones_do_not_count,
        no_body_is_pushed_by_left_and_right,
    };
    Suite *s = suite_create("halves");
    TCase *t = tcase_create("halves");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof test / sizeof *test; i++)
        tcase_add_test(t, test[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
