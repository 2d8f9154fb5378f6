// check_capsule.c - balls and capsules, as shapes.

#include "expect.h"
#include "capsule.h"
#include "scarce.h"
#include "suite.h"
#include "validate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const real TINY = 1e-13;

// The core of a capsule is an edge that leads to its other end from either.
START_TEST(core_of_a_capsule_is_an_edge)
{
    shape s;
    expect_ok(shape_capsule(&s, 2, 1, 1));
    ck_assert_int_eq(s.mesh.edges, 1);
    for (int v = 0; v < 2; v++) {
        int h = s.mesh.vertex_half[v];
        ck_assert_int_eq(s.mesh.half[h].origin, v);
        ck_assert_int_eq(mesh_target(&s.mesh, h), 1 - v);
        ck_assert_int_eq(mesh_around(&s.mesh, h), h);
    }
    ck_assert(s.at[0].y == -1 && s.at[1].y == 1);
    shape_free(&s);
}
END_TEST

// Rejects: a skin with holes or cracks, one that looks inwards, one that is
// not the body's surface.
static void expect_skin(const shape *s, real volume)
{
    struct skin k = shape_skin(s);
    mesh m;
    expect_ok(mesh_build(&m, k.points,
                         (const int (*)[3])(void *)k.face, k.faces));
    expect_ok(mesh_validate(&m));
    ck_assert_int_eq(mesh_euler(&m), 2);
    real inside = mesh_volume(&m, k.at) / volume;
    ck_assert_msg(inside > .93 && inside < 1, "%g of the volume", inside);
    real half = s->at[s->particles - 1].y;
    for (int i = 0; i < k.points; i++) {
        vec3 x = k.at[i];
        real y = fmax(fabs(x.y) - half, 0);
        near_relative(sqrt(x.x * x.x + y * y + x.z * x.z), s->round, TINY);
    }
    mesh_free(&m);
}

START_TEST(skin_is_closed_and_on_the_surface)
{
    real pi = acos(-1);
    shape s;
    expect_ok(shape_sphere(&s, 2, 1));
    expect_skin(&s, 4 * pi * 8 / 3);
    shape_free(&s);
    expect_ok(shape_capsule(&s, 3, .5, 1));
    expect_skin(&s, pi * (.25 * 3 + 4 * .125 / 3));
    shape_free(&s);
    // Of a shape that is not round it is the mesh.
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 1));
    struct skin k = shape_skin(&s);
    ck_assert(k.points == 8 && k.faces == 12 && k.at == s.at
              && k.face == s.face);
    shape_free(&s);
}
END_TEST

START_TEST(sizes_out_of_range_are_refused)
{
    shape s;
    expect_why(shape_sphere(&s, 0, 1), "the radius is 0 m: it must be a number "
               "from 1e-30 to 1e+30");
    ck_assert(!s.at && !s.skin.at && s.particles == 0);
    expect_why(shape_sphere(&s, (real)NAN, 1), "the radius is nan m: it must be a "
               "number from 1e-30 to 1e+30");
    expect_why(shape_sphere(&s, 1, -2), "the mass is -2 kg: it must be a "
               "number from 1e-30 to 1e+30");
    expect_why(shape_capsule(&s, -1, 1, 1), "the length is -1 m: it must be a "
               "number from 1e-30 to 1e+30");
    expect_why(shape_capsule(&s, 1, HUGE_VAL, 1), "the radius is inf m: it "
               "must be a number from 1e-30 to 1e+30");
    ck_assert(!s.at && !s.skin.at && s.particles == 0 && s.round == 0);
}
END_TEST

START_TEST(refused_memory_leaves_nothing)
{
    bool done = false;
    for (int left = 0; !done; left++) {
        shape s;
        long before = blocks_held;
        mallocs_left = left;
        status made = shape_capsule(&s, 1, 1, 1);
        mallocs_left = INT_MAX;
        done = made.ok;
        if (done) shape_free(&s);
        long held = blocks_held;
        ck_assert_int_eq(held, before);
        ck_assert_int_lt(left, 1000);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        core_of_a_capsule_is_an_edge,
        skin_is_closed_and_on_the_surface,
        sizes_out_of_range_are_refused,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){ .name = "capsule", .tests = tests });
}
