// check_experiments.c - are the paper's three experiments what they are said to be?
// Book: chapter 9.

#include <check.h>
#include <limits.h>
#include <string.h>

#include "experiments.h"
#include "scarce.h"
#include "suite.h"

// A chain of 50 links: fifty sums of numbers near 1.
#define ROUNDING 1e-13

static scene s;

static void build(scene_kind kind, scene_options what)
{
    status done = scene_build(&s, kind, what);
    ck_assert_msg(done.ok, "%s: %s", scene_name(kind), done.why);
}

// Rejects: bodies that overlap, or stick out of the room, at the start.
START_TEST(thrown_bodies_start_apart_and_inside)
{
    for (int bodies = 1; bodies <= 60; bodies++) {
        scene_options what = scene_options_default();
        what.bodies = bodies;
        build(SCENE_ROOM, what);
        ck_assert_int_eq(s.bodies, bodies);
        ck_assert_int_eq(s.planes, 6);
        for (int k = 0; k < bodies; k++) {
            vec3 x = s.body[k].where.position;
            real side = s.size / 2 - SCENE_BODY_RADIUS + 1e-9;
            ck_assert(fabs(x.x) <= side && fabs(x.z) <= side);
            ck_assert(fabs(x.y - s.size / 2) <= side);
            for (int j = 0; j < k; j++)
                ck_assert(vec3_distance(x, s.body[j].where.position)
                          >= 2 * SCENE_BODY_RADIUS - 1e-9);
        }
        scene_free(&s);
    }
}
END_TEST

// Rejects: another seed's room; a side that is not the documented one.
START_TEST(room_is_as_documented)
{
    scene_options what = scene_options_default();
    build(SCENE_ROOM, what);
    ck_assert(fabs(s.size - cbrt(0.317 * 50 / 0.15)) <= 1e-12);
    vec3 first = s.body[0].where.position;
    for (int k = 0; k < 50; k++) {
        vec3 v = s.body[k].where.velocity, w = s.body[k].where.spin;
        ck_assert(fabs(v.x) <= 5 && fabs(v.y) <= 5 && fabs(v.z) <= 5);
        ck_assert(fabs(w.x) <= 5 && fabs(w.y) <= 5 && fabs(w.z) <= 5);
    }
    scene_free(&s);
    build(SCENE_ROOM, what);
    ck_assert(vec3_distance(first, s.body[0].where.position) == 0);
    scene_free(&s);
    what.seed = 2;
    build(SCENE_ROOM, what);
    ck_assert(vec3_distance(first, s.body[0].where.position) > 1e-6);
    scene_free(&s);
}
END_TEST

// Rejects: a cube that moves; a cloth that touches it; stiff diagonals by
// default.
START_TEST(cloth_starts_over_a_static_cube)
{
    scene_options what = scene_options_default();
    for (int n = 2; n <= 42; n += 20) {
        what.cloth = n;
        build(SCENE_CLOTH_ON_CUBE, what);
        ck_assert_int_eq(s.bodies, 2);
        ck_assert(s.body[0].where.is_static && !s.body[1].where.is_static);
        const shape *cloth = scene_shape(&s, 1);
        ck_assert_int_eq(cloth->particles, n * n);
        for (int i = 0; i < 8; i++)
            ck_assert(scene_position(&s, 0, i).y <= 0.8 + ROUNDING);
        for (int i = 0; i < n * n; i++)
            ck_assert(scene_position(&s, 1, i).y >= 0.9 - ROUNDING);
        real soft = 1;
        for (int k = 0; k < cloth->sticks; k++)
            soft = fmin(soft, cloth->stick[k].stiffness);
        ck_assert(soft == 0.2);
        scene_free(&s);
    }
}
END_TEST

// The sum of the forces on a particle of a hanging chain is nothing: with links
// of one length, the difference of the slopes of neighbours is constant.
// Rejects: a parabola; a chain that is not as long as its links.
START_TEST(rope_hangs_at_rest_from_two_pins)
{
    build(SCENE_CLOTH_ON_ROPE, scene_options_default());
    const shape *rope = scene_shape(&s, 0);
    ck_assert_int_eq(s.pins, 2);
    ck_assert_int_eq(s.pin[0].particle, 0);
    ck_assert_int_eq(s.pin[1].particle, 50);
    vec3 first = scene_position(&s, 0, 0), last = scene_position(&s, 0, 50);
    ck_assert(fabs(last.x - first.x - 2.6) <= ROUNDING);
    ck_assert(fabs(first.y - 1.5) + fabs(last.y - 1.5) <= ROUNDING);
    real before = 0, rise = 0;
    for (int i = 0; i < 50; i++) {
        vec3 d = vec3_sub(scene_position(&s, 0, i + 1), scene_position(&s, 0, i));
        ck_assert(fabs(vec3_length(d) - 0.06) <= ROUNDING);
        ck_assert(d.z == 0);
        if (i == 1) rise = d.y / d.x - before;
        if (i > 1) ck_assert(fabs(d.y / d.x - before - rise) <= 1e-10);
        before = d.y / d.x;
    }
    ck_assert(vec3_length(scene_velocity(&s, 0, 20)) == 0);
    ck_assert_int_eq(rope->sticks, 50);
    scene_free(&s);
}
END_TEST

// Rejects: limits that are not kept; a scene half built.
START_TEST(bad_options_are_refused_with_a_sentence)
{
    struct { int bodies, cloth; double diagonal; const char *word; } bad[] = {
        { 0, 40, 0.2, "bodies" }, { 20001, 40, 0.2, "bodies" },
        { 50, 1, 0.2, "cloth" },  { 50, 513, 0.2, "cloth" },
        { 50, 40, 0, "diagonal" }, { 50, 40, 1.1, "diagonal" },
        { 50, 40, (real)NAN, "diagonal" },
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        scene_options what = scene_options_default();
        what.bodies = bad[k].bodies;
        what.cloth = bad[k].cloth;
        what.diagonal = bad[k].diagonal;
        status done = scene_build(&s, SCENE_ROOM, what);
        ck_assert(!done.ok);
        ck_assert_ptr_nonnull(strstr(done.why, bad[k].word));
        ck_assert_ptr_null(s.body);
        ck_assert_ptr_null(s.shape);
    }
}
END_TEST

// Rejects: a shape that is thrown and freed by its maker, too; one that is lost
// where the scene is refused.
START_TEST(thrown_shape_is_taken_over_whatever_happens)
{
    for (int bodies = 0; bodies < 2; bodies++) {
        shape box;
        scene_options what = scene_options_default();
        what.bodies = bodies;       // none are refused
        what.thrown = &box;
        long before = blocks_held;
        status made = shape_box(&box, vec3_make(0.5, 0.5, 0.5), 1);
        status done = scene_build(&s, SCENE_ROOM, what);
        int vertices = done.ok ? scene_shape(&s, 0)->particles : 8;
        scene_free(&s);
        long after = blocks_held;
        ck_assert(made.ok && done.ok == (bodies == 1));
        ck_assert_int_eq(box.particles, 0);
        ck_assert_int_eq(vertices, 8);
        ck_assert_int_eq(after, before);
    }
}
END_TEST

// Rejects: a malloc whose answer is not looked at; a scene half built of which
// something is lost.
START_TEST(every_refusal_of_memory_is_told_and_leaves_nothing)
{
    for (int kind = 0; kind < SCENES; kind++) {
        scene_options what = scene_options_default();
        what.bodies = what.cloth = 5;
        bool ok = false;
        for (int n = 0; n < 2000 && !ok; n++) {
            long before = blocks_held;
            mallocs_left = n;
            status done = scene_build(&s, (scene_kind)kind, what);
            mallocs_left = INT_MAX;
            ok = done.ok;
            long refused = blocks_held;
            scene_free(&s);
            long after = blocks_held;
            if (!ok) ck_assert_str_eq(done.why, "out of memory");
            if (!ok) ck_assert_int_eq(refused, before);
            ck_assert_int_eq(after, before);
        }
        ck_assert(ok);
    }
}
END_TEST

// Rejects: names that the command line does not know again.
START_TEST(scenes_have_names)
{
    ck_assert_str_eq(scene_name(SCENE_ROOM), "room");
    ck_assert_str_eq(scene_name(SCENE_CLOTH_ON_CUBE), "cloth-on-cube");
    ck_assert_str_eq(scene_name(SCENE_CLOTH_ON_ROPE), "cloth-on-rope");
    ck_assert_str_eq(scene_name(SCENES), "");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        thrown_bodies_start_apart_and_inside,
        room_is_as_documented,
        cloth_starts_over_a_static_cube,
        rope_hangs_at_rest_from_two_pins,
        bad_options_are_refused_with_a_sentence,
        thrown_shape_is_taken_over_whatever_happens,
        every_refusal_of_memory_is_told_and_leaves_nothing,
        scenes_have_names,
        NULL
    };
    return suite_run((suite){ .name = "experiments", .tests = tests });
}
