// check_steering.c - do bodies do what a program asks of them?  Book: chapter 18.

#include <check.h>

#include "expect.h"
#include "handle.h"
#include "measure.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

// Positions near 10 m, of which a velocity is 480 times the difference.
#define ROUNDING 1e-14
#define SPEED (480 * 4e-15)

static shape box, ball, cloth, rope;

// No two of its sides are equal: 2 kg, sides 1, 2 and 3 m.
static const vec3 SIDE = { 1, 2, 3 };

static void set_up(void)
{
    ck_assert(shape_box(&box, SIDE, 2).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
    ck_assert(shape_cloth(&cloth, 10, 10, 1, 1, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&rope);
}

static void begin_without_gravity(void)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
}

static void steps(int n)
{
    for (int k = 0; k < n; k++) world_step(&w);
}

static void steps_to_sleep(void)
{
    int k = 0;
    while (!w.is_still && k++ < 2000) world_step(&w);
    ck_assert(w.is_still);
}

static real strain(void)
{
    return world_measure(&w).strain;
}

// The component of the box's inertia about its axis i, as the textbook has it.
static real inertia(int i)
{
    real s[3] = { SIDE.x * SIDE.x, SIDE.y * SIDE.y, SIDE.z * SIDE.z };
    return 2.0 / 12 * (s[0] + s[1] + s[2] - s[i]);
}

// The spin that an angular momentum L (in the world) gives the box.
static vec3 spin_of(placement p, vec3 L)
{
    vec3 axis[3] = { p.x, p.y, p.z }, sum = ZERO;
    for (int i = 0; i < 3; i++)
        sum = vec3_add_scaled(sum, vec3_dot(axis[i], L) / inertia(i), axis[i]);
    return sum;
}

// --- where -------------------------------------------------------------------

// Rejects: the axes of the four particles for those of the shape; a turn the
// wrong way round.
START_TEST(body_is_where_it_was_put)
{
    for (int k = 0; k < 50; k++) {
        begin(world_options_default());
        placement p = anywhere(10, 5, 5), q;
        add(&box, p);
        for (int moved = 0; moved < 2; moved++) {
            q = world_where(&w, 0);
            near_vec3(q.position, p.position, 10 * ROUNDING);
            near_vec3(q.x, p.x, ROUNDING);
            near_vec3(q.y, p.y, ROUNDING);
            near_vec3(q.z, p.z, ROUNDING);
            near_vec3(q.velocity, p.velocity, 10 * SPEED);
            near_vec3(q.spin, p.spin, 10 * SPEED);
            p = anywhere(10, 5, 5);
            ck_assert(world_put(&w, 0, p).ok);
            ck_assert(strain() <= ROUNDING * 10);
        }
    }
}
END_TEST

// Rejects: a velocity of half a substep ago.
START_TEST(body_that_falls_has_the_velocity_of_the_textbook)
{
    add_thrown(&box, vec3_make(0, 5, 0), vec3_make(1, 2, 3), ZERO);
    steps(30);
    near_vec3(world_where(&w, 0).velocity, vec3_make(1, 2 - 9.81 / 2, 3),
              1e-11);
    near_vec3(world_where(&w, 0).position,
              vec3_make(0.5, 5 + 1 - 9.81 / 8, 1.5), 1e-11);
    world_set_velocity(&w, 0, vec3_make(0, 7, 0), ZERO);
    near_vec3(world_where(&w, 0).velocity, vec3_make(0, 7, 0), 10 * SPEED);
    steps(60);
    near_vec3(world_where(&w, 0).velocity, vec3_make(0, 7 - 9.81, 0), 1e-11);
}
END_TEST

// A third of a second up and down, then sideways for a second.
static void expect_two_parabolas(const shape *s)
{
    const vec3 up = { 1, 2, 0 }, aside = { 5, 0, -3 };
    begin(world_options_default());
    add_thrown(s, ZERO, up, ZERO);
    steps(20);
    world_set_gravity(&w, aside);
    vec3 v = vec3_make(1, 2 - 9.81 / 3, 0);
    vec3 x = vec3_make(1.0 / 3, 2.0 / 3 - 9.81 / 18, 0);
    near_vec3(world_where(&w, 0).velocity, v, 1e-11);
    steps(60);
    near_vec3(world_where(&w, 0).velocity, vec3_add(v, aside), 1e-11);
    near_vec3(vec3_sub(world_where(&w, 0).position, x),
              vec3_add_scaled(v, 0.5, aside), 1e-11);
}

// Rejects: a new gravity that begins half a substep ago, in a body or a rope.
START_TEST(gravity_changes_from_one_parabola_to_the_next)
{
    expect_two_parabolas(&box);
    expect_two_parabolas(&rope);
}
END_TEST

static real taut(real g)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
    int b = add_at(&cloth, 0, 0, 0);
    world_set_gravity(&w, vec3_make(0, -g, 0));
    return w.body[b].taut * g;
}

// Rejects: a sheet that was added without gravity, and does not give.
START_TEST(taut_cloth_gives_by_its_weight_of_now)
{
    ck_assert(taut(0) == 0 && taut(1) > 0);
    near(taut(20), taut(1), 1e-15 * taut(1), "give times weight");
}
END_TEST

// Rejects: gravity in the velocity of what lies.
START_TEST(body_that_lies_stands_still)
{
    shape cube;
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    add_at(&cube, 0, 0.5, 0);
    add_floor();
    steps(20);
    ck_assert(vec3_length(world_where(&w, 0).velocity) < 1e-3);
    steps_to_sleep();
    ck_assert(vec3_length(world_where(&w, 0).velocity) == 0);
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// Rejects: a place that the tables do not know: of the static, where all is as
// it was; contacts that come along; a neighbour that sleeps on in the air.
START_TEST(body_that_is_put_elsewhere_is_met_there)
{
    shape slab, cube;
    ck_assert(shape_box(&slab, vec3_make(3, 0.5, 3), 9).ok);
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    for (int fixed = 0; fixed < 2; fixed++) {
        begin(world_options_default());
        int low = fixed ? add_nailed(&slab, 0, 0.25, 0)
                        : add_at(&slab, 0, 0.25, 0);
        int up = add_at(&cube, 0, 1, 0), far = add_at(&cube, 30, 3, 0);
        add_floor();
        steps_to_sleep();
        ck_assert(world_put(&w, low, placement_at(vec3_make(20, 0.25, 0))).ok);
        ck_assert(!probe_sleeps(&w, up) && probe_sleeps(&w, far));
        steps(1);
        ck_assert_int_eq(w.report.pushing, fixed ? 0 : 1);
        steps_to_sleep();
        near(world_where(&w, up).position.y, 0.5, 0.005);
        ck_assert(world_put(&w, up, placement_at(vec3_make(20, 1.2, 0))).ok);
        steps_to_sleep();
        near(world_where(&w, up).position.y, 1, 0.005);
        near(world_where(&w, low).position.x, 20, 0.005);
        placement bad = placement_at(vec3_make((real)NAN, 0, 0));
        ck_assert(!world_put(&w, up, bad).ok);
        near(world_where(&w, up).position.y, 1, 0.005);
    }
    world_free(&w);
    shape_free(&slab);
    shape_free(&cube);
}
END_TEST

// Rejects: pins that are lost; a cloth that remembers its folds.
START_TEST(cloth_is_put_as_its_shape_is)
{
    int b = add_at(&cloth, 0, 2, 0);
    world_pin(&w, b, 3);
    steps(60);
    placement p = placement_at(vec3_make(5, 8, 0));
    p.x = vec3_make(0, 1, 0);
    p.y = vec3_make(-1, 0, 0);
    ck_assert(world_put(&w, b, p).ok);
    near_vec3(world_where(&w, b).position, p.position, 1e-12);
    ck_assert(strain() < 1e-12);
    ck_assert(particle_of(b, 3)->inverse_mass == 0);
    vec3 pin = particle_of(b, 3)->position;
    steps(30);
    ck_assert(vec3_distance(particle_of(b, 3)->position, pin) == 0);
    ck_assert(world_where(&w, b).position.y < 7.8);
}
END_TEST

// --- push --------------------------------------------------------------------

// J at the arm r gives J / m, and the inverse of the inertia times r x J.
START_TEST(impulse_changes_velocity_and_spin_as_the_textbook_says)
{
    begin_without_gravity();
    for (int k = 0; k < 50; k++) {
        int b = add(&box, anywhere(10, 5, 5));
        placement was = world_where(&w, b);
        vec3 J = random_vec3(&seed, 1), r = random_vec3(&seed, 1);
        world_push(&w, b, J, vec3_add(was.position, r));
        placement now = world_where(&w, b);
        near_vec3(vec3_sub(now.velocity, was.velocity), vec3_scale(0.5, J),
                  10 * SPEED);
        near_vec3(vec3_sub(now.spin, was.spin),
                  spin_of(was, vec3_cross(r, J)), 10 * SPEED);
        near_vec3(now.position, was.position, 0);
        world_remove(&w, b);
    }
}
END_TEST

START_TEST(impulse_on_a_particle_is_shared_by_the_cloth)
{
    begin_without_gravity();
    int b = add_at(&cloth, 0, 2, 0);
    world_push_particle(&w, b, 42, vec3_make(0, 0.3, 0));
    near_vec3(world_measure(&w).momentum, vec3_make(0, 0.3, 0), 1e-12);
    steps(60);
    near_vec3(world_measure(&w).momentum, vec3_make(0, 0.3, 0), 1e-12);
    ck_assert(world_where(&w, b).position.y > 2.2);
}
END_TEST

// Rejects: a sleeper without its inverse masses, that never moves again.
START_TEST(sleeper_that_is_pushed_wakes_with_its_island_and_sleeps_again)
{
    shape cube;
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    add_at(&cube, 0, 0.5, 0);
    add_at(&cube, 0, 1.5, 0);
    add_at(&cube, 9, 0.5, 0);
    add_floor();
    for (int how = 0; how < 4; how++) {
        steps_to_sleep();
        vec3 was = world_where(&w, 1).position;
        if (how == 0) world_push(&w, 1, vec3_make(0.6, 0, 0), was);
        if (how == 1) world_force(&w, 1, vec3_make(60, 0, 0), ZERO);
        if (how == 2) world_set_velocity(&w, 1, vec3_make(0.6, 0, 0), ZERO);
        if (how == 3) world_wake(&w, 1);
        ck_assert(!probe_sleeps(&w, 0) && !probe_sleeps(&w, 1));
        ck_assert(probe_sleeps(&w, 2));
        for (int i = 0; i < 2 * FOUR; i++)
            ck_assert(w.pool.at[i].inverse_mass == 4);
        steps(5);
        real way = world_where(&w, 1).position.x - was.x;
        if (how < 3) ck_assert_msg(way > 0.005, "%g", way);
        else         ck_assert_msg(fabs(way) < 1e-4, "%g", way);
    }
    steps_to_sleep();
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// Rejects: a static body that moves.
START_TEST(static_body_feels_nothing)
{
    int b = add_nailed(&box, 0, 5, 0);
    world_push(&w, b, vec3_make(1, 2, 3), ZERO);
    world_force(&w, b, vec3_make(1, 2, 3), vec3_make(1, 2, 3));
    world_set_velocity(&w, b, vec3_make(1, 2, 3), ZERO);
    steps(10);
    near_vec3(world_where(&w, b).position, vec3_make(0, 5, 0), 0);
    near_vec3(world_where(&w, b).velocity, ZERO, 0);
}
END_TEST

// --- force -------------------------------------------------------------------

// Rejects: a force of one substep; one that acts in every frame; one that
// counts twice when the frame is divided.
START_TEST(constant_force_gives_force_times_time_by_mass)
{
    const vec3 F = { 0.3, -0.7, 0.2 };
    begin_without_gravity();
    int b = add_at(&box, 0, 0, 0), other = add_at(&ball, 9, 0, 0);
    for (int k = 0; k < 60; k++) {
        world_force(&w, b, vec3_scale(0.25, F), ZERO);
        world_force(&w, b, vec3_scale(0.75, F), ZERO);
        steps(1);
    }
    near_vec3(world_where(&w, b).velocity, vec3_scale(0.5, F), 1e-12);
    // x = F t^2 / 2 m, but for half a substep of h too much at the start.
    near_vec3(world_where(&w, b).position, vec3_scale(0.25, F),
              0.5 * vec3_length(F) * w.options.dt / w.options.substeps);
    steps(10);
    near_vec3(world_where(&w, b).velocity, vec3_scale(0.5, F), 1e-12);
    near_vec3(world_where(&w, b).spin, ZERO, 1e-12);
    near_vec3(world_where(&w, other).velocity, ZERO, 0);
}
END_TEST

START_TEST(constant_torque_gives_torque_times_time_by_inertia)
{
    begin_without_gravity();
    placement p = anywhere(3, 0, 0);
    int b = add(&box, p);
    vec3 axis[3] = { p.x, p.y, p.z };
    for (int i = 0; i < 3; i++) {
        world_set_velocity(&w, b, ZERO, ZERO);
        ck_assert(world_put(&w, b, p).ok);
        for (int k = 0; k < 60; k++) {
            world_force(&w, b, ZERO, vec3_scale(0.8, axis[i]));
            steps(1);
        }
        near_vec3(world_where(&w, b).spin,
                  vec3_scale(0.8 / inertia(i), axis[i]),
                  1e-9);
        near_vec3(world_where(&w, b).position, p.position, 1e-10);
    }
}
END_TEST

// Rejects: a guard of the energy that takes a program's push for a fault of the
// contacts.
START_TEST(strong_force_on_a_light_body_in_a_heap_is_not_braked)
{
    begin_without_gravity();
    int b = add_at(&ball, 0, 0, 0);
    add_at(&ball, 1.2, 0, 0);
    for (int k = 0; k < 10; k++) {
        world_force(&w, b, vec3_make(-600, 0, 0), ZERO);
        steps(1);
    }
    near(world_where(&w, b).velocity.x, -100, 1e-9);
}
END_TEST

// A weight that is held by its own weight's force, up.
START_TEST(force_of_its_weight_holds_a_body)
{
    int b = add_at(&box, 0, 5, 0);
    for (int k = 0; k < 120; k++) {
        world_force(&w, b, vec3_make(0, 2 * 9.81, 0), ZERO);
        steps(1);
    }
    near(world_where(&w, b).position.y, 5, 9.81 / 480 * 2);
}
END_TEST

// --- materials ---------------------------------------------------------------

static shape cube;

// On a slope of 3 : 4, sine .6 and cosine .8, that is a plane or a body.
static int add_on_slope(const shape *s, real z, real up)
{
    vec3 n = { -0.6, 0.8, 0 };
    placement p = placement_at(vec3_add_scaled(vec3_make(0, 0, z), up, n));
    p.x = vec3_make(0.8, 0.6, 0);
    p.y = n;
    return add(s, p);
}

// Five boxes of five frictions, .1, .2 ... on a slope of .9; each slides at
// g (sin a - mu cos a), with the root of the product, or rests.
// Rejects: the friction of the first for all of a block; the mean; the world's.
START_TEST(each_box_slides_with_a_friction_of_its_own)
{
    shape slab;
    ck_assert(shape_box(&cube, vec3_make(1, 0.25, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(60, 1, 60), 1).ok);
    for (int fixed = 0; fixed < 2; fixed++) {
        begin(world_options_default());
        if (fixed) {
            int b = add_on_slope(&slab, 0, -0.5);
            placement p = world_where(&w, b);
            world_remove(&w, b);
            p.is_static = true;
            p.velocity = ZERO;
            b = add(&slab, p);
            ck_assert(world_set_material(&w, b, (material){ 0.9, -1 }).ok);
        } else {
            ck_assert(world_add_plane(&w, vec3_make(-0.6, 0.8, 0), 0).ok);
            material m = { 0.9, -1 };
            ck_assert(world_set_plane_material(&w, 0, m).ok);
        }
        int box_of[6];
        for (int k = 0; k < 6; k++) {
            box_of[k] = add_on_slope(&cube, 3 * k - 7, 0.125);
            material m = { k < 5 ? 0.1 * (k + 1) : -1, -1 };
            ck_assert(world_set_material(&w, box_of[k], m).ok);
        }
        steps(30);
        for (int k = 0; k < 6; k++) {
            real own = k < 5 ? 0.1 * (k + 1) : 0.5, mu = sqrt(0.9 * own);
            real pull = 9.81 * (0.6 - mu * 0.8);
            placement q = world_where(&w, box_of[k]);
            // It falls on the slope for half a substep, and gives a little.
            near(vec3_length(q.velocity), real_max(pull, 0) / 2, 0.04);
        }
    }
    world_free(&w);
    shape_free(&cube);
    shape_free(&slab);
}
END_TEST

// The same of a cloth, on a plane and on a static body; and of one on another.
START_TEST(cloth_slides_with_a_friction_of_its_own)
{
    for (int k = 0; k < 3; k++) {
        begin(world_options_default());
        ck_assert(world_add_plane(&w, vec3_make(-0.6, 0.8, 0), 0).ok);
        ck_assert(world_set_plane_material(&w, 0, (material){ 0.8, -1 }).ok);
        int b = add_on_slope(&cloth, 0, cloth.spacing * 0.55);
        ck_assert(world_set_material(&w, b, (material){ 0.2 * k, -1 }).ok);
        steps(30);
        real pull = 9.81 * (0.6 - sqrt(0.8 * 0.2 * k) * 0.8);
        near(vec3_length(world_where(&w, b).velocity), pull / 2, 0.05);
    }
}
END_TEST

// Rejects: the smaller restitution, or the product; impacts only where the
// world has some.
START_TEST(two_bounce_with_the_larger_restitution)
{
    const real own[] = { 0, 0.3, 0.5, 0.8, -1 };
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    add_floor();
    ck_assert(world_set_plane_material(&w, 0, (material){ -1, 0.4 }).ok);
    for (int k = 0; k < 5; k++) {
        int b = add_at(&cube, 3 * k, 1.5, 0);
        ck_assert(world_set_material(&w, b, (material){ -1, own[k] }).ok);
    }
    real top[5] = { 0 };
    // They fall for .45 s, and rise for e times that.
    for (int f = 0; f < 60; f++) {
        steps(1);
        for (int b = 0; b < 5 && f > 28; b++)
            top[b] = real_max(top[b], world_where(&w, b).position.y - 0.5);
    }
    for (int b = 0; b < 5; b++) {
        real e = real_max(own[b], 0.4);
        near(top[b], e * e, 0.01);
    }
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// Rejects: cubes without restitution that others' impacts leave to bounce, or
// in the floor.
START_TEST(body_that_bounces_disturbs_none_that_does_not)
{
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    add_floor();
    int first = add_at(&cube, 0, 1.5, 0), last = add_at(&cube, 9, 1.5, 0);
    ck_assert(world_set_material(&w, last, (material){ -1, 0.9 }).ok);
    real top = 0, low = 1;
    for (int f = 0; f < 120; f++) {
        steps(1);
        real y = world_where(&w, first).position.y;
        if (f > 33) top = real_max(top, y);
        low = real_min(low, y);
    }
    ck_assert_msg(top < 0.501 && low > 0.48, "%g %g", top, low);
    ck_assert(!world_set_material(&w, 0, (material){ (real)NAN, 0 }).ok);
    ck_assert(!world_set_material(&w, 0, (material){ 0.5, 1.1 }).ok);
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// A frame of n substeps of h, each island's own, leaves 1 / (1 + h d)^n.
static real left_of(int b, real damping)
{
    real h = body_age(&w, b), left = 1;
    int n = (int)(w.options.dt / h + 0.5);
    for (int k = 0; k < n; k++) left /= 1 + damping * h;
    return left;
}

START_TEST(damping_takes_its_share_in_every_substep)
{
    begin_without_gravity();
    int b = add_thrown(&box, ZERO, vec3_make(1, 2, 3), vec3_make(0, 0, 2));
    int free = add_thrown(&box, vec3_make(9, 0, 0), vec3_make(1, 2, 3), ZERO);
    int sheet = add_thrown(&cloth, vec3_make(0, 9, 0), vec3_make(0, 1, 0), ZERO);
    ck_assert(world_set_damping(&w, b, 0.5, 4).ok);
    ck_assert(world_set_damping(&w, sheet, 0.5, 0).ok);
    ck_assert(!world_set_damping(&w, b, -1, 4).ok);
    ck_assert(!world_set_damping(&w, b, 0, HUGE_VAL).ok);
    real left = 1, spin = 2, flat = 1;
    for (int f = 0; f < 30; f++) {
        steps(1);
        left *= left_of(b, 0.5);
        spin *= left_of(b, 4);
        flat *= left_of(sheet, 0.5);
    }
    near_vec3(world_where(&w, b).velocity,
              vec3_scale(left, vec3_make(1, 2, 3)), 1e-10);
    near_vec3(world_where(&w, b).spin, vec3_make(0, 0, spin), 1e-7);
    near_vec3(world_where(&w, free).velocity, vec3_make(1, 2, 3), 1e-10);
    near_vec3(world_where(&w, sheet).velocity, vec3_make(0, flat, 0), 1e-9);
}
END_TEST

// --- kinematic ---------------------------------------------------------------

static int add_driven(const shape *s, vec3 at, vec3 velocity, vec3 spin)
{
    int b = add_at(s, at.x, at.y, at.z);
    world_set_kind(&w, b, BODY_KINEMATIC);
    world_set_velocity(&w, b, velocity, spin);
    return b;
}

// In every frame x + v dt, and nothing else.
// Rejects: a pusher that is pushed, by whatever little.
START_TEST(kinematic_body_goes_its_way_to_the_last_bit)
{
    world_options o = world_options_default();
    o.dt = 1.0 / 64;
    begin(o);
    shape wall;
    ck_assert(shape_box(&wall, vec3_make(1, 2, 16), 1).ok);
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 3).ok);
    add_floor();
    int pusher = add_driven(&wall, vec3_make(-2, 1, 0), vec3_make(0.5, 0, 0),
                            ZERO);
    int box_of[10];
    for (int k = 0; k < 10; k++)
        box_of[k] = add_at(&cube, 0, 0.5, 1.25 * (k - 4.5));
    vec3 at = particle_of(pusher, 0)->position;
    for (int f = 1; f <= 512; f++) {
        steps(1);
        at.x += 0.5 / 64;
        near_vec3(particle_of(pusher, 0)->position, at, 0);
    }
    near_vec3(world_where(&w, pusher).position, vec3_make(2, 1, 0), 1e-12);
    for (int k = 0; k < 10; k++) {
        placement q = world_where(&w, box_of[k]);
        near(q.position.x, 3, 0.02);
        near(q.velocity.x, 0.5, 0.02);
    }
    near_vec3(world_where(&w, pusher).velocity, vec3_make(0.5, 0, 0), 0);
    world_free(&w);
    shape_free(&wall);
    shape_free(&cube);
}
END_TEST

// Rejects: friction against what stands; a guard of the energy that brakes it.
START_TEST(platform_carries_what_lies_on_it)
{
    shape plate;
    ck_assert(shape_box(&plate, vec3_make(4, 0.5, 4), 1).ok);
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    int deck = add_driven(&plate, vec3_make(0, 0, 0), ZERO, ZERO);
    int b = add_at(&cube, 0.5, 0.75, 0);
    add_at(&cube, 0.5, 1.75, 0);
    // (One that weighs more than all, so that loads are looked at.)
    shape heavy;
    ck_assert(shape_box(&heavy, vec3_make(1, 1, 1), 1000).ok);
    int far = add_nailed(&plate, 99, -0.25, 0);
    ck_assert(w.body[far].first > 0);
    add_at(&heavy, 99, 0.5, 0);
    steps_to_sleep();
    // It sleeps on a platform at rest, and wakes when that goes.
    world_set_velocity(&w, deck, vec3_make(0.5, 0.25, 0), ZERO);
    int roof = add_driven(&plate, vec3_make(0, 2.499, 0),
                          vec3_make(0.5, 0.25, 0), ZERO);
    for (int f = 0; f < 300; f++) {
        steps(1);
        ck_assert_int_le(w.report.substeps, w.options.substeps);
    }
    placement d = world_where(&w, deck), q = world_where(&w, b);
    near_vec3(d.position, vec3_make(2.5, 1.25, 0), 1e-9);
    near_vec3(q.velocity, d.velocity, 0.005);
    near_vec3(vec3_sub(q.position, d.position), vec3_make(0.5, 0.75, 0), 0.02);
    // When it stops, they slide on a little, and sleep.
    world_remove(&w, roof);
    world_set_velocity(&w, deck, ZERO, ZERO);
    steps_to_sleep();
    near(world_where(&w, b).position.y, 2, 0.005);
    world_free(&w);
    shape_free(&heavy);
    shape_free(&plate);
    shape_free(&cube);
}
END_TEST

// Rejects: a guard of the energy that takes a pusher's gift back.
START_TEST(fast_pusher_takes_a_body_along_at_once)
{
    begin_without_gravity();
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    int pusher = add_driven(&cube, vec3_make(-2, 0, 0), vec3_make(10, 0, 0),
                            ZERO);
    int b = add_at(&cube, 0, 0, 0);
    for (int f = 0; f < 40; f++) {
        steps(1);
        real gap = world_where(&w, b).position.x
                 - world_where(&w, pusher).position.x;
        ck_assert_msg(gap > 0.99, "frame %d: %g", f, gap);
    }
    near(world_where(&w, b).velocity.x, 10.2, 0.3);
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// With restitution 1 on a plate that rises by V, a body that comes down by v
// goes up by v + 2 V.  Rejects: a plate that falls as bodies do.
START_TEST(body_bounces_off_a_plate_that_rises)
{
    shape plate;
    ck_assert(shape_box(&plate, vec3_make(4, 1, 4), 1).ok);
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    for (int k = 0; k < 12; k++) {
        begin(world_options_default());
        real high = 1 + 0.005 * k;
        int b = k % 2 ? add_at(&cube, 0, high, 0) : -1;
        int deck = add_driven(&plate, vec3_make(0, -1, 0), vec3_make(0, 1, 0),
                              ZERO);
        ck_assert(world_set_material(&w, deck, (material){ -1, 1 }).ok);
        if (b < 0) b = add_at(&cube, 0, high, 0);
        // They meet when high - g t^2 / 2 = t: v = g t.
        real t = (sqrt(1 + 2 * 9.81 * high) - 1) / 9.81, v = 9.81 * t;
        steps(42);
        near(world_where(&w, b).velocity.y, v + 2 - 9.81 * (0.7 - t),
                  0.002);
    }
    world_free(&w);
    shape_free(&plate);
    shape_free(&cube);
}
END_TEST

// A spin of w for t turns by w t; a body at r leaves with w r.
START_TEST(body_that_is_turned_throws)
{
    shape plate;
    ck_assert(shape_box(&plate, vec3_make(8, 0.5, 8), 1).ok);
    ck_assert(shape_box(&cube, vec3_make(0.5, 0.5, 0.5), 1).ok);
    begin_without_gravity();
    int wheel = add_driven(&plate, ZERO, ZERO, vec3_make(0, 2, 0));
    int sleeper = add_at(&cube, 99, 0, 0);
    world_sleep(&w, sleeper);
    steps(30);
    world_wake(&w, sleeper);
    steps(30);
    ck_assert(strain() < 1e-8);
    placement q = world_where(&w, wheel);
    near_vec3(q.x, vec3_make(cos(2.0), 0, -sin(2.0)), 1e-9);
    near_vec3(q.position, ZERO, 1e-12);
    near_vec3(q.spin, vec3_make(0, 2, 0), 0);
    // A bat, in the plane of the ball.
    begin_without_gravity();
    shape bat;
    ck_assert(shape_box(&bat, vec3_make(4, 0.5, 0.25), 1).ok);
    ck_assert(world_set_material(&w, add_driven(&bat, vec3_make(2, 0, 0), ZERO,
        ZERO), (material){ 0, 0 }).ok);
    int b = add_at(&cube, 3, 0, 1);
    world_set_velocity(&w, 0, vec3_make(0, 0, 0), vec3_make(0, -1, 0));
    for (int f = 0; f < 120; f++) steps(1);
    // It is struck at the arm r = 1.41 m, by w = 1 rad/s, and slides along the
    // bat without friction to its end R = 2 m: there it goes w R with the bat,
    // and w sqrt(R^2 - r^2) along it.
    near(vec3_length(world_where(&w, b).velocity), sqrt(4.0 + 4 - 2), 0.1);
    near_vec3(world_where(&w, 0).position, vec3_make(2, 0, 0), 1e-12);
    world_free(&w);
    shape_free(&bat);
    shape_free(&plate);
    shape_free(&cube);
}
END_TEST

// Rejects: cloth that goes through; a pusher that is held by it.
START_TEST(kinematic_body_carries_cloth)
{
    shape ram;
    ck_assert(shape_box(&ram, vec3_make(0.4, 0.4, 0.4), 1).ok);
    int sheet = add_at(&cloth, 0, 1, 0);
    int b = add_driven(&ram, vec3_make(0, 0.5, 0), vec3_make(0, 0.5, 0), ZERO);
    vec3 at = particle_of(b, 0)->position;
    for (int f = 0; f < 240; f++) {
        steps(1);
        at.y += w.options.dt * 0.5;
        // To the rounding of 240 sums of 2 m, there and here.
        near_vec3(particle_of(b, 0)->position, at, 1.1e-13);
    }
    near_vec3(world_where(&w, b).position, vec3_make(0, 2.5, 0), 1e-9);
    real top = 0;
    for (int i = 0; i < cloth.particles; i++)
        top = real_max(top, particle_of(sheet, i)->position.y);
    near(top, 2.7, 0.12);
    world_free(&w);
    shape_free(&ram);
}
END_TEST

// Rejects: contacts with planes and static bodies that nothing comes of; work
// that no account has; a body that stays kinematic.
START_TEST(kinematic_body_goes_through_what_does_not_move)
{
    world_options o = world_options_default();
    o.ledger = true;
    begin(o);
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    add_floor();
    add_nailed(&cube, 0, 0.5, 0);
    int other = add_driven(&cube, vec3_make(0, 0, 1), vec3_make(0, 1, 0), ZERO);
    int b = add_driven(&cube, vec3_make(0, -1, 0), vec3_make(0, 1, 0), ZERO);
    int up = add_at(&cube, 0, 1.5, 0);
    steps(60);
    ck_assert_int_eq(w.report.unconverged, 0);
    near(world_where(&w, b).position.y, 0, 1e-12);
    steps(60);
    near(world_where(&w, other).position.y, 2, 1e-12);
    // It has lifted the cube by half a metre, and with its speed.
    placement q = world_where(&w, up);
    near(q.position.y, 2, 0.02);
    real gave = 0, has = 9.81 * (q.position.y - 1.5)
                       + vec3_length_squared(q.velocity) / 2;
    for (int k = 0; k < LEDGERS; k++) gave += w.ledger[k].energy;
    near(gave, has, 0.06);
    world_set_kind(&w, b, BODY_DYNAMIC);
    world_set_kind(&w, other, BODY_DYNAMIC);
    near_vec3(world_where(&w, other).velocity, vec3_make(0, 1, 0), 1e-9);
    steps_to_sleep();
    near(world_where(&w, other).position.y, 0.5, 0.01);
    ck_assert_int_eq(w.dynamic_bodies, 3);
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// --- filter ------------------------------------------------------------------

// Rejects: a mask that is asked of one side only; one that is asked once.
START_TEST(bodies_meet_as_their_groups_and_masks_say)
{
    // Who has 2 meets 1 and 2; who has 4 meets none but 1; one is as all are.
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    const struct { unsigned group, mask; bool meets; } who[] = {
        { 1, ~0u, true }, { 2, ~0u, true }, { 2, 1, true }, { 2, 2, false },
        { 4, 2 | 4, false }, { 0, ~0u, false }, { 1, 0, false },
    };
    for (int k = 0; k < 7; k++) {
        begin(world_options_default());
        int b = add_nailed(&box, 0, 0, 0);
        int up = add_at(&cube, 0, 2, 0), sheet = add_at(&cloth, 0, 1.1, 0);
        world_remove(&w, k % 2 ? sheet : up);
        int rest = k % 2 ? up : sheet;
        world_set_filter(&w, rest, who[k].group, who[k].mask);
        steps(60);
        real y = world_where(&w, rest).position.y;
        if (who[k].meets) ck_assert_msg(y > 0.5, "%d: %g", k, y);
        else              ck_assert_msg(y < -2, "%d: %g", k, y);
        if (!who[k].meets) continue;
        // Now they do not meet any more, and it falls through.
        steps(200);
        world_set_filter(&w, b, 8, 8);
        steps(60);
        ck_assert(world_where(&w, rest).position.y < -2);
        (void)b;
    }
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// --- sleep -------------------------------------------------------------------

START_TEST(body_that_is_put_to_sleep_hangs_in_the_air_until_it_is_woken)
{
    int b = add_at(&box, 0, 5, 0), sheet = add_at(&cloth, 9, 5, 0);
    steps(3);
    vec3 was = world_where(&w, b).position;
    world_sleep(&w, b);
    world_sleep(&w, sheet);
    steps(60);
    near_vec3(world_where(&w, b).position, was, 0);
    ck_assert_int_eq(w.report.asleep, 2);
    world_wake(&w, b);
    steps(60);
    // (What stood still stood still half a substep ago.)
    near(world_where(&w, b).position.y, was.y - 9.81 / 2, 9.81 / 475);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        body_is_where_it_was_put,
        body_that_falls_has_the_velocity_of_the_textbook,
        gravity_changes_from_one_parabola_to_the_next,
        taut_cloth_gives_by_its_weight_of_now,
        body_that_lies_stands_still,
        body_that_is_put_elsewhere_is_met_there,
        cloth_is_put_as_its_shape_is,
        impulse_changes_velocity_and_spin_as_the_textbook_says,
        impulse_on_a_particle_is_shared_by_the_cloth,
        sleeper_that_is_pushed_wakes_with_its_island_and_sleeps_again,
        static_body_feels_nothing,
        constant_force_gives_force_times_time_by_mass,
        constant_torque_gives_torque_times_time_by_inertia,
        strong_force_on_a_light_body_in_a_heap_is_not_braked,
        force_of_its_weight_holds_a_body,
        each_box_slides_with_a_friction_of_its_own,
        cloth_slides_with_a_friction_of_its_own,
        two_bounce_with_the_larger_restitution,
        body_that_bounces_disturbs_none_that_does_not,
        damping_takes_its_share_in_every_substep,
        kinematic_body_goes_its_way_to_the_last_bit,
        platform_carries_what_lies_on_it,
        fast_pusher_takes_a_body_along_at_once,
        body_bounces_off_a_plate_that_rises,
        body_that_is_turned_throws,
        kinematic_body_carries_cloth,
        kinematic_body_goes_through_what_does_not_move,
        bodies_meet_as_their_groups_and_masks_say,
        body_that_is_put_to_sleep_hangs_in_the_air_until_it_is_woken,
        NULL
    };
    return suite_run((suite){
        .name = "steering", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
