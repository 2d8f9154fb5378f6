// check.c - tests of the exercise 13/plain.

#include "shared.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some hundred roundings of numbers of about 10.
static const real ROUNDING = 1e-12;

// m/s, of a box that slides: the first step is cold, and friction begins before
// the push along the normal is what it should be.
static const real SETTLING = 1e-4;

static const vec3 NONE = { 0, 0, 0 }, UP = { 0, 1, 0 };
static const real H = 1.0 / 60, G = 9.81;

enum { BODIES = 11, POINTS = 4 * BODIES };

static solid body[BODIES];      // number 0 never moves
static touch t[POINTS];
static int   bodies, points;

// A box of those sides, its own axes along the world's.
static int add_box(vec3 side, real mass)
{
    real x = side.x * side.x, y = side.y * side.y, z = side.z * side.z;
    body[bodies] = (solid){ .inverse_mass = 1 / mass,
        .inverse = { { 12 / (mass * (y + z)), 0, 0 },
                     { 0, 12 / (mass * (x + z)), 0 },
                     { 0, 0, 12 / (mass * (x + y)) } } };
    return bodies++;
}

static void clear(void)
{
    body[0] = (solid){ .inverse_mass = 0 };
    bodies = 1;
    points = 0;
}

// A box lies on another of the same sides, in its four lower corners; on number
// 0, whose centre is below, it lies as well.
static void lay_on(int a, int b, vec3 side, real friction)
{
    for (int i = 0; i < 4; i++) {
        real x = (i & 1 ? 0.5 : -0.5) * side.x;
        real z = (i & 2 ? 0.5 : -0.5) * side.z;
        t[points++] = (touch){ .a = a, .b = b, .ra = { x, -side.y / 2, z },
                               .rb = { x, side.y / 2, z }, .normal = UP,
                               .friction = friction };
    }
}

static void fall(vec3 gravity)
{
    for (int i = 1; i < bodies; i++)
        body[i].velocity = vec3_add_scaled(body[i].velocity, H, gravity);
}

// What the points between two bodies give, in sum.
static real load_of(int a)
{
    real sum = 0;
    for (int i = 0; i < points; i++) if (t[i].a == a) sum += t[i].push;
    return sum;
}

// Ten cubes of 1 m and 3 kg without friction, number 1 at the bottom.
static const real MASS = 3;
static void pile(void)
{
    vec3 side = { 1, 1, 1 };
    clear();
    for (int i = 1; i <= 10; i++) lay_on(add_box(side, MASS), i - 1, side, 0);
}

// The largest error of all loads, as a share of the weight of one cube.
static real worst_load(void)
{
    real worst = 0;
    for (int i = 1; i <= 10; i++) {
        real wanted = (11 - i) * MASS * G * H;
        worst = fmax(worst, fabs(load_of(i) - wanted) / (MASS * G * H));
    }
    return worst;
}

START_TEST(corner_of_a_cube_weighs_a_quarter)
{
    // I = m/6; the corner has a lever of 1/2 about two axes: K = 1/m + 6/m
    // (1/4 + 1/4) = 4/m.  A small cube at rest on a corner of a large one adds
    // its own K. Rejects: no turning; the inverse forgotten; one body for
    // both.
    clear();
    vec3 corner = { 0.5, -0.5, 0.5 };
    int a = add_box(vec3_make(1, 1, 1), 2), b = add_box(vec3_make(1, 1, 1), 6);
    touch ground = { .a = a, .b = 0, .ra = corner, .normal = UP };
    near(touch_mass(body, &ground, UP), 0.5, ROUNDING, "kg, on the ground");
    touch both = { .a = a, .b = b, .ra = corner,
                   .rb = vec3_scale(-1, corner), .normal = UP };
    near(touch_mass(body, &both, UP), 1 / (4 / 2.0 + 4 / 6.0), ROUNDING,
         "kg, on another cube");
    // Along x the lever is the same, along the diagonal there is none.
    near(touch_mass(body, &ground, vec3_unit(corner)), 2, ROUNDING,
         "kg, through the centre");
}
END_TEST

START_TEST(open_gap_closes_and_no_further)
{
    // A ball-like box without a lever nears at 1 m/s; its gap is what half a
    // step closes.  Rejects: it is stopped too early; the gap is not looked
    // at.
    clear();
    int a = add_box(vec3_make(1, 1, 1), 2);
    t[points++] = (touch){ .a = a, .b = 0, .ra = { 0, -0.5, 0 }, .normal = UP,
                           .gap = 0.5 * H };
    body[a].velocity = vec3_make(0, -1, 0);
    touches_solve(body, t, points, H, 1);
    near(body[a].velocity.y, -0.5, ROUNDING, "m/s afterwards");
    near(t[0].push, 1, ROUNDING, "kg m/s given");
    // Too far to be reached: nothing is given.
    t[0].gap = 2 * H;
    t[0].push = 0;
    touches_solve(body, t, points, H, 3);
    near(body[a].velocity.y, -0.5, ROUNDING, "m/s, when it is far");
    near(t[0].push, 0, 0, "kg m/s given, when it is far");
}
END_TEST

START_TEST(overlap_opens_by_a_fifth)
{
    clear();
    int a = add_box(vec3_make(1, 1, 1), 2);
    t[points++] = (touch){ .a = a, .b = 0, .ra = { 0, -0.5, 0 }, .normal = UP,
                           .gap = -0.01 };
    body[a].velocity = vec3_make(0, -1, 0);
    touches_solve(body, t, points, H, 1);
    near(body[a].velocity.y, 0.2 * 0.01 / H, ROUNDING, "m/s afterwards");
}
END_TEST

START_TEST(nothing_pulls)
{
    // Rejects: a contact that holds on to what leaves.
    clear();
    int a = add_box(vec3_make(1, 1, 1), 2);
    lay_on(a, 0, vec3_make(1, 1, 1), 0.5);
    body[a].velocity = vec3_make(0.3, 1, 0);
    touches_solve(body, t, points, H, 10);
    near_vec3(body[a].velocity, vec3_make(0.3, 1, 0), 0, "m/s of what leaves");
}
END_TEST

START_TEST(too_much_is_given_back)
{
    // The last step pushed three times as hard as this one needs.  Rejects: the
    // change is clamped, and not the sum.
    clear();
    vec3 side = { 1, 0.2, 1 };
    int a = add_box(side, 2);
    lay_on(a, 0, side, 0);
    for (int i = 0; i < points; i++) t[i].push = 3 * 2 * G * H / 4;
    fall(vec3_make(0, -G, 0));
    touches_warm(body, t, points);
    near(body[a].velocity.y, 2 * G * H, ROUNDING, "m/s after the warm start");
    touches_solve(body, t, points, H, 200);
    near(body[a].velocity.y, 0, 1e-9, "m/s after 200 iterations");
    near(load_of(a), 2 * G * H, 1e-9, "kg m/s, the weight of a step");
}
END_TEST

START_TEST(pile_of_ten_holds_its_weights)
{
    // The cubes above the k-th touch weigh n m g: the impulses are n m g h.
    // Rejects: iterations that do not see what the one before has done.
    pile();
    fall(vec3_make(0, -G, 0));
    touches_warm(body, t, points);
    touches_solve(body, t, points, H, 1000);
    near(worst_load(), 0, 1e-8, "error of a load, in weights of a cube");
    for (int i = 1; i <= 10; i++)
        near(vec3_length(body[i].velocity), 0, 1e-8, "m/s of a cube");
}
END_TEST

START_TEST(warm_start_converges_where_cold_does_not)
{
    // Ten iterations a step, for 10 s; where the cubes are stays as it is. 
    // Cold, the pile sinks at a steady speed, for ever.  Rejects: impulses
    // that are remembered and not given; given and forgotten.
    for (int warm = 0; warm < 2; warm++) {
        pile();
        for (int step = 0; step < 600; step++) {
            fall(vec3_make(0, -G, 0));
            for (int i = 0; i < points && !warm; i++) {
                t[i].push = 0;
                t[i].rub = NONE;
            }
            touches_warm(body, t, points);
            touches_solve(body, t, points, H, 10);
        }
        real sinks = -body[10].velocity.y;
        if (warm) {
            near(worst_load(), 0, 1e-8, "error of a load, warm");
            near(sinks, 0, 1e-8, "m/s at which the top sinks, warm");
        } else
            ck_assert_msg(sinks > 0.1, "cold, the top sinks at %g m/s only: "
                          "is it cold?", sinks);
    }
}
END_TEST

// A flat box of 2 kg on a slope of that tangent, in the axes of the slope; down
// the slope is along (1, 0, 1), so that no axis is preferred.
static vec3 on_slope(real tangent, real friction)
{
    real cosine = 1 / sqrt(1 + tangent * tangent), sine = tangent * cosine;
    vec3 side = { 1, 0.2, 1 }, down = { sqrt(0.5), 0, sqrt(0.5) };
    clear();
    int a = add_box(side, 2);
    lay_on(a, 0, side, friction);
    for (int step = 0; step < 60; step++) {
        fall(vec3_add_scaled(vec3_scale(sine * G, down), -cosine * G, UP));
        touches_warm(body, t, points);
        touches_solve(body, t, points, H, 50);
    }
    near(load_of(a), 2 * G * H * cosine, 1e-6, "kg m/s along the normal");
    return body[a].velocity;
}

START_TEST(box_on_a_slope_obeys_coulomb)
{
    // After 1 s: at rest below friction, and g (sin - mu cos) beyond it.
    // Rejects: friction that is no sum; a square in place of the cone; friction
    // by the change of the push.
    const vec3 down = { sqrt(0.5), 0, sqrt(0.5) };
    near_vec3(on_slope(0.45, 0.5), NONE, 1e-6, "m/s where it holds");
    vec3 rub = NONE;
    for (int i = 0; i < points; i++) rub = vec3_add(rub, t[i].rub);
    near_vec3(rub, vec3_scale(-2 * G * H * 0.45 / sqrt(1.2025), down), 1e-6,
              "kg m/s of friction where it holds");
    near_vec3(on_slope(0.6, 0.5), vec3_scale(G * 0.1 / sqrt(1.36), down),
              SETTLING, "m/s where it slides");
    for (int i = 0; i < points; i++)
        near(vec3_length(t[i].rub), 0.5 * t[i].push, 1e-9,
             "kg m/s of friction of a point that slides");
}
END_TEST

START_TEST(momentum_and_angular_momentum_stay)
{
    // Two bodies meet in space, somewhere, in three points.  Rejects: a sign;
    // the arm of the other body; an impulse for one of the two.
    unsigned long long seed = 13;
    for (int round = 0; round < 200; round++) {
        clear();
        vec3 at[2], moved[2] = { NONE, NONE }, turned[2] = { NONE, NONE };
        real mass[2] = { 1, 5 };
        vec3 side = { 1, 2, 3 };
        for (int i = 0; i < 2; i++) {
            int k = add_box(side, mass[i]);
            at[i] = random_vec3(&seed, 1);
            body[k].velocity = random_vec3(&seed, 3);
            body[k].spin = random_vec3(&seed, 3);
        }
        for (int i = 0; i < 3; i++) {
            vec3 x = random_vec3(&seed, 1);
            t[points++] = (touch){ .a = 1, .b = 2, .ra = vec3_sub(x, at[0]),
                .rb = vec3_sub(x, at[1]), .normal = random_direction(&seed),
                .friction = 0.7 };
        }
        real given = 0;
        for (int after = 0; after < 2; after++) {
            if (after) touches_solve(body, t, points, H, 5);
            for (int i = 0; i < 2; i++) {
                const solid *s = &body[i + 1];
                vec3 p = vec3_scale(mass[i], s->velocity);
                vec3 own = { s->spin.x / s->inverse[0].x,
                             s->spin.y / s->inverse[1].y,
                             s->spin.z / s->inverse[2].z };
                moved[after] = vec3_add(moved[after], p);
                turned[after] = vec3_add(turned[after],
                                    vec3_add(own, vec3_cross(at[i], p)));
            }
        }
        for (int i = 0; i < points; i++) given += t[i].push;
        near_vec3(moved[1], moved[0], 1e-10, "momentum");
        near_vec3(turned[1], turned[0], 1e-10, "angular momentum");
        if (round == 0) ck_assert_msg(given > 0, "nothing was given");
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        corner_of_a_cube_weighs_a_quarter,
        open_gap_closes_and_no_further,
        overlap_opens_by_a_fifth,
        nothing_pulls,
        too_much_is_given_back,
        pile_of_ten_holds_its_weights,
        warm_start_converges_where_cold_does_not,
        box_on_a_slope_obeys_coulomb,
        momentum_and_angular_momentum_stay,
        NULL
    };
    return suite_run((suite){ .name = "plain", .tests = tests });
}
