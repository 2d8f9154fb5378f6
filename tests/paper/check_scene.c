// check_scene.c - is a scene what its description says?
// Book: chapter 9.

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "scarce.h"
#include "scene.h"
#include "suite.h"

static scene s;

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

// Rejects: a list of starts that is not looked at; a body that has one, and is thrown.
START_TEST(a_body_starts_where_its_list_says)
{
    scene_init(&s);
    add_box(vec3_make(1, 1, 1));
    placement p = placement_at(vec3_make(0, 0, 0));
    p.velocity = vec3_make(1, 2, 3);
    ck_assert(scene_add(&s, 0, p).ok);
    vec3 *start = malloc(8 * sizeof *start);
    for (int i = 0; i < 8; i++) start[i] = vec3_make(i, -i, 0);
    s.body[0].start = start;
    ck_assert(vec3_distance(scene_position(&s, 0, 5), start[5]) == 0);
    ck_assert(vec3_length(scene_velocity(&s, 0, 5)) == 0);
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

int main(void)
{
    const TTest *const tests[] = {
        particles_start_where_the_placement_says,
        static_bodies_have_no_velocity,
        a_body_starts_where_its_list_says,
        bad_placements_and_planes_are_refused_with_a_sentence,
        a_body_is_placed_no_further_than_its_sticks_bear,
        planes_are_made_units,
        lists_grow_and_keep_what_they_hold,
        refused_room_leaves_the_lists_as_they_were,
        NULL
    };
    return suite_run((suite){ .name = "scene", .tests = tests });
}
