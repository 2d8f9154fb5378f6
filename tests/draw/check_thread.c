// check_thread.c - does it matter who does the halves of a step?  Chapter 14.
//
// The second thread is that of the figures: figures/measure/thread.c.

#include <check.h>
#include <stdlib.h>

#include "world_scene.h"
#include "step.h"
#include "thread.h"

// More than are left whole, and in a heap after a second.
enum { BODIES = 200, FRAMES = 90 };

static void right_first(void *context, void (*work)(void *data, int half),
                        void *data)
{
    ++*(long *)context;
    work(data, 1);
    work(data, 0);
}

static unsigned long long bits_of(world_options how)
{
    world_scene s;
    scene_options what = scene_options_default();
    what.bodies = BODIES;
    ck_assert(world_scene_build(&s, SCENE_ROOM, what, how).ok);
    for (int k = 0; k < FRAMES; k++) world_step(&s.world);
    ck_assert_int_gt(s.world.pushes.end[PILE_LEFT], 100);
    ck_assert_int_gt(s.world.pushes.end[PILE_ACROSS],
                     s.world.pushes.end[PILE_RIGHT]);
    unsigned long long bits = world_hash(&s.world);
    world_scene_free(&s);
    return bits;
}

// Rejects: a number that both halves write; one that a half reads and the other
// writes; a sum whose order depends on who is ahead.
START_TEST(halves_give_the_same_bits_whoever_does_them)
{
    world_options how = world_scene_options(SCENE_ROOM, 0);
    unsigned long long bits = bits_of(how);
    long calls = 0;
    how.both = right_first;
    how.both_context = &calls;
    ck_assert(bits_of(how) == bits);
    ck_assert_int_gt(calls, FRAMES);
    thread *t = thread_new();
    ck_assert_ptr_nonnull(t);
    how.both = thread_both;
    how.both_context = t;
    ck_assert(bits_of(how) == bits);
    thread_free(t);
}
END_TEST

static void count(void *data, int half)
{
    int *done = data;
    for (int k = 0; k < 100 * (half + 1); k++) done[half]++;
}

// Rejects: a half that is done twice, or not at all, or is not done on return.
START_TEST(thread_does_its_half_every_time)
{
    thread *t = thread_new();
    ck_assert_ptr_nonnull(t);
    for (int k = 0; k < 20000; k++) {
        int done[2] = { 0 };
        thread_both(t, count, done);
        ck_assert(done[0] == 100 && done[1] == 200);
    }
    thread_free(t);
    thread_free(NULL);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("thread");
    TCase *t = tcase_create("thread");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, halves_give_the_same_bits_whoever_does_them);
    tcase_add_test(t, thread_does_its_half_every_time);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
