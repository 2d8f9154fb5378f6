// 14-broad.c - which bodies may meet?  Time against their number, by looking at
// every pair, by one sorted line, and by a tree, on the same moving rooms, with the
// pairs that not all of them find; and what a thousand bodies cost that do not fill
// a room.

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
static int    line[MOST];               // scene by scene, from left to right
static int    treed[CAPACITY][2], all[CAPACITY][2];

// A frame, or many: microseconds a scene, and what was found in all scenes; what
// was compared by the tree and in the line, and passed there.
typedef struct {
    real tree, line, all;
    long pairs, wrong, compared, in_line, passed;
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

static real left_of(int k)
{
    return ball[line[k]].center.x - ball[line[k]].radius;
}

// The little program's way: the line of balls first to last, put in order by
// insertion, and swept.  Returns how many pairs meet.
static int sweep(int first, int last, cost *c)
{
    int found = 0;
    for (int k = first + 1; k < last; k++) {
        int me = line[k], at = k;
        real left = left_of(k);
        for (; at > first && left_of(at - 1) > left; at--) line[at] = line[at - 1];
        line[at] = me;
        c->passed += k - at;
    }
    for (int k = first; k < last; k++) {
        sphere a = ball[line[k]];
        for (int i = k + 1; i < last && left_of(i) <= a.center.x + a.radius; i++) {
            sphere b = ball[line[i]];
            vec3 d = vec3_sub(a.center, b.center);
            real near = a.radius + b.radius;
            c->in_line++;
            found += (moves[line[k]] || moves[line[i]])
                  && vec3_length_squared(d) <= near * near;
        }
    }
    return found;
}

// What the tree compares: the balls of leaves whose boxes meet.
static long count_below(const aabb_tree *t, int i, int k)
{
    if (!aabbs_meet(&t->node[i], &t->node[k])) return 0;
    if (i >= t->leaves) {
        long n = aabb_tree_end(t, i - t->leaves) - (i - t->leaves) * A_LEAF;
        long m = aabb_tree_end(t, k - t->leaves) - (k - t->leaves) * A_LEAF;
        return i == k ? n * (n - 1) / 2 : n * m;
    }
    return count_below(t, 2 * i, 2 * k) + count_below(t, 2 * i, 2 * k + 1)
         + (i != k ? count_below(t, 2 * i + 1, 2 * k) : 0)
         + count_below(t, 2 * i + 1, 2 * k + 1);
}

// Pairs that stand in one of two sorted lists only.
static long differences(int n, int m)
{
    long wrong = 0;
    for (int i = 0, j = 0; i < n || j < m;) {
        int first = j == m ? -1 : i == n ? 1 : treed[i][0] - all[j][0];
        if (first == 0) first = treed[i][1] - all[j][1];
        wrong += first != 0;
        i += first <= 0;
        j += first >= 0;
    }
    return wrong;
}

// Compares the answers for scene k; asks again if the lists hold those of another
// scene.
static void check(int k, int n, int scenes, int found, int swept, cost *c)
{
    const sphere *b = ball + k * n;
    const char *m = moves + k * n;
    if (scenes > 1) broad_pairs(&state[k], b, m, treed, CAPACITY);
    int right = broad_pairs_all(b, m, n, all, scenes > 1 ? CAPACITY : 0);
    c->pairs += right;
    c->wrong += differences(found, right) + labs((long)right - swept);
    c->compared += count_below(&state[k].tree, 1, 1);
}

static cost frame(int scenes, int n)
{
    static int found[MOST], swept[MOST];
    cost c = { 0 };
    real time[4] = { clock_seconds() };
    for (int k = 0; k < scenes; k++)
        found[k] = broad_pairs(&state[k], ball + k * n, moves + k * n, treed,
                               CAPACITY);
    time[1] = clock_seconds();
    for (int k = 0; k < scenes; k++) swept[k] = sweep(k * n, (k + 1) * n, &c);
    time[2] = clock_seconds();
    for (int k = 0; k < scenes; k++)
        broad_pairs_all(ball + k * n, moves + k * n, n, all, CAPACITY);
    time[3] = clock_seconds();
    c.tree = (time[1] - time[0]) / scenes * 1e6;
    c.line = (time[2] - time[1]) / scenes * 1e6;
    c.all = (time[3] - time[2]) / scenes * 1e6;
    for (int k = 0; k < scenes; k++) check(k, n, scenes, found[k], swept[k], &c);
    return c;
}

static real least(real a, real b)
{
    return b == 0 || a < b ? a : b;
}

// Adds a frame's counts, and keeps the times of the quickest one.
static void add(cost *sum, cost c)
{
    sum->tree = least(c.tree, sum->tree);
    sum->line = least(c.line, sum->line);
    sum->all = least(c.all, sum->all);
    sum->pairs += c.pairs;
    sum->wrong += c.wrong;
    sum->compared += c.compared;
    sum->in_line += c.in_line;
    sum->passed += c.passed;
}

// So many frames; the one before them puts the line in order.
static void run(int scenes, int n, vec3 box, int frames, cost *sum)
{
    for (int k = 0; k < scenes; k++)
        if (!broad_grow(&state[k], n)) exit(1);
    for (int k = 0; k < scenes * n; k++) line[k] = k;
    frame(scenes, n);
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

// Where two curves cross, on straight lines between the measured points; how steep
// they are from 1000 bodies on.
static void print_curves(const cost *c)
{
    real from = 0, gain[ROWS];
    int last = ROWS - 1, mid = last;
    for (int k = 0; k < ROWS; k++) {
        gain[k] = log(c[k].all / c[k].tree);
        if (k == 0 || gain[k] <= 0 || gain[k - 1] > 0) continue;
        real part = gain[k] / (gain[k] - gain[k - 1]);
        from = number[k] * exp(part * log((real)number[k - 1] / number[k]));
    }
    while (number[mid] > 1000) mid--;
    real grown = log((real)number[last] / number[mid]);
    printf("# the tree is quicker from %.0f bodies on\n"
           "# from 1000 on, time grows as n^%.2f by the tree, n^%.2f in a line, "
           "n^%.2f all\n", from, log(c[last].tree / c[mid].tree) / grown,
           log(c[last].line / c[mid].line) / grown,
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

// What chapter 14's formula says that a body compares in one line: balls 1.2 m
// wide.
static real compared_by_formula(int n)
{
    real share = 1.2 / room(n).x;
    return n * share * (1 - share / 2);
}

// And by a tree, far from the walls: leaves of four, of which each has a box as wide
// as three fifths of its room and a ball.
static real compared_in_tree(void)
{
    real volume = 0.317 / 0.15, wide = 0.6 * cbrt(4 * volume) + 1.2;
    return 4 * wide * wide * wide / volume;
}

// The book's tables: times of a few of the rooms, and what chapter 14's
// formulas say that a body compares and passes.
static void print_tables(const cost *c)
{
    printf("#rooms| bodies,pairs a frame,\"every pair, µs\",\"one line, µs\","
           "\"the tree, µs\"\n"
           "#formula| bodies,\"compared in one line, by the formula\",measured,"
           "\"passed, by the formula\",measured,"
           "\"compared by the tree, by the formula\",counted\n");
    for (int k = 0; k < ROWS; k++) {
        int n = number[k];
        real each = (real)ROUNDS * frames_of(n) * scenes_of(n);
        if (!is_shown(n)) continue;
        printf("#rooms| %d", n);
        print_cell((real)c[k].pairs / each);
        print_cell(c[k].all);
        print_cell(c[k].line);
        print_cell(c[k].tree);
        printf("\n#formula| %d,%.1f,%.1f,%.2f,%.2f,%.1f,%.1f\n", n,
               compared_by_formula(n), (real)c[k].in_line / each / n,
               n * 5.0 / 60 / (3 * room(n).x), (real)c[k].passed / each / n,
               compared_in_tree(), (real)c[k].compared / each / n);
    }
}

// Every number of bodies in each round, so that a minute in which the machine
// was busy spoils no point.
static void print_rooms(void)
{
    static cost sum[ROWS];
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < ROWS; k++) {
            int n = number[k], scenes = scenes_of(n);
            begin(scenes * n, room(n));
            run(scenes, n, room(n), frames_of(n), &sum[k]);
        }
    printf("\n\n# rooms: us a frame; pairs a frame, in all frames, and of "
           "these found by some ways only;\n# compared and passed, a body\n"
           "# bodies tree_us all_us line_us pairs all_pairs wrong compared "
           "in_line passed\n");
    for (int k = 0; k < ROWS; k++) {
        int n = number[k];
        real each = (real)ROUNDS * frames_of(n) * scenes_of(n);
        printf("%d %.4g %.4g %.4g %.1f %ld %ld %.1f %.1f %.2f\n", n, sum[k].tree,
               sum[k].all, sum[k].line, (real)sum[k].pairs / each, sum[k].pairs,
               sum[k].wrong, (real)sum[k].compared / each / n,
               (real)sum[k].in_line / each / n, (real)sum[k].passed / each / n);
    }
    print_curves(sum);
    print_tables(sum);
}

// A thousand, in a box of another shape.
typedef enum { ORDINARY, ONE_LARGE, ONE_AWAY } oddity;

static void print_case(const char *name, vec3 box, oddity odd)
{
    enum { N = 1000, RUN = 24 };
    cost c = { 0 };
    begin(N, box);
    if (odd == ONE_LARGE)
        ball[N / 2] = (sphere){ vec3_scale(0.5, box), 2 * box.x };
    if (odd == ONE_AWAY) ball[N / 2].center.y = -18000;
    if (odd != ORDINARY) velocity[N / 2] = vec3_make(0, 0, 0);
    run(1, N, box, RUN, &c);
    printf("\"%s\" %.4g %.4g %.4g %.1f %ld %.1f %.1f\n", name, c.tree, c.all,
           c.line, (real)c.pairs / RUN, c.wrong, (real)c.compared / RUN / N,
           (real)c.in_line / RUN / N);
    printf("#scenes| %s,%.0f,%.1f,%.1f", name, (real)c.pairs / RUN,
           (real)c.in_line / RUN / N, (real)c.compared / RUN / N);
    print_cell(c.all);
    print_cell(c.line);
    print_cell(c.tree);
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
           "# name tree_us all_us line_us pairs wrong compared in_line\n"
           "#scenes| scene,pairs,\"compared in one line, a body\",by the tree,"
           "\"every pair, µs\",\"one line, µs\",\"the tree, µs\"\n");
    print_case("a row along x", vec3_make(1000, 1, 1), ORDINARY);
    print_case("a floor", vec3_make(40, 0.5, 40), ORDINARY);
    print_case("a room", room(1000), ORDINARY);
    print_case("one large in it", room(1000), ONE_LARGE);
    print_case("one far below it", room(1000), ONE_AWAY);
    print_case("a tower along y", vec3_make(0.5, 1000, 0.5), ORDINARY);
    print_case("all in one place", vec3_make(0.2, 0.2, 0.2), ORDINARY);
    return 0;
}
