// front.c - joints are solved one after the other, and bodies that still have joints
// wait: a front goes through a chain, a tree, a ring, a net (chapter 17).

#include "join.h"
#include "live.h"
#include "step.h"

enum { FORM };                                  // dial
enum { CHAIN, TREE, RING, NET };
enum { DRAWING, MATRIX };                       // panes
enum { MOST = 16, SIDE = 4, JOINTS = 24 };
enum { PACE = 30, BACK = 12, REST = 110 };      // frames
typedef enum { INWARD, OUTWARD, DONE } phase;

typedef struct {
    int  bodies, joints;
    vec3 at[MOST];
    int  a[JOINTS], b[JOINTS];
} plan;

static const vec3 ROUND[] = {
    { -0.5, 1.2, 0 }, { 0.5, 1.2, 0 }, { 1.2, 0.5, 0 }, { 1.2, -0.5, 0 },
    { 0.5, -1.2, 0 }, { -0.5, -1.2, 0 }, { -1.2, -0.5, 0 }, { -1.2, 0.5, 0 }
};
static const vec3 HANGING[] = {
    { 0, 1.2, 0 }, { -0.85, 0.45, 0 }, { 0.85, 0.45, 0 }, { -1.3, -0.4, 0 }, { -0.45, -0.4, 0 },
    { 0.45, -0.4, 0 }, { 1.3, -0.4, 0 }, { -1.3, -1.2, 0 }, { -0.45, -1.2, 0 }, { 0.45, -1.2, 0 }
};
static const int PARENT[] = { -1, 0, 0, 1, 1, 2, 2, 3, 4, 5 };

static plan web;
static world links;
static shape box;
static bool is_ready;
static phase now;
static int at, frame;                           // the step that is shown

// --- What hangs together ----------------------------------------------------------
static void add_body(vec3 where) { web.at[web.bodies++] = where; }

static void add_joint(int a, int b)
{
    web.a[web.joints] = a;
    web.b[web.joints++] = b;
}

static void plan_web(int form)
{
    web = (plan){ .bodies = 0 };
    for (int k = 0; k < 8 && form == CHAIN; k++) add_body(vec3_make(-1.4 + 0.4 * k, k % 2 ? 0.45 : -0.45, 0));
    for (int k = 0; k < 8 && form == RING; k++) add_body(ROUND[k]);
    for (int k = 0; k < 10 && form == TREE; k++) add_body(HANGING[k]);
    for (int k = 0; k < MOST && form == NET; k++) add_body(vec3_make(-1.2 + 0.8 * (k % SIDE), 1.2 - 0.8 * (k / SIDE), 0));
    for (int k = 1; k < web.bodies; k++) {
        if (form != NET) add_joint(form == TREE ? PARENT[k] : k - 1, k);
        if (form == NET && k % SIDE) add_joint(k - 1, k);
        if (form == NET && k >= SIDE) add_joint(k - SIDE, k);
    }
    if (form == RING) add_joint(0, web.bodies - 1);
}

// The library plans its steps when a frame begins: they are shown as they stand then.
static void begin(void)
{
    if (is_ready) {
        world_free(&links);
        shape_free(&box);
    }
    plan_web(live_choice(FORM));
    world_options how = world_options_default();
    how.gravity = vec3_make(0, 0, 0);
    status done = world_init(&links, how);
    if (done.ok) done = shape_box(&box, vec3_make(0.2, 0.2, 0.2), 1);
    for (int k = 0; k < web.bodies && done.ok; k++) done = world_add(&links, &box, placement_at(web.at[k]), NULL);
    for (int k = 0; k < web.joints && done.ok; k++)
        done = world_join(&links, (joint_plan){ .kind = JOINT_BALL, .a = web.a[k], .b = web.b[k],
                          .point = vec3_scale(0.5, vec3_add(web.at[web.a[k]], web.at[web.b[k]])) }, NULL);
    is_ready = done.ok;
    if (done.ok) world_step(&links);
    else live_say("%s", done.why);
    now = INWARD;
    at = frame = 0;
}

// --- Frames -----------------------------------------------------------------------
static const linkage *joints(void) { return &links.joints; }
static const linkage_step *this_step(void) { return &joints()->step[at]; }

static int widest(void)
{
    int most = 0;
    for (int k = 0; k < joints()->steps; k++) most = int_max(most, joints()->step[k].count);
    return most;
}

static void tell(void)
{
    int n = this_step()->count, steps = joints()->steps;
    if (now == INWARD && n == 0) live_say("Joint %d of %d. No body waits any more.", at + 1, steps);
    else if (now == INWARD && n == 1) live_say("Joint %d of %d. One body of this front waits for another joint: one block.", at + 1, steps);
    else if (now == INWARD) live_say("Joint %d of %d. Now %d bodies of this front wait, and an impulse on one moves all: %d blocks.", at + 1, steps, n, n * n);
    else if (now == OUTWARD) live_say("And back: what the later joints give is known, so joint %d is known.", at + 1);
    else live_say("All %d joints hold. The widest front had %d bod%s.", steps, widest(), widest() == 1 ? "y" : "ies");
    live_light(now != INWARD ? "" : frame < PACE / 3 ? "take_speed(r->want, n, r->a" : frame < 2 * PACE / 3 ? "small_times(n, r->inverse" : "drive_by(l->body[l->reach[i].body]");
}

static void step(void)
{
    if (!is_ready || joints()->steps == 0) return;
    if (++frame >= (now == INWARD ? PACE : now == OUTWARD ? BACK : REST)) {
        frame = 0;
        if (now == INWARD && ++at == joints()->steps) now = OUTWARD;
        if (now == OUTWARD && --at < 0) now = DONE, at = 0;
        else if (now == DONE) now = INWARD;
    }
    tell();
}

static void press(int button)
{
    (void)button;
    frame = REST;
    step();
}

// --- Drawing ----------------------------------------------------------------------
// The step that solves that joint, from 0.
static int step_of(int number)
{
    int k = 0;
    while (k < joints()->steps && joints()->step[k].joint != number) k++;
    return k;
}

// Of the joints of body b: how many are solved, and how many are left?
static void count_joints(int b, int *solved, int *left)
{
    *solved = *left = 0;
    for (int k = 0; k < web.joints; k++) {
        if (web.a[k] != b && web.b[k] != b) continue;
        *(step_of(k) <= at ? solved : left) += 1;
    }
}

static live_colour joint_colour(int number)
{
    int k = step_of(number);
    if (now == INWARD) return k == at ? LIVE_RED : k < at ? LIVE_GREY : LIVE_BLUE;
    return now == DONE || k > at ? LIVE_GREEN : k == at ? LIVE_RED : LIVE_GREY;
}

static live_colour body_colour(int b)
{
    int solved, left;
    count_joints(b, &solved, &left);
    if (now == INWARD) return solved == 0 ? LIVE_BLUE : left > 0 ? LIVE_ORANGE : LIVE_GREY;
    return now == DONE || left > 0 || at == joints()->steps - 1 ? LIVE_GREEN : LIVE_GREY;
}

static void draw_web(void)
{
    live_pane(DRAWING);
    for (int k = 0; k < web.joints; k++) {
        vec3 end[2] = { web.at[web.a[k]], web.at[web.b[k]] };
        live_line(joint_colour(k), end, 2);
        live_dot(joint_colour(k), vec3_scale(0.5, vec3_add(end[0], end[1])), joint_colour(k) == LIVE_RED ? 6 : 3);
    }
    for (int b = 0; b < web.bodies; b++) live_circle(body_colour(b), web.at[b], 0.17);
}

// Which places of the bodies' own order does step k couple?
static int places(int k, int *out)
{
    const linkage_step *s = &joints()->step[k];
    for (int i = 0; i < s->count; i++) out[i] = joints()->body[joints()->reach[s->first + i].body].place;
    return s->count;
}

static void draw_cell(live_colour c, int row, int column)
{
    real d = 2.6 / web.bodies, x = -1.3 + d * column, y = 1.3 - d * row, e = 0.9 * d;
    live_band(c, (vec3[]){ { x, y, 0 }, { x + e, y, 0 }, { x + e, y - e, 0 }, { x, y - e, 0 } }, 4);
}

// A block for each two bodies of which one answers impulses on the other.
static void draw_matrix(void)
{
    int first = joints()->groups > 0 ? joints()->group[0].first_body : 0;
    live_colour cell[MOST][MOST];
    for (int i = 0; i < web.bodies; i++)
        for (int j = 0; j < web.bodies; j++) cell[i][j] = LIVE_INK;
    for (int k = 0; k < joints()->steps && (now != INWARD || k <= at); k++) {
        int place[MOST], n = places(k, place);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) cell[place[i] - first][place[j] - first] = k == at && now != DONE ? LIVE_ORANGE : LIVE_QUIET;
    }
    live_pane(MATRIX);
    live_line(LIVE_RULE, (vec3[]){ { -1.33, 1.33, 0 }, { 1.33, 1.33, 0 }, { 1.33, -1.33, 0 }, { -1.33, -1.33, 0 }, { -1.33, 1.33, 0 } }, 5);
    for (int i = 0; i < web.bodies; i++)
        for (int j = 0; j < web.bodies; j++)
            if (cell[i][j] != LIVE_INK) draw_cell(cell[i][j], i, j);
}

static void draw(void)
{
    if (!is_ready) return;
    draw_web();
    draw_matrix();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, (int[]){ (int)now, at, frame }, 3 * sizeof(int));
    for (int k = 0; is_ready && k < joints()->steps; k++)
        h = live_hash(h, (int[]){ joints()->step[k].joint, joints()->step[k].count }, 2 * sizeof(int));
    return h;
}

const live_figure figure = {
    .name = "front",
    .says = "Bodies that hang together, whose joints are solved one after the other; beside them the blocks by which those that wait answer each other",
    .code = "lib/joint/linkage.c solve_inward",
    .pane = { [DRAWING] = { -1.9, -1.5, 3.8, 3 }, [MATRIX] = { -1.9, -1.5, 3.8, 3 } },
    .dial = { [FORM] = { "joined as a", NULL, 0, 3, 1, 2, "chain|tree|ring|net", true } },
    .button = { "Next joint" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press,
};
