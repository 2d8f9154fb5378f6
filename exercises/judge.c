// judge.c - stands between Check and a reader's code.
//
// Check runs every test in a process of its own, and says how each ended.  Two
// things it cannot see.  A test whose code calls exit(0) looks as if it had
// passed: so the judge says when a test has ended, and one that never says so
// did not.  And a test that never ends is stopped by the clock on the wall,
// which on a busy machine stops others too: so the judge counts the time
// computed.

#define _XOPEN_SOURCE 700

#include "judge.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

static void say(const char *what)
{
    // On a line of its own, whatever the reader's code has printed.
    char line[200];
    int n = snprintf(line, sizeof line, "\njudge: %s\n", what);
    if (n > 0 && write(2, line, (size_t)n) < 0) _exit(1);
}

// Of the sanitizers, with which every judge is linked: which line is being run,
// and from where it was called.
void __sanitizer_print_stack_trace(void);

// One test without end is enough: the file JUDGE_STOP stops those after it.  To
// tell the line may take memory, and the loop may have been interrupted while it
// did the same: if the two wait for each other, the alarm ends both.
static void never_ends(int number)
{
    (void)number;
    const char *stop = getenv("JUDGE_STOP");
    if (stop) close(open(stop, O_WRONLY | O_CREAT, 0666));
    say("endless");
    signal(SIGALRM, SIG_DFL);
    alarm(20);
    __sanitizer_print_stack_trace();
    _exit(1);
}

static void limit_time(int seconds)
{
    struct itimerval limit = { { 0, 0 }, { seconds, 0 } };
    struct sigaction action = { .sa_handler = never_ends };
    sigaction(SIGPROF, &action, NULL);
    setitimer(ITIMER_PROF, &limit, NULL);
}

// A right answer may round otherwise than ours: whether every machine gets our
// bits is not asked of a reader.
int judge_wants(const char *name)
{
    const char *only = getenv("ONLY");
    if (strcmp(name, "the_same_bits_everywhere") == 0) return 0;
    return !only || !*only || strcmp(only, name) == 0;
}

void judge_trial(const char *name, void (*test)(int), int i)
{
    const char *stop = getenv("JUDGE_STOP"), *seconds = getenv("JUDGE_SECONDS");
    if (stop && access(stop, F_OK) == 0) return;

    // What the reader's code prints comes in its place among what is said here.
    dup2(2, 1);
    setvbuf(stdout, NULL, _IONBF, 0);
    char begin[120];
    snprintf(begin, sizeof begin, "begin %s", name);
    say(begin);
    limit_time(seconds ? atoi(seconds) : 10);
    test(i);
    limit_time(0);
    say("end");
}
