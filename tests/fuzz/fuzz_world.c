// fuzz_world.c - random worlds, and what a step costs in them.
//
//   fuzz_world SEED                       this one; says what it is
//   fuzz_world FIRST LAST [SECONDS [STEPS]]   these, until the time is over
//
// Unlike the other fuzzers it takes no bytes: a world is made from a number
// (worlds.h).  Each has a process of its own, so that one which ends with an
// assertion, or never, does not end the others; a line says which it was.
// Ends with 0 if all is well, 1 if not, 2 if it was not understood.

#define _DEFAULT_SOURCE

#include "worlds.h"

#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { STEPS = 1000 };

// No frame may cost more than so many times the median of its trial: of the
// frames in which something is awake, and counted as LEAST at least, for a
// machine that is busy makes a difference of that.  A trial that begins in one
// place and flies apart is another scene in the end: a frame with more to do
// than the median frame (bodies awake, contacts, particles near something) may
// cost as many times more.  A sanitizer makes all of it ten times as slow.
static const double MOST = 50;
#if defined(__SANITIZE_ADDRESS__)       // gcc says so
#define IS_SLOW
#elif defined(__has_feature)            // clang says so
#if __has_feature(address_sanitizer)
#define IS_SLOW
#endif
#endif
#ifdef IS_SLOW
enum { SLOWER = 10 };
#else
enum { SLOWER = 1 };
#endif
static const double LEAST = SLOWER * 0.2e-3;    // s
enum { STEPS_A_SECOND = 8 };    // a trial that is slower never ends

// What a trial leaves: shared with the process that runs it.
typedef struct {
    volatile int step;
    char what[TRIAL_TEXT], why[TRIAL_TEXT];
} outcome;

static outcome *result;
static double *cost;        // s, [steps] of each frame; 0: all asleep
static double *work;        // [steps] how many things there were to do in it

// ---- One trial -------------------------------------------------------------

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double work_of(const world *w)
{
    const step_report *r = &w->report;
    return 1 + w->bodies - r->asleep + r->contacts + r->near;
}

// Of two runs of the same trial a frame costs what it cost in the cheaper one.
static void run(unsigned long long seed, int steps, bool is_again)
{
    static trial t;
    bool is_well = trial_make(&t, seed) == TRIAL_WELL;
    memcpy(result->what, t.what, TRIAL_TEXT);
    for (int k = 0; k < steps && is_well; k++) {
        result->step = k;
        double start = cpu_seconds();
        is_well = trial_step(&t) == TRIAL_WELL;
        double took = cpu_seconds() - start;
        if (t.world.report.asleep == t.world.bodies) took = 0;
        cost[k] = is_again && cost[k] < took ? cost[k] : took;
        work[k] = work_of(&t.world);
    }
    memcpy(result->why, t.why, TRIAL_TEXT);
    trial_free(&t);
}

static int is_more(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Of costs, or of costs for a thing to do; only frames that cost something.
static double median(int steps, bool is_each)
{
    double *sorted = malloc((size_t)steps * sizeof *sorted);
    int count = 0;
    for (int k = 0; k < steps; k++)
        if (cost[k] > 0) sorted[count++] = cost[k] / (is_each ? work[k] : 1);
    qsort(sorted, (size_t)count, sizeof *sorted, is_more);
    double middle = count > 0 ? sorted[count / 2] : 0;
    free(sorted);
    return middle;
}

// The frame that costs most beside what it may, if that is too much; -1: none.
static int find_costly(int steps, double *fair)
{
    double usual = median(steps, false), each = median(steps, true);
    double most = MOST;
    int worst = -1;
    if (usual < LEAST) usual = LEAST;
    for (int k = 0; k < steps; k++) {
        double may = each * work[k] > usual ? each * work[k] : usual;
        if (cost[k] <= most * may) continue;
        most = cost[k] / may;
        worst = k;
        *fair = may;
    }
    return worst;
}

static void run_trial(unsigned long long seed, int steps)
{
    double fair = 0;
    memset(cost, 0, (size_t)steps * sizeof *cost);
    run(seed, steps, false);
    if (result->why[0] || find_costly(steps, &fair) < 0) return;
    run(seed, steps, true);
    int k = find_costly(steps, &fair);
    if (k < 0) return;
    snprintf(result->why, TRIAL_TEXT, "takes %.3g ms, where %.3g are usual",
             1e3 * cost[k], 1e3 * fair);
    result->step = k;
}

// ---- In a process of its own -----------------------------------------------

// What the process said before it ended: the line about what was wrong.
static void read_last_words(FILE *said)
{
    char line[TRIAL_TEXT];
    rewind(said);
    while (fgets(line, sizeof line, said)) {
        line[strcspn(line, "\n")] = '\0';
        if (strstr(line, "ssertion") || strstr(line, "rror"))
            { memcpy(result->why, line, sizeof line); return; }
    }
}

static void explain_end(int how, FILE *said)
{
    snprintf(result->why, TRIAL_TEXT, "ended with status %d", how);
    if (WIFSIGNALED(how))
        snprintf(result->why, TRIAL_TEXT, "signal %d", WTERMSIG(how));
    if (WIFSIGNALED(how) && WTERMSIG(how) == SIGXCPU)
        snprintf(result->why, TRIAL_TEXT, "takes so long that it never ends");
    read_last_words(said);
}

// True if all held.
static bool try_seed(unsigned long long seed, int steps)
{
    FILE *said = tmpfile();
    int how = 0;
    memset(result, 0, sizeof *result);
    fflush(stdout);
    pid_t child = said ? fork() : -1;
    if (child < 0) { perror("fuzz_world"); exit(2); }
    if (child == 0) {
        rlim_t longest = (rlim_t)(SLOWER * (10 + steps / STEPS_A_SECOND));
        struct rlimit most = { longest, longest + 1 };
        setrlimit(RLIMIT_CPU, &most);
        dup2(fileno(said), STDERR_FILENO);
        run_trial(seed, steps);
        _exit(0);
    }
    waitpid(child, &how, 0);
    if (how != 0) explain_end(how, said);
    fclose(said);
    if (result->why[0])
        printf("seed %llu, step %d: %s (%s)\n", seed, result->step,
               result->why, result->what);
    return result->why[0] == '\0';
}

// ---- All of them -----------------------------------------------------------

static int run_all(unsigned long long first, unsigned long long last,
                   long seconds, int steps)
{
    time_t start = time(NULL);
    int failed = 0, runs = 0;
    for (unsigned long long seed = first; seed <= last; seed++) {
        if (time(NULL) - start >= seconds) break;
        failed += !try_seed(seed, steps);
        runs++;
    }
    printf("Done %d runs in %ld second(s)\n", runs, (long)(time(NULL) - start));
    return failed > 0;
}

static void *shared(size_t size)
{
    void *at = mmap(NULL, size, PROT_READ | PROT_WRITE,
                    MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) { perror("fuzz_world"); exit(2); }
    return at;
}

int main(int count, char **word)
{
    unsigned long long seed[2] = { 0, 0 };
    long most[2] = { LONG_MAX, STEPS };         // seconds, steps
    bool is_understood = count >= 2 && count <= 5;
    for (int k = 1; k < count && is_understood; k++) {
        char *end;
        unsigned long long n = strtoull(word[k], &end, 10);
        if (k <= 2) seed[k - 1] = n;
        else        most[k - 3] = (long)n;
        is_understood = *end == '\0' && end > word[k];
    }
    if (!is_understood || most[1] < 1 || most[1] > 1000000) {
        fprintf(stderr, "usage: fuzz_world FIRST [LAST [SECONDS [STEPS]]]\n");
        return 2;
    }
    result = shared(sizeof *result);
    cost = shared((size_t)most[1] * sizeof *cost);
    work = shared((size_t)most[1] * sizeof *work);
    if (count > 2)
        return run_all(seed[0], seed[1], most[0], (int)most[1]);
    run_trial(seed[0], STEPS);
    printf("seed %llu: %s\n%s\n", seed[0], result->what,
           result->why[0] ? result->why : "all is well");
    return result->why[0] != '\0';
}
