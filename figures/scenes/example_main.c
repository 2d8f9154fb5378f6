// example_main.c - runs the named scenes, or all: does each hold its claim?
//   cc example_main.c examples.c pyramid.c ... -ltumble -lm

#include "example.h"

#include <stdio.h>
#include <string.h>

static bool is_wanted(const example *s, int count, char **name)
{
    for (int k = 1; k < count; k++)
        if (strcmp(name[k], s->name) == 0) return true;
    return count == 1;
}

static void tell_laws(const example *s, tumble_world *w)
{
    example_law is[EXAMPLE_LAWS];
    int n = s->laws(w, is);
    for (int k = 0; k < n; k++)
        printf("  %s: %.5g, by the law %.5g\n", is[k].what, is[k].measured,
               is[k].law);
}

static bool run(const example *s)
{
    tumble_options o = s->options ? s->options() : tumble_options_default();
    tumble_world *w = tumble_world_make(&o);
    if (w) s->build(w);
    while (w && tumble_world_time(w) < s->seconds && !tumble_world_failure(w)) {
        if (s->act) s->act(w);
        tumble_world_step(w);
    }
    const char *why = tumble_world_failure(w);
    double error = why ? 0 : example_error(s, w);
    bool holds = !why && error <= s->most;
    if (why) printf("%s: %s\n", s->name, why);
    else printf("%s: %s: %s (%.3g, at most %.3g)\n", s->name,
                holds ? "holds" : "FAILS", s->claim, error, s->most);
    if (!why && s->laws) tell_laws(s, w);
    tumble_world_free(w);
    return holds;
}

int main(int count, char **name)
{
    bool all = true;
    for (int k = 0; examples[k]; k++)
        if (is_wanted(examples[k], count, name)) all = run(examples[k]) && all;
    return !all;
}
