// check_sleep.c - what is still, which bodies sleep together, and which wake?
// Book: chapter 18.

#include <check.h>
#include <limits.h>
#include <stdlib.h>

#include "scarce.h"
#include "random.h"
#include "sleep.h"
#include "suite.h"

#define TIME_TO_SLEEP 0.5
#define EARTH 9.81

static sleep_state state;

static void tear_down(void)
{
    sleep_free(&state);
}

// --- how one body moves ------------------------------------------------------

// A path: where a body of 0.5 m on Earth is (m) at t (s).  Others go the same
// way, with lengths as their radius, and times as sqrt(R / g).
#define USUAL 0.5

typedef vec3 (*path)(real t);

typedef struct {
    real dt, radius, gravity;
} scale;

static real size_of_time(scale c)
{
    real g = c.gravity;
    return g > 0 ? sqrt(c.radius / USUAL * EARTH / g) : 1;
}

// How long it takes the body to fall asleep; HUGE_VAL if it is awake after
// `most`, both as its path counts time.
static real asleep_after(path x, scale c, real speed, real most)
{
    enum { PARTS = 8 };
    real unit = size_of_time(c), h = c.dt / PARTS, found = HUGE_VAL;
    sleep_rule rule = { speed, TIME_TO_SLEEP, c.gravity, c.dt, h, 0 };
    particle p[2] = { { .inverse_mass = 1 }, { .inverse_mass = 1 } };
    state = (sleep_state){ .bodies = 0 };
    ck_assert(sleep_grow(&state, 1, 2));
    for (int k = 1; k * c.dt < most * unit && found == HUGE_VAL; k++) {
        real now = k * c.dt;
        p[1].position = vec3_scale(c.radius / USUAL, x(now / unit));
        p[1].previous = vec3_scale(c.radius / USUAL,
                                   x((now - h) / unit));
        sleep_begin(&state);
        sleep_observe(&state, 0, p, 0, 2, c.radius, &rule);
        if (sleep_end(&state)) found = now / unit;
    }
    sleep_free(&state);
    return found;
}

// Frames from 1/240 to 1/15 s, radii from 5 mm to 500 m, on Earth and on the
// Moon.
enum { SCALES = 5 * 6 * 2 };

static scale scale_number(int k)
{
    const real frame[] = { 240, 120, 60, 30, 15 };
    const real radius[] = { 0.005, 0.05, 0.5, 1, 20, 500 };
    return (scale){ 1 / frame[k % 5], radius[k / 5 % 6], k < 30 ? 9.81 : 1.62 };
}

static void expect_asleep(path x, real before)
{
    for (int k = 0; k < SCALES; k++) {
        scale c = scale_number(k);
        real unit = real_min(1, size_of_time(c));
        real t = asleep_after(x, c, 0.005, 2 * before / unit);
        ck_assert_msg(t * unit <= before, "dt %g, radius %g, g %g: %g s", c.dt,
                      c.radius, c.gravity, t * unit);
    }
}

static void expect_awake(path x, real until)
{
    for (int k = 0; k < SCALES; k++) {
        scale c = scale_number(k);
        real t = asleep_after(x, c, 0.005, until);
        ck_assert_msg(t == HUGE_VAL, "dt %g, radius %g, g %g: %g s", c.dt,
                      c.radius, c.gravity, t);
    }
}

// --- what is still -----------------------------------------------------------

static vec3 along(real x)
{
    return vec3_make(0, x, 0);
}

static vec3 rest(real t)
{
    (void)t;
    return vec3_make(3, 5, 7);
}

// One window to compare with, then the time to sleep.  Rejects: time that is
// lost while clocks wait for each other.
START_TEST(what_never_moved_sleeps_after_three_windows)
{
    expect_asleep(rest, 0.92);
    scale usual = { 1.0 / 60, USUAL, EARTH };
    // At 60 Hz: before the end of the first second.
    ck_assert(asleep_after(rest, usual, 0.005, 1) <= 50.0 / 60);
}
END_TEST

static real pull;

static vec3 falling(real t)
{
    return along(pull * t * t / 2);
}

// On a slope with mu = 0.5, and 0.0005 too steep, the acceleration is
// 9.81 cos(a) 0.0005 = 0.0044 m/s^2.  Rejects: a limit for the speed alone.
START_TEST(what_slides_from_rest_goes_on)
{
    const real pulls[] = { 9.81, 1, 0.1, 0.01, 0.0044, 0.003, 0.002 };
    for (int k = 0; k < 7; k++) {
        pull = pulls[k];
        expect_awake(falling, 12);
    }
}
END_TEST

static real first_speed;

static vec3 sliding(real t)
{
    return along(first_speed * t + pull * t * t / 2);
}

// A box put down on a slope has some speed before its friction is there.
// Rejects: a speed that hides an acceleration.
START_TEST(what_slides_faster_and_faster_goes_on)
{
    pull = 0.0044;
    for (first_speed = 0.001; first_speed < 0.01; first_speed += 0.001)
        expect_awake(sliding, 12);
}
END_TEST

static vec3 braking(real t)
{
    return along(t < 1 ? 0.0044 * (t - t * t / 2) : 0.0022);
}

START_TEST(what_stops_sleeps)
{
    expect_asleep(braking, 2);
}
END_TEST

// A cube that stands on its edge, 0.0003 rad off balance, begins to fall as
// cosh(sqrt(g r m / I) t) = cosh(3.2 t); one of its particles is 1.2 m from
// that edge.
static vec3 tipping(real t)
{
    real x = 3.2 * t;
    return along(1.2 * 0.0003 * ((exp(x) + exp(-x)) / 2 - 1));
}

// Rejects: an edge that sleeps before it has begun to fall.
START_TEST(what_tips_over_goes_on)
{
    expect_awake(tipping, 3);
}
END_TEST

static vec3 thrown(real t)
{
    return along(2 * t - EARTH * t * t / 2);
}

static vec3 thrown_low(real t)
{
    return along(0.5 * (t - 1) - 0.02 * EARTH * (t - 1) * (t - 1) / 2);
}

// Rejects: a body that sleeps at the top of its flight.
START_TEST(what_is_thrown_up_does_not_sleep_at_the_top)
{
    expect_awake(thrown, 5);
    expect_awake(thrown_low, 8);
}
END_TEST

static real speed_of_path;

static vec3 gliding(real t)
{
    return along(speed_of_path * t);
}

// Rejects: a limit that does not depend on the size, or on gravity: seen by
// themselves all these move alike.
START_TEST(sleep_speed_is_that_of_a_cube_of_a_metre_on_earth)
{
    speed_of_path = 0.0053;
    expect_awake(gliding, 10);
    speed_of_path = 0.0047;
    expect_asleep(gliding, 0.92);
    for (real speed = 1e-4; speed < 1; speed *= 7) {
        scale usual = { 1.0 / 60, USUAL, EARTH };
        speed_of_path = 1.06 * speed;
        ck_assert(asleep_after(gliding, usual, speed, 10) == HUGE_VAL);
        speed_of_path = 0.94 * speed;
        ck_assert(asleep_after(gliding, usual, speed, 10) < 1);
    }
}
END_TEST

static vec3 settling(real t)
{
    return along(-0.02 * (1 - exp(-t / 0.1)));
}

static vec3 settling_slowly(real t)
{
    return along(-0.02 * (1 - exp(-t)));
}

// Rejects: a body that must come back to the place where it was.
START_TEST(what_settles_sleeps)
{
    expect_asleep(settling, 1.5);
    expect_asleep(settling_slowly, 4);
}
END_TEST

// 1.3 to 9 times a second.
static vec3 trembling(real t)
{
    return along(1e-4 * (sin(8 * t) + sin(23.7 * t) + sin(57.1 * t)));
}

// Rejects: a window that is measured from end to end, which finds by chance now
// less, now more.
START_TEST(what_trembles_a_little_sleeps)
{
    expect_asleep(trembling, 5);
}
END_TEST

static vec3 swinging(real t)
{
    return along(0.02 * sin(2 * t));
}

// Rejects: a pendulum that sleeps where it turns round.
START_TEST(what_swings_does_not_sleep_where_it_turns)
{
    expect_awake(swinging, 20);
}
END_TEST

// Without gravity there is no slow or fast, only rest.  Rejects: drifts that
// end.
START_TEST(without_gravity_only_what_does_not_move_sleeps)
{
    for (int k = 0; k < 30; k++) {
        scale c = scale_number(k);
        c.gravity = 0;
        ck_assert(asleep_after(rest, c, 0.005, 10) < 0.92);
        for (speed_of_path = 1e-5; speed_of_path < 10; speed_of_path *= 10)
            ck_assert(asleep_after(gliding, c, 0.005, 10) == HUGE_VAL);
    }
}
END_TEST

// Rounding, where there is no other motion.
static vec3 rounding(real t)
{
    return along(1e-9 * sin(1000 * t));
}

// Rejects: a time that overflows where gravity is next to nothing.
START_TEST(rounding_does_not_keep_awake)
{
    scale c = { 1.0 / 60, USUAL, 0 };
    ck_assert(asleep_after(rounding, c, 0.005, 10) < 0.92);
    c.gravity = 1e-30;
    ck_assert(asleep_after(rest, c, 0.005, 1e-14) == HUGE_VAL);
}
END_TEST

static vec3 lost(real t)
{
    return along(t > 0.6 ? (real)NAN : 0);
}

static vec3 far_away(real t)
{
    (void)t;
    return along(HUGE_VAL);
}

START_TEST(what_is_not_finite_does_not_sleep)
{
    expect_awake(lost, 3);
    expect_awake(far_away, 3);
}
END_TEST

START_TEST(without_sleep_speed_nothing_sleeps)
{
    for (int k = 0; k < SCALES; k++)
        ck_assert(asleep_after(rest, scale_number(k), 0, 10) == HUGE_VAL);
}
END_TEST

// --- islands -----------------------------------------------------------------

// Powers of two: half a window is two frames.
#define DT 0.0625

// The first window of a body begins at its first observation; three windows
// after that it may sleep.
enum { MANY = 64, TO_SLEEP = 13, AFTER_MOVE = 9 };

static bool moves[MANY];
static particle pool[MANY];

// `bodies` bodies of a particle each, all still.
static void begin(int bodies)
{
    state = (sleep_state){ .bodies = 0 };
    ck_assert(sleep_grow(&state, bodies, bodies));
    for (int b = 0; b < MANY; b++) {
        moves[b] = false;
        pool[b] = (particle){ .inverse_mass = 1 };
    }
}

// n frames in which the pairs of `touching` (closed by a negative number)
// touch.
static void frames(int n, const int *touching)
{
    const sleep_rule rule = { 0.005, TIME_TO_SLEEP, EARTH, DT, DT, 0 };
    for (int k = 0; k < n; k++) {
        sleep_begin(&state);
        for (const int *t = touching; t && *t >= 0; t += 2)
            sleep_touch(&state, t[0], t[1]);
        for (int b = 0; b < state.bodies; b++) {
            pool[b].previous = pool[b].position;
            if (moves[b]) pool[b].position.x += 1;
            if (!state.asleep[b])
                sleep_observe(&state, b, pool, b, 1, USUAL, &rule);
        }
        sleep_end(&state);
    }
}

static void asleep_are(const char *wanted)
{
    for (int b = 0; b < state.bodies; b++)
        ck_assert_msg(state.asleep[b] == (wanted[b] == 'z'),
                      "body %d is %s; wanted %s", b,
                      state.asleep[b] ? "asleep" : "awake", wanted);
}

// Rejects: bodies that are born asleep; a time to sleep that is one frame too
// short, or never over.
START_TEST(still_body_sleeps_when_its_time_is_over)
{
    begin(3);
    asleep_are("...");
    frames(TO_SLEEP - 1, NULL);
    asleep_are("...");
    frames(1, NULL);
    asleep_are("zzz");
}
END_TEST

// A move spoils both windows in which it is: the next begins a frame after it,
// and with the one after that makes the time to sleep.
// Rejects: stillness that is only counted down, or halved, by a jolt.
START_TEST(one_fast_frame_starts_the_time_again)
{
    begin(1);
    frames(TO_SLEEP - 2, NULL);
    moves[0] = true;
    frames(1, NULL);
    ck_assert(sleep_is_moving(&state, 0));
    moves[0] = false;
    frames(AFTER_MOVE - 1, NULL);
    ck_assert(!sleep_is_moving(&state, 0));
    asleep_are(".");
    frames(1, NULL);
    asleep_are("z");
}
END_TEST

// Rejects: a body that is struck as it falls asleep, and hangs in the air.
START_TEST(what_is_fast_in_the_last_frame_does_not_sleep)
{
    const sleep_rule rule = { 0.005, TIME_TO_SLEEP, EARTH, DT, DT / 8, 0 };
    begin(1);
    frames(TO_SLEEP - 1, NULL);
    pool[0].position.x += 0.04 * DT / 8;
    sleep_begin(&state);
    sleep_observe(&state, 0, pool, 0, 1, USUAL, &rule);
    ck_assert_int_eq(sleep_end(&state), 0);
    ck_assert(sleep_is_moving(&state, 0));
}
END_TEST

// Rejects: a body that sleeps while what it lies on still moves; islands that
// join only pairs, not chains.
START_TEST(island_sleeps_only_when_all_of_it_is_still)
{
    // 4 - 1 - 3 - 0 in a chain, 2 alone, named in an order in which two chains
    // are joined at their ends.
    const int chain[] = { 3, 0, 4, 1, 1, 3, -1 };
    begin(5);
    moves[4] = true;
    frames(20, chain);
    asleep_are("..z..");
    moves[4] = false;
    frames(AFTER_MOVE - 1, chain);
    asleep_are("..z..");
    frames(1, chain);
    asleep_are("zzzzz");
}
END_TEST

// Rejects: islands of yesterday that hold bodies which have parted.
START_TEST(bodies_that_part_are_islands_of_their_own)
{
    const int pair[] = { 0, 1, -1 };
    begin(2);
    moves[1] = true;
    frames(20, pair);
    asleep_are("..");
    frames(1, NULL);
    asleep_are("z.");
}
END_TEST

// Rejects: waking of one body alone, which leaves those on it in the air;
// waking of all, which costs the other islands their sleep.
START_TEST(waking_wakes_the_whole_island_and_no_other)
{
    const int pairs[] = { 0, 3, 3, 5, 1, 4, -1 };
    for (int b = 0; b < 6; b++) {
        static const char *const after[6] = {
            ".zz.z.", "z.zz.z", "zz.zzz", ".zz.z.", "z.zz.z", ".zz.z."
        };
        begin(6);
        frames(TO_SLEEP, pairs);
        asleep_are("zzzzzz");
        sleep_wake(&state, b);
        asleep_are(after[b]);
        sleep_free(&state);
    }
}
END_TEST

// Rejects: a woken body that falls asleep again at once, in the air; one that is
// taken to rest before it was looked at.
START_TEST(woken_island_is_observed_from_the_start)
{
    const int pair[] = { 0, 1, -1 };
    begin(2);
    frames(TO_SLEEP, pair);
    sleep_wake(&state, 1);
    ck_assert(sleep_is_moving(&state, 0) && sleep_is_moving(&state, 1));
    frames(1, pair);
    ck_assert(!sleep_is_moving(&state, 0) && !sleep_is_moving(&state, 1));
    frames(TO_SLEEP - 2, pair);
    asleep_are("..");
    frames(1, pair);
    asleep_are("zz");
}
END_TEST

// Rejects: waking that touches a body that is awake.
START_TEST(waking_what_is_awake_changes_nothing)
{
    begin(2);
    moves[1] = true;
    frames(TO_SLEEP + 1, NULL);
    asleep_are("z.");
    moves[1] = false;
    frames(AFTER_MOVE - 1, NULL);
    sleep_wake(&state, 1);
    asleep_are("z.");
    frames(1, NULL);
    asleep_are("zz");
}
END_TEST

// Rejects: a body that is moved by hand, and taken to be still.
START_TEST(forgotten_body_is_observed_from_the_start)
{
    begin(2);
    frames(TO_SLEEP - 1, NULL);
    sleep_forget(&state, 1);
    frames(TO_SLEEP - 1, NULL);
    asleep_are("z.");
    frames(1, NULL);
    asleep_are("zz");
}
END_TEST

// Contacts between sleepers are not looked for, so none are found.
// Rejects: islands that fall apart while their bodies sleep.
START_TEST(sleepers_keep_their_island_while_others_move)
{
    const int pair[] = { 0, 2, -1 };
    begin(4);
    moves[1] = moves[3] = true;
    frames(TO_SLEEP, pair);
    asleep_are("z.z.");
    frames(100, NULL);
    asleep_are("z.z.");
    sleep_wake(&state, 2);
    asleep_are("....");
}
END_TEST

// Rejects: a restless body that wakes sleepers by lying against them (that is
// for the step to decide).
START_TEST(restless_neighbour_lets_sleepers_sleep)
{
    const int before[] = { 0, 1, -1 }, after[] = { 1, 2, -1 };
    begin(3);
    moves[2] = true;
    frames(TO_SLEEP, before);
    asleep_are("zz.");
    frames(10, after);
    asleep_are("zz.");
    // It comes to rest on them, and now belongs to them.
    moves[2] = false;
    frames(AFTER_MOVE, after);
    asleep_are("zzz");
    frames(5, NULL);
    sleep_wake(&state, 0);
    asleep_are("...");
}
END_TEST

// Two that fell asleep together, and two more; then one lies between them.
// Rejects: an island of which only the one that was touched takes part; rings
// that are two, or that have two names; a sleeper that is counted once more.
START_TEST(what_comes_to_rest_on_sleepers_belongs_to_all_of_them)
{
    const int before[] = { 0, 1, 2, 3, -1 }, after[] = { 1, 4, 4, 3, -1 };
    begin(5);
    moves[4] = true;
    frames(TO_SLEEP, before);
    moves[4] = false;
    frames(1, after);
    asleep_are("zzzz.");
    frames(AFTER_MOVE, after);
    asleep_are("zzzzz");
    ck_assert_int_eq(state.sleepers, 5);
    for (int b = 0; b < 5; b++)
        ck_assert_int_eq(state.island[b], state.island[0]);
    sleep_wake(&state, 0);
    asleep_are(".....");
    ck_assert_int_eq(state.sleepers, 0);
}
END_TEST

// Rejects: an island named by a body that has left it: here both islands have
// gone through the name 0.
START_TEST(islands_that_form_later_do_not_share_a_name)
{
    const int first[] = { 0, 1, -1 }, second[] = { 0, 2, -1 };
    begin(3);
    frames(TO_SLEEP, first);
    asleep_are("zzz");
    sleep_wake(&state, 1);              // 0 and 1
    sleep_wake(&state, 2);
    moves[1] = true;
    frames(TO_SLEEP, second);
    asleep_are("z.z");
    moves[1] = false;
    frames(TO_SLEEP, NULL);
    asleep_are("zzz");
    sleep_wake(&state, 1);
    asleep_are("z.z");
    sleep_wake(&state, 2);
    asleep_are("...");
}
END_TEST

// 1 fell asleep with 0, and has been awake since; 2 falls asleep with 0 later,
// under the number that 1 still carries.  Rejects: a waking that believes the
// old island number of a body that is awake, and forgets how still it has been.
START_TEST(an_old_island_number_means_nothing)
{
    const int first[] = { 0, 1, -1 }, second[] = { 0, 2, -1 };
    begin(3);
    moves[2] = true;
    frames(TO_SLEEP, first);
    asleep_are("zz.");
    sleep_wake(&state, 0);
    moves[1] = true;
    moves[2] = false;
    frames(TO_SLEEP + 1, second);
    asleep_are("z.z");
    moves[1] = false;
    frames(AFTER_MOVE - 1, NULL);
    sleep_wake(&state, 2);
    asleep_are("...");
    frames(1, NULL);
    asleep_are(".z.");
}
END_TEST

// The slow oracle: which bodies can be reached through contacts, by colouring.
// Rejects: a union that loses a branch, or hangs.
START_TEST(islands_are_what_can_be_reached)
{
    unsigned long long seed = 5;
    for (int round = 0; round < 500; round++) {
        int touching[2 * MANY + 1], color[MANY], n = 0;
        begin(MANY);
        for (int k = 0; k < MANY * 3 / 4; k++)
            for (int side = 0; side < 2; side++)
                touching[n++] = random_below(&seed, MANY);
        touching[n] = -1;
        for (int b = 0; b < MANY; b++) color[b] = b;
        for (int again = 1; again;) {
            again = 0;
            for (int k = 0; k < n; k += 2) {
                int *a = &color[touching[k]], *b = &color[touching[k + 1]];
                if (*a == *b) continue;
                if (*a < *b) *b = *a; else *a = *b;
                again = 1;
            }
        }
        int restless = round % MANY;
        moves[restless] = true;
        frames(TO_SLEEP, touching);
        for (int b = 0; b < MANY; b++)
            ck_assert_int_eq(state.asleep[b], color[b] != color[restless]);
        // Without contacts the sleepers keep their islands; those that the
        // restless one kept awake are alone, and sleep.
        int waker = (restless + 1) % MANY;
        frames(2, NULL);
        if (color[waker] != color[restless]) {
            sleep_wake(&state, waker);
            for (int b = 0; b < MANY; b++)
                ck_assert_int_eq(state.asleep[b], color[b] != color[waker]
                                                  && b != restless);
        }
        sleep_free(&state);
    }
}
END_TEST

// Rejects: a static body, which is not observed, that sleeps, or keeps others
// from it.
START_TEST(what_is_not_observed_does_not_sleep)
{
    begin(2);
    state.bodies = 1;
    frames(TO_SLEEP, NULL);
    state.bodies = 2;
    sleep_begin(&state);
    ck_assert_int_eq(sleep_end(&state), 0);
    asleep_are("z.");
}
END_TEST

// Rejects: an empty world that cannot sleep; memory that is left.
START_TEST(no_bodies_are_no_trouble)
{
    begin(0);
    frames(3, NULL);
    sleep_free(&state);
    sleep_free(&state);
    ck_assert_int_eq(state.bodies, 0);
}
END_TEST

// Rejects: a leak, or bodies without a table, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    int n = 0;
    for (; n < 20; n++) {
        long held = blocks_held;
        mallocs_left = n;
        state = (sleep_state){ .bodies = 0 };
        bool ok = sleep_grow(&state, 3, 12);
        mallocs_left = INT_MAX;
        if (ok) break;
        bool has_none = state.bodies == 0 && state.particles == 0;
        sleep_free(&state);
        held = blocks_held - held;
        ck_assert(has_none);
        ck_assert(!state.parent && !state.island && !state.watch
                  && !state.asleep && !state.is_restless && !state.start[0]
                  && !state.start[1] && state.bodies == 0);
        ck_assert_int_eq(held, 0);
    }
    ck_assert_int_eq(n, 10);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_never_moved_sleeps_after_three_windows,
        what_slides_from_rest_goes_on,
        what_slides_faster_and_faster_goes_on,
        what_stops_sleeps,
        what_tips_over_goes_on,
        what_is_thrown_up_does_not_sleep_at_the_top,
        sleep_speed_is_that_of_a_cube_of_a_metre_on_earth,
        what_settles_sleeps,
        what_trembles_a_little_sleeps,
        what_swings_does_not_sleep_where_it_turns,
        without_gravity_only_what_does_not_move_sleeps,
        rounding_does_not_keep_awake,
        what_is_not_finite_does_not_sleep,
        without_sleep_speed_nothing_sleeps,
        still_body_sleeps_when_its_time_is_over,
        one_fast_frame_starts_the_time_again,
        what_is_fast_in_the_last_frame_does_not_sleep,
        island_sleeps_only_when_all_of_it_is_still,
        bodies_that_part_are_islands_of_their_own,
        waking_wakes_the_whole_island_and_no_other,
        woken_island_is_observed_from_the_start,
        waking_what_is_awake_changes_nothing,
        forgotten_body_is_observed_from_the_start,
        sleepers_keep_their_island_while_others_move,
        restless_neighbour_lets_sleepers_sleep,
        what_comes_to_rest_on_sleepers_belongs_to_all_of_them,
        islands_that_form_later_do_not_share_a_name,
        an_old_island_number_means_nothing,
        islands_are_what_can_be_reached,
        what_is_not_observed_does_not_sleep,
        no_bodies_are_no_trouble,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "sleep", .tests = tests, .tear_down = tear_down, .seconds = 30
    });
}
