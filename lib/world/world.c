//> world-options
#include "world.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

world_options world_options_default(void)
{
    world_options o = {
        .dt = 1.0 / 60, .substeps = 4, .least_substeps = 2,
        .most_substeps = 1000, .sweeps = 6,
        .gravity = { 0, -9.81, 0 },
        .relax = { ROOT_EXACT, GRADIENT_OLD, 1e-9, 0 },
        .friction = 0.5, .restitution = 0,
        .passes = 4, .content = 1e-7, .memory = 1,
        .mend = 0.2, .mend_speed = 2.5,
        .skin = 0.005, .stay = 0.001,
        .resting = 1,
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
        { "least_substeps", o->least_substeps,    1, 10000 },
        { "most_substeps", o->most_substeps,      1, 10000 },
        { "sweeps",      o->sweeps,               1, 10000 },
        { "tolerance",   o->relax.tolerance,      0, 1 },
        { "passes",      o->passes,               1, 1000 },
        { "content",     o->content,              0, 1 },
        { "mend",        o->mend,                 0, 1 },
        { "mend_speed",  o->mend_speed,           0, 1e9 },
        { "skin",        o->skin,                 0, 1 },
        { "stay",        o->stay,                 0, 0.01 },
        { "friction",    o->friction,             0, 1000 },
        { "restitution", o->restitution,          0, 1 },
        { "root",        o->relax.root,           0, ROOT_APPROXIMATE },
        { "gradient",    o->relax.gradient,       0, GRADIENT_OLD },
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
    *w = (world){ .options = options, .near = { .trusted = -1 },
                  .hull = { .of = -1 },
                  .age = options.dt / options.substeps };
    pool_init(&w->pool);
    return check_options(&options);
}

status world_add_plane(world *w, vec3 normal, real offset)
{
    real length = vec3_length(normal);
    assert(!w->ready);
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

void world_nail(world *w, int b, int i)
{
    assert(!w->ready && b >= 0 && b < w->bodies);
    assert(i >= 0 && i < body_particles(&w->body[b]));
    assert(body_is_soft(&w->body[b]));
    particle *p = &w->pool.at[w->body[b].first + i];
    p->inverse_mass = 0;
    p->previous = p->position;
}
//<

//> world-tree
// The features that the leaves of a body's tree enclose: the faces of a rigid
// body, the particles of a deformable one.
static leaf_feature leaf_number(const shape *s, int i)
{
    if (s->kind != SHAPE_RIGID) return (leaf_feature){ 1, { i, 0, 0 } };
    const int *v = &s->face[3 * i];
    return (leaf_feature){ 3, { v[0], v[1], v[2] } };
}

// Particles of a deformable body are balls of 0.55 of its spacing: where two
// sheets lie on each other, no diagonal of one can then pass between the
// particles of the other, which are 1.1 spacings away.
static real body_thickness(const shape *s, const world_options *o)
{
    return s->kind == SHAPE_RIGID ? o->skin * s->radius : 0.55 * s->spacing;
}

// How far a rigid body may be stretched and still lie in the balls around it.
// Sticks that are off by the 1 % that the paper's relaxation leaves let a
// vertex out by up to 4.7 %.
static const real SLACK = 0.05;

static status build_tree(body *b, const vec3 *at)
{
    const shape *s = b->plan;
    int n = body_is_soft(b) ? s->particles : s->mesh.faces;

    leaf_feature *leaf = malloc((size_t)n * sizeof *leaf);
    if (!leaf) return status_out_of_memory();
    for (int i = 0; i < n; i++) leaf[i] = leaf_number(s, i);
    status done = sphere_tree_build(&b->tree,
        body_is_soft(b) ? TREE_LAYERED : TREE_WRAPPED,
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
    const shape *s = b->plan;
    const rigid4 *f = b->four;
    for (int i = 0; i < body_particles(b); i++) {
        if (f) place_particle(w, where, f->at[i], f->center, f->mass);
        else   place_particle(w, where, s->at[i], origin, s->mass[i]);
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

// The four particles of the rigid plan s.
static status plan_four(const shape *s, rigid4 **f)
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

// Enters plan s among those in use, if it is new; its number in *number.
static status enter_plan(world *w, const shape *s, int *number)
{
    for (*number = 0; *number < w->plans; (*number)++)
        if (w->plan[*number].shape == s) return status_ok();
    plan_entry *more = grown(w->plan, w->plans, sizeof *more);
    if (!more) return status_out_of_memory();
    w->plan = more;
    plan_entry entry = { .shape = s, .inner = shape_inner(s) };
    status done = status_ok();
    if (s->kind == SHAPE_RIGID) done = plan_four(s, &entry.four);
    if (done.ok) {
        w->plan[w->plans++] = entry;
    } else if (entry.four) {
        rigid4_free(entry.four);
        free(entry.four);
    }
    return done;
}

static status reserve_body(world *w, const shape *s, int *plan)
{
    body *more = grown(w->body, w->bodies, sizeof *more);
    if (!more) return status_out_of_memory();
    w->body = more;
    status done = enter_plan(w, s, plan);
    // A rigid body has four vertices or more.
    int need = w->pool.count + s->particles;
    if (!done.ok || need <= w->pool.capacity) return done;
    return pool_reserve(&w->pool, 2 * need);
}

status world_add(world *w, const shape *s, placement where, int *number)
{
    assert(!w->ready && s->particles > 0);
    if (!placement_is_sound(&where))
        return status_fail("body %d is placed at numbers that are not finite, "
                           "or on axes that are not perpendicular units",
                           w->bodies);
    int plan = 0;
    status done = reserve_body(w, s, &plan);
    if (!done.ok) return done;

    body b = { .plan = s, .four = w->plan[plan].four,
               .inner = w->plan[plan].inner,
               .first = w->pool.count,
               .corner = w->pool.count, .mass = HUGE_VAL };
    real mass = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    if (!where.is_static) b.mass = mass;
    b.thickness = body_thickness(s, &w->options);
    done = build_tree(&b, s->at);
    if (!done.ok) return done;

    place_particles(w, &b, &where);
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
// pairs are fewer).  Few of them touch face on face, in PAIR_CONTACTS points.
// At the planes a body lies on a few vertices; but one so fast that it may get
// anywhere in a frame is near every plane with all of them.  A contact that
// found no room there would let the body through the wall: so there is room for
// all of these.
// A particle of a cloth folded on itself has 12 in touch as well, most of them
// its neighbours at rest, but the lists look further: 24 a particle.  And it is
// near 4 rigid bodies at most, where they lie together.
static void size_lists(world *w)
{
    int rigid = 0, soft = 0, corners = 0;
    for (int b = 0; b < w->bodies; b++) {
        int n = w->body[b].plan->particles;
        if (body_is_soft(&w->body[b])) soft += n;
        else                           corners += n;
        rigid += !body_is_soft(&w->body[b]);
    }
    int all_pairs = rigid < 24 ? rigid * (rigid - 1) / 2 : 12 * rigid;
    w->pairs.capacity = all_pairs;
    w->pushes.capacity = (rigid < 24 ? PAIR_CONTACTS * all_pairs : 12 * rigid)
                       + w->planes * corners;
    w->near.pair_capacity = w->leaves.capacity = 24 * soft;
    w->near.point_capacity = 4 * soft;
    w->least_radius = HUGE_VAL;
    for (int k = 0; k < w->plans; k++)
        if (w->plan[k].shape->kind == SHAPE_RIGID)
            w->least_radius = fmin(w->least_radius, w->plan[k].shape->radius);
    // A wide margin makes long lists, a narrow one makes them often.  With 0.75
    // of a spacing a flat cloth has the diagonals of its cells, and no more:
    // what stands at two spacings is further than the 1.1 of touching and the
    // margin.
    w->near.margin = HUGE_VAL;
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b]))
            w->near.margin = fmin(w->near.margin,
                                  0.75 * w->body[b].plan->spacing);
}

static size_t at_least_one(int n)
{
    return n > 0 ? (size_t)n : 1;
}

// Vertices that are no particles follow after those that are.
static int place_vertices(world *w)
{
    int end = w->pool.count;
    for (int b = 0; b < w->bodies; b++) {
        if (!w->body[b].four) continue;
        w->body[b].corner = end;
        end += w->body[b].plan->particles;
    }
    return end;
}
//<

//> world-size-bodies
static int size_particles(particle_tables *t, const particle_pool *pool)
{
    size_t n = at_least_one(pool->count);
    t->at     = malloc(at_least_one(t->corners) * sizeof *t->at);
    t->seen   = malloc(n * sizeof *t->seen);
    t->lain   = malloc(n * sizeof *t->lain);
    t->listed = malloc(n * sizeof *t->listed);
    t->inverse_mass = malloc(n * sizeof *t->inverse_mass);
    if (!t->at || !t->seen || !t->lain || !t->listed || !t->inverse_mass)
        return 0;
    for (int i = 0; i < pool->count; i++) {
        vec3 x = pool->at[i].position;
        t->at[i] = t->seen[i] = t->lain[i] = t->listed[i] = x;
        t->inverse_mass[i] = pool->at[i].inverse_mass;
    }
    return 1;
}

static int size_flags(body_flags *t, int bodies)
{
    size_t n = at_least_one(bodies);
    t->moves    = calloc(n, 1);
    t->fresh    = calloc(n, 1);
    t->looked   = calloc(n, 1);
    t->still    = calloc(n, 1);
    return t->moves && t->fresh && t->looked && t->still;
}

// Before they are first cut, all are left.
static int size_cut(world_cut *t, int bodies)
{
    size_t n = at_least_one(bodies);
    t->side  = calloc(n, 1);
    t->sided = malloc(n * sizeof *t->sided);
    if (!t->side || !t->sided) return 0;
    t->lefts = bodies;
    for (int b = 0; b < bodies; b++) t->sided[b] = b;
    return 1;
}
//<

//> world-size-rigid
static int size_pairs(pair_tables *t, int bodies)
{
    size_t n = at_least_one(bodies), pairs = at_least_one(t->capacity);
    t->ball    = calloc(n, sizeof *t->ball);
    t->spread  = calloc(n, sizeof *t->spread);
    t->listed  = calloc(n, sizeof *t->listed);
    t->met     = malloc(pairs * sizeof *t->met);
    t->at      = malloc(pairs * sizeof *t->at);
    t->old     = malloc(pairs * sizeof *t->old);
    t->carried = malloc(pairs * sizeof *t->carried);
    t->old_carried = malloc(pairs * sizeof *t->old_carried);
    return t->ball && t->spread && t->listed && t->met && t->at && t->old
        && t->carried && t->old_carried;
}

// The largest rigid body has so many vertices.
static int size_narrow(narrow_tables *t, const world *w, int vertices)
{
    size_t n = at_least_one(w->bodies);
    t->wall  = calloc(n, sizeof *t->wall);
    t->found = malloc(at_least_one(w->planes * (w->of.corners - w->pool.count)
                                   + PAIR_CONTACTS * w->pairs.capacity)
                      * sizeof *t->found);
    for (int half = 0; half < 2; half++) {
        t->swept[half]  = malloc(at_least_one(2 * vertices)
                                 * sizeof *t->swept[half]);
        t->needed[half] = malloc(n);
        if (!t->swept[half] || !t->needed[half]) return 0;
    }
    return t->wall && t->found;
}

static int size_pushes(push_tables *t, int bodies)
{
    size_t n = at_least_one(t->capacity), moving = at_least_one(bodies);
    t->at       = malloc(n * sizeof *t->at);
    t->old      = malloc(n * sizeof *t->old);
    t->between  = malloc(n * sizeof *t->between);
    t->old_between = malloc(n * sizeof *t->old_between);
    t->in_parts = malloc(n * sizeof *t->in_parts);
    t->ways     = calloc(moving, sizeof *t->ways);
    t->drift    = calloc(moving + PILE_PARTS, sizeof *t->drift);
    t->near     = malloc(n * sizeof *t->near);
    return t->at && t->old && t->between && t->old_between && t->in_parts
        && t->ways && t->drift && t->near;
}
//<

//> world-size-soft
static int size_near(near_lists *t)
{
    t->pair  = malloc(at_least_one(t->pair_capacity) * sizeof *t->pair);
    t->point = malloc(at_least_one(t->point_capacity) * sizeof *t->point);
    return t->pair && t->point;
}

static int size_leaves(leaf_tables *t)
{
    t->pair = malloc(at_least_one(t->capacity) * sizeof *t->pair);
    return t->pair != NULL;
}

static int size_hull(hull_tables *t, int faces)
{
    t->plane = malloc(at_least_one(faces) * sizeof *t->plane);
    t->face  = malloc(at_least_one(faces) * sizeof *t->face);
    return t->plane && t->face;
}
//<

//> world-size-tables
static int size_tables(world *w)
{
    int faces = 0, vertices = 0;
    for (int k = 0; k < w->plans; k++) {
        const shape *s = w->plan[k].shape;
        faces  = int_max(faces, s->mesh.faces);
        if (s->kind == SHAPE_RIGID) vertices = int_max(vertices, s->particles);
    }
    return size_particles(&w->of, &w->pool) && size_flags(&w->flags, w->bodies)
        && size_pairs(&w->pairs, w->bodies) && size_cut(&w->cut, w->bodies)
        && size_narrow(&w->narrow, w, vertices)
        && size_pushes(&w->pushes, w->bodies) && size_near(&w->near)
        && size_leaves(&w->leaves) && size_hull(&w->hull, faces);
}
//<

//> world-begin
static int size_lines(world *w)
{
    for (int k = 0; k < w->plans; k++) {
        if (w->plan[k].shape->kind == SHAPE_RIGID) continue;
        w->plan[k].line = line_scratch_new(w->plan[k].shape);
        if (!w->plan[k].line) return 0;
    }
    return 1;
}

// The near lists ask about one deformable body at a time.
static status build_grid(world *w)
{
    int most = 0;
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b]) && w->body[b].plan->particles > most)
            most = w->body[b].plan->particles;
    return grid_init(&w->near.grid, most);
}

status world_begin(world *w)
{
    assert(!w->ready);
    size_lists(w);
    w->of.corners = place_vertices(w);
    if (!size_tables(w) || !size_lines(w)) return status_out_of_memory();
    // The trees were built to the plans; now they stand where the bodies do.
    for (int b = 0; b < w->bodies; b++) world_look_again(w, &w->body[b]);
    for (int b = 0; b < w->bodies; b++) world_find_ways(w, &w->body[b]);
    status done = rest_init(&w->rest, w->bodies);
    if (done.ok) done = broad_init(&w->pairs.broad, w->bodies);
    if (done.ok) done = build_grid(w);
    w->ready = done.ok;
    return done;
}
//<

//> world-free
void world_free(world *w)
{
    for (int b = 0; b < w->bodies; b++) sphere_tree_free(&w->body[b].tree);
    for (int k = 0; k < w->plans; k++) {
        line_scratch_free(w->plan[k].line);
        if (w->plan[k].four) rigid4_free(w->plan[k].four);
        free(w->plan[k].four);
    }
    void *owned[] = { w->body, w->plan,
        w->of.at, w->of.seen, w->of.lain, w->of.listed, w->of.inverse_mass,
        w->flags.moves, w->flags.fresh, w->flags.looked, w->flags.still,
        w->pairs.ball, w->pairs.spread, w->pairs.listed, w->pairs.met,
        w->pairs.at, w->pairs.old, w->pairs.carried, w->pairs.old_carried,
        w->cut.side, w->cut.sided,
        w->narrow.wall, w->narrow.found, w->narrow.swept[0],
        w->narrow.swept[1], w->narrow.needed[0], w->narrow.needed[1],
        w->pushes.at, w->pushes.old, w->pushes.between, w->pushes.old_between,
        w->pushes.in_parts, w->pushes.ways, w->pushes.drift, w->pushes.near,
        w->near.pair, w->near.point, w->leaves.pair,
        w->hull.plane, w->hull.face };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    pool_free(&w->pool);
    rest_free(&w->rest);
    broad_free(&w->pairs.broad);
    grid_free(&w->near.grid);
    *w = (world){ .hull = { .of = -1 } };
}
//<

//> world-look
// Vertices that ride on four particles have no number in the pool: they are
// numbered within the body.
pooled world_collider(const world *w, const body *b)
{
    return (pooled){ b->plan, b->four ? 0 : b->first, w->of.at + b->corner,
                     b->mass };
}

void world_vertices(const world *w, const body *b, vec3 *at)
{
    const particle *p = w->pool.at + b->first;
    if (b->four) {
        rigid4_ride(b->four, p, at, b->plan->particles);
        return;
    }
    for (int i = 0; i < b->plan->particles; i++) at[i] = p[i].position;
}

void world_look(world *w, const body *b)
{
    world_vertices(w, b, w->of.at + b->corner);
}

void world_look_again(world *w, body *b)
{
    world_look(w, b);
    sphere_tree_refresh(&b->tree, w->of.at + b->corner);
}

void world_find_ways(world *w, const body *b)
{
    const particle *p = w->pool.at + b->first;
    vec3 at[FOUR];
    if (body_is_soft(b)) return;
    for (int i = 0; i < FOUR; i++) at[i] = p[i].position;
    rigid4_find_ways(at, p->inverse_mass, &w->pushes.ways[b - w->body]);
}
//<
