// 20-scenes.c - hard cases 21, 24 and 26: a bullet into a cloth, the paper's
// two cloths, and its room with more bodies than it had.  20-scenes FILE.png
//
// Prints, and writes on each, what was measured meanwhile.

#include "film.h"
#include "hard_set.h"
#include "step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 1880, HIGH = 1400, LAMPS = 5, BODIES = 400, CLOTH = 40,
       SECONDS = 5, MOMENTS = 3 };

// Where a panel lies in the picture.
typedef struct {
    int left, top, width, height;
} box;

// `low` points below the upper edge: the second line.
static void write_on(picture *out, box at, const char *title, int low,
                     const char *second)
{
    const colour ink = colour_hex(0x30353c), pale = colour_hex(0x5a616b);
    picture_text(out, at.left + 22, at.top + 42, 20, ink, title);
    picture_text(out, at.left + 22, at.top + low, 15, pale, second);
}

// ---- 24 and 26: the scenes -------------------------------------------------

// The worst of all frames.
static measures run_scene(world_scene *s, int seconds)
{
    measures worst = { .strain = 0 };
    int frames = (int)(seconds / s->world.options.dt + 0.5);
    for (int f = 0; f < frames; f++) {
        world_step(&s->world);
        measures now = world_measure(&s->world);
        worst.strain = fmax(worst.strain, now.strain);
        worst.penetration = fmax(worst.penetration, now.penetration);
    }
    return worst;
}

static status show_scene(scene_kind kind, box at, const char *title,
                         picture *out)
{
    world_scene s;
    scene_options what = scene_options_default();
    what.bodies = BODIES;
    what.cloth = CLOTH;
    status done = world_scene_build(&s, kind, what, world_scene_options(kind, CLOTH));
    if (!done.ok) return done;
    char below[100];
    measures m = run_scene(&s, SECONDS);
    if (kind == SCENE_ROOM)
        snprintf(below, sizeof below, "%d s: never deeper than %.1f mm",
                 SECONDS, 1e3 * m.penetration);
    else
        snprintf(below, sizeof below, "%d s: strain never over %.2f %%",
                 SECONDS, 100 * m.strain);
    printf("%s: %s, penetration %.2g m, strain %.2g\n", title, below,
           m.penetration, m.strain);
    done = film_paint(&s, LAMPS, out, at.left, at.top, at.width, at.height);
    write_on(out, at, title, kind == SCENE_ROOM ? at.height - 22 : 72, below);
    world_scene_free(&s);
    return done;
}

// ---- 21: a bullet ----------------------------------------------------------

enum { CELLS = 20 };
static const real SPEED = 50;       // m/s

static void build_shot(setting *s)
{
    world_options o = weightless(best(4));
    setting_start(s, o);
    shape *cloth = &s->plan[s->plans++];
    if (s->ok.ok)
        s->ok = shape_cloth(cloth, CELLS + 1, CELLS + 1, 1, 1, 0.2, 0.2);
    add_body(s, cloth, placement_at(vec3_make(0, 0, 0)));
    for (int k = 0; k < 4 && s->ok.ok; k++)
        world_pin(&s->w, 0, (k & 1 ? CELLS : 0)
                             + (k & 2 ? CELLS * (CELLS + 1) : 0));
    shape *bullet = &s->plan[s->plans++];
    if (s->ok.ok) s->ok = shape_icosahedron(bullet, 0.05, 0.5);
    placement p = placement_at(vec3_make(0.06, 2.0, 0.04));
    p.velocity = vec3_make(0, -SPEED, 0);
    add_body(s, bullet, p);
}

// Squares of five by five cells, in two tints.
static void check(const shape *cloth, real *tint)
{
    for (int f = 0; f < cloth->mesh.faces; f++)
        tint[f] = (f / 2 % CELLS / 5 + f / 2 / CELLS / 5) % 2;
}

static status add_to(painter *p, const world *w, int b, const unsigned tone[2])
{
    static real tint[2 * CELLS * CELLS];
    const shape *plan = w->body[b].shape;
    vec3 *at = malloc((size_t)plan->particles * sizeof *at);
    if (!at) return status_out_of_memory();
    const colour c[2] = { colour_hex(tone[0]), colour_hex(tone[1]) };
    int soft = plan->kind == SHAPE_CLOTH;
    if (soft) check(plan, tint);
    world_vertices(w, &w->body[b], at);
    painted_mesh m = { .vertices = plan->particles, .at = at,
                       .faces = plan->mesh.faces, .face = plan->face,
                       .front = { c[0], c[1] }, .back = { c[0], c[1] },
                       .tint = soft ? tint : NULL, .casts = 1,
                       .smooth = soft, .creases = !soft, .gloss = 0.2 };
    status done = painter_mesh(p, &m);
    free(at);
    return done;
}

static status paint_shot(const world *w, box at, picture *out)
{
    const unsigned cloth[2] = { 0x56b4e9, 0x8fcdf0 };
    const unsigned bullet[2] = { 0xd55e00, 0xd55e00 };
    painter p;
    painter_init(&p);
    p.lamps = LAMPS;
    painter_look(&p, vec3_make(0.8, 0.9, 2.6), vec3_make(0, 0.13, 0), 23);
    p.lamp = vec3_unit(vec3_make(-0.6, 1, 0.3));
    status done = add_to(&p, w, 0, cloth);
    if (done.ok) done = add_to(&p, w, 1, bullet);
    if (done.ok)
        done = painter_paint(&p, out, at.left, at.top, at.width, at.height);
    painter_free(&p);
    return done;
}

static status shoot(picture *out)
{
    static const int frame[MOMENTS] = { 2, 3, 6 };
    setting s;
    build_shot(&s);
    status done = setting_begin(&s);
    for (int k = 0, f = 0; k < MOMENTS && done.ok; k++) {
        box at = { k * 629, 1000, k < 2 ? 621 : 622, 400 };
        char below[80];
        for (; f < frame[k]; f++) world_step(&s.w);
        vec3 x = middle(&s.w, 1);
        snprintf(below, sizeof below, "frame %d: bullet at %.2f m", f, x.y);
        printf("21: %s\n", below);
        done = paint_shot(&s.w, at, out);
        write_on(out, at, k == 0 ? "21. Half a kilogram, 50 m/s, into 200 g" : "", 72, below);
    }
    setting_free(&s);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 20-scenes FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, WIDE, HIGH, colour_hex(0xffffff));
    if (done.ok) done = shoot(&p);
    if (done.ok)
        done = show_scene(SCENE_ROOM, (box){ 0, 0, 1100, 992 },
                          "26. 400 icosahedra", &p);
    if (done.ok)
        done = show_scene(SCENE_CLOTH_ON_CUBE, (box){ 1108, 0, 772, 492 },
                          "24. a cloth on a cube", &p);
    if (done.ok)
        done = show_scene(SCENE_CLOTH_ON_ROPE, (box){ 1108, 500, 772, 492 },
                          "24. a cloth on a rope", &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "20-scenes: %s\n", done.why);
    return done.ok ? 0 : 1;
}
