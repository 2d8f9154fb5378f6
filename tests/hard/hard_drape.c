// hard_drape.c - cases 27 to 36: cloth and rope on all kinds of things.

#include "hard.h"
#include "hard_drape_set.h"

#include <math.h>
#include <stdio.h>

static void add_targets(hard_report *r, const drape *d, const verdict *v,
                        const char *which, int fast)
{
    if (d->strain < HUGE_VAL)
        hard_add(r, v->off, d->strain, "", v->must > 0
                 ? "strain off springs; %s" : "strain; %s", which);
    if (d->end < HUGE_VAL)
        hard_add(r, v->end, d->end, "", "strain at the end; %s", which);
    if (d->rest < HUGE_VAL)
        hard_add(r, v->rest, d->rest, "", "strain at rest; %s", which);
    if (d->speed < HUGE_VAL)
        hard_add(r, 1e3 * v->speed, 1e3 * d->speed, "mm/s",
                 "speed at rest; %s", which);
    if (d->slowest < HUGE_VAL && !fast)
        hard_add(r, v->slowest / v->median, d->slowest, "",
                 "slowest frame / median; %s", which);
    hard_add(r, (double)v->crossings, 0, "", "crossings; %s", which);
    hard_add(r, (double)(v->inside + v->cutting + v->edges), 0, "",
             "inside, cutting, edges; %s", which);
    if (d->floor > -HUGE_VAL)
        hard_add(r, v->passed, 0, "", "ended below; %s", which);
}

// A case in its short form has one start a row, no cloth above 40, and nothing
// that a clock tells: it is a test, and a machine may be busy.
enum { SHORT = 40, ROWS = 8 };

static verdict run_row(hard_report *r, const drape *d, int fast)
{
    char which[40];
    verdict v = { .strain = 0 };
    int starts = fast ? 1 : d->n > 2 * SHORT ? 2 : d->starts;
    snprintf(which, sizeof which, "%s, %d", d->name, d->n);
    for (int k = 1; k <= d->starts && k <= starts; k++) {
        setting s;
        drape_build(&s, d, k);
        if (hard_ok(r, s.ok))
            if (!drape_watch(d, &s.w, &v))
                hard_ok(r, status_out_of_memory());
        setting_free(&s);
    }
    add_targets(r, d, &v, which, fast);
    return v;
}

static void run_case(hard_report *r, int number, int fast)
{
    real particles[ROWS], seconds[ROWS];
    int sizes = 0;
    for (const drape *d = drape_table; d->name; d++) {
        if (d->hard != number || (fast && d->n > SHORT)) continue;
        verdict v = run_row(r, d, fast);
        if (r->notes < HARD_NOTES)
            hard_note(r, "%s, %d: strain %.4f, at the end %.4f; in a frame "
                      "%.2f ms, at most %.0f; substeps %.1f", d->name, d->n,
                      v.strain, v.end, 1e3 * v.mean, 1e3 * v.slowest,
                      v.substeps);
        if (v.must > 0)
            hard_note(r, "springs beside %s, %d: strained by %.4f", d->name,
                      d->n, v.must);
        if (v.must > 0)
            hard_note(r, "off the springs, %s, %d: at most by %.4f", d->name,
                      d->n, v.off);
        if (number != 27 || sizes == ROWS) continue;
        particles[sizes] = (real)d->n * d->n;
        seconds[sizes++] = v.mean;
    }
    if (sizes > 1 && !fast)
        hard_add(r, hard_order(particles, seconds, sizes), 1.2, "",
                 "exponent of the time in the particles");
}

#define RUN(number) \
    static void run_##number(hard_report *r, int fast) \
    { \
        run_case(r, number, fast); \
    }
RUN(27)
RUN(28)
RUN(29)
RUN(30)
RUN(31)
RUN(32)
RUN(33)
RUN(34)
RUN(35)
RUN(36)

const hard_case hard_drape[] = {
    { 27, "cloth on the cube, 20 to 160", 1, run_27 },
    { 28, "cloth and rope on other things", 0, run_28 },
    { 29, "cloth on cloth", 0, run_29 },
    { 30, "cloth and spikes", 0, run_30 },
    { 31, "pinned cloth at rest", 0, run_31 },
    { 32, "cloth lands flat", 1, run_32 },
    { 33, "cloth thrown at the cube", 0, run_33 },
    { 34, "rope with a load, over the cube", 0, run_34 },
    { 35, "what moves into a held cloth", 0, run_35 },
    { 36, "silk, denim, card over the cube", 0, run_36 },
    { 0, NULL, 0, NULL }
};
