//> world-options
#include "world.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

world_options world_options_default(void)
{
    return (world_options){
        .dt = 1.0 / 60, .substeps = 8, .most_substeps = 200,
        .gravity = { 0, -9.81, 0 },
        .friction = 0.5, .restitution = 0,
        .hertz = 1000, .stay = 0.03, .warm_start = true,
        .sleep_speed = 0.005, .time_to_sleep = 0.5,
        .iterations = 6,
        .relax = { ROOT_EXACT, GRADIENT_OLD, 1e-9, 0 },
    };
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
        { "dt",            o->dt,              1e-9, 1 },
        { "substeps",      o->substeps,        1, 10000 },
        { "most_substeps", o->most_substeps,   1, 10000 },
        { "friction",      o->friction,        0, 1000 },
        { "restitution",   o->restitution,     0, 1 },
        { "hertz",         o->hertz,           1e-3, 1e6 },
        { "stay",          o->stay,            0, 0.1 },
        { "sleep_speed",   o->sleep_speed,     0, 1e9 },
        { "time_to_sleep", o->time_to_sleep,   0, 1e9 },
        { "iterations",    o->iterations,      1, 10000 },
        { "tolerance",     o->relax.tolerance, 0, 1 },
        { "root",          o->relax.root,      0, ROOT_APPROXIMATE },
        { "gradient",      o->relax.gradient,  0, GRADIENT_OLD },
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
status world_init(world *w, world_options options)
{
    *w = (world){ .options = options,
                  .age = options.dt / options.substeps };
    pool_init(&w->pool);
    return check_options(&options);
}

status world_add_plane(world *w, vec3 normal, real offset)
{
    real length = vec3_length(normal);
    assert(!w->is_ready);
    if (w->planes == PLANES)
        return status_fail("a world has room for %d planes", PLANES);
    real away = offset / length;
    if (!(length > 0) || !(length < HUGE_VAL) || !(away - away == 0))
        return status_fail("plane %d has no finite normal and offset",
                           w->planes);
    w->plane[w->planes++] = (plane){ vec3_scale(1 / length, normal),
                                     away };
    return status_ok();
}

void world_pin(world *w, int b, int i)
{
    assert(!w->is_ready && b >= 0 && b < w->bodies);
    assert(i >= 0 && i < body_particles(&w->body[b]));
    assert(body_is_soft(&w->body[b]));
    particle *p = &w->pool.at[w->body[b].first + i];
    p->inverse_mass = 0;
    p->previous = p->position;
}

status world_bend(world *w, int b, real stiffness)
{
    assert(b >= 0 && b < w->bodies && body_is_soft(&w->body[b]));
    if (!(stiffness >= 0) || !(stiffness < HUGE_VAL))
        return status_fail("the stiffness of body %d is %g; it must be finite, "
                           "and 0 or more", b, stiffness);
    w->body[b].bending = stiffness;
    return status_ok();
}
//<

//> world-radius
// Particles of deformable bodies are balls of 0.55 of its spacing: where two
// sheets lie on each other, no diagonal of one can then pass between the
// particles of the other, which are 1.1 spacings away.
static real particle_radius(const shape *s)
{
    return s->kind == SHAPE_RIGID ? 0 : 0.55 * s->spacing;
}
//<

//> world-place
static vec3 placed(const placement *where, vec3 r)
{
    return vec3_add(vec3_scale(r.x, where->x),
           vec3_add(vec3_scale(r.y, where->y), vec3_scale(r.z, where->z)));
}

// A particle of a body, at `at` in the body's frame, with the velocity of one
// that turns about its centre of mass, appended to the pool.
static void place_particle(world *w, const placement *where, vec3 at,
                           vec3 center, real mass)
{
    const vec3 still = { 0, 0, 0 };
    real h = w->age;
    vec3 x = vec3_add(where->position, placed(where, at));
    vec3 r = placed(where, vec3_sub(at, center));
    vec3 v = vec3_add(where->velocity, vec3_cross(where->spin, r));
    pool_add(&w->pool, where->is_static
        ? particle_start(x, still, still, 0, h)
        : particle_start(x, v, w->options.gravity, 1 / mass, h));
}

static void place_particles(world *w, const body *b, const placement *where)
{
    const vec3 origin = { 0, 0, 0 };
    const shape *s = b->shape;
    const rigid4 *f = b->rigid;
    for (int i = 0; i < body_particles(b); i++) {
        if (f) place_particle(w, where, f->at[i], f->center, f->mass);
        else   place_particle(w, where, s->at[i], origin, s->mass[i]);
    }
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

// The four particles of the rigid shape s.
static status make_rigid(const shape *s, rigid4 **f)
{
    *f = malloc(sizeof **f);
    if (!*f) return status_out_of_memory();
    status done = rigid4_build(*f, s);
    if (!done.ok) {
        free(*f);
        *f = NULL;
    }
    return done;
}

// Enters shape s among those in use, if it is new; its number in *number.
static status enter_shape(world *w, const shape *s, int *number)
{
    for (*number = w->shapes - 1; *number >= 0; (*number)--)
        if (w->shape[*number].shape == s) return status_ok();
    *number = w->shapes;
    shape_entry *more = grown(w->shape, w->shapes, sizeof *more);
    if (!more) return status_out_of_memory();
    w->shape = more;
    shape_entry entry = { .shape = s };
    status done = status_ok();
    if (s->kind == SHAPE_RIGID) {
        entry.inner = shape_inner(s);
        done = make_rigid(s, &entry.rigid);
    } else {
        entry.line = line_scratch_new(s);
        if (!entry.line) done = status_out_of_memory();
    }
    if (done.ok) w->shape[w->shapes++] = entry;
    return done;
}

static status reserve_body(world *w, const shape *s, int *number)
{
    body *more = grown(w->body, w->bodies, sizeof *more);
    if (!more) return status_out_of_memory();
    w->body = more;
    status done = enter_shape(w, s, number);
    int need = w->pool.count + int_max(s->particles, FOUR);
    if (!done.ok || need <= w->pool.capacity) return done;
    return pool_reserve(&w->pool, 2 * need);
}

status world_add(world *w, const shape *s, placement where, int *number)
{
    assert(!w->is_ready && s->particles > 0);
    int entry = 0;
    status done = placement_check(&where, s, w->bodies);
    if (done.ok) done = reserve_body(w, s, &entry);
    if (!done.ok) return done;

    body b = { .shape = s, .rigid = w->shape[entry].rigid,
               .line = w->shape[entry].line,
               .inner = w->shape[entry].inner, .first = w->pool.count,
               .mass = HUGE_VAL, .thickness = particle_radius(s) };
    real mass = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    if (!where.is_static) b.mass = mass;

    place_particles(w, &b, &where);
    w->softs += body_is_soft(&b);
    w->dynamic_bodies += !body_is_static(&b);
    if (number) *number = w->bodies;
    w->body[w->bodies++] = b;
    return status_ok();
}
//<

//> world-size-rigid
// Where a static body stands never changes; neither does what kind a body is.
static void begin_body(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    const body *x = &w->body[b];
    t->now[b] = (solver_body){ .radius = -1 };
    t->ball[b] = (sphere){ { 0, 0, 0 }, -1 };
    t->ahead[b] = (prediction){ .reach = 0 };
    t->reach[b] = 0;
    t->moves[b] = 0;
    if (body_is_soft(x)) return;
    t->dynamic[b] = !body_is_static(x);
    if (t->dynamic[b]) {
        t->lightest = real_min(x->mass, t->lightest);
        t->heaviest = real_max(x->mass, t->heaviest);
    }
    t->body[b] = (cache_body){ x->shape, x->rigid, x->inner };
    t->now[b].frame = t->middle[b] = rigid4_frame(w->pool.at + x->first);
    t->now[b].radius = 1.02 * x->rigid->reach;
    t->ball[b] = (sphere){ t->now[b].frame.center, t->now[b].radius };
}

static bool size_rigid(rigid_tables *t, int bodies)
{
    size_t n = (size_t)bodies + 1;
    t->body  = calloc(n, sizeof *t->body);
    t->moves = calloc(n, sizeof *t->moves);
    t->dynamic = calloc(n, sizeof *t->dynamic);
    t->now   = calloc(n, sizeof *t->now);
    t->ball  = calloc(n, sizeof *t->ball);
    t->ahead = calloc(n, sizeof *t->ahead);
    t->middle = calloc(n, sizeof *t->middle);
    t->reach = calloc(n, sizeof *t->reach);
    t->velocity = aligned_alloc(64, n * sizeof *t->velocity);
    t->moved    = aligned_alloc(64, n * sizeof *t->moved);
    t->relaxed  = calloc(n, sizeof *t->relaxed);
    if (!t->body || !t->moves || !t->dynamic || !t->now || !t->ball
        || !t->ahead || !t->middle || !t->reach || !t->velocity || !t->moved
        || !t->relaxed) return false;
    memset(t->velocity, 0, n * sizeof *t->velocity);
    memset(t->moved, 0, n * sizeof *t->moved);
    return true;
}

static status begin_rigid(world *w)
{
    rigid_tables *t = &w->rigid;
    if (!size_rigid(t, w->bodies)) return status_out_of_memory();
    t->lightest = HUGE_VAL;
    t->heaviest = 0;
    for (int b = 0; b < w->bodies; b++) begin_body(w, b);
    status done = pair_list_init(&t->pairs, w->bodies);
    if (done.ok) done = cache_init(&t->cache, t->body, w->bodies, w->planes);
    if (done.ok) done = solver_init(&t->solver, w->bodies);
    return done;
}
//<

//> world-begin
status world_begin(world *w)
{
    assert(!w->is_ready);
    w->inverse_mass = calloc((size_t)w->pool.count + 1,
                             sizeof *w->inverse_mass);
    if (!w->inverse_mass) return status_out_of_memory();
    for (int i = 0; i < w->pool.count; i++)
        w->inverse_mass[i] = w->pool.at[i].inverse_mass;
    status done = begin_rigid(w);
    if (done.ok) done = sleep_init(&w->sleep, w->bodies, w->pool.count);
    if (done.ok) done = soft_init(&w->soft, w->body, w->bodies, w->pool.count);
    w->is_ready = done.ok;
    return done;
}
//<

//> world-free
static void free_shape(shape_entry *e)
{
    line_scratch_free(e->line);
    if (e->rigid) rigid4_free(e->rigid);
    free(e->rigid);
}

void world_free(world *w)
{
    rigid_tables *r = &w->rigid;
    for (int k = 0; k < w->shapes; k++) free_shape(&w->shape[k]);
    void *owned[] = { w->body, w->shape, w->inverse_mass,
        r->body, r->moves, r->dynamic, r->now, r->ball, r->ahead, r->middle,
        r->reach, r->velocity, r->moved, r->relaxed };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    pair_list_free(&r->pairs);
    cache_free(&r->cache);
    solver_free(&r->solver);
    pool_free(&w->pool);
    sleep_free(&w->sleep);
    soft_free(&w->soft);
    *w = (world){ .bodies = 0 };
}
//<

//> world-vertices
void world_vertices(const world *w, const body *b, vec3 *at)
{
    const particle *p = w->pool.at + b->first;
    if (b->rigid) {
        rigid_frame frame = rigid4_frame(p);
        rigid4_ride(b->rigid, &frame, at, b->shape->particles);
        return;
    }
    for (int i = 0; i < b->shape->particles; i++) at[i] = p[i].position;
}

void world_skin(const world *w, const body *b, vec3 *at)
{
    const struct skin *k = &b->shape->skin;
    if (k->points == 0) {
        world_vertices(w, b, at);
        return;
    }
    rigid_frame frame = rigid4_frame(w->pool.at + b->first);
    for (int i = 0; i < k->points; i++)
        at[i] = frame_point(&frame, rigid4_local(b->rigid, k->at[i]));
}
//<

//> world-wake
// Wakes b and all that sleep with it.
static void rouse(world *w, int b)
{
    sleep_wake(&w->sleep, b);
    for (int k = 0; k < w->bodies; k++) {
        const body *x = &w->body[k];
        if (w->sleep.asleep[k]) continue;
        for (int i = x->first; i < x->first + body_particles(x); i++)
            w->pool.at[i].inverse_mass = w->inverse_mass[i];
    }
    w->soft.near.trusted = -1;
}

bool world_wake_near(world *w, int a, int b)
{
    int sleeper = w->sleep.asleep[a] ? a : b, other = a + b - sleeper;
    if (!w->sleep.asleep[sleeper] || w->sleep.asleep[other]) return false;
    if (body_is_static(&w->body[sleeper])) return false;
    if (!sleep_is_moving(&w->sleep, other)) return false;
    rouse(w, sleeper);
    return true;
}
//<
