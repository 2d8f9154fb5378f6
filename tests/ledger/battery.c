// battery.c - runs scenes of the ledger.
//
//   battery            all: a line of name, error, unit, work and bits each
//   battery soft       those of one kind: rigid, held or soft
//   battery --list     name, unit, least error that matters, what is measured

#include "battery.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// The library is compiled to call this at every block of its code (a stretch
// without a branch): a measure of work that no other program disturbs.
static long long blocks;
#ifdef __clang__
#define UNCOUNTED __attribute__((no_sanitize("coverage")))
#else
#define UNCOUNTED __attribute__((no_sanitize_coverage))
#endif
void __sanitizer_cov_trace_pc(void);
UNCOUNTED void __sanitizer_cov_trace_pc(void)
{
    blocks++;
}

void battery_step(battery_run *r, double seconds)
{
    int steps = (int)(seconds * 60 + 0.5);
    for (int k = 0; k < steps; k++) {
        tumble_world_step(r->w);
        r->bits = 0x100000001b3u * (r->bits ^ tumble_world_hash(r->w));
    }
}

void battery_see(battery_run *r, double error)
{
    if (!(error <= r->worst)) r->worst = error == error ? error : HUGE_VAL;
}

static void run_scene(const battery_scene *s)
{
    battery_run r = { tumble_world_make(NULL), 0, 0 };
    blocks = 0;
    s->run(&r);
    long long work = blocks;
    if (tumble_world_failure(r.w)) {
        fprintf(stderr, "%s: %s\n", s->name, tumble_world_failure(r.w));
        r.worst = HUGE_VAL;
    }
    printf("%s,%.4g,%s,%lld,%016llx\n", s->name, r.worst, s->unit, work,
           r.bits);
    fflush(stdout);
    tumble_world_free(r.w);
}

int main(int count, char **word)
{
    static const struct {
        const char *name;
        const battery_scene *scene;
    } kind[] = { { "rigid", battery_rigid }, { "held", battery_held },
                 { "soft", battery_soft } };
    const char *only = count > 1 ? word[1] : NULL;
    bool lists = only && strcmp(only, "--list") == 0;
    for (int k = 0; k < 3; k++) {
        if (only && !lists && strcmp(only, kind[k].name) != 0) continue;
        for (const battery_scene *s = kind[k].scene; s->name; s++)
            if (lists) printf("%s,%s,%g,%s\n", s->name, s->unit, s->fine,
                              s->what);
            else run_scene(s);
    }
    return 0;
}
