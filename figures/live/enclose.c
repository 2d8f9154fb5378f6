// enclose.c - the smallest circle around points in a plane, round by round, with the
// line of sphere_of_points() lit (chapter 6).

#include "live.h"

#include <math.h>

// The library's own, so that it can be asked round by round.
#define sphere_of_points enclose_points
#define sphere_of_spheres enclose_spheres
#include "../../lib/paper/sphere.c"

enum { POINTS = 12, PACE = 45, REST = 180 };

static const vec3 REST_AT[POINTS] = {
    { -0.45, 0.1, 0 }, { -0.1, 0.55, 0 }, { 0.3, -0.2, 0 }, { 0.75, 0.35, 0 },
    { -1.15, 0.6, 0 }, { 0.1, -0.8, 0 }, { 1.25, -0.35, 0 }, { -0.75, -0.5, 0 },
    { 0.5, 0.9, 0 }, { -1.0, -0.1, 0 }, { -0.35, -0.3, 0 }, { 0.95, -0.75, 0 } };
static vec3 at[POINTS];
static int which[POINTS];
static trial now;                               // relative to the first point
static sphere answer;
static int far, rounds, frame;
static bool is_done;

static vec3 center(void)
{
    return vec3_add(at[0], now.center);
}

// Looks for the farthest point, as sphere_of_points() does between two rounds.
static void look(void)
{
    real far2;
    far = farthest(at, which, POINTS, at[0], now.center, &far2);
    is_done = !(far2 > now.reach2 * OUTSIDE);
}

static void tell(void)
{
    if (is_done)
        live_say("After %d rounds all points are inside. %d support points fix the circle, with a radius of %.3f m.", rounds, now.count, answer.radius);
    else if (rounds == 0)
        live_say("The circle begins as a point. The orange one is the farthest from it, and outside: it is let in.");
    else
        live_say("Round %d: radius %.3f m. The orange point is the farthest from the centre, and outside: it is let in.", rounds, sqrt(now.reach2));
    live_light(is_done ? "*supports = s.count" : "let_in(s, index[far]");
}

static void restart(void)
{
    int support[4], supports;
    real weight[4];
    now = (trial){ .count = 1, .index = { 0 }, .weight = { 1 } };
    answer = sphere_of_points(at, which, POINTS, support, weight, &supports);
    rounds = frame = 0;
    look();
    tell();
}

static void begin(void)
{
    for (int k = 0; k < POINTS; k++) at[k] = REST_AT[k], which[k] = k;
    restart();
}

static void go_on(void)
{
    trial next = let_in(now, far, vec3_sub(at[far], at[0]));
    if (next.count > 0) now = next;
    rounds++, frame = 0;
    look();
    is_done |= next.count == 0 || rounds == ROUNDS_MAX;
    tell();
}

static void step(void)
{
    frame++;
    if (is_done && frame >= REST) restart();
    if (!is_done && frame >= PACE) go_on();
}

// The hand sees the last circle at once; its rounds are shown when it rests.
static void move(int number, vec3 to)
{
    at[number] = vec3_make(to.x, to.y, 0);
    restart();
    while (!is_done) go_on();
}

static bool is_support(int k)
{
    for (int i = 0; i < now.count; i++)
        if (now.index[i] == k) return true;
    return false;
}

static void draw(void)
{
    real reach = sqrt(now.reach2);
    if (reach > 0) live_circle(LIVE_BLUE, center(), reach);
    if (!is_done) live_dashes(LIVE_ORANGE, (vec3[]){ center(), at[far] }, 2);
    live_dot(LIVE_BLUE, center(), 3);
    for (int k = 0; k < now.count && rounds > 0; k++) live_dot(LIVE_BLUE, at[now.index[k]], 5);
    for (int k = 0; k < POINTS; k++) {
        char name[] = "point a";
        name[6] = (char)('a' + k);
        live_handle(k, !is_done && k == far ? LIVE_ORANGE : is_support(k) ? LIVE_BLUE : LIVE_QUIET, at[k], name);
    }
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, &answer, sizeof answer), &now.center, sizeof now.center);
}

const live_figure figure = {
    .name = "enclose",
    .says = "Twelve points in a plane, and a circle that grows until it holds them all",
    .code = "lib/paper/sphere.c sphere_of_points",
    .pane = { { -2.6, -1.55, 5.2, 3.1 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
