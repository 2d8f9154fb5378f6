// room.c - icosahedra thrown into a room: as printed, as mended, and under the
// engine of Part II (chapter 9).

#include "handle.h"
#include "live.h"
#include "runner.h"

enum { SYSTEM, BODIES, SUBSTEPS, FRICTION };    // dials
enum { OVERLAP, TIME };                         // charts
enum { PRINTED, MENDED, ENGINE };
static const runner_kind KIND[] = { AS_PRINTED, BY_PLAIN, BY_ENGINE };
static const live_colour COLOUR[] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREY, LIVE_GREEN, LIVE_RED, LIVE_PURPLE };

static runner run;
static bool is_ready;
static int frame;

static status begin_system(scene_options what, real times)
{
    system_options how = runner_options(KIND[live_choice(SYSTEM)]);
    how.substeps = int_max(1, (int)(how.substeps * times));
    how.friction = live_dial(FRICTION);
    return runner_begin_system(&run, KIND[live_choice(SYSTEM)], SCENE_ROOM, what, how);
}

static status begin_engine(scene_options what, real times)
{
    world_options how = world_scene_options(SCENE_ROOM, 0);
    how.substeps = int_max(1, (int)(world_substeps(&how) * times));
    how.friction = live_dial(FRICTION);
    return runner_begin_world(&run, SCENE_ROOM, what, how);
}

static void begin(void)
{
    static const real TIMES[] = { 0.5, 1, 2, 4 };
    if (is_ready) runner_free(&run);
    scene_options what = scene_options_default();
    what.bodies = (int)live_dial(BODIES);
    real times = TIMES[live_choice(SUBSTEPS)];
    bool is_engine = live_choice(SYSTEM) == ENGINE;
    status done = is_engine ? begin_engine(what, times) : begin_system(what, times);
    is_ready = done.ok;
    frame = 0;
    if (!done.ok) live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
// s, between the two positions that a particle of Part I's system stores.
static real substep(void)
{
    return run.plain.options.dt / run.plain.options.substeps;
}

static vec3 velocity_of(int b)
{
    if (run.kind == BY_ENGINE) return world_where(&run.world, b).velocity;
    const system_body *x = &run.plain.body[b];
    vec3 sum = { 0, 0, 0 };
    for (int i = x->first; i < x->first + x->shape->particles; i++)
        sum = vec3_add(sum, vec3_sub(run.plain.pool.at[i].position, run.plain.pool.at[i].previous));
    return vec3_scale(1 / (x->shape->particles * substep()), sum);
}

// Makes a body faster by dv, all of it alike.
static void hurry(int b, vec3 dv)
{
    if (run.kind == BY_ENGINE) {
        world_push(&run.world, b, vec3_scale(run.world.body[b].mass, dv), runner_middle(&run, b));
        return;
    }
    const system_body *x = &run.plain.body[b];
    for (int i = x->first; i < x->first + x->shape->particles; i++) {
        particle *p = &run.plain.pool.at[i];
        p->previous = vec3_add_scaled(p->previous, -substep(), dv);
    }
}

static void pull(int b)
{
    vec3 a = live_pull(runner_middle(&run, b), velocity_of(b));
    hurry(b, vec3_scale(1.0 / 60, a));
}

static void throw_body(int b, vec3 along)
{
    if (is_ready) hurry(b, vec3_add(vec3_scale(7, along), vec3_make(0, 6, 0)));
}

static void press(int button)
{
    static int next;
    (void)button;
    if (is_ready) throw_body(next++ % run.scene.bodies, vec3_make(0, 0.3, 0));
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!is_ready) return;
    if (live_held() >= 0) pull(live_held());
    runner_step(&run);
    frame++;
}

static void measure(void)
{
    if (!is_ready || frame % 4) return;
    poses p = runner_poses(&run);
    live_value(OVERLAP, 0, 100 * real_max(p.overlap, p.behind) / SCENE_BODY_RADIUS);
    if (run.lost > 0) live_say("%d bodies have left all bounds.", run.lost);
}

static void draw_room(real side)
{
    for (int k = 0; k < 8; k++)
        for (int d = 1; d < 8; d *= 2) {
            if (k & d) continue;
            vec3 end[2];
            for (int e = 0; e < 2; e++) {
                int c = e ? k | d : k;
                end[e] = vec3_make((c & 1 ? 0.5 : -0.5) * side, c & 2 ? side : 0, (c & 4 ? 0.5 : -0.5) * side);
            }
            live_edge(LIVE_QUIET, end[0], end[1]);
        }
}

static void draw(void)
{
    if (!is_ready) return;
    draw_room(run.scene.size);
    const vec3 *at = run.at;
    for (int b = 0; b < run.scene.bodies; b++) {
        const shape *s = scene_shape(&run.scene, b);
        live_mesh(b, COLOUR[(b * 7 + b / 4) % 6], at, s->particles, s->face, s->mesh.faces, false);
        at += s->particles;
    }
}

static unsigned long long hash(void)
{
    return is_ready ? runner_hash(&run) : 0;
}

const live_figure figure = {
    .name = "room",
    .says = "Icosahedra thrown into a room",
    .camera = { .distance = 12.5, .turn = 0.62, .rise = 0.42, .target = { 0, 1.75, 0 }, .has_floor = true },
    .dial = {
        [SYSTEM] = { "system", NULL, 0, 2, 1, MENDED, "as printed|as mended|engine", true },
        [BODIES] = { "bodies", NULL, 2, 100, 1, 50, NULL, true },
        [SUBSTEPS] = { "substeps", NULL, 0, 3, 1, 1, "half|usual|double|4 ×", true },
        [FRICTION] = { "friction", NULL, 0, 1, 0.05, 0.5, NULL, true },
    },
    .button = { "Throw one" },
    .chart = {
        [OVERLAP] = { "deepest overlap", "% of a radius", { NULL }, 0.01, 10, true, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = throw_body,
};
