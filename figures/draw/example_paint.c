#include "example_paint.h"

#include <stdlib.h>

// Triangles of the body that is being drawn, each with corners of its own.
typedef struct {
    painter *painter;
    const tumble_world *world;
    status done;
    tumble_body body;
    vec3 *at;
    int *face;
    int corners, room;
} sheet;

// The colours of bodies: by their ids, so that a body keeps its own, and shifted
// in each row of six, so that walls show their bricks; what does not move is
// grey.
static colour colour_of(const tumble_world *w, tumble_body b)
{
    static const unsigned tone[] = { 0x0072b2, 0xd55e00, 0x009e73, 0xe69f00,
                                     0xcc79a7, 0x56b4e9 };
    if (tumble_mass(w, b) == 0) return colour_hex(0xb8bcc2);
    return colour_hex(tone[(b.place + b.place / 6) % 6]);
}

static void finish_body(sheet *s)
{
    colour c = colour_of(s->world, s->body);
    painted_mesh m = { .vertices = s->corners, .at = s->at,
                       .faces = s->corners / 3, .face = s->face,
                       .front = { c, c }, .back = { c, c }, .casts = 1,
                       .gloss = 0.2 };
    if (s->corners > 0 && s->done.ok) s->done = painter_mesh(s->painter, &m);
    s->corners = 0;
}

static bool reserve(sheet *s)
{
    if (s->corners + 3 <= s->room) return true;
    int room = 2 * s->room + 300;
    vec3 *at = realloc(s->at, (size_t)room * sizeof *at);
    if (at) s->at = at;
    int *face = realloc(s->face, (size_t)room * sizeof *face);
    if (face) s->face = face;
    if (!at || !face) s->done = status_out_of_memory();
    else s->room = room;
    return at && face;
}

static void on_triangle(void *context, tumble_body b, const tumble_vec3 at[3])
{
    sheet *s = context;
    if (b.place != s->body.place) finish_body(s);
    s->body = b;
    if (!reserve(s)) return;
    for (int k = 0; k < 3; k++, s->corners++) {
        s->at[s->corners] = vec3_make(at[k].x, at[k].y, at[k].z);
        s->face[s->corners] = s->corners;
    }
}

static void on_line(void *context, tumble_body b, const tumble_vec3 at[2])
{
    sheet *s = context;
    (void)b;
    if (s->done.ok)
        s->done = painter_line(s->painter,
                               vec3_make(at[0].x, at[0].y, at[0].z),
                               vec3_make(at[1].x, at[1].y, at[1].z), 0.006,
                               colour_hex(0x4a525d));
}

status example_paint(const example *s, const tumble_world *w, int lamps,
                   picture *out, int left, int top, int width, int height)
{
    painter p;
    sheet all = { .painter = &p, .world = w, .done = status_ok() };
    tumble_pen pen = { on_triangle, on_line, NULL, &all };
    painter_init(&p);
    p.lamps = lamps;
    painter_look(&p, vec3_make(s->eye.x, s->eye.y, s->eye.z),
                 vec3_make(s->target.x, s->target.y, s->target.z), 34);
    p.lamp = vec3_unit(vec3_make(-0.5, 1, 0.6));
    if (s->has_floor)
        painter_floor(&p, vec3_make(s->target.x, 0, s->target.z), 40, 1);
    tumble_draw(w, &pen);
    finish_body(&all);
    if (all.done.ok)
        all.done = painter_paint(&p, out, left, top, width, height);
    free(all.at);
    free(all.face);
    painter_free(&p);
    return all.done;
}
