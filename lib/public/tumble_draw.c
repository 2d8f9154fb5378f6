//> face-vertices
#include "inside.h"

#include <stdlib.h>

// Writes the vertices of piece b of a body; returns how many there are.
static int piece_vertices(const tumble_world *w, int b, tumble_vec3 *out,
                          int most)
{
    const body *x = &w->world.body[b];
    int n = x->shape->particles;
    if (most <= 0) return n;
    world_vertices(&w->world, x, w->scratch);
    for (int i = 0; i < n && i < most; i++) out[i] = to_user(w->scratch[i]);
    return n;
}

int tumble_vertices(const tumble_world *w, tumble_body b, tumble_vec3 *out,
                    int most)
{
    const body_place *x = inside_look(w, b);
    int n = 0;
    for (int k = 0; x && k < x->pieces; k++)
        n += piece_vertices(w, x->piece[k].number, out + n, most - n);
    return n;
}

const int (*tumble_triangles(const tumble_world *w, tumble_body b,
                             int *count))[3]
{
    const body_place *x = inside_look(w, b);
    *count = 0;
    if (!x || x->pieces != 1) return NULL;
    const shape *s = w->world.body[x->piece[0].number].shape;
    *count = s->mesh.faces;
    return (const int (*)[3])(const void *)s->face;
}
//<

//> face-draw
static void draw_triangles(const tumble_world *w, const body *x,
                           tumble_body id, const tumble_pen *pen)
{
    for (int f = 0; f < x->shape->mesh.faces; f++) {
        const int *v = x->shape->face + 3 * f;
        tumble_vec3 at[3];
        for (int k = 0; k < 3; k++) at[k] = to_user(w->scratch[v[k]]);
        pen->triangle(pen->context, id, at);
    }
}

static void draw_links(const tumble_world *w, const body *x, tumble_body id,
                       const tumble_pen *pen)
{
    for (int k = 0; k < x->shape->sticks; k++) {
        const stick *s = &x->shape->stick[k];
        tumble_vec3 at[2] = { to_user(w->scratch[s->a]), to_user(w->scratch[s->b]) };
        pen->line(pen->context, id, at);
    }
}

static void draw_body(const tumble_world *w, int b, const tumble_pen *pen)
{
    const body *x = &w->world.body[b];
    tumble_body id = inside_owner(w, b);
    world_vertices(&w->world, x, w->scratch);
    if (x->shape->kind == SHAPE_ROPE) {
        if (pen->line) draw_links(w, x, id, pen);
    } else if (pen->triangle) {
        draw_triangles(w, x, id, pen);
    }
}

static void draw_contacts(const tumble_world *w, const tumble_pen *pen)
{
    int n = tumble_contacts(w, NULL, 0);
    tumble_contact *c = malloc(((size_t)n + 1) * sizeof *c);
    if (!c) return;
    tumble_contacts(w, c, n);
    for (int k = 0; k < n; k++)
        for (int i = 0; i < c[k].points; i++)
            pen->point(pen->context, c[k].a, c[k].point[i]);
    free(c);
}

void tumble_draw(const tumble_world *w, const tumble_pen *pen)
{
    for (int k = 0; k < w->bodies.count; k++) {
        const body_place *x = slots_at(&w->bodies, k);
        for (int i = 0; x && i < x->pieces; i++)
            draw_body(w, x->piece[i].number, pen);
    }
    if (pen->point) draw_contacts(w, pen);
}
//<
