// shapes.h - what tests expect of every shape.

#ifndef TUMBLE_TESTS_SHAPES_H
#define TUMBLE_TESTS_SHAPES_H

#include "body.h"

#include <check.h>
#include <string.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))

// A few roundings of numbers near 1: sums of up to a thousand terms.
static const real ROUNDING = 1e-13;

static inline void expect_near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance * fabs(wanted),
                  "got %.17g, wanted %.17g", got, wanted);
}

static inline void expect_why(status s, const char *why)
{
    ck_assert_msg(!s.ok, "accepted, wanted: %s", why);
    ck_assert_msg(strcmp(s.why, why) == 0, "said: %s\nwanted: %s", s.why, why);
}

static inline void expect_ok(status s)
{
    ck_assert_msg(s.ok, "refused: %s", s.why);
}

static inline void expect_empty(const shape *s)
{
    static const shape empty = { 0 };
    ck_assert(s->particles == 0 && s->sticks == 0 && s->mesh.edges == 0);
    ck_assert(!s->at && !s->mass && !s->stick && !s->face && !s->ring_start);
    ck_assert(!s->ring && !s->mesh.half && s->radius == empty.radius);
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
    expect_near(sum, mass, s->particles * 1e-15);
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
        expect_near(vec3_distance(s->at[t.a], s->at[t.b]), t.rest_length,
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
    ck_assert_int_eq(s->ring_start[s->particles], 2 * s->mesh.edges);
    for (int f = 0; f < s->mesh.faces; f++) {
        int v[3];
        mesh_face(&s->mesh, f, v);
        ck_assert(memcmp(v, &s->face[3 * f], sizeof v) == 0);
    }
    // Every half-edge v -> w puts w once into the ring of v, and nothing else
    // is there.
    for (int h = 0; h < 2 * s->mesh.edges; h++) {
        int v = s->mesh.half[h].origin, found = 0;
        for (int k = s->ring_start[v]; k < s->ring_start[v + 1]; k++)
            found += s->ring[k] == mesh_target(&s->mesh, h);
        ck_assert_int_eq(found, 1);
    }
}

static inline int has_stick(const shape *s, int a, int b)
{
    for (int k = 0; k < s->sticks; k++)
        if ((s->stick[k].a == a && s->stick[k].b == b) ||
            (s->stick[k].a == b && s->stick[k].b == a)) return 1;
    return 0;
}

// Every link of the strands is a stick, as long as it says, and no stick is
// counted that is none of theirs.
static inline void expect_good_strands(const shape *s)
{
    int links = 0, highest = 0;
    for (int d = 0; d < s->directions; d++) {
        strands t = s->strand[d];
        ck_assert(t.lines >= 1 && t.particles >= 2);
        ck_assert_int_eq(t.lines * t.particles, s->particles);
        for (int l = 0; l < t.lines; l++)
            for (int k = 0; k + 1 < t.particles; k++, links++) {
                int a = l * t.across + k * t.along, b = a + t.along;
                if (b > highest) highest = b;
                ck_assert(a >= 0 && b < s->particles);
                expect_near(vec3_distance(s->at[a], s->at[b]), t.rest_length,
                            ROUNDING * s->radius / t.rest_length);
                if (s->sticks < 2000) ck_assert(has_stick(s, a, b));
            }
    }
    ck_assert_int_eq(links, s->on_strands);
    ck_assert_int_eq(highest, s->directions > 0 ? s->particles - 1 : 0);
    ck_assert_int_eq(s->directions, s->kind == SHAPE_ROPE ? 1
                                    : s->kind == SHAPE_CLOTH ? 2 : 0);
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
    expect_good_strands(s);
    if (s->kind != SHAPE_ROPE) expect_good_mesh(s);
}

#endif
