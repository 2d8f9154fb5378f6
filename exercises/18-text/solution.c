// solution.c - line by line, and back again if one is wrong.

#include "text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    text_scene *s;
    placement   where;      // of the last body, while it waits for its lines
    int         waits;
    int         line, began;// this line; that of the body that waits
    int         blame;      // the line that a mistake is in
} reader;

enum { GRAVITY, PLANE, BOX, BALL, THROW, SPIN, NAIL, WORDS, MOST_NUMBERS = 7 };

static const struct {
    const char *word;
    int numbers;
} KNOWN[WORDS] = { { "gravity", 3 }, { "plane", 4 }, { "box", 7 },
                   { "ball", 5 }, { "throw", 3 }, { "spin", 3 },
                   { "nail", 0 } };

// Exactly n finite numbers, and nothing behind them?
static int read_numbers(const char *text, int n, real *x)
{
    for (int k = 0; k < n; k++) {
        char *end;
        x[k] = strtod(text, &end);
        if (end == text || !(x[k] - x[k] == 0)) return 0;
        text = end;
    }
    return text[strspn(text, " \t\r")] == 0;
}

static status add_waiting(reader *r)
{
    if (!r->waits) return status_ok();
    r->waits = 0;
    r->blame = r->began;
    status added = world_add(&r->s->world, &r->s->plan[r->s->bodies - 1],
                             r->where, NULL);
    if (added.ok) r->blame = r->line;
    return added;
}

static status begin_body(reader *r, int word, const real *x)
{
    text_scene *s = r->s;
    status added = add_waiting(r);
    if (!added.ok) return added;
    if (s->bodies == TEXT_BODIES)
        return status_fail("there is no room for more than %d bodies",
                           TEXT_BODIES);
    shape *plan = &s->plan[s->bodies];
    status built = word == BOX
        ? shape_box(plan, vec3_make(x[0], x[1], x[2]), x[3])
        : shape_icosahedron(plan, x[0], x[1]);
    if (!built.ok) return built;
    const real *at = word == BOX ? x + 4 : x + 2;
    s->bodies++;
    r->where = placement_at(vec3_make(at[0], at[1], at[2]));
    r->waits = 1;
    r->began = r->line;
    return status_ok();
}

static status change_body(reader *r, int word, vec3 x)
{
    if (!r->waits)
        return status_fail("%s wants a body before it", KNOWN[word].word);
    if (word == THROW) r->where.velocity = x;
    if (word == SPIN)  r->where.spin = x;
    if (word == NAIL)  r->where.is_static = 1;
    return status_ok();
}

static status read_line(reader *r, const char *line)
{
    char word[16];
    real x[MOST_NUMBERS] = { 0 };
    int length = 0, k = 0;
    if (sscanf(line, "%15s%n", word, &length) < 1) return status_ok();
    while (k < WORDS && strcmp(word, KNOWN[k].word) != 0) k++;
    if (k == WORDS) return status_fail("what is %s?", word);
    if (!read_numbers(line + length, KNOWN[k].numbers, x))
        return status_fail("%s wants %d numbers, and nothing else", word,
                           KNOWN[k].numbers);
    vec3 v = { x[0], x[1], x[2] };
    if (k == PLANE) return world_add_plane(&r->s->world, v, x[3]);
    if (k == GRAVITY) {
        if (r->s->bodies > 0) return status_fail("gravity comes before bodies");
        r->s->world.options.gravity = v;
        return status_ok();
    }
    if (k == BOX || k == BALL) return begin_body(r, k, x);
    return change_body(r, k, v);
}

// To where the next line begins, or its end; NULL if it is too long.
static const char *copy_line(const char *text, char line[TEXT_LINE])
{
    size_t length = strcspn(text, "\n");
    if (length >= TEXT_LINE) return NULL;
    memcpy(line, text, length);
    line[length] = 0;
    line[strcspn(line, "#")] = 0;
    return text + length + (text[length] == '\n');
}

status text_scene_read(text_scene *s, const char *text)
{
    reader r = { .s = s };
    memset(s, 0, sizeof *s);
    status so_far = world_init(&s->world, world_options_default());
    while (so_far.ok && *text) {
        char line[TEXT_LINE];
        r.blame = ++r.line;
        text = copy_line(text, line);
        so_far = text ? read_line(&r, line)
                      : status_fail("it is longer than %d characters",
                                    TEXT_LINE - 1);
    }
    if (so_far.ok) so_far = add_waiting(&r);
    else           so_far = status_fail("line %d: %s", r.blame, so_far.why);
    if (!so_far.ok) text_scene_free(s);
    return so_far;
}

void text_scene_free(text_scene *s)
{
    world_free(&s->world);
    for (int k = 0; k < s->bodies; k++) shape_free(&s->plan[k]);
    memset(s, 0, sizeof *s);
}
