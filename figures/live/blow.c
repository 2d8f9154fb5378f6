// blow.c - a hexagon of sticks is struck, and relaxed in three orders (chapter 8).

#include "live.h"
#include "ordering.h"

#include <stdio.h>
#include <stdlib.h>

enum { PACE, TOLERANCE };                       // dials
enum { ERROR, LOOKS };                          // charts
enum { LISTED, BREADTH_FIRST, REPEATED, ORDERS };   // panes and lines of charts
enum { SIDE = 6, ACROSS = 2 * SIDE + 1, PARTICLES = 3 * SIDE * (SIDE + 1) + 1,
       STICKS = 9 * SIDE * SIDE + 3 * SIDE, MOST = 4000, LOOK = 10, REST = 150 };
static const char *const NAME[ORDERS] = { "listed", "breadth first", "repeated" };

static vec3 rest[PARTICLES];
static stick has[STICKS];
static stick_lists once, again;
static int listed[STICKS], struck = -1, waits;
static vec3 struck_to;

// A body on its way: where its list goes on, and what was done.
typedef struct {
    particle p[PARTICLES];
    const int *list;
    int  n, next, relaxed, tested, idle;        // idle: sticks in turn that were right
    real error[LIVE_CURVE];                     // after every LOOK relaxations
    int  errors;
} body;
static body run[ORDERS];

static bool is_inside(int i, int j)
{
    return abs(i) <= SIDE && abs(j) <= SIDE && abs(i + j) <= SIDE;
}

// Row by row, from below; and each particle's sticks to the ones before it.
static void build(void)
{
    static int number[ACROSS][ACROSS];
    int particles = 0, sticks = 0;
    for (int j = -SIDE; j <= SIDE; j++)
        for (int i = -SIDE; i <= SIDE; i++) {
            if (!is_inside(i, j)) continue;
            const int back[3][2] = { { i - 1, j }, { i, j - 1 }, { i + 1, j - 1 } };
            rest[particles] = vec3_make(i + 0.5 * j, sqrt(0.75) * j, 0);
            number[i + SIDE][j + SIDE] = particles;
            for (int k = 0; k < 3; k++)
                if (is_inside(back[k][0], back[k][1]))
                    has[sticks++] = (stick){ number[back[k][0] + SIDE][back[k][1] + SIDE], particles, 1, 1, STICK_EXACT };
            particles++;
        }
    for (int k = 0; k < STICKS; k++) listed[k] = k;
    if (!stick_lists_build(&once, has, STICKS, PARTICLES, false).ok
        || !stick_lists_build(&again, has, STICKS, PARTICLES, true).ok) abort();
}

static real worst(const particle *p)
{
    real most = 0;
    for (int k = 0; k < STICKS; k++) most = real_max(most, stick_strain(has[k], p));
    return most;
}

static void note_error(body *b)
{
    if (b->errors == LIVE_CURVE) return;
    b->error[b->errors++] = 100 * worst(b->p);
    live_curve(ERROR, (int)(b - run), b->error, b->errors);
}

static void strike(body *b, int order)
{
    *b = (body){ .list = listed, .n = STICKS };
    const stick_lists *lists = order == REPEATED ? &again : &once;
    if (order != LISTED) {
        b->list = lists->stick + lists->start[struck];
        b->n = lists->start[struck + 1] - lists->start[struck];
    }
    for (int i = 0; i < PARTICLES; i++) b->p[i] = (particle){ rest[i], rest[i], 1 };
    b->p[struck].position = struck_to;
    note_error(b);
}

static void begin(void)
{
    if (struck < 0) {
        build();
        struck = PARTICLES / 2;
        struck_to = vec3_add(rest[struck], vec3_make(0.78, 0.45, 0));
    }
    waits = 0;
    for (int k = 0; k < ORDERS; k++) strike(&run[k], k);
}

// --- Frames -----------------------------------------------------------------------
static bool is_done(const body *b)
{
    return b->idle >= b->n || b->relaxed == MOST;
}

// Goes on in the list until a stick is found that is off.
static void relax_one(body *b)
{
    while (!is_done(b)) {
        stick s = has[b->list[b->next]];
        b->next = b->next + 1 < b->n ? b->next + 1 : 0;
        b->tested++;
        b->idle++;
        if (!(stick_strain(s, b->p) > live_dial(TOLERANCE) / 100)) continue;
        stick_relax(s, b->p, relax_options_pbd());
        b->idle = 0;
        if (++b->relaxed % LOOK == 0) note_error(b);
        return;
    }
}

static void step(void)
{
    bool all = true;
    for (int k = 0; k < ORDERS; k++) {
        for (int n = 0; n < (int)live_dial(PACE); n++) relax_one(&run[k]);
        all = all && is_done(&run[k]);
    }
    if (all && ++waits == REST) begin();
}

static void measure(void)
{
    char text[200];
    int n = 0;
    for (int k = 0; k < ORDERS; k++)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%s: %d relaxed%s, %d looked at", k ? "; " : "",
                      NAME[k], run[k].relaxed, is_done(&run[k]) ? " (done)" : "", run[k].tested);
    live_say("%s.", text);
}

static void move(int number, vec3 to)
{
    (void)number;
    vec3 way = vec3_sub(vec3_make(to.x, to.y, 0), rest[struck]);
    real length = vec3_length(way);
    struck_to = vec3_add_scaled(rest[struck], length > 3 ? 3 / length : 1, way);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
// Within 1 %; too long or too short by more, or by more than a tenth.
static live_colour colour_of(stick s, const particle *p)
{
    real strain = stick_strain(s, p);
    return strain < 0.01 ? LIVE_RULE : strain < 0.05 ? LIVE_ORANGE : LIVE_RED;
}

static void draw(void)
{
    for (int k = 0; k < ORDERS; k++) {
        live_pane(k);
        for (int i = 0; i < STICKS; i++) {
            const particle *p = run[k].p;
            vec3 ends[] = { p[has[i].a].position, p[has[i].b].position };
            live_line(colour_of(has[i], p), ends, 2);
        }
        live_label(LIVE_INK, vec3_make(-6.8, 6.2, 0), NAME[k]);
        live_handle(k, LIVE_INK, struck_to, "the particle that is struck");
    }
}

static unsigned long long hash(void)
{
    unsigned long long h = LIVE_HASH;
    for (int k = 0; k < ORDERS; k++) h = live_hash(h, run[k].p, sizeof run[k].p);
    return h;
}

const live_figure figure = {
    .name = "blow",
    .says = "Three hexagons of sticks, struck in the middle, are relaxed in three orders; sticks that are off by more than 1 % are orange, by more than 5 % red",
    .pane = { { -7, -6.2, 14, 13.4 }, { -7, -6.2, 14, 13.4 }, { -7, -6.2, 14, 13.4 } },
    .dial = {
        [PACE] = { "relaxations a frame", NULL, 1, 30, 1, 3, NULL, false },
        [TOLERANCE] = { "tolerance", "%", 0.1, 5, 0.1, 1, NULL, true },
    },
    .chart = {
        [ERROR] = { "worst strain, %", NULL, { "listed", "breadth first", "repeated" }, 1, 100, true, false, "relaxations, in tens" },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
