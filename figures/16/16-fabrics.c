// 16-fabrics.c - silk, denim and card over the same cube.  16-fabrics FILE.png
//
// Prints what each weighs, how stiff it is, how it gives, and how far down it
// hangs.

#include "film.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

enum { PANELS = 3, WIDE = 560, HIGH = 520, GAP = 10, LAMPS = 5, SIDE = 48,
       SECONDS = 4 };
static const real WIDTH = 0.42, CUBE = 0.14;     // m

typedef struct {
    const char *name;
    real weight;        // kg/m^2
    real stiffness;     // N m
    real compliance;    // m/N
    unsigned tone[2];
} fabric;

static const fabric FABRIC[PANELS] = {
    { "silk",  0.06, 5e-6,   5e-5, { 0xcc79a7, 0xe3aecb } },
    { "denim", 0.40, 1e-4,   1e-4, { 0x0072b2, 0x5ba4d4 } },
    { "card",  0.30, 1.6e-2, 8e-7, { 0xe6c17a, 0xf2dcae } },
};

static status paint_body(painter *p, const world *w, int b, colour front,
                         colour back)
{
    const shape *plan = w->body[b].shape;
    vec3 *at = malloc((size_t)plan->particles * sizeof *at);
    if (!at) return status_out_of_memory();
    bool is_soft = plan->kind == SHAPE_CLOTH;
    world_vertices(w, &w->body[b], at);
    painted_mesh m = { .vertices = plan->particles, .at = at,
                       .faces = plan->mesh.faces, .face = plan->face,
                       .front = { front, front }, .back = { back, back },
                       .casts = 1, .smooth = is_soft, .creases = !is_soft,
                       .gloss = 0.2 };
    status done = painter_mesh(p, &m);
    free(at);
    return done;
}

static status paint(const world *w, const fabric *f, int left, picture *out)
{
    painter p;
    painter_init(&p);
    p.lamps = LAMPS;
    painter_look(&p, vec3_make(0.62, 0.46, 0.8), vec3_make(0, -0.02, 0), 29);
    p.lamp = vec3_unit(vec3_make(-0.6, 1, 0.4));
    status done = paint_body(&p, w, 0, colour_hex(0xb8bcc2),
                             colour_hex(0xb8bcc2));
    if (done.ok)
        done = paint_body(&p, w, 1, colour_hex(f->tone[0]),
                          colour_hex(f->tone[1]));
    if (done.ok) done = painter_paint(&p, out, left, 0, WIDE, HIGH);
    painter_free(&p);
    return done;
}

// A square of cloth falls on a cube that stands fast, its corners first.
static status drape(world *w, const shape *cube, const shape *cloth,
                    const fabric *f)
{
    world_options o = world_scene_options(SCENE_CLOTH_ON_CUBE, SIDE);
    o.friction = 0.8;
    status done = world_init(w, o);
    placement fixed = placement_at(vec3_make(0, 0, 0));
    fixed.is_static = true;
    if (done.ok) done = world_add(w, cube, fixed, NULL);
    placement over = placement_at(vec3_make(0, CUBE / 2 + 0.03, 0));
    real c = cos(0.35), s = sin(0.35);
    over.x = vec3_make(c, 0, -s);
    over.z = vec3_make(s, 0, c);
    if (done.ok) done = world_add(w, cloth, over, NULL);
    if (done.ok) done = world_bend(w, 1, f->stiffness);
    if (done.ok) done = world_stretch(w, 1, f->compliance);
    for (int k = 0; k < SECONDS * 60 && done.ok; k++) world_step(w);
    return done;
}

static status show(int k, picture *out)
{
    const fabric *f = &FABRIC[k];
    shape cube = { .particles = 0 }, cloth = { .particles = 0 };
    world w = { .bodies = 0 };
    status done = shape_box(&cube, vec3_make(CUBE, CUBE, CUBE), 1);
    if (done.ok)
        done = shape_cloth(&cloth, SIDE, SIDE, WIDTH, WIDTH,
                           f->weight * WIDTH * WIDTH, 0.2);
    if (done.ok) done = drape(&w, &cube, &cloth, f);
    int left = k * (WIDE + GAP);
    if (done.ok) done = paint(&w, f, left, out);
    if (done.ok) {
        vec3 low = { 0, 0, 0 };
        for (int i = 0; i < cloth.particles; i++) {
            vec3 x = w.pool.at[w.body[1].first + i].position;
            if (x.y < low.y) low = x;
        }
        printf("%s: %g kg/m^2, %g N m, %g m/N, hangs %.3f m below the cube's "
               "middle\n", f->name, f->weight, f->stiffness, f->compliance,
               -low.y);
        picture_text(out, left + 22, 42, 24, colour_hex(0x30353c), f->name);
    }
    world_free(&w);
    shape_free(&cloth);
    shape_free(&cube);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 16-fabrics FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, PANELS * (WIDE + GAP) - GAP, HIGH,
                               colour_hex(0xffffff));
    for (int k = 0; k < PANELS && done.ok; k++) done = show(k, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "16-fabrics: %s\n", done.why);
    return done.ok ? 0 : 1;
}
