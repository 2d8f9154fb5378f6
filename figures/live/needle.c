// needle.c - a needle that tumbles past a post: asked with its turn, and as if it flew
// straight (chapter 15).

#include "live.h"
#include "plane.h"

// The library's own, so that it can be asked distance by distance.
#define swept_first_touch needle_first_touch
#define shape_inner needle_inner
#define swept_place needle_place
#define swept_turning needle_turning
#include "../../lib/query/swept.c"

enum { TURN };                                  // dial
enum { CORNERS = 4, SHOWN = 40, FRAMES = 150, REST = 70 };
static const vec3 NEEDLE[CORNERS] = { { -0.9, -0.025, 0 }, { 0.9, -0.025, 0 }, { 0.9, 0.025, 0 }, { -0.9, 0.025, 0 } };
static const vec3 POST[CORNERS] = { { -0.11, -0.11, 0 }, { 0.11, -0.11, 0 }, { 0.11, 0.11, 0 }, { -0.11, 0.11, 0 } };
static const real TOLERANCE = 1e-3;             // m

static vec3 from = { -2, 0.45, 0 }, to = { 2, 0.45, 0 }, post = { 0.35, -0.2, 0 };
static vec3 start_at[CORNERS], post_at[CORNERS], scratch[2 * CORNERS];
static real asked_at[SHOWN];                    // shares of the way
static swept_result turning, straight;
static int frame;

static swept_motion motion_of_needle(void)
{
    return (swept_motion){ .center = from, .delta = vec3_sub(to, from), .out = vec3_length(NEEDLE[0]),
                           .turn = { 0, 0, live_dial(TURN) * 0.017453292519943295 } };
}

// As swept_turning(), with a look at the time of each distance.
static void ask(void)
{
    swept_motion a = motion_of_needle(), b = { .center = post };
    sweep s = { .given = { start_at, CORNERS }, .other = { post_at, CORNERS }, .of_a = &a, .of_b = &b, .a_at = scratch, .b_at = scratch + CORNERS,
                .a = { scratch, CORNERS }, .b = { scratch + CORNERS, CORNERS }, .near = TOLERANCE, .aim = TOLERANCE / 2 };
    bool more = true;
    turning = (swept_result){ .status = SWEPT_CAPPED };
    while (more && turning.iterations < TURNING_CAP) {
        if (turning.iterations < SHOWN) asked_at[turning.iterations] = turning.time;
        more = sweep_step(&s, &turning);
    }
    straight = swept_first_touch((hull){ start_at, CORNERS }, a.delta, (hull){ post_at, CORNERS }, 0, TOLERANCE, scratch);
}

static bool touches(const swept_result *r) { return r->status == SWEPT_TOUCHES; }

static void begin(void)
{
    frame = 0;
    for (int i = 0; i < CORNERS; i++) {
        start_at[i] = vec3_add(from, NEEDLE[i]);
        post_at[i] = vec3_add(post, POST[i]);
    }
    ask();
    if (touches(&turning)) live_say("With its turn it touches at %.0f %% of the way: %d distances. Flown straight it %s.", 100 * turning.time, turning.iterations,
                                    touches(&straight) ? "would touch as well" : "would seem to pass");
    else if (turning.status == SWEPT_PASSES) live_say("With its turn it passes: %d distances are enough to be sure. Flown straight it %s.", turning.iterations,
                                                      touches(&straight) ? "would seem to touch" : "passes as well");
    else live_say("They touch at the start already.");
}

static void step(void)
{
    if (++frame > FRAMES + REST) frame = 0;
}

static void move(int number, vec3 where)
{
    *(number == 0 ? &from : number == 1 ? &to : &post) = vec3_make(where.x, where.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void place_at(real time, vec3 *out)
{
    swept_motion a = motion_of_needle();
    swept_place((hull){ start_at, CORNERS }, &a, time, out);
}

static void draw_asked(real until)
{
    int n = int_min(turning.iterations, SHOWN);
    for (int k = 0; k < n && asked_at[k] <= until; k++) {
        vec3 out[CORNERS];
        place_at(asked_at[k], out);
        live_line(LIVE_GREY, (vec3[]){ vec3_scale(0.5, vec3_add(out[0], out[3])), vec3_scale(0.5, vec3_add(out[1], out[2])) }, 2);
    }
}

// Where its ends go, if nothing is in the way.
static void draw_arcs(void)
{
    enum { BITS = 41 };
    vec3 end[2][BITS], out[CORNERS];
    for (int k = 0; k < BITS; k++) {
        place_at(k / (BITS - 1.0), out);
        end[0][k] = out[0];
        end[1][k] = out[1];
    }
    live_line(LIVE_RULE, end[0], BITS);
    live_line(LIVE_RULE, end[1], BITS);
}

static void draw(void)
{
    vec3 out[CORNERS];
    real most = touches(&turning) || turning.status == SWEPT_OVERLAP ? turning.time : 1, time = real_min(most, (real)frame / FRAMES);
    bool is_there = touches(&turning) && time >= most;
    draw_arcs();
    live_dashes(LIVE_RULE, (vec3[]){ from, to }, 2);
    draw_asked(time);
    live_area(LIVE_ORANGE, post_at, CORNERS);
    place_at(time, out);
    live_area(is_there ? LIVE_RED : LIVE_BLUE, out, CORNERS);
    if (is_there) live_circle(LIVE_RED, vec3_add(post_at[0], turning.on_b), 0.12);
    live_handle(0, LIVE_BLUE, from, "start of the needle");
    live_handle(1, LIVE_INK, to, "end of its way");
    live_handle(2, LIVE_ORANGE, post, "the post");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, asked_at, (size_t)int_min(turning.iterations, SHOWN) * sizeof(real));
    return live_hash(h, (int[]){ turning.iterations, (int)turning.status, (int)straight.status, frame }, 4 * sizeof(int));
}

const live_figure figure = {
    .name = "needle",
    .says = "A needle flies past a post and tumbles; grey lines are where it was when a distance was asked for, and they crowd before it touches",
    .pane = { { -3.1, -1.3, 6.2, 2.75 } },
    .dial = { [TURN] = { "turns on its way by", "°", -360, 360, 5, 160, NULL, true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
