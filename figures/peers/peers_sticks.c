// peers_sticks.c - what needs no peer: a rope; and the cloth, which no other C
// library has, beside what was measured elsewhere.

#include "hard_set.h"
#include "line.h"
#include "world_scene.h"
#include "step.h"
#include "peers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROUNDS = 15 };

// ---- A rope ----------------------------------------------------------------

// It hangs from one end, 1 m long; each particle weighs 1 kg.
enum { LINKS = 50, FRAMES = 300, NEWTONS = 3, TEN = 10 };

static shape hanging;
static line_scratch *scratch;
static particle rope[2][LINKS + 1];     // solved, and swept

static void hang(int which)
{
    for (int i = 0; i <= LINKS; i++) {
        vec3 x = { 0, -(real)i / LINKS, 0 };
        rope[which][i] = (particle){ x, x, i > 0 };
    }
}

static void fall(int which)
{
    const vec3 gravity = { 0, -9.81, 0 };
    verlet_step(rope[which], LINKS + 1, gravity, NULL, 1.0 / 60);
}

static void fall_solved(int piece) { (void)piece; fall(0); }
static void fall_swept(int piece) { (void)piece; fall(1); }

static relax_options along_new(void)
{
    relax_options o = relax_options_pbd();
    o.tolerance = 0;
    return o;
}

static void solve(int piece)
{
    (void)piece;
    line_solve(shape_strands(&hanging, 0), rope[0], NEWTONS, along_new(), scratch);
}

static void sweep(int piece)
{
    (void)piece;
    for (int k = 0; k < TEN; k++)
        sticks_iterate(hanging.stick, LINKS, rope[1], along_new());
}

static real rope_strain(int which)
{
    real worst = 0;
    for (int k = 0; k < LINKS; k++)
        worst = fmax(worst, stick_strain(hanging.stick[k], rope[which]));
    return worst;
}

static void measure_rope(void)
{
    const way ways[2] = { { fall_solved, solve }, { fall_swept, sweep } };
    if (!shape_rope(&hanging, LINKS, 1, LINKS + 1).ok)
        give_up("there is no memory for the rope");
    scratch = line_scratch_new(&hanging);
    if (!scratch) give_up("there is no memory for the rope");
    hang(0);
    hang(1);
    real *time = time_in_turn(ways, 2, FRAMES, 5);
    row r = { .what = "hanging rope of 50 links, 3 Newton steps",
              .against = "ours, 10 sweeps", .unit = "us", .ratio = 1,
              .ours = 1e6 * time_sum(time, FRAMES, 0) / FRAMES,
              .theirs = 1e6 * time_sum(time, FRAMES, 1) / FRAMES };
    real strain = rope_strain(0);
    r.is_wrong = !(strain <= 1e-8);
    snprintf(r.our_error, TEXT, "strain %.0e", strain);
    snprintf(r.their_error, TEXT, "strain %.2g", rope_strain(1));
    table_add(r);
    free(time);
    line_scratch_free(scratch);
    shape_free(&hanging);
}

// ---- A cloth ---------------------------------------------------------------

static world_scene cloth;

static void cloth_start(int frame)
{
    if (frame > 0) return;
    world_scene_free(&cloth);
    status done = world_scene_build(&cloth, SCENE_CLOTH_ON_CUBE,
                              scene_options_default(),
                              world_scene_options(SCENE_CLOTH_ON_CUBE, 40));
    if (!done.ok) give_up(done.why);
}

static void cloth_step(int frame)
{
    (void)frame;
    world_step(&cloth.world);
}

// Others' times and errors come from elsewhere (the chapter says whence): the
// same scene without self-collision.  Crossings are pairs of triangles.
static void add_cloth(real ms, real most, real end)
{
    static const struct { const char *name, *error; real ms; } peer[3] = {
        { "Bullet, no self-collision", "strain 29 %; 550 crossings", 0.75 },
        { "Jolt, the same", "strain 30 %; 64 crossings", 0.68 },
        { "PositionBasedDynamics, the same",
          "strain 6.2 %; 267 crossings", 0.85 },
    };
    for (int k = 0; k < 3; k++) {
        row r = { .what = "cloth of 40 x 40 on the cube, a step",
                  .against = peer[k].name, .unit = "ms", .ours = ms,
                  .theirs = peer[k].ms, .is_quoted = 1,
                  .most = k == 0 ? 1.2 : 0 };
        snprintf(r.our_error, TEXT, "strain %.2g %%, in the end %.2g %%",
                 100 * most, 100 * end);
        snprintf(r.their_error, TEXT, "%s", peer[k].error);
        r.is_wrong = !(most <= 0.013) || !(end <= 0.003);
        table_add(r);
    }
}

static void measure_cloth(void)
{
    const way ways[1] = { { cloth_start, cloth_step } };
    real most = 0, end = 0;
    cloth_start(0);
    for (int f = 0; f < FRAMES; f++) {
        world_step(&cloth.world);
        end = world_measure(&cloth.world).strain;
        most = fmax(most, end);
    }
    real *time = time_in_turn(ways, 1, FRAMES, 3);
    add_cloth(1e3 * time_sum(time, FRAMES, 0) / FRAMES, most, end);
    free(time);
    world_scene_free(&cloth);
}

void peers_sticks(void)
{
    measure_rope();
    measure_cloth();
}
