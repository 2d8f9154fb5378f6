// peers.c - the same work by this library and by others, in one run.  Shows the
// table line by line as it comes, on stderr; prints it as CSV in the end.
//
// Both sides take turns, in rounds: the machine may be busy, and ratios hold.

#include "clock.h"
#include "peers_others.h"
#include "peers.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

_Noreturn void give_up(const char *why)
{
    fprintf(stderr, "peers: %s\n", why);
    exit(1);
}

// ---- The clock -------------------------------------------------------------

static real timed(const way *w, int piece)
{
    if (w->prepare) w->prepare(piece);
    real start = clock_seconds();
    w->run(piece);
    return clock_seconds() - start;
}

real *time_in_turn(const way *ways, int count, int pieces, int rounds)
{
    size_t all = (size_t)count * (size_t)pieces, each = (size_t)rounds;
    real *sample = malloc(all * each * sizeof *sample);
    real *time = malloc(all * sizeof *time);
    if (!sample || !time) give_up("there is no memory for the times");
    for (int round = rounds > 1 ? -1 : 0; round < rounds; round++)
        for (int piece = 0; piece < pieces; piece++)
            for (int k = 0; k < count; k++) {
                int w = (k + piece + round + 1) % count;
                real taken = timed(&ways[w], piece);
                if (round >= 0)
                    sample[(w * pieces + piece) * rounds + round] = taken;
            }
    for (size_t k = 0; k < all; k++)
        time[k] = clock_median(sample + k * each, rounds);
    free(sample);
    return time;
}

real time_sum(const real *time, int pieces, int w)
{
    real sum = 0;
    for (int piece = 0; piece < pieces; piece++)
        sum += time[w * pieces + piece];
    return sum;
}

// ---- The table -------------------------------------------------------------

enum { ROWS = 40, CELLS = 9 };
static row table[ROWS];
static int rows;

// A row as it is printed.
typedef struct { char cell[CELLS][TEXT]; } line;

static const char *const head[CELLS] = {
    "what", "against", "ours", "theirs", "ratio", "target", "our error",
    "their error", "verdict"
};

static const char *verdict(const row *r)
{
    if (r->is_quoted) return "not measured here";
    if (!(r->ratio > 0) && !(r->most > 0)) return "";
    int is_slow = (r->ratio > 0 && !(r->ours <= r->ratio * r->theirs))
               || (r->most > 0 && !(r->ours <= r->most));
    return is_slow || r->is_wrong ? "falls short" : "holds";
}

static void print_target(const row *r, char *to)
{
    if (r->ratio > 0) snprintf(to, TEXT, "%.3g x", r->ratio);
    else if (r->most > 0) snprintf(to, TEXT, "%.3g %s", r->most, r->unit);
}

// With three digits, and never as 1e+03.
static void print_time(real t, const row *r, const char *beside, char *to)
{
    snprintf(to, TEXT, t < 1000 ? "%.3g %s%s" : "%.0f %s%s", t, r->unit,
             beside);
}

static line line_of(const row *r)
{
    line l = { { "" } };
    snprintf(l.cell[0], TEXT, "%s", r->what);
    snprintf(l.cell[1], TEXT, "%s", r->against);
    print_time(r->ours, r, "", l.cell[2]);
    if (r->theirs > 0) {
        print_time(r->theirs, r, r->is_quoted ? " (quoted)" : "", l.cell[3]);
        if (!r->is_quoted)
            snprintf(l.cell[4], TEXT, "%.3g x", r->ours / r->theirs);
    }
    print_target(r, l.cell[5]);
    snprintf(l.cell[6], TEXT, "%s", r->our_error);
    snprintf(l.cell[7], TEXT, "%s", r->their_error);
    snprintf(l.cell[8], TEXT, "%s", verdict(r));
    return l;
}

static void print_line(line l)
{
    static const int width[CELLS] = { 45, 29, 9, 17, 8, 8, 44, 44, 0 };
    for (int c = 0; c < CELLS; c++)
        fprintf(stderr, "%-*s ", width[c], l.cell[c]);
    fprintf(stderr, "\n");
}

void table_add(row r)
{
    if (rows == 0) {
        line l;
        for (int c = 0; c < CELLS; c++)
            snprintf(l.cell[c], TEXT, "%s", head[c]);
        print_line(l);
    }
    if (rows == ROWS) give_up("the table is full");
    table[rows++] = r;
    print_line(line_of(&r));
}

// ---- The CSV ---------------------------------------------------------------

static void print_csv(void)
{
    clock_print_head("The same work by this library and by others, in one run",
                     FLAGS);
    printf("# libccd and %s as their packages were built\n", ode_name());
    for (int c = 0; c < CELLS; c++)
        printf("%s%s", head[c], c + 1 < CELLS ? "," : "\n");
    for (int k = 0; k < rows; k++) {
        line l = line_of(&table[k]);
        for (int c = 0; c < CELLS; c++)
            printf("\"%s\"%s", l.cell[c], c + 1 < CELLS ? "," : "\n");
    }
}

int main(void)
{
    peers_pairs();
    peers_rooms();
    peers_sticks();
    print_csv();
    return 0;
}
