//> world-options
#include "world.h"

#include <assert.h>
#include <stdlib.h>

world_options world_options_default(void)
{
    world_options o = {
        .dt = 1.0 / 60, .substeps = 8, .sweeps = 6,
        .gravity = { 0, -9.81, 0 },
        .relax = { ROOT_EXACT, GRADIENT_OLD, 0.001, 0 }, .order = ORDER_LISTED,
        .response = response_options_default(),
        .leaves = LEAVES_VERTEX,
        .look_ahead = 1, .skin = 0.005, .manifold = 1, .blows = 1, .resting = 1,
    };
    o.response.gain = 3;
    return o;
}

world_options world_options_paper(void)
{
    world_options o = {
        .dt = 1.0 / 60, .substeps = 1, .sweeps = 10,
        .gravity = { 0, -9.81, 0 },
        .relax = { ROOT_APPROXIMATE, GRADIENT_NEW, 0.01, 1 },
        .order = ORDER_REPEATED,
        // Paper: d = pB - cA, A moves by -d/2: deeper in; here: out, because
        // its Fig. 8 b shows what its authors ran.
        .response = { SHARE_PRINTED, PUSH_OUT, 1, 0.5, 0 },
        .leaves = LEAVES_FACE,
    };
    return o;
}
//<

//> world-check
static status check_range(const char *name, real value, real least, real most)
{
    if (value >= least && value <= most) return status_ok();
    return status_fail("%s is %g; it must lie between %g and %g",
                       name, value, least, most);
}

// Names the first option that is out of its range (NaN is out of every range).
static status check_options(const world_options *o)
{
    struct { const char *name; real value, least, most; } rule[] = {
        { "dt",          o->dt,                   1e-9, 1 },
        { "substeps",    o->substeps,             1, 10000 },
        { "sweeps",      o->sweeps,               1, 10000 },
        { "tolerance",   o->relax.tolerance,      0, 1 },
        { "skin",        o->skin,                 0, 1 },
        // 12 mends at once where sticks leave a twelfth of a push.
        { "gain",        o->response.gain,        0, 12 },
        { "friction",    o->response.friction,    0, 1000 },
        { "restitution", o->response.restitution, 0, 1 },
    };
    for (size_t i = 0; i < sizeof rule / sizeof *rule; i++) {
        status s = check_range(rule[i].name, rule[i].value,
                               rule[i].least, rule[i].most);
        if (!s.ok) return s;
    }
    if (!vec3_is_finite(o->gravity))
        return status_fail("gravity is not finite");
    return status_ok();
}
//<

//> world-init
placement placement_at(vec3 position)
{
    return (placement){ .position = position,
        .x = { 1, 0, 0 }, .y = { 0, 1, 0 }, .z = { 0, 0, 1 } };
}

status world_init(world *w, world_options options)
{
    *w = (world){ .options = options, .hull_of = -1, .trusted = -1 };
    pool_init(&w->pool);
    return check_options(&options);
}

status world_add_plane(world *w, vec3 normal, real offset)
{
    const int most = (int)(sizeof w->plane / sizeof *w->plane);
    real length = vec3_length(normal);
    assert(!w->ready);
    if (w->planes == most)
        return status_fail("a world has room for %d planes", most);
    real away = offset / length;
    if (!(length > 0) || !(length < HUGE_VAL) || !(away - away == 0))
        return status_fail("plane %d has no finite normal and offset",
                           w->planes);
    w->plane[w->planes++] = (plane){ vec3_scale(1 / length, normal),
                                     away };
    return status_ok();
}

void world_nail(world *w, int b, int i)
{
    assert(!w->ready && b >= 0 && b < w->bodies);
    assert(i >= 0 && i < w->body[b].plan->particles);
    particle *p = &w->pool.at[w->body[b].first + i];
    p->inverse_mass = 0;
    p->previous = p->position;
}
//<

//> world-tree
// The features that the leaves of a body's tree enclose: the faces of a rigid
// body; of a deformable one its particles, or its faces, or a rope's links.
static int leaf_count(const shape *s, leaves_kind kind)
{
    if (s->kind == SHAPE_RIGID) return s->mesh.faces;
    if (kind == LEAVES_VERTEX)  return s->particles;
    return s->kind == SHAPE_CLOTH ? s->mesh.faces : s->sticks;
}

static leaf_feature leaf_number(const shape *s, leaves_kind kind, int i)
{
    if (s->kind != SHAPE_RIGID && kind == LEAVES_VERTEX)
        return (leaf_feature){ 1, { i, 0, 0 } };
    if (s->kind == SHAPE_ROPE)
        return (leaf_feature){ 2, { s->stick[i].a, s->stick[i].b, 0 } };
    const int *v = &s->face[3 * i];
    return (leaf_feature){ 3, { v[0], v[1], v[2] } };
}

// Particles of a deformable body are balls of 0.55 of its spacing: where two
// sheets lie on each other, no diagonal of one can then pass between the
// particles of the other, which are 1.1 spacings away.
static real body_thickness(const shape *s, const world_options *o)
{
    if (s->kind == SHAPE_RIGID) return o->skin * s->radius;
    return o->leaves == LEAVES_VERTEX ? 0.55 * s->spacing : 0;
}

// How far a rigid body may be strained and still lie in the balls around it:
// twice the strain that the paper's relaxation leaves.
static const real SLACK = 0.02;

static status build_tree(body *b, leaves_kind kind, const vec3 *at)
{
    const shape *s = b->plan;
    int n = leaf_count(s, kind);

    leaf_feature *leaf = malloc((size_t)n * sizeof *leaf);
    if (!leaf) return status_out_of_memory();
    for (int i = 0; i < n; i++) leaf[i] = leaf_number(s, kind, i);
    status done = sphere_tree_build(&b->tree,
        s->kind == SHAPE_RIGID ? TREE_WRAPPED : TREE_LAYERED,
        at, leaf, n, b->thickness, SLACK);
    free(leaf);
    return done;
}
//<

//> world-place
static vec3 placed(const placement *where, vec3 r)
{
    return vec3_add(vec3_scale(r.x, where->x),
           vec3_add(vec3_scale(r.y, where->y), vec3_scale(r.z, where->z)));
}

// The particles of plan s, each with the velocity of a body that turns about
// its centre of mass, appended to the pool.
static void place_particles(world *w, const shape *s, const placement *where)
{
    const vec3 still = { 0, 0, 0 };
    real h = w->options.dt / w->options.substeps;
    for (int i = 0; i < s->particles; i++) {
        vec3 r = placed(where, s->at[i]);
        vec3 x = vec3_add(where->position, r);
        vec3 v = vec3_add(where->velocity, vec3_cross(where->spin, r));
        pool_add(&w->pool, where->nailed
            ? particle_start(x, still, still, 0, h)
            : particle_start(x, v, w->options.gravity, 1 / s->mass[i], h));
    }
}

static int placement_is_sound(const placement *p)
{
    return vec3_is_finite(p->position) && vec3_is_finite(p->velocity)
        && vec3_is_finite(p->spin)
        && vec3_distance(vec3_cross(p->x, p->y), p->z) < 1e-6
        && fabs(vec3_length(p->x) - 1) < 1e-6
        && fabs(vec3_length(p->y) - 1) < 1e-6
        && fabs(vec3_dot(p->x, p->y)) < 1e-6;
}
//<

//> world-add
// Grows an array that is only added to; doubles, so that adding n elements
// copies O(n) of them.
static void *grown(void *old, int count, size_t size)
{
    int is_full = count == 0 || (count & (count - 1)) == 0;
    if (!is_full) return old;
    return realloc(old, (size_t)(count > 0 ? 2 * count : 1) * size);
}

// The number of plan s among those in use, entered if it is new; -1: no memory.
static int find_plan(world *w, const shape *s)
{
    for (int k = 0; k < w->plans; k++)
        if (w->plan[k].shape == s) return k;
    plan_order *more = grown(w->plan, w->plans, sizeof *more);
    if (!more) return -1;
    w->plan = more;
    w->plan[w->plans] = (plan_order){ .shape = s };
    return w->plans++;
}

static status reserve_body(world *w, const shape *s)
{
    body *more = grown(w->body, w->bodies, sizeof *more);
    if (!more || find_plan(w, s) < 0) {
        if (more) w->body = more;
        return status_out_of_memory();
    }
    w->body = more;
    int need = w->pool.count + s->particles;
    if (need <= w->pool.capacity) return status_ok();
    return pool_reserve(&w->pool, 2 * need);
}

status world_add(world *w, const shape *s, placement where, int *number)
{
    assert(!w->ready && s->particles > 0);
    if (!placement_is_sound(&where))
        return status_fail("body %d is placed at numbers that are not finite, "
                           "or on axes that are not perpendicular units",
                           w->bodies);
    status done = reserve_body(w, s);
    if (!done.ok) return done;

    body b = { .plan = s, .first = w->pool.count, .mass = HUGE_VAL };
    real mass = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    if (!where.nailed) b.mass = mass;
    b.thickness = body_thickness(s, &w->options);
    done = build_tree(&b, w->options.leaves, s->at);
    if (!done.ok) return done;

    place_particles(w, s, &where);
    w->softs += body_is_soft(&b);
    if (number) *number = w->bodies;
    w->body[w->bodies++] = b;
    return status_ok();
}
//<

//> world-size
// Room enough for what can touch at once; what finds no room is counted in the
// report.  A ball touches at most 12 of its own size, which makes 6 pairs a
// body: twice that, for a look ahead reaches further (below 24 bodies, all
// pairs are fewer).  Not all of them touch face on face, in 8 points; 4 in the
// mean are room enough.
// A particle of a cloth folded on itself has 12 in touch as well, most of them
// its neighbours at rest, but the lists look further: 24 a particle.  And it is
// near 4 rigid bodies at most, where they lie together.
static void size_lists(world *w)
{
    int rigid = 0, soft = 0;
    for (int b = 0; b < w->bodies; b++) {
        if (body_is_soft(&w->body[b])) soft += w->body[b].plan->particles;
        else                           rigid++;
    }
    int all_pairs = rigid < 24 ? rigid * (rigid - 1) / 2 : 12 * rigid;
    w->pair_capacity = all_pairs;
    w->contact_capacity = (rigid < 24 ? PAIR_CONTACTS : 4) * all_pairs
                        + w->planes * w->pool.count;
    w->near_capacity  = 24 * soft;
    w->leaf_capacity  = 24 * soft;
    w->point_capacity = 4 * soft;
    // A wide margin makes long lists, a narrow one makes them often.  With 0.6
    // of a spacing a flat cloth still has none: what stands at two spacings is
    // further than the 1.1 of touching and the margin.
    w->list_margin = HUGE_VAL;
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b]))
            w->list_margin = fmin(w->list_margin,
                                  0.6 * w->body[b].plan->spacing);
}

static size_t at_least_one(int n)
{
    return n > 0 ? (size_t)n : 1;
}

static int size_particles(particle_tables *t, const particle_pool *pool)
{
    size_t n = at_least_one(pool->count);
    t->at     = malloc(n * sizeof *t->at);
    t->start  = malloc(n * sizeof *t->start);
    t->before = malloc(n * sizeof *t->before);
    t->listed = malloc(n * sizeof *t->listed);
    t->inverse_mass = malloc(n * sizeof *t->inverse_mass);
    if (!t->at || !t->start || !t->before || !t->listed
        || !t->inverse_mass) return 0;
    for (int i = 0; i < pool->count; i++) {
        t->at[i] = t->start[i] = t->listed[i] = pool->at[i].position;
        t->inverse_mass[i] = pool->at[i].inverse_mass;
    }
    return 1;
}

static int size_buffers(world *w)
{
    int faces = 0, sticks = 0, leaves = 0;
    for (int k = 0; k < w->plans; k++) {
        const shape *s = w->plan[k].shape;
        if (s->mesh.faces > faces) faces = s->mesh.faces;
        if (s->sticks > sticks) sticks = s->sticks;
    }
    for (int b = 0; b < w->bodies; b++)
        if (w->body[b].tree.leaves > leaves) leaves = w->body[b].tree.leaves;
    size_t pairs = at_least_one(w->pair_capacity);
    size_t contacts = at_least_one(w->contact_capacity);
    w->pair      = malloc(pairs * sizeof *w->pair);
    w->old_pair  = malloc(pairs * sizeof *w->old_pair);
    w->contact   = malloc(contacts * sizeof *w->contact);
    w->between   = malloc(contacts * sizeof *w->between);
    w->near      = malloc(at_least_one(w->near_capacity) * sizeof *w->near);
    w->point     = malloc(at_least_one(w->point_capacity) * sizeof *w->point);
    w->leaf_pair = malloc(at_least_one(w->leaf_capacity)
                          * sizeof *w->leaf_pair);
    w->leaf_met  = calloc(at_least_one(leaves), sizeof *w->leaf_met);
    w->hull      = malloc(at_least_one(faces) * sizeof *w->hull);
    w->hull_face = malloc(at_least_one(faces) * sizeof *w->hull_face);
    w->slow      = calloc(at_least_one(w->bodies), 1);
    w->collided  = calloc(at_least_one(w->bodies), 1);
    w->ball      = calloc(at_least_one(w->bodies), sizeof *w->ball);
    w->spread    = calloc(at_least_one(w->bodies), sizeof *w->spread);
    w->hit       = hit_scratch_new();
    w->orders    = order_scratch_new(sticks);
    return w->pair && w->old_pair && w->contact && w->between && w->near
        && w->point && w->leaf_pair && w->leaf_met && w->hull && w->hull_face
        && w->slow && w->collided && w->ball && w->spread && w->hit
        && w->orders;
}
//<

//> world-begin
// The lists of section 6.2, for the rigid plans alone: they grow as particles
// times sticks, and only rigid bodies are relaxed by them.
static status build_lists(world *w)
{
    order_kind order = w->options.order;
    for (int k = 0; k < w->plans && order != ORDER_LISTED; k++) {
        const shape *s = w->plan[k].shape;
        if (s->kind != SHAPE_RIGID) continue;
        status done = stick_lists_build(&w->plan[k].lists, s->stick, s->sticks,
                                        s->particles, order == ORDER_REPEATED);
        if (!done.ok) return done;
    }
    return status_ok();
}

status world_begin(world *w)
{
    assert(!w->ready);
    size_lists(w);
    if (!size_particles(&w->of, &w->pool) || !size_buffers(w))
        return status_out_of_memory();
    // The trees were built to the plans; now they stand where the bodies do.
    for (int b = 0; b < w->bodies; b++)
        sphere_tree_refresh(&w->body[b].tree, w->of.at + w->body[b].first);
    status done = build_lists(w);
    if (done.ok) done = rest_init(&w->rest, w->bodies);
    w->ready = done.ok;
    return done;
}
//<

//> world-free
void world_free(world *w)
{
    for (int b = 0; b < w->bodies; b++) sphere_tree_free(&w->body[b].tree);
    for (int k = 0; k < w->plans; k++) stick_lists_free(&w->plan[k].lists);
    void *owned[] = { w->body, w->plan, w->of.at, w->of.start, w->of.before,
        w->of.listed, w->of.inverse_mass, w->pair, w->old_pair,
        w->contact, w->between, w->near, w->point, w->leaf_pair, w->leaf_met,
        w->hull, w->hull_face, w->slow, w->collided, w->ball, w->spread };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    pool_free(&w->pool);
    hit_scratch_free(w->hit);
    order_scratch_free(w->orders);
    rest_free(&w->rest);
    *w = (world){ .hull_of = -1 };
}
//<

//> world-look
collider world_collider(const world *w, const body *b)
{
    return (collider){ b->plan, b->first, w->of.at + b->first, b->mass };
}

void world_look(world *w, const body *b)
{
    int end = b->first + b->plan->particles;
    for (int i = b->first; i < end; i++)
        w->of.at[i] = w->pool.at[i].position;
}

void world_look_again(world *w, body *b)
{
    world_look(w, b);
    sphere_tree_refresh(&b->tree, w->of.at + b->first);
}
//<
