// check_bounds.c - what no frame may do, whatever its contacts were (guard.h).
// Book: chapter 18.

#include <check.h>
#include <math.h>

#include "guard.h"
#include "handle.h"
#include "hull.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

static shape box, plate, bullet, rope;

static void set_up(void)
{
    expect_ok(shape_box(&box, vec3_make(1, 1, 1), 2));
    expect_ok(shape_box(&plate, vec3_make(1, 0.01, 1), 1));
    expect_ok(shape_icosahedron(&bullet, 0.05, 0.05));
    expect_ok(shape_rope(&rope, 1, 1, 1));
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&plate);
    shape_free(&bullet);
    shape_free(&rope);
}

static void begin_falling(real down, real dt)
{
    world_options o = world_options_default();
    o.gravity = vec3_make(0, -down, 0);
    o.dt = dt;
    begin(o);
}

// As a frame has it that has found its contacts: body b goes so far in it, and has
// that velocity.
static void go(int b, vec3 way, vec3 velocity)
{
    w.rigid.moved[b] = (motion){ { way.x, way.y, way.z } };
    w.rigid.velocity[b] = (motion){ { velocity.x, velocity.y, velocity.z } };
}

static vec3 way_of(int b)
{
    const real *of = w.rigid.moved[b].of;
    return vec3_make(of[0], of[1], of[2]);
}

static vec3 velocity_of(int b)
{
    const real *of = w.rigid.velocity[b].of;
    return vec3_make(of[0], of[1], of[2]);
}

// --- Energy ------------------------------------------------------------------

// sqrt(2 E / m) is a speed: those of what moves, of what gravity and the pushing
// out of overlaps add, and of what is driven, twice that where it is bounced off,
// add up.  With m in kg, sqrt of the bound in J: sqrt(E) + sqrt(m / 2) * speed.
START_TEST(what_a_frame_may_have_is_a_sum_of_speeds)
{
    const solver_frame f = { .max_speed = 3, .restitution = 0.5 };
    begin_falling(10, 0.1);
    int b = add_at(&box, 0, 0, 0), lost = add_at(&box, 9, 0, 0);
    world_step(&w);
    go(b, ZERO, vec3_make(3, 0, 0));
    go(lost, ZERO, vec3_make((real)NAN, 0, 0));
    near(sqrt(guard_most(&w, &f)), 3 + 1 * (1 + 3), 1e-9);
    // A force of 20 N gives a body at rest 1 m/s in the frame.
    world_force(&w, b, vec3_make(20, 0, 0), ZERO);
    near(sqrt(guard_most(&w, &f)), 3 + 1 + 4, 1e-9);
    world_forget_loads(&w);
    // What is driven at 5 m/s gives 5, and as much again by its restitution; its
    // own energy is not counted.
    int lift = add_at(&box, 20, 0, 0);
    world_set_kinematic(&w, lift, true);
    world_set_velocity(&w, lift, vec3_make(5, 0, 0), ZERO);
    world_step(&w);
    go(b, ZERO, vec3_make(3, 0, 0));
    go(lost, ZERO, vec3_make((real)NAN, 0, 0));
    near(sqrt(guard_most(&w, &f)), 3 + 4 + 1.5 * 5, 1e-9);
}
END_TEST

// A rope of one link of 1 m and 1 kg, which gives 0.01 m / N, and is 0.1 m longer:
// 0.5 J, and 0.5 J of one end that flies at 1.414 m/s, or that is pinned.  A box
// is there that could take it; where none is, nothing is counted.
START_TEST(what_links_have_stored_may_come_back)
{
    const solver_frame f = { .max_speed = 0 };
    begin_falling(0, 0.1);
    int b = add_at(&rope, 0, 0, 0), taker = add_at(&box, 20, 0, 0);
    expect_ok(world_stretch(&w, b, 0.01));
    world_step(&w);
    particle *end = particle_of(b, 1);
    end->position = end->previous = vec3_add_scaled(particle_of(b, 0)->position,
                                                    1.1, vec3_make(1, 0, 0));
    particle_of(b, 0)->previous = particle_of(b, 0)->position;
    near(guard_most(&w, &f), 0.5, 1e-6);
    end->previous.y -= sqrt(2.0) * w.age;
    near(guard_most(&w, &f), 1, 1e-6);
    world_set_kinematic(&w, taker, true);
    near(guard_most(&w, &f), 0, 1e-9);
    world_set_kinematic(&w, taker, false);
    world_sleep(&w, b);
    near(guard_most(&w, &f), 0, 1e-9);
}
END_TEST

// Rejects: a brake that slows one body more than another, or what is driven; a
// body that keeps its way.
START_TEST(all_are_slowed_by_the_same_share)
{
    begin_falling(0, 0.1);
    int fast = add_at(&box, 0, 0, 0), slow = add_at(&box, 9, 0, 0);
    int lift = add_at(&box, 20, 0, 0);
    world_set_kinematic(&w, lift, true);
    world_set_velocity(&w, lift, vec3_make(5, 0, 0), ZERO);
    world_step(&w);
    for (int k = 0; k < 2; k++) {
        go(fast, vec3_make(0.4, 0, 0), vec3_make(4, 0, 0));
        go(slow, vec3_make(0, 0.3, 0), vec3_make(0, 3, 0));
        go(lift, vec3_make(9, 0, 0), vec3_make(90, 0, 0));
        real share = k == 0 ? 1 : 0.5;      // 25 J
        guard_brake(&w, 25 * share * share);
        near_vec3(velocity_of(fast), vec3_make(4 * share, 0, 0), 1e-12);
        near_vec3(velocity_of(slow), vec3_make(0, 3 * share, 0), 1e-12);
        near_vec3(way_of(slow), vec3_make(0, 0.3 * share, 0), 1e-12);
        near_vec3(velocity_of(lift), vec3_make(90, 0, 0), 0);
        near_vec3(way_of(lift), vec3_make(9, 0, 0), 0);
    }
}
END_TEST

// What had numbers when the frame began stands still; what had none keeps none, so
// that it is seen.
START_TEST(a_body_whose_numbers_are_lost_stands_still)
{
    const real none = (real)NAN;
    begin_falling(0, 0.1);
    int b = add_at(&box, 0, 0, 0), other = add_at(&box, 9, 0, 0);
    world_step(&w);
    w.rigid.reach[b] = 1;
    w.rigid.reach[other] = HUGE_VAL;
    go(b, vec3_make(none, 1, 0), vec3_make(0, none, 0));
    go(other, vec3_make(1, 0, 0), vec3_make(none, 0, 0));
    guard_brake(&w, 1e6);
    near_vec3(velocity_of(b), ZERO, 0);
    near_vec3(way_of(b), ZERO, 0);
    ck_assert(isnan(velocity_of(other).x));
}
END_TEST

// --- Planes ------------------------------------------------------------------

// The centre is 1 m over the floor: it goes down to it, and no further; what goes
// up may go on; and what is below it already is not put over it.
START_TEST(no_centre_goes_behind_a_plane)
{
    const struct { real high, way, speed, goes, has; } c[] = {
        { 1, -3, -30, -1, 0 }, { 1, -3, 7, -1, 7 }, { 1, -0.9, -9, -0.9, -9 },
        { 1, 5, 50, 5, 50 }, { -0.2, -3, -30, 0, 0 }, { -0.2, 0.1, 1, 0.1, 1 }
    };
    for (int k = 0; k < COUNT(c); k++) {
        begin_falling(0, 0.1);
        int b = add_at(&box, 0, 5, 0);
        world_step(&w);
        expect_ok(world_add_plane(&w, UP, 5 - c[k].high));
        go(b, vec3_make(2, c[k].way, 0), vec3_make(20, c[k].speed, 0));
        guard_planes(&w);
        near_vec3(way_of(b), vec3_make(2, c[k].goes, 0), 1e-12);
        near_vec3(velocity_of(b), vec3_make(20, c[k].has, 0), 1e-12);
    }
}
END_TEST

// --- Bodies ------------------------------------------------------------------

// The inner radius of the bullet, and the plate's upper side.
static const real INNER = 0.0397327, SIDE = 0.005;

// A bullet so high over the middle of a plate, whose contact is known.
static void bullet_over_plate(real high, bool plate_is_static,
                              bool bullet_is_static)
{
    begin_falling(0, 1.0 / 60);
    placement p = placement_at(ZERO), q = placement_at(vec3_make(0.1, high, 0));
    p.is_static = plate_is_static;
    q.is_static = bullet_is_static;
    if (!plate_is_static) p.velocity = vec3_make(0, 0.25, 0);
    else                  q.velocity = vec3_make(0, -0.25, 0);
    add(&plate, p);
    add(&bullet, q);
    world_step(&w);
    ck_assert_int_eq(w.rigid.cache.actives, 1);
    w.rigid.reach[0] = w.rigid.reach[1] = 1;
    go(0, ZERO, ZERO);
    go(1, ZERO, ZERO);
}

static real height_of_bullet(void)
{
    return w.rigid.now[1].frame.center.y + way_of(1).y;
}

// Rejects: an impulse that pulls at what parts already.
START_TEST(what_parts_keeps_its_speed)
{
    bullet_over_plate(0.06, true, false);
    go(1, vec3_make(0, -0.2, 0), vec3_make(0, 8, 0));
    guard_bodies(&w);
    near(height_of_bullet(), SIDE + INNER, 1e-6);
    near_vec3(velocity_of(1), vec3_make(0, 8, 0), 1e-12);
}
END_TEST

// Rejects: one that is thrown out of the plate, for it was in it.
START_TEST(what_overlapped_is_put_no_higher_than_it_was)
{
    bullet_over_plate(0.03, true, false);
    real was = w.rigid.now[1].frame.center.y;
    ck_assert(was > SIDE && was < SIDE + INNER - 0.005);
    go(1, vec3_make(0, -0.2, 0), ZERO);
    guard_bodies(&w);
    near(height_of_bullet(), was, 1e-9);
}
END_TEST

// The plate goes up through the bullet, which stands or lies loose: it is stopped
// by it, or takes it along.  Rejects: a plate that is taken where it was.
START_TEST(what_moves_goes_through_nothing_that_stands)
{
    for (int k = 0; k < 2; k++) {
        bullet_over_plate(0.06, false, k == 0);
        go(0, vec3_make(0, 0.3, 0), vec3_make(0, 18, 0));
        guard_bodies(&w);
        real apart = w.rigid.now[1].frame.center.y + way_of(1).y
                   - w.rigid.now[0].frame.center.y - way_of(0).y;
        near(apart, SIDE + INNER, 1e-6);
        real gained = 0.05 * velocity_of(1).y, left = velocity_of(0).y;
        if (k == 1) near(gained + left, 18, 1e-9);
        else        near_vec3(velocity_of(1), ZERO, 0);
        ck_assert(left < 18);
    }
}
END_TEST

// A prism of three sides, its edge along z at x = 0, and a bullet that goes down
// through the planes of the two sides: before the edge, or through the prism.
// Rejects: a line that comes in through a side where it has left the body.
START_TEST(what_passes_an_edge_is_not_stopped)
{
    for (int k = 0; k < 40; k++) {
        bool passes = k % 2 == 0;
        real rise = 0.1 + 0.01 * k;
        shape prism;
        vec3 at[6];
        for (int i = 0; i < 6; i++)
            at[i] = vec3_make(i < 2 ? 0 : -1, i < 2 ? 0 : i < 4 ? rise : -rise,
                              i % 2 - 0.5);
        expect_ok(shape_hull(&prism, at, 6, 5));
        begin_falling(0, 1.0 / 60);
        placement p = placement_at(vec3_make(0, 0, 0));
        for (int i = 0; i < 6; i++)     // where its edge is
            p.position.x = real_min(p.position.x, -prism.at[i].x);
        p.is_static = true;
        real x = passes ? 0.03 : -0.5, y = passes ? 0.03 : rise / 2 + 0.06;
        add(&prism, p);
        add_thrown(&bullet, vec3_make(x, y, 0.1), vec3_make(0, -0.2, 0), ZERO);
        world_step(&w);
        ck_assert_int_eq(w.rigid.cache.actives, 1);
        w.rigid.reach[1] = 1;
        go(1, vec3_make(0, -2 * y, 0), vec3_make(0, -1, 0));
        guard_bodies(&w);
        if (passes) near_vec3(way_of(1), vec3_make(0, -2 * y, 0), 0);
        else        ck_assert(way_of(1).y > -y);
        world_free(&w);
        shape_free(&prism);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_a_frame_may_have_is_a_sum_of_speeds,
        what_links_have_stored_may_come_back,
        all_are_slowed_by_the_same_share,
        a_body_whose_numbers_are_lost_stands_still,
        no_centre_goes_behind_a_plane,
        what_parts_keeps_its_speed,
        what_overlapped_is_put_no_higher_than_it_was,
        what_moves_goes_through_nothing_that_stands,
        what_passes_an_edge_is_not_stopped,
        NULL
    };
    return suite_run((suite){ .name = "bounds", .tests = tests,
                              .set_up = set_up, .tear_down = tear_down });
}
