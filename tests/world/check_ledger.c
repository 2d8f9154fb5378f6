// check_ledger.c - do the books say what gave and what took?  Book: chapter 18.
//
// Whether they balance over whole frames is asked in check_books.c.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "ledger.h"
#include "probe.h"
#include "shake.h"
#include "suite.h"

// Sums over a few dozen particles, of numbers up to a thousand.
#define ROUNDING 1e-11
// J of some hundred: a substep a hundred times shorter makes a hundred times as
// much of the rounding of a place.
#define CHANGING 1e-8

static const vec3 ZERO = { 0, 0, 0 };

static world w;
static shape box, ball, rope;

static world_options booked(void)
{
    world_options o = world_options_default();
    o.ledger = true;
    return o;
}

static void begin(world_options o)
{
    world_free(&w);
    ck_assert(world_init(&w, o).ok);
}

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 2, 3), 6).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 2).ok);
    ck_assert(shape_rope(&rope, 1, 2, 3).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&ball);
    shape_free(&rope);
}

static placement thrown(vec3 at, vec3 velocity, vec3 spin)
{
    placement p = placement_at(at);
    p.velocity = velocity;
    p.spin = spin;
    return p;
}

static void add(const shape *s, placement where)
{
    ck_assert(world_add(&w, s, where, NULL).ok);
}

// J/kg, what a particle under gravity has above the middle of its two places,
// which lies (g h^2)/8 under the parabola of its fall.
static real above_middle(void)
{
    return 9.81 * 9.81 * w.age * w.age / 8;
}

// Two particles of 1.5 kg: what each has, half a substep ago.
// Rejects: velocities over a frame; a lever arm or a height of another moment;
// a mass that is not there, or that of the wrong particle.
START_TEST(total_is_the_sum_over_particles)
{
    begin(booked());
    // Two bodies, so that a particle that is counted twice shows.
    add(&rope, placement_at(ZERO));
    add(&rope, placement_at(ZERO));
    real h = 0.01;
    probe_set_age(&w, h);
    const vec3 x[4] = { { 1, 2, 3 }, { -4, 5, 6 }, { 7, 1, -2 }, { 0, 3, 1 } };
    const vec3 v[4] = { { 0.5, -1, 2 }, { 3, 1, -2 }, { 1, 1, 0 }, { 0, -2, 4 } };
    vec3 linear = ZERO, angular = ZERO;
    real energy = 0;
    for (int i = 0; i < 4; i++) {
        w.pool.at[i].position = vec3_add_scaled(x[i], h / 2, v[i]);
        w.pool.at[i].previous = vec3_add_scaled(x[i], -h / 2, v[i]);
        linear = vec3_add_scaled(linear, 1.5, v[i]);
        angular = vec3_add_scaled(angular, 1.5, vec3_cross(x[i], v[i]));
        energy += 1.5 * (vec3_length_squared(v[i]) / 2 + 9.81 * x[i].y
                         + above_middle());
    }
    ledger_entry sum = ledger_total(&w);
    near(sum.energy, energy, ROUNDING);
    near_vec3(sum.momentum, linear, ROUNDING);
    near_vec3(sum.angular, angular, ROUNDING);
}
END_TEST

// Rejects: a sleeper that takes its height out of the books; static bodies, or
// pins, that have weight; a sleeper that has energy for lying between two
// places.
START_TEST(total_counts_sleepers_and_nothing_static)
{
    begin(booked());
    placement fixed = placement_at(vec3_make(0, 9, 0));
    fixed.is_static = 1;
    add(&box, fixed);
    add(&ball, placement_at(vec3_make(0, 5, 0)));
    add(&rope, placement_at(vec3_make(0, 3, 0)));
    world_pin(&w, 2, 1);
    for (int i = 0; i < w.pool.count; i++)
        w.pool.at[i].previous = w.pool.at[i].position;
    real wanted = 9.81 * (2 * 5 + 1.5 * 3) + 3.5 * above_middle();
    near(ledger_total(&w).energy, wanted, ROUNDING);
    // Asleep, it is pinned for the time being.
    for (int i = 0; i < body_particles(&w.body[1]); i++)
        w.pool.at[w.body[1].first + i].inverse_mass = 0;
    probe_lay(&w, 1);
    near(ledger_total(&w).energy, wanted - 2 * above_middle(), ROUNDING);
}
END_TEST

// Verlet under gravity keeps the energy of this moment to the last digit, and
// gives M g h of momentum, and the torque of the weights where they stand.
// Rejects: a height of the substep's end, which would find an energy of order
// h; gravity that is booked elsewhere.
START_TEST(free_fall_books_no_energy_and_gravitys_momentum)
{
    begin(booked());
    add(&box, thrown(vec3_make(1, 2, 3), vec3_make(4, 5, -6),
                     vec3_make(1, -2, 3)));
    add(&ball, thrown(vec3_make(-3, 2, 1), vec3_make(0, 9, 1),
                      vec3_make(-5, 0, 2)));
    add(&rope, thrown(vec3_make(0, 7, 0), vec3_make(2, 0, 0), ZERO));
    real h = w.age, mass = 6 + 2 + 3;
    vec3 torque = ZERO;
    ledger_open(&w);
    enum { STEPS = 300 };
    for (int n = 0; n < STEPS; n++) {
        for (int i = 0; i < w.pool.count; i++)
            torque = vec3_add_scaled(torque, h / w.pool.at[i].inverse_mass,
                                     vec3_cross(w.pool.at[i].position,
                                                w.options.gravity));
        verlet_step(w.pool.at, w.pool.count, w.options.gravity, NULL, h);
        ledger_book(&w, LEDGER_INTEGRATE);
    }
    const ledger_entry *booked = &w.ledger[LEDGER_INTEGRATE];
    near(booked->energy, 0, 100 * ROUNDING);
    near_vec3(booked->momentum, vec3_scale(mass * h * STEPS, w.options.gravity),
              100 * ROUNDING);
    near_vec3(booked->angular, torque, 1000 * ROUNDING);
    for (int k = 1; k < LEDGERS; k++)
        ck_assert(w.ledger[k].energy == 0
                  && vec3_length(w.ledger[k].momentum) == 0);
}
END_TEST

// Verlet's step if the last one took before and this one takes dt.
static void step_changed(particle *p, int n, vec3 a, real before, real dt)
{
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position, last = vec3_sub(here, p[i].previous);
        vec3 move = vec3_add_scaled(vec3_scale(dt / before, last),
                                    dt * (before + dt) / 2, a);
        p[i].position = vec3_add(here, move);
        p[i].previous = here;
    }
}

// Rejects: a height under the parabola, which depends on the substep: every
// change of it would give or take (g h)^2/8 a kilogram.
START_TEST(fall_in_substeps_of_changing_length_books_no_energy)
{
    const real share[] = { 1, 0.5, 3, 0.01, 10, 1 };
    begin(booked());
    add(&box, thrown(vec3_make(1, 2, 3), vec3_make(4, 5, -6), ZERO));
    add(&rope, thrown(vec3_make(0, 7, 0), vec3_make(2, 0, 0), ZERO));
    real h = w.age;
    ledger_open(&w);
    for (int n = 0; n < 60; n++) {
        real next = h * share[n % 6];
        step_changed(w.pool.at, w.pool.count, w.options.gravity, w.age, next);
        probe_set_age(&w, next);
        ledger_book(&w, LEDGER_INTEGRATE);
        near(w.ledger[LEDGER_INTEGRATE].energy, 0, CHANGING);
    }
}
END_TEST

static void add_some(void)
{
    add(&box, thrown(vec3_make(1, 2, 3), vec3_make(4, 5, -6),
                     vec3_make(1, -2, 3)));
    add(&ball, thrown(vec3_make(-3, 2, 1), vec3_make(0, 9, 1),
                      vec3_make(-5, 0, 2)));
    add(&rope, thrown(vec3_make(0, 7, 0), vec3_make(2, 0, 0), ZERO));
}

// Rejects: a frame that begins with another sum than the last one ended with; a
// spin without energy or angular momentum; a moment that is not the middle of
// the last move.
START_TEST(bodies_have_in_a_frame_what_their_particles_have)
{
    begin(booked());
    add_some();
    ledger_entry was = ledger_total(&w);
    probe_look(&w);
    for (int i = 0; i < 8; i++) w.pool.at[i].position = ZERO;
    probe_set_halfway(&w, -w.age / 2);
    ledger_entry now = ledger_total(&w);
    near(now.energy, was.energy, ROUNDING);
    near_vec3(now.momentum, was.momentum, ROUNDING);
    near_vec3(now.angular, was.angular, ROUNDING);
    ck_assert(vec3_length(was.angular) > 10);
}
END_TEST

// A frame of substeps of another length than the last frame's: first velocity,
// then place.
// Rejects: a height of another moment; a length of the substep that is not the
// new one; a move that is booked apart from the velocity that makes it.
START_TEST(fall_within_a_frame_books_no_energy)
{
    const real share[] = { 1, 0.5, 3, 0.01, 10 };
    for (int n = 0; n < 5; n++) {
        begin(booked());
        add_some();
        ledger_open(&w);
        probe_look(&w);
        real h = share[n] * w.age;
        vec3 g = w.options.gravity;
        for (int k = 0; k < 20; k++) {
            real seconds = k == 0 ? (w.age + h) / 2 : h;
            for (int b = 0; b < 2; b++)
                probe_velocity(&w, b)->of[1] += seconds * g.y;
            probe_set_halfway(&w, h / 2);
            ledger_book(&w, LEDGER_INTEGRATE);
            near(w.ledger[LEDGER_INTEGRATE].energy, 0, CHANGING);
            for (int b = 0; b < 2; b++) {
                const real *u = probe_velocity(&w, b)->of;
                real *d = probe_move(&w, b)->of;
                for (int i = 0; i < MOTIONS; i++) d[i] += h * u[i];
            }
            probe_set_halfway(&w, -h / 2);
            ledger_book(&w, LEDGER_CONTACTS);
            near(w.ledger[LEDGER_CONTACTS].energy, 0, CHANGING);
        }
        real fell = (w.age - h) / 2 + 20 * h;
        near_vec3(w.ledger[LEDGER_INTEGRATE].momentum, vec3_scale(8 * fell, g),
                  100 * ROUNDING);
        // Its moves have taken nothing of the angular momentum.
        near_vec3(w.ledger[LEDGER_CONTACTS].angular, ZERO, 100 * ROUNDING);
    }
}
END_TEST

// An impulse of P at x gives the energy P . v and P^2 K / 2, the momentum P,
// the angular momentum x x P; a weightless body has no other.
START_TEST(impulses_within_a_frame_are_booked)
{
    const vec3 impulse = { 3, -1, 2 }, arm = { 0.5, 1, -1.5 };
    world_options o = booked();
    o.gravity = ZERO;
    begin(o);
    add_some();
    ledger_open(&w);
    probe_look(&w);
    probe_set_halfway(&w, w.age / 2);
    motion *u = probe_velocity(&w, 0);
    const motion_basis *basis = &probe_start(&w, 0)->basis;
    vec3 before = motion_at(basis, u, arm);
    motion_push(u, basis, arm, impulse);
    vec3 after = motion_at(basis, u, arm);
    ledger_book(&w, LEDGER_CONTACTS);
    const ledger_entry *e = &w.ledger[LEDGER_CONTACTS];
    near(e->energy, vec3_dot(impulse, vec3_add(before, after)) / 2,
              ROUNDING);
    near_vec3(e->momentum, impulse, ROUNDING);
    vec3 at = vec3_add(probe_start(&w, 0)->frame.center, arm);
    near_vec3(e->angular, vec3_cross(at, impulse), ROUNDING);
}
END_TEST

// Sticks along the old places are forces between pairs: they book no momentum
// and no angular momentum, but what energy they take.
START_TEST(relaxing_books_energy_alone)
{
    begin(booked());
    add(&box, thrown(ZERO, vec3_make(1, 2, 3), vec3_make(9, -20, 15)));
    real h = w.age;
    for (int n = 0; n < 60; n++) {
        verlet_step(w.pool.at, w.pool.count, w.options.gravity, NULL, h);
        ledger_open(&w);
        shake(w.body[0].rigid, w.pool.at, 6, w.options.relax);
        ledger_book(&w, LEDGER_STICKS);
    }
    ck_assert(w.ledger[LEDGER_STICKS].energy != 0);
    near_vec3(w.ledger[LEDGER_STICKS].momentum, ZERO, 100 * ROUNDING);
    near_vec3(w.ledger[LEDGER_STICKS].angular, ZERO, 100 * ROUNDING);
}
END_TEST

static void push_up(real by)
{
    for (int i = 0; i < w.pool.count; i++) w.pool.at[i].position.y += by;
}

// Rejects: an entry in place of a sum; one under the wrong name; what was done
// between two steps blamed on the first entry.
START_TEST(books_add_up_under_their_names)
{
    begin(booked());
    add(&ball, placement_at(ZERO));
    ledger_open(&w);
    ledger_entry a = ledger_total(&w);
    push_up(0.01);
    ledger_book(&w, LEDGER_CONTACTS);
    ledger_entry b = ledger_total(&w);
    push_up(-0.03);
    ledger_book(&w, LEDGER_STICKS);
    ledger_entry c = ledger_total(&w);
    push_up(0.005);
    ledger_book(&w, LEDGER_CONTACTS);
    ledger_entry d = ledger_total(&w);
    near(w.ledger[LEDGER_CONTACTS].energy,
              b.energy - a.energy + d.energy - c.energy, ROUNDING);
    near(w.ledger[LEDGER_STICKS].energy, c.energy - b.energy, ROUNDING);
    near_vec3(w.ledger[LEDGER_STICKS].momentum,
              vec3_sub(c.momentum, b.momentum), ROUNDING);
    push_up(7);
    ledger_open(&w);
    ledger_book(&w, LEDGER_SLEEP);
    ck_assert(w.ledger[LEDGER_SLEEP].energy == 0);
    ck_assert(w.ledger[LEDGER_INTEGRATE].energy == 0);
}
END_TEST

// Rejects: a ledger that counts unasked.
START_TEST(ledger_that_is_off_holds_nothing)
{
    static const ledger_entry none[LEDGERS];
    for (int on = 0; on < 2; on++) {
        world_options o = booked();
        o.ledger = on;
        begin(o);
        add(&ball, placement_at(ZERO));
        ledger_open(&w);
        push_up(0.01);
        for (int k = 0; k < LEDGERS; k++) {
            ledger_book(&w, k);
            push_up(0.02);
        }
        ck_assert_int_eq(memcmp(w.ledger, none, sizeof none) == 0, !on);
        ck_assert_int_eq(w.ledger_now.energy == 0, !on);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        total_is_the_sum_over_particles,
        relaxing_books_energy_alone,
        total_counts_sleepers_and_nothing_static,
        bodies_have_in_a_frame_what_their_particles_have,
        fall_within_a_frame_books_no_energy,
        impulses_within_a_frame_are_booked,
        free_fall_books_no_energy_and_gravitys_momentum,
        fall_in_substeps_of_changing_length_books_no_energy,
        books_add_up_under_their_names,
        ledger_that_is_off_holds_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "ledger", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
