// check_advance.c - is everything where it is, in every substep?
// Book: chapter 18.

#include <check.h>
#include <string.h>

#include "advance.h"
#include "handle.h"
#include "stage.h"
#include "suite.h"

static shape brick, rod;

static void set_up(void)
{
    ck_assert(shape_box(&brick, vec3_make(0.4, 0.2, 0.1), 2).ok);
    ck_assert(shape_box(&rod, vec3_make(6, 0.2, 0.2), 1).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&brick);
    shape_free(&rod);
}

// As the step does: the substeps of a frame.
static void begin_substeps(void)
{
    probe_begin_substeps(&w);
    advance_begin(&w);
}

static vec3 angular(int b)
{
    return motion_angular(&probe_start(&w, b)->basis, probe_velocity(&w, b));
}

static real energy(int b)
{
    return motion_energy(&probe_start(&w, b)->basis, probe_velocity(&w, b));
}

// --- what is free ------------------------------------------------------------

// A brick that is thrown about its middle axis, and turns over again and again.
static int throw_brick(void)
{
    return add_thrown(&brick, vec3_make(1, 2, 3), vec3_make(0.5, 0, -1),
                      vec3_make(1, 12, 2));
}

// Substeps of h for so many seconds; frames have eight.
static void fly(real h, real seconds)
{
    int n = (int)(seconds / h + 0.5);
    for (int k = 1; k <= n; k++) {
        advance_bodies(&w, h);
        if (k % 8 == 0) ck_assert_int_eq(advance_end(&w), 0);
    }
    ck_assert_int_eq(advance_end(&w), 0);
}

// The most by which energy is off in the next second, relative.
static real energy_off(int b, real had)
{
    real most = 0;
    for (int k = 0; k < 480; k++) {
        fly(1.0 / 480, 1.0 / 480);
        most = real_max(most, fabs(energy(b) / had - 1));
    }
    return most;
}

// Rejects: a spin that is kept while the body turns away from it; a basis of the
// frame's start, by which a top gains half of its energy in ten seconds.
START_TEST(free_top_keeps_angular_momentum_and_energy)
{
    int b = throw_brick();
    begin_substeps();
    vec3 was = angular(b);
    real had = energy(b), first = energy_off(b, had), last = 0;
    for (int second = 1; second < 10; second++) last = energy_off(b, had);
    real off = vec3_distance(angular(b), was) / vec3_length(was);
    ck_assert_msg(off <= 1e-13, "angular momentum is off by %g", off);
    ck_assert_msg(first <= 1e-3 && last <= 1.1 * first,
                  "energy is off by %g, and then by %g", first, last);
}
END_TEST

static rigid_frame flown(real h)
{
    begin(world_options_default());
    int b = throw_brick();
    begin_substeps();
    fly(h, 1);
    return probe_frame(&w, b);
}

static real apart(const rigid_frame *a, const rigid_frame *b)
{
    real most = vec3_distance(a->center, b->center);
    for (int i = 0; i < FOUR_AXES; i++)
        most = real_max(most, vec3_distance(a->axis[i], b->axis[i])
                              / vec3_length(b->axis[i]));
    return most;
}

// Rejects: order 1; a way that depends on how often it is divided.
START_TEST(half_the_substep_has_a_quarter_of_the_error)
{
    rigid_frame exact = flown(1.0 / 30720);
    real was = 0;
    for (int n = 240; n <= 1920; n *= 2) {
        rigid_frame now = flown(1.0 / n);
        real off = apart(&now, &exact);
        if (n > 240)
            ck_assert_msg(was / off > 3.8 && was / off < 4.2,
                          "%d substeps a second: off by %g, before by %g", n,
                          off, was);
        was = off;
    }
}
END_TEST

// Rejects: a spin that is kept, or turned with the body.
START_TEST(what_is_displaced_keeps_its_angular_momentum)
{
    for (int n = 0; n < 100; n++) {
        begin(world_options_default());
        int b = add(&brick, anywhere(3, 2, 20));
        begin_substeps();
        vec3 was = angular(b), way;
        motion u = *probe_velocity(&w, b), *d = probe_move(&w, b);
        rigid_frame at = probe_start(&w, b)->frame;
        for (int i = 0; i < MOTIONS; i++) d->of[i] = 0.1 * random_real(&seed);
        way = vec3_make(d->of[0], d->of[1], d->of[2]);
        rigid_frame there = probe_frame(&w, b);
        ck_assert_int_eq(advance_end(&w), 0);
        for (int i = 0; i < MOTIONS; i++) ck_assert(d->of[i] == 0);
        for (int i = 0; i < MOTION_TURN; i++)
            ck_assert(probe_velocity(&w, b)->of[i] == u.of[i]);
        near_vec3(probe_start(&w, b)->frame.center, vec3_add(at.center, way), 0);
        ck_assert(apart(&probe_start(&w, b)->frame, &there) <= 1e-14);
        ck_assert(vec3_distance(angular(b), was) <= 1e-13 * vec3_length(was));
    }
}
END_TEST

// --- what is driven ----------------------------------------------------------

// A rod of 6 m that turns about its middle, in substeps of many lengths.
// Rejects: a clock that begins again with every substep; arcs that are added up;
// what contacts did to it.
START_TEST(driven_body_is_where_its_clock_says)
{
    int b = add_at(&rod, 1, 2, 3);
    const real spin = 7, speed = 2;
    world_set_kind(&w, b, BODY_KINEMATIC);
    world_set_velocity(&w, b, vec3_make(0, 0, speed), vec3_make(0, spin, 0));
    begin_substeps();
    vec3 arm = vec3_sub(vertex_of(b, 7), vec3_make(1, 2, 3));
    real seconds = 0;
    for (int k = 0; k < 100; k++) {
        real h = 1e-3 * (1 + k % 7);
        seconds += h;
        probe_velocity(&w, b)->of[k % MOTIONS] += 3;
        advance_bodies(&w, h);
        advance_mark(&w);
        real c = cos(spin * seconds), s = sin(spin * seconds);
        vec3 far = { 1 + c * arm.x + s * arm.z, 2 + arm.y,
                     3 + speed * seconds + c * arm.z - s * arm.x };
        rigid_frame f = probe_frame(&w, b);
        vec3 got = frame_point(&f, w.body[b].rigid->local[7]);
        // The series that is left out turns each third of a radian by 4.3e-9.
        near_vec3(got, far, 3 * 4.3e-9 * (1 + 3 * spin * seconds));
    }
}
END_TEST

// --- what is done again ------------------------------------------------------

typedef struct {
    solver_body now;
    motion velocity, moved;
} state;

enum { SOME = 6 };

static void copy(state of[SOME])
{
    memset(of, 0, SOME * sizeof *of);
    for (int b = 0; b < SOME; b++) {
        memcpy(&of[b].now, probe_start(&w, b), sizeof of[b].now);
        memcpy(&of[b].velocity, probe_velocity(&w, b), sizeof of[b].velocity);
        memcpy(&of[b].moved, probe_move(&w, b), sizeof of[b].moved);
    }
}

// One of them is driven.
// Rejects: a clock, a displacement or a spin that is not put back.
START_TEST(a_substep_that_is_done_again_leaves_bodies_where_they_were)
{
    static state was[SOME], then[SOME], now[SOME];
    for (int b = 0; b < SOME; b++) add(&brick, anywhere(3, 2, 20));
    world_set_kind(&w, SOME - 1, BODY_KINEMATIC);
    world_set_velocity(&w, SOME - 1, vec3_make(1, 2, 3), vec3_make(3, 2, 1));
    begin_substeps();
    advance_bodies(&w, 0.002);
    for (int b = 0; b < SOME - 1; b++)
        for (int i = 0; i < MOTIONS; i++)
            probe_move(&w, b)->of[i] = 0.01 * random_real(&seed);
    advance_mark(&w);
    copy(was);
    advance_bodies(&w, 0.003);
    copy(then);
    ck_assert(memcmp(was, then, sizeof was) != 0);
    for (int k = 0; k < 3; k++) {
        advance_back(&w);
        copy(now);
        ck_assert(memcmp(was, now, sizeof was) == 0);
        advance_bodies(&w, k < 2 ? 0.001 : 0.003);
    }
    copy(now);
    ck_assert(memcmp(then, now, sizeof now) == 0);
}
END_TEST

// Rejects: a body that is lost, and takes its particles along; one that stops
// others.
START_TEST(what_is_lost_stands_where_it_did)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int n = 0; n < 3 * MOTIONS; n++) {
        begin(world_options_default());
        for (int b = 0; b < 2; b++) add(&brick, anywhere(3, 2, 20));
        begin_substeps();
        rigid_frame was = probe_start(&w, 0)->frame;
        advance_bodies(&w, 0.002);
        probe_velocity(&w, 0)->of[n % MOTIONS] = bad[n / MOTIONS];
        advance_bodies(&w, 0.002);
        vec3 u = vec3_make(probe_velocity(&w, 1)->of[0], 0, 0);
        ck_assert_int_eq(advance_end(&w), 1);
        ck_assert(memcmp(&probe_start(&w, 0)->frame, &was, sizeof was) == 0);
        for (int i = 0; i < MOTIONS; i++)
            ck_assert(probe_velocity(&w, 0)->of[i] == 0);
        ck_assert(probe_velocity(&w, 1)->of[0] == u.x);
        advance_write(&w);
        for (int i = 0; i < FOUR; i++)
            ck_assert(vec3_is_finite(particle_of(0, i)->position)
                      && vec3_is_finite(particle_of(0, i)->previous));
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        free_top_keeps_angular_momentum_and_energy,
        half_the_substep_has_a_quarter_of_the_error,
        what_is_displaced_keeps_its_angular_momentum,
        driven_body_is_where_its_clock_says,
        a_substep_that_is_done_again_leaves_bodies_where_they_were,
        what_is_lost_stands_where_it_did,
        NULL
    };
    return suite_run((suite){
        .name = "advance", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
