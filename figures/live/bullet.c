// bullet.c - a fast ball and a thin plate: when is the contact looked for?
// (chapter 15)

#include "hit_face.h"
#include "live.h"
#include "swept.h"

enum { AIM, SPEED, THICKNESS };                 // dials
enum { BY_END, BY_SUBSTEPS, AHEAD, SWEPT, WAYS };   // lanes and lines of charts
enum { THROUGH_CHART, PUSHED_CHART };
enum { CORNERS = 12, PLATE = 8, SPEEDS = 31, SHOTS = 24, FLIGHT = 90, REST = 50 };
typedef enum { FLIES, STOPPED, THROUGH } outcome;
static const char *const NAME[WAYS] = { "end of frame", "substeps", "looking ahead", "swept" };
static const real RADIUS = 0.05, FRAME = 1.0 / 60, SPACE = 0.56;    // m, s; lanes
static const real HALF = 0.18, LEFT = -1.5, TOLERANCE = 1e-9;   // m, of the plate

static shape ball;
static vec3 plate_at[PLATE], stop[WAYS];
static outcome ends[WAYS];
static real through[WAYS][SPEEDS], pushed[WAYS][SPEEDS];
static int frame, shot, known;

static real speed_of(int k)                     // m/s: 1 to 1000, ten a decade
{
    static const real TEN[] = { 1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.3, 8 };
    static const real DECADE[] = { 1, 10, 100, 1000 };
    return DECADE[k / 10] * TEN[k % 10];
}

static hull placed(vec3 where, vec3 *at)
{
    for (int i = 0; i < CORNERS; i++) at[i] = vec3_add(ball.at[i], where);
    return (hull){ at, CORNERS };
}

static hull plate(void)
{
    return (hull){ plate_at, PLATE };
}

// --- One frame, by each way of looking --------------------------------------------
// Do they overlap here?  Then out by the hit face: on which side?
static outcome look(vec3 *where)
{
    vec3 at[CORNERS];
    hull here = placed(*where, at);
    gjk_result g = gjk_distance(here, plate(), HUGE_VAL, NULL);
    if (g.status != GJK_OVERLAP) return FLIES;
    hit_result h = hit_face_find(here, plate(), &g.last);
    *where = vec3_add_scaled(*where, h.depth, h.normal);
    return h.normal.x > 0.5 ? THROUGH : STOPPED;
}

static outcome by_substeps(vec3 *where, vec3 way)
{
    int n = (int)ceil(vec3_length(way) / shape_inner(&ball));
    vec3 from = *where;
    outcome o = FLIES;
    for (int k = 1; k <= n && o == FLIES; k++) {
        *where = vec3_add_scaled(from, (real)k / n, way);
        o = look(where);
    }
    return o;
}

// What may come near on this way gets a plane to stay in front of.
static outcome by_looking_ahead(vec3 *where, vec3 way)
{
    vec3 at[CORNERS];
    gjk_result g = gjk_distance(placed(*where, at), plate(), vec3_length(way), NULL);
    real nearing = g.status == GJK_APART ? -vec3_dot(way, vec3_unit(g.axis)) : 0;
    bool meets = g.distance < nearing;
    *where = vec3_add_scaled(*where, meets ? g.distance / nearing : 1, way);
    return meets ? STOPPED : FLIES;
}

static outcome by_sweep(vec3 *where, vec3 way)
{
    vec3 at[CORNERS], room[CORNERS + PLATE];
    swept_result s = swept_first_touch(placed(*where, at), way, plate(), 0, TOLERANCE, room);
    *where = vec3_add_scaled(*where, s.time, way);
    return s.status == SWEPT_PASSES ? FLIES : STOPPED;
}

static outcome fly_frame(int by, vec3 *where, vec3 way)
{
    if (by == BY_SUBSTEPS) return by_substeps(where, way);
    if (by == AHEAD) return by_looking_ahead(where, way);
    if (by == SWEPT) return by_sweep(where, way);
    *where = vec3_add(*where, way);
    return look(where);
}

// --- A whole shot -----------------------------------------------------------------
// Past the plate, a shot goes by 2 cm beside its rim.
static vec3 start_of(int number, bool beside, vec3 way)
{
    real phase = (number * 7 % SHOTS + 0.5) / SHOTS;
    return vec3_make(LEFT - phase * way.x, beside ? HALF + RADIUS + 0.02 : 0.01, 0);
}

static outcome fly(int by, int number, bool beside, real speed, vec3 *where)
{
    vec3 way = { speed * FRAME, 0, 0 };
    *where = start_of(number, beside, way);
    outcome o = FLIES;
    while (o == FLIES && where->x < -LEFT) o = fly_frame(by, where, way);
    return o;
}

static void shoot(void)
{
    for (int by = 0; by < WAYS; by++)
        ends[by] = fly(by, shot, live_choice(AIM), live_dial(SPEED), &stop[by]);
    frame = 0;
    shot++;
}

// All shots at one more speed, for the charts.
static void know_more(void)
{
    for (int by = 0; by < WAYS && known < SPEEDS; by++) {
        vec3 where;
        for (int k = 0; k < SHOTS; k++) {
            through[by][known] += 100.0 / SHOTS * (fly(by, k, false, speed_of(known), &where) != STOPPED);
            pushed[by][known] += 100.0 / SHOTS * (fly(by, k, true, speed_of(known), &where) != FLIES);
        }
        live_curve(THROUGH_CHART, by, through[by], known + 1);
        live_curve(PUSHED_CHART, by, pushed[by], known + 1);
    }
    known = int_min(known + 1, SPEEDS);
}

static void begin(void)
{
    shape_free(&ball);
    status done = shape_icosahedron(&ball, RADIUS, 1);
    if (!done.ok) live_say("%s", done.why);
    real thick = live_dial(THICKNESS) / 1000;
    for (int i = 0; i < PLATE; i++)
        plate_at[i] = vec3_make((i & 1 ? 0.5 : -0.5) * thick, i & 2 ? HALF : -HALF, i & 4 ? HALF : -HALF);
    for (int by = 0; by < WAYS; by++)
        for (int k = 0; k < SPEEDS; k++) through[by][k] = pushed[by][k] = 0;
    known = shot = 0;
    shoot();
}

static void step(void)
{
    know_more();
    if (++frame == FLIGHT + REST) shoot();
}

static void measure(void)
{
    real s = live_dial(SPEED) * FRAME, reach = RADIUS + live_dial(THICKNESS) / 2000;
    live_say("In a frame the ball goes %.0f cm. What is looked at once a frame is seen in time if that is less than %.1f cm.", 100 * s, 100 * reach);
}

// --- Drawing ----------------------------------------------------------------------
// Where the ball was seen: as it stood, or where those places lie too close, a dot.
static void draw_seen(vec3 lane, vec3 from, vec3 way, real end)
{
    for (vec3 seen = from; seen.x < end; seen = vec3_add(seen, way)) {
        if (way.x > 2 * RADIUS) live_circle(LIVE_RULE, vec3_add(seen, lane), RADIUS);
        live_dot(LIVE_QUIET, vec3_add(seen, lane), 2);
    }
}

// What has become of the shot, in a word.
static void draw_end(vec3 lane, bool has_ended, bool is_past, bool is_wrong)
{
    if (!has_ended && !is_past) return;
    live_label(is_wrong ? LIVE_RED : LIVE_GREEN, vec3_add(lane, vec3_make(0.1, 0.14, 0)),
               has_ended && is_wrong ? "stopped by nothing" : has_ended ? "stopped" : is_wrong ? "through the plate" : "flies by");
}

static void draw_lane(int by)
{
    vec3 lane = { 0, (WAYS - 1 - by) * SPACE, 0 }, way = { live_dial(SPEED) * FRAME, 0, 0 };
    vec3 at = start_of(shot - 1, live_choice(AIM), way), corners[4];
    real x = LEFT - 2 * LEFT * real_min(1, (real)frame / FLIGHT), end;
    bool has_ended = ends[by] == STOPPED && x >= stop[by].x, beside = live_choice(AIM);
    bool is_past = !has_ended && x > 0.1, is_wrong = beside ? has_ended : is_past && ends[by] != STOPPED;
    live_colour c = is_wrong ? LIVE_RED : has_ended || is_past ? LIVE_GREEN : LIVE_BLUE;
    if (by < WAYS - 1) live_line(LIVE_RULE, (vec3[]){ { LEFT, lane.y - SPACE / 2, 0 }, { -LEFT, lane.y - SPACE / 2, 0 } }, 2);
    end = has_ended ? stop[by].x : x;
    draw_seen(lane, at, way, end);
    live_line(c, (vec3[]){ { LEFT, lane.y + at.y, 0 }, { end, lane.y + at.y, 0 } }, 2);
    for (int i = 0; i < 4; i++) corners[i] = vec3_add(plate_at[i ^ i >> 1], lane);
    live_area(LIVE_INK, corners, 4);
    at = has_ended ? stop[by] : vec3_make(x, at.y, 0);
    live_circle(c, vec3_add(at, lane), RADIUS);
    live_label(LIVE_INK, vec3_add(lane, vec3_make(LEFT, 0.14, 0)), NAME[by]);
    draw_end(lane, has_ended, is_past, is_wrong);
}

static void draw(void)
{
    for (int by = 0; by < WAYS; by++) draw_lane(by);
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, stop, sizeof stop);
    h = live_hash(h, through, sizeof through);
    return live_hash(h, pushed, sizeof pushed);
}

const live_figure figure = {
    .name = "bullet",
    .says = "Four lanes, in each a ball that flies at a thin plate; a dot marks each place where the ball stands at the end of a frame",
    .pane = { { -1.56, -0.24, 3.12, 2.2 } },
    .dial = {
        [AIM] = { "shots go", NULL, 0, 1, 1, 0, "at the plate|just past it", true },
        [SPEED] = { "speed", "m/s", 1, 200, 1, 20, NULL, true },
        [THICKNESS] = { "thickness of the plate", "mm", 1, 60, 1, 10, NULL, true },
    },
    .chart = {
        [THROUGH_CHART] = { "shots at the plate that go through, %", NULL, { "end of frame", "substeps", "looking ahead", "swept" }, 0, 100, false, false, "speed, from 1 to 1000 m/s, logarithmic" },
        [PUSHED_CHART] = { "shots past it that are stopped, %", NULL, { "end of frame", "substeps", "looking ahead", "swept" }, 0, 100, false, false, "speed" },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
};
