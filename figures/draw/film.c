// film.c - cameras, colours and moments for the three scenes.

#include "film.h"

#include <stdio.h>
#include <stdlib.h>

// ---- Cameras ---------------------------------------------------------------

// For each scene: where the camera stands as seen from the target, the target
// and the half width and half height (m) that must be in the picture, and the
// first moments (s) of a strip.  Of the room all is in units of its side.
typedef struct {
    vec3 from, target;
    real half_width, half_height;
    vec3 lamp;
    real moment[STRIP_PANELS - 1];
} view;

static const view views[SCENES] = {
    { { 0.42, 0.32, 1 }, { -0.01, 0.42, 0 }, 0.79, 0.73, { 0.3, 1, 0.55 },
      { 0, 0.5 } },
    { { 0.55, 0.55, 1 }, { 0, 0.5, 0 }, 1.42, 0.9, { -0.45, 1, 0.5 },
      { 0.1, 0.4 } },
    { { 0.4, 0.28, 1 }, { 0.07, 1.0, 0 }, 1.5, 0.95, { -0.35, 1, 0.6 },
      { 0.2, 0.7 } },
};

static const real ANGLE = 28;       // degrees, from lower to upper edge

// Steps back until both half sides are inside the picture.
static void point_camera(painter *p, const pose *s, real aspect)
{
    const view *v = &views[s->kind];
    real unit = s->kind == SCENE_ROOM ? s->scene->size : 1;
    real half = tan(ANGLE / 2 * 3.14159265358979 / 180);
    real away = fmax(v->half_height, v->half_width / aspect) / half;
    vec3 target = vec3_scale(unit, v->target);
    vec3 eye = vec3_add_scaled(target, unit * away, vec3_unit(v->from));
    painter_look(p, eye, target, ANGLE);
    painter_floor(p, vec3_make(0, 0, 0), unit * (0.8 * away + 2),
                  s->kind == SCENE_ROOM ? 0.5 : 0.25);
    p->lamp = vec3_unit(v->lamp);
}

// ---- Bodies ----------------------------------------------------------------

// Okabe and Ito's colours, which everyone can tell apart, a little softened.
static const unsigned thrown[] = {
    0xe69f00, 0x56b4e9, 0x009e73, 0xefdc4a, 0x0072b2, 0xd55e00, 0xcc79a7
};

static status paint_rigid(painter *p, const scene *s, const vec3 *at,
                          int number)
{
    const shape *x = scene_shape(s, number);
    int colours = (int)(sizeof thrown / sizeof thrown[0]);
    colour c = colour_hex(thrown[number % colours]);
    if (s->body[number].where.is_static) c = colour_hex(0x8794a3);
    painted_mesh m = { .vertices = x->particles, .at = at,
                       .faces = x->mesh.faces, .face = x->face,
                       .front = { c, c }, .back = { c, c },
                       .creases = 1, .casts = 1, .gloss = 0.3 };
    return painter_mesh(p, &m);
}

// The weave: bands of cells along x and along z in the cloth's own frame, 13
// each way; where two dark ones cross, the cloth is darkest.
static void weave(const shape *s, real *tint)
{
    const int bands = 13;
    vec3 first = s->at[0], last = s->at[s->particles - 1];
    int cells = (int)((last.x - first.x) / s->spacing + 0.5);
    int wide = (cells + bands / 2) / bands;
    if (wide < 1) wide = 1;
    for (int f = 0; f < s->mesh.faces; f++) {
        vec3 low = s->at[s->face[3 * f]];
        for (int k = 1; k < 3; k++) {
            vec3 at = s->at[s->face[3 * f + k]];
            low = vec3_make(fmin(low.x, at.x), 0, fmin(low.z, at.z));
        }
        int i = (int)((low.x - first.x) / s->spacing + 0.5);
        int j = (int)((low.z - first.z) / s->spacing + 0.5);
        tint[f] = 0.5 * (i / wide % 2) + 0.5 * (j / wide % 2);
    }
}

static status paint_cloth(painter *p, const shape *s, const vec3 *at,
                          scene_kind kind)
{
    static const unsigned skins[2][4] = {
        { 0xbf3f2b, 0xe9a075, 0xcfa980, 0xead3b4 },
        { 0x0f5f9e, 0x86c0e6, 0x9db4c8, 0xd9e4ee },
    };
    const unsigned *skin = skins[kind == SCENE_CLOTH_ON_ROPE];
    real *tint = malloc((size_t)s->mesh.faces * sizeof *tint);
    if (!tint) return status_out_of_memory();
    weave(s, tint);
    painted_mesh m = { .vertices = s->particles, .at = at,
        .faces = s->mesh.faces, .face = s->face, .tint = tint,
        .front = { colour_hex(skin[0]), colour_hex(skin[1]) },
        .back = { colour_hex(skin[2]), colour_hex(skin[3]) },
        .smooth = 1, .casts = 1, .gloss = 0.04 };
    status done = painter_mesh(p, &m);
    free(tint);
    return done;
}

static status paint_rope(painter *p, const shape *s, const vec3 *at)
{
    const colour light = colour_hex(0xead5a8), dark = colour_hex(0xb28b4f);
    const colour pin = colour_hex(0x4a525d);
    int last = s->particles - 1;
    real radius = fmax(0.41 * s->spacing, 0.02);
    status done = painter_rope(p, at, last + 1, radius, light, dark);
    if (done.ok) done = painter_ball(p, at[0], 1.7 * radius, pin);
    if (done.ok) done = painter_ball(p, at[last], 1.7 * radius, pin);
    return done;
}

static status paint_body(painter *p, const pose *s, int number, const vec3 *at)
{
    const shape *x = scene_shape(s->scene, number);
    switch (x->kind) {
    case SHAPE_RIGID: return paint_rigid(p, s->scene, at, number);
    case SHAPE_CLOTH: return paint_cloth(p, x, at, s->kind);
    case SHAPE_ROPE:  return paint_rope(p, x, at);
    }
    return status_ok();
}

// ---- The room --------------------------------------------------------------

// Corner i of the room: its bits choose the sides along x, y and z.
static vec3 room_corner(real side, int i)
{
    return vec3_make(i & 1 ? side / 2 : -side / 2, i & 2 ? side : 0,
                     i & 4 ? side / 2 : -side / 2);
}

// Four walls, each seen from the inside only: the near ones are not in the way.
static status paint_walls(painter *p, real side)
{
    static const int face[] = {
        0, 1, 2,  1, 3, 2,   4, 6, 5,  5, 6, 7,     // z low, z high
        0, 2, 4,  2, 6, 4,   1, 5, 3,  3, 5, 7      // x low, x high
    };
    const colour c = p->wall;
    vec3 at[8];
    for (int i = 0; i < 8; i++) at[i] = room_corner(side, i);
    painted_mesh m = { .vertices = 8, .at = at, .faces = 8, .face = face,
                       .front = { c, c }, .back = { c, c }, .see_through = 1 };
    return painter_mesh(p, &m);
}

static status paint_edges(painter *p, real side)
{
    const colour c = colour_hex(0x98a1ab);
    status done = status_ok();
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8 && done.ok; bit *= 2)
            if (!(i & bit))
                done = painter_line(p, room_corner(side, i),
                                    room_corner(side, i | bit), 0.0025, c);
    return done;
}

status film_paint_pose(pose s, int lamps, picture *out,
                       int left, int top, int width, int height)
{
    painter p;
    const vec3 *at = s.at;
    painter_init(&p);
    p.lamps = lamps;
    point_camera(&p, &s, (real)width / height);
    status done = status_ok();
    if (s.kind == SCENE_ROOM) {
        done = paint_walls(&p, s.scene->size);
        if (done.ok) done = paint_edges(&p, s.scene->size);
    }
    for (int b = 0; b < s.scene->bodies && done.ok; b++) {
        done = paint_body(&p, &s, b, at);
        at += scene_shape(s.scene, b)->particles;
    }
    if (done.ok) done = painter_paint(&p, out, left, top, width, height);
    painter_free(&p);
    return done;
}

status film_paint(const world_scene *s, int lamps, picture *out,
                  int left, int top, int width, int height)
{
    int count = 1;
    for (int b = 0; b < s->scene.bodies; b++)
        count += scene_shape(&s->scene, b)->particles;
    vec3 *at = malloc((size_t)count * sizeof *at);
    if (!at) return status_out_of_memory();
    for (int b = 0, first = 0; b < s->scene.bodies; b++) {
        world_vertices(&s->world, &s->world.body[b], at + first);
        first += scene_shape(&s->scene, b)->particles;
    }
    pose p = { s->kind, &s->scene, at, s->world.time };
    status done = film_paint_pose(p, lamps, out, left, top, width, height);
    free(at);
    return done;
}

// ---- Strips and frames -----------------------------------------------------

enum { PANEL_WIDTH = 528, PANEL_HEIGHT = 480, GUTTER = 8, STRIP_LAMPS = 8,
       FRAME_WIDTH = 960, FRAME_HEIGHT = 540, FRAME_LAMPS = 3 };

strip strip_begin(scene_kind kind, long steps, real dt)
{
    strip t = { .taken = 0 };
    const real *moment = views[kind].moment;
    // A run too short for these moments has them closer together.
    real whole = (real)steps * dt, last = moment[STRIP_PANELS - 2];
    real scale = whole / (1.5 * last);
    if (scale > 1) scale = 1;
    for (int k = 0; k + 1 < STRIP_PANELS; k++)
        t.step[k] = (long)(scale * moment[k] / dt + 0.5);
    t.step[STRIP_PANELS - 1] = steps;
    return t;
}

void strip_free(strip *t)
{
    for (int k = 0; k < t->taken; k++) picture_free(&t->panel[k]);
    t->taken = 0;
}

static void caption(picture *p, real seconds)
{
    char text[32];
    snprintf(text, sizeof text, "%.2f s", seconds);
    picture_text(p, 14, p->height - 14.0, 12, colour_hex(0x4a4f57), text);
}

status strip_look(strip *t, pose s, long step)
{
    while (t->taken < STRIP_PANELS && t->step[t->taken] <= step) {
        picture *p = &t->panel[t->taken];
        status done = picture_init(p, PANEL_WIDTH, PANEL_HEIGHT,
                                   colour_hex(0xffffff));
        if (!done.ok) return done;
        t->taken++;
        done = film_paint_pose(s, STRIP_LAMPS, p, 0, 0, PANEL_WIDTH,
                               PANEL_HEIGHT);
        if (!done.ok) return done;
        caption(p, s.time);
    }
    return status_ok();
}

status strip_write(const strip *t, const char *path)
{
    if (t->taken == 0) return status_ok();
    picture all;
    status done = picture_init(&all, t->taken * (PANEL_WIDTH + GUTTER) - GUTTER,
                               PANEL_HEIGHT, colour_hex(0xffffff));
    if (!done.ok) return done;
    for (int k = 0; k < t->taken; k++)
        picture_copy(&all, k * (PANEL_WIDTH + GUTTER), 0, &t->panel[k]);
    done = picture_write(&all, path);
    picture_free(&all);
    return done;
}

status film_write(pose s, const char *path)
{
    picture p;
    status done = picture_init(&p, FRAME_WIDTH, FRAME_HEIGHT,
                               colour_hex(0xffffff));
    if (!done.ok) return done;
    done = film_paint_pose(s, FRAME_LAMPS, &p, 0, 0, FRAME_WIDTH, FRAME_HEIGHT);
    if (done.ok) caption(&p, s.time);
    if (done.ok) done = picture_write(&p, path);
    picture_free(&p);
    return done;
}
