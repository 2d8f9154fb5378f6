// check_poses.c - are the errors of a pose what they were made to be?
// Book: chapter 9.

#include <check.h>

#include "poses.h"
#include "suite.h"

// Sums of a few numbers near 1.
#define ROUNDING 1e-12

enum { MOST = 2000 };

static scene s;
static vec3 at[MOST], before[MOST];

static void add(shape made, vec3 where, bool is_static)
{
    placement p = placement_at(where);
    p.is_static = is_static;
    ck_assert(scene_add_shape(&s, &made).ok);
    ck_assert(scene_add(&s, s.shapes - 1, p).ok);
}

static shape cube(real side)
{
    shape box;
    ck_assert(shape_box(&box, vec3_make(side, side, side), 8).ok);
    return box;
}

static shape sheet(int n, real side)
{
    shape cloth;
    ck_assert(shape_cloth(&cloth, n, n, side, side, 1, 0.2).ok);
    return cloth;
}

static poses measure(void)
{
    int count = 0;
    for (int b = 0; b < s.bodies; b++)
        for (int i = 0; i < scene_shape(&s, b)->particles; i++)
            at[count++] = scene_position(&s, b, i);
    return poses_measure(&s, at);
}

static bool is_near(real a, real b)
{
    return fabs(a - b) <= ROUNDING;
}

// Rejects: depths with the wrong sign; pairs that are not looked at.
START_TEST(overlap_is_the_deepest_of_all_pairs)
{
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), false);
    add(cube(1), vec3_make(5, 0, 0), false);
    ck_assert(measure().overlap == 0);
    add(cube(1), vec3_make(0.75, 0.1, 0.1), false);
    add(cube(1), vec3_make(5, 0.9, 0.1), false);
    poses m = measure();
    ck_assert(is_near(m.overlap, 0.25));
    ck_assert(m.finite && m.inside == 0 && m.behind == 0 && m.strain < 1e-12);
    scene_free(&s);
}
END_TEST

// Rejects: static bodies held against each other.
START_TEST(static_pairs_do_not_count)
{
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), true);
    add(cube(1), vec3_make(0.5, 0, 0), true);
    ck_assert(measure().overlap == 0);
    scene_free(&s);
}
END_TEST

START_TEST(depth_behind_planes_and_bodies_outside_are_told)
{
    scene_init(&s);
    ck_assert(scene_add_plane(&s, vec3_make(0, 1, 0), 0).ok);
    ck_assert(scene_add_plane(&s, vec3_make(1, 0, 0), -10).ok);
    add(cube(1), vec3_make(0, 0.375, 0), false);
    poses m = measure();
    ck_assert(is_near(m.behind, 0.125));
    ck_assert_int_eq(m.outside, 0);
    add(cube(1), vec3_make(-11, 3, 0), false);
    m = measure();
    ck_assert(is_near(m.behind, 1.5));
    ck_assert_int_eq(m.outside, 1);
    scene_free(&s);
}
END_TEST

// A sheet of 5 x 5 at half height of a cube: 3 x 3 of its particles are inside.
// Rejects: particles on the surface counted; triangles that only pass by.
START_TEST(particles_and_triangles_inside_are_counted)
{
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), true);
    add(sheet(5, 2), vec3_make(0, 0.25, 0), false);
    poses m = measure();
    ck_assert_int_eq(m.particles_in, 1);        // spacing 0.5: the middle one
    ck_assert(is_near(m.inside, 0.25));
    ck_assert_int_eq(poses_triangles_in(&s, at), 8);
    scene_free(&s);
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), true);
    add(sheet(5, 2), vec3_make(0, 0.5001, 0), false);
    ck_assert_int_eq(measure().particles_in, 0);
    ck_assert_int_eq(poses_triangles_in(&s, at), 0);
    scene_free(&s);
}
END_TEST

// Rejects: shear taken for strain; static bodies measured.
START_TEST(strain_is_that_of_stiff_sticks)
{
    scene_init(&s);
    add(sheet(3, 2), vec3_make(0, 0, 0), false);
    measure();
    for (int i = 0; i < 9; i++) at[i].x *= 1.25;
    poses m = poses_measure(&s, at);
    ck_assert(is_near(m.strain, 0.25));
    // Six of the twelve links, and no diagonal.
    ck_assert(is_near(m.strain_rms, sqrt(0.25 * 0.25 / 2)));
    real slant = sqrt(1.25 * 1.25 + 1) / sqrt(2) - 1;
    ck_assert(is_near(m.shear, slant));
    scene_free(&s);
}
END_TEST

// A rope that is pushed through a sheet, and a sheet whose corner is.
// Rejects: crossings of neighbours counted; far ones not looked at.
START_TEST(crossings_are_counted)
{
    scene_init(&s);
    shape rope;
    ck_assert(shape_rope(&rope, 4, 4, 1).ok);
    add(sheet(5, 2), vec3_make(0, 0, 0), false);
    add(rope, vec3_make(0.1, 3, 0.2), false);
    measure();
    ck_assert_int_eq(poses_crossings(&s, at), 0);
    for (int i = 0; i < 5; i++) at[25 + i] = vec3_make(0.1, i - 1.5, 0.2);
    ck_assert_int_eq(poses_crossings(&s, at), 1);
    // The corner beside two sides, folded under and up through another cell.
    for (int i = 0; i < 5; i++) at[25 + i].y += 10;
    at[0] = vec3_make(0.3, 0.1, 0.35);
    ck_assert_int_ge(poses_crossings(&s, at), 0);
    at[1].y = at[5].y = at[6].y = -0.5;
    ck_assert_int_ge(poses_crossings(&s, at), 1);
    scene_free(&s);
}
END_TEST

// Rejects: a half that is missing; static bodies counted.
START_TEST(kinetic_energy_is_that_of_the_velocities)
{
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), false);
    add(cube(1), vec3_make(3, 0, 0), true);
    measure();
    for (int i = 0; i < 16; i++) before[i] = at[i];
    for (int i = 0; i < 16; i++) at[i].z += 0.5;
    ck_assert(is_near(poses_kinetic(&s, before, at, 0.25), 8 * 2.0 * 2 / 2));
    scene_free(&s);
}
END_TEST

// Rejects: NaN that passes for a good pose.
START_TEST(what_is_not_finite_is_told)
{
    scene_init(&s);
    add(cube(1), vec3_make(0, 0, 0), false);
    measure();
    at[3].x = (real)NAN;
    ck_assert(!poses_measure(&s, at).finite);
    scene_free(&s);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        overlap_is_the_deepest_of_all_pairs,
        static_pairs_do_not_count,
        depth_behind_planes_and_bodies_outside_are_told,
        particles_and_triangles_inside_are_counted,
        strain_is_that_of_stiff_sticks,
        crossings_are_counted,
        kinetic_energy_is_that_of_the_velocities,
        what_is_not_finite_is_told,
        NULL
    };
    return suite_run((suite){ .name = "poses", .tests = tests });
}
