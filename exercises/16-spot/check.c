// check.c - tests of the exercise 16/spot.

#include "expect.h"
#include "random.h"
#include "spot.h"
#include "suite.h"

#include <check.h>

static const real ROUNDING = 1e-13;     // of lengths and masses about 1
static const vec3 UP = { 0, 1, 0 };
static particle p[6];
static const spot TRIANGLE = { 3, { 0, 1, 2 }, { 1 / 3.0, 1 / 3.0, 1 / 3.0 } };
static const spot CORNER = { 1, { 3 }, { 1 } };
static const spot EDGE = { 2, { 3, 4 }, { 0.25, 0.75 } };

// A triangle of 1 kg a corner in the plane y = 0, the spot's other particles
// below its middle.  Nothing has moved.
static void lay(real below)
{
    const vec3 at[6] = { { 2, 0, 0 }, { -1, 0, 1.5 }, { -1, 0, -1.5 }, { 0, -below, 0 },
                         { 0, -below, 0 }, { 0, -below, 0 } };
    for (int i = 0; i < 6; i++) p[i] = (particle){ .position = at[i], .previous = at[i], .inverse_mass = 1 };
}

START_TEST(middle_of_a_triangle_weighs_as_three)
{
    // Rejects: weights that count once, a mean of the masses.
    lay(1);
    near_vec3(spot_position(p, &TRIANGLE), vec3_make(0, 0, 0), ROUNDING, "middle of the triangle");
    near(spot_answer(p, &TRIANGLE), 1 / 3.0, ROUNDING, "1/kg, of three particles of 1 kg in their middle",
         "Each weight counts twice: in what a particle gets, and in how its move counts.");
    near(spot_answer(p, &EDGE), 0.25 * 0.25 + 0.75 * 0.75, ROUNDING, "1/kg, nearer to one end of an edge");
    near(spot_answer(p, &CORNER), 1, ROUNDING, "1/kg, of one particle");
}
END_TEST

START_TEST(spots_part_to_their_distance)
{
    // The triangle is three times as heavy: it goes a quarter of the way.
    // Rejects: half of the way each, a move that ignores one of the two.
    lay(0.6);
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0);
    near(spot_position(p, &TRIANGLE).y, 0.1, ROUNDING, "height of the triangle", "A quarter of 0.4 m.");
    near(spot_position(p, &CORNER).y, -0.9, ROUNDING, "height of the corner below", "Three quarters of 0.4 m.");
    near(p[1].position.y, 0.1, ROUNDING, "height of one corner of the triangle", "All three share alike.");
}
END_TEST

START_TEST(corner_that_is_nearer_goes_further)
{
    // Rejects: equal shares for the ends of an edge.
    lay(0.5);
    spots_part(p, &TRIANGLE, &EDGE, UP, 1, 0);
    real far = -0.5 - p[3].position.y, close = -0.5 - p[4].position.y;
    near(close / far, 3, 1e-12, "move of the nearer end over that of the other", "Its weight is 0.75, that of the other 0.25.");
    near(spot_position(p, &TRIANGLE).y - spot_position(p, &EDGE).y, 1, ROUNDING, "distance (m)");
}
END_TEST

START_TEST(what_is_apart_stays)
{
    // Rejects: contacts that pull, friction without a push.
    lay(1.5);
    p[3].previous.x = -1;
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0.5);
    near_vec3(p[3].position, vec3_make(0, -1.5, 0), 0, "corner that is far enough", "It was 1.5 m off, and wants 1.");
    near_vec3(p[0].position, vec3_make(2, 0, 0), 0, "corner of the triangle");
}
END_TEST

START_TEST(friction_takes_back_what_slid_within_the_cone)
{
    // Both slide; what counts is their difference.  0.4 m are pushed.
    // Rejects: the slide of one alone, all of it, the part along the normal.
    lay(0.6);
    p[3].previous = vec3_make(-0.1, -0.1, 0.05);
    for (int i = 0; i < 3; i++) p[i].previous.x += 0.05;
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0.9);
    vec3 slid = vec3_sub(spot_position(p, &TRIANGLE), p[3].position);
    near_vec3(slid, vec3_make(0.15, 1, -0.05), 1e-12, "way from the corner to the triangle",
              "All of the slide, 0.16 m, is less than 0.9 times 0.4 m: it goes.");
    lay(0.6);
    p[3].previous.x = -1;
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0.5);
    near(spot_position(p, &TRIANGLE).x - p[3].position.x, 0.2, ROUNDING, "m of slide taken back",
         "Half of the 0.4 m that were pushed, and no more.");
}
END_TEST

START_TEST(momentum_stays)
{
    // Any masses, weights, slides and normals; the distance is right each time.
    // Rejects: shares without masses, friction on one of the two.
    unsigned long long seed = 4;
    for (int k = 0; k < 5000; k++) {
        spot s[2];
        for (int j = 0; j < 2; j++) {
            real x = random_fraction(&seed), y = random_fraction(&seed) * (1 - x);
            s[j] = (spot){ 3, { 3 * j, 3 * j + 1, 3 * j + 2 }, { x, y, 1 - x - y } };
        }
        for (int i = 0; i < 6; i++)
            p[i] = (particle){ .position = random_vec3(&seed, 1), .previous = random_vec3(&seed, 1),
                               .inverse_mass = random_between(&seed, 0.1, 4) };
        particle was[6];
        for (int i = 0; i < 6; i++) was[i] = p[i];
        vec3 normal = random_direction(&seed), sum = { 0, 0, 0 };
        spots_part(p, &s[0], &s[1], normal, 3, random_fraction(&seed));
        near(vec3_dot(normal, vec3_sub(spot_position(p, &s[0]), spot_position(p, &s[1]))), 3, 1e-11, "distance (m)");
        for (int i = 0; i < 6; i++) {
            sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass, vec3_sub(p[i].position, was[i].position));
            near_vec3(p[i].previous, was[i].previous, 0, "previous", "Only position changes.");
        }
        near_vec3(sum, vec3_make(0, 0, 0), 1e-11, "kg m, that all six have moved together", "What one gets the other loses.");
    }
}
END_TEST

START_TEST(pins_do_not_move)
{
    // Rejects: 0 / 0, a pinned corner that is pushed.
    lay(0.6);
    p[0].inverse_mass = 0;
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0);
    near(p[0].position.y, 0, 0, "height of a pinned corner");
    near(spot_position(p, &TRIANGLE).y - p[3].position.y, 1, ROUNDING, "distance (m)", "The others have to go further.");
    lay(0.6);
    for (int i = 0; i < 4; i++) p[i].inverse_mass = 0;
    spots_part(p, &TRIANGLE, &CORNER, UP, 1, 0.5);
    near_vec3(p[3].position, vec3_make(0, -0.6, 0), 0, "pinned corner below a pinned triangle", "0 / 0 is NaN.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        middle_of_a_triangle_weighs_as_three,
        spots_part_to_their_distance,
        corner_that_is_nearer_goes_further,
        what_is_apart_stays,
        friction_takes_back_what_slid_within_the_cone,
        momentum_stays,
        pins_do_not_move,
        NULL
    };
    return suite_run((suite){ .name = "spot", .tests = tests });
}
