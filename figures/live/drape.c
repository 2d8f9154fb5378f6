// drape.c - a cloth on a cube or on a rope: as printed, as mended, and under the
// engine of Part II (chapter 9).

#include "handle.h"
#include "live.h"
#include "runner.h"

enum { SYSTEM, SCENE, CLOTH, SUBSTEPS };        // dials
enum { STRAIN, TIME };                          // charts
enum { PRINTED, MENDED, ENGINE };
enum { BELOW, ON_TOP, PIN };                    // cube or rope; the cloth; pins from here on
enum { ROPE_PINS = 2, PINS = 4 };               // then two corners of the cloth, in front
static const runner_kind KIND[] = { AS_PRINTED, BY_PLAIN, BY_ENGINE };
static const real PULL = 20, REACH = 0.2;       // 1/s; m, what comes along
static const real ROPE_RADIUS = 0.03, PIN_RADIUS = 0.05;   // m, as they are drawn

static runner run;
static bool is_ready;
static bool is_pinned[PINS];
static int held = -1, held_particle, frame;
static vec3 held_at;

static scene_kind kind(void)
{
    return live_choice(SCENE) ? SCENE_CLOTH_ON_ROPE : SCENE_CLOTH_ON_CUBE;
}

static int substeps(int usual)
{
    static const real TIMES[] = { 0.5, 1, 2, 4 };
    return int_max(1, (int)(usual * TIMES[live_choice(SUBSTEPS)]));
}

static status begin_system(runner_kind by, scene_options what)
{
    system_options how = runner_options(by);
    how.substeps = substeps(how.substeps);
    if (by == AS_PRINTED) what.diagonal = 1;
    return runner_begin_system(&run, by, kind(), what, how);
}

static status begin_engine(scene_options what)
{
    world_options how = world_scene_options(kind(), what.cloth);
    how.substeps = substeps(world_substeps(&how));
    return runner_begin_world(&run, kind(), what, how);
}

static void begin(void)
{
    if (is_ready) runner_free(&run);
    scene_options what = scene_options_default();
    what.cloth = (int)live_dial(CLOTH);
    runner_kind by = KIND[live_choice(SYSTEM)];
    status done = by == BY_ENGINE ? begin_engine(what) : begin_system(by, what);
    is_ready = done.ok;
    held = -1;
    frame = 0;
    for (int k = 0; k < PINS; k++) is_pinned[k] = done.ok && k < run.scene.pins;
    if (!done.ok) live_say("%s", done.why);
}

static const vec3 *places(int b)
{
    return b == BELOW ? run.at : run.at + scene_shape(&run.scene, BELOW)->particles;
}

// --- Hands ------------------------------------------------------------------------
static scene_pin pin(int k)
{
    if (k < ROPE_PINS) return run.scene.pin[k];
    const shape *cloth = scene_shape(&run.scene, ON_TOP);
    return (scene_pin){ ON_TOP, cloth->particles - (k == ROPE_PINS ? 1 : cloth->columns) };
}

static void set_pin(int k, bool holds)
{
    scene_pin p = pin(k);
    is_pinned[k] = holds;
    if (run.kind == BY_ENGINE) {
        if (holds) world_pin(&run.world, p.body, p.particle);
        else       world_unpin(&run.world, p.body, p.particle);
        return;
    }
    particle *at = &run.plain.pool.at[run.plain.body[p.body].first + p.particle];
    at->inverse_mass = holds ? 0 : 1 / scene_shape(&run.scene, p.body)->mass[p.particle];
    at->previous = at->position;
}

static void press(int button)
{
    if (!is_ready) return;
    if (button == 0) {
        for (int k = ROPE_PINS; k < PINS; k++) set_pin(k, true);
        return;
    }
    for (int k = PINS - 1; k >= 0; k--)
        if (is_pinned[k]) {
            set_pin(k, false);
            return;
        }
}

// A pin that is touched is cut.
static void tap(int number, vec3 along)
{
    (void)along;
    if (number >= PIN) set_pin(number - PIN, false);
}

static void move(int number, vec3 to)
{
    if (!is_ready || number >= PIN) return;
    held_at = to;
    if (held == number) return;
    held = number;
    held_particle = 0;
    const vec3 *at = places(held);
    for (int i = 1; i < scene_shape(&run.scene, held)->particles; i++)
        if (vec3_distance(at[i], to) < vec3_distance(at[held_particle], to)) held_particle = i;
}

static void release(int number)
{
    (void)number;
    held = -1;
}

// Makes one vertex of the held body faster by dv.
static void hurry(int i, vec3 dv)
{
    if (run.kind == BY_ENGINE) {
        world_push_particle(&run.world, held, i, vec3_scale(scene_shape(&run.scene, held)->mass[i], dv));
        return;
    }
    particle *p = &run.plain.pool.at[run.plain.body[held].first + i];
    real h = run.plain.options.dt / run.plain.options.substeps;
    if (p->inverse_mass > 0) p->previous = vec3_add_scaled(p->previous, -h, dv);
}

// A hand takes what is near the vertex, too: one alone weighs a gram.
static void pull_held(void)
{
    const vec3 *at = places(held);
    vec3 centre = at[held_particle], way = vec3_sub(held_at, centre);
    for (int i = 0; i < scene_shape(&run.scene, held)->particles; i++)
        if (vec3_distance(at[i], centre) < REACH) hurry(i, vec3_scale(PULL, way));
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!is_ready) return;
    if (held >= 0) pull_held();
    runner_step(&run);
    frame++;
}

// m, how far all of the cloth is below the floor, where it is not seen; 0: it is seen.
static real lost(void)
{
    real top = -HUGE_VAL;
    for (int i = 0; i < scene_shape(&run.scene, ON_TOP)->particles; i++) top = real_max(top, places(ON_TOP)[i].y);
    return real_max(0, -top);
}

static void measure(void)
{
    if (!is_ready || frame % 4) return;
    poses p = runner_poses(&run);
    live_value(STRAIN, 0, 100 * p.strain);
    if (!p.finite) live_say("The cloth has flown off: its numbers are lost.");
    else if (lost() > 0) live_say("The cloth has gone through: it is %.0f m below the floor, its worst stick wrong by %.1f %%.", lost(), 100 * p.strain);
    else if (p.particles_in > 0) live_say("%d particles of the cloth stand in the cube.", p.particles_in);
    else live_say("The worst stick is wrong by %.1f %%.", 100 * p.strain);
}

static void draw_pins(void)
{
    for (int k = 0; k < PINS; k++)
        if (is_pinned[k]) live_ball(PIN + k, LIVE_INK, places(pin(k).body)[pin(k).particle], PIN_RADIUS);
}

static void draw(void)
{
    if (!is_ready) return;
    const shape *below = scene_shape(&run.scene, BELOW), *cloth = scene_shape(&run.scene, ON_TOP);
    if (below->kind == SHAPE_ROPE) live_rope(BELOW, LIVE_ORANGE, places(BELOW), below->particles, ROPE_RADIUS);
    else live_mesh(-1, LIVE_GREY, places(BELOW), below->particles, below->face, below->mesh.faces, false);
    live_cloth(ON_TOP, LIVE_BLUE, places(ON_TOP), cloth->particles, cloth->face, cloth->mesh.faces);
    draw_pins();
}

static unsigned long long hash(void)
{
    return is_ready ? runner_hash(&run) : 0;
}

const live_figure figure = {
    .name = "drape",
    .says = "A cloth falls on a cube, or on a rope that hangs from two pins",
    .camera = { .distance = 3.7, .turn = 0.55, .rise = 0.36, .target = { 0, 0.62, 0 }, .has_floor = true },
    .dial = {
        [SYSTEM] = { "system", NULL, 0, 2, 1, MENDED, "as printed|as mended|engine", true },
        [SCENE] = { "on", NULL, 0, 1, 1, 0, "a cube|a rope", true },
        [CLOTH] = { "particles a side", NULL, 10, 40, 1, 32, NULL, true },
        [SUBSTEPS] = { "substeps", NULL, 0, 3, 1, 1, "half|usual|double|4 ×", true },
    },
    .button = { "Pin two corners", "Cut a pin" },
    .chart = {
        [STRAIN] = { "largest strain", "%", { NULL }, 0.1, 10, true, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = tap, .move = move, .release = release,
};
