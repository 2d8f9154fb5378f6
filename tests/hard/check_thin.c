// check_thin.c - bullets, plates and cloth in the whole system.  Book: chapter
// 14.

#include <check.h>
#include <stdlib.h>

#include "ledger.h"
#include "random.h"
#include "step.h"
#include "suite.h"

// Sums over some hundred substeps, of metres.
#define ROUNDING 1e-9

static const vec3 ZERO = { 0, 0, 0 };

static world w;
static shape plate, bullet, cloth;

static void set_up(void)
{
    ck_assert(shape_box(&plate, vec3_make(1, 0.01, 1), 1).ok);
    ck_assert(shape_icosahedron(&bullet, 0.05, 0.05).ok);
    ck_assert(shape_cloth(&cloth, 21, 21, 1, 1, 0.2, 0.2).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&plate);
    shape_free(&bullet);
    shape_free(&cloth);
}

static void begin(world_options o)
{
    world_free(&w);
    ck_assert(world_init(&w, o).ok);
}

static world_options weightless(void)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    return o;
}

static void add(const shape *s, vec3 at, vec3 velocity, bool is_static)
{
    placement p = placement_at(at);
    p.velocity = velocity;
    p.is_static = is_static;
    ck_assert(world_add(&w, s, p, NULL).ok);
}

static vec3 middle(int b)
{
    const body *x = &w.body[b];
    vec3 sum = ZERO;
    for (int i = 0; i < FOUR; i++)
        sum = vec3_add_scaled(sum, 0.25, w.pool.at[x->first + i].position);
    return sum;
}

static vec3 speed(int b)
{
    const body *x = &w.body[b];
    vec3 sum = ZERO;
    for (int i = 0; i < FOUR; i++) {
        const particle *p = &w.pool.at[x->first + i];
        sum = vec3_add_scaled(sum, 0.25 / body_age(&w, b),
                              vec3_sub(p->position, p->previous));
    }
    return sum;
}

static void pin_corners(int cells)
{
    for (int k = 0; k < 4; k++)
        world_pin(&w, 0, (k & 1 ? cells : 0)
                          + (k & 2 ? cells * (cells + 1) : 0));
}

// A bullet at v, `away` m over the middle of a static plate.
static void shoot_down(world_options o, real away, vec3 v)
{
    begin(o);
    add(&plate, ZERO, ZERO, true);
    add(&bullet, vec3_make(0, away, 0), v, false);
}

// 100 m/s are 5/3 m a frame, 42 inner radii.  The frame of the impact is divided
// in four, all others are not: contacts found where the bullet will touch need
// no substeps beyond that.
// Rejects: substeps for what is fast, where only rigid bodies meet.
START_TEST(bullet_at_a_plate_takes_few_more_substeps)
{
    world_options o = weightless();
    shoot_down(o, 1, vec3_make(0, -100, 0));
    int divided = 0;
    for (int f = 0; f < 6; f++) {
        world_step(&w);
        ck_assert_int_le(w.report.substeps, 4 * 8);
        divided += w.report.substeps > 8;
    }
    ck_assert_int_le(divided, 2);
}
END_TEST

// Rejects: a cap that is not kept.
START_TEST(substeps_stay_within_their_bounds)
{
    world_options o = weightless();
    o.most_substeps = 10;
    begin(o);
    add(&cloth, ZERO, ZERO, false);
    add(&bullet, vec3_make(0, 1, 0), vec3_make(0, -100, 0), false);
    world_step(&w);
    ck_assert_int_eq(w.report.substeps, 10);
}
END_TEST

// A cloth asks for as many as the bullet needs to go no further than its radius.
START_TEST(what_meets_a_cloth_goes_by_its_radius)
{
    begin(weightless());
    add(&cloth, ZERO, ZERO, false);
    add(&bullet, vec3_make(0, 1, 0), vec3_make(0, -100, 0), false);
    world_step(&w);
    int want = (int)((100.0 / 60 + 0.0005) / shape_inner(&bullet)) + 1;
    ck_assert_int_eq(w.report.substeps, want);
}
END_TEST

// While a bullet strikes a cloth, the whole world takes more substeps.  A ball
// that falls far away does not feel it.
// Rejects: a speed kept as a length, which the next substep takes for another
// speed; gravity of another substep's length.
START_TEST(other_substeps_change_no_parabola)
{
    world_options o = world_options_default();
    begin(o);
    add(&cloth, ZERO, ZERO, false);
    add(&bullet, vec3_make(0, 1, 0), vec3_make(0, -100, 0), false);
    add(&bullet, vec3_make(50, 0, 0), vec3_make(1, 2, 3), false);
    pin_corners(20);
    int most = 0, least = 10000;
    for (int f = 1; f <= 30; f++) {
        world_step(&w);
        real t = f / 60.0;
        vec3 x = middle(2);
        most = w.report.substeps > most ? w.report.substeps : most;
        least = w.report.substeps < least ? w.report.substeps : least;
        ck_assert(fabs(x.x - (50 + t)) < ROUNDING);
        ck_assert(fabs(x.y - (2 * t - 9.81 * t * t / 2)) < ROUNDING);
        ck_assert(fabs(x.z - 3 * t) < ROUNDING);
    }
    ck_assert_int_gt(most, 40);
    ck_assert_int_lt(least, 20);
}
END_TEST

// Rejects: books that do not know how long the last substep was.
START_TEST(books_balance_over_other_substeps)
{
    world_options o = world_options_default();
    o.ledger = true;
    begin(o);
    add(&cloth, ZERO, ZERO, false);
    add(&bullet, vec3_make(0, 1, 0), vec3_make(3, -100, 0), false);
    pin_corners(20);
    ledger_entry was = ledger_total(&w);
    for (int f = 0; f < 10; f++) {
        world_step(&w);
        ck_assert(fabs(w.ledger[LEDGER_INTEGRATE].energy) < 1e-9);
    }
    ledger_entry now = ledger_total(&w);
    real sum = 0;
    for (int k = 0; k < LEDGERS; k++) sum += w.ledger[k].energy;
    // J; the bullet had 250 of them, and a substep in a thousand of a second
    // makes a rounding of places a thousand times as much of a speed.
    ck_assert(fabs(now.energy - was.energy - sum) < 1e-9);
    ck_assert(w.ledger[LEDGER_CONTACTS].energy + w.ledger[LEDGER_STICKS].energy
              < -10);
}
END_TEST

// 0.2 m from the rim, on a way that passes it by 2 cm.
// Rejects: a plane that has no rim.
START_TEST(bullet_that_passes_the_rim_feels_nothing)
{
    const vec3 v = { 0, -300, 0 };
    begin(weightless());
    add(&plate, ZERO, ZERO, true);
    add(&bullet, vec3_make(0.57, 2, 0), v, false);
    for (int f = 0; f < 3; f++) world_step(&w);
    ck_assert(vec3_distance(speed(1), v) < 1e-9);
    ck_assert(vec3_distance(middle(1), vec3_make(0.57, 2 - 15, 0)) < 1e-9);
}
END_TEST

// The plate is so wide that a bullet which hops along it stays over it.
// Rejects: a plate that is passed where the frame ends behind it; a guard on
// the wrong side; a bullet that is thrown back by more than it had.
START_TEST(bullet_stops_at_a_plate_however_fast)
{
    shape wide;
    ck_assert(shape_box(&wide, vec3_make(60, 0.01, 60), 1).ok);
    for (real v = 5; v < 3000; v *= 1.5) {
        begin(weightless());
        add(&wide, ZERO, ZERO, true);
        add(&bullet, vec3_make(0, 1.7, 0), vec3_make(v / 10, -v, 0), false);
        for (int f = 0; f < 4 + (int)(120 / v); f++) {
            world_step(&w);
            ck_assert_msg(middle(1).y > 0, "%g m/s", v);
            ck_assert(fabs(middle(1).x) < 30);
            ck_assert_msg(vec3_length(speed(1)) < 1.06 * v, "%g m/s", v);
            ck_assert_int_eq(w.report.dropped, 0);
        }
    }
    world_free(&w);
    shape_free(&wide);
}
END_TEST

// A bullet that is thrown at a free plate gives it what it loses.
START_TEST(bullet_and_plate_keep_their_momentum)
{
    begin(weightless());
    add(&plate, ZERO, ZERO, false);
    add(&bullet, vec3_make(0.2, 1, 0.1), vec3_make(0, -200, 0), false);
    for (int f = 0; f < 20; f++) world_step(&w);
    vec3 sum = vec3_add_scaled(speed(0), 0.05, speed(1));
    ck_assert(vec3_distance(sum, vec3_make(0, -10, 0)) < 1e-9);
    ck_assert(speed(0).y < -1);
}
END_TEST

// Is the bullet just behind the plate, as that lies?
static bool is_behind(void)
{
    vec3 at[8];
    world_vertices(&w, &w.body[0], at);
    vec3 up = vec3_unit(vec3_sub(at[2], at[0]));
    vec3 over = vec3_sub(middle(1), middle(0));
    real high = vec3_dot(over, up);
    vec3 along = vec3_add_scaled(over, -high, up);
    return high < 0 && high > -0.1 && vec3_length(along) < 0.5;
}

// 1, if the bullet was behind the free plate, which it reaches after 15 ms.
static int passes_free(vec3 to, vec3 v, vec3 spin)
{
    begin(weightless());
    add(&plate, ZERO, ZERO, false);
    placement p = placement_at(vec3_add_scaled(to, -0.015, v));
    p.velocity = v;
    p.spin = spin;
    ck_assert(world_add(&w, &bullet, p, NULL).ok);
    for (int f = 0; f < 4; f++) {
        world_step(&w);
        if (is_behind()) return 1;
    }
    vec3 sum = vec3_add_scaled(speed(0), 0.05, speed(1));
    ck_assert(vec3_distance(sum, vec3_scale(0.05, v)) < 1e-9 * vec3_length(v));
    return 0;
}

// Struck off its middle, the plate turns under the bullet, while that slides
// along it by half a metre in a quarter of a frame.
// Rejects: contacts alone, which let 17 of 392 through.
START_TEST(bullet_that_slides_along_a_turning_plate_stays_before_it)
{
    enum { ROW = 7, WAYS = 8 };
    int through = 0;
    for (int k = 0; k < ROW * ROW * WAYS; k++) {
        int place = k / WAYS, way = k % WAYS < 4 ? k % WAYS : k % WAYS + 1;
        vec3 to = vec3_make(0.09 * (place / ROW - 3), 0,
                            0.09 * (place % ROW - 3));
        vec3 v = vec3_make(1.2 * (way % 3 - 1), -1, 1.2 * (way / 3 - 1));
        through += passes_free(to, vec3_scale(1000 / vec3_length(v), v), ZERO);
    }
    ck_assert_int_eq(through, 0);
}
END_TEST

// A bullet that spins by radians in a substep has the points of its first touch,
// and its middle, as long as the frame lasts.
// Rejects: contacts that are asked again because it has turned, and lose its
// middle: bullets pass.
START_TEST(bullet_that_spins_stays_before_a_free_plate)
{
    unsigned long long seed = 21;
    int through = 0;
    for (int n = 0; n < 600; n++) {
        vec3 to = { 0.3 * random_real(&seed), 0, 0.3 * random_real(&seed) };
        vec3 way = { random_real(&seed), -1, random_real(&seed) };
        vec3 spin = { random_real(&seed), random_real(&seed),
                      random_real(&seed) };
        vec3 v = vec3_scale(1000 / vec3_length(way), way);
        through += passes_free(to, v, vec3_scale(50, spin));
    }
    ck_assert_int_eq(through, 0);
}
END_TEST

// m, from needle 0 to needle 1 along the normal of both, where they cross between
// their ends; else 0.
static real between_needles(void)
{
    vec3 x[2], d[2];
    for (int b = 0; b < 2; b++) {
        vec3 at[8];
        world_vertices(&w, &w.body[b], at);
        x[b] = vec3_scale(.5, vec3_add(at[0], at[7]));
        d[b] = vec3_unit(vec3_sub(at[1], at[0]));
    }
    vec3 n = vec3_cross(d[0], d[1]), r = vec3_sub(x[1], x[0]);
    real square = vec3_length_squared(n);
    real s = vec3_dot(vec3_cross(r, d[1]), n) / square;
    real t = vec3_dot(vec3_cross(r, d[0]), n) / square;
    bool cross = square > 1e-3 && fabs(s) < .98 && fabs(t) < .98;
    return cross ? vec3_dot(r, n) / sqrt(square) : 0;
}

// So many needles of 2 m and 5 mm, of 200, come through one that lies, or that is free
// as well: their lines cross the other way round, between their ends.
static int needles_through(bool is_free, real spin)
{
    unsigned long long seed = 9;
    shape needle;
    int through = 0;
    ck_assert(shape_box(&needle, vec3_make(2, .005, .005), 1).ok);
    for (int n = 0; n < 200; n++) {
        begin(weightless());
        add(&needle, ZERO, ZERO, !is_free);
        real by = .3 + 2.5 * random_fraction(&seed);
        placement p = placement_at(vec3_make(.6 * random_real(&seed), .3,
                                             .4 * random_real(&seed)));
        p.x = vec3_make(cos(by), 0, -sin(by));
        p.z = vec3_make(sin(by), 0, cos(by));
        p.velocity = vec3_make(0, -.6 - 2 * random_fraction(&seed), 0);
        p.spin = vec3_scale(spin, random_vec3(&seed, 1));
        ck_assert(world_add(&w, &needle, p, NULL).ok);
        real was = 0;
        for (int f = 0; f < 60; f++) {
            world_step(&w);
            real high = between_needles();
            through += was * high < 0;
            if (was * high < 0) break;
            was = high;
        }
    }
    world_free(&w);
    shape_free(&needle);
    return through;
}

// Rejects: needles that are asked where they were placed, which let 67 and 111
// through; that are asked as if they did not turn.
START_TEST(needle_that_crosses_another_stays_on_its_side)
{
    ck_assert_int_eq(needles_through(false, 0), 0);
    ck_assert_int_eq(needles_through(true, 0), 0);
    ck_assert_int_le(needles_through(false, 5), 2);
}
END_TEST

// Rejects: particles that make way one by one, for each weighs a thousandth of
// what they are to stop.
START_TEST(heavy_bullet_stops_at_a_light_cloth)
{
    shape heavy;
    ck_assert(shape_icosahedron(&heavy, 0.05, 5).ok);
    for (real v = 20; v < 100; v *= 2) {
        begin(weightless());
        add(&cloth, ZERO, ZERO, false);
        add(&heavy, vec3_make(0.06, 1.1, 0.04), vec3_make(0, -v, 0), false);
        pin_corners(20);
        for (int f = 0; f < 20; f++) world_step(&w);
        ck_assert_msg(middle(1).y > -0.3, "%g m/s", v);
    }
    world_free(&w);
    shape_free(&heavy);
}
END_TEST

// A cube of 10 kg in a cloth of 0.2 kg that hangs by its corners.  Rejects: a
// cloth that gives the cube the speed of its particles as if they were pinned.
START_TEST(hammock_holds_what_weighs_fifty_times_as_much)
{
    shape cube;
    ck_assert(shape_box(&cube, vec3_make(0.2, 0.2, 0.2), 10).ok);
    begin(world_options_default());
    add(&cloth, ZERO, ZERO, false);
    add(&cube, vec3_make(0, 0.2, 0), ZERO, false);
    pin_corners(20);
    vec3 was = ZERO;
    for (int f = 0; f < 240; f++) {
        world_step(&w);
        if (f == 179) was = middle(1);
        ck_assert(middle(1).y > -0.15 && middle(1).y < 0.2);
    }
    // The sheet trembles under it, with up to 0.3 m/s in a frame.
    ck_assert(vec3_distance(middle(1), was) < 0.04);
    world_free(&w);
    shape_free(&cube);
}
END_TEST

// Thrown at each other with v (m/s) in all, the cloth with `share` of it.
static void meet_a_free_cloth(const shape *heavy, real v, real share)
{
    begin(weightless());
    add(&cloth, ZERO, vec3_make(0, share * v, 0), false);
    add(heavy, vec3_make(0.06, 0.3, 0.04), vec3_make(0, (share - 1) * v, 0),
        false);
    vec3 before = vec3_make(0, 0.2 * share * v + 0.5 * (share - 1) * v, 0);
    for (int f = 0; f < 4; f++) world_step(&w);
    vec3 sum = vec3_scale(0.5, speed(1));
    for (int i = 0; i < 21 * 21; i++) {
        const particle *p = &w.pool.at[i];
        vec3 step = vec3_sub(p->position, p->previous);
        sum = vec3_add_scaled(sum, 1 / (p->inverse_mass * body_age(&w, 0)), step);
    }
    ck_assert(vec3_distance(sum, before) < ROUNDING);
}

// They end as one, more or less.  Rejects: a cloth that is pushed at one
// particle only, or is asked without regard to how it flies.
START_TEST(bullet_and_free_cloth_keep_their_momentum)
{
    shape heavy;
    ck_assert(shape_icosahedron(&heavy, 0.05, 0.5).ok);
    for (real share = -2; share <= 2; share += 1) {
        meet_a_free_cloth(&heavy, 20, share);
        real faster = speed(1).y - (share - 1) * 20, as_one = 20 * 0.2 / 0.7;
        ck_assert_msg(fabs(faster / as_one - 1) < 0.15, "by %g m/s", faster);
    }
    world_free(&w);
    shape_free(&heavy);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        bullet_at_a_plate_takes_few_more_substeps,
        substeps_stay_within_their_bounds,
        what_meets_a_cloth_goes_by_its_radius,
        other_substeps_change_no_parabola,
        books_balance_over_other_substeps,
        bullet_that_passes_the_rim_feels_nothing,
        bullet_stops_at_a_plate_however_fast,
        bullet_and_plate_keep_their_momentum,
        bullet_that_slides_along_a_turning_plate_stays_before_it,
        bullet_that_spins_stays_before_a_free_plate,
        needle_that_crosses_another_stays_on_its_side,
        heavy_bullet_stops_at_a_light_cloth,
        hammock_holds_what_weighs_fifty_times_as_much,
        bullet_and_free_cloth_keep_their_momentum,
        NULL
    };
    // A minute is for programs without optimisation, under gcov.
    return suite_run((suite){
        .name = "thin", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 60
    });
}
