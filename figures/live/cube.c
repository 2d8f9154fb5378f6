// cube.c - a cube of sticks falls on a corner; take a stick away (chapter 3).

#include "live.h"
#include "rigidity.h"

enum { KIND, ITERATIONS };                      // dials
enum { ERROR, TIME };                           // charts
enum { CORNERS = 8, MOST = 28, STEPS = 4 };     // steps a frame
enum { CORNER = 100 };                          // numbers of corners begin here
static const real DT = 1.0 / (60 * STEPS);
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const live_colour COLOUR[] = { LIVE_INK, LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN };

static vec3 rest[CORNERS];
static particle at[CORNERS];
static stick has[MOST];
static int sticks, rank, held = -1;
static vec3 held_at;

// How many coordinates the ends differ in: 1 an edge, 2 a diagonal of a side, 3
// a main diagonal.
static int class_of(int a, int b)
{
    int d = a ^ b;
    return (d & 1) + (d >> 1 & 1) + (d >> 2);
}

// One of the two diagonals of each side: the one whose ends have an even sum.
static bool is_wanted(int a, int b)
{
    return class_of(a, b) != 2 || ((a & 1) + (a >> 1 & 1) + (a >> 2)) % 2 == 0;
}

static void count_rank(void)
{
    shape s = { .particles = CORNERS, .at = rest, .sticks = sticks, .stick = has };
    rank = shape_rank(&s);
    const char *so = rank == 3 * CORNERS - 6 ? "it is rigid" : "it can fold";
    live_say("%d sticks of rank %d. A cube needs %d: %s.", sticks, rank, 3 * CORNERS - 6, so);
}

static void add_sticks(int class)
{
    for (int a = 0; a < CORNERS; a++)
        for (int b = a + 1; b < CORNERS; b++)
            if (class_of(a, b) == class && is_wanted(a, b))
                has[sticks++] = (stick){ a, b, vec3_distance(rest[a], rest[b]), 1, STICK_EXACT };
}

// The corners, turned so that one is lowest.
static void place_corners(void)
{
    const vec3 up = vec3_unit(vec3_make(0.30, 1, 0.42));
    const vec3 right = vec3_unit(vec3_cross(up, vec3_make(-0.3, 0, 1)));
    const vec3 front = vec3_cross(right, up);
    real low = 0;
    for (int k = 0; k < CORNERS; k++) {
        vec3 x = vec3_scale((k & 1) - 0.5, right);
        x = vec3_add_scaled(x, (k >> 1 & 1) - 0.5, up);
        rest[k] = vec3_add_scaled(x, (k >> 2) - 0.5, front);
        low = real_min(low, rest[k].y);
    }
    for (int k = 0; k < CORNERS; k++)
        at[k] = particle_start(vec3_add(rest[k], vec3_make(0, 0.35 - low, 0)),
                               vec3_make(0, 0, 0), GRAVITY, CORNERS, DT);
}

static void begin(void)
{
    place_corners();
    sticks = 0;
    held = -1;
    for (int class = 1; class <= live_choice(KIND) + 1; class++) add_sticks(class);
    count_rank();
}

// The floor holds what has reached it: by friction it stays where it was.
static void hold(void)
{
    for (int k = 0; k < CORNERS; k++)
        if (at[k].position.y < 0) {
            at[k].position = at[k].previous;
            at[k].position.y = 0;
        }
    if (held >= 0)
        at[held].position = vec3_add_scaled(at[held].position, 0.1, vec3_sub(held_at, at[held].position));
}

static void step(void)
{
    for (int i = 0; i < STEPS; i++) {
        verlet_step(at, CORNERS, GRAVITY, NULL, DT);
        for (int k = 0; k < (int)live_dial(ITERATIONS); k++) {
            hold();
            sticks_iterate(has, sticks, at, relax_options_pbd());
        }
        hold();
    }
}

// The largest relative error of the 28 distances, whether a stick holds them or
// not.
static void measure(void)
{
    real most = 0;
    for (int a = 0; a < CORNERS; a++)
        for (int b = a + 1; b < CORNERS; b++) {
            real wants = vec3_distance(rest[a], rest[b]);
            real is = vec3_distance(at[a].position, at[b].position);
            most = real_max(most, fabs(is - wants) / wants);
        }
    live_value(ERROR, 0, 100 * most);
}

static void draw(void)
{
    for (int k = 0; k < sticks; k++) {
        int class = class_of(has[k].a, has[k].b);
        live_tube(k, COLOUR[class], at[has[k].a].position, at[has[k].b].position, class == 1 ? 0.03 : 0.018);
    }
    for (int k = 0; k < CORNERS; k++)
        live_ball(CORNER + k, COLOUR[0], at[k].position, 0.065);
}

// --- What the reader does ---------------------------------------------------------
static void take_away(int k)
{
    if (k < 0 || k >= sticks) return;
    sticks--;
    for (; k < sticks; k++) has[k] = has[k + 1];
    count_rank();
}

static void tap(int number, vec3 along)
{
    (void)along;
    if (number < CORNER) take_away(number);
}

static void press(int button)
{
    (void)button;
    take_away(sticks - 1);
}

static void move(int number, vec3 to)
{
    if (number < CORNER) return;
    held = number - CORNER;
    held_at = to;
}

static void release(int number)
{
    (void)number;
    held = -1;
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, at, sizeof at);
}

const live_figure figure = {
    .name = "cube",
    .says = "A cube of balls and sticks falls on the floor, on one of its corners",
    .camera = { .distance = 3.6, .turn = 0.5, .rise = 0.3, .target = { 0, 0.66, 0 }, .has_floor = true },
    .dial = {
        [KIND] = { "sticks", NULL, 0, 2, 1, 2, "12|18|22", true },
        [ITERATIONS] = { "iterations a step", NULL, 1, 64, 1, 32, NULL, false },
    },
    .button = { "Take one away" },
    .chart = {
        [ERROR] = { "worst distance of two corners, % off", NULL, { NULL }, 1e-6, 100, true, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 0.1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .move = move, .release = release, .tap = tap,
};
