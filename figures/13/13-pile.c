// 13-pile.c - ten cubes, one on the other, the highest of them twenty times as
// heavy as the others, that may not sleep: by the paper's system as mended, and
// by the engine.  13-pile FILE.png
//
// Prints how high the highest cube lies at each moment, and how far the cubes
// have drifted.

#include "painter.h"
#include "step.h"
#include "system.h"
#include "world_scene.h"

#include <stdio.h>

enum { CUBES = 10, CORNERS = 8, PILES = 2, MOMENTS = 2, WIDTH = 560,
       HEIGHT = 560, GAP = 6 };

// s, when they are looked at.
static const real moment[MOMENTS] = { 1, 20 };

static const char *const name[PILES] = {
    "chapter 09", "this chapter"
};

// A pile, and what moves it: the paper's system, or the engine.
typedef struct {
    scene  scene;
    bool   by_engine;
    world  world;
    particle_system plain;
    real   time;                        // s
    vec3   at[CUBES][CORNERS];          // m, where the corners are
} pile;

static void look(pile *p)
{
    for (int b = 0; b < CUBES; b++) {
        if (p->by_engine) {
            world_vertices(&p->world, &p->world.body[b], p->at[b]);
            continue;
        }
        const particle *x = &p->plain.pool.at[p->plain.body[b].first];
        for (int i = 0; i < CORNERS; i++) p->at[b][i] = x[i].position;
    }
}

static status add_shape(scene *s, real mass)
{
    shape cube;
    status done = shape_box(&cube, vec3_make(1, 1, 1), mass);
    return done.ok ? scene_add_shape(s, &cube) : done;
}

// Cubes of 1 m on y = 0, as far apart as they are kept: `margin` (m) each.
static status build_scene(scene *s, real margin)
{
    scene_init(s);
    status done = add_shape(s, 1);
    if (done.ok) done = add_shape(s, 20);
    if (done.ok) done = scene_add_plane(s, vec3_make(0, 1, 0), 0);
    for (int b = 0; b < CUBES && done.ok; b++) {
        vec3 at = { 0, 0.5 + b + margin * (1 + 2 * b), 0 };
        done = scene_add(s, b == CUBES - 1, placement_at(at));
    }
    return done;
}

static status build(pile *p, int which)
{
    world_options engine = world_options_default();
    system_options plain = system_options_mended();
    *p = (pile){ .by_engine = which == PILES - 1 };
    engine.sleep_speed = 0;
    status done = build_scene(&p->scene, p->by_engine ? 0 : plain.margin / 2);
    if (done.ok)
        done = p->by_engine ? world_of_scene(&p->world, &p->scene, engine)
                            : system_init(&p->plain, &p->scene, plain);
    if (done.ok) look(p);
    return done;
}

static void pile_free(pile *p)
{
    world_free(&p->world);
    system_free(&p->plain);
    scene_free(&p->scene);
}

static void step(pile *p)
{
    if (p->by_engine) world_step(&p->world);
    else              system_step(&p->plain);
    p->time += 1.0 / 60;
    look(p);
}

static status add_cube(painter *p, const pile *x, int b)
{
    const shape *cube = scene_shape(&x->scene, b);
    colour tone = colour_mix(colour_hex(0x0072b2), colour_hex(0xe69f00),
                             b / (real)(CUBES - 1));
    painted_mesh m = { .vertices = CORNERS, .at = x->at[b],
        .faces = cube->mesh.faces, .face = cube->face,
        .front = { tone, tone }, .back = { tone, tone },
        .creases = 1, .casts = 1, .gloss = 0.1 };
    return painter_mesh(p, &m);
}

static status paint(const pile *x, picture *out, int left, int top)
{
    painter p;
    status done = status_ok();
    painter_init(&p);
    painter_look(&p, vec3_make(9, 8, 25), vec3_make(0, 4.7, 0), 28.5);
    p.lamps = 5;
    painter_floor(&p, vec3_make(0, 0, 0), 26, 1);
    for (int b = 0; b < CUBES && done.ok; b++) done = add_cube(&p, x, b);
    if (done.ok) done = painter_paint(&p, out, left, top, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

static void label(picture *out, int left, int top, int which, int k)
{
    const colour ink = colour_hex(0x4a525d);
    char text[40];
    if (k == 0) picture_text(out, left + 20, top + 36, 19, ink, name[which]);
    snprintf(text, sizeof text, "%g s", moment[k]);
    picture_text(out, left + WIDTH - 20 - picture_text(NULL, 0, 0, 16, ink,
                 text), top + 36, 16, ink, text);
}

static vec3 middle(const pile *p, int b)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < CORNERS; i++)
        sum = vec3_add_scaled(sum, 1.0 / CORNERS, p->at[b][i]);
    return sum;
}

static void print_pile(const pile *p, int which)
{
    real high = 0, drift = 0;
    for (int b = 0; b < CUBES; b++) {
        vec3 m = middle(p, b);
        high = fmax(high, m.y);
        drift = fmax(drift, vec3_distance(m, p->scene.body[b].where.position));
    }
    printf("# %s, %g s: the highest cube's middle is at %.3f m; the furthest "
           "went %.4f m\n", name[which], p->time, high, drift);
}

static status paint_pile(picture *out, int which)
{
    static pile p;
    status done = build(&p, which);
    for (int k = 0; k < MOMENTS && done.ok; k++) {
        int left = which * (WIDTH + GAP), top = k * (HEIGHT + GAP);
        while (p.time < moment[k] - 1e-9) step(&p);
        print_pile(&p, which);
        done = paint(&p, out, left, top);
        label(out, left, top, which, k);
    }
    pile_free(&p);
    return done;
}

int main(int arguments, char **argument)
{
    picture out;
    if (arguments != 2) {
        fprintf(stderr, "usage: 13-pile FILE.png\n");
        return 2;
    }
    status done = picture_init(&out, PILES * (WIDTH + GAP) - GAP,
                               MOMENTS * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    for (int k = 0; k < PILES && done.ok; k++) done = paint_pile(&out, k);
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    if (!done.ok) fprintf(stderr, "13-pile: %s\n", done.why);
    return done.ok ? 0 : 1;
}
