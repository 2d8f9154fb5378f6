// fabric.c - a square of silk, denim or card hangs over a ball that is led about
// below it (chapter 16).

#include "capsule.h"
#include "handle.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"
#include "world_scene.h"

enum { FABRIC, SIDE, SUBSTEPS };                // dials
enum { STRAIN, TIME };                          // charts
enum { BALL, CLOTH, PIN };                      // bodies; pins from here on
enum { MOST = 40, PINS = 2 };
static const real WIDTH = 0.42, HIGH = 0.33, RADIUS = 0.075;     // m
static const real PACE = 2.5;                   // 1/s, of the ball, times 2 pi

// kg/m^2, N m, m/N.
static const struct { real weight, bending, give; } KIND[] = {
    { 0.06, 5e-6, 5e-5 }, { 0.4, 1e-4, 1e-4 }, { 0.3, 0.016, 8e-7 },
};

static world room;
static shape ball_shape, cloth_shape;
static bool is_ready, is_led;
static vec3 led_to, aim, aim_velocity, pulled_to;
static bool is_pinned[PINS];
static int pulled = -1, frame;

static int corner_of(int k)
{
    int side = (int)live_dial(SIDE);
    return side * side - (k == 0 ? 1 : side);
}

static status add_all(void)
{
    int side = (int)live_dial(SIDE), f = live_choice(FABRIC);
    status done = shape_sphere(&ball_shape, RADIUS, 1);
    if (done.ok) done = shape_cloth(&cloth_shape, side, side, WIDTH, WIDTH, KIND[f].weight * WIDTH * WIDTH, 0.3);
    if (done.ok) done = world_add_plane(&room, vec3_make(0, 1, 0), 0);
    if (done.ok) done = world_add(&room, &ball_shape, placement_at(aim), NULL);
    if (done.ok) done = world_add(&room, &cloth_shape, placement_at(vec3_make(0, HIGH, 0)), NULL);
    if (done.ok) done = world_bend(&room, CLOTH, KIND[f].bending);
    if (done.ok) done = world_stretch(&room, CLOTH, KIND[f].give);
    return done;
}

static void begin(void)
{
    if (is_ready) {
        world_free(&room);
        shape_free(&ball_shape);
        shape_free(&cloth_shape);
    }
    static const real TIMES[] = { 0.5, 1, 2, 4 };
    world_options how = world_scene_options(SCENE_CLOTH_ON_CUBE, (int)live_dial(SIDE));
    how.substeps = int_max(1, (int)(world_substeps(&how) * TIMES[live_choice(SUBSTEPS)]));
    how.friction = 0.8;
    aim = vec3_make(-0.05, 0.23, 0);
    aim_velocity = vec3_make(0, 0, 0.12);
    status done = world_init(&room, how);
    if (done.ok) done = add_all();
    is_ready = done.ok;
    is_led = false;
    pulled = -1;
    frame = 0;
    for (int k = 0; k < PINS; k++) is_pinned[k] = false;
    if (done.ok) world_set_kind(&room, BALL, BODY_KINEMATIC);
    else         live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
static vec3 particle_at(int i)
{
    static vec3 at[MOST * MOST];
    world_vertices(&room, &room.body[CLOTH], at);
    return at[i];
}

static void move(int number, vec3 to)
{
    if (!is_ready || number >= PIN) return;
    if (number == BALL) {
        is_led = true;
        led_to = vec3_make(to.x, real_max(to.y, RADIUS + 0.01), to.z);
        return;
    }
    pulled_to = to;
    if (pulled >= 0) return;
    pulled = 0;
    for (int i = 1; i < cloth_shape.particles; i++)
        if (vec3_distance(particle_at(i), to) < vec3_distance(particle_at(pulled), to)) pulled = i;
}

static void release(int number)
{
    if (number == CLOTH) pulled = -1;
}

static void set_pin(int k, bool holds)
{
    if (holds == is_pinned[k]) return;
    is_pinned[k] = holds;
    if (holds) world_pin(&room, CLOTH, corner_of(k));
    else       world_unpin(&room, CLOTH, corner_of(k));
}

static void press(int button)
{
    if (!is_ready) return;
    if (button == 0) for (int k = 0; k < PINS; k++) set_pin(k, true);
    else             set_pin(is_pinned[1] ? 1 : 0, false);
}

// A pin that is touched is cut.
static void tap(int number, vec3 along)
{
    (void)along;
    if (number >= PIN) set_pin(number - PIN, false);
}

// --- Frames -----------------------------------------------------------------------
// By itself the ball goes about as a weight on springs does.
static void lead_ball(void)
{
    const vec3 middle = { 0, 0.23, 0 };
    aim_velocity = vec3_add_scaled(aim_velocity, -PACE * PACE / 60, vec3_sub(aim, middle));
    aim = vec3_add_scaled(aim, 1.0 / 60, aim_velocity);
    vec3 way = vec3_sub(is_led ? led_to : aim, world_where(&room, BALL).position);
    vec3 v = vec3_scale(15, way);
    if (vec3_length(v) > 1.5) v = vec3_scale(1.5, vec3_unit(v));
    world_set_velocity(&room, BALL, v, vec3_make(0, 0, 0));
}

static void step(void)
{
    if (!is_ready) return;
    lead_ball();
    if (pulled >= 0) {
        vec3 dv = vec3_scale(8, vec3_sub(pulled_to, particle_at(pulled)));
        world_push_particle(&room, CLOTH, pulled, vec3_scale(5 * cloth_shape.mass[pulled], dv));
    }
    world_step(&room);
    frame++;
}

static void measure(void)
{
    if (!is_ready || frame % 4) return;
    measures m = world_measure(&room);
    live_value(STRAIN, 0, 100 * m.strain);
    live_say("The longest link is off by %.2f %%. The frame took %d substeps.", 100 * m.strain, room.report.substeps);
}

static void draw(void)
{
    if (!is_ready) return;
    live_ball(BALL, LIVE_ORANGE, world_where(&room, BALL).position, RADIUS - 0.004);
    live_world_body(&room, CLOTH, LIVE_BLUE);
    for (int k = 0; k < PINS; k++)
        if (is_pinned[k]) live_ball(PIN + k, LIVE_INK, particle_at(corner_of(k)), 0.009);
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&room) : 0;
}

const live_figure figure = {
    .name = "fabric",
    .says = "A square of cloth has fallen on a ball that moves about",
    .camera = { .distance = 1.05, .turn = 0.5, .rise = 0.42, .target = { 0, 0.17, 0 }, .has_floor = true },
    .dial = {
        [FABRIC] = { "cloth", NULL, 0, 2, 1, 0, "silk|denim|card", true },
        [SIDE] = { "particles a side", NULL, 8, MOST, 1, 24, NULL, true },
        [SUBSTEPS] = { "substeps", NULL, 0, 3, 1, 1, "half|usual|double|4 ×", true },
    },
    .button = { "Pin two corners", "Cut a pin" },
    .chart = {
        [STRAIN] = { "longest link, error", "%", { NULL }, 0.01, 10, true, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 0.5, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = tap, .move = move, .release = release,
};
