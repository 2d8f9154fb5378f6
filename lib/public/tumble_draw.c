//> face-vertices
//>   To draw a body of several pieces, its points and triangles are written one
//>   piece after the other.
#include "inside.h"

#include <stdlib.h>

// What piece k of a body is drawn with: of a surface, which is one, all of it.
static struct skin skin_of(const tumble_world *w, const body_place *x, int k)
{
    if (!x->mesh) return shape_skin(w->world.body[x->piece[k].number].shape);
    const surface *s = &x->mesh->surface;
    return (struct skin){ s->points, s->triangles, s->point, s->triangle[0] };
}

static int skins(const body_place *x)
{
    return x->mesh ? 1 : x->pieces;
}

// The same, with its points where they are now: in the world's scratch.
static struct skin place_skin(const tumble_world *w, const body_place *x, int k)
{
    const body *all = &w->world.body[x->piece[k].number];
    struct skin s = skin_of(w, x, k);
    if (x->mesh) return s;
    if (all->shape->round > 0) world_skin(&w->world, all, w->scratch);
    else world_vertices(&w->world, all, w->scratch);
    s.at = w->scratch;
    return s;
}

int tumble_body_vertices(const tumble_world *w, tumble_body b, tumble_vec3 *out,
                         int most)
{
    const body_place *x = inside_body_of(w, b);
    int n = 0;
    for (int k = 0; x && k < skins(x); k++) {
        struct skin s = place_skin(w, x, k);
        for (int i = 0; i < s.points; i++, n++)
            if (out && n < most) out[n] = to_user(s.at[i]);
    }
    return n;
}

const int *tumble_body_triangles(const tumble_world *w, tumble_body b,
                                 int *count)
{
    const body_place *x = inside_body_of(w, b);
    if (count) *count = 0;
    if (!x || skins(x) != 1) return NULL;
    struct skin s = skin_of(w, x, 0);
    if (count) *count = s.faces;
    return s.face;
}
//<

//> face-draw
//>   The lines for debugging are handed to a function of the program, one at a
//>   time, so that the library needs no graphics.
static void draw_triangles(struct skin s, tumble_body id, const tumble_pen *pen)
{
    for (int f = 0; f < s.faces; f++) {
        const int *v = s.face + 3 * f;
        tumble_vec3 at[3];
        for (int k = 0; k < 3; k++) at[k] = to_user(s.at[v[k]]);
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

static void draw_piece(const tumble_world *w, const body_place *x, int k,
                       const tumble_pen *pen)
{
    int b = x->piece[k].number;
    const body *all = &w->world.body[b];
    tumble_body id = inside_owner(w, b);
    struct skin s = place_skin(w, x, k);
    if (all->shape->kind == SHAPE_ROPE) {
        if (pen->line) draw_links(w, all, id, pen);
    } else if (pen->triangle) {
        draw_triangles(s, id, pen);
    }
}

// A joint is where its two points are: one, or, of a distance, two.
static void draw_joint(const tumble_world *w, const joint *j,
                       const tumble_pen *pen)
{
    rigid_frame a = inside_frame(w, j->a), b = inside_frame(w, j->b);
    vec3 end[2];
    joint_points(j, &a, &b, &end[0], &end[1]);
    tumble_vec3 at[2] = { to_user(end[0]), to_user(end[1]) };
    tumble_body id = inside_owner(w, j->a >= 0 ? j->a : j->b);
    if (j->kind == JOINT_DISTANCE && pen->line) pen->line(pen->context, id, at);
    else if (pen->point) pen->point(pen->context, id, at[0]);
}

static void draw_contacts(const tumble_world *w, const tumble_pen *pen)
{
    int n = tumble_world_contacts(w, NULL, 0);
    tumble_contact *c = malloc(((size_t)n + 1) * sizeof *c);
    if (!c) return;
    tumble_world_contacts(w, c, n);
    for (int k = 0; k < n; k++)
        for (int i = 0; i < c[k].points; i++)
            pen->point(pen->context, c[k].a, c[k].point[i]);
    free(c);
}

void tumble_world_draw(const tumble_world *w, const tumble_pen *pen)
{
    if (!w || !pen) return;
    for (int k = 0; k < w->bodies.count; k++) {
        const body_place *x = slots_at(&w->bodies, k);
        for (int i = 0; x && i < skins(x); i++) draw_piece(w, x, i, pen);
    }
    const linkage *l = &w->world.joints;
    for (int k = 0; k < l->count; k++)
        if (l->joint[k].kind != JOINT_NONE && l->joint[k].kind != JOINT_LOCK)
            draw_joint(w, &l->joint[k], pen);
    if (pen->point) draw_contacts(w, pen);
}
//<
