// check.c - tests of the exercise 15/impact.

#include "strike.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some roundings, and what a point may still close at when it has been stopped.
static const real STOPPED = 1e-8;

static const vec3 UP = { 0, 1, 0 };

static unsigned long long seed;
static solid box, floor_below, other;

// A box of those sides, its own axes along the world's.
static solid make_box(vec3 side, real mass)
{
    real x = side.x * side.x, y = side.y * side.y, z = side.z * side.z;
    return (solid){ .inverse_mass = 1 / mass,
        .inverse = { { 12 / (mass * (y + z)), 0, 0 },
                     { 0, 12 / (mass * (x + z)), 0 },
                     { 0, 0, 12 / (mass * (x + y)) } } };
}

static striking on_floor(real restitution)
{
    floor_below = (solid){ .inverse_mass = 0 };
    return (striking){ .a = &box, .b = &floor_below, .normal = UP,
                       .restitution = restitution };
}

static void add_point(striking *s, vec3 ra, vec3 rb)
{
    s->ra[s->points] = ra;
    s->rb[s->points++] = rb;
}

// A cube of 1 kg and 1 m comes down at 4 m/s on an edge, half a metre beside its
// middle; the edge has two ends.
// Rejects: a body that does not turn; restitution squared, or left out.
START_TEST(edge_of_a_cube_strikes_as_in_the_chapter)
{
    striking s = on_floor(0.5);
    box = make_box(vec3_make(1, 1, 1), 1);
    box.velocity = vec3_make(0, -4, 0);
    add_point(&s, vec3_make(-0.5, -0.5, 0), vec3_make(0, 0, 0));
    near(impact_mass(&s, 0), 0.4, 1e-14);
    impact_strike(&s);
    near_vec3(box.velocity, vec3_make(0, -1.6, 0), STOPPED);
    near_vec3(box.spin, vec3_make(0, 0, -7.2), STOPPED);
}
END_TEST

// Rejects: corners that strike once each, one after the other; a sum that pulls.
START_TEST(box_that_lands_flat_leaves_flat)
{
    striking s = on_floor(0.5);
    box = make_box(vec3_make(1, 1, 1), 1);
    box.velocity = vec3_make(0, -4, 0);
    for (int k = 0; k < 4; k++)
        add_point(&s, vec3_make(k % 2 - 0.5, -0.5, k / 2 - 0.5),
                  vec3_make(0, 0, 0));
    impact_strike(&s);
    near_vec3(box.velocity, vec3_make(0, 2, 0), STOPPED);
    near_vec3(box.spin, vec3_make(0, 0, 0), STOPPED);
}
END_TEST

// One end comes down, the other goes up by itself.
// Rejects: a point that is pulled; one that pushes though it parts.
START_TEST(what_parts_by_itself_is_left)
{
    striking s = on_floor(1), alone = on_floor(1);
    solid was = make_box(vec3_make(1, 1, 1), 1);
    was.spin = vec3_make(0, 0, 3);
    add_point(&s, vec3_make(-0.5, -0.5, 0), vec3_make(0, 0, 0));
    add_point(&s, vec3_make(0.5, -0.5, 0), vec3_make(0, 0, 0));
    add_point(&alone, vec3_make(-0.5, -0.5, 0), vec3_make(0, 0, 0));
    box = was;
    impact_strike(&alone);
    solid wanted = box;
    box = was;
    impact_strike(&s);
    near_vec3(box.velocity, wanted.velocity, STOPPED);
    near_vec3(box.spin, wanted.spin, STOPPED);
    // Both go up: nothing happens.
    box = was;
    box.velocity = vec3_make(0, 9, 0);
    impact_strike(&s);
    near_vec3(box.velocity, vec3_make(0, 9, 0), 0);
    near_vec3(box.spin, was.spin, 0);
}
END_TEST

// --- any two boxes ---------------------------------------------------------------

static vec3 any_side(void)
{
    real x = random_between(&seed, 0.3, 1), y = random_between(&seed, 0.3, 1);
    return vec3_make(x, y, random_between(&seed, 0.3, 1));
}

// m, from the centre of `other` to that of `box`.
static vec3 between;

// All points are at one height, half a metre below the centre of `box`.
static striking any_striking(real restitution)
{
    striking s = { .a = &box, .b = &other, .normal = UP,
                   .restitution = restitution };
    box = make_box(any_side(), random_between(&seed, 0.1, 10));
    other = make_box(any_side(), random_between(&seed, 0.1, 10));
    box.velocity = random_vec3(&seed, 5);
    box.spin = random_vec3(&seed, 5);
    other.velocity = random_vec3(&seed, 5);
    other.spin = random_vec3(&seed, 5);
    between = vec3_add(UP, random_vec3(&seed, 0.5));
    for (int k = 1 + random_below(&seed, 4); k > 0; k--) {
        vec3 ra = random_vec3(&seed, 0.5);
        ra.y = -0.5;
        add_point(&s, ra, vec3_add(ra, between));
    }
    return s;
}

static real parts(const striking *s, int k)
{
    vec3 a = vec3_add(box.velocity, vec3_cross(box.spin, s->ra[k]));
    vec3 b = vec3_add(other.velocity, vec3_cross(other.spin, s->rb[k]));
    return vec3_dot(UP, vec3_sub(a, b));
}

// The moment of inertia is diagonal.
static vec3 spin_momentum(const solid *s)
{
    return vec3_make(s->spin.x / s->inverse[0].x, s->spin.y / s->inverse[1].y,
                     s->spin.z / s->inverse[2].z);
}

static real energy(const solid *s)
{
    return vec3_dot(s->spin, spin_momentum(s)) / 2
         + vec3_length_squared(s->velocity) / s->inverse_mass / 2;
}

static vec3 momentum(void)
{
    return vec3_add(vec3_scale(1 / box.inverse_mass, box.velocity),
                    vec3_scale(1 / other.inverse_mass, other.velocity));
}

// About the centre of `other`.
static vec3 angular_momentum(void)
{
    vec3 of_box = vec3_cross(between,
                             vec3_scale(1 / box.inverse_mass, box.velocity));
    return vec3_add(of_box, vec3_add(spin_momentum(&box), spin_momentum(&other)));
}

// Rejects: restitution that acts while the others are still being stopped.
START_TEST(no_point_parts_more_slowly_than_restitution_asks)
{
    int alone = 0;
    seed = 1;
    for (int round = 0; round < 1000; round++) {
        striking s = any_striking(random_fraction(&seed));
        real closed[STRIKE_POINTS];
        for (int k = 0; k < s.points; k++) closed[k] = -parts(&s, k);
        impact_strike(&s);
        for (int k = 0; k < s.points; k++)
            ck_assert(!(closed[k] > 0)
                      || parts(&s, k) >= s.restitution * closed[k] - 1e-7);
        if (s.points > 1 || !(closed[0] > 0)) continue;
        near(parts(&s, 0), s.restitution * closed[0], STOPPED);
        alone++;
    }
    ck_assert_int_gt(alone, 50);
}
END_TEST

// Rejects: one body that gets no impulse, or gets it at the other's arm.
START_TEST(momentum_and_angular_momentum_stay)
{
    seed = 2;
    for (int round = 0; round < 1000; round++) {
        striking s = any_striking(random_fraction(&seed));
        vec3 p = momentum(), l = angular_momentum();
        impact_strike(&s);
        near_vec3(momentum(), p, 1e-10);
        near_vec3(angular_momentum(), l, 1e-10);
    }
}
END_TEST

// Rejects: impulses that were not found together; scaled by more than 1 + e.
START_TEST(no_impact_gives_energy_and_an_elastic_one_takes_none)
{
    seed = 3;
    for (int round = 0; round < 1000; round++) {
        striking s = any_striking(round % 2 ? 1 : random_fraction(&seed));
        real before = energy(&box) + energy(&other);
        impact_strike(&s);
        real after = energy(&box) + energy(&other);
        ck_assert(after <= before * (1 + 1e-7));
        if (round % 2) near(after, before, 1e-7 * before);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        edge_of_a_cube_strikes_as_in_the_chapter,
        box_that_lands_flat_leaves_flat,
        what_parts_by_itself_is_left,
        no_point_parts_more_slowly_than_restitution_asks,
        momentum_and_angular_momentum_stay,
        no_impact_gives_energy_and_an_elastic_one_takes_none,
        NULL
    };
    return suite_run((suite){ .name = "strike", .tests = tests });
}
