// check_store.c - memory turned into bytes and back.

#include "store.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static int thing_there[3];

static const void *thing_at(const void *owner, int number)
{
    ck_assert_ptr_eq(owner, thing_there);
    return &thing_there[number];
}

// A list of what a store is made for.
typedef struct {
    double number;
    int count, room;
    double *table;
    char *scratch;
    const int *thing, *stranger;
    double over;            // means nothing later
} sample;

static void sample_store(sample *x, store *s)
{
    store_memory(s, x, sizeof *x);
    store_enter(s);
    STORE_TABLE(s, x->table, x->count, x->room);
    STORE_ROOM(s, x->scratch, 100);
    s->thing = thing_at;
    s->owner = thing_there;
    s->things = 3;
    store_pointer(s, &x->thing);
    store_pointer(s, &x->stranger);
    STORE_FORGET(s, x->over);
    store_leave(s);
}

static size_t sample_save(const sample *x, void *into, size_t room)
{
    sample all = *x;
    store s = store_to(into, room, "1.2");
    sample_store(&all, &s);
    return store_end(&s);
}

static status sample_load(sample *x, const void *from, size_t size,
                          const char *version)
{
    store s = store_from(from, size, version);
    memset(x, 0, sizeof *x);
    if (s.done.ok) sample_store(x, &s);
    return s.done;
}

static sample make_sample(void)
{
    sample x = { 0.1, 3, 5, malloc(5 * sizeof(double)), malloc(100),
                 &thing_there[2], (const int *)&x, 7 };
    for (int k = 0; k < 5; k++) x.table[k] = k + 0.5;
    return x;
}

static void free_sample(sample *x)
{
    free(x->table);
    free(x->scratch);
}

START_TEST(what_is_listed_comes_back)
{
    sample x = make_sample(), y;
    unsigned char at[1000];
    size_t size = sample_save(&x, at, sizeof at);
    ck_assert_uint_le(size, sizeof at);
    ck_assert(sample_load(&y, at, size, "1.2").ok);
    ck_assert(y.number == x.number && y.count == 3 && y.room == 5);
    ck_assert_mem_eq(y.table, x.table, 3 * sizeof(double));
    ck_assert(y.table[3] == 0 && y.table[4] == 0);      // room for more
    ck_assert_ptr_nonnull(y.scratch);
    ck_assert_ptr_eq(y.thing, &thing_there[2]);
    ck_assert_ptr_null(y.stranger);
    ck_assert(y.over == 0 && x.over == 7);
    free_sample(&x);
    free_sample(&y);
}
END_TEST

START_TEST(no_table_stays_none)
{
    sample x = { .count = 0 }, y;
    unsigned char at[1000];
    size_t size = sample_save(&x, at, sizeof at);
    ck_assert(sample_load(&y, at, size, "1.2").ok);
    ck_assert_ptr_null(y.table);
    ck_assert_ptr_null(y.scratch);
}
END_TEST

// Rejects: an address in the bytes.
START_TEST(equal_things_have_equal_bytes)
{
    sample x = make_sample(), y = make_sample();
    unsigned char a[1000], b[1000];
    size_t size = sample_save(&x, a, sizeof a);
    ck_assert_uint_eq(sample_save(&y, b, sizeof b), size);
    ck_assert_mem_eq(a, b, size);
    free_sample(&x);
    free_sample(&y);
}
END_TEST

static void expect_refusal(const void *at, size_t size, const char *version,
                           const char *part)
{
    sample y;
    status done = sample_load(&y, at, size, version);
    ck_assert(!done.ok);
    ck_assert_msg(strstr(done.why, part) != NULL, "said: %s", done.why);
    ck_assert_ptr_null(y.table);
}

START_TEST(cut_altered_or_foreign_bytes_are_refused)
{
    sample x = make_sample();
    unsigned char at[1000];
    size_t size = sample_save(&x, at, sizeof at);
    for (size_t n = 0; n < size; n++)
        expect_refusal(at, n, "1.2", n < 48 ? "no saved world" : "has");
    expect_refusal(at, size + 1, "1.2", "has");
    expect_refusal(at, size, "1.3", "another version of the library than 1.3");
    for (size_t i = 0; i < size; i++)
        for (int bit = 0; bit < 8; bit++) {
            at[i] ^= (unsigned char)(1 << bit);
            expect_refusal(at, size, "1.2", "");
            at[i] ^= (unsigned char)(1 << bit);
        }
    free_sample(&x);
}
END_TEST

// Two flips of the highest bits of words take each other back in a sum that is
// not mixed.
START_TEST(two_signs_that_change_are_seen)
{
    sample x = make_sample();
    unsigned char at[1000];
    size_t size = sample_save(&x, at, sizeof at);
    for (size_t i = 55; i < size; i += 8)
        for (size_t k = i + 8; k < size; k += 8) {
            at[i] ^= 0x80;
            at[k] ^= 0x80;
            expect_refusal(at, size, "1.2", "checksum");
            at[i] ^= 0x80;
            at[k] ^= 0x80;
        }
    free_sample(&x);
}
END_TEST

// Rejects: a table of as many bytes as another build would read.
START_TEST(a_table_of_another_size_is_refused)
{
    float three[3] = { 1, 2, 3 }, *table = three;
    double *wide = NULL;
    unsigned char at[1000];
    store s = store_to(at, sizeof at, "1");
    store_memory(&s, &table, sizeof table);
    STORE_TABLE(&s, table, 3, 3);
    size_t size = store_end(&s);
    s = store_from(at, size, "1");
    store_memory(&s, &wide, sizeof wide);
    STORE_TABLE(&s, wide, 3, 3);
    ck_assert(!s.done.ok);
    ck_assert_ptr_nonnull(strstr(s.done.why, "another build"));
    ck_assert_ptr_null(wide);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_is_listed_comes_back,
        no_table_stays_none,
        equal_things_have_equal_bytes,
        cut_altered_or_foreign_bytes_are_refused,
        two_signs_that_change_are_seen,
        a_table_of_another_size_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "store", .tests = tests });
}
