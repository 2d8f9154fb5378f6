// family_cost.c - rows 185 to 188: what is hard costs its own.
//
// Times are processor time of this program alone, and are judged by their
// ratio: what is compared runs in turns, step by step, and the median of the
// steps is taken.  So machine and load hardly matter; the last digits do
// vary.  Where the report counts the work, the count is judged as well.

#define _POSIX_C_SOURCE 200809L     // clock_gettime

#include "family.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

// s, processor time.
static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, compare);
    return x[n / 2];
}

// Takes a step, and returns how long it took.
static double timed_step(tumble_world *w)
{
    double start = clock_now();
    tumble_world_step(w);
    return clock_now() - start;
}

enum { MOST_STEPS = 240 };

// s, the median step of each world; and substeps, the mean of each.
typedef struct {
    double seconds[3], substeps[3];
} cost;

static cost measure(tumble_world *const *w, int worlds, int steps)
{
    static double took[3][MOST_STEPS];
    cost c = { { 0, 0, 0 }, { 0, 0, 0 } };
    for (int n = 0; n < steps; n++)
        for (int k = 0; k < worlds; k++) {
            took[k][n] = timed_step(w[k]);
            c.substeps[k] += (double)tumble_world_last_step(w[k]).substeps
                / steps;
        }
    for (int k = 0; k < worlds; k++) c.seconds[k] = median(took[k], steps);
    return c;
}

static tumble_world *begin(double sleep_speed)
{
    tumble_options o = tumble_options_default();
    o.sleep_speed = sleep_speed;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    return w;
}

// ---- 185: one hard pair beside an easy pile --------------------------------

// Boxes of 1 kg in stacks of ten.
static void add_stacks(tumble_world *w, int n)
{
    tumble_shape box = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int i = 0; i < n; i++)
        tumble_body_add(w, box,
                        tumble_body_at(i / 10 % 10, 0.25 + 0.5 * (i % 10),
                                       i / 100));
}

typedef enum { CHAIN, HEAVY, SPIN, CLOTH, HARD } hard_kind;
static const char *const HARD_NAME[] = {
    "a chain under 100 links", "1,000 times its support", "a top of 100 rad/s",
    "a hung cloth"
};

// Far from the stacks.
static void add_hard(tumble_world *w, hard_kind kind)
{
    tumble_body last = tumble_body_ground();
    tumble_vec3 at = { -20, 8, 0 };
    if (kind == CHAIN) {
        tumble_shape link = tumble_shape_box(w, tumble_v(0.4, 0.1, 0.1), 1);
        for (int i = 0; i < 10; i++, at.x += 0.4) {
            tumble_body b =
                tumble_body_add(w, link, tumble_body_at(at.x + 0.2, at.y, 0));
            tumble_joint_ball(w, last, b, at);
            last = b;
        }
        tumble_joint_ball(w, last,
                          tumble_body_add(w, tumble_shape_sphere(w, 0.4, 100),
                                          tumble_body_at(at.x + 0.4, at.y, 0)),
                          at);
    } else if (kind == HEAVY) {
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1),
                        tumble_body_at(-20, 0.25, 0));
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1000),
                        tumble_body_at(-20, 0.75, 0));
    } else if (kind == SPIN) {
        tumble_body_options o = tumble_body_at(-20, 8, 0);
        o.spin = tumble_v(30, 90, 30);
        tumble_shape rod = tumble_shape_box(w, tumble_v(1, 0.2, 0.4), 1);
        tumble_body b = tumble_body_add(w, rod, o);
        tumble_joint_ball(w, tumble_body_ground(), b, tumble_v(-20, 7, 0));
    } else {
        tumble_body b =
            tumble_body_add(w, tumble_shape_cloth(w, 16, 16, 2, 2, 0.4),
                            tumble_body_at(-20, 8, 0));
        tumble_body_pin(w, b, 0);
        tumble_body_pin(w, b, 15);
    }
}

// The two in one world, against the sum of the two in worlds of their own.
static void beside(hard_report *r, int fast)
{
    static const int piles[] = { 100, 1000, 400 };
    family_worst times = { .target = 1.2 }, asleep = { .target = 1.2 };
    for (int k = 0; k < (fast ? 1 : HARD * 3); k++) {
        hard_kind kind = (hard_kind)(k % HARD);
        int n = piles[k / HARD];
        double ratio[2], substeps[2][3];
        for (int sleeps = 0; sleeps < (fast ? 1 : 2); sleeps++) {
            tumble_world *w[3];
            for (int i = 0; i < 3; i++) {
                w[i] = begin(sleeps ? tumble_options_default().sleep_speed : 0);
                if (i != 1) add_stacks(w[i], n);
                if (i != 0) add_hard(w[i], kind);
                for (int step = 0; step < (sleeps ? 120 : 20); step++)
                    tumble_world_step(w[i]);
            }
            cost c = measure(w, 3, fast ? 20 : 60);
            ratio[sleeps] = c.seconds[2] / (c.seconds[0] + c.seconds[1]);
            for (int i = 0; i < 3; i++) substeps[sleeps][i] = c.substeps[i];
            family_worst *f = sleeps ? &asleep : &times;
            if (family_ok(r, w[2]))
                family_trial(f, ratio[sleeps], "%d boxes, %s; substeps %.0f, "
                             "%.0f, together %.0f", n, HARD_NAME[kind],
                             substeps[sleeps][0], substeps[sleeps][1],
                             substeps[sleeps][2]);
            for (int i = 0; i < 3; i++) tumble_world_free(w[i]);
        }
    }
    family_add(r, &times, "x", "both in one world, of the two apart");
    if (!fast)
        family_add(r, &asleep, "x", "the same, when the stacks may sleep");
}

// ---- 186: who is awake pays ------------------------------------------------

// Boxes that lie in pairs, put to sleep; and ten balls that roll beside them.
static tumble_world *town(int boxes, int balls)
{
    tumble_world *w = begin(tumble_options_default().sleep_speed);
    tumble_shape box = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    tumble_shape ball = tumble_shape_sphere(w, 0.3, 1);
    for (int i = 0; i < boxes; i++) {
        tumble_body b =
            tumble_body_add(w, box, tumble_body_at(i / 2 % 50,
                                                   0.25 + 0.5 * (i % 2),
                                                   i / 100));
        tumble_body_sleep(w, b);
    }
    for (int i = 0; i < balls; i++) {
        tumble_body_options o = tumble_body_at(2 * i, 0.3, -5);
        o.velocity = tumble_v(0, 0, -2);
        o.spin = tumble_v(-2 / 0.3, 0, 0);
        tumble_body_add(w, ball, o);
    }
    return w;
}

static void sleepers(hard_report *r, int fast)
{
    static const int boxes[] = { 1000, 100, 10000 };
    family_worst times = { .target = 2 };
    for (int k = 0; k < (fast ? 1 : 3); k++) {
        tumble_world *w[2] = { town(boxes[k], 10), town(0, 10) };
        // The first step is that of worlds just made.
        for (int i = 0; i < 2; i++)
            for (int n = 0; n < 5; n++) tumble_world_step(w[i]);
        cost c = measure(w, 2, fast ? 20 : 100);
        if (family_ok(r, w[0]))
            family_trial(&times, c.seconds[0] / c.seconds[1],
                         "%d boxes, %d asleep", boxes[k],
                         tumble_world_last_step(w[0]).asleep);
        for (int i = 0; i < 2; i++) tumble_world_free(w[i]);
    }
    family_add(r, &times, "x", "10 rolling balls and sleepers, of 10 alone");
}

// ---- 187: to make a world --------------------------------------------------

enum { MOST_WORLDS = 16 };

// s, to add n bodies to each of so many worlds.
static double time_making(int worlds, int n, int joined)
{
    tumble_world *w[MOST_WORLDS];
    double took = 0;
#ifdef __GLIBC__
    malloc_trim(0);     // what is left of the last worlds would be had for nothing
#endif
    for (int k = 0; k < worlds; k++) {
        w[k] = begin(0);
        tumble_shape box = tumble_shape_box(w[k], tumble_v(0.5, 0.5, 0.5), 1);
        tumble_body before = tumble_body_ground();
        double start = clock_now();
        for (int i = 0; i < n; i++) {
            double x = i % 100, z = i / 100;
            tumble_body b = tumble_body_add(w[k], box, tumble_body_at(x, 1, z));
            if (joined)
                tumble_joint_ball(w[k], i % 2 ? before : tumble_body_ground(),
                                  b, tumble_v(x, 1, z));
            before = b;
        }
        took += clock_now() - start;
    }
    for (int k = 0; k < worlds; k++) tumble_world_free(w[k]);
    return took;
}

// Twice as many may take twice as long, and nothing more: one world of many
// against many of few, which take as much memory from the system.
static void making(hard_report *r, int fast)
{
    family_worst grows[2] = { { .target = 1.5 }, { .target = 1.5 } };
    for (int joined = 0; joined < 2; joined++) {
        double few[9], many[9];
        int n = joined ? 250 : 1000, times = fast ? 2 : joined ? 8 : MOST_WORLDS;
        int repeats = fast ? 3 : 5;
        for (int k = 0; k < repeats; k++) {
            few[k] = time_making(times, n, joined);
            many[k] = time_making(1, times * n, joined);
        }
        family_trial(&grows[joined], median(many, repeats) / median(few, repeats),
                     "%d against %d", times * n, n);
    }
    family_add(r, &grows[0], "x", "to add one of 16,000 bodies, of 1,000");
    family_add(r, &grows[1], "x", "to add one of 2,000 joined, of 250");
}

// ---- 188: more of the same -------------------------------------------------

// n groups that never meet cost n times one: stacks, chains, cloths.
static tumble_world *groups(int kind, int n)
{
    tumble_world *w = begin(0);
    tumble_shape box = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    tumble_shape cloth =
        kind == 2 ? tumble_shape_cloth(w, 10, 10, 1, 1, 0.2) : box;
    for (int i = 0; i < n; i++) {
        double x = 3 * (i % 10), z = 3 * (i / 10);
        tumble_body before = tumble_body_ground();
        if (kind == 2) {
            tumble_body b = tumble_body_add(w, cloth, tumble_body_at(x, 3, z));
            tumble_body_pin(w, b, 0);
            tumble_body_pin(w, b, 9);
        }
        for (int k = 0; k < 5 && kind < 2; k++) {
            double y = kind ? 8 - 0.6 * k : 0.25 + 0.5 * k;
            tumble_body b = tumble_body_add(w, box, tumble_body_at(x, y, z));
            if (kind)
                tumble_joint_ball(w, before, b, tumble_v(x, y + 0.3, z + 0.1));
            before = b;
        }
    }
    return w;
}

static void more_of_it(hard_report *r, int fast)
{
    static const char *const name[] = { "stacks", "chains", "cloths" };
    family_worst times = { .target = 1.2 };
    for (int kind = 0; kind < (fast ? 1 : 3); kind++) {
        int few = kind == 2 ? 4 : 20, more = fast ? 2 : 10;
        tumble_world *w[2] = { groups(kind, few), groups(kind, more * few) };
        for (int i = 0; i < 2; i++)
            for (int n = 0; n < 10; n++) tumble_world_step(w[i]);
        cost c = measure(w, 2, fast ? 20 : 60);
        if (family_ok(r, w[1]))
            family_trial(&times, c.seconds[1] / (more * c.seconds[0]),
                         "%d against %d %s", more * few, few, name[kind]);
        for (int i = 0; i < 2; i++) tumble_world_free(w[i]);
    }
    family_add(r, &times, "x", "ten times as many groups, of ten times one");
}

// Not one of the short forms: times are no test.
const hard_case family_cost[] = {
    { 185, "a hard pair beside a pile", 0, beside },
    { 186, "rolling balls among sleepers", 0, sleepers },
    { 187, "to make many bodies", 0, making },
    { 188, "groups that never meet", 0, more_of_it },
    { 0, NULL, 0, NULL }
};
