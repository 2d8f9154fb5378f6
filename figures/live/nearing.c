// nearing.c - conservative advancement: how far may a body surely go?  One distance
// after the other, with the line of sweep_step() lit (chapter 15).

#include "live.h"

// The library's own, so that it can be asked step by step.
#define swept_first_touch nearing_first_touch
#define shape_inner nearing_inner
#define swept_place nearing_place
#define swept_turning nearing_turning
#include "../../lib/query/swept.c"

enum { PACE = 70, REST = 110 };                 // frames a distance, at the end
enum { CORNERS = 5, WALL = 4, MOST = SWEPT_CAP + 1 };
typedef enum { ASKS, PLANE, GOES } moment;      // of a distance

static const vec3 STONE[CORNERS] = {
    { -0.42, -0.3, 0 }, { 0.2, -0.42, 0 }, { 0.5, 0.05, 0 }, { 0.1, 0.42, 0 }, { -0.4, 0.28, 0 }
};
static const vec3 B[WALL] = { { 1.3, -1.2, 0 }, { 2.3, -0.7, 0 }, { 2.1, 0.75, 0 }, { 1.0, 0.15, 0 } };
static vec3 from = { -2.3, 0.75, 0 }, to = { 2.2, -0.1, 0 };
static vec3 at[CORNERS], scratch[CORNERS + WALL];
static swept_result asked[MOST];                // after each distance
static real moment_of[MOST + 1], distance[MOST];
static int count, now, frame;
static bool goes_on[MOST];

static vec3 way(void) { return vec3_sub(to, from); }

static void place(real time, vec3 *out)
{
    for (int i = 0; i < CORNERS; i++) out[i] = vec3_add(STONE[i], vec3_add_scaled(from, time, way()));
}

// All distances are asked for at once; the picture shows them in turn.
static void solve(void)
{
    sweep s;
    swept_result r = { .status = SWEPT_NOT_FINITE };
    place(0, at);
    count = 0;
    if (!sweep_begin(&s, (hull){ at, CORNERS }, way(), (hull){ B, WALL }, 0, 1e-3, scratch)) return;
    bool more = true;
    while (more && count < MOST - 1) {
        moment_of[count] = r.time;
        more = sweep_step(&s, &r);
        distance[count] = vec3_distance(r.on_a, r.on_b);
        goes_on[count] = more;
        asked[count++] = r;
    }
    moment_of[count] = r.status == SWEPT_PASSES ? 1 : r.time;
}

static moment this_moment(void)
{
    return frame < PACE / 4 ? ASKS : frame < PACE / 2 ? PLANE : GOES;
}

static bool is_last(void) { return !goes_on[now]; }

static void tell(void)
{
    const swept_result *r = &asked[now];
    if (this_moment() == ASKS || !is_last())
        live_say("Distance %d: %.0f mm, at %.1f %% of the way. Up to %.1f %% nothing can happen.", now + 1, 1000 * distance[now],
                 100 * moment_of[now], 100 * moment_of[now + 1]);
    else if (r->status == SWEPT_PASSES)
        live_say("They pass: after %d distances it is certain that they never meet on this way.", count);
    else if (r->status == SWEPT_OVERLAP)
        live_say("They touch at the start already.");
    else live_say("They touch at %.1f %% of the way: %d distances were enough.", 100 * moment_of[now], count);
    live_light(this_moment() == ASKS ? "gjk_result g =" : this_moment() == PLANE ? "r->normal = direction" : !is_last() ? "r->time = next"
               : r->status == SWEPT_PASSES ? "if (!(closing > 0" : "if (!(g.distance > s->near))");
}

static void begin(void)
{
    now = frame = 0;
    solve();
    tell();
}

static void step(void)
{
    if (++frame >= (is_last() ? REST : PACE)) {
        frame = 0;
        if (is_last()) now = 0; else now++;
    }
    tell();
}

static void move(int number, vec3 where)
{
    *(number == 0 ? &from : &to) = vec3_make(where.x, where.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_stone(live_colour c, real time)
{
    vec3 out[CORNERS + 1];
    place(time, out);
    out[CORNERS] = out[0];
    live_dashes(c, out, CORNERS + 1);
}

// The plane that parts them, which A will not have crossed before.
static void draw_plane(const swept_result *r)
{
    vec3 n = r->normal, side = { -n.y, n.x, 0 }, on_b = vec3_add(r->on_b, B[0]);
    live_dashes(LIVE_GREEN, (vec3[]){ vec3_add_scaled(on_b, -7, side), vec3_add_scaled(on_b, 7, side) }, 2);
}

static void draw(void)
{
    const swept_result *r = &asked[now];
    vec3 out[CORNERS], origin = B[0];
    real part = this_moment() == GOES && !is_last() ? real_min(1, 4.0 * (frame - PACE / 2) / PACE) : 0;
    real time = moment_of[now] + part * (moment_of[now + 1] - moment_of[now]);
    if (is_last() && r->status == SWEPT_PASSES) time = moment_of[now] + real_max(0, real_min(1, (frame - PACE / 2) / 40.0)) * (1 - moment_of[now]);
    live_line(LIVE_RULE, (vec3[]){ from, to }, 2);
    live_area(LIVE_ORANGE, B, WALL);
    live_label(LIVE_ORANGE, vec3_make(1.7, -0.3, 0), "B");
    for (int k = 0; k <= now; k++) draw_stone(LIVE_GREY, moment_of[k]);
    if (this_moment() != ASKS && distance[now] > 0) draw_plane(r);
    if (this_moment() != GOES) live_line(LIVE_INK, (vec3[]){ vec3_add(r->on_a, origin), vec3_add(r->on_b, origin) }, 2);
    place(time, out);
    live_area(LIVE_BLUE, out, CORNERS);
    live_label(LIVE_BLUE, vec3_add(vec3_add_scaled(from, time, way()), vec3_make(-0.05, -0.05, 0)), "A");
    live_handle(0, LIVE_BLUE, from, "start of A");
    live_handle(1, LIVE_INK, to, "end of the way");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, moment_of, (size_t)(count + 1) * sizeof(real));
    return live_hash(h, (int[]){ now, frame, count }, 3 * sizeof(int));
}

const live_figure figure = {
    .name = "nearing",
    .says = "A stone A on its straight way to a wall B: from each place the distance and a plane say how far it may go without looking",
    .code = "lib/query/swept.c sweep_step",
    .pane = { { -3.1, -1.4, 6.2, 2.75 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
