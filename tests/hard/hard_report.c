// hard_report.c - see hard.h.

#include "hard.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

const hard_case *hard_find(int number)
{
    for (const hard_case *const *l = hard_all.list; *l; l++)
        for (const hard_case *c = *l; c->number > 0; c++)
            if (c->number == number) return c;
    return NULL;
}

void hard_add(hard_report *r, double error, double target, const char *unit,
              const char *format, ...)
{
    assert(r->parts < HARD_PARTS);
    hard_part *p = &r->part[r->parts++];
    va_list words;
    va_start(words, format);
    vsnprintf(p->what, sizeof p->what, format, words);
    va_end(words);
    snprintf(p->unit, sizeof p->unit, "%s", unit);
    p->error = error;
    p->target = target;
}

void hard_note(hard_report *r, const char *format, ...)
{
    assert(r->notes < HARD_NOTES);
    va_list words;
    va_start(words, format);
    vsnprintf(r->note[r->notes++], sizeof r->note[0], format, words);
    va_end(words);
}

int hard_ok(hard_report *r, status so_far)
{
    if (so_far.ok) return 1;
    hard_add(r, HUGE_VAL, 0, "", "was built");
    hard_note(r, "%s", so_far.why);
    return 0;
}

int hard_holds(const hard_part *p)
{
    return p->error <= p->target;
}

double hard_ratio(const hard_part *p)
{
    if (p->error != p->error) return HUGE_VAL;
    if (p->error == 0) return 0;
    return p->target > 0 ? p->error / p->target : HUGE_VAL;
}

const hard_part *hard_worst(const hard_report *r)
{
    assert(r->parts > 0);
    int worst = 0;
    for (int i = 1; i < r->parts; i++)
        if (hard_ratio(&r->part[i]) > hard_ratio(&r->part[worst])) worst = i;
    return &r->part[worst];
}

double hard_worse(double so_far, double now)
{
    if (now != now) return HUGE_VAL;
    return now > so_far ? now : so_far;
}

double hard_order(const double *step, const double *error, int n)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < n; i++) {
        double a = log(step[i]), b = log(error[i]);
        x += a / n;
        y += b / n;
        xx += a * a / n;
        xy += a * b / n;
    }
    return (xy - x * y) / (xx - x * x);
}
