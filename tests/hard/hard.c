// hard.c - runs hard cases, one line each, and counts them: `hard` those of the
// engine, `families` those through tumble.h.
//
//   hard                  all of them
//   hard 3 17             some
//   hard --fast           the short forms, those that make test runs
//   hard --parts          every number of a case, and its notes, under its line
//   hard --list           numbers and names
//   hard --head           the head of its table in figures/tables
//   hard --row 3          what case 3 writes below it; its line goes to stderr
//
// Ends with 0 if all hold, 1 if some fall short, 2 if it was not understood; with
// --row, 0 if it was run.

#include "hard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

typedef struct {
    int fast, parts, some, list, head, row;
    int chosen[HARD_LAST + 1];
} options;

static int refuse(const char *what, const char *word)
{
    fprintf(stderr, "%s: %s %s\n"
            "usage: [--fast] [--parts] [NUMBER ...]\n"
            "       --list | --head | --row NUMBER\n",
            hard_all.program, what, word);
    return 0;
}

static int choose(options *o, const char *word)
{
    char *end;
    long number = strtol(word, &end, 10);
    if (*end != '\0' || number < 1 || number > HARD_LAST)
        return refuse("there is no case", word);
    if (!hard_find((int)number)) return refuse("not built yet: case", word);
    o->chosen[number] = o->some = 1;
    return 1;
}

static int read_options(options *o, int count, char **word)
{
    for (int i = 1; i < count; i++) {
        if (strcmp(word[i], "--fast") == 0)       o->fast = 1;
        else if (strcmp(word[i], "--parts") == 0) o->parts = 1;
        else if (strcmp(word[i], "--list") == 0)  o->list = 1;
        else if (strcmp(word[i], "--head") == 0)  o->head = 1;
        else if (strcmp(word[i], "--row") == 0)   o->row = 1;
        else if (!choose(o, word[i])) return 0;
    }
    return 1;
}

static const char *verdict(const hard_part *p)
{
    return hard_holds(p) ? "holds" : "FALLS SHORT";
}

static void print_line(FILE *out, const hard_case *c, const hard_report *r,
                       double seconds, int parts)
{
    const hard_part *w = hard_worst(r);
    fprintf(out, "%2d  %-31s %-44s %9.2e %9.2e %-5s %6.2f s  %s\n", c->number,
            c->name, w->what, w->error, w->target, w->unit, seconds,
            verdict(w));
    for (int i = 0; parts && i < r->parts; i++) {
        const hard_part *p = &r->part[i];
        fprintf(out, "    %-31s %-44s %9.2e %9.2e %-5s %8s  %s\n", "", p->what,
                p->error, p->target, p->unit, "", verdict(p));
    }
    for (int i = 0; parts && i < r->notes; i++)
        fprintf(out, "    - %s\n", r->note[i]);
    fflush(out);
}

// The line of the table; below it, as comments, every number and note.
static void write_row(const hard_case *c, const hard_report *r, double seconds)
{
    const hard_part *w = hard_worst(r);
    printf("%d,\"%s\",\"%s\",%.2g %s,%.2g %s,%.1f,%s\n", c->number, c->name,
           w->what, w->error, w->unit, w->target, w->unit, seconds, verdict(w));
    for (int i = 0; i < r->parts; i++) {
        const hard_part *p = &r->part[i];
        printf("# %d: %s: %.6g %s, target %.6g, %s\n", c->number, p->what,
               p->error, p->unit, p->target, verdict(p));
    }
    for (int i = 0; i < r->notes; i++)
        printf("# %d: %s\n", c->number, r->note[i]);
}

static int run_case(const hard_case *c, const options *o)
{
    hard_report *r = calloc(1, sizeof *r);
    if (!r) {
        fprintf(stderr, "%s: there is no memory for case %d\n",
                hard_all.program, c->number);
        return 0;
    }
    clock_t start = clock();
    c->run(r, o->fast);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    print_line(o->row ? stderr : stdout, c, r, seconds, o->parts);
    if (o->row) write_row(c, r, seconds);
    int holds = hard_holds(hard_worst(r));
    free(r);
    return holds;
}

static int is_chosen(const hard_case *c, const options *o)
{
    return c && (!o->some || o->chosen[c->number]) && (!o->fast || c->fast);
}

static int run_all(const options *o)
{
    int run = 0, hold = 0;
    printf("    %-31s %-44s %9s %9s\n", "case", "measured (the worst)", "error",
           "target");
    for (int number = 1; number <= HARD_LAST; number++) {
        const hard_case *c = hard_find(number);
        if (!is_chosen(c, o)) continue;
        run++;
        hold += run_case(c, o);
    }
    printf("%d of %d hold\n", hold, run);
    return hold == run;
}

static int list_all(void)
{
    for (int number = 1; number <= HARD_LAST; number++)
        if (hard_find(number))
            printf("%2d  %s\n", number, hard_find(number)->name);
    return 0;
}

static int print_head(void)
{
    printf("# %s\n# compiler: %s; flags: %s\n"
           "number,case,measured,error,target,seconds,verdict\n",
           hard_all.title, __VERSION__, FLAGS);
    return 0;
}

static int run_rows(const options *o)
{
    for (int number = 1; number <= HARD_LAST; number++)
        if (o->chosen[number]) run_case(hard_find(number), o);
    return fflush(stdout) == 0 ? 0 : 2;
}

int main(int count, char **word)
{
    options o = { 0 };
    if (!read_options(&o, count, word)) return 2;
    if (o.list) return list_all();
    if (o.head) return print_head();
    if (o.row)  return run_rows(&o);
    return run_all(&o) ? 0 : 1;
}
