// piles.c - boxes in piles, by this library and by others, in one run: what a
// step costs, beside what is wrong with it.
//
// Prints a block for each scene and each mover, in the order of main and
// of MOVER; columns: setting, ms a step, and in mm overlap, moved, crept; boxes
// outside.  What takes too long to be seen to its end has a time alone.  Lines
// that begin with #= are the rows of a table: every mover as it comes, awake
// and with sleeping.
// All movers of a scene take turns, some frames each; error is measured by one
// judge, from where the boxes lie alone.

#include "clock.h"
#include "piles.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

NEVER_RETURNS void give_up(const char *why)
{
    fprintf(stderr, "piles: %s\n", why);
    exit(1);
}

// ---- What is run -----------------------------------------------------------

enum { MOVERS = 4, SETTINGS = 6 };

// A mover with the settings of its curve.  The one in `as_it_comes` is what its
// users get who set nothing.
static const struct {
    const mover *is;
    const char  *name, *unit;
    real longest;       // s, a run that takes more is cut off
    int  settings, setting[SETTINGS], as_it_comes;
} MOVER[MOVERS] = {
    { &mover_tumble, "tumble", "substeps", 60, 5, { 1, 2, 4, 8, 16 }, 8 },
    { &mover_ode, "ODE quickstep", "iterations", 60, 6,
      { 5, 10, 20, 40, 80, 160 }, 20 },
    { &mover_ode, "ODE dWorldStep", "", 10, 1, { 0 }, 0 },
    { &mover_bullet, "Bullet", "iterations", 60, 6, { 5, 10, 20, 40, 80, 160 },
      10 },
};

enum { RUNS = MOVERS * (SETTINGS + 1), TURN = 20, JUDGED = 5, MIDDLE = 300 };

typedef struct {
    int   mover, setting;
    bool  may_sleep, is_cut;
    void *self;
    int   frames, asleep_at;        // -1: not all are
    real  seconds;
    pose *now, *middle;             // [boxes] at the end; at MIDDLE
    verdict found;
} run;

static run all[RUNS];
static int runs;

static void add_run(const pile *p, int m, int setting, bool may_sleep)
{
    run *r = &all[runs++];
    *r = (run){ .mover = m, .setting = setting, .may_sleep = may_sleep,
                .asleep_at = -1 };
    r->self = MOVER[m].is->begin(p, setting, may_sleep);
    r->now = malloc((size_t)p->boxes * sizeof *r->now);
    r->middle = malloc((size_t)p->boxes * sizeof *r->middle);
    if (!r->now || !r->middle) give_up("there is no memory for a run");
}

static void end_run(run *r)
{
    MOVER[r->mover].is->end(r->self);
    free(r->now);
    free(r->middle);
}

// ---- A run -----------------------------------------------------------------

static void look(const pile *p, run *r, pose *to)
{
    for (int k = 0; k < p->boxes; k++)
        to[k] = MOVER[r->mover].is->look(r->self, k);
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
    const mover *m = MOVER[r->mover].is;
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
        r->is_cut = r->seconds > MOVER[r->mover].longest
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

static void print_curves(const pile *p)
{
    for (int m = 0; m < MOVERS; m++) {
        printf("# %s of %d, %s\n# %s ms overlap moved crept outside\n",
                p->name, p->boxes, MOVER[m].name, MOVER[m].unit);
        for (int k = 0; k < runs; k++)
            if (all[k].mover == m && !all[k].may_sleep)
                print_point(&all[k]);
        printf("\n\n");
    }
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
           MOVER[awake->mover].name, ms_of(awake));
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
        print_mm(v->crept);
    }
    if (!asleep)                    printf(",\n");
    else if (asleep->asleep_at < 0) printf("never,");
    else                            printf("step %d,", asleep->asleep_at);
    if (asleep) printf("%.0f ms\n", 1e3 * asleep->seconds);
}

static const run *find_run(int m, bool may_sleep)
{
    for (int k = 0; k < runs; k++)
        if (all[k].mover == m && all[k].may_sleep == may_sleep
            && all[k].setting == MOVER[m].as_it_comes) return &all[k];
    return NULL;
}

// ---- All scenes ------------------------------------------------------------

static void run_scene(pile p)
{
    runs = 0;
    for (int m = 0; m < MOVERS; m++) {
        for (int k = 0; k < MOVER[m].settings; k++)
            add_run(&p, m, MOVER[m].setting[k], false);
        if (MOVER[m].settings > 1)
            add_run(&p, m, MOVER[m].as_it_comes, true);
    }
    fprintf(stderr, "piles: %s of %d\n", p.name, p.boxes);
    run_all(&p);
    print_curves(&p);
    for (int m = 0; m < MOVERS; m++)
        print_row(&p, find_run(m, false), find_run(m, true));
    fflush(stdout);
    for (int k = 0; k < runs; k++) end_run(&all[k]);
    pile_free(&p);
}

int main(void)
{
    clock_print_head("Boxes in piles: ms a step and what is wrong", FLAGS);
    run_scene(pile_pyramid(20));
    run_scene(pile_tower(20));
    run_scene(pile_drop(1000));
    run_scene(pile_thrown(200));
    return 0;
}
