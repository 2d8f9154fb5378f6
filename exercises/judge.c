// judge.c - stands between Check and a reader's code.
//
// Check runs every test in a process of its own, and says how each ended.  Two
// things it cannot see.  A test whose code calls exit(0) looks as if it had
// passed: so the judge says when a test has ended, and one that never says so
// did not.  And a test that never ends is stopped by the clock on the wall,
// which on a busy machine stops others too: so the judge counts the time
// computed, and says it.

#define _XOPEN_SOURCE 700

#include "judge.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static void say(const char *what)
{
    // On a line of its own, whatever the reader's code has printed.
    char line[300];
    int n = snprintf(line, sizeof line, "\njudge: %s\n", what);
    if (n > 0 && write(2, line, (size_t)n) < 0) _exit(1);
}

// Of the sanitizers, with which every judge is linked: which line is being run,
// and from where it was called.
void __sanitizer_print_stack_trace(void);

static double limit;     // s of computing, for the test that runs

// One test without end is enough: the file JUDGE_STOP stops those after it.  To
// tell the line may take memory, and the loop may have been interrupted while it
// did the same: if the two wait for each other, the alarm ends both.
static void never_ends(int number)
{
    (void)number;
    const char *stop = getenv("JUDGE_STOP");
    if (stop) close(open(stop, O_WRONLY | O_CREAT, 0666));
    char why[60];
    snprintf(why, sizeof why, "endless %g", limit);
    say(why);
    signal(SIGALRM, SIG_DFL);
    alarm(20);
    __sanitizer_print_stack_trace();
    _exit(1);
}

static void limit_time(double seconds)
{
    long whole = (long)seconds, rest = (long)(1e6 * (seconds - (double)whole));
    struct itimerval timer = { { 0, 0 }, { whole, rest } };
    struct sigaction action = { .sa_handler = never_ends };
    limit = seconds;
    sigaction(SIGPROF, &action, NULL);
    setitimer(ITIMER_PROF, &timer, NULL);
}

// The file JUDGE_TIMES has a line for each test that was timed with the book's
// own answer: its name, and the seconds after which it is stopped.
static double seconds_for(const char *test)
{
    const char *all = getenv("JUDGE_SECONDS"), *times = getenv("JUDGE_TIMES");
    double seconds = all ? atof(all) : 2, own;
    char name[200];
    FILE *f = times && *times ? fopen(times, "r") : NULL;
    while (f && fscanf(f, "%199s %lf %*f", name, &own) == 2)
        if (strcmp(name, test) == 0) seconds = own;
    if (f) fclose(f);
    return seconds;
}

// A right answer may round otherwise than ours: whether every machine gets our
// bits is not asked of a reader.
int judge_wants(const char *name)
{
    const char *only = getenv("ONLY"), *leave = getenv("LEAVE");
    if (strcmp(name, "the_same_bits_everywhere") == 0) return 0;
    if (leave && strstr(leave, name)) return 0;
    return !only || !*only || strcmp(only, name) == 0;
}

void judge_trial(const char *name, void (*test)(int), int i)
{
    const char *stop = getenv("JUDGE_STOP");
    if (stop && access(stop, F_OK) == 0) return;

    // What the reader's code prints comes in its place among what is said here.
    dup2(2, 1);
    setvbuf(stdout, NULL, _IONBF, 0);
    char what[250];
    snprintf(what, sizeof what, "begin %s", name);
    say(what);
    double seconds = seconds_for(name);
    clock_t began = clock();
    limit_time(seconds);
    test(i);
    limit_time(0);
    snprintf(what, sizeof what, "end %s %.4f", name,
             (double)(clock() - began) / CLOCKS_PER_SEC);
    say(what);
}
