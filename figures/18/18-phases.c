// 18-phases.c - one frame of the engine, phase by phase: six boxes stand in a
// pyramid, and a seventh flies into them.  18-phases FILE.png
//
// What is drawn is what the tables of the world hold when the frame is over:
// balls and ways, pairs, contacts, impulses of the last substep, particles.
// An impulse is drawn 60 m long for each N s, but 1.1 m at most.

#include "painter.h"
#include "step.h"
#include "world_scene.h"

#include <stdio.h>

enum { BOXES = 7, CORNERS = 8, PANELS = 6, COLUMNS = 3, WIDTH = 470, HEIGHT = 470,
       GAP = 6, FLYING = BOXES - 1, FRAMES = 300 };

static const char *const name[PANELS] = {
    "bodies", "pairs", "contacts", "impulses", "positions", "bodies again"
};
static const char *const what[PANELS] = {
    "a ball and a way for each", "whose balls may meet",
    "points, and their normals", "to both sides of a point",
    "four particles each", "the next frame begins"
};

static const unsigned INK = 0x4a525d, PALE = 0xb8bec6, BLUE = 0x0072b2,
    ORANGE = 0xe69f00, RED = 0xd55e00, GREEN = 0x009e73;

typedef struct {
    scene scene;
    world world;
} set;

static status add_boxes(scene *s)
{
    static const real at[BOXES - 1][2] = {
        { -1.15, 0.5 }, { 0, 0.5 }, { 1.15, 0.5 },
        { -0.58, 1.5 }, { 0.58, 1.5 }, { 0, 2.5 }
    };
    status done = status_ok();
    for (int b = 0; b < BOXES - 1 && done.ok; b++)
        done = scene_add(s, 0, placement_at(vec3_make(at[b][0], at[b][1], 0)));
    placement p = placement_at(vec3_make(-2.7, 2.9, 0));
    p.velocity = vec3_make(6, 0.2, 0);
    p.spin = vec3_make(0, 0, -2);
    return done.ok ? scene_add(s, 0, p) : done;
}

static status build(set *s)
{
    shape cube;
    world_options o = world_options_default();
    o.sleep_speed = 0;
    scene_init(&s->scene);
    status done = shape_box(&cube, vec3_make(1, 1, 1), 1);
    if (done.ok) done = scene_add_shape(&s->scene, &cube);
    if (done.ok) done = scene_add_plane(&s->scene, vec3_make(0, 1, 0), 0);
    if (done.ok) done = add_boxes(&s->scene);
    if (done.ok) done = world_of_scene(&s->world, &s->scene, o);
    return done;
}

// Do the flying box and another push each other?
static bool has_struck(const world *w)
{
    const contact_cache *c = &w->rigid.cache;
    for (int k = 0; k < c->actives; k++) {
        const contact *x = c->active[k];
        if (x->b >= 0 && (x->a == FLYING || x->b == FLYING)
            && contact_load(x) > 0) return true;
    }
    return false;
}

// --- strokes -----------------------------------------------------------------

static const real THIN = 0.0045, BOLD = 0.009;

static void stroke(painter *p, vec3 a, vec3 b, real width, unsigned tone)
{
    painter_line(p, a, b, width, colour_hex(tone));
}

static void arrow(painter *p, vec3 from, vec3 way, unsigned tone)
{
    real length = vec3_length(way);
    if (!(length > 0.02)) return;
    vec3 to = vec3_add(from, way);
    vec3 back = vec3_scale(-fmin(0.14, length / 2) / length, way);
    vec3 side = vec3_scale(0.45, vec3_make(-back.y, back.x, 0));
    stroke(p, from, to, BOLD, tone);
    stroke(p, to, vec3_add(to, vec3_add(back, side)), BOLD, tone);
    stroke(p, to, vec3_add(to, vec3_sub(back, side)), BOLD, tone);
}

static void circle(painter *p, vec3 center, real radius, unsigned tone)
{
    enum { PIECES = 64 };
    vec3 last = { 0, 0, 0 };
    for (int k = 0; k <= PIECES; k++) {
        real a = 2 * 3.141592653589793 * k / PIECES;
        vec3 at = vec3_add_scaled(center, radius,
                                  vec3_make(cos(a), sin(a), 0));
        if (k > 0) stroke(p, last, at, THIN, tone);
        last = at;
    }
}

// The edges between corners that differ in one coordinate.
static void edges(painter *p, const shape *cube, const vec3 *at, unsigned tone)
{
    for (int i = 0; i < CORNERS; i++)
        for (int j = i + 1; j < CORNERS; j++)
            if (fabs(vec3_distance(cube->at[i], cube->at[j]) - 1) < 0.1)
                stroke(p, at[i], at[j], THIN, tone);
}

static void box_as_it_began(painter *p, const world *w, int b, unsigned tone)
{
    vec3 at[CORNERS];
    rigid4_ride(w->body[b].rigid, &w->rigid.now[b].frame, at, CORNERS);
    edges(p, w->body[b].shape, at, tone);
}

static const real LONGEST = 1.1;            // m, of an impulse's arrow

// --- the pictures ---------------------------------------------------------

static void draw_bodies(painter *p, const world *w)
{
    for (int b = 0; b < BOXES; b++) {
        const sphere *ball = &w->rigid.ball[b];
        box_as_it_began(p, w, b, INK);
        circle(p, ball->center, ball->radius, BLUE);
        arrow(p, ball->center, vec3_scale(8, w->rigid.ahead[b].delta), ORANGE);
    }
}

static void draw_pairs(painter *p, const world *w)
{
    const pair_list *list = &w->rigid.pairs;
    for (int b = 0; b < BOXES; b++) {
        box_as_it_began(p, w, b, PALE);
        painter_ball(p, w->rigid.ball[b].center, 0.07, colour_hex(BLUE));
    }
    for (int k = 0; k < list->count; k++)
        stroke(p, w->rigid.ball[list->pair[k][0]].center,
               w->rigid.ball[list->pair[k][1]].center, BOLD, BLUE);
}

static void draw_contact(painter *p, const world *w, const contact *x,
                         bool is_solved)
{
    for (int k = 0; k < x->count; k++) {
        const rigid_frame *a = &w->rigid.now[x->a].frame;
        vec3 at = frame_point(a, x->point[k].local_a);
        painter_ball(p, at, 0.05, colour_hex(is_solved ? PALE : GREEN));
        if (!is_solved) {
            arrow(p, at, vec3_scale(0.4, x->normal), GREEN);
            continue;
        }
        vec3 way = vec3_scale(fmin(60 * x->impulse[k], LONGEST), x->normal);
        arrow(p, at, way, RED);
        if (x->b >= 0) arrow(p, at, vec3_scale(-1, way), RED);
    }
}

static void draw_contacts(painter *p, const world *w, bool is_solved)
{
    const contact_cache *c = &w->rigid.cache;
    for (int b = 0; b < BOXES; b++) box_as_it_began(p, w, b, PALE);
    for (int k = 0; k < c->actives; k++)
        draw_contact(p, w, c->active[k], is_solved);
}

static void draw_positions(painter *p, const world *w)
{
    for (int b = 0; b < BOXES; b++) {
        vec3 at[CORNERS];
        const particle *x = w->pool.at + w->body[b].first;
        world_vertices(w, &w->body[b], at);
        edges(p, w->body[b].shape, at, INK);
        for (int i = 0; i < FOUR; i++) {
            painter_ball(p, x[i].position, 0.07, colour_hex(ORANGE));
            for (int k = 0; k < i; k++)
                stroke(p, x[i].position, x[k].position, THIN, ORANGE);
        }
    }
}

static void draw(painter *p, const world *w, int panel)
{
    stroke(p, vec3_make(-9, 0, -0.5), vec3_make(9, 0, -0.5), THIN, INK);
    stroke(p, vec3_make(-9, 0, 0.5), vec3_make(9, 0, 0.5), THIN, INK);
    if (panel == 0 || panel == 5) draw_bodies(p, w);
    if (panel == 1) draw_pairs(p, w);
    if (panel == 2) draw_contacts(p, w, false);
    if (panel == 3) draw_contacts(p, w, true);
    if (panel == 4) draw_positions(p, w);
}

static status paint(const world *w, picture *out, int panel)
{
    painter p;
    int left = panel % COLUMNS * (WIDTH + GAP);
    int top = panel / COLUMNS * (HEIGHT + GAP);
    painter_init(&p);
    painter_look(&p, vec3_make(2.2, 4.6, 22), vec3_make(-0.35, 1.85, 0), 13.5);
    draw(&p, w, panel);
    status done = painter_paint(&p, out, left, top, WIDTH, HEIGHT);
    painter_free(&p);
    picture_text(out, left + 20, top + 42, 26, colour_hex(INK), name[panel]);
    picture_text(out, left + 20, top + 76, 21, colour_hex(INK), what[panel]);
    return done;
}

int main(int arguments, char **argument)
{
    static set s;
    picture out;
    if (arguments != 2) {
        fprintf(stderr, "usage: 18-phases FILE.png\n");
        return 2;
    }
    status done = picture_init(&out, COLUMNS * (WIDTH + GAP) - GAP,
                               PANELS / COLUMNS * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    if (done.ok) done = build(&s);
    for (int k = 0; k < FRAMES && done.ok && !has_struck(&s.world); k++)
        world_step(&s.world);
    for (int k = 0; k < PANELS && done.ok; k++) {
        if (k == PANELS - 1) world_step(&s.world);
        done = paint(&s.world, &out, k);
    }
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    world_free(&s.world);
    scene_free(&s.scene);
    if (!done.ok) fprintf(stderr, "18-phases: %s\n", done.why);
    return done.ok ? 0 : 1;
}
