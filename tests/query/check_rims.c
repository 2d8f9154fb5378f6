// check_rims.c - what the queries say of a cylinder, against prisms of very many
// sides.  Book: chapter 10.

#include "cylinder.h"
#include "expect.h"
#include "gjk.h"
#include "manifold.h"
#include "random.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>

enum { CORNERS = 2 + 2 * CYLINDER_SIDES, FINE = 2048 };
static unsigned long long seed = 1;

static real some(real from, real to)
{
    return random_between(&seed, from, to);
}

static vec3 some_unit(void)
{
    vec3 v;
    do v = vec3_make(some(-1, 1), some(-1, 1), some(-1, 1));
    while (vec3_length(v) > 1 || vec3_length(v) < 0.1);
    return vec3_unit(v);
}

// A cylinder somewhere, with its axis along `axis`.
typedef struct {
    shape s;
    vec3 at[CORNERS], axis, x, y, middle;
    real length, radius;
} drum;

static void place(drum *d, vec3 axis, vec3 middle)
{
    d->axis = axis;
    d->middle = middle;
    d->x = vec3_unit(vec3_cross(axis, fabs(axis.x) < 0.6 ? vec3_make(1, 0, 0)
                                                         : vec3_make(0, 1, 0)));
    d->y = vec3_cross(axis, d->x);
    for (int i = 0; i < CORNERS; i++) {
        vec3 p = d->s.at[i];
        vec3 q = vec3_add_scaled(middle, p.y, axis);
        q = vec3_add_scaled(q, p.x, d->x);
        d->at[i] = vec3_add_scaled(q, p.z, d->y);
    }
}

static void make(drum *d, real length, real radius)
{
    expect_ok(shape_cylinder(&d->s, length, radius, 1));
    d->length = length;
    d->radius = radius;
}

// m, how far it reaches along the unit vector v.
static real reach_along(const drum *d, vec3 v)
{
    real up = vec3_dot(v, d->axis);
    return vec3_dot(v, d->middle) + fabs(up) * d->length / 2
         + d->radius * sqrt(fmax(1 - up * up, 0));
}

// Rejects: a ball around the end of the axis, which is right only across it.
START_TEST(core_and_radius_reach_as_far_as_the_rim)
{
    int flat = 0;
    for (int k = 0; k < 3000; k++) {
        drum d;
        rim_core r;
        make(&d, some(0.1, 2), some(0.1, 2));
        place(&d, some_unit(), vec3_scale(5, some_unit()));
        vec3 v = some_unit();
        bool is_round = rim_towards(&d.s, d.at, v, &r);
        ck_assert(is_round == (fabs(vec3_dot(v, d.axis)) < sqrt(0.98)));
        flat += !is_round;
        if (is_round) {
            feature_point far = rim_furthest(&r, v);
            real reach = vec3_dot(feature_at(&far, r.at), v) + r.core.round;
            near_relative(reach, reach_along(&d, v), 1e-10);
            feature_point on = rim_feature(&r, &far);
            vec3 off = vec3_sub(feature_at(&on, d.at), feature_at(&far, r.at));
            ck_assert(vec3_length(off) < 1e-12);
        }
        shape_free(&d.s);
    }
    ck_assert_int_gt(flat, 10);
}
END_TEST

// Rejects: the prism's own gap, which is more.
START_TEST(gap_to_a_plane_is_that_of_the_rim)
{
    for (int k = 0; k < 3000; k++) {
        drum d;
        make(&d, some(0.1, 2), some(0.1, 2));
        place(&d, some_unit(), some_unit());
        vec3 n = some_unit();
        collider c = { &d.s, d.at, false };
        manifold m = manifold_on_plane(&c, n, -3, HUGE_VAL, 0);
        real least = 3 - reach_along(&d, vec3_scale(-1, n));
        real deepest = HUGE_VAL;
        ck_assert_int_ge(m.count, 1);
        for (int i = 0; i < m.count; i++)
            deepest = fmin(deepest, m.point[i].gap);
        bool is_end = fabs(vec3_dot(n, d.axis)) >= sqrt(0.98);
        near(deepest, least, is_end ? 1e-3 * d.radius : 1e-12);
        shape_free(&d.s);
    }
}
END_TEST

static void fine_prism(const drum *d, vec3 *at)
{
    for (int i = 0; i < FINE; i++) {
        real turn = 2 * acos(-1) * (i / 2) / (FINE / 2);
        vec3 p = vec3_add_scaled(d->middle, (i % 2 - 0.5) * d->length, d->axis);
        p = vec3_add_scaled(p, d->radius * cos(turn), d->x);
        at[i] = vec3_add_scaled(p, d->radius * sin(turn), d->y);
    }
}

// Of the larger radius; across its side it is exact, and at a rim the normal is that
// of the prism.  Rejects: the distance of the prism.
START_TEST(distance_of_two_is_that_of_prisms_with_very_many_sides)
{
    vec3 *a = malloc(FINE * sizeof *a), *b = malloc(FINE * sizeof *b);
    int sides = 0;
    real worst = 0, worst_side = 0;
    ck_assert(a && b);
    for (int k = 0; k < 4000; k++) {
        drum d, e;
        make(&d, some(0.1, 2), some(0.1, 1));
        make(&e, some(0.1, 2), some(0.1, 1));
        place(&d, some_unit(), vec3_make(0, 0, 0));
        place(&e, some_unit(), vec3_scale(some(0.5, 2), some_unit()));
        fine_prism(&d, a);
        fine_prism(&e, b);
        gjk_result g = gjk_distance((hull){ a, FINE }, (hull){ b, FINE },
                                    HUGE_VAL, NULL);
        collider x = { &d.s, d.at, false }, y = { &e.s, e.at, false };
        query_cache none = { .count = 0 };
        query_result r = query_nearest(&x, &y, HUGE_VAL, &none);
        real size = fmax(d.radius, e.radius);
        if (g.status == GJK_APART && g.distance < 0.1 * size) {
            real off = fabs(r.at.gap - g.distance) / size;
            bool is_side = fabs(vec3_dot(r.normal, d.axis)) < 1e-6
                        && fabs(vec3_dot(r.normal, e.axis)) < 1e-6;
            sides += is_side;
            worst = fmax(worst, off);
            if (is_side) worst_side = fmax(worst_side, off);
        }
        shape_free(&d.s);
        shape_free(&e.s);
    }
    ck_assert_int_gt(sides, 10);
    ck_assert_msg(worst < 0.005 && worst_side < 2e-5, "%g %g", worst, worst_side);
    free(a);
    free(b);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        core_and_radius_reach_as_far_as_the_rim,
        gap_to_a_plane_is_that_of_the_rim,
        distance_of_two_is_that_of_prisms_with_very_many_sides,
        NULL
    };
    return suite_run((suite){ .name = "rims", .tests = tests, .seconds = 60 });
}
