// sandbox.c - the scenes of chapters 19 and 19b, and whatever a reader adds, joins, pins
// and takes away: by tumble.h alone.

#include "example.h"
#include "live.h"
#include "view.h"

#include <math.h>
#include <stdlib.h>

enum { SCENE, NEW, TOUCH, WIND, GRAVITY };      // dials
enum { BOX, BALL, STONE, ROD, CLOTH, ROPE };
enum { STRIKE, PIN, TIE, CUT, TAKE };
enum { AWAKE, TIME };                           // charts
enum { WRECKER = 5, CAR = 10, BELT = 14, EMPTY = 16, MOST = 600, PINS = 64, ROUND = 60 };
static const real HIGH = 2.1;                   // m, as it is drawn: from there what is new falls
static const live_colour COLOUR[] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_PURPLE, LIVE_RED };

static const example nothing = { .name = "floor", .about = "an empty floor", .has_floor = true,
                                 .eye = { 2.8, 1.9, 5.1 }, .target = { 0, 1, 0 } };
static const example *scene;
static tumble_world *world;
static tumble_body all[MOST];
static int bodies, thrown;
static real rolled;                             // m, that a belt has gone
static struct { tumble_body body; int vertex; tumble_joint joint; } pin[PINS];
static int pins;
static bool is_tying;
static tumble_body tied;                        // the first of two that are tied, and where
static tumble_vec3 tied_at;

static tumble_vec3 given(vec3 v) { return tumble_v(v.x, v.y, v.z); }
static vec3 taken(tumble_vec3 v) { return vec3_make(v.x, v.y, v.z); }
static vec3 drawn(tumble_vec3 v) { return view_of(taken(v)); }

static void begin(void)
{
    int k = live_choice(SCENE);
    scene = k == EMPTY ? &nothing : examples[k];
    tumble_options o = scene->options ? scene->options() : tumble_options_default();
    tumble_world_free(world);
    world = tumble_world_make(&o);
    pins = thrown = 0;
    is_tying = false;
    rolled = 0;
    if (!world) return;
    if (scene->build) scene->build(world);
    else              tumble_plane_add(world, tumble_v(0, 1, 0), 0, -1);
    if (live_dial(GRAVITY) < 9.81 || live_dial(GRAVITY) > 9.81)
        tumble_world_set_gravity(world, tumble_v(0, -live_dial(GRAVITY), 0));
    view_look(taken(scene->eye), taken(scene->target), scene->has_floor);
    bodies = int_min(tumble_world_bodies(world, all, MOST), MOST);
}

static void turn(int dial)
{
    if (dial == GRAVITY && world)
        tumble_world_set_gravity(world, tumble_v(0, -live_dial(GRAVITY), 0));
}

// --- What is soft? ------------------------------------------------------------------
// A closed surface has 2 V - 4 triangles; a cloth has fewer, and a rope none.  (What is
// of several pieces has no list of them; of these only static ones are here.)
static bool is_soft(tumble_body b)
{
    int faces, n = tumble_body_vertices(world, b, NULL, 0);
    tumble_body_triangles(world, b, &faces);
    return n > 2 && faces < 2 * n - 4 && tumble_body_mass(world, b) > 0;
}

static int nearest_vertex(tumble_body b, vec3 at)
{
    int best = 0, n = tumble_body_vertices(world, b, NULL, 0);
    for (int i = 1; i < n; i++)
        if (vec3_distance(taken(tumble_body_vertex(world, b, i)), at)
            < vec3_distance(taken(tumble_body_vertex(world, b, best)), at))
            best = i;
    return best;
}

// The least box around a body, as far as it is seen.
typedef struct { vec3 least, most; } bounds;

static bounds bounds_of(tumble_body b)
{
    int n = tumble_body_vertices(world, b, NULL, 0);
    tumble_vec3 *vertex = malloc((size_t)n * sizeof *vertex);
    if (n > 0 && !vertex) abort();
    tumble_body_vertices(world, b, vertex, n);
    bounds box = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
    for (int i = 0; i < n; i++) {
        vec3 v = taken(vertex[i]);
        box.least = vec3_make(real_min(box.least.x, v.x), real_min(box.least.y, v.y), real_min(box.least.z, v.z));
        box.most = vec3_make(real_max(box.most.x, v.x), real_max(box.most.y, v.y), real_max(box.most.z, v.z));
    }
    free(vertex);
    return box;
}

// What the program moves: an arm, or what is wide and flat, a belt that goes along x.
static bool is_moved(tumble_body b)
{
    return tumble_body_get_options(world, b).kind == TUMBLE_KINEMATIC;
}

static bool is_belt(tumble_body b)
{
    if (!is_moved(b)) return false;
    bounds box = bounds_of(b);
    real high = box.most.y - box.least.y;
    return high < (box.most.x - box.least.x) / 4 && high < (box.most.z - box.least.z) / 4;
}

// --- One more ------------------------------------------------------------------------
static tumble_shape new_shape(int kind, double m)
{
    switch (kind) {
    case BOX:   return tumble_shape_box(world,
                                        tumble_v(0.35 * m, 0.35 * m, 0.35 * m),
                                        1);
    case BALL:  return tumble_shape_sphere(world, 0.2 * m, 1);
    case STONE: return tumble_shape_icosahedron(world, 0.22 * m, 1);
    case ROD:   return tumble_shape_capsule(world, 0.4 * m, 0.1 * m, 1);
    case CLOTH: return tumble_shape_cloth(world, 16, 16, 1.1 * m, 1.1 * m, 0.2);
    default:    return tumble_shape_rope(world, 24, 1.6 * m, 0.3);
    }
}

// How far up a body has to go, so that all that lies in its column is below it.
static real way_up(tumble_body b, real gap)
{
    bounds own = bounds_of(b);
    real up = 0;
    for (int k = 0; k < bodies; k++) {
        bounds other = bounds_of(all[k]);
        if (own.least.x < other.most.x && other.least.x < own.most.x
            && own.least.z < other.most.z && other.least.z < own.most.z)
            up = real_max(up, other.most.y + gap - own.least.y);
    }
    return up;
}

// What is new falls on all that is there, and begins further from it than a cloth here
// is thick, which is 1.1 of its links: one that began within another would be thrown out.
static void put_in(vec3 at)
{
    if (!world || bodies == MOST) return;
    tumble_shape s = new_shape(live_choice(NEW), 1 / view_scale());
    tumble_body b = tumble_body_add(world, s, tumble_body_at(at.x, at.y, at.z));
    if (!tumble_body_exists(world, b)) return;
    real up = way_up(b, 0.12 / view_scale());
    if (up > 0) {
        tumble_body_remove(world, b);
        b = tumble_body_add(world, s, tumble_body_at(at.x, at.y + up, at.z));
    }
    thrown++;
    if (tumble_body_exists(world, b)) all[bodies++] = b;
}

static void press(int button)
{
    (void)button;
    put_in(view_back(vec3_make(0.17 * (thrown * 3 % 7 - 3), HIGH, 0.15 * (thrown * 2 % 5 - 2))));
}

// A touch of the floor: one more falls there.
static void ground(vec3 at)
{
    put_in(view_back(vec3_make(at.x, HIGH, at.z)));
}

// --- Hands ------------------------------------------------------------------------------
static vec3 pull_of(tumble_vec3 at, tumble_vec3 velocity)
{
    return view_turn_back(live_pull(drawn(at), view_turn(taken(velocity))));
}

static void pull(tumble_body b)
{
    static tumble_body held;
    static int vertex;
    if (!is_soft(b)) {
        vec3 a = pull_of(tumble_body_position(world, b),
                         tumble_body_velocity(world, b));
        tumble_body_push(world, b,
                         given(vec3_scale(tumble_body_mass(world, b) / 60, a)),
                         tumble_body_position(world, b));
        return;
    }
    if (held.place != b.place) vertex = nearest_vertex(b, view_back(live_touched()));
    held = b;
    int n = tumble_body_vertices(world, b, NULL, 0);
    vec3 way = vec3_sub(view_back(live_touched()),
                        taken(tumble_body_vertex(world, b, vertex)));
    tumble_body_push_vertex(world, b, vertex,
                            given(vec3_scale(60 * tumble_body_mass(world, b)
                                             / n, way)));
}

static bool take_pin(tumble_body b)
{
    for (int k = 0; k < pins; k++) {
        if (pin[k].body.place != b.place) continue;
        if (pin[k].vertex >= 0) tumble_body_unpin(world, b, pin[k].vertex);
        else tumble_joint_remove(world, pin[k].joint);
        pin[k] = pin[--pins];
        return true;
    }
    return false;
}

static void put_pin(tumble_body b, vec3 at)
{
    if (pins == PINS || (!is_soft(b) && take_pin(b))) return;
    pin[pins].body = b;
    pin[pins].vertex = is_soft(b) ? nearest_vertex(b, at) : -1;
    if (pin[pins].vertex >= 0) tumble_body_pin(world, b, pin[pins].vertex);
    else pin[pins].joint = tumble_joint_ball(world, tumble_body_ground(), b,
                                             given(at));
    pins++;
}

// A string between two places of rigid bodies; a cloth or a rope hangs on a body.
static void tie(tumble_body b, vec3 at)
{
    if (!is_tying) {
        is_tying = true, tied = b, tied_at = given(at);
        return;
    }
    is_tying = false;
    if (b.place == tied.place || !tumble_body_exists(world, tied)) return;
    if (is_soft(b) && is_soft(tied)) return;
    if (is_soft(b)) tumble_joint_hang(world, b, nearest_vertex(b, at), tied);
    else if (is_soft(tied))
        tumble_joint_hang(world, tied, nearest_vertex(tied, taken(tied_at)), b);
    else tumble_joint_distance(world, tied, tied_at, b, given(at), 0,
                               vec3_distance(at, taken(tied_at)));
}

static void cut(tumble_body b)
{
    tumble_joint joint[MOST];
    int n = int_min(tumble_world_joints(world, joint, MOST), MOST);
    while (take_pin(b)) continue;
    for (int k = 0; k < n; k++)
        if (tumble_joint_body(world, joint[k], 0).place == b.place || tumble_joint_body(world, joint[k], 1).place == b.place)
            tumble_joint_remove(world, joint[k]);
    tumble_body_wake(world, b);
}

static void tap(int number, vec3 along)
{
    if (number >= bodies) return;
    tumble_body b = all[number];
    vec3 at = view_back(live_touched()), way = vec3_unit(view_turn_back(along));
    int what = live_choice(TOUCH);
    if (what == STRIKE && is_soft(b))
        tumble_body_push_vertex(world, b, nearest_vertex(b, at),
                                given(vec3_scale(0.2
                                                 * tumble_body_mass(world, b)
                                                 / view_scale(), way)));
    else if (what == STRIKE)
        tumble_body_push(world, b,
                         given(vec3_scale(3 * tumble_body_mass(world, b)
                                          / view_scale(), way)), given(at));
    else if (what == PIN) put_pin(b, at);
    else if (what == TIE) tie(b, at);
    else if (what == CUT) cut(b);
    else {
        cut(b);
        tumble_body_remove(world, b);
        for (int k = number; k + 1 < bodies; k++) all[k] = all[k + 1];
        bodies--;
    }
}

// --- Frames -------------------------------------------------------------------------------
// Wind drags cloth and rope along with it, and bodies eight times less.
static void blow(void)
{
    vec3 wind = view_turn_back(vec3_make(live_dial(WIND) * view_scale(), 0, 0));
    for (int k = 0; k < bodies; k++) {
        real m = tumble_body_mass(world, all[k]);
        if (m <= 0) continue;
        if (!is_soft(all[k])) {
            tumble_body_force(world, all[k], given(vec3_scale(m / 8, wind)),
                              tumble_v(0, 0, 0));
            continue;
        }
        int n = tumble_body_vertices(world, all[k], NULL, 0);
        for (int i = 0; i < n; i++)
            tumble_body_push_vertex(world, all[k], i,
                                    given(vec3_scale(m / n / 60, wind)));
    }
}

static void step(void)
{
    if (!world) return;
    if (live_held() >= 0 && live_held() < bodies) pull(all[live_held()]);
    if (live_dial(WIND) > 0) blow();
    if (scene->act) scene->act(world);
    for (int k = 0; k < bodies; k++)
        if (is_belt(all[k])) rolled += tumble_body_velocity(world, all[k]).x / 60;
    tumble_world_step(world);
}

static void measure(void)
{
    if (!world) return;
    tumble_report r = tumble_world_last_step(world);
    live_value(AWAKE, 0, r.bodies - r.asleep);
    if (tumble_world_failure(world))
        live_say("%s.", tumble_world_failure(world));
    else if (is_tying) live_say("Touch the other body.");
    else live_say("%s: %s. %d bodies, %d asleep; %d contacts, %d substeps.", scene->name, scene->about, r.bodies, r.asleep,
                  r.contacts, r.substeps);
}

// --- Drawing -------------------------------------------------------------------------------
static void draw_skin(int k, live_colour c)
{
    int faces, n = tumble_body_vertices(world, all[k], NULL, 0);
    const int *face = tumble_body_triangles(world, all[k], &faces);
    tumble_vec3 *vertex = malloc((size_t)n * sizeof *vertex);
    vec3 *at = malloc((size_t)n * sizeof *at);
    if (!vertex || !at) abort();
    tumble_body_vertices(world, all[k], vertex, n);
    for (int i = 0; i < n; i++) at[i] = drawn(vertex[i]);
    int number = tumble_body_mass(world, all[k]) > 0 ? k : -1;
    if (faces == 0)           live_rope(number, c, at, n, 0.02);
    else if (number < 0 && faces == 2 * n - 4) live_ground(c, at, face, faces, 0.25);
    else if (is_soft(all[k])) live_cloth(number, c, at, n, face, faces);
    else live_mesh(number, c, at, n, face, faces, faces < 2 * n - 4 || n > ROUND);
    free(vertex);
    free(at);
}

// Bodies of several pieces, and what joins them, as the library draws them.
static void on_triangle(void *context, tumble_body b, const tumble_vec3 at[3])
{
    (void)context;
    for (int k = 0; k < bodies; k++) {
        int faces;
        if (all[k].place != b.place || tumble_body_triangles(world, b, &faces))
            continue;
        vec3 corner[3] = { drawn(at[0]), drawn(at[1]), drawn(at[2]) };
        live_mesh(tumble_body_mass(world, b) > 0 ? k : -1, COLOUR[k % 5],
                  corner, 3, (int[]){ 0, 1, 2 }, 1, false);
    }
}

static void on_line(void *context, tumble_body b, const tumble_vec3 at[2])
{
    (void)context;
    for (int k = 0; k < bodies; k++)
        if (all[k].place == b.place && is_soft(b)) return;
    live_tube(-1, LIVE_QUIET, drawn(at[0]), drawn(at[1]), 0.008);
}

// Ribs across a belt go with it; what it carries lies on them.
static void draw_belt(tumble_body b)
{
    enum { RIBS = 16 };
    bounds box = bounds_of(b);
    real gap = (box.most.x - box.least.x) / RIBS, wide = gap / 6, y = box.most.y + 0.004;
    for (int k = 0; k < RIBS; k++) {
        real x = box.least.x + fmod(rolled + k * gap, RIBS * gap);
        vec3 corner[4] = { { x, y, box.least.z }, { x + wide, y, box.least.z }, { x + wide, y, box.most.z }, { x, y, box.most.z } };
        for (int i = 0; i < 4; i++) corner[i] = view_of(corner[i]);
        live_mesh(-1, LIVE_QUIET, corner, 4, (int[]){ 0, 3, 2, 0, 2, 1 }, 2, false);
    }
}

// A road for what drives, with a mark for every two metres.
static void draw_road(void)
{
    for (int k = -3; k < 40; k++)
        for (int side = -1; side <= 1; side++) {
            real z = 1.9 * side, x = 2 * k;
            live_tube(-1, side ? LIVE_QUIET : LIVE_ORANGE, view_of(vec3_make(x, 0, z)), view_of(vec3_make(x + (side ? 2 : 0.8), 0, z)), 0.012);
        }
}

// On an empty floor a ring shows where what is put in will fall.
static void draw_ring(void)
{
    enum { ARCS = 48 };
    vec3 before = { 0.35, 0.002, 0 };
    for (int k = 1; k <= ARCS; k++) {
        real angle = 2 * 3.14159265358979 * k / ARCS;
        vec3 here = { 0.35 * cos(angle), 0.002, 0.35 * sin(angle) };
        live_edge(LIVE_QUIET, before, here);
        before = here;
    }
}

static void draw(void)
{
    if (!world) return;
    if (bodies == 0) draw_ring();
    if (live_choice(SCENE) == CAR) draw_road();
    tumble_pen pen = { on_triangle, on_line, NULL, NULL };
    for (int k = 0; k < bodies; k++) {
        int faces;
        bool is_whole = tumble_body_triangles(world, all[k], &faces)
            || is_soft(all[k]);
        bool rests = !tumble_body_is_awake(world, all[k])
            || tumble_body_mass(world, all[k]) <= 0;
        bool belt = is_belt(all[k]);
        if (is_whole) draw_skin(k, is_moved(all[k]) && !belt ? LIVE_ORANGE : rests ? LIVE_GREY : COLOUR[k % 5]);
        if (belt) draw_belt(all[k]);
    }
    tumble_world_draw(world, &pen);
    for (int k = 0; k < pins; k++)
        if (pin[k].vertex >= 0)
            live_ball(-1, LIVE_INK,
                      drawn(tumble_body_vertex(world, pin[k].body,
                                               pin[k].vertex)), 0.03);
        else live_ball(-1, LIVE_INK,
                       drawn(tumble_body_position(world, pin[k].body)), 0.03);
    if (is_tying) live_ball(-1, LIVE_RED, drawn(tied_at), 0.04);
}

static unsigned long long hash(void)
{
    return world ? tumble_world_hash(world) : 0;
}

const live_figure figure = {
    .name = "sandbox",
    .says = "The scenes of the library, to be pulled, struck, pinned, tied, cut and filled",
    // The wrecker asks for acos(-1) alone, which all libraries round alike.
    .fickle = ~(1u << 0 | 1u << WRECKER | 1u << 8 | 1u << 9 | 1u << BELT | 1u << EMPTY),
    .camera = VIEW_CAMERA,
    .dial = {
        [SCENE] = { "scene", NULL, 0, EMPTY, 1, WRECKER,
                    "pyramid|dominoes|cradle|bridge|ragdoll|wrecker|marbles|flag|curtain|blanket|car|crane|terrain|walker|belt|cape|empty",
                    true },
        [TOUCH] = { "a touch", NULL, 0, 4, 1, 0, "strikes|pins, or lets go|ties two|cuts loose|takes away", false },
        [NEW] = { "one more", NULL, 0, 5, 1, 0, "box|ball|stone|rod|cloth|rope", false },
        [WIND] = { "wind on cloth", "m/s²", 0, 15, 0.5, 0, NULL, false },
        [GRAVITY] = { "gravity", "m/s²", 0, 20, 0.01, 9.81, NULL, false },
    },
    .button = { "Put one in" },
    .chart = {
        [AWAKE] = { "bodies awake", NULL, { NULL }, 0, 10, false, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .turn = turn, .press = press, .tap = tap, .ground = ground,
};
