// drape.c - cloth and rope, scene by scene: a line of numbers each.
//
//     build/drape [--starts K] [--from N] [--up-to N] [--substeps N]
//                 [--compliance C] [SCENE ...]
//
// SCENE: the beginning of a name, or the number of a case.  K perturbed starts,
// else as many as the scene has; 0: the scene as it is.  A number that exceeds
// its target has an asterisk; the strain of a cloth that must be stretched, if
// it is further off that of springs.  Counts are the most in any frame.  N
// substeps a frame, whatever the cloth asks for; links of cloth that give by C
// (m/N).

#include "hard.h"
#include "hard_drape_set.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    int  starts, least, largest, substeps, names;
    real compliance;            // m/N; < 0: the scene's own
    char **name;
} options;

static int is_wanted(const options *o, const drape *d)
{
    char number[16];
    if (d->n < o->least || (o->largest > 0 && d->n > o->largest)) return 0;
    snprintf(number, sizeof number, "%d", d->hard);
    for (int k = 0; k < o->names; k++)
        if (strcmp(o->name[k], number) == 0
            || strstr(d->name, o->name[k]) == d->name) return 1;
    return o->names == 0;
}

static void print_head(void)
{
    printf("%-2s %-17s %3s %2s %8s %8s %8s %5s %5s %5s %5s %6s %6s %8s %8s "
           "%7s %5s\n", "", "scene", "n", "", "strain", "end", "at rest",
           "cross", "in", "cut", "edges", "mm in", "passed", "ms", "median",
           "worst/m", "subst");
}

static const char *mark(real x, real target)
{
    return x <= target ? " " : "*";
}

static void print_row(const drape *d, const verdict *v)
{
    real ratio = v->median > 0 ? v->slowest / v->median : 0;
    printf("%-2d %-17s %3d %2d ", d->hard, d->name, d->n, v->runs);
    printf("%7.2g%s %7.2g%s %7.2g%s ", v->strain, mark(v->off, d->strain),
           v->end, mark(v->end, d->end), v->rest, mark(v->rest, d->rest));
    printf("%4ld%s %4ld%s %4ld%s %4ld%s %6.2f %5d%s ",
           v->crossings, mark((real)v->crossings, 0),
           v->inside, mark((real)v->inside, 0),
           v->cutting, mark((real)v->cutting, 0),
           v->edges, mark((real)v->edges, 0), 1e3 * v->depth, v->passed,
           mark(d->floor > -HUGE_VAL ? v->passed : 0, 0));
    printf("%8.3f %8.3f %6.1f%s %5.1f", 1e3 * v->mean, 1e3 * v->median, ratio,
           mark(ratio, d->slowest), v->substeps);
    printf("   speed %.3g%s mm/s\n", 1e3 * v->speed,
           mark(v->speed, d->speed));
    fflush(stdout);
}

static void alter(setting *s, const options *o)
{
    world *w = &s->w;
    if (o->substeps > 0) w->options.substeps = w->options.most_substeps = o->substeps;
    for (int b = 0; b < w->bodies && s->ok.ok && o->compliance >= 0; b++)
        if (w->body[b].shape->kind == SHAPE_CLOTH) s->ok = world_stretch(w, b, o->compliance);
}

static int run_row(const drape *d, const options *o)
{
    verdict v = { .strain = 0 };
    int ok = 1, starts = o->starts >= 0 ? o->starts : d->starts;
    for (int k = 0; k < (starts > 0 ? starts : 1) && ok; k++) {
        setting s;
        drape_build(&s, d, starts > 0 ? k + 1 : 0);
        alter(&s, o);
        ok = s.ok.ok;
        if (!ok) fprintf(stderr, "drape: %s: %s\n", d->name, s.ok.why);
        else
            ok = drape_watch(d, &s.w, &v);
        setting_free(&s);
    }
    if (ok) print_row(d, &v);
    return ok;
}

int main(int count, char **word)
{
    options o = { .starts = -1, .compliance = -1 };
    int k = 1, ok = 1;
    for (; k + 1 < count && strncmp(word[k], "--", 2) == 0; k += 2) {
        if (strcmp(word[k], "--starts") == 0) o.starts = atoi(word[k + 1]);
        else if (strcmp(word[k], "--from") == 0) o.least = atoi(word[k + 1]);
        else if (strcmp(word[k], "--up-to") == 0)
            o.largest = atoi(word[k + 1]);
        else if (strcmp(word[k], "--substeps") == 0) o.substeps = atoi(word[k + 1]);
        else if (strcmp(word[k], "--compliance") == 0) o.compliance = atof(word[k + 1]);
        else break;
    }
    if (k < count && word[k][0] == '-') {
        fprintf(stderr, "usage: drape [--starts K] [--from N] [--up-to N] "
                        "[--substeps N] [--compliance C] [SCENE ...]\n");
        return 2;
    }
    o.names = count - k;
    o.name = word + k;
    print_head();
    for (const drape *d = drape_table; d->name; d++)
        if (is_wanted(&o, d))
            ok &= run_row(d, &o);
    return !ok;
}
