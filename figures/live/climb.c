// climb.c - which corner of a stone lies furthest along d?  Uphill along its edges,
// with the line of hull_climb() lit (chapter 5).

#include "climb.h"
#include "live.h"
#include "plane.h"

enum { FROM };                                  // dial
enum { LOWEST, LAST };
enum { RINGS = 9, AROUND = 14, CORNERS = RINGS * AROUND + 2, FACES = 2 * RINGS * AROUND };
enum { PACE = 3, REST = 100 };                  // frames a line, at the end
enum { STONE, TIP };                            // what a hand takes
typedef enum { COME, ASK, KEEP, DONE } moment;
static const real REACH = 1.6;                  // m, of d

static vec3 at[CORNERS], tip;
static int face[FACES][3];
static mesh net;
static bool is_ready, is_led;                   // by the reader, and not by itself
static int first, v, best, half, asked, walked, frame, turns;
static int path[CORNERS];                       // the corners that it came to
static real most;                               // m, times the length of d
static moment now;

static real height(int k) { return vec3_dot(tip, at[k]); }
static hull_mesh stone(void) { return (hull_mesh){ { at, CORNERS }, &net, 2.5 }; }

// --- A stone: rings about the vertical, and a corner at either end ----------------
static void place_corners(void)
{
    vec3 up = { 0, -1, 0 };
    for (int r = 0; r < RINGS; r++) {
        vec3 flat = { 1, 0, 0 };
        up = plane_turned(up, plane_tangent(180.0 / (RINGS + 1)));
        for (int k = 0; k < AROUND; k++) {
            at[r * AROUND + k] = vec3_make(1.2 * up.x * flat.x, 0.9 * up.y, up.x * flat.y);
            flat = plane_turned(flat, plane_tangent(360.0 / AROUND));
        }
    }
    at[CORNERS - 2] = vec3_make(0, -0.9, 0);
    at[CORNERS - 1] = vec3_make(0, 0.9, 0);
}

static void set_face(int k, int a, int b, int c)
{
    face[k][0] = a, face[k][1] = b, face[k][2] = c;
}

static status make_stone(void)
{
    int n = 0;
    place_corners();
    for (int k = 0; k < AROUND; k++) {
        int next = (k + 1) % AROUND, top = (RINGS - 1) * AROUND;
        set_face(n++, CORNERS - 2, k, next);
        set_face(n++, CORNERS - 1, top + next, top + k);
        for (int r = 0; r + 1 < RINGS; r++) {
            int low = r * AROUND, high = low + AROUND;
            set_face(n++, low + k, high + k, high + next);
            set_face(n++, low + k, high + next, low + next);
        }
    }
    return mesh_build(&net, CORNERS, (const int (*)[3])face, n);
}

// --- The climb, line by line ------------------------------------------------------
static void come(void)
{
    now = COME;
    path[walked++] = v = best;
    half = net.vertex_half[v];
}

static void climb_from(int k)
{
    first = best = k;
    most = height(k);
    walked = frame = 0;
    asked = 1;
    come();
}

static int lowest(void)
{
    int low = 0;
    for (int k = 1; k < CORNERS; k++) low = height(k) < height(low) ? k : low;
    return low;
}

// Where it ended, or, before the first, where it would have ended for d a little before.
static void begin_again(int last)
{
    climb_from(live_choice(FROM) == LAST ? last : lowest());
}

static vec3 turned(vec3 d, real degrees)
{
    vec3 flat = plane_turned(vec3_make(d.x, d.z, 0), plane_tangent(degrees));
    return vec3_make(flat.x, d.y, flat.y);
}

// One line more: as hull_climb() does it, and no faster than can be seen.
static void go_on(void)
{
    half_edge back = net.half[mesh_twin(half)];
    frame = 0;
    if (now == COME) now = ASK, asked++;
    else if (now == ASK) {
        if (height(back.origin) > most) most = height(best = back.origin);
        now = KEEP;
    } else if (now == KEEP) {
        half = back.next;
        if (half != net.vertex_half[v]) now = ASK, asked++;
        else if (best != v && walked < CORNERS) come();
        else now = DONE;
    } else {
        if (!is_led) tip = turned(tip, ++turns % 2 ? 14 : -14);
        begin_again(best);
    }
}

static void tell(void)
{
    static const char *const line[] = { "int h = m->vertex_half", "real height =", "best = height > most", "return best" };
    real d = vec3_length(tip);
    hull_mesh b = stone();
    if (now == DONE) live_say("No neighbour of corner %d is higher. %d heights were asked for; to look at all corners takes %d. hull_climb says corner %d.",
                              best, asked, CORNERS, hull_climb(&b, tip, first));
    else live_say("From corner %d, %.2f m along d, to its neighbours: the highest so far is corner %d, %.2f m along d.", v, height(v) / d, best,
                  height(best) / d);
    live_light(line[now]);
}

static void begin(void)
{
    if (!is_ready) {
        status done = make_stone();
        if (!done.ok) { live_say("%s", done.why); return; }
        is_ready = true;
    }
    tip = vec3_scale(REACH, vec3_unit(vec3_make(0.55, 0.62, 0.56)));
    is_led = false;
    turns = 0;
    hull_mesh b = stone();
    begin_again(hull_climb(&b, turned(tip, -14), 0));
    tell();
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame >= (now == DONE ? REST : PACE)) go_on();
    tell();
}

// --- Hands ------------------------------------------------------------------------
static void move(int number, vec3 to)
{
    if (number != TIP || !is_ready || vec3_length(to) < 0.01) return;
    is_led = true;
    tip = vec3_scale(REACH, vec3_unit(to));
    begin_again(best);
    tell();
}

// The corner that is nearest to the finger: the climb begins there.
static void tap(int number, vec3 along)
{
    (void)along;
    if (number != STONE || !is_ready) return;
    int near = 0;
    for (int k = 1; k < CORNERS; k++)
        if (vec3_distance(at[k], live_touched()) < vec3_distance(at[near], live_touched())) near = k;
    is_led = true;
    climb_from(near);
    tell();
}

// --- Drawing ----------------------------------------------------------------------
static vec3 outside(int k) { return vec3_scale(1.01, at[k]); }

static void draw_net(void)
{
    for (int h = 0; h < 2 * net.edges; h += 2) live_edge(LIVE_QUIET, vec3_scale(1.004, at[net.half[h].origin]), vec3_scale(1.004, at[mesh_target(&net, h)]));
}

static void draw_climb(void)
{
    for (int k = 0; k + 1 < walked; k++) live_tube(-1, LIVE_ORANGE, outside(path[k]), outside(path[k + 1]), 0.018);
    for (int k = 0; k < walked; k++) live_ball(-1, LIVE_ORANGE, outside(path[k]), k ? 0.03 : 0.045);
    if (now == ASK || now == KEEP) {
        int asks = net.half[mesh_twin(half)].origin;
        live_tube(-1, LIVE_RED, outside(v), outside(asks), 0.012);
        live_ball(-1, LIVE_RED, outside(asks), 0.04);
    }
    live_ball(-1, LIVE_GREEN, outside(best), 0.05);
}

static void draw(void)
{
    if (!is_ready) return;
    live_mesh(STONE, LIVE_BLUE, at, CORNERS, face[0], FACES, false);
    draw_net();
    draw_climb();
    live_tube(-1, LIVE_INK, vec3_make(0, 0, 0), tip, 0.014);
    live_ball(TIP, LIVE_INK, tip, 0.075);
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, at, sizeof at);
    h = live_hash(h, path, (size_t)walked * sizeof *path);
    return live_hash(h, (int[]){ best, asked, (int)now, frame }, 4 * sizeof(int));
}

const live_figure figure = {
    .name = "climb",
    .says = "A stone with 128 corners, and a direction d; a path leads along the edges of the stone to the corner that is furthest along d",
    .code = "lib/paper/climb.c hull_climb",
    .camera = { .distance = 4.6, .turn = 2.5, .rise = 0.05, .target = { 0, 0.1, 0 } },
    .dial = { [FROM] = { "it begins at", NULL, 0, 1, 1, LOWEST, "the lowest corner|where the last one ended", true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move, .tap = tap,
};
