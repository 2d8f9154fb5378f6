// race_judge.c - how deep do bodies lie in each other, how far do joints gape, how
// long is a thread, and what crosses?
//
// From where things lie alone, and with no function that moves any of them.  Two
// convex bodies are apart if they are along the normal of a face, or along the
// product of two edges; else they overlap by the least that they do along one of
// these.  For two boxes that makes 15 directions, for two icosahedra 245.

#include "race.h"
#include "crossings.h"
#include "oracle.h"

#include <stdlib.h>

static vec3 turned(const pose *p, vec3 own)
{
    vec3 v = vec3_scale(own.x, p->x);
    return vec3_add_scaled(vec3_add_scaled(v, own.y, p->y), own.z, p->z);
}

static vec3 seen_from(const pose *p, vec3 at)
{
    vec3 arm = vec3_sub(at, p->middle);
    return vec3_make(vec3_dot(arm, p->x), vec3_dot(arm, p->y), vec3_dot(arm, p->z));
}

// Along n (unit): half the shadow of a body that lies there.
static real shadow(const body_form *f, const pose *p, vec3 n)
{
    vec3 own = { vec3_dot(p->x, n), vec3_dot(p->y, n), vec3_dot(p->z, n) };
    real most = f->kind == FORM_BALL ? f->radius : 0;
    for (int k = 0; k < f->corners; k++)
        most = fmax(most, fabs(vec3_dot(f->corner[k], own)));
    return most;
}

static real depth_along(const body_form *f, const pose *a, const body_form *g,
                        const pose *b, vec3 n)
{
    return shadow(f, a, n) + shadow(g, b, n)
         - fabs(vec3_dot(n, vec3_sub(b->middle, a->middle)));
}

// ---- Two bodies ------------------------------------------------------------

static real least_along_normals(const body_form *f, const pose *a, const body_form *g,
                                const pose *b)
{
    real least = HUGE_VAL;
    for (int k = 0; k < f->normals; k++)
        least = fmin(least, depth_along(f, a, g, b, turned(a, f->normal[k])));
    for (int k = 0; k < g->normals; k++)
        least = fmin(least, depth_along(f, a, g, b, turned(b, g->normal[k])));
    return least;
}

// The ball's middle seen from the box, and the point of the box nearest to it.
static real ball_in_box(const body_form *ball, const pose *a, const body_form *box,
                        const pose *b)
{
    vec3 c = seen_from(b, a->middle), h = box->half;
    vec3 out = { fmax(fabs(c.x) - h.x, 0), fmax(fabs(c.y) - h.y, 0),
                 fmax(fabs(c.z) - h.z, 0) };
    real far = vec3_length(out);
    if (far > 0) return ball->radius - far;
    return ball->radius + fmin(h.x - fabs(c.x), fmin(h.y - fabs(c.y), h.z - fabs(c.z)));
}

real forms_depth(const body_form *f, const pose *a, const body_form *g, const pose *b,
                 real known)
{
    bool f_is_ball = f->kind == FORM_BALL, g_is_ball = g->kind == FORM_BALL;
    if (f_is_ball && g_is_ball)
        return f->radius + g->radius - vec3_distance(a->middle, b->middle);
    if (f_is_ball) return ball_in_box(f, a, g, b);
    if (g_is_ball) return ball_in_box(g, b, f, a);

    real least = least_along_normals(f, a, g, b);
    for (int i = 0; i < f->edges; i++)
        for (int j = 0; j < g->edges; j++) {
            if (least <= known) return 0;
            vec3 n = vec3_cross(turned(a, f->edge[i]), turned(b, g->edge[j]));
            real l = vec3_length(n);
            if (l > 1e-6)       // else the edges are parallel: a face's normal
                least = fmin(least, depth_along(f, a, g, b, vec3_scale(1 / l, n)));
        }
    return least > known ? least : 0;
}

// ---- All bodies ------------------------------------------------------------

static void keep_depth(verdict *v, real depth)
{
    if (v->depths == v->room) {
        v->room = v->room ? 2 * v->room : 1024;
        v->depth = realloc(v->depth, (size_t)v->room * sizeof *v->depth);
        if (!v->depth) give_up("there is no memory for the depths");
    }
    v->depth[v->depths++] = depth;
}

static bool is_number(vec3 v)
{
    return fabs(v.x) < 1e9 && fabs(v.y) < 1e9 && fabs(v.z) < 1e9;
}

static void look_at_walls(const scene *s, int k, const pose *at, bool keep,
                          verdict *v)
{
    for (int w = 0; w < s->walls; w++) {
        real up = vec3_dot(at->middle, s->normal[w]) - s->offset[w];
        real depth = shadow(&s->form[s->body[k].form], at, s->normal[w]) - up;
        v->overlap = fmax(v->overlap, depth);
        if (keep && depth > 0) keep_depth(v, depth);
    }
}

static void look_at_pair(const scene *s, const pose *at, int i, int j, bool keep,
                         verdict *v)
{
    int f = s->body[i].form, g = s->body[j].form;
    real depth = forms_depth(&s->form[f], &at[i], &s->form[g], &at[j],
                             keep ? 0 : v->pair);
    if (keep && depth > 0) keep_depth(v, depth);
    v->overlap = fmax(v->overlap, depth);
    if (depth <= v->pair) return;
    v->pair = depth;
    v->a = at[i], v->b = at[j];
    v->form_a = f, v->form_b = g;
}

static bool are_joined(const scene *s, int i, int j)
{
    for (int k = 0; k < s->joints; k++) {
        const ball_joint *b = &s->joint[k];
        if ((b->a == i && b->b == j) || (b->a == j && b->b == i)) return true;
    }
    return false;
}

typedef struct {
    real x;
    int  body;
} mark;

static int is_right_of(const void *a, const void *b)
{
    real x = ((const mark *)a)->x, y = ((const mark *)b)->x;
    return (x > y) - (x < y);
}

static void look_at_pairs(const scene *s, const pose *at, const mark *by_x, int n,
                          real widest, bool keep, verdict *v)
{
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n && by_x[j].x - by_x[i].x < 2 * widest; j++) {
            int a = by_x[i].body, b = by_x[j].body;
            real far = s->form[s->body[a].form].radius + s->form[s->body[b].form].radius;
            vec3 d = vec3_sub(at[b].middle, at[a].middle);
            if (vec3_length_squared(d) < far * far && !are_joined(s, a, b)
                && (a >= s->fixed || b >= s->fixed))
                look_at_pair(s, at, a, b, keep, v);
        }
}

static void look_at_joints(const scene *s, const pose *at, verdict *v)
{
    for (int k = 0; k < s->joints; k++) {
        const ball_joint *j = &s->joint[k];
        vec3 a = vec3_add(at[j->a].middle,
                          turned(&at[j->a], seen_from(&s->body[j->a].at, j->at)));
        vec3 b = j->b < 0 ? j->at
               : vec3_add(at[j->b].middle,
                          turned(&at[j->b], seen_from(&s->body[j->b].at, j->at)));
        v->gap = fmax(v->gap, vec3_distance(a, b));
    }
}

void judge_bodies(const scene *s, const pose *at, bool all_pairs, verdict *v)
{
    mark *by_x = malloc((size_t)(s->bodies + 1) * sizeof *by_x);
    if (!by_x) give_up("there is no memory for the judge");
    real widest = 0;
    int n = 0;
    v->lost = 0;
    for (int k = 0; k < s->bodies; k++) {
        widest = fmax(widest, s->form[s->body[k].form].radius);
        if (!is_number(at[k].middle)) {
            v->lost++;
            continue;
        }
        by_x[n++] = (mark){ at[k].middle.x, k };
        if (k >= s->fixed) look_at_walls(s, k, &at[k], all_pairs, v);
    }
    qsort(by_x, (size_t)n, sizeof *by_x, is_right_of);
    look_at_pairs(s, at, by_x, n, widest, all_pairs, v);
    look_at_joints(s, at, v);
    free(by_x);
}

static hull hull_of(const body_form *f, const pose *p, vec3 *at)
{
    for (int k = 0; k < f->corners; k++) {
        vec3 arm = turned(p, f->corner[k]);
        at[2 * k] = vec3_add(p->middle, arm);
        at[2 * k + 1] = vec3_sub(p->middle, arm);
    }
    return (hull){ at, 2 * f->corners };
}

void judge_the_judge(const scene *s, const verdict *v)
{
    vec3 a[FORM_CORNERS], b[FORM_CORNERS];
    const body_form *f = &s->form[v->form_a], *g = &s->form[v->form_b];
    if (!(v->pair > 0) || !f->corners || !g->corners) return;
    real truth = (real)oracle_depth(hull_of(f, &v->a, a), hull_of(g, &v->b, b));
    // Other engines count in float: their axes are not quite perpendicular.
    if (!(fabs(v->pair - truth) <= 1e-5 * (f->radius + g->radius)))
        give_up("the oracle does not agree about the deepest pair");
}

// ---- The sheet -------------------------------------------------------------

static void look_at_thread(const cloth_sheet *c, vec3 a, vec3 b, verdict *v)
{
    real rest = c->width / (c->side - 1);
    real strain = fabs(vec3_distance(a, b) - rest) / rest;
    v->strain_now = fmax(v->strain_now, strain);
}

void judge_sheet(const scene *s, const pose *at, const vec3 *vertex, verdict *v)
{
    const cloth_sheet *c = &s->sheet;
    int n = c->side;
    v->strain_now = 0;
    for (int k = 0; k < n * n; k++) {
        if (!is_number(vertex[k])) {
            v->lost++;
            continue;
        }
        if (k % n) look_at_thread(c, vertex[k - 1], vertex[k], v);
        if (k >= n) look_at_thread(c, vertex[k - n], vertex[k], v);
        for (int b = 0; b < s->bodies; b++) {
            const body_form point = { .kind = FORM_BALL };
            const body_form *f = &s->form[s->body[b].form];
            pose p = { .middle = vertex[k] };
            if (f->kind == FORM_BOX)
                v->into = fmax(v->into, ball_in_box(&point, &p, f, &at[b]));
        }
    }
    v->strain = fmax(v->strain, v->strain_now);
}

long judge_crossings(const scene *s, const vec3 *vertex)
{
    int n = s->sheet.side, count = 0;
    patch *x = malloc((size_t)(2 * n * n) * sizeof *x);
    if (!x) give_up("there is no memory for the triangles");
    for (int j = 0; j + 1 < n; j++)
        for (int i = 0; i + 1 < n; i++) {
            int a = j * n + i, b = a + 1, c = a + n, d = c + 1;
            x[count++] = patch_make(vertex, (int[]){ a, c, d }, 0);
            x[count++] = patch_make(vertex, (int[]){ a, d, b }, 0);
        }
    long crossings = crossings_count(x, count);
    free(x);
    if (crossings < 0) give_up("there is no memory to count crossings");
    return crossings;
}
