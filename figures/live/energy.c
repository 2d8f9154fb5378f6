// energy.c - a heap of bodies under the whole engine, which keeps what it found,
// or forgets it; and where the energy is (chapter 18).

#include "capsule.h"
#include "forget.h"
#include "ledger.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

enum { MEMORY, BODIES, FRICTION, RESTITUTION }; // dials
enum { ENERGY, ASKED, TIME };                   // charts
enum { MOVING, HIGH, LOST, SUM };               // lines of the first
enum { FORGOTTEN = 1, KINDS = 4, WALLS = 5, LAYER = 16 };
static const live_colour COLOUR[KINDS] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_PURPLE };
static const real HALF = 1.3;                   // m, of the room

static world room;
static shape solid[KINDS];
static bool is_ready;
static int thrown;

static status make_solids(void)
{
    status done = shape_box(&solid[0], vec3_make(0.42, 0.32, 0.32), 1);
    if (done.ok) done = shape_icosahedron(&solid[1], 0.22, 1);
    if (done.ok) done = shape_capsule(&solid[2], 0.25, 0.13, 1);
    if (done.ok) done = shape_sphere(&solid[3], 0.18, 1);
    return done;
}

static status add_walls(void)
{
    static const vec3 INWARD[WALLS] = { { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    status done = status_ok();
    for (int k = 0; k < WALLS && done.ok; k++)
        done = world_add_plane(&room, INWARD[k], k == 0 ? 0 : -HALF);
    return done;
}

// In layers of four by four, each a little aside of the one below.
static status add_bodies(void)
{
    status done = status_ok();
    for (int k = 0; k < (int)live_dial(BODIES) && done.ok; k++) {
        int layer = k / LAYER, place = k % LAYER;
        vec3 at = { 0.55 * (place % 4 - 1.5) + 0.1 * (layer % 3 - 1), 0.4 + 0.5 * layer,
                    0.55 * (place / 4 - 1.5) + 0.08 * (layer % 2) };
        placement p = placement_at(at);
        p.spin = vec3_make(k % 3 - 1, k % 5 - 2, k % 2);
        done = world_add(&room, &solid[(k + layer) % KINDS], p, NULL);
    }
    return done;
}

static void begin(void)
{
    if (is_ready) world_free(&room);
    for (int k = 0; k < KINDS; k++) shape_free(&solid[k]);
    world_options how = world_options_default();
    how.friction = live_dial(FRICTION);
    how.restitution = live_dial(RESTITUTION);
    how.ledger = true;
    status done = make_solids();
    if (done.ok) done = world_init(&room, how);
    is_ready = done.ok;
    if (done.ok) done = add_walls();
    if (done.ok) done = add_bodies();
    thrown = 0;
    if (!done.ok) live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
static void throw_body(int b, vec3 along)
{
    if (is_ready) live_world_hurry(&room, b, vec3_add(vec3_scale(4, along), vec3_make(0, 4, 0)));
}

static void press(int button)
{
    (void)button;
    throw_body(thrown++ % room.bodies, vec3_make(0, 0.5, 0));
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!is_ready) return;
    if (live_held() >= 0) live_world_pull(&room, live_held(), 0);
    if (live_choice(MEMORY) == FORGOTTEN) cache_clear(&room.rigid.cache);
    world_step(&room);
}

// J, of the particles in the middle of the last substep.
static real kinetic(void)
{
    real sum = 0;
    for (int i = 0; i < room.pool.count; i++) {
        const particle *p = &room.pool.at[i];
        real h = body_age(&room, room.owner[i]);
        if (room.inverse_mass[i] > 0)
            sum += vec3_length_squared(vec3_sub(p->position, p->previous))
                   / (2 * h * h * room.inverse_mass[i]);
    }
    return sum;
}

// What all accounts but that of gravity and motion have taken.
static real taken(void)
{
    real sum = 0;
    for (int k = 0; k < LEDGERS; k++) sum -= room.ledger[k].energy;
    return sum;
}

static void measure(void)
{
    if (!is_ready) return;
    real whole = ledger_total(&room).energy, moving = kinetic();
    live_value(ENERGY, MOVING, moving);
    live_value(ENERGY, HIGH, whole - moving);
    live_value(ENERGY, LOST, taken());
    live_value(ENERGY, SUM, whole + taken());
    live_value(ASKED, 0, room.report.queries);
    live_say("%d of %d bodies sleep; %d pairs are near, %d of them touch. %d substeps.", room.report.asleep,
             room.bodies, room.report.pairs, room.report.pushing, room.report.substeps);
}

// --- Drawing ----------------------------------------------------------------------
static void draw_walls(void)
{
    vec3 foot[4] = { { -HALF, 0, -HALF }, { HALF, 0, -HALF }, { HALF, 0, HALF }, { -HALF, 0, HALF } };
    for (int k = 0; k < 4; k++) {
        vec3 up = vec3_make(0, 1.6, 0), next = foot[(k + 1) % 4];
        live_edge(LIVE_QUIET, foot[k], next);
        live_edge(LIVE_QUIET, foot[k], vec3_add(foot[k], up));
        live_edge(LIVE_QUIET, vec3_add(foot[k], up), vec3_add(next, up));
    }
}

static void draw(void)
{
    if (!is_ready) return;
    draw_walls();
    for (int b = 0; b < room.bodies; b++) {
        int kind = (int)(room.body[b].shape - solid);
        live_world_body(&room, b, room.sleep.asleep[b] ? LIVE_GREY : COLOUR[kind]);
    }
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&room) : 0;
}

const live_figure figure = {
    .name = "energy",
    .says = "Boxes, balls, rods and icosahedra fall into a room and come to rest; what sleeps is grey",
    .camera = { .distance = 6, .turn = 0.6, .rise = 0.42, .target = { 0, 0.65, 0 }, .has_floor = true },
    .dial = {
        [MEMORY] = { "what was found in the last frame is", NULL, 0, 1, 1, 0, "kept|forgotten", true },
        [BODIES] = { "bodies of 1 kg", NULL, 8, 160, 8, 80, NULL, true },
        [FRICTION] = { "friction", NULL, 0, 1, 0.05, 0.5, NULL, true },
        [RESTITUTION] = { "restitution", NULL, 0, 0.9, 0.05, 0.2, NULL, true },
    },
    .button = { "Throw one" },
    .chart = {
        [ENERGY] = { "energy", "J", { "of motion", "of height", "lost", "sum" }, 0, 100, false, false, NULL },
        [ASKED] = { "queries in a frame", NULL, { NULL }, 0, 100, false, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 0.5, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = throw_body,
};
