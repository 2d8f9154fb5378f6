// piles_run.c - a scene by several movers, which take turns, some frames each;
// error is measured by one judge, from where the bodies lie alone.
//
// Prints a block for each mover, in the order of its list; columns: setting, ms a
// step, and in mm overlap, moved, crept; boxes outside.  What takes too long to be
// seen to its end has a time alone.  Lines that begin with #= are the rows of a
// table: every mover as it comes, awake and with sleeping.

#include "clock.h"
#include "piles.h"

#include <stdio.h>
#include <stdlib.h>

NEVER_RETURNS void give_up(const char *why)
{
    fprintf(stderr, "piles: %s\n", why);
    exit(1);
}

enum { RUNS = 4 * (SETTINGS + 1), TURN = 20, JUDGED = 5, MIDDLE = 300 };

typedef struct {
    const contender *by;
    int   setting;
    bool  may_sleep, is_cut;
    void *self;
    int   frames, asleep_at;        // -1: not all are
    real  seconds;
    pose *now, *middle;             // [boxes] at the end; at MIDDLE
    verdict found;
} run;

static run all[RUNS];
static int runs;

static void add_run(const pile *p, const contender *by, int setting,
                    bool may_sleep)
{
    if (runs == RUNS) give_up("there are too many runs");
    run *r = &all[runs++];
    *r = (run){ .by = by, .setting = setting, .may_sleep = may_sleep,
                .asleep_at = -1 };
    r->self = by->is->begin(p, setting, may_sleep);
    r->now = malloc((size_t)p->boxes * sizeof *r->now);
    r->middle = malloc((size_t)p->boxes * sizeof *r->middle);
    if (!r->now || !r->middle) give_up("there is no memory for a run");
}

static void end_run(run *r)
{
    r->by->is->end(r->self);
    free(r->now);
    free(r->middle);
}

// ---- A run -----------------------------------------------------------------

static void look(const pile *p, run *r, pose *to)
{
    for (int k = 0; k < p->boxes; k++)
        to[k] = r->by->is->look(r->self, k);
}

static real farthest(const pile *p, const pose *now, const pose *then)
{
    real most = 0;
    for (int k = 0; k < p->boxes; k++) {
        vec3 was = then ? then[k].middle : p->box[k].at.middle;
        most = fmax(most, vec3_distance(now[k].middle, was));
    }
    return most;
}

static void one_frame(const pile *p, run *r)
{
    const mover *m = r->by->is;
    real begin = clock_seconds();
    m->step(r->self);
    r->seconds += clock_seconds() - begin;
    r->frames++;
    if (r->asleep_at < 0 && r->may_sleep && m->asleep(r->self) == p->boxes)
        r->asleep_at = r->frames;
    if (r->frames == MIDDLE) look(p, r, r->middle);
    if (r->frames % JUDGED == 0) {
        look(p, r, r->now);
        judge_overlap(p, r->now, &r->found);
    }
}

static void take_turn(const pile *p, run *r)
{
    for (int k = 0; k < TURN && r->frames < p->frames && !r->is_cut; k++) {
        one_frame(p, r);
        r->is_cut = r->seconds > r->by->longest
                 && r->frames < p->frames;
    }
}

static void run_all(const pile *p)
{
    for (int turn = 0; turn * TURN < p->frames; turn++)
        for (int k = 0; k < runs; k++)
            take_turn(p, &all[(k + turn) % runs]);
    for (int k = 0; k < runs; k++) {
        run *r = &all[k];
        judge_the_judge(p, &r->found);
        r->found.moved = farthest(p, r->now, NULL);
        r->found.crept = farthest(p, r->now, r->middle);
    }
}

// ---- What is printed -------------------------------------------------------

static real ms_of(const run *r)
{
    return 1e3 * r->seconds / r->frames;
}

static void print_point(const run *r)
{
    const verdict *v = &r->found;
    printf("%d %.4g ", r->setting, ms_of(r));
    if (r->is_cut) printf("NaN NaN NaN NaN\n");
    else printf("%.3f %.3f %.4f %d\n", 1e3 * v->overlap, 1e3 * v->moved,
                 1e3 * v->crept, v->outside);
}

static void print_curve(const pile *p, const contender *by)
{
    printf("# %s of %d, %s\n# %s ms overlap moved crept outside\n",
           p->name, p->boxes, by->name, by->unit);
    for (int k = 0; k < runs; k++)
        if (all[k].by == by && !all[k].may_sleep) print_point(&all[k]);
    printf("\n\n");
}

static void print_mm(real m)
{
    if (m >= 10) printf("%.0f m,", m);
    else if (m >= 0.1) printf("%.2g m,", m);
    else printf("%.2g mm,", 1e3 * m);
}

static void print_row(const pile *p, const run *awake, const run *asleep)
{
    if (!awake) give_up("a mover has no run as it comes");
    const verdict *v = &awake->found;
    printf("#= %s of %d,%s,%.3g ms,", p->name, p->boxes,
           awake->by->name, ms_of(awake));
    if (awake->is_cut) {
        printf("cut off after %d steps,,,,\n", awake->frames);
        return;
    }
    print_mm(v->overlap);
    // What has fallen has gone by more than its size.
    if (p->is_built && v->moved > 2 * p->half) printf("falls,,");
    else {
        if (p->is_built) print_mm(v->moved);
        else             printf(",");
        if (p->frames > MIDDLE) print_mm(v->crept);
        else                    printf(",");
    }
    if (!asleep)                    printf(",\n");
    else if (asleep->asleep_at < 0) printf("never,");
    else                            printf("step %d,", asleep->asleep_at);
    if (asleep) printf("%.0f ms\n", 1e3 * asleep->seconds);
}

static const run *find_run(const contender *by, bool may_sleep)
{
    for (int k = 0; k < runs; k++)
        if (all[k].by == by && all[k].may_sleep == may_sleep
            && all[k].setting == by->as_it_comes) return &all[k];
    return NULL;
}

// ---- A scene ---------------------------------------------------------------

void run_scene(pile p, const contender *list, int count)
{
    runs = 0;
    for (const contender *by = list; by < list + count; by++) {
        for (int k = 0; k < by->settings; k++)
            add_run(&p, by, by->setting[k], false);
        if (by->may_sleep) add_run(&p, by, by->as_it_comes, true);
    }
    fprintf(stderr, "%s of %d\n", p.name, p.boxes);
    run_all(&p);
    for (int m = 0; m < count; m++) print_curve(&p, &list[m]);
    for (int m = 0; m < count; m++)
        print_row(&p, find_run(&list[m], false), find_run(&list[m], true));
    fflush(stdout);
    for (int k = 0; k < runs; k++) end_run(&all[k]);
    pile_free(&p);
}
