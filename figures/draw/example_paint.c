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
// in each row of six, so that walls show their bricks; what never moves is
// grey, and what is driven like slate.
static colour colour_of(const tumble_world *w, tumble_body b)
{
    static const unsigned tone[] = { 0x0072b2, 0xd55e00, 0x009e73, 0xe69f00,
                                     0xcc79a7, 0x56b4e9 };
    tumble_kind kind = tumble_body_get_options(w, b).kind;
    if (kind == TUMBLE_STATIC)    return colour_hex(0xb8bcc2);
    if (kind == TUMBLE_KINEMATIC) return colour_hex(0x7e95b5);
    return colour_hex(tone[(b.place + b.place / 6) % 6]);
}

// --- Which bodies are smooth? -----------------------------------------------
// A corner of a triangle, and which; an edge of one, from the lower vertex on.
typedef struct { vec3 at; int corner; } placed_corner;
typedef struct { int from, to, face; } face_edge;

static int sign_of(real x) { return (x > 0) - (x < 0); }

static int by_place(const void *a, const void *b)
{
    const placed_corner *p = a, *q = b;
    int order = sign_of(p->at.x - q->at.x);
    if (!order) order = sign_of(p->at.y - q->at.y);
    if (!order) order = sign_of(p->at.z - q->at.z);
    return order ? order : p->corner - q->corner;
}

static int by_ends(const void *a, const void *b)
{
    const face_edge *p = a, *q = b;
    if (p->from != q->from) return p->from - q->from;
    return p->to != q->to ? p->to - q->to : p->face - q->face;
}

// Corners at one place become one vertex.  Returns how many there are.
static int weld(sheet *s, placed_corner *sorted)
{
    int n = 0;
    for (int k = 0; k < s->corners; k++)
        sorted[k] = (placed_corner){ s->at[k], k };
    qsort(sorted, (size_t)s->corners, sizeof *sorted, by_place);
    for (int k = 0; k < s->corners; k++) {
        if (k == 0 || vec3_distance(sorted[k].at, sorted[k - 1].at) > 0)
            s->at[n++] = sorted[k].at;
        s->face[sorted[k].corner] = n - 1;
    }
    return n;
}

static vec3 normal_of(const sheet *s, int f)
{
    const int *v = s->face + 3 * f;
    return vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                                vec3_sub(s->at[v[2]], s->at[v[0]])));
}

// What has a rim is cloth.  What has none, and no edge that is sharp, is round.
static bool is_smooth(const sheet *s, face_edge *edge, bool *is_cloth)
{
    const real sharp = 0.77;            // the cosine of 40 degrees
    bool is_round = true;
    for (int k = 0; k < s->corners; k++) {
        int a = s->face[k], b = s->face[k % 3 == 2 ? k - 2 : k + 1];
        edge[k] = (face_edge){ int_min(a, b), int_max(a, b), k / 3 };
    }
    qsort(edge, (size_t)s->corners, sizeof *edge, by_ends);
    *is_cloth = false;
    for (int k = 0; k < s->corners; k += 2) {
        const face_edge *one = &edge[k], *two = one + 1;
        if (k + 1 == s->corners || one->from != two->from
            || one->to != two->to) return *is_cloth = true;
        real bend = vec3_dot(normal_of(s, one->face), normal_of(s, two->face));
        is_round = is_round && bend > sharp;
    }
    return is_round;
}

// (Vertices of a sharp body are its corners, which share no normal.)
static void finish_body(sheet *s)
{
    size_t n = (size_t)s->corners;
    placed_corner *sorted = malloc((n + 1) * sizeof *sorted);
    face_edge *edge = malloc((n + 1) * sizeof *edge);
    bool is_cloth = false;
    if (!sorted || !edge) s->done = status_out_of_memory();
    if (s->corners > 0 && s->done.ok) {
        colour c = colour_of(s->world, s->body), inside = c;
        painted_mesh m = { .vertices = weld(s, sorted), .at = s->at,
                           .faces = s->corners / 3, .face = s->face,
                           .casts = 1 };
        m.smooth = is_smooth(s, edge, &is_cloth);
        if (is_cloth) inside = colour_mix(c, colour_hex(0x202428), 0.15);
        m.gloss = is_cloth ? 0.05 : 0.2;
        m.front[0] = m.front[1] = c;
        m.back[0] = m.back[1] = inside;
        s->done = painter_mesh(s->painter, &m);
    }
    free(sorted);
    free(edge);
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
    tumble_world_draw(w, &pen);
    finish_body(&all);
    if (all.done.ok)
        all.done = painter_paint(&p, out, left, top, width, height);
    free(all.at);
    free(all.face);
    painter_free(&p);
    return all.done;
}
