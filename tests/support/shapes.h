// shapes.h - what tests expect of every shape.

#ifndef TUMBLE_TESTS_SHAPES_H
#define TUMBLE_TESTS_SHAPES_H

#include "body.h"
#include "expect.h"

#include <check.h>
#include <string.h>

// A few roundings of numbers near 1: sums of up to a thousand terms.
static const real ROUNDING = 1e-13;

static inline void expect_empty(const shape *s)
{
    static const shape empty = { 0 };
    ck_assert(s->particles == 0 && s->sticks == 0 && s->mesh.edges == 0);
    ck_assert(!s->at && !s->mass && !s->stick && !s->face && !s->mesh.half);
    ck_assert(s->radius == empty.radius);
    ck_assert(!s->angle && s->angles == 0 && s->columns == 0);
}

// ------------------------------------------------ what holds for every shape

static inline void expect_equal_masses(const shape *s, real mass)
{
    real sum = 0;
    vec3 moment = { 0, 0, 0 };
    for (int i = 0; i < s->particles; i++) {
        ck_assert(s->mass[i] == s->mass[0] && s->mass[i] > 0);
        sum += s->mass[i];
        moment = vec3_add_scaled(moment, s->mass[i], s->at[i]);
    }
    near_relative(sum, mass, s->particles * 1e-15);
    ck_assert(vec3_length(moment) <= ROUNDING * mass * s->radius);
}

static inline void expect_good_sticks(const shape *s)
{
    real shortest = (real)INFINITY;
    for (int k = 0; k < s->sticks; k++) {
        stick t = s->stick[k];
        ck_assert(t.a >= 0 && t.a < s->particles);
        ck_assert(t.b >= 0 && t.b < s->particles && t.a != t.b);
        ck_assert(t.kind == STICK_EXACT && t.rest_length > 0);
        near_relative(vec3_distance(s->at[t.a], s->at[t.b]), t.rest_length,
                    ROUNDING * s->radius / t.rest_length);
        if (t.rest_length < shortest) shortest = t.rest_length;
        for (int j = 0; j < k && s->sticks < 2000; j++) {
            stick u = s->stick[j];
            ck_assert_msg(!(t.a == u.a && t.b == u.b) &&
                          !(t.a == u.b && t.b == u.a),
                          "sticks %d and %d are the same", j, k);
        }
    }
    ck_assert(s->spacing == shortest);
}

static inline void expect_good_mesh(const shape *s)
{
    for (int f = 0; f < s->mesh.faces; f++) {
        int v[3];
        mesh_face(&s->mesh, f, v);
        ck_assert(memcmp(v, &s->face[3 * f], sizeof v) == 0);
    }
}

static inline int has_stick(const shape *s, int a, int b)
{
    for (int k = 0; k < s->sticks; k++)
        if ((s->stick[k].a == a && s->stick[k].b == b) ||
            (s->stick[k].a == b && s->stick[k].b == a)) return 1;
    return 0;
}

static inline void expect_sound(const shape *s, real mass)
{
    real farthest = 0;
    for (int i = 0; i < s->particles; i++) {
        ck_assert(vec3_is_finite(s->at[i]));
        farthest = fmax(farthest, vec3_length(s->at[i]));
    }
    ck_assert(s->radius == farthest);
    expect_equal_masses(s, mass);
    expect_good_sticks(s);
    if (s->kind != SHAPE_ROPE) expect_good_mesh(s);
}

#endif
