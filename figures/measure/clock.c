// clock.c - processor time, in rounds.

#define _POSIX_C_SOURCE 200809L

#include "clock.h"
#include "random.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

real clock_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

static int compare_real(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

real clock_median(real *x, int n)
{
    if (n < 1) return 0;
    qsort(x, (size_t)n, sizeof *x, compare_real);
    return n % 2 ? x[n / 2] : (x[n / 2 - 1] + x[n / 2]) / 2;
}

// ---- A race ----------------------------------------------------------------

static real run(const race *r, int way, long times)
{
    real start = clock_seconds();
    for (long k = 0; k < times; k++) r->work(way, r->with);
    return clock_seconds() - start;
}

// The warming up: how often must this way run to fill a slice?
static long times_of(const race *r, int way)
{
    long times = 1;
    while (run(r, way, times) < r->slice && times < 1L << 30) times *= 2;
    return times;
}

// Another order for every round: nothing that comes and goes regularly is to
// meet the same way each time.
static void shuffle(int *order, int n, unsigned long long *seed)
{
    for (int k = n - 1; k > 0; k--) {
        int j = random_below(seed, k + 1), kept = order[k];
        order[k] = order[j];
        order[j] = kept;
    }
}

void clock_race(race r, lap *out)
{
    assert(r.ways >= 1 && r.ways <= CLOCK_WAYS);
    assert(r.rounds >= 1 && r.rounds <= CLOCK_ROUNDS);
    static real took[CLOCK_WAYS][CLOCK_ROUNDS];
    unsigned long long seed = 1;
    long times[CLOCK_WAYS];
    int order[CLOCK_WAYS];
    for (int way = 0; way < r.ways; way++) {
        times[way] = times_of(&r, way);
        order[way] = way;
    }
    for (int round = 0; round < r.rounds; round++) {
        shuffle(order, r.ways, &seed);
        for (int k = 0; k < r.ways; k++) {
            int way = order[k];
            took[way][round] = run(&r, way, times[way]) / (real)times[way];
        }
    }
    // The first way last: the others still need its rounds in their order.
    for (int way = r.ways - 1; way >= 0; way--) {
        real ratio[CLOCK_ROUNDS];
        for (int k = 0; k < r.rounds; k++) ratio[k] = took[way][k] / took[0][k];
        out[way].ratio = clock_median(ratio, r.rounds);
        out[way].seconds = clock_median(took[way], r.rounds);
    }
}

real clock_at_error(const real *seconds, const real *error, int n,
                    real wanted)
{
    real best = HUGE_VAL;
    for (int k = 0; k < n; k++) {
        if (error[k] <= wanted) best = fmin(best, seconds[k]);
        if (k == 0 || error[k] > wanted || error[k - 1] <= wanted
            || error[k] <= 0) continue;
        real part = log(error[k - 1] / wanted) / log(error[k - 1] / error[k]);
        real way = log(seconds[k] / seconds[k - 1]);
        best = fmin(best, seconds[k - 1] * exp(part * way));
    }
    return best;
}

// ---- Telling ---------------------------------------------------------------

// Clang's version says its name, gcc's does not.
#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

// As the system names it; "unknown" where it does not.
static void processor(char *name, int room)
{
    char line[256];
    FILE *f = fopen("/proc/cpuinfo", "r");
    snprintf(name, (size_t)room, "unknown");
    while (f && fgets(line, sizeof line, f)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon) continue;
        line[strcspn(line, "\n")] = 0;
        snprintf(name, (size_t)room, "%s", colon + 2);
        break;
    }
    if (f) fclose(f);
}

void clock_print_head(const char *what, const char *flags)
{
    char name[128];
    processor(name, sizeof name);
    printf("# %s\n# compiler: %s; flags: %s; processor: %s\n", what, COMPILER,
           flags, name);
}

void clock_print_row(const char *module, const char *what, const char *error,
                     const char *best, const char *other, real ratio)
{
    if (ratio > 1e6)
        printf("#= %s,%s,%s,%s,%s,never\n", module, what, error, best, other);
    else
        printf("#= %s,%s,%s,%s,%s,%.3g\n", module, what, error, best, other,
               ratio);
}
