// check_task.c - is every item of work done once, whoever does it?  Chapter 18.

#include <check.h>

#include "task.h"
#include "suite.h"

enum { ITEMS = 7 };

static void count(void *data, int item)
{
    int *times = data;
    ck_assert(item >= 0 && item < ITEMS);
    times[item]++;
}

static void backwards(void *context, void (*work)(void *data, int item),
                      void *data, int items)
{
    ++*(int *)context;
    for (int k = items - 1; k >= 0; k--) work(data, k);
}

// Rejects: an item left out, or done twice; a caller's threads asked for one
// item, or for none; a context that is lost.
START_TEST(every_item_is_done_once)
{
    int calls = 0;
    const tasks none = { 0 }, own = { backwards, &calls };
    for (int items = 0; items <= ITEMS; items++) {
        int times[2][ITEMS] = { { 0 } };
        calls = 0;
        tasks_run(none, count, times[0], items);
        tasks_run(own, count, times[1], items);
        for (int k = 0; k < ITEMS; k++)
            ck_assert(times[0][k] == (k < items) && times[1][k] == (k < items));
        ck_assert_int_eq(calls, items > 1);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        every_item_is_done_once,
        NULL
    };
    return suite_run((suite){ .name = "task", .tests = tests });
}
