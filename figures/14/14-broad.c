// 14-broad.c - which bodies may meet?  Time against their number, by looking at
// every pair and sorted, on the same moving rooms, with the pairs that one of
// the two finds and the other does not; and what a thousand bodies cost that do
// not fill a room.

#include "broad.h"
#include "clock.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { MOST = 10000, CAPACITY = 500000 };

// Many small scenes in a row, so that no processor learns one by heart: body b
// belongs to scene b / n.
static sphere ball[MOST];
static vec3   velocity[MOST];
static char   moves[MOST];
static broad  state[MOST];
static int    sorted[CAPACITY][2], all[CAPACITY][2];

// A frame, or many: microseconds a scene, and what was found in all scenes.
typedef struct {
    real sorted, all;
    long pairs, wrong, tests, shifts;
} cost;

static unsigned long long seed = 1;

// Radius 0.5 m, and 0.1 m of looking ahead; +-5 m/s along each axis.
static void begin(int bodies, vec3 box)
{
    for (int b = 0; b < bodies; b++) {
        real x = random_fraction(&seed), y = random_fraction(&seed),
             z = random_fraction(&seed);
        ball[b] = (sphere){ { x * box.x, y * box.y, z * box.z }, 0.6 };
        velocity[b] = random_vec3(&seed, 5);
        moves[b] = 1;
    }
}

static void fly_along(real *x, real *v, real side)
{
    *x += *v / 60;
    if (*x < 0)    *v = fabs(*v);
    if (*x > side) *v = -fabs(*v);
}

static void fly(int bodies, vec3 box)
{
    for (int b = 0; b < bodies; b++) {
        if (!moves[b]) continue;
        fly_along(&ball[b].center.x, &velocity[b].x, box.x);
        fly_along(&ball[b].center.y, &velocity[b].y, box.y);
        fly_along(&ball[b].center.z, &velocity[b].z, box.z);
    }
}

// What the sweep compares: in each lane, the pairs of balls that overlap along
// x.  Those that stand still only look at those that move.
static long count_tests(const broad *s, const char *is_awake)
{
    long tests = 0;
    for (int l = 0; l < s->lanes[0] * s->lanes[1]; l++)
        for (int i = s->lane[l]; i < s->lane[l + 1]; i++) {
            real end = s->high[s->who[i]];
            for (int j = i + 1; j < s->lane[l + 1] && s->start[j] <= end; j++)
                tests += is_awake[s->who[i]] || is_awake[s->who[j]];
        }
    return tests;
}

// Pairs that stand in one of two sorted lists only.
static long differences(int n, int m)
{
    long wrong = 0;
    for (int i = 0, j = 0; i < n || j < m;) {
        int first = j == m ? -1 : i == n ? 1 : sorted[i][0] - all[j][0];
        if (first == 0) first = sorted[i][1] - all[j][1];
        wrong += first != 0;
        i += first <= 0;
        j += first >= 0;
    }
    return wrong;
}

// Compares the answers for scene k, which found that many; asks again if the
// lists hold those of another scene.
static void check(int k, int n, int scenes, int found, cost *c)
{
    const sphere *b = ball + k * n;
    const char *m = moves + k * n;
    c->shifts += state[k].shifts;
    if (scenes > 1) broad_pairs(&state[k], b, m, sorted, CAPACITY);
    int right = broad_pairs_all(b, m, n, all, scenes > 1 ? CAPACITY : 0);
    c->pairs += right;
    c->wrong += differences(found, right);
    c->tests += count_tests(&state[k], m);
}

static cost frame(int scenes, int n)
{
    static int found[MOST];
    cost c = { 0 };
    real start = clock_seconds();
    for (int k = 0; k < scenes; k++)
        found[k] = broad_pairs(&state[k], ball + k * n, moves + k * n, sorted,
                               CAPACITY);
    real middle = clock_seconds();
    for (int k = 0; k < scenes; k++)
        broad_pairs_all(ball + k * n, moves + k * n, n, all, CAPACITY);
    c.sorted = (middle - start) / scenes * 1e6;
    c.all = (clock_seconds() - middle) / scenes * 1e6;
    for (int k = 0; k < scenes; k++) check(k, n, scenes, found[k], &c);
    return c;
}

static real least(real a, real b)
{
    return b == 0 || a < b ? a : b;
}

// Adds a frame's counts, and keeps the times of the quickest one.
static void add(cost *sum, cost c)
{
    sum->sorted = least(c.sorted, sum->sorted);
    sum->all = least(c.all, sum->all);
    sum->pairs += c.pairs;
    sum->wrong += c.wrong;
    sum->tests += c.tests;
    sum->shifts += c.shifts;
}

// So many frames, and what the first call cost, from no order at all.
static void run(int scenes, int n, vec3 box, int frames, cost *sum, cost *first)
{
    for (int k = 0; k < scenes; k++)
        if (!broad_grow(&state[k], n).ok) exit(1);
    add(first, frame(scenes, n));
    for (int k = 0; k < frames; k++) {
        fly(scenes * n, box);
        add(sum, frame(scenes, n));
    }
    for (int k = 0; k < scenes; k++) broad_free(&state[k]);
}

static vec3 room(int n)
{
    real side = cbrt(0.317 * n / 0.15);
    return vec3_make(side, side, side);
}

// Room scenes at a time, and frames of them.
static int scenes_of(int n)
{
    return n < 2000 ? 2000 / n : 1;
}

static int frames_of(int n)
{
    return n < 2000 ? 14 : 28000 / n;
}

static const int number[] = { 10, 14, 20, 30, 40, 50, 60, 80, 100, 140, 200,
    300, 500, 700, 1000, 1400, 2000, 3000, 5000, 7000, 10000 };
enum { ROWS = sizeof number / sizeof *number, ROUNDS = 3 };

// Where the two curves cross, on straight lines between the measured points;
// how steep they are from 1000 bodies on.
static void print_curves(const cost *c)
{
    real from = 0, gain[ROWS];
    int last = ROWS - 1, mid = last;
    for (int k = 0; k < ROWS; k++) {
        gain[k] = log(c[k].all / c[k].sorted);
        if (k == 0 || gain[k] <= 0 || gain[k - 1] > 0) continue;
        real part = gain[k] / (gain[k] - gain[k - 1]);
        from = number[k] * exp(part * log((real)number[k - 1] / number[k]));
    }
    while (number[mid] > 1000) mid--;
    real grown = log((real)number[last] / number[mid]);
    printf("# sorted is quicker from %.0f bodies on\n"
           "# from 1000 on, time grows as n^%.2f sorted, n^%.2f all\n", from,
           log(c[last].sorted / c[mid].sorted) / grown,
           log(c[last].all / c[mid].all) / grown);
}

// In a cell: three digits, or whole.
static void print_cell(real x)
{
    printf(x < 100 ? ",%.3g" : ",%.0f", x);
}

static int is_shown(int n)
{
    return n == 10 || n == 50 || n == 100 || n == 200 || n == 1000 || n == 10000;
}

// What chapter 14's formulas say that a body compares: balls 1.2 m wide, in
// one lane along x, or in lanes by lanes of them.
static real compared_by_formula(int n, int in_lanes)
{
    real side = room(n).x, share = 1.2 / side;
    real one = n * share * (1 - share / 2);
    int lanes = (int)((side + 1.2) / 2.4);
    real each = 1 + (lanes - 1) * share, common = each * each / lanes;
    return in_lanes ? one * common * common : one;
}

// The book's tables: times of a few of the rooms, and what chapter 14's
// formulas say that a body compares and passes.
static void print_tables(const cost *c, const cost *first)
{
    printf("#rooms| bodies,pairs a frame,\"every pair, µs\",\"sorted, µs\","
           "\"the first call, µs\"\n"
           "#formula| bodies,\"compared in one line, by the formula\","
           "in lanes,measured,\"passed, by the formula\",measured\n");
    for (int k = 0; k < ROWS; k++) {
        int n = number[k];
        real each = (real)ROUNDS * frames_of(n) * scenes_of(n);
        if (!is_shown(n)) continue;
        printf("#rooms| %d", n);
        print_cell((real)c[k].pairs / each);
        print_cell(c[k].all);
        print_cell(c[k].sorted);
        print_cell(first[k].sorted);
        printf("\n#formula| %d,%.1f,", n, compared_by_formula(n, 0));
        if (n < 400) printf("none");
        else         printf("%.1f", compared_by_formula(n, 1));
        printf(",%.1f,%.2f,%.2f\n", (real)c[k].tests / each / n,
               n * 5.0 / 60 / (3 * room(n).x), (real)c[k].shifts / each / n);
    }
}

// Every number of bodies in each round, so that a minute in which the machine
// was busy spoils no point.
static void print_rooms(void)
{
    static cost sum[ROWS], first[ROWS];
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < ROWS; k++) {
            int n = number[k], scenes = scenes_of(n);
            begin(scenes * n, room(n));
            run(scenes, n, room(n), frames_of(n), &sum[k], &first[k]);
        }
    printf("\n\n# rooms: us a frame; pairs a frame, in all frames, and of "
           "these found by one way only;\n# compared and passed, a body\n"
           "# bodies sorted_us all_us first_us pairs all_pairs wrong compared "
           "passed\n");
    for (int k = 0; k < ROWS; k++) {
        int n = number[k];
        real each = (real)ROUNDS * frames_of(n) * scenes_of(n);
        printf("%d %.4g %.4g %.4g %.1f %ld %ld %.1f %.2f\n", n, sum[k].sorted,
               sum[k].all, first[k].sorted, (real)sum[k].pairs / each,
               sum[k].pairs, sum[k].wrong, (real)sum[k].tests / each / n,
               (real)sum[k].shifts / each / n);
    }
    print_curves(sum);
    print_tables(sum, first);
}

// A thousand, in a box of another shape.  large: one of them holds all others.
static void print_case(const char *name, vec3 box, int large, int awake)
{
    enum { N = 1000, RUN = 24 };
    cost c = { 0 }, first = { 0 };
    begin(N, box);
    if (large) ball[N / 2] = (sphere){ vec3_scale(0.5, box), 2 * box.x };
    if (large) velocity[N / 2] = vec3_make(0, 0, 0);
    for (int b = awake; b < N; b++) moves[b] = 0;
    run(1, N, box, RUN, &c, &first);
    printf("\"%s\" %.4g %.4g %.4g %.1f %ld %.1f %.2f\n", name, c.sorted, c.all,
           first.sorted, (real)c.pairs / RUN, c.wrong,
           (real)c.tests / RUN / N, (real)c.shifts / RUN / N);
    printf("#scenes| %s,%.1f,%.2f,%.0f", name, (real)c.tests / RUN / N,
           (real)c.shifts / RUN / N, (real)c.pairs / RUN);
    print_cell(c.all);
    print_cell(c.sorted);
    printf("\n");
}

int main(void)
{
    printf("# balls of 0.5 + 0.1 m that fly at up to 5 m/s along each axis, a "
           "room of 0.317 / 0.15 m3 each\n# CPU time of the quickest frame\n"
           "# %s, %s\n",
           __VERSION__, FLAGS);
    print_rooms();

    printf("\n\n# a thousand bodies\n"
           "# name sorted_us all_us first_us pairs wrong compared passed\n"
           "#scenes| scene,\"compared, a body\",\"passed, a body\",pairs,"
           "\"every pair, µs\",\"sorted, µs\"\n");
    print_case("all asleep", room(1000), 0, 0);
    print_case("one awake", room(1000), 0, 1);
    print_case("a row along x", vec3_make(1000, 1, 1), 0, 1000);
    print_case("a floor", vec3_make(40, 0.5, 40), 0, 1000);
    print_case("a room", room(1000), 0, 1000);
    print_case("one large in it", room(1000), 1, 1000);
    print_case("a tower along y", vec3_make(0.5, 1000, 0.5), 0, 1000);
    print_case("all in one place", vec3_make(0.2, 0.2, 0.2), 0, 1000);
    return 0;
}
