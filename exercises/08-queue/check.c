// check.c - tests of the exercise 08/queue.

#include "queue.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

enum { PLENTY = 100000 };

static stick between(int a, int b)
{
    return (stick){ a, b, 1, 1, STICK_EXACT };
}

static particle at(real x, real y, real w)
{
    return (particle){ { x, y, 0 }, { x, y, 0 }, w };
}

// Which sticks has each particle?
static stick_lists own_sticks(const stick *s, int n, int particles)
{
    stick_lists l = { .particles = particles };
    l.start = malloc(((size_t)particles + 1) * sizeof *l.start);
    l.stick = malloc((2 * (size_t)n + 1) * sizeof *l.stick);
    ck_assert(l.start && l.stick);
    int total = 0;
    for (int v = 0; v < particles; v++) {
        l.start[v] = total;
        for (int k = 0; k < n; k++)
            if (s[k].a == v || s[k].b == v) l.stick[total++] = k;
    }
    l.start[particles] = total;
    return l;
}

// Asks with memory that ends behind the last place, and holds rubbish.
static queue_result ask(const stick *s, int n, particle *p, int particles,
                        int from, real tolerance, int budget)
{
    stick_lists l = own_sticks(s, n, particles);
    int *line = malloc((size_t)n * sizeof *line);
    char *waits = malloc((size_t)n);
    ck_assert(line && waits);
    memset(line, 0x77, (size_t)n * sizeof *line);
    memset(waits, 0x77, (size_t)n);
    queue_result r = queue_relax(s, n, p, &l, from, tolerance, budget, line,
                                 waits);
    free(line);
    free(waits);
    stick_lists_free(&l);
    return r;
}

// The same without a ring: a list that is as long as it gets.
static queue_result slowly(const stick *s, int n, particle *p, int from,
                           real tolerance, int budget)
{
    static int list[PLENTY];
    int begin = 0, end = 0;
    queue_result r = { 0, 0 };
    for (int k = 0; k < n; k++)
        if (s[k].a == from || s[k].b == from) list[end++] = k;
    while (begin < end && r.relaxed < budget) {
        int now = list[begin++];
        r.tested++;
        if (!(stick_strain(s[now], p) > tolerance)) continue;
        if (!stick_relax(s[now], p, relax_options_pbd()).moved) continue;
        r.relaxed++;
        for (int side = 0; side < 2; side++) {
            int v = side ? s[now].b : s[now].a;
            for (int k = 0; k < n; k++) {
                if (k == now || (s[k].a != v && s[k].b != v)) continue;
                int there = 0;
                for (int i = begin; i < end; i++) there |= list[i] == k;
                if (!there && end < PLENTY) list[end++] = k;
            }
        }
    }
    return r;
}

static void expect(queue_result r, int relaxed, int tested)
{
    ck_assert_msg(r.relaxed == relaxed, "relaxed %d sticks, wanted %d",
                  r.relaxed, relaxed);
    ck_assert_msg(r.tested == tested, "looked at %d sticks, wanted %d",
                  r.tested, tested);
}

enum { ROPE = 8 };

static void rope(stick *s, particle *p)
{
    for (int k = 0; k < ROPE; k++) s[k] = between(k, k + 1);
    for (int i = 0; i <= ROPE; i++) p[i] = at(i, 0, 1);
}

START_TEST(blow_travels_along_a_rope)
{
    // The end is pulled by one stick's length, and pinned there.  Each stick
    // passes half of its error on, and the blow arrives at the other end.
    // Rejects: neighbours of one end alone, marks that were there before, a
    // mark that stays when its stick has left the line.
    stick s[ROPE];
    particle p[ROPE + 1];
    rope(s, p);
    p[0] = at(-1, 0, 0);
    queue_result r = ask(s, ROPE, p, ROPE + 1, 0, 1e-9, PLENTY);
    for (int i = 0; i <= ROPE; i++)
        ck_assert_msg(fabs(p[i].position.x - (i - 1)) < 1e-6, "particle %d "
                      "is at x = %g, wanted %d", i, p[i].position.x, i - 1);
    ck_assert_msg(r.relaxed < PLENTY, "it took %d relaxations", r.relaxed);
}
END_TEST

START_TEST(stick_within_tolerance_is_left)
{
    // Off by 1 %, which is allowed.  One look, nothing moved, none sent.
    stick s[ROPE];
    particle p[ROPE + 1];
    rope(s, p);
    p[0].position.x = -0.01;
    expect(ask(s, ROPE, p, ROPE + 1, 0, 0.02, PLENTY), 0, 1);
    ck_assert_msg(p[0].position.x == -0.01, "it was moved to x = %g",
                  p[0].position.x);
}
END_TEST

START_TEST(first_come_is_first_served)
{
    // The middle of a cross is struck.  With a budget of one, only the stick
    // that stands first in its list is mended.
    const stick s[4] = { between(0, 1), between(0, 2), between(0, 3),
                         between(0, 4) };
    particle p[5] = { at(0, 0, 0), at(1.5, 0, 1), at(0, 1.5, 1),
                      at(-1.5, 0, 1), at(0, -1.5, 1) };
    ask(s, 4, p, 5, 0, 0.01, 1);
    ck_assert_msg(p[1].position.x == 1, "stick 0 stands first in line, and its "
                  "end is at x = %g, wanted 1", p[1].position.x);
    ck_assert_msg(p[4].position.y == -1.5, "stick 3 stands last in line, and "
                  "was relaxed first");
}
END_TEST

START_TEST(neighbours_send_each_other_back)
{
    // Two sticks pull at the particle between them: each has to go again when
    // the other has.  The sum of the errors, 1, is shared between them and the
    // free end in the end.
    const stick s[2] = { between(0, 1), between(1, 2) };
    particle p[3] = { at(0, 0, 0), at(2, 0, 1), at(3, 0, 1) };
    queue_result r = ask(s, 2, p, 3, 0, 1e-9, PLENTY);
    ck_assert_msg(fabs(p[2].position.x - 2) < 1e-6, "the free end is at x = "
                  "%g, wanted 2, after %d relaxations", p[2].position.x,
                  r.relaxed);
}
END_TEST

START_TEST(line_is_full_and_goes_round)
{
    // A star: every stick waits at once, and every stick that moves sends all
    // the others.  Rejects: writing behind the ring, waiting twice.
    enum { RAYS = 6 };
    stick s[RAYS];
    particle p[RAYS + 1] = { at(0.4, 0.3, 1) }, q[RAYS + 1];
    for (int k = 0; k < RAYS; k++) {
        s[k] = between(k + 1, 0);
        p[k + 1] = at(k - 2.5, k % 2 ? 1 : -1, 1);
    }
    memcpy(q, p, sizeof p);
    queue_result r = ask(s, RAYS, p, RAYS + 1, 0, 1e-6, 1000);
    queue_result w = slowly(s, RAYS, q, 0, 1e-6, 1000);
    expect(r, w.relaxed, w.tested);
    ck_assert_msg(memcmp(p, q, sizeof p) == 0, "some particle is elsewhere "
                  "than a plain list has it");
}
END_TEST

START_TEST(every_look_is_counted)
{
    // A single stick: looked at once, relaxed once, and done.
    // Rejects: a stick that sends itself.
    const stick s[1] = { between(0, 1) };
    particle p[2] = { at(0, 0, 1), at(3, 0, 1) };
    expect(ask(s, 1, p, 2, 1, 1e-9, PLENTY), 1, 1);
}
END_TEST

START_TEST(stick_between_pins_sends_none)
{
    // Looked at, and not mended; its neighbour beyond is off, too, but none
    // has come to tell.
    const stick s[2] = { between(0, 1), between(1, 2) };
    particle p[3] = { at(0, 0, 0), at(1.5, 0, 0), at(3, 0, 1) };
    expect(ask(s, 2, p, 3, 0, 1e-3, PLENTY), 0, 1);
}
END_TEST

START_TEST(particle_without_sticks_has_no_work)
{
    const stick s[1] = { between(0, 1) };
    particle p[3] = { at(0, 0, 1), at(2, 0, 1), at(5, 0, 1) };
    expect(ask(s, 1, p, 3, 2, 1e-3, PLENTY), 0, 0);
}
END_TEST

START_TEST(budget_counts_relaxations)
{
    // Stick 0 has its length; the look at it is free.  Stick 1 uses up the
    // budget, and stick 2 is left as it is.
    const stick s[3] = { between(0, 1), between(0, 2), between(0, 3) };
    particle p[4] = { at(0, 0, 0), at(1, 0, 1), at(0, 1.5, 1), at(-1.5, 0, 1) };
    expect(ask(s, 3, p, 4, 0, 1e-3, 1), 1, 2);
    ck_assert_msg(p[2].position.y == 1, "the end of stick 1 is at y = %g, "
                  "wanted 1", p[2].position.y);
    ck_assert_msg(p[3].position.x == -1.5, "stick 2 was relaxed, beyond the "
                  "budget");
}
END_TEST

START_TEST(budget_ends_what_cannot_converge)
{
    // Two sticks of 1 m, and two pins 3 m apart.
    const stick s[2] = { between(0, 1), between(1, 2) };
    particle p[3] = { at(0, 0, 0), at(1, 0, 1), at(3, 0, 0) };
    expect(ask(s, 2, p, 3, 1, 1e-3, 51), 51, 52);
}
END_TEST

START_TEST(same_bits_as_a_plain_list)
{
    // A square net with diagonals; every particle in turn is struck.
    enum { SIDE = 4, ALL = SIDE * SIDE };
    stick s[4 * ALL];
    int n = 0;
    for (int i = 0; i < ALL; i++)
        for (int j = i + 1; j < ALL; j++) {
            int dx = j % SIDE - i % SIDE, dy = j / SIDE - i / SIDE;
            if (dx * dx > 1 || dy > 1) continue;
            s[n++] = (stick){ i, j, sqrt(dx * dx + dy * dy), 1, STICK_EXACT };
        }
    for (int v = 0; v < ALL; v++) {
        particle p[ALL], q[ALL];
        for (int i = 0; i < ALL; i++) p[i] = at(i % SIDE, i / SIDE, 1 + i % 3);
        p[v].position = (vec3){ v % SIDE + 0.3, v / SIDE - 0.2, 0.25 };
        memcpy(q, p, sizeof p);
        queue_result r = ask(s, n, p, ALL, v, 1e-3, PLENTY);
        queue_result w = slowly(s, n, q, v, 1e-3, PLENTY);
        expect(r, w.relaxed, w.tested);
        ck_assert_msg(memcmp(p, q, sizeof p) == 0, "particle %d struck: the "
                      "bits differ from those of a plain list", v);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        blow_travels_along_a_rope,
        stick_within_tolerance_is_left,
        first_come_is_first_served,
        neighbours_send_each_other_back,
        line_is_full_and_goes_round,
        every_look_is_counted,
        stick_between_pins_sends_none,
        particle_without_sticks_has_no_work,
        budget_counts_relaxations,
        budget_ends_what_cannot_converge,
        same_bits_as_a_plain_list,
        NULL
    };
    return suite_run((suite){ .name = "queue", .tests = tests });
}
