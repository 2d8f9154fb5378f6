// check.c - tests of the exercise 19/saved.

#include "saved.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 4096 };
static unsigned char bytes[ROOM];

// A world with nothing in its padding, and numbers that only bits tell apart.
static small_world some(int count)
{
    unsigned long long seed = 5;
    small_world w;
    memset(&w, 0, sizeof w);
    w.gravity = vec3_make(-0.0, -9.81, (real)INFINITY);
    w.time = (real)NAN;
    w.count = count;
    for (int i = 0; i < count; i++) {
        w.balls[i].position = random_vec3(&seed, 1);
        w.balls[i].velocity = random_vec3(&seed, 1);
        w.balls[i].inverse_mass = 1e-300 / (i + 1);
    }
    return w;
}

static size_t save(const small_world *w)
{
    small_world kept = *w;
    size_t size = world_save(w, bytes, ROOM);
    ck_assert_msg(memcmp(&kept, w, sizeof kept) == 0, "to save a world changes it");
    ck_assert_msg(size > 0 && size <= ROOM, "it takes %zu bytes", size);
    return size;
}

static void is_same(const small_world *a, const small_world *b)
{
    ck_assert_msg(memcmp(&a->gravity, &b->gravity, sizeof a->gravity) == 0, "gravity is another");
    ck_assert_msg(memcmp(&a->time, &b->time, sizeof a->time) == 0, "the time is another");
    ck_assert_msg(a->count == b->count, "there are %d balls, and there were %d", b->count, a->count);
    for (int i = 0; i < a->count; i++)
        ck_assert_msg(memcmp(&a->balls[i], &b->balls[i], sizeof a->balls[i]) == 0, "ball %d is another", i);
}

// Loads from memory of just that size, into a world that must not change if it
// is refused.
static bool load(small_world *w, size_t size)
{
    unsigned char *exact = malloc(size + (size == 0));
    small_world kept = *w;
    ck_assert_ptr_nonnull(exact);
    memcpy(exact, bytes, size);
    bool is_loaded = world_load(w, exact, size);
    free(exact);
    if (!is_loaded) ck_assert_msg(memcmp(&kept, w, sizeof kept) == 0, "it was refused, and the world has changed");
    return is_loaded;
}

START_TEST(world_comes_back_to_the_bit)
{
    // Rejects: a member that is forgotten, numbers that are written in words.
    for (int count = 0; count <= BALLS; count += 5) {
        small_world w = some(count), back = some(7);
        size_t size = save(&w);
        ck_assert_msg(load(&back, size), "a world of %d balls is refused", count);
        is_same(&w, &back);
    }
}
END_TEST

START_TEST(balls_that_are_not_there_take_no_bytes)
{
    small_world one = some(1), two = some(2);
    size_t first = save(&one), second = save(&two);
    ck_assert_msg(second - first == sizeof(ball), "one ball more takes %zu bytes more, and a ball has %zu",
                  second - first, sizeof(ball));
}
END_TEST

START_TEST(sum_is_that_of_the_field)
{
    // FNV-1a of the letters "foobar" is known.
    // Rejects: the product before the exclusive or.
    unsigned char word[6];
    archive f = { .bytes = word, .size = 6, .sum = 14695981039346656037ULL };
    char letters[] = "foobar";
    saved_bytes(&f, letters, 6);
    ck_assert_msg(f.sum == 0x85944171f73967e8ULL, "the sum of foobar is %llx", f.sum);
    saved_bytes(&f, letters, 1);
    ck_assert_msg(f.failed && f.at == 6, "a byte more does not fit");
    saved_bytes(&f, letters, 0);
    ck_assert_msg(f.failed, "what has failed once has failed for good");
}
END_TEST

START_TEST(file_that_is_cut_is_refused)
{
    // Rejects: bytes beyond the end, a world that is half loaded.
    small_world w = some(3), kept = some(5);
    size_t size = save(&w);
    for (size_t cut = 0; cut < size; cut++) ck_assert_msg(!load(&kept, cut), "%zu bytes of %zu are taken for a world", cut, size);
    ck_assert_msg(!load(&kept, size + 1), "a file that goes on behind its end is taken for a world");
}
END_TEST

START_TEST(file_with_a_bit_turned_is_refused)
{
    // Rejects: no sum, a sum that leaves some bytes out, a count that is believed.
    small_world w = some(3), kept = some(5);
    size_t size = save(&w);
    for (size_t bit = 0; bit < 8 * size; bit++) {
        bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
        ck_assert_msg(!load(&kept, size), "bit %zu is turned, and it is taken for a world", bit);
        bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
    }
    ck_assert_msg(load(&kept, size), "all bits are back, and it is refused");
}
END_TEST

START_TEST(world_that_does_not_fit_is_not_saved)
{
    small_world w = some(3);
    size_t size = save(&w);
    for (size_t room = 0; room < size; room++) {
        unsigned char *exact = malloc(room + (room == 0));
        ck_assert_ptr_nonnull(exact);
        size_t said = world_save(&w, exact, room);
        free(exact);
        ck_assert_msg(said == 0, "%zu bytes are room for a world of %zu", room, size);
    }
}
END_TEST

START_TEST(wild_counts_and_other_versions_are_refused)
{
    // With a right sum, so that only the count, or the version, is wrong.
    // Rejects: a count that is used before it is looked at.
    small_world kept = some(5);
    const int wild[4] = { -1, BALLS + 1, 1 << 30, 3 };
    for (int i = 0; i < 4; i++) {
        int version = i == 3 ? SAVED_VERSION + 1 : SAVED_VERSION, count = wild[i];
        small_world w = some(3);
        archive f = { .bytes = bytes, .size = ROOM, .sum = 14695981039346656037ULL };
        saved_bytes(&f, &version, sizeof version);
        saved_bytes(&f, &w.gravity, sizeof w.gravity);
        saved_bytes(&f, &w.time, sizeof w.time);
        saved_bytes(&f, &count, sizeof count);
        for (int k = 0; k < (count == BALLS + 1 ? count : 3); k++) saved_bytes(&f, &w.balls[0], sizeof w.balls[0]);
        unsigned long long sum = f.sum;
        saved_bytes(&f, &sum, sizeof sum);
        ck_assert_msg(!load(&kept, f.at), i == 3 ? "another version is taken for ours" : "a count of %d is believed", count);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        world_comes_back_to_the_bit,
        balls_that_are_not_there_take_no_bytes,
        sum_is_that_of_the_field,
        file_that_is_cut_is_refused,
        file_with_a_bit_turned_is_refused,
        world_that_does_not_fit_is_not_saved,
        wild_counts_and_other_versions_are_refused,
        NULL
    };
    return suite_run((suite){ .name = "saved", .tests = tests });
}
