// check_scene.c - is a scene what its description says?
// Book: chapter 9.

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "scarce.h"
#include "scene.h"
#include "suite.h"

// A chain of 50 links: fifty sums of numbers near 1.
#define ROUNDING 1e-13

static scene s;

static void build(scene_kind kind, scene_options what)
{
    status done = scene_build(&s, kind, what);
    ck_assert_msg(done.ok, "%s: %s", scene_name(kind), done.why);
}

static void add_box(vec3 sides)
{
    shape box;
    ck_assert(shape_box(&box, sides, 1).ok);
    ck_assert(scene_add_shape(&s, &box).ok);
    ck_assert_int_eq(box.particles, 0);
}

// Rejects: the velocity of the whole for every particle; spin x arm the wrong
// way round; axes taken for rows.
START_TEST(particles_start_where_the_placement_says)
{
    scene_init(&s);
    add_box(vec3_make(2, 4, 6));
    placement p = placement_at(vec3_make(10, 20, 30));
    // A quarter turn about z: the shape's x points along y.
    p.x = vec3_make(0, 1, 0);
    p.y = vec3_make(-1, 0, 0);
    p.velocity = vec3_make(1, 0, 0);
    p.spin = vec3_make(0, 0, 2);
    ck_assert(scene_add(&s, 0, p).ok);
    // Particle 7 stands at (1, 2, 3) of the shape: at (-2, 1, 3) of the middle.
    vec3 x = scene_position(&s, 0, 7), v = scene_velocity(&s, 0, 7);
    ck_assert(vec3_distance(x, vec3_make(8, 21, 33)) == 0);
    ck_assert(vec3_distance(v, vec3_make(1 - 2, -4, 0)) == 0);
    scene_free(&s);
}
END_TEST

// Rejects: a static body that is thrown.
START_TEST(static_bodies_have_no_velocity)
{
    scene_init(&s);
    add_box(vec3_make(1, 1, 1));
    placement p = placement_at(vec3_make(0, 0, 0));
    p.velocity = p.spin = vec3_make(1, 2, 3);
    p.is_static = true;
    ck_assert(scene_add(&s, 0, p).ok);
    ck_assert(vec3_length(scene_velocity(&s, 0, 3)) == 0);
    scene_free(&s);
}
END_TEST

// Rejects: a bad placement or plane that is added; one that ends the program.
START_TEST(bad_placements_and_planes_are_refused_with_a_sentence)
{
    scene_init(&s);
    add_box(vec3_make(1, 1, 1));
    placement bad[8];
    for (int k = 0; k < 8; k++) bad[k] = placement_at(vec3_make(0, 0, 0));
    bad[0].position.y = (real)NAN;
    bad[1].velocity.x = HUGE_VAL;
    bad[2].spin.z = (real)NAN;
    bad[3].y = vec3_make(0, 0, 1);
    bad[4].x = vec3_make(2, 0, 0);
    // Right-handed, but x or y is no unit, or they are not perpendicular.
    bad[5].x = vec3_make(2, 0, 0);
    bad[6].y = vec3_make(0, 2, 0);
    bad[7].y = vec3_make(0.6, 0.8, 0);
    for (int k = 5; k < 8; k++) bad[k].z = vec3_cross(bad[k].x, bad[k].y);
    for (int k = 0; k < 8; k++) {
        status done = scene_add(&s, 0, bad[k]);
        ck_assert(!done.ok);
        ck_assert_ptr_nonnull(strstr(done.why, "body 0"));
    }
    ck_assert_int_eq(s.bodies, 0);
    ck_assert(!scene_add_plane(&s, vec3_make(0, 0, 0), 1).ok);
    ck_assert(!scene_add_plane(&s, vec3_make(0, (real)NAN, 0), 1).ok);
    ck_assert(!scene_add_plane(&s, vec3_make(0, HUGE_VAL, 0), 1).ok);
    ck_assert(!scene_add_plane(&s, vec3_make(0, 1, 0), HUGE_VAL).ok);
    ck_assert_int_eq(s.planes, 0);
    scene_free(&s);
}
END_TEST

// Rejects: an offset that is not divided by the length of its normal.
// Rejects: a body whose particles fall into one point, for doubles are no finer
// there; a bound that is the same for large and small.
START_TEST(a_body_is_placed_no_further_than_its_sticks_bear)
{
    scene_init(&s);
    add_box(vec3_make(1, 1, 1));
    add_box(vec3_make(1000, 1000, 1000));
    const real far = 1e17, edge = 0.99e9;
    ck_assert(scene_add(&s, 0, placement_at(vec3_make(edge, 0, 0))).ok);
    ck_assert(scene_add(&s, 1, placement_at(vec3_make(0, 1000 * edge, 0))).ok);
    ck_assert(!scene_add(&s, 1, placement_at(vec3_make(0, 0, far))).ok);
    status done = scene_add(&s, 0, placement_at(vec3_make(0, -1.01e9, 0)));
    ck_assert(!done.ok && strstr(done.why, "body 2"));
    ck_assert_ptr_nonnull(strstr(done.why, "too coarse"));
    // What the bound is for: the length of a link there.
    vec3 a = scene_position(&s, 0, 0), b = scene_position(&s, 0, 1);
    ck_assert(fabs(vec3_distance(a, b) - 1) < 1e-6);
    ck_assert_int_eq(s.bodies, 2);
    scene_free(&s);
}
END_TEST

START_TEST(planes_are_made_units)
{
    scene_init(&s);
    ck_assert(scene_add_plane(&s, vec3_make(0, 2, 0), 6).ok);
    ck_assert(s.plane[0].normal.y == 1 && s.plane[0].offset == 3);
    scene_free(&s);
}
END_TEST

// Rejects: a list that writes beyond its end, or loses what it held, when it
// grows.
START_TEST(lists_grow_and_keep_what_they_hold)
{
    scene_init(&s);
    for (int k = 1; k <= 20; k++) add_box(vec3_make(k, 1, 1));
    for (int k = 0; k < 100; k++)
        ck_assert(scene_add(&s, k % 20, placement_at(vec3_make(k, 0, 0))).ok);
    for (int k = 0; k < 100; k++) {
        ck_assert(scene_add_pin(&s, k, k % 8).ok);
        ck_assert(scene_add_plane(&s, vec3_make(0, 1, 0), k).ok);
    }
    ck_assert_int_eq(s.shapes, 20);
    for (int k = 0; k < 100; k++) {
        ck_assert(s.body[k].where.position.x == k);
        ck_assert(scene_position(&s, k, 1).x == k + (k % 20 + 1) / 2.0);
        ck_assert_int_eq(s.pin[k].body, k);
        ck_assert_int_eq(s.pin[k].particle, k % 8);
        ck_assert(s.plane[k].offset == k);
    }
    scene_free(&s);
    ck_assert_int_eq(s.bodies, 0);
    ck_assert_ptr_null(s.body);
}
END_TEST

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

// A list that is refused room keeps what it holds.
// Rejects: a realloc whose answer is taken for the list.
START_TEST(refused_room_leaves_the_lists_as_they_were)
{
    scene_init(&s);
    add_box(vec3_make(1, 1, 1));
    ck_assert(scene_add(&s, 0, placement_at(vec3_make(0, 0, 0))).ok);
    ck_assert(scene_add_pin(&s, 0, 3).ok);
    ck_assert(scene_add_plane(&s, vec3_make(0, 1, 0), 0).ok);
    shape more;
    ck_assert(shape_box(&more, vec3_make(1, 1, 1), 1).ok);
    mallocs_left = 0;
    bool added = scene_add_shape(&s, &more).ok;
    added |= scene_add(&s, 0, placement_at(vec3_make(1, 0, 0))).ok;
    added |= scene_add_pin(&s, 0, 4).ok;
    added |= scene_add_plane(&s, vec3_make(0, 1, 0), 1).ok;
    mallocs_left = INT_MAX;
    ck_assert(!added);
    ck_assert_int_eq(more.particles, 8);
    shape_free(&more);
    ck_assert_int_eq(s.shapes + s.bodies + s.pins + s.planes, 4);
    ck_assert_int_eq(s.pin[0].particle, 3);
    ck_assert(s.plane[0].normal.y == 1);
    scene_free(&s);
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
        particles_start_where_the_placement_says,
        static_bodies_have_no_velocity,
        bad_placements_and_planes_are_refused_with_a_sentence,
        a_body_is_placed_no_further_than_its_sticks_bear,
        planes_are_made_units,
        lists_grow_and_keep_what_they_hold,
        thrown_bodies_start_apart_and_inside,
        room_is_as_documented,
        cloth_starts_over_a_static_cube,
        rope_hangs_at_rest_from_two_pins,
        bad_options_are_refused_with_a_sentence,
        thrown_shape_is_taken_over_whatever_happens,
        every_refusal_of_memory_is_told_and_leaves_nothing,
        refused_room_leaves_the_lists_as_they_were,
        scenes_have_names,
        NULL
    };
    return suite_run((suite){ .name = "scene", .tests = tests });
}
