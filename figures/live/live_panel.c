// live_panel.c - what the page builds of a figure before it runs: dials, buttons, charts
// and the lines of its code, as JSON.  panel.mjs runs it, and adds the hashes.

#include "live_page.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    printf("],\"ground\":%d,\"camera\":[%g,%g,%g,%g,%g,%g,%d,%g],", figure.ground != NULL,
           c->distance, c->turn, c->rise, c->target.x, c->target.y, c->target.z,
           c->has_floor, c->floor);
}

// A text of the code, between the quotes of JSON.
static void print_quoted(const char *text)
{
    for (const char *c = text; *c && *c != '\n'; c++)
        printf(*c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
}

// Does the function begin on this line?  A promise of it ends with a semicolon.
static bool begins_here(const char *line, const char *name)
{
    const char *at = strstr(line, name);
    return at && at[strlen(name)] == '(' && (at[-1] == ' ' || at[-1] == '*')
        && line[0] != ' ' && line[0] != '/' && !strchr(line, ';');
}

// The lines of a function, as they stand in the tree when the page is made, and
// before the first of all where they are from.  Returns how many there are in all.
static int print_function(const char *path, const char *name, int printed)
{
    char line[200];
    FILE *file = fopen(path, "r");
    bool is_inside = false, is_over = false;
    for (int number = 1; file && !is_over && fgets(line, sizeof line, file); number++) {
        is_inside = is_inside || begins_here(line, name);
        if (!is_inside) continue;
        if (!printed) printf("\"%s, line %d\"", path, number);
        printf(",\"");
        print_quoted(line);
        printf("\"");
        printed++;
        is_over = line[0] == '}';
    }
    if (file) fclose(file);
    if (is_over) return printed;
    fprintf(stderr, "%s: there is no %s in %s\n", figure.name, name, path);
    exit(1);
}

static void print_code(const char *place)
{
    char path[80], name[80];
    int printed = 0, read = 0;
    if (!place || sscanf(place, "%79s%n", path, &read) != 1) return;
    printf("\"code\":[");
    for (place += read; sscanf(place, "%79s%n", name, &read) == 1; place += read)
        printed = print_function(path, name, printed);
    printf("],");
}

static void print_panel(void)
{
    printf("{");
    text("name", figure.name);
    text("says", figure.says);
    print_code(figure.code);
    print_view();
    print_dials();
    print_charts();
    printf("\"fickle\":%u}\n", figure.fickle);
}

int main(void)
{
    print_panel();
    return 0;
}
