// live_main.c - a live figure on this machine: prints the hash of frame 60, as
// tests/bits/bits.txt keeps it; with --panel, what the page builds from it; with
// --film, a film.

#include "live_page.h"

#include <stdio.h>
#include <string.h>

static unsigned long long hash_of_frame_60(void)
{
    page_draw();
    for (int k = 0; k < LIVE_FRAMES; k++) page_step();
    page_draw();
    return page_hash();
}

// How many choices has the first dial?  1, if it is a slider.
static int variants(void)
{
    int n = 1;
    for (const char *c = figure.dial[0].choices; c && *c; c++) n += *c == '|';
    return n;
}

static unsigned long long hash_of_variant(int k)
{
    page_start();
    if (figure.dial[0].choices) page_turn(0, k);
    return hash_of_frame_60();
}

// --- JSON -------------------------------------------------------------------------
static void text(const char *name, const char *value)
{
    printf(value ? "\"%s\":\"%s\"," : "\"%s\":null,", name, value);
}

static void print_dials(void)
{
    printf("\"dials\":[");
    for (int k = 0; k < LIVE_DIALS && figure.dial[k].name; k++) {
        const live_dial_plan *d = &figure.dial[k];
        printf("%s{", k ? "," : "");
        text("name", d->name);
        text("unit", d->unit);
        text("choices", d->choices);
        printf("\"least\":%g,\"most\":%g,\"step\":%g,\"value\":%g}", d->least, d->most, d->step, d->value);
    }
    printf("],\"buttons\":[");
    for (int k = 0; k < LIVE_BUTTONS && figure.button[k]; k++)
        printf("%s\"%s\"", k ? "," : "", figure.button[k]);
    printf("],");
}

static void print_charts(void)
{
    printf("\"charts\":[");
    for (int k = 0; k < LIVE_CHARTS && figure.chart[k].name; k++) {
        const live_chart_plan *c = &figure.chart[k];
        printf("%s{", k ? "," : "");
        text("name", c->name);
        text("unit", c->unit);
        text("over", c->over);
        printf("\"least\":%g,\"most\":%g,\"logarithmic\":%d,\"time\":%d,\"lines\":[",
               c->least, c->most, c->logarithmic, c->is_time);
        for (int i = 0; i < LIVE_LINES && c->line[i]; i++)
            printf("%s\"%s\"", i ? "," : "", c->line[i]);
        printf("]}");
    }
    printf("],");
}

static void print_view(void)
{
    const live_camera_plan *c = &figure.camera;
    printf("\"panes\":[");
    for (int k = 0; k < LIVE_PANES && figure.pane[k].width > 0; k++)
        printf("%s[%g,%g,%g,%g]", k ? "," : "", figure.pane[k].left,
               figure.pane[k].bottom, figure.pane[k].width, figure.pane[k].height);
    printf("],\"camera\":[%g,%g,%g,%g,%g,%g,%d],", c->distance, c->turn, c->rise,
           c->target.x, c->target.y, c->target.z, c->has_floor);
}

static void print_panel(void)
{
    printf("{");
    text("name", figure.name);
    text("says", figure.says);
    print_view();
    print_dials();
    print_charts();
    printf("\"wants\":[");
    for (int k = 0; k < variants(); k++)
        printf("%s\"%016llx\"", k ? "," : "", hash_of_variant(k));
    printf("]}\n");
}

int main(int arguments, char **argument)
{
    if (arguments > 1 && strcmp(argument[1], "--panel") == 0) {
        print_panel();
        return 0;
    }
    if (arguments > 1 && strcmp(argument[1], "--film") == 0) {
        live_film();
        return 0;
    }
    int usual = figure.dial[0].choices ? (int)figure.dial[0].value : 0;
    printf("live %s %016llx\n", figure.name, hash_of_variant(usual));
    for (int k = 0; k < variants(); k++)
        if (k != usual) printf("live %s+%d %016llx\n", figure.name, k, hash_of_variant(k));
    return 0;
}
