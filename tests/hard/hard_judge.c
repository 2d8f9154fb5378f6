// hard_judge.c - see hard_judge.h.

#include "hard_judge.h"
#include "hard.h"
#include "step.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// What is looked at, in one frame after another.
typedef struct {
    const world *w;
    patch *sheet;       // [patches] triangles and links
    vec3  *at, *was;    // [particles] of deformable bodies, and a frame ago
    solid *stone;       // room for a rigid body
    real  *seconds;     // [frames]
    int    patches;
    real   strain;      // of this frame
} look;

static bool look_begin(look *l, const world *w, int frames)
{
    int patches = 0;
    for (int b = 0; b < w->bodies; b++) {
        const shape *s = w->body[b].shape;
        patches += s->mesh.faces + s->sticks;
    }
    *l = (look){ .w = w };
    l->sheet = calloc((size_t)patches + 1, sizeof *l->sheet);
    l->at = calloc((size_t)w->pool.count + 1, sizeof *l->at);
    l->was = calloc((size_t)w->pool.count + 1, sizeof *l->was);
    l->stone = calloc(1, sizeof *l->stone);
    l->seconds = calloc((size_t)frames + 1, sizeof *l->seconds);
    return l->sheet && l->at && l->was && l->stone && l->seconds;
}

static void look_end(look *l)
{
    free(l->sheet);
    free(l->at);
    free(l->was);
    free(l->stone);
    free(l->seconds);
}

// ---- one frame -------------------------------------------------------------

static void read_body(look *l, const body *b)
{
    const shape *s = b->shape;
    int is_cloth = s->kind == SHAPE_CLOTH;
    int n = is_cloth ? s->mesh.faces : s->sticks;
    const vec3 *at = l->at + b->first;
    for (int i = 0; i < s->particles; i++)
        l->at[b->first + i] = l->w->pool.at[b->first + i].position;
    for (int k = 0; k < n; k++) {
        const int link[3] = { s->stick[k].a, s->stick[k].b, s->stick[k].b };
        l->sheet[l->patches++] =
            patch_make(at, is_cloth ? &s->face[3 * k] : link, b->first);
    }
    for (int k = 0; k < s->sticks; k++) {
        const stick *x = &s->stick[k];
        if (x->stiffness < 1) continue;
        real length = vec3_distance(at[x->a], at[x->b]);
        l->strain = hard_worse(l->strain, fabs(length / x->rest_length - 1));
    }
}

static void read_all(look *l)
{
    l->patches = 0;
    l->strain = 0;
    for (int b = 0; b < l->w->bodies; b++)
        if (body_is_soft(&l->w->body[b])) read_body(l, &l->w->body[b]);
}

static long most(long a, long b)
{
    return a > b ? a : b;
}

void judge_solid(const world *w, int number, solid *out)
{
    static vec3 at[SOLID_CORNERS];
    const body *b = &w->body[number];
    const shape *s = b->shape;
    assert(!body_is_soft(b) && s->particles <= SOLID_CORNERS);
    world_vertices(w, b, at);
    solid_make(out, at, s->particles, s->face, s->mesh.faces);
}

// How much of cloth and rope is in a rigid body.
static void look_in(const look *l, int rigid, verdict *now)
{
    const world *w = l->w;
    judge_solid(w, rigid, l->stone);
    for (int k = 0; k < l->patches; k++) {
        now->cutting += solid_is_cut(l->stone, &l->sheet[k]);
        now->edges += solid_edges_through(l->stone, &l->sheet[k]);
    }
    real near = l->stone->size;
    vec3 center = vec3_scale(0.5, vec3_add(l->stone->least, l->stone->most));
    for (int b = 0; b < w->bodies; b++) {
        if (!body_is_soft(&w->body[b])) continue;
        const vec3 *at = l->at + w->body[b].first;
        for (int i = 0; i < w->body[b].shape->particles; i++) {
            if (vec3_distance(at[i], center) > near) continue;
            real depth = solid_depth(l->stone, at[i]);
            now->inside += depth > 0;
            now->depth = fmax(now->depth, depth);
        }
    }
}

// m/s, the fastest since the last frame; then that is this one.
static real fastest(look *l)
{
    real speed = 0, dt = l->w->options.dt;
    for (int b = 0; b < l->w->bodies; b++) {
        const body *x = &l->w->body[b];
        if (!body_is_soft(x)) continue;
        for (int i = x->first; i < x->first + x->shape->particles; i++)
            speed = hard_worse(speed, vec3_distance(l->at[i], l->was[i]) / dt);
    }
    memcpy(l->was, l->at, (size_t)l->w->pool.count * sizeof *l->was);
    return speed;
}

static void look_once(look *l, bool is_last_second, verdict *v)
{
    verdict now = { .strain = 0 };
    read_all(l);
    now.crossings = crossings_count(l->sheet, l->patches);
    if (now.crossings < 0) v->crossings = 1000000000;
    for (int b = 0; b < l->w->bodies; b++)
        if (!body_is_soft(&l->w->body[b])) look_in(l, b, &now);
    v->strain = hard_worse(v->strain, l->strain);
    v->crossings = most(v->crossings, now.crossings);
    v->inside = most(v->inside, now.inside);
    v->cutting = most(v->cutting, now.cutting);
    v->edges = most(v->edges, now.edges);
    v->depth = hard_worse(v->depth, now.depth);
    real speed = fastest(l);
    if (!is_last_second) return;
    v->rest = hard_worse(v->rest, l->strain);
    v->speed = hard_worse(v->speed, speed);
}

bool judge_look(const world *w, verdict *v)
{
    look l;
    bool is_ready = look_begin(&l, w, 0);
    if (is_ready) look_once(&l, false, v);
    look_end(&l);
    return is_ready;
}

// ---- a run -----------------------------------------------------------------

static real mean_height(const world *w, const body *x)
{
    static vec3 at[SOLID_CORNERS];
    int n = x->shape->particles;
    real height = 0;
    if (!body_is_soft(x)) world_vertices(w, x, at);
    for (int i = 0; i < n; i++)
        height += (body_is_soft(x) ? w->pool.at[x->first + i].position.y
                                   : at[i].y) / n;
    return height;
}

static int count_below(const world *w, real floor)
{
    int below = 0;
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_static(&w->body[b]))
            below += !(mean_height(w, &w->body[b]) >= floor);
    return below;
}

static int by_size(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

// Means over all runs; the slowest of all.
static void add_times(real *seconds, int n, verdict *v)
{
    real sum = 0, share = 1.0 / (v->runs + 1);
    for (int k = 0; k < n; k++) sum += seconds[k] / n;
    qsort(seconds, (size_t)n, sizeof *seconds, by_size);
    v->mean += share * (sum - v->mean);
    v->median += share * (seconds[n / 2] - v->median);
    v->slowest = fmax(v->slowest, seconds[n - 1]);
}

static void calm(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        if (!body_is_soft(x)) continue;
        for (int i = x->first; i < x->first + x->shape->particles; i++) {
            particle *p = &w->pool.at[i];
            vec3 move = vec3_sub(p->position, p->previous);
            p->previous = vec3_add_scaled(p->position, -0.95, move);
        }
    }
}

bool judge_watch(world *w, watch_plan plan, verdict *v)
{
    look l;
    bool is_ready = look_begin(&l, w, plan.frames);
    long substeps = 0;
    for (int k = 0; is_ready && k < plan.frames; k++) {
        clock_t start = clock();
        world_step(w);
        l.seconds[k] = (real)(clock() - start) / CLOCKS_PER_SEC;
        substeps += w->report.substeps;
        look_once(&l, k >= plan.frames - 60, v);
        if (k < plan.calmed) calm(w);
    }
    if (is_ready && plan.frames > 0) {
        v->end = hard_worse(v->end, l.strain);
        add_times(l.seconds, plan.frames, v);
        v->substeps += ((real)substeps / plan.frames - v->substeps)
                     / (v->runs + 1);
        v->passed += count_below(w, plan.floor);
        v->frames = plan.frames;
        v->runs++;
    }
    look_end(&l);
    return is_ready;
}
