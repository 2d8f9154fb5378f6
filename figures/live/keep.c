// keep.c - of all corners in which a coin may touch, which four are kept?  Those without
// which it could sink deepest, one after the other (chapter 11).

#include "live.h"
#include "plane.h"

// The library's own, so that it can be asked for one corner after the other.
#define manifold_find keep_find
#define manifold_on_plane keep_on_plane
#define face_is_along keep_looks
#define face_area keep_area
#include "../../lib/query/manifold.c"

enum { LEAN };                                  // dial
enum { ABOVE, BESIDE };                         // panes
enum { CORNERS = 20, PACE = 80, REST = 160 };
static const real RADIUS = 1, TIMES = 8;        // m; the lean is drawn so large

static meetings met;
static vec3 low_side = { 0.9, 0.35, 0 };        // where the coin is lowest
static int chosen[MANIFOLD_POINTS], count, now, frame;

static vec3 rim_corner(int k)
{
    return vec3_scale(RADIUS, plane_turned(vec3_make(1, 0, 0), plane_tangent(360.0 * (k + 0.5) / CORNERS - 180)));
}

// m, of a coin that leans by that dial: 0 where it is lowest.
static real gap_at(vec3 x)
{
    real t = 2 * plane_tangent(live_dial(LEAN));
    return t * (RADIUS - vec3_dot(x, vec3_unit(low_side)));
}

// As choose() and choose_exposed() do, with a look after each.
static void solve(void)
{
    vec3 kept[MANIFOLD_POINTS];
    met.same = 1e-9;
    met.count = CORNERS;
    chosen[0] = 0;
    for (int k = 0; k < CORNERS; k++) {
        met.at[k] = rim_corner(k);
        met.of[k] = (touch){ .gap = gap_at(met.at[k]) };
        if (met.of[k].gap < met.of[chosen[0]].gap - 1e-9) chosen[0] = k;
    }
    for (count = 1; count < MANIFOLD_POINTS; count++) {
        kept[count - 1] = met.at[chosen[count - 1]];
        int k = most_exposed(&met, CORNERS, kept, count, MANIFOLD_TURN, -HUGE_VAL);
        if (k < 0) break;
        chosen[count] = k;
    }
}

static void tell(void)
{
    if (now == 0) live_say("The deepest corner comes first.");
    else if (now < count) live_say("Corner %d: the body could turn by %.2f rad about those that are kept. This one would come deepest, by %.0f mm.", now + 1,
                                   MANIFOLD_TURN, 1000 * (MANIFOLD_TURN * sqrt(apart_from(met.at[chosen[now]], (vec3[]){ met.at[chosen[0]], met.at[chosen[1]], met.at[chosen[2]] }, now)) - met.of[chosen[now]].gap));
    else live_say("Of %d corners four are kept. Lean the coin: is it still the far side that is kept?", CORNERS);
    live_light(now == 0 || now >= count ? "" : frame < PACE / 2 ? "real near = apart_from" : "real deep = turn");
}

static void begin(void)
{
    now = frame = 0;
    solve();
    tell();
}

static void step(void)
{
    if (++frame >= (now == count ? REST : PACE)) {
        frame = 0;
        now = now == count ? 0 : now + 1;
    }
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    vec3 way = { to.x, to.y, 0 };
    if (vec3_length(way) > 0.05) low_side = way;
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static int kept_now(void) { return int_min(now + 1, count); }

// Corner k is a dot, as large as how deep it could come if it were not kept.
static void draw_danger(int k)
{
    vec3 kept[MANIFOLD_POINTS];
    int n = int_min(int_max(now, 1), count);
    for (int i = 0; i < n; i++) kept[i] = met.at[chosen[i]];
    real near = sqrt(apart_from(met.at[k], kept, n)), deep = MANIFOLD_TURN * near - met.of[k].gap;
    bool is_next = now > 0 && now < count && chosen[now] == k;
    live_dot(is_next ? LIVE_RED : deep > 0 ? LIVE_ORANGE : LIVE_GREY, met.at[k], 3 + real_max(0, real_min(6, 6 * deep / (2 * MANIFOLD_TURN))));
}

static void draw_above(void)
{
    vec3 rim[CORNERS], kept[MANIFOLD_POINTS];
    live_pane(ABOVE);
    for (int k = 0; k < CORNERS; k++) rim[k] = met.at[k];
    live_area(LIVE_BLUE, rim, CORNERS);
    for (int i = 0; i < kept_now(); i++) kept[i] = met.at[chosen[i]];
    for (int i = 0; i < kept_now(); i++)
        for (int j = i + 1; j < kept_now(); j++) live_line(LIVE_GREEN, (vec3[]){ kept[i], kept[j] }, 2);
    for (int k = 0; k < CORNERS; k++) draw_danger(k);
    for (int i = 0; i < kept_now(); i++) live_circle(LIVE_GREEN, kept[i], 0.1);
    vec3 low = vec3_scale(1.3, vec3_unit(low_side));
    live_label(LIVE_INK, vec3_make(low.x - 0.08, low.y - 0.27, 0), "low");
    live_handle(0, LIVE_INK, low, "the low side");
    live_label(LIVE_QUIET, vec3_make(-1.5, 1.33, 0), "from above");
}

// Across the lowest place: the coin leans more than it does.
static void draw_beside(void)
{
    live_pane(BESIDE);
    vec3 out = vec3_unit(low_side), end[2];
    live_line(LIVE_QUIET, (vec3[]){ { -1.4, 0, 0 }, { 1.4, 0, 0 } }, 2);
    for (int k = 0; k < CORNERS; k++) {
        real x = vec3_dot(out, met.at[k]);
        bool is_kept = false;
        for (int i = 0; i < kept_now(); i++) is_kept |= chosen[i] == k;
        live_dot(is_kept ? LIVE_GREEN : LIVE_BLUE, vec3_make(x, TIMES * met.of[k].gap, 0), is_kept ? 6 : 3);
    }
    end[0] = vec3_make(-RADIUS, TIMES * gap_at(vec3_scale(-RADIUS, out)), 0);
    end[1] = vec3_make(RADIUS, 0, 0);
    live_line(LIVE_BLUE, end, 2);
    live_label(LIVE_QUIET, vec3_make(-1.4, -0.32, 0), "from the side, 8 times as high");
}

static void draw(void)
{
    draw_above();
    draw_beside();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, chosen, (size_t)count * sizeof *chosen);
    for (int k = 0; k < CORNERS; k++) h = live_hash(h, &met.of[k].gap, sizeof(real));
    return live_hash(h, (int[]){ now, frame }, 2 * sizeof(int));
}

const live_figure figure = {
    .name = "keep",
    .says = "A coin seen from above and from the side; of its corners four are kept, one after the other, and the others are as large as they could come deep",
    .code = "lib/query/manifold.c most_exposed",
    .pane = { [ABOVE] = { -1.6, -1.5, 3.2, 3 }, [BESIDE] = { -1.5, -0.45, 3, 1.7 } },
    .dial = { [LEAN] = { "the coin leans by", "°", 0, 4, 0.1, 1, NULL, true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
