// check_books.c - do the books balance, over whole frames?
// Book: chapter 18.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "ledger.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

// Of what the largest account holds: sums over hundreds of substeps.
#define BOOKS 1e-11
// Of the energy that a slide has: how long a block takes to settle into its
// contacts counts, too.
#define SLIDING 0.01

static shape box, heavy, low, ball, cloth, rope;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 8).ok);
    ck_assert(shape_box(&heavy, vec3_make(1, 1, 1), 8000).ok);
    ck_assert(shape_box(&low, vec3_make(2, 0.5, 1), 4).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 3).ok);
    ck_assert(shape_cloth(&cloth, 12, 12, 2, 2, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 8, 1, 0.5).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&heavy);
    shape_free(&low);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&rope);
}

static void begin_booked(bool is_booked)
{
    world_options o = world_options_default();
    o.ledger = is_booked;
    begin(o);
}

static ledger_entry sum_of_books(void)
{
    ledger_entry sum = { 0, ZERO, ZERO };
    for (int k = 0; k < LEDGERS; k++) {
        sum.energy += w.ledger[k].energy;
        sum.momentum = vec3_add(sum.momentum, w.ledger[k].momentum);
        sum.angular = vec3_add(sum.angular, w.ledger[k].angular);
    }
    return sum;
}

// Do all accounts together say what has changed since `was`?
static void books_balance(ledger_entry was, real error)
{
    ledger_entry now = ledger_total(&w), sum = sum_of_books();
    near(sum.energy, now.energy - was.energy, error);
    near_vec3(sum.momentum, vec3_sub(now.momentum, was.momentum), error);
    near_vec3(sum.angular, vec3_sub(now.angular, was.angular), error);
}

// J, the largest account.
static real largest_account(void)
{
    real most = 0;
    for (int k = 0; k < LEDGERS; k++)
        most = fmax(most, fabs(w.ledger[k].energy));
    return most;
}

static void fill_corner(void)
{
    for (int b = 0; b < 10; b++)
        add_thrown(b % 2 ? &ball : &box,
                   vec3_make(1.3 * (b % 2), 0.8 + 1.2 * (b / 4),
                             1.3 * (b / 2 % 2)),
                   vec3_make(b % 3, 0, 1 - b % 2), vec3_make(1, b, 0));
    ck_assert(world_add_plane(&w, vec3_make(1, 0, 0), -0.8).ok);
    ck_assert(world_add_plane(&w, vec3_make(-1, 0, 0), -2.4).ok);
}

static void fill_with_cloth(void)
{
    add_nailed(&box, 0, 0.5, 0);
    add_at(&cloth, 0.1, 1.2, 0.2);
    add_at(&rope, 0, 2, 0);
    add_at(&ball, 0.2, 3, 0.1);
}

// Heavy on light: substeps of other lengths.
static void fill_with_load(void)
{
    add_at(&box, 0, 0.5, 0);
    add_at(&heavy, 0.1, 1.6, 0);
}

// Rejects: a phase that is not booked, or is booked twice; a ledger that loses
// what sleeps; gravity that gives energy in substeps of changing length.
START_TEST(books_balance_whatever_happens)
{
    for (int k = 0; k < 5; k++) {
        world_options o = world_options_default();
        o.ledger = true;
        o.restitution = k % 2 ? 0.5 : 0;
        begin(o);
        if (k < 2)      fill_corner();
        else if (k < 4) fill_with_cloth();
        else            fill_with_load();
        add_floor();
        ledger_entry was = ledger_total(&w);
        real most = fabs(was.energy);
        int substeps = 0;
        for (int f = 0; f < 300; f++) {
            world_step(&w);
            most = fmax(most, largest_account());
            substeps = int_max(substeps, w.report.substeps);
        }
        ck_assert(most > 1);
        if (k == 4) ck_assert_int_gt(substeps, 2 * w.options.substeps);
        books_balance(was, BOOKS * most);
        // Sticks hold to 1e-9 when a frame begins.
        near(w.ledger[LEDGER_INTEGRATE].energy, 0, 1e-8 * most);
    }
}
END_TEST

// What wakes has again what it had: the books go on.
// Rejects: an account that is opened after a body has woken.
START_TEST(books_balance_while_bodies_fall_asleep_and_wake)
{
    begin_booked(true);
    add_at(&box, 0, 0.5, 0);
    add_floor();
    add_thrown(&ball, vec3_make(0, 40, 0), ZERO, ZERO);
    ledger_entry was = ledger_total(&w);
    bool slept = false, woke = false;
    for (int f = 0; f < 400; f++) {
        world_step(&w);
        slept |= probe_sleeps(&w, 0);
        woke |= slept && !probe_sleeps(&w, 0);
        books_balance(was, BOOKS * 2000);
    }
    ck_assert(slept && woke);
    near(w.ledger[LEDGER_SLEEP].energy, 0, 1e-2);
}
END_TEST

// Rejects: a ledger that moves what it counts, or that counts unasked.
START_TEST(ledger_changes_no_bit)
{
    static particle was[200];
    for (int k = 0; k < 2; k++) {
        begin_booked(k);
        add_nailed(&low, 0, 0.25, 0);
        add_at(&box, 0.1, 1.2, 0);
        add_at(&ball, 0.3, 2.4, 0.1);
        add_at(&cloth, 0, 3.2, 0);
        add_floor();
        for (int f = 0; f < 90; f++) world_step(&w);
        ck_assert_int_le(w.pool.count, 200);
        size_t size = (size_t)w.pool.count * sizeof *was;
        if (k == 0) memcpy(was, w.pool.at, size);
        ck_assert(memcmp(was, w.pool.at, size) == 0);
        for (int i = 0; i < LEDGER_SLEEP; i++)
            ck_assert_int_eq(w.ledger[i].energy != 0, k == 1);
    }
}
END_TEST

// A slab of 4 kg slides at 3 m/s over a floor of friction 0.5: v^2 / 2 mu g,
// and 18 J.
// Rejects: the work of friction booked elsewhere than under contacts, or with
// the wrong sign.
START_TEST(contacts_take_what_a_sliding_block_loses)
{
    begin_booked(true);
    add_thrown(&low, vec3_make(0, 0.25, 0), vec3_make(3, 0, 0), ZERO);
    add_floor();
    real from = vertex_of(0, 0).x;
    for (int f = 0; f < 60; f++) world_step(&w);
    real way = vertex_of(0, 0).x - from;
    near(way, 9 / (2 * 0.5 * 9.81), SLIDING);
    near(w.ledger[LEDGER_CONTACTS].energy, -18, SLIDING * 18);
    near(w.ledger[LEDGER_CONTACTS].momentum.x, -12, 1e-9);
}
END_TEST

// A ball lies in a cloth that hangs by its corners: nothing but the sticks and
// contacts carries it, and what the cloth does to it, it does to the cloth.
// Rejects: an impulse that one of the two does not feel.
START_TEST(cloth_and_ball_keep_their_momentum_in_flight)
{
    world_options o = world_options_default();
    o.ledger = true;
    o.gravity = ZERO;
    begin(o);
    add_at(&cloth, 0, 0, 0);
    add_thrown(&ball, vec3_make(0.1, 1, 0.05), vec3_make(0, -6, 0),
               vec3_make(3, 1, 2));
    int touching = 0;
    for (int f = 0; f < 60; f++) {
        world_step(&w);
        touching += w.report.touching;
    }
    ck_assert_int_gt(touching, 50);
    near_vec3(ledger_total(&w).momentum, vec3_make(0, -18, 0), 1e-10);
    for (int k = 0; k < LEDGERS; k++)
        near_vec3(w.ledger[k].momentum, ZERO, 1e-10);
    ck_assert(w.ledger[LEDGER_CONTACTS].energy < -1);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        books_balance_whatever_happens,
        books_balance_while_bodies_fall_asleep_and_wake,
        ledger_changes_no_bit,
        contacts_take_what_a_sliding_block_loses,
        cloth_and_ball_keep_their_momentum_in_flight,
        NULL
    };
    return suite_run((suite){
        .name = "books", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 30
    });
}
