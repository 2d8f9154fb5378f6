//> world-options
//>   The defaults are those of a scene in metres on Earth at sixty frames a
//>   second.
#include "world.h"
#include "table.h"
#include "weight.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

world_options world_options_default(void)
{
    return (world_options){
        .dt = 1.0 / 60, .most_substeps = 200,
        .gravity = { 0, -9.81, 0 },
        .friction = 0.5, .restitution = 0,
        // The most that may be chosen: as stiff as a substep bears (solver-pass).
        .hertz = 1e6,
        // Vertices move by so much before they are placed again.
        .stay = 0.03,               // tuned, radii
        .warm_start = true,
        // What an eye does not see move, and for so long.
        .sleep_speed = 0.005,       // tuned, m/s
        .time_to_sleep = 0.5,       // tuned, s
        .certified = true,
        // Columns and rows of a cloth are solved in turn.
        .iterations = 40,           // tuned, iterations
        .relax = { ROOT_EXACT, GRADIENT_OLD, 1e-9, 0 },
    };
}

int world_substeps(const world_options *o)
{
    // At 60 frames a second a heap stands on four, and they are no longer than that.
    enum { FEWEST = 4 };                    // tuned, substeps
    const real rate = 240;                  // tuned, 1/s
    const real rounding = 1e-9;
    if (o->substeps > 0 || !(o->dt > 0 && o->dt <= 1)) return o->substeps;
    return int_max(FEWEST, (int)(rate * o->dt - rounding) + 1);
}

int world_usual(const world *w, bool is_stiff)
{
    // Rope, what lies on cloth, and joints are stiffer than contacts.
    enum { SOFT = 8 };                      // tuned, substeps
    int n = w->options.substeps;
    bool is_part = w->frame < w->options.dt;
    return (is_stiff || is_part) && !w->has_substeps ? int_max(SOFT, n) : n;
}
//<

//> world-check
//>   Options are checked once, so that no step needs to doubt them.
// Names the first option that is out of its range (NaN is out of every range).
static status check_world_options(const world_options *o)
{
    struct { const char *name; real value, least, most; } rule[] = {
        { "dt",            o->dt,              1e-9, 1 },
        { "substeps",      o->substeps,        0, ALL_SUBSTEPS },
        { "most_substeps", o->most_substeps,   1, ALL_SUBSTEPS },
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
    for (size_t k = 0; k < sizeof rule / sizeof *rule; k++)
        if (!(rule[k].value >= rule[k].least && rule[k].value <= rule[k].most))
            return status_fail("%s is %g; it must lie between %g and %g",
                               rule[k].name, rule[k].value, rule[k].least,
                               rule[k].most);
    return vec3_is_finite(o->gravity) ? status_ok()
                                      : status_fail("gravity is not finite");
}
//<

//> world-init
//>   A world begins empty. A table grows when the first thing comes that needs
//>   it.
status world_init(world *w, world_options options)
{
    *w = (world){ .options = options };
    pool_init(&w->pool);
    w->rigid.cache.free_entry = -1;
    w->has_substeps = options.substeps > 0;
    w->options.substeps = world_substeps(&options);
    w->age = options.dt / w->options.substeps;
    w->most_gravity = 1;
    return check_world_options(&options);
}

// The world's own.
static material material_of(const world *w)
{
    return (material){ w->options.friction, w->options.restitution };
}

static const plane NO_PLANE = { { 0, 1, 0 }, -1e300 };

bool world_has_plane(const world *w, int k)
{
    assert(k >= 0 && k < w->planes);
    return w->plane[k].offset > NO_PLANE.offset;
}

int world_next_plane(const world *w)
{
    int k = 0;
    while (k < w->planes && world_has_plane(w, k)) k++;
    return k;
}

// Plane k is another one now.
static void set_plane(world *w, int k, plane p)
{
    w->plane[k] = p;
    w->wall[k] = material_of(w);
    pair_list_renew(&w->rigid.pairs, -1);
    soft_doubt(&w->soft);
    for (int b = 0; b < w->bodies; b++) world_wake(w, b);
}

status world_add_plane(world *w, vec3 normal, real offset)
{
    real length = vec3_length(normal), away = offset / length;
    int k = world_next_plane(w);
    if (!(length > 0) || !(length < HUGE_VAL) || !(fabs(away) <= 1e60))
        return status_fail("a plane needs a finite normal, and an offset of at "
                           "most 1e60 m, as corners do");
    if (!TABLE_ADD(w->plane, k, w->plane_room)
        || !TABLE_ADD(w->wall, k, w->wall_room)) return status_out_of_memory();
    w->planes += k == w->planes;
    set_plane(w, k, (plane){ vec3_scale(1 / length, normal), away });
    return status_ok();
}

void world_remove_plane(world *w, int k)
{
    assert(world_has_plane(w, k));
    cache_forget_plane(&w->rigid.cache, k);
    set_plane(w, k, NO_PLANE);
}

particle *world_particle(world *w, int b, int i)
{
    assert(b >= 0 && b < w->bodies && body_is_soft(&w->body[b]));
    assert(i >= 0 && i < body_particles(&w->body[b]));
    world_wake(w, b);
    return &w->pool.at[w->body[b].first + i];
}

void world_pin(world *w, int b, int i)
{
    particle *p = world_particle(w, b, i);
    p->inverse_mass = w->inverse_mass[w->body[b].first + i] = 0;
    p->previous = p->position;
}

void world_unpin(world *w, int b, int i)
{
    particle *p = world_particle(w, b, i);
    const body *x = &w->body[b];
    real inverse = body_is_static(x) ? 0 : 1 / x->shape->mass[i];
    p->inverse_mass = w->inverse_mass[x->first + i] = inverse;
}

// It may lie otherwise with another number, so it wakes.
static status set_number(world *w, int b, const char *name, real value,
                         real *number)
{
    if (!(value >= 0) || !(value < HUGE_VAL))
        return status_fail("the %s of a body is %g; it must be finite, and 0 or "
                           "more", name, value);
    world_wake(w, b);
    *number = value;
    return status_ok();
}

status world_bend(world *w, int b, real stiffness)
{
    assert(b >= 0 && b < w->bodies && body_is_soft(&w->body[b]));
    return set_number(w, b, "stiffness", stiffness, &w->body[b].bending);
}

status world_stretch(world *w, int b, real compliance)
{
    assert(b >= 0 && b < w->bodies && body_is_soft(&w->body[b]));
    return set_number(w, b, "compliance", compliance, &w->body[b].compliance);
}

// A pinned cloth becomes longer by this share under its own weight, if nothing else
// is said.  (Threads that give by nothing never rest.  With five times as much a
// spike thrown at 10 m/s cuts a cell.)
static const real TAUT = 4e-6;              // tuned, 1

real world_taut(const world *w, const body *b)
{
    real weight = b->mass * vec3_length(w->options.gravity);
    if (shape_directions(b->shape) < 2 || !(weight > 0)) return 0;
    return TAUT * shape_width(b->shape, 0) / weight;
}
//<

//> world-radius
//>   A particle of a cloth has a ball around it (chapter 16).
// Particles of deformable bodies are balls of 0.55 of its spacing: where two
// sheets lie on each other, no diagonal of one can then pass between the
// particles of the other, which are 1.1 spacings away.
static const real BALL = 0.55;              // tuned, spacings

static real particle_radius(const shape *s)
{
    return s->kind == SHAPE_RIGID ? 0 : BALL * s->spacing;
}
//<

//> world-place
//>   A body is placed by moving its shape's particles. Verlet's previous
//>   positions carry the velocity, half a substep old.
// A particle of a body, at `at` in the body's frame, with the velocity of one
// that turns about its centre of mass.
static particle placed_particle(const world *w, const placement *where,
                                vec3 at, vec3 center, real mass, vec3 gravity)
{
    const vec3 still = { 0, 0, 0 };
    real h = w->age;
    vec3 x = vec3_add(where->position, placement_vector(where, at));
    vec3 r = placement_vector(where, vec3_sub(at, center));
    vec3 v = vec3_add(where->velocity, vec3_cross(where->spin, r));
    if (where->is_static) return particle_start(x, still, still, 0, h);
    return particle_start(x, v, gravity, 1 / mass, h);
}

static void place_particles(world *w, const body *b, const placement *where)
{
    const vec3 origin = { 0, 0, 0 };
    const shape *s = b->shape;
    const rigid4 *f = b->rigid;
    vec3 g = body_gravity(w, (int)(b - w->body));
    w->rigid.age[b - w->body] = w->age;
    for (int i = 0; i < body_particles(b); i++) {
        particle *p = &w->pool.at[b->first + i];
        if (f) *p = placed_particle(w, where, f->at[i], f->center, f->mass, g);
        else   *p = placed_particle(w, where, s->at[i], origin, s->mass[i], g);
    }
}
//<

//> world-wake
//>   A body that does not move wakes nothing, or two piles that lean on each
//>   other would wake each other for ever.
void world_notice(world *w, int b)
{
    w->rigid.is_awake[b] = true;
    w->rigid.has_noticed = true;
    for (int k = w->body[b].next; k > 0; k = w->body[k - 1].next)
        w->rigid.is_awake[k - 1] = true;
}

void world_wake(world *w, int b)
{
    assert(b >= 0 && b < w->bodies);
    if (!w->sleep.asleep[b]) return;
    int k = b;
    do {
        const body *x = &w->body[k];
        for (int i = x->first; i < x->first + body_particles(x); i++)
            w->pool.at[i].inverse_mass = w->inverse_mass[i];
        world_notice(w, k);
        k = w->sleep.next[k];
    } while (k != b);
    sleep_wake(&w->sleep, b);
    w->soft.near.is_stale = true;
    w->is_still = false;
}

void world_pin_sleeper(world *w, int b)
{
    const body *x = &w->body[b];
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        particle *p = &w->pool.at[i];
        p->inverse_mass = 0;
        p->previous = p->position;
    }
}

int world_sleeper_near(const world *w, int a, int b)
{
    int sleeper = w->sleep.asleep[a] ? a : b, other = a + b - sleeper;
    if (!w->sleep.asleep[sleeper] || w->sleep.asleep[other]) return -1;
    if (body_is_static(&w->body[sleeper])) return -1;
    bool comes = w->body[other].is_kinematic
               ? body_is_driven(w, other)
               : body_is_dynamic(&w->body[other])
                 && sleep_is_moving(&w->sleep, other);
    return comes ? sleeper : -1;
}

bool world_wake_near(world *w, int a, int b)
{
    int sleeper = world_sleeper_near(w, a, b);
    if (sleeper >= 0) world_wake(w, sleeper);
    return sleeper >= 0;
}

sphere world_ball(const world *w, int b)
{
    const body *x = &w->body[b];
    const particle *p = w->pool.at + x->first;
    int n = body_particles(x);
    sphere s = { { 0, 0, 0 }, 0 };
    if (!body_is_soft(x)) return w->rigid.ball[b];
    for (int i = 0; i < n; i++)
        s.center = vec3_add_scaled(s.center, 1.0 / n, p[i].position);
    for (int i = 0; i < n; i++)
        s.radius = real_max(vec3_distance(s.center, p[i].position), s.radius);
    s.radius += 2 * x->thickness;
    return s;
}

// What hangs on b is near it.
static void wake_joined(world *w, int b)
{
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        if (j->kind == JOINT_NONE || (j->a != b && j->b != b)) continue;
        int other = j->a + j->b - b;
        if (other >= 0) world_wake(w, other);
    }
}

void world_wake_around(world *w, int b)
{
    sphere own = world_ball(w, b);
    world_wake(w, b);
    if (w->sleep.sleepers == 0) return;
    wake_joined(w, b);
    for (int k = 0; k < w->bodies; k++) {
        if (!w->sleep.asleep[k]) continue;
        sphere other = world_ball(w, k);
        if (vec3_distance(own.center, other.center)
            <= own.radius + other.radius) world_wake(w, k);
    }
}
//<

//> world-shape
//>   What follows from a shape alone is computed once a shape.
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

// Enters shape s among those in use, if it is new; its number in *number.  The shape
// of a part is always new, and there may be many, so it is not sought.
static status enter_shape(world *w, const shape *s, bool is_part, int *number)
{
    for (int k = 0; k < w->shapes && !is_part; k++) {
        *number = k;
        if (w->shape[k].bodies > 0 && w->shape[k].shape == s) return status_ok();
    }
    while (w->free_entry < w->shapes && w->shape[w->free_entry].bodies > 0)
        w->free_entry++;
    int place = w->free_entry;
    if (!TABLE_ADD(w->shape, place, w->shape_room)) return status_out_of_memory();
    shape_entry entry = { .shape = s };
    status done = status_ok();
    if (s->kind == SHAPE_RIGID) {
        entry.inner = shape_inner(s);
        done = make_rigid(s, &entry.rigid);
    } else {
        entry.line = line_scratch_new(s);
        if (!entry.line) done = status_out_of_memory();
    }
    *number = place;
    if (done.ok) w->shape[place] = entry;
    w->shapes += done.ok && place == w->shapes;
    return done;
}

static void free_shape(shape_entry *e)
{
    line_scratch_free(e->line);
    if (e->rigid) rigid4_free(e->rigid);
    free(e->rigid);
    *e = (shape_entry){ .bodies = 0 };
}
//<

//> world-room
//>   Room for what comes: tables grow between frames.
static bool grow_rigid(rigid_tables *t, int old, int room)
{
    bool ok = true;
#define GROW(table) TABLE_GROW(ok, t->table, old, room);
    RIGID_TABLES(GROW, GROW, GROW)
#undef GROW
    for (int b = old; b < room && ok; b++) t->ball[b].radius = -1;
    return ok;
}

static bool grow_motions(rigid_tables *t, int motions)
{
    bool ok = true;
    if (motions <= t->motions) return true;
    TABLE_GROW_ALIGNED(ok, t->velocity, t->motions, motions);
    TABLE_GROW_ALIGNED(ok, t->moved, t->motions, motions);
    if (ok) t->motions = motions;
    return ok;
}

static bool grow_tables(world *w, int bodies)
{
    int room = table_room(bodies, w->room);
    bool ok = true;
    if (bodies <= w->room) return true;
    TABLE_GROW(ok, w->body, w->bodies, room);
    w->rigid.body = w->body;
    ok = ok && grow_rigid(&w->rigid, w->bodies, room);
    if (ok) w->room = room;
    return ok;
}

static bool grow_pool(world *w, int particles)
{
    int was = w->pool.capacity, more = 2 * particles;
    if (particles <= was) return true;
    bool ok = true;
    TABLE_GROW(ok, w->inverse_mass, w->pool.count, more);
    TABLE_GROW(ok, w->owner, w->pool.count, more);
    return ok && pool_reserve(&w->pool, more).ok;
}

// For one more body, with so many more particles.
static bool make_world_room(world *w, int bodies, int particles)
{
    rigid_tables *t = &w->rigid;
    return grow_tables(w, bodies) && grow_pool(w, particles)
        && sleep_grow(&w->sleep, bodies, particles)
        && pair_list_grow(&t->pairs, bodies) && solver_grow(&t->solver, bodies)
        && grow_motions(t, t->solver.room + 1);
}
//<

//> world-start
// What the tables say of body b, which is new there.  Where a static body stands
// never changes; neither does what kind a body is.  Its ball has some room.
static const real SWELLS = 1.02;            // tuned, radii

static void start_body(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    const body *x = &w->body[b];
    t->now[b] = (solver_body){ .radius = -1 };
    t->ball[b] = (sphere){ { 0, 0, 0 }, -1 };
    t->ahead[b] = (prediction){ .reach = 0 };
    t->reach[b] = 0;
    t->moves[b] = t->dynamic[b] = 0;
    t->velocity[b] = t->moved[b] = (motion){ { 0 } };
    t->held[b] = t->going[b] = false;
    t->load[b] = (body_load){ .force = { 0, 0, 0 } };
    pair_list_renew(&t->pairs, b);
    sleep_forget(&w->sleep, b);
    assert(!w->sleep.asleep[b]);
    world_notice(w, b);
    w->is_still = false;
    if (body_is_soft(x)) return;
    t->dynamic[b] = !body_is_fixed(x);
    t->now[b].frame = rigid4_frame(w->pool.at + x->first);
    t->asked[b] = t->began[b] = t->now[b].frame;
    t->now[b].radius = SWELLS * x->rigid->reach;
    t->ball[b] = (sphere){ t->now[b].frame.center, t->now[b].radius };
}

void world_place(world *w, int b, const placement *where)
{
    const body *x = &w->body[b];
    place_particles(w, x, where);
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        particle *p = &w->pool.at[i];
        if (!x->is_kinematic) p->inverse_mass = w->inverse_mass[i];
        if (!(p->inverse_mass > 0)) p->previous = p->position;
    }
    start_body(w, b);
    for (int k = x->next; k > 0; k = w->body[k - 1].next) world_renew(w, k - 1);
}

void world_renew(world *w, int b)
{
    cache_forget(&w->rigid.cache, &b, 1);
    soft_forget(&w->soft, b);
    start_body(w, b);
}
//<

//> world-add
// A free place whose particles are enough, and as few as there are; or a new
// one.  (A piece has no particles, and takes no place that has.)
static int find_place(world *w, int particles)
{
    while (w->free_place < w->bodies && !body_is_gone(&w->body[w->free_place]))
        w->free_place++;
    int best = w->bodies;
    for (int b = w->free_place; b < w->bodies && w->gone > 0; b++) {
        const body *x = &w->body[b];
        if (!body_is_gone(x) || x->room < particles
            || (particles == 0 && x->room > 0)) continue;
        if (best == w->bodies || x->room < w->body[best].room) best = b;
        if (x->room == particles) break;
    }
    return best;
}

static body body_made(const world *w, int entry, const placement *where)
{
    const shape_entry *e = &w->shape[entry];
    const shape *s = e->shape;
    body b = { .shape = s, .rigid = e->rigid, .line = e->line,
               .entry = entry, .inner = e->inner, .mass = HUGE_VAL,
               .round = s->round, .is_weighed = s->own.mass > 0,
               .thickness = particle_radius(s),
               .gravity = 1, .group = 1, .mask = ~0u };
    if (!where->is_static) b.mass = rigid4_mass(s);
    b.taut = world_taut(w, &b);
    return b;
}

// Body x takes the place b.
static status take_place(world *w, int b, body x)
{
    int n = body_rides(&x) ? 0 : body_particles(&x);
    bool is_new = b == w->bodies;
    if (!make_world_room(w, w->bodies + is_new,
                         w->pool.count + (is_new ? n : 0)))
        return status_out_of_memory();
    body was = w->body[b];
    x.first = is_new ? w->pool.count : was.first;
    x.room = is_new ? n : was.room;
    if (body_rides(&x)) x.first = w->body[x.rides - 1].first;
    w->body[b] = x;
    bool fits = cache_add(&w->rigid.cache, b, x.rigid ? x.shape->particles : 0);
    status done = fits ? soft_add(&w->soft, w->body, b, w->bodies + is_new,
                                  w->pool.capacity)
                       : status_out_of_memory();
    w->body[b] = done.ok || is_new ? x : was;
    return done;
}

// Body x, of a shape that was entered, comes at place b.
static status enter_body(world *w, body x, int b)
{
    status done = take_place(w, b, x);
    if (!done.ok) {
        if (w->shape[x.entry].bodies == 0) free_shape(&w->shape[x.entry]);
        return done;
    }
    if (b < w->bodies) w->gone--;
    else               w->bodies++;
    w->shape[x.entry].bodies++;
    w->rigid.material[b] = material_of(w);
    w->rigid.drive[b] = (body_drive){ .velocity = { 0, 0, 0 } };
    w->softs += body_is_soft(&x);
    w->dynamic_bodies += !body_is_static(&x);
    return done;
}

static status put_body(world *w, const shape *s, placement where, bool is_part,
                       int *number)
{
    assert(s->particles > 0);
    int entry = 0;
    status done = placement_check(&where, s, w->bodies);
    if (done.ok) done = enter_shape(w, s, is_part, &entry);
    if (!done.ok) return done;
    body x = body_made(w, entry, &where);
    int n = body_particles(&x);
    int b = find_place(w, n);
    done = enter_body(w, x, b);
    if (!done.ok) return done;
    while (w->pool.count < w->body[b].first + n)
        pool_add(&w->pool, (particle){ .inverse_mass = 0 });
    place_particles(w, &w->body[b], &where);
    for (int i = w->body[b].first; i < w->body[b].first + n; i++) {
        w->inverse_mass[i] = w->pool.at[i].inverse_mass;
        w->owner[i] = b;
    }
    start_body(w, b);
    *number = b;
    return status_ok();
}

status world_add(world *w, const shape *s, placement where, int *number)
{
    int b;
    status done = put_body(w, s, where, false, &b);
    if (!done.ok) return done;
    if (where.is_static) world_wake_around(w, b);
    if (number) *number = b;
    return done;
}

status world_add_part(world *w, const shape *s, vec3 x, int of, int *number)
{
    placement where = placement_at(x);
    where.is_static = true;
    status done = put_body(w, s, where, true, number);
    if (!done.ok) return done;
    w->rigid.material[*number] = w->rigid.material[of];
    w->body[*number].family = w->body[of].family;
    w->body[*number].group = w->body[of].group;
    w->body[*number].mask = w->body[of].mask;
    w->body[*number].is_part = true;
    return done;
}
//<

//> world-add-piece
//>   A body of several pieces is a body of the first, on whose four particles the
//>   others ride.
status world_add_piece(world *w, const shape *s, int of, int *number)
{
    assert(of >= 0 && of < w->bodies && body_is_dynamic(&w->body[of]));
    placement where = placement_at(w->rigid.now[of].frame.center);
    where.is_static = true;
    int entry = 0;
    status done = enter_shape(w, s, true, &entry);
    if (!done.ok) return done;
    body x = body_made(w, entry, &where), *whole = &w->body[of];
    int b = find_place(w, 0), next = whole->next;
    x.rides = of + 1;
    x.round = 0;
    x.next = next;
    done = enter_body(w, x, b);
    if (!done.ok) return done;
    whole = &w->body[of];
    whole->rides = of + 1;
    whole->round = 0;
    whole->next = b + 1;
    w->has_pieces = true;
    start_body(w, b);
    *number = b;
    return done;
}
//<

//> world-remove
//>   A body goes, and all that names it.
const shape WORLD_NOTHING = { .kind = SHAPE_ROPE };

static void leave_shape(world *w, int entry)
{
    if (--w->shape[entry].bodies > 0) return;
    free_shape(&w->shape[entry]);
    w->free_entry = int_min(w->free_entry, entry);
}

static void leave_joints(world *w, int b)
{
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        if (j->kind != JOINT_NONE && (j->a == b || j->b == b))
            linkage_remove(&w->joints, k);
    }
    linkage_untie_body(&w->joints, b);
}

static void leave_whole(world *w, int b)
{
    int *k = &w->body[w->body[b].rides - 1].next;
    while (*k > 0 && *k != b + 1) k = &w->body[*k - 1].next;
    *k = w->body[b].next;
}

// Its place is free now.
static void leave(world *w, int b)
{
    body x = w->body[b];
    if (body_rides(&x)) leave_whole(w, b);
    soft_remove(&w->soft, w->body, b);
    leave_shape(w, x.entry);
    w->softs -= body_is_soft(&x);
    w->dynamic_bodies -= body_is_dynamic(&x);
    w->kinematic_bodies -= x.is_kinematic;
    w->body[b] = (body){ .shape = &WORLD_NOTHING, .mass = HUGE_VAL,
                         .first = x.first, .room = x.room };
    for (int i = x.first; i < x.first + x.room; i++) {
        w->pool.at[i] = (particle){ .inverse_mass = 0 };
        w->inverse_mass[i] = 0;
    }
    w->gone++;
    w->free_place = int_min(w->free_place, b);
    start_body(w, b);
}

void world_remove(world *w, int b)
{
    assert(b >= 0 && b < w->bodies && !body_is_gone(&w->body[b]));
    world_wake_around(w, b);
    leave_joints(w, b);
    cache_forget(&w->rigid.cache, &b, 1);
    leave(w, b);
}

void world_remove_parts(world *w, const int *part, int n)
{
    cache_forget(&w->rigid.cache, part, n);
    for (int k = 0; k < n; k++) leave(w, part[k]);
}
//<

//> world-free
//>   A world is given back.
void world_free(world *w)
{
    rigid_tables *r = &w->rigid;
    for (int k = 0; k < w->shapes; k++) free_shape(&w->shape[k]);
    void *owned[] = { w->body, w->plane, w->wall, w->shape, w->inverse_mass,
                      w->owner, r->velocity, r->moved, r->heard };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
#define FREE(table) free(r->table);
    RIGID_TABLES(FREE, FREE, FREE)
#undef FREE
    pair_list_free(&r->pairs);
    cache_free(&r->cache);
    solver_free(&r->solver);
    linkage_free(&w->joints);
    pool_free(&w->pool);
    sleep_free(&w->sleep);
    soft_free(&w->soft);
    *w = (world){ .bodies = 0 };
}
//<

//> world-vertices
//>   To draw a body, its vertices are computed from its frame.
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
    rigid_frame now = rigid4_frame(w->pool.at + b->first);
    rigid_frame rest = rigid4_rest(b->rigid);
    for (int i = 0; i < k->points; i++)
        at[i] = frame_point(&now, frame_local(&rest, vec3_sub(k->at[i],
                                                              rest.center)));
}
//<
