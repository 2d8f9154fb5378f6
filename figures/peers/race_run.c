// race_run.c - scenes by several engines in one process, which take turns, some
// frames each; every throw by all of them.
//
// A time is that of the stepping thread.  A ratio is one of two times of the same
// throw, side by side; the tables have the medians and quartiles of the throws.

#define _POSIX_C_SOURCE 200809L

#include "clock.h"
#include "race.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

NEVER_RETURNS void give_up(const char *why)
{
    fprintf(stderr, "race: %s\n", why);
    exit(1);
}

enum { THROWS = 40, TURN = 20, JUDGED = 5, ALL_PAIRS = 30, MIDDLE = 300 };

// What one throw left.
typedef struct {
    bool was_run;
    int  frames, timed, asleep_at;      // -1: not all are
    real seconds, overlap, deep, gap, moved, crept;
    real strain, strain_end, into, crossings;
    int  lost;
} outcome;

typedef struct {
    const scene *s;
    const mover *is;
    bool may_sleep;
    void *self;
    pose *now, *middle;                 // [bodies]
    vec3 *vertex;                       // [side * side]
    verdict found;
    outcome out;
} run;

static real thread_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

// ---- One run ---------------------------------------------------------------

static run begin_run(const scene *s, const contender *by, bool may_sleep)
{
    size_t bodies = (size_t)s->bodies + 1;
    size_t vertices = (size_t)s->sheet.side * (size_t)s->sheet.side + 1;
    run r = { .s = s, .is = by->is, .may_sleep = may_sleep,
              .out = { .was_run = true, .asleep_at = -1 } };
    r.self = by->is->begin(s, by->setting, may_sleep);
    r.now = malloc(bodies * sizeof *r.now);
    r.middle = malloc(bodies * sizeof *r.middle);
    r.vertex = calloc(vertices, sizeof *r.vertex);
    if (!r.now || !r.middle || !r.vertex) give_up("there is no memory for a run");
    return r;
}

static void look(const run *r, pose *to)
{
    for (int k = 0; k < r->s->bodies; k++) to[k] = r->is->look(r->self, k);
}

static void judge(run *r)
{
    look(r, r->now);
    judge_bodies(r->s, r->now, r->out.frames % ALL_PAIRS == 0, &r->found);
    if (!r->s->sheet.side) return;
    r->is->vertices(r->self, r->vertex);
    judge_sheet(r->s, r->now, r->vertex, &r->found);
}

static void one_frame(run *r)
{
    outcome *o = &r->out;
    real begin = thread_seconds();
    r->is->step(r->self);
    real took = thread_seconds() - begin;
    if (o->frames++ >= r->s->timed_from) {
        o->seconds += took;
        o->timed++;
    }
    if (o->asleep_at < 0 && r->may_sleep
        && r->is->asleep(r->self) >= r->s->bodies - r->s->fixed)
        o->asleep_at = o->frames;
    if (o->frames == MIDDLE) look(r, r->middle);
    if (o->frames % JUDGED == 0) judge(r);
}

static real farthest(const run *r, bool from_middle)
{
    real most = 0;
    for (int k = r->s->fixed; k < r->s->bodies; k++) {
        vec3 was = from_middle ? r->middle[k].middle : r->s->body[k].at.middle;
        most = fmax(most, vec3_distance(r->now[k].middle, was));
    }
    return most;
}

static int compare_real(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

// Of numbers in order: what the share of them is below.
static real share_below(const real *x, int n, real share)
{
    if (n < 1) return 0;
    real at = share * (n - 1);
    int k = (int)at;
    return k + 1 < n ? x[k] + (at - k) * (x[k + 1] - x[k]) : x[n - 1];
}

static outcome end_run(run *r)
{
    outcome *o = &r->out;
    const verdict *v = &r->found;
    judge_the_judge(r->s, v);
    qsort(v->depth, (size_t)v->depths, v->depth ? sizeof *v->depth : 1, compare_real);
    o->deep = share_below(v->depth, v->depths, 0.99);
    o->overlap = v->overlap;
    o->gap = v->gap;
    o->moved = farthest(r, false);
    o->crept = o->frames > MIDDLE ? farthest(r, true) : 0;
    o->strain = v->strain;
    o->strain_end = v->strain_now;
    o->into = v->into;
    o->lost = v->lost;
    if (r->s->sheet.side) o->crossings = (real)judge_crossings(r->s, r->vertex);
    r->is->end(r->self);
    free(r->now);
    free(r->middle);
    free(r->vertex);
    free(v->depth);
    return *o;
}

// ---- All throws of a scene -------------------------------------------------

// [contender][awake, as it comes][throw]
static outcome all[CONTENDERS][2][THROWS];

static void take_turns(run *list, int n, int frames)
{
    for (int turn = 0; turn * TURN < frames; turn++)
        for (int k = 0; k < n; k++)
            for (int f = turn * TURN; f < (turn + 1) * TURN && f < frames; f++)
                one_frame(&list[(k + turn) % n]);
}

static void one_throw(const scene *s, const contender *by, int count, int throw)
{
    for (int how = 0; how < 2; how++) {
        if (!(s->runs & (how ? RUN_DEFAULT : RUN_AWAKE))) continue;
        run list[CONTENDERS];
        // Other settings than the engine's own are tried awake.
        int n = 0, which[CONTENDERS];
        for (int k = 0; k < count; k++)
            if (!how || !by[k].setting || s->runs == RUN_DEFAULT) which[n++] = k;
        for (int k = 0; k < n; k++) list[k] = begin_run(s, &by[which[k]], how);
        take_turns(list, n, s->frames);
        for (int k = 0; k < n; k++) all[which[k]][how][throw] = end_run(&list[k]);
    }
}

// ---- The tables ------------------------------------------------------------

typedef struct {
    real median, lower, upper;
} spread;

static spread spread_of(real *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, compare_real);
    return (spread){ share_below(x, n, 0.5), share_below(x, n, 0.25),
                     share_below(x, n, 0.75) };
}

static real ms_of(const outcome *o)
{
    return 1e3 * o->seconds / o->timed;
}

typedef real taken(const outcome *o);

static spread spread_by(const outcome *o, int throws, taken *of)
{
    real x[THROWS];
    for (int t = 0; t < throws; t++) x[t] = of(&o[t]);
    return spread_of(x, throws);
}

// Ours to theirs, throw by throw.
static spread ratio_of(int k, int how, int throws)
{
    real x[THROWS];
    for (int t = 0; t < throws; t++)
        x[t] = ms_of(&all[0][how][t]) / ms_of(&all[k][how][t]);
    return spread_of(x, throws);
}

static void print_spread(FILE *to, spread s)
{
    fprintf(to, ",%.3g,%.3g,%.3g", s.median, s.lower, s.upper);
}

static real mm_overlap(const outcome *o) { return 1e3 * o->overlap; }
static real mm_deep(const outcome *o) { return 1e3 * o->deep; }
static real mm_gap(const outcome *o) { return 1e3 * o->gap; }
static real mm_crept(const outcome *o) { return 1e3 * o->crept; }
static real mm_into(const outcome *o) { return 1e3 * o->into; }
static real percent(const outcome *o) { return 100 * o->strain; }
static real percent_end(const outcome *o) { return 100 * o->strain_end; }
static real crossings(const outcome *o) { return o->crossings; }
static real asleep_at(const outcome *o)
{
    return o->asleep_at < 0 ? HUGE_VAL : o->asleep_at;
}

// Awake, or as it comes, with the step at which all slept.
static void print_times(FILE *to, const char *name, const contender *by, int k,
                        int how, int throws)
{
    if (!all[k][how][0].was_run) return;
    fprintf(to, "%s,%s,%d", name, by->name, throws);
    print_spread(to, spread_by(all[k][how], throws, ms_of));
    print_spread(to, ratio_of(k, how, throws));
    real at = spread_by(all[k][how], throws, asleep_at).median;
    if (!how)          fprintf(to, "\n");
    else if (at < 1e9) fprintf(to, ",%.0f\n", at);
    else               fprintf(to, ",never\n");
}

static int count_falls(const scene *s, const outcome *o, int throws)
{
    int falls = 0;
    for (int t = 0; t < throws; t++) falls += o[t].moved > s->form[0].half.x * 2;
    return falls;
}

static int count_lost(const outcome *o, int throws)
{
    int lost = 0;
    for (int t = 0; t < throws; t++) lost += o[t].lost > 0;
    return lost;
}

static void print_errors(FILE *to, const scene *s, const char *name,
                         const contender *by, int k, int throws)
{
    const outcome *o = all[k][s->runs & RUN_AWAKE ? 0 : 1];
    fprintf(to, "%s,%s,%d", name, by->name, throws);
    print_spread(to, spread_by(o, throws, mm_overlap));
    fprintf(to, ",%.3g,", spread_by(o, throws, mm_deep).median);
    if (s->joints) fprintf(to, "%.3g", spread_by(o, throws, mm_gap).median);
    fprintf(to, ",");
    if (s->is_built && s->frames > MIDDLE)
        fprintf(to, "%.3g", spread_by(o, throws, mm_crept).median);
    fprintf(to, ",");
    if (s->is_built) fprintf(to, "%d", count_falls(s, o, throws));
    fprintf(to, ",%d\n", count_lost(o, throws));
}

static void print_cloth(FILE *to, const char *name, const contender *by, int k,
                        int throws)
{
    const outcome *o = all[k][0];
    fprintf(to, "%s,%s,%d", name, by->name, throws);
    if (count_lost(o, throws) == throws) {
        fprintf(to, ",lost,,,,,,,,%d\n", throws);
        return;
    }
    print_spread(to, spread_by(o, throws, percent));
    fprintf(to, ",%.3g", spread_by(o, throws, percent_end).median);
    print_spread(to, spread_by(o, throws, crossings));
    fprintf(to, ",%.3g,%d\n", spread_by(o, throws, mm_into).median,
            count_lost(o, throws));
}

static void name_scene(char *to, size_t room, const scene *s)
{
    int side = s->sheet.side;
    if (side) snprintf(to, room, "%s %d x %d", s->name, side, side);
    else      snprintf(to, room, "%s of %d", s->name, s->bodies);
}

static FILE *begin_table(const char *folder, const char *peer, const char *what,
                         const char *head)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s%s.csv", folder, peer, what);
    FILE *to = fopen(path, "w");
    if (!to) give_up("a table cannot be written");
    fprintf(to, "%s\n", head);
    return to;
}

race_form race_begin(const char *folder, const char *peer, int throws,
                     bool has_cloth)
{
    race_form f = { .throws = throws > 0 ? throws : 2, .is_quick = throws <= 0 };
    f.times[0] = begin_table(folder, peer, "-times",
        "scene,by,throws,ms a step,from,to,ratio,ratio from,ratio to");
    f.times[1] = begin_table(folder, peer, "-default",
        "scene,by,throws,ms a step,from,to,ratio,ratio from,ratio to,asleep at step");
    f.errors = begin_table(folder, peer, "",
        "scene,by,throws,overlap mm,from,to,99 of 100 mm,"
        "gap mm,crept mm,falls,lost");
    if (has_cloth) f.cloths = begin_table(folder, peer, "-cloth",
        "scene,by,throws,strain %,from,to,strain at the end %,crossings,"
        "crossings from,crossings to,in bodies mm,lost");
    return f;
}

void race_end(race_form *f)
{
    fclose(f->times[0]);
    fclose(f->times[1]);
    fclose(f->errors);
    if (f->cloths) fclose(f->cloths);
}

void race_scene(const race_form *f, scene_maker *make, int size,
                const contender *list, int count)
{
    char name[64];
    int throws = f->is_quick ? 2 : f->throws;
    if (throws > THROWS || count > CONTENDERS) give_up("too many throws or engines");
    memset(all, 0, sizeof all);
    for (int t = 0; t < throws; t++) {
        scene s = make(size, t + 1);
        name_scene(name, sizeof name, &s);
        if (f->is_quick) s.frames = s.timed_from + s.frames / 5;
        one_throw(&s, list, count, t);
        scene_free(&s);
    }
    scene s = make(size, 1);
    if (f->is_quick) s.frames = s.timed_from + s.frames / 5;
    for (int k = 0; k < count; k++) {
        for (int how = 0; how < 2; how++)
            print_times(f->times[how], name, &list[k], k, how, throws);
        if (s.sheet.side) print_cloth(f->cloths, name, &list[k], k, throws);
        else print_errors(f->errors, &s, name, &list[k], k, throws);
    }
    scene_free(&s);
    fflush(NULL);
    fprintf(stderr, "%s: %.0f s so far\n", name, thread_seconds());
}
