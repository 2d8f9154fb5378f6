// stage_main.c - runs the scenes that are named, or all: does each hold what it
// claims?   cc stage_main.c stages.c pyramid.c ... -ltumble -lm

#include "stage.h"

#include <stdio.h>
#include <string.h>

static bool is_wanted(const stage *s, int count, char **name)
{
    for (int k = 1; k < count; k++)
        if (strcmp(name[k], s->name) == 0) return true;
    return count == 1;
}

static bool run(const stage *s)
{
    tumble_options o = s->options ? s->options() : tumble_options_default();
    tumble_world *w = tumble_make(&o);
    if (w) s->build(w);
    while (w && tumble_time(w) < s->seconds && !tumble_failure(w)) {
        if (s->act) s->act(w);
        tumble_step(w);
    }
    const char *why = tumble_failure(w);
    double error = why ? 0 : s->error(w);
    bool holds = !why && error <= s->most;
    if (why) printf("%s: %s\n", s->name, why);
    else printf("%s: %s: %s (%.3g, at most %.3g)\n", s->name,
                holds ? "holds" : "FAILS", s->claim, error, s->most);
    tumble_free(w);
    return holds;
}

int main(int count, char **name)
{
    bool all = true;
    for (int k = 0; stages[k]; k++)
        if (is_wanted(stages[k], count, name)) all = run(stages[k]) && all;
    return !all;
}
