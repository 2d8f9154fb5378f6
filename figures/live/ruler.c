// ruler.c - the order of the sticks around a blow, stick by stick, with the line of
// write_list() lit (chapter 8).

#include "live.h"
#include "ordering.h"

enum { REPEATS };                               // dial
enum { COLUMNS = 9, ROWS = 4, PARTICLES = COLUMNS * ROWS, MOST = 4 * PARTICLES, PACE = 4, REST = 120 };
static const real SIDE = 0.5;                   // m
static const vec3 BLOW = { 0.25, 0.18, 0 };     // m

static particle p[PARTICLES];
static stick s[MOST];
static int sticks, away[PARTICLES];             // sticks from the blow
static stick_lists lists;
static bool is_ready;
static int struck = 11, at, frame;              // place in the list
static int turns[MOST];                         // of each stick

static vec3 rest(int i)
{
    int row = i / COLUMNS;
    return vec3_make(-2.2 + SIDE * (i % COLUMNS) + (row % 2 ? SIDE / 2 : 0), -1.0 + 0.8660254 * SIDE * row, 0);
}

static void join(int a, int b)
{
    s[sticks++] = (stick){ a, b, SIDE, 1, STICK_EXACT };
}

// Triangles, row by row.
static void build(void)
{
    sticks = 0;
    for (int i = 0; i < PARTICLES; i++) {
        int column = i % COLUMNS, row = i / COLUMNS, odd = row % 2;
        if (column + 1 < COLUMNS) join(i, i + 1);
        if (row + 1 == ROWS) continue;
        join(i, i + COLUMNS);
        if (odd && column + 1 < COLUMNS) join(i, i + COLUMNS + 1);
        if (!odd && column > 0) join(i, i + COLUMNS - 1);
    }
}

static void find_away(void)
{
    for (int i = 0; i < PARTICLES; i++) away[i] = i == struck ? 0 : PARTICLES;
    for (int round = 0; round < PARTICLES; round++)
        for (int k = 0; k < sticks; k++) {
            int *a = &away[s[k].a], *b = &away[s[k].b];
            *a = int_min(*a, *b + 1);
            *b = int_min(*b, *a + 1);
        }
}

static int distance(int k)
{
    return 1 + int_min(away[s[k].a], away[s[k].b]);
}

static int entry(int place) { return lists.stick[lists.start[struck] + place]; }
static int length(void) { return lists.start[struck + 1] - lists.start[struck]; }

static void tell(void)
{
    if (!is_ready) return;
    if (at == length()) {
        live_say("The list of this particle has %d entries for %d sticks.", length(), sticks);
        live_light("return length");
        return;
    }
    int d = distance(entry(at)), before = at > 0 ? distance(entry(at - 1)) : 0;
    live_say("Entry %d of %d: a stick at distance %d, for the %d%s time.", at + 1, length(), d, turns[entry(at)],
             turns[entry(at)] == 1 ? "st" : turns[entry(at)] == 2 ? "nd" : turns[entry(at)] == 3 ? "rd" : "th");
    live_light(d < before || at == 0 ? "for (int r = 1" : d > before ? "for (int d = 1" : "out[length] = k");
}

static void take(void)
{
    int k = entry(at);
    turns[k]++;
    stick_relax(s[k], p, relax_options_pbd());
}

static void begin(void)
{
    if (!sticks) build();
    if (is_ready) stick_lists_free(&lists);
    is_ready = stick_lists_build(&lists, s, sticks, PARTICLES, live_choice(REPEATS)).ok;
    for (int i = 0; i < PARTICLES; i++) p[i] = (particle){ rest(i), rest(i), 1 };
    p[struck].position = vec3_add(p[struck].position, BLOW);
    for (int k = 0; k < sticks; k++) turns[k] = 0;
    find_away();
    at = frame = 0;
    if (is_ready) take();
    tell();
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame >= (at == length() ? REST : PACE)) {
        frame = 0;
        if (at == length()) begin();
        else if (++at < length()) take();
    }
    tell();
}

// The particle that is nearest to the hand is struck.
static void move(int number, vec3 to)
{
    int best = 0;
    (void)number;
    to.z = 0;
    for (int i = 1; i < PARTICLES; i++)
        if (vec3_distance(rest(i), to) < vec3_distance(rest(best), to)) best = i;
    if (best == struck) return;
    struck = best;
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static live_colour colour_of(int k)
{
    static const live_colour RING[] = { LIVE_RED, LIVE_PURPLE, LIVE_BLUE, LIVE_GREEN };
    return turns[k] == 0 ? LIVE_QUIET : RING[int_min(distance(k), 4) - 1];
}

static void draw_count(int k)
{
    static const char *const word[] = { "", "", "2", "3", "4", "5", "6", "7", "8", "9" };
    vec3 middle = vec3_scale(0.5, vec3_add(p[s[k].a].position, p[s[k].b].position));
    if (turns[k] > 1) live_label(colour_of(k), vec3_add(middle, vec3_make(-0.04, -0.04, 0)), word[int_min(turns[k], 9)]);
}

// The net as a strip of cloth: its sticks, and what lies between them.
static void draw_net(void)
{
    for (int row = 0; row + 1 < ROWS; row++) {
        vec3 strip[2 * COLUMNS];
        for (int i = 0; i < COLUMNS; i++) {
            strip[i] = p[row * COLUMNS + i].position;
            strip[2 * COLUMNS - 1 - i] = p[(row + 1) * COLUMNS + i].position;
        }
        live_band(LIVE_GREY, strip, 2 * COLUMNS);
    }
    for (int i = 0; i < PARTICLES; i++) live_dot(LIVE_QUIET, p[i].position, 3);
}

static void draw(void)
{
    int now = is_ready && at < length() ? entry(at) : -1;
    draw_net();
    for (int k = 0; k < sticks; k++)
        if (k != now) live_line(colour_of(k), (vec3[]){ p[s[k].a].position, p[s[k].b].position }, 2);
    for (int k = 0; k < sticks; k++) draw_count(k);
    if (now >= 0) {
        vec3 ends[2] = { p[s[now].a].position, p[s[now].b].position };
        live_line(LIVE_ORANGE, ends, 2);
        for (int k = 0; k < 2; k++) live_dot(LIVE_ORANGE, ends[k], 5);
    }
    live_handle(0, LIVE_INK, p[struck].position, "struck particle");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, turns, (size_t)sticks * sizeof *turns);
    for (int i = 0; i < PARTICLES; i++) h = live_hash(h, &p[i].position, sizeof(vec3));
    return h;
}

const live_figure figure = {
    .name = "ruler",
    .says = "A flat net of sticks; one after the other is corrected, in the order of the list of the particle that was struck",
    .code = "lib/particles/ordering.c write_list",
    .pane = { { -2.6, -1.45, 5.2, 2.3 } },
    .dial = { [REPEATS] = { "list", NULL, 0, 1, 1, 0, "each stick once|the near ones more often", true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
