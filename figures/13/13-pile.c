// 13-pile.c - ten cubes, one on the other, that may not sleep: with contacts
// that begin each frame at nothing, and with warm starting.
// 13-pile FILE.png
//
// Prints how high the highest cube lies at each moment.

#include "measure.h"
#include "painter.h"
#include "step.h"

#include <stdio.h>

enum { CUBES = 10, PILES = 2, MOMENTS = 2, WIDTH = 560, HEIGHT = 560, GAP = 6 };

// s, when they are looked at.
static const real moment[MOMENTS] = { 1, 10 };

static const char *const name[PILES] = {
    "contacts that forget", "warm-started contacts"
};

static status build(world *w, const shape *cube, world_options how)
{
    real skin = how.skin * cube->radius;
    how.resting = 0;
    status done = world_init(w, how);
    if (done.ok) done = world_add_plane(w, vec3_make(0, 1, 0), 0);
    for (int b = 0; b < CUBES && done.ok; b++) {
        vec3 at = { 0, 0.5 + b + skin * (1 + 2 * b), 0 };
        done = world_add(w, cube, placement_at(at), NULL);
    }
    return done.ok ? world_begin(w) : done;
}

static status add_cube(painter *p, const world *w, int b)
{
    enum { CORNERS = 8 };
    vec3 at[CORNERS];
    const body *x = &w->body[b];
    colour tone = colour_mix(colour_hex(0x0072b2), colour_hex(0xe69f00),
                             b / (real)(CUBES - 1));
    world_vertices(w, x, at);
    painted_mesh m = { .vertices = CORNERS, .at = at,
        .faces = x->plan->mesh.faces, .face = x->plan->face,
        .front = { tone, tone }, .back = { tone, tone },
        .creases = 1, .casts = 1, .gloss = 0.1 };
    return painter_mesh(p, &m);
}

static status paint(const world *w, picture *out, int left, int top)
{
    painter p;
    status done = status_ok();
    painter_init(&p);
    painter_look(&p, vec3_make(9, 8, 25), vec3_make(0, 4.7, 0), 28.5);
    p.lamps = 5;
    painter_floor(&p, vec3_make(0, 0, 0), 26, 1);
    for (int b = 0; b < CUBES && done.ok; b++) done = add_cube(&p, w, b);
    if (done.ok) done = painter_paint(&p, out, left, top, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

static void label(picture *out, int left, int top, int pile, int k)
{
    const colour ink = colour_hex(0x4a525d);
    char text[40];
    if (k == 0) picture_text(out, left + 20, top + 36, 19, ink, name[pile]);
    snprintf(text, sizeof text, "%g s", moment[k]);
    picture_text(out, left + WIDTH - 20 - picture_text(NULL, 0, 0, 16, ink,
                 text), top + 36, 16, ink, text);
}

static real height(const world *w)
{
    real high = 0;
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        real sum = 0;
        int n = body_particles(x);
        for (int i = 0; i < n; i++)
            sum += w->pool.at[x->first + i].position.y / n;
        high = fmax(high, sum);
    }
    return high;
}

static status paint_pile(picture *out, const shape *cube, int pile,
                         world_options how)
{
    world w;
    status done = build(&w, cube, how);
    for (int k = 0; k < MOMENTS && done.ok; k++) {
        int left = pile * (WIDTH + GAP), top = k * (HEIGHT + GAP);
        while (w.time < moment[k] - 1e-9) world_step(&w);
        printf("# %s, %g s: the highest cube's middle is at %.2f m\n",
               name[pile], moment[k], height(&w));
        done = paint(&w, out, left, top);
        label(out, left, top, pile, k);
    }
    world_free(&w);
    return done;
}

int main(int arguments, char **argument)
{
    world_options how[PILES] = {
        world_options_default(), world_options_default()
    };
    how[0].memory = 0;
    shape cube;
    picture out;
    if (arguments != 2) {
        fprintf(stderr, "usage: 13-pile FILE.png\n");
        return 2;
    }
    status done = shape_box(&cube, vec3_make(1, 1, 1), 1);
    if (done.ok) done = picture_init(&out, PILES * (WIDTH + GAP) - GAP,
                                     MOMENTS * (HEIGHT + GAP) - GAP,
                                     colour_hex(0xffffff));
    for (int k = 0; k < PILES && done.ok; k++)
        done = paint_pile(&out, &cube, k, how[k]);
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    shape_free(&cube);
    if (!done.ok) fprintf(stderr, "13-pile: %s\n", done.why);
    return done.ok ? 0 : 1;
}
