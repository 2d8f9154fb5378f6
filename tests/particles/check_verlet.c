// check_verlet.c - tests of chapter 1.  Each names the mistake it rejects.

#include "scarce.h"
#include "expect.h"
#include "suite.h"
#include "verlet.h"

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

// Room for the rounding of some thousand sums near 1, each 1.1e-16.
static const real ROUNDING = 1e-12;
// A measured order may miss the whole number by the next term of the series.
static const real ORDER_SLACK = 0.05;

static const real PI = 3.14159265358979323846;
static const vec3 NO_GRAVITY = { 0, 0, 0 };
static const vec3 GRAVITY = { 0, -9.81, 0 };

// ---- The pool

START_TEST(pool_keeps_what_is_added)
{
    // Rejects: a reserve that loses the old particles, or shrinks.
    particle_pool pool;
    pool_init(&pool);
    for (int i = 0; i < 100; i++) {
        if (pool.count == pool.capacity)
            ck_assert(pool_reserve(&pool, 2 * pool.capacity + 1).ok);
        particle p = { { i, 0, 0 }, { 0, i, 0 }, 1 };
        ck_assert_int_eq(pool_add(&pool, p), i);
    }
    int room = pool.capacity;
    ck_assert(pool_reserve(&pool, 3).ok);
    ck_assert_int_eq(pool.capacity, room);
    for (int i = 0; i < 100; i++) {
        near_vec3(pool.at[i].position, (vec3){ i, 0, 0 }, 0);
        near_vec3(pool.at[i].previous, (vec3){ 0, i, 0 }, 0);
    }
    pool_free(&pool);
    ck_assert(pool.at == NULL && pool.count == 0 && pool.capacity == 0);
    pool_free(&pool);
}
END_TEST

START_TEST(empty_pool_owns_nothing)
{
    particle_pool pool;
    pool_init(&pool);
    ck_assert(pool_reserve(&pool, 0).ok);
    ck_assert(pool.at == NULL);
    pool_free(&pool);
}
END_TEST

START_TEST(pool_too_large_to_number_is_refused)
{
    // Rejects: a product of sizes that overflows, where a size has 32 bits.
    particle_pool pool;
    pool_init(&pool);
    ck_assert(pool_reserve(&pool, 4).ok);
    pool_add(&pool, (particle){ { 1, 2, 3 }, { 4, 5, 6 }, 7 });
    status s = pool_reserve(&pool, INT_MAX);
    ck_assert(!s.ok && strstr(s.why, "2147483647 particles is too large"));
    ck_assert(pool.count == 1 && pool.capacity == 4);
    near_vec3(pool.at[0].previous, (vec3){ 4, 5, 6 }, 0);
    // Less than nothing is there already.
    ck_assert(pool_reserve(&pool, -3).ok && pool.capacity == 4);
    pool_free(&pool);
}
END_TEST

START_TEST(refused_memory_leaves_the_pool)
{
    // Rejects: the old particles lost or leaked when there is no room for more.
    particle_pool pool;
    pool_init(&pool);
    for (int room = 0; room < 2; room++) {
        long held = blocks_held;
        mallocs_left = 0;
        status s = pool_reserve(&pool, 4 + room);
        mallocs_left = INT_MAX;
        held = blocks_held - held;
        ck_assert_str_eq(s.why, "out of memory");
        ck_assert_int_eq(held, 0);
        ck_assert(pool.count == room && pool.capacity == 4 * room);
        ck_assert(pool_reserve(&pool, 4).ok);
        if (!room) pool_add(&pool, (particle){ { 1, 2, 3 }, { 4, 5, 6 }, 7 });
    }
    near_vec3(pool.at[0].position, (vec3){ 1, 2, 3 }, 0);
    long held = blocks_held;
    pool_free(&pool);
    held -= blocks_held;
    ck_assert_int_eq(held, 1);
}
END_TEST

// ---- The parabola

static vec3 parabola(vec3 x0, vec3 v0, vec3 a, real t)
{
    return vec3_add_scaled(vec3_add_scaled(x0, t, v0), t * t / 2, a);
}

START_TEST(parabola_is_exact_to_the_last_bit)
{
    // Every number here is a sum of a few powers of 2, so nothing rounds.
    // Rejects: a start without a0, a dt^2 / 2 in the step, a last move with the
    // wrong sign, a previous that stays behind.
    vec3 x0 = { 1, 2, 3 }, v0 = { 4, 5, -6 }, a = { 0.5, -9.8125, 0 };
    real dt = 1.0 / 64;
    particle p = particle_start(x0, v0, a, 2, dt);
    for (int k = 1; k <= 640; k++) {
        verlet_step(&p, 1, a, NULL, dt);
        near_vec3(p.position, parabola(x0, v0, a, k * dt), 0);
    }
}
END_TEST

START_TEST(parabola_is_exact_to_rounding)
{
    // A rounding of at most |x| / 2^53 in one step is a wrong velocity in all
    // that follow: after k steps k^2 / 2 of them at worst, here for each of
    // two roundings (the move, and its sum with x).
    vec3 x0 = { 1, 2, 3 }, v0 = { 4, 5, -6 };
    real dt = 1.0 / 60, bit = 1.0 / 9007199254740992.0;
    particle p = particle_start(x0, v0, GRAVITY, 2, dt);
    for (int k = 1; k <= 600; k++) {
        verlet_step(&p, 1, GRAVITY, NULL, dt);
        vec3 wanted = parabola(x0, v0, GRAVITY, k * dt);
        near(vec3_distance(p.position, wanted), 0,
             k * k * bit * (60 + vec3_length(wanted)), "off the parabola");
    }
}
END_TEST

START_TEST(force_and_gravity_add_up)
{
    // Rejects: a force that forgets the mass, or replaces gravity.
    particle p = particle_start((vec3){ 0, 0, 0 }, (vec3){ 0, 0, 0 },
                                (vec3){ 3, -9.81, 0 }, 0.5, 0.125);
    vec3 force = { 6, 0, 0 };
    for (int k = 0; k < 8; k++) verlet_step(&p, 1, GRAVITY, &force, 0.125);
    near(p.position.x, 1.5, ROUNDING, "x");
    near(p.position.y, -9.81 / 2, ROUNDING, "y");
}
END_TEST

START_TEST(far_from_the_origin_gravity_still_pulls)
{
    // Rejects: float anywhere in the sum: at 1e6 m its last bit is 0.06 m, and
    // gravity's 9e-6 m a step would vanish.
    real dt = 1.0 / 1024, far = 1048576;
    particle p = { { 0, far, 0 }, { 0, far, 0 }, 1 };
    for (int k = 0; k < 1024; k++) verlet_step(&p, 1, GRAVITY, NULL, dt);
    // From rest with previous = position: dt^2 k (k + 1) / 2.
    real wanted = -9.81 * (1 + dt) / 2;
    // 1024 roundings of 2^-33 m, each carried on as a velocity.
    near(p.position.y - far, wanted, 1024 * 512 / 8589934592.0, "fall");
}
END_TEST

// ---- Pinned particles

START_TEST(pinned_particle_stays)
{
    // Rejects: gravity on a pinned particle, a velocity left in previous.
    particle p = particle_start((vec3){ 1, 2, 3 }, (vec3){ 4, 5, 6 }, GRAVITY,
                                0, 0.01);
    near_vec3(p.previous, p.position, 0);
    vec3 force = { 1e9, 0, 0 };
    for (int k = 0; k < 10; k++) verlet_step(&p, 1, GRAVITY, &force, 0.01);
    near_vec3(p.position, (vec3){ 1, 2, 3 }, 0);
    near_vec3(p.previous, (vec3){ 1, 2, 3 }, 0);
    near_vec3(verlet_velocity(&p, GRAVITY, 0.01), (vec3){ 0, 0, 0 }, 0);
}
END_TEST

START_TEST(pinned_particle_forgets_its_motion)
{
    // Rejects: a step that leaves previous behind: a particle pinned in flight
    // would fly on the moment it is set free.
    particle p = { { 1, 0, 0 }, { 0, 0, 0 }, 0 };
    verlet_step(&p, 1, GRAVITY, NULL, 0.01);
    near_vec3(p.position, (vec3){ 1, 0, 0 }, 0);
    near_vec3(p.previous, (vec3){ 1, 0, 0 }, 0);
}
END_TEST

START_TEST(each_particle_has_its_own_force)
{
    // Rejects: force[0] for all.
    particle p[3];
    vec3 force[3] = { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } };
    for (int i = 0; i < 3; i++)
        p[i] = (particle){ { 0, 0, 0 }, { 0, 0, 0 }, 1 };
    verlet_step(p, 3, NO_GRAVITY, force, 1);
    for (int i = 0; i < 3; i++) near_vec3(p[i].position, force[i], 0);
    verlet_step(p, 0, NO_GRAVITY, force, 1);
}
END_TEST

// ---- The oscillator: x'' = -omega^2 x, a spring of stiffness omega^2 on 1 kg

typedef enum { EXPLICIT, SYMPLECTIC, VERLET, CARELESS } method;

static vec3 spring(vec3 x, real omega)
{
    return vec3_scale(-omega * omega, x);
}

// Both Euler methods, to compare with: explicit moves with the velocity before
// the kick, symplectic with the velocity after it.
typedef struct {
    real x, v;
} euler;

static euler euler_step(method m, euler e, real omega, real dt)
{
    real kick = -omega * omega * e.x * dt;
    if (m == SYMPLECTIC) e.v += kick;
    e.x += e.v * dt;
    if (m == EXPLICIT) e.v += kick;
    return e;
}

// The position after steps steps of dt, from x = 1 at the speed v0.
static real oscillate(method m, real omega, real v0, real dt, int steps)
{
    vec3 x0 = { 1, 0, 0 }, v = { v0, 0, 0 };
    euler e = { 1, v0 };
    vec3 a0 = m == CARELESS ? NO_GRAVITY : spring(x0, omega);
    particle p = particle_start(x0, v, a0, 1, dt);
    for (int k = 0; k < steps; k++) {
        vec3 force = spring(p.position, omega);
        if (m < VERLET) e = euler_step(m, e, omega, dt);
        else            verlet_step(&p, 1, NO_GRAVITY, &force, dt);
    }
    return m < VERLET ? e.x : p.position.x;
}

// The slope of log error against log dt, over the last halving, at t = 1.
static real order(method m)
{
    real error[2];
    for (int h = 0; h < 2; h++) {
        int steps = 1000 << h;
        error[h] = oscillate(m, 2, 1, 1.0 / steps, steps)
                 - (cos(2.0) + sin(2.0) / 2);
    }
    return log2(fabs(error[0] / error[1]));
}

START_TEST(explicit_euler_is_of_order_1)
{
    near(order(EXPLICIT), 1, ORDER_SLACK, "order");
}
END_TEST

START_TEST(symplectic_euler_is_of_order_1)
{
    near(order(SYMPLECTIC), 1, ORDER_SLACK, "order");
}
END_TEST

START_TEST(verlet_is_of_order_2)
{
    // Rejects: a start or a step that drops a term.
    near(order(VERLET), 2, ORDER_SLACK, "order");
}
END_TEST

START_TEST(careless_start_costs_an_order)
{
    // Rejects: the belief that the start is forgotten.
    near(order(CARELESS), 1, ORDER_SLACK, "order");
}
END_TEST

START_TEST(careless_verlet_is_symplectic_euler)
{
    // x1 = x0 + v0 dt + a0 dt^2 in both, and so for ever.  Rejects: a
    // symplectic step that kicks with the force at the new place.
    for (int k = 1; k < 1000; k += 37)
        near(oscillate(CARELESS, 2, 1, 0.01, k),
             oscillate(SYMPLECTIC, 2, 1, 0.01, k), ROUNDING, "place");
}
END_TEST

START_TEST(explicit_euler_spirals_out)
{
    // |z|^2 grows by 1 + (omega dt)^2 each step, exactly.  Rejects: explicit
    // and symplectic exchanged.
    real dt = 0.1;
    euler e = { 1, 0 }, k = { 1, 0 };
    for (int i = 0; i < 628; i++) {
        e = euler_step(EXPLICIT, e, 1, dt);
        k = euler_step(SYMPLECTIC, k, 1, dt);
    }
    near((e.x * e.x + e.v * e.v) / pow(1 + dt * dt, 628), 1, ROUNDING,
         "growth");
    // Symplectic keeps v^2 + x^2 - omega dt x v, exactly.
    near(k.x * k.x + k.v * k.v - dt * k.x * k.v, 1, ROUNDING,
         "modified energy");
}
END_TEST

START_TEST(oscillator_keeps_the_period_law)
{
    // x_k = cos(k phi) with sin(phi / 2) = omega dt / 2: one step back and
    // forward from the top are equal.  Rejects: any other step of order 2.
    real at[] = { 0.01, 0.1, 0.3, 1, 1.5, 1.9, 1.99 };
    for (int i = 0; i < 7; i++) {
        real wdt = at[i], phi = 2 * asin(wdt / 2);
        real omega = 3, dt = wdt / omega;
        for (int k = 1; k < 2000; k += 97)
            near(oscillate(VERLET, omega, 0, dt, k), cos(k * phi),
                 1e-10, "period law");
    }
}
END_TEST

static real largest_swing(real wdt)
{
    real top = 0;
    particle p = particle_start((vec3){ 1, 0, 0 }, NO_GRAVITY,
                                (vec3){ -1, 0, 0 }, 1, wdt);
    for (int k = 0; k < 10000 && top < 1e6; k++) {
        vec3 force = spring(p.position, 1);
        verlet_step(&p, 1, NO_GRAVITY, &force, wdt);
        top = fmax(top, fabs(p.position.x));
    }
    return top;
}

START_TEST(oscillator_is_bounded_below_two_and_not_above)
{
    // From rest at the top the law says amplitude 1 at every omega dt < 2.
    near(largest_swing(1.99), 1, 1e-9, "at 1.99");
    ck_assert_msg(largest_swing(2.01) > 1e6, "2.01 should explode");
}
END_TEST

START_TEST(modified_energy_is_kept)
{
    // v^2 / 2 + omega^2 x^2 / 2 (1 - (omega dt)^2 / 4), v the centred
    // velocity, does not drift at all.  Rejects: a damped step.
    real omega = 2, dt = 0.1;
    particle p = particle_start((vec3){ 1, 0, 0 }, (vec3){ 1, 0, 0 },
                                (vec3){ -4, 0, 0 }, 1, dt);
    real first = 0;
    for (int k = 0; k < 10000; k++) {
        real x = p.position.x;
        real v = verlet_velocity(&p, spring(p.position, omega), dt).x;
        real e = v * v / 2
               + omega * omega * x * x / 2 * (1 - omega * dt * omega * dt / 4);
        if (k == 0) first = e;
        near(e, first, ROUNDING * 10, "modified energy");
        vec3 force = spring(p.position, omega);
        verlet_step(&p, 1, NO_GRAVITY, &force, dt);
    }
}
END_TEST

START_TEST(reversed_run_comes_home)
{
    // Exchange position and previous, and the same steps lead back.
    // Rejects: damping, a force taken at the wrong end of the step.
    real dt = 0.05;
    particle p = particle_start((vec3){ 1, 0, 0 }, (vec3){ 0, 0.7, 0 },
                                (vec3){ -1, 0, 0 }, 1, dt);
    particle home = p;
    for (int there = 0; there < 2; there++) {
        for (int k = 0; k < 1000; k++) {
            real r = vec3_length(p.position);
            vec3 force = vec3_scale(-1 / (r * r * r), p.position);
            verlet_step(&p, 1, NO_GRAVITY, &force, dt);
        }
        vec3 swap = p.position;
        p.position = p.previous;
        p.previous = swap;
    }
    // A Kepler orbit magnifies rounding in proportion to the time.
    near(vec3_distance(p.position, home.position), 0, 1e-10, "home");
    near(vec3_distance(p.previous, home.previous), 0, 1e-10, "home before");
}
END_TEST

// ---- The velocity

static real velocity_error(int steps)
{
    real dt = 1.0 / steps;
    particle p = particle_start((vec3){ 1, 0, 0 }, (vec3){ 1, 0, 0 },
                                (vec3){ -4, 0, 0 }, 1, dt);
    for (int k = 0; k < steps; k++) {
        vec3 force = spring(p.position, 2);
        verlet_step(&p, 1, NO_GRAVITY, &force, dt);
    }
    vec3 v = verlet_velocity(&p, spring(p.position, 2), dt);
    return fabs(v.x - (-2 * sin(2.0) + cos(2.0)));
}

START_TEST(velocity_is_of_order_2)
{
    // Rejects: (x - x_previous) / dt alone, which is half a step late.
    near(log2(velocity_error(1000) / velocity_error(2000)), 2, ORDER_SLACK,
         "order");
}
END_TEST

START_TEST(start_and_velocity_agree)
{
    // Rejects: a wrong sign of a0 in either.
    vec3 v0 = { 1, -2, 3 };
    particle p = particle_start((vec3){ 1, 2, 3 }, v0, GRAVITY, 1, 0.25);
    vec3 v = verlet_velocity(&p, GRAVITY, 0.25);
    near(vec3_distance(v, v0), 0, ROUNDING, "velocity");
}
END_TEST

START_TEST(energy_of_an_orbit_stays_bounded)
{
    // Verlet's energy error swings with the orbit and does not grow: the last
    // ten of 200 orbits are no worse than the first ten, but for a tenth.
    real dt = 2 * PI / 200, worst[2] = { 0, 0 };
    particle p = particle_start((vec3){ 1, 0, 0 }, (vec3){ 0, 1.1, 0 },
                                (vec3){ -1, 0, 0 }, 1, dt);
    for (int k = 0; k < 40000; k++) {
        real r = vec3_length(p.position);
        vec3 a = vec3_scale(-1 / (r * r * r), p.position);
        vec3 v = verlet_velocity(&p, a, dt);
        real e = fabs(vec3_dot(v, v) / 2 - 1 / r - (1.1 * 1.1 / 2 - 1));
        if (k < 2000) worst[0] = fmax(worst[0], e);
        if (k >= 38000) worst[1] = fmax(worst[1], e);
        verlet_step(&p, 1, NO_GRAVITY, &a, dt);
    }
    ck_assert_msg(worst[1] < 1.1 * worst[0], "%g then %g", worst[0], worst[1]);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        pool_keeps_what_is_added,
        empty_pool_owns_nothing,
        pool_too_large_to_number_is_refused,
        refused_memory_leaves_the_pool,
        parabola_is_exact_to_the_last_bit,
        parabola_is_exact_to_rounding,
        force_and_gravity_add_up,
        far_from_the_origin_gravity_still_pulls,
        pinned_particle_stays,
        pinned_particle_forgets_its_motion,
        each_particle_has_its_own_force,
        explicit_euler_is_of_order_1,
        symplectic_euler_is_of_order_1,
        verlet_is_of_order_2,
        careless_start_costs_an_order,
        careless_verlet_is_symplectic_euler,
        explicit_euler_spirals_out,
        oscillator_keeps_the_period_law,
        oscillator_is_bounded_below_two_and_not_above,
        modified_energy_is_kept,
        reversed_run_comes_home,
        velocity_is_of_order_2,
        start_and_velocity_agree,
        energy_of_an_orbit_stays_bounded,
        NULL
    };
    return suite_run((suite){ .name = "verlet", .tests = tests });
}
