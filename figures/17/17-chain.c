// 17-chain.c - a chain of twenty boxes with a load of a hundred times one of
// them, thrown from the horizontal: its joints solved one after the other, and
// as a tree.  17-chain FILE.png
//
// Prints how far the points of a joint are apart at most.

#include "join.h"
#include "painter.h"
#include "step.h"

#include <stdio.h>

enum { LINKS = 20, BODIES = LINKS + 1, CORNERS = 8, WAYS = 2, WIDTH = 780,
       HEIGHT = 620, GAP = 6 };

static const real SECONDS = 1.05;       // when they are painted

static const char *const name[WAYS] = { "joint by joint", "this chapter" };

static shape link_shape, load_shape;

static status add_bodies(world *w)
{
    status done = status_ok();
    for (int k = 0; k < BODIES && done.ok; k++) {
        vec3 at = { k < LINKS ? 0.2 * k + 0.1 : 0.2 * LINKS + 0.25, 0, 0 };
        done = world_add(w, k < LINKS ? &link_shape : &load_shape,
                         placement_at(at), NULL);
    }
    for (int k = 0; k < BODIES && done.ok; k++)
        done = world_join(w, (joint_plan){ .kind = JOINT_BALL, .a = k - 1,
                             .b = k, .point = { 0.2 * k, 0, 0 } }, NULL);
    return done;
}

static status run(world *w, int way)
{
    world_options o = world_options_default();
    o.sleep_speed = 0;
    status done = world_init(w, o);
    if (done.ok) done = add_bodies(w);
    w->joints.is_plain = way == 0;
    real worst = 0;
    for (int n = 0; n < (int)(60 * SECONDS) && done.ok; n++) {
        world_step(w);
        worst = real_max(worst, w->report.parted);
    }
    printf("# %s: a joint came apart by %.3g mm\n", name[way], 1e3 * worst);
    return done;
}

static status add_body(painter *p, const world *w, int b)
{
    vec3 at[CORNERS];
    const shape *s = w->body[b].shape;
    colour tone = b < LINKS ? colour_hex(b % 2 ? 0x0072b2 : 0x56b4e9)
                            : colour_hex(0xe69f00);
    world_vertices(w, &w->body[b], at);
    painted_mesh m = { .vertices = CORNERS, .at = at,
        .faces = s->mesh.faces, .face = s->face,
        .front = { tone, tone }, .back = { tone, tone },
        .creases = 1, .casts = 1, .gloss = 0.1 };
    return painter_mesh(p, &m);
}

static status paint(const world *w, picture *out, int left)
{
    painter p;
    status done = status_ok();
    painter_init(&p);
    painter_look(&p, vec3_make(0.4, -1, 11), vec3_make(0.4, -2.4, 0), 32);
    p.lamps = 5;
    painter_floor(&p, vec3_make(0, -5.3, 0), 26, 1);
    for (int b = 0; b < BODIES && done.ok; b++) done = add_body(&p, w, b);
    if (done.ok) done = painter_paint(&p, out, left, 0, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

static status paint_way(picture *out, int way)
{
    static world w;
    status done = run(&w, way);
    int left = way * (WIDTH + GAP);
    if (done.ok) done = paint(&w, out, left);
    picture_text(out, left + 20, 36, 19, colour_hex(0x4a525d), name[way]);
    world_free(&w);
    return done;
}

int main(int arguments, char **argument)
{
    picture out;
    if (arguments != 2) {
        fprintf(stderr, "usage: 17-chain FILE.png\n");
        return 2;
    }
    status done = picture_init(&out, WAYS * (WIDTH + GAP) - GAP, HEIGHT,
                               colour_hex(0xffffff));
    if (done.ok) done = shape_box(&link_shape, vec3_make(0.14, 0.1, 0.1), 1);
    if (done.ok) done = shape_box(&load_shape, vec3_make(0.5, 0.5, 0.5), 100);
    for (int k = 0; k < WAYS && done.ok; k++) done = paint_way(&out, k);
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    shape_free(&link_shape);
    shape_free(&load_shape);
    if (!done.ok) fprintf(stderr, "17-chain: %s\n", done.why);
    return done.ok ? 0 : 1;
}
