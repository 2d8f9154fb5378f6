// check_slots.c - tests of lib/public/slots: are ids never used twice?

#include "slots.h"
#include "suite.h"

#include <check.h>
#include <limits.h>
#include <stdint.h>

typedef struct {
    int value;
    double wide;
} thing;

static thing *put(slots *s, int value)
{
    int k = slots_take(s);
    ck_assert_int_ge(k, 0);
    thing *t = slots_at(s, k);
    ck_assert_int_eq(t->value, 0);
    t->value = value;
    return t;
}

START_TEST(things_are_found_by_place_and_generation)
{
    slots s;
    slots_init(&s, sizeof(thing));
    for (int k = 0; k < 100; k++) put(&s, k + 1);
    for (int k = 0; k < 100; k++) {
        thing *t = slots_find(&s, (unsigned)k, slots_generation(&s, k));
        ck_assert_ptr_nonnull(t);
        ck_assert_int_eq(t->value, k + 1);
        ck_assert_uint_eq((uintptr_t)t % sizeof(double), 0);
    }
    slots_free(&s);
}
END_TEST

// Rejects: a place that is given again with its old generation.
START_TEST(an_id_of_what_is_gone_finds_nothing_even_where_another_stands)
{
    slots s;
    slots_init(&s, sizeof(thing));
    put(&s, 7);
    unsigned old = slots_generation(&s, 0);
    slots_give(&s, 0);
    ck_assert_ptr_null(slots_find(&s, 0, old));
    ck_assert_ptr_null(slots_find(&s, 0, old + 1));
    ck_assert_ptr_null(slots_at(&s, 0));
    put(&s, 8);
    ck_assert_int_eq(s.count, 1);
    ck_assert_ptr_null(slots_find(&s, 0, old));
    ck_assert_int_eq(((thing *)slots_find(&s, 0, slots_generation(&s, 0)))
                     ->value, 8);
    slots_free(&s);
}
END_TEST

START_TEST(zero_and_what_never_was_find_nothing)
{
    slots s;
    slots_init(&s, sizeof(thing));
    ck_assert_ptr_null(slots_find(&s, 0, 0));
    put(&s, 1);
    ck_assert_ptr_null(slots_find(&s, 0, 0));
    ck_assert_ptr_null(slots_find(&s, 1, 1));
    ck_assert_ptr_null(slots_find(&s, UINT_MAX, UINT_MAX));
    slots_free(&s);
}
END_TEST

START_TEST(coming_and_going_needs_no_more_room)
{
    slots s;
    slots_init(&s, sizeof(thing));
    for (int k = 0; k < 10; k++) put(&s, k);
    for (int k = 0; k < 100000; k++) {
        slots_give(&s, k % 10);
        put(&s, k);
    }
    ck_assert_int_eq(s.count, 10);
    slots_free(&s);
}
END_TEST

START_TEST(a_place_without_generations_left_is_not_taken)
{
    slots s;
    slots_init(&s, sizeof(thing));
    put(&s, 1);
    s.slot[0].generation = UINT_MAX - 2;
    slots_give(&s, 0);
    put(&s, 2);
    ck_assert_int_eq(s.count, 2);
    ck_assert_ptr_null(slots_at(&s, 0));
    slots_free(&s);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        things_are_found_by_place_and_generation,
        an_id_of_what_is_gone_finds_nothing_even_where_another_stands,
        zero_and_what_never_was_find_nothing,
        coming_and_going_needs_no_more_room,
        a_place_without_generations_left_is_not_taken,
        NULL
    };
    return suite_run((suite){ .name = "slots", .tests = tests });
}
