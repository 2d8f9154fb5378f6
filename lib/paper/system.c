//> system-step
// system.c - integrate, find contacts, separate them, relax.
#include "system.h"

#include <limits.h>
#include <stdlib.h>

static void find_contacts(particle_system *s);
static void separate_contacts(particle_system *s);
static void relax_bodies(particle_system *s);

system_report system_step(particle_system *s)
{
    const system_options *o = &s->options;
    s->report = (system_report){ .contacts = 0 };
    for (int k = 0; k < o->substeps; k++) {
        verlet_step(s->pool.at, s->pool.count, o->gravity, NULL,
                    o->dt / o->substeps);
        if (k % o->find_every == 0) find_contacts(s);
        for (int round = 0; round < o->rounds; round++) {
            separate_contacts(s);
            relax_bodies(s);
        }
    }
    s->report.contacts = s->contacts;
    return s->report;
}
//<

//> system-find
static bool is_soft(const system_body *x)
{
    return x->shape->kind != SHAPE_RIGID;
}

static void forget_contacts(particle_system *s);
static void update_body(particle_system *s, system_body *x);
static void find_pair(particle_system *s, int i, int j);
static void find_rigid(particle_system *s, int i, int j);
static void find_mixed(particle_system *s, system_body *a, system_body *b);
static void find_soft(particle_system *s, system_body *a, system_body *b);
static void find_planes(particle_system *s, const system_body *x);

// Sections 5 and 6.1: which bodies are near, and where do they touch?
static void find_contacts(particle_system *s)
{
    forget_contacts(s);
    for (int k = 0; k < s->bodies; k++) update_body(s, &s->body[k]);
    for (int i = 0; i < s->bodies; i++)
        for (int j = i; j < s->bodies; j++) find_pair(s, i, j);
    for (int k = 0; k < s->bodies; k++) find_planes(s, &s->body[k]);
}

// Where the body is now, and the sphere around it: a rigid one's rests on four
// particles at most, and is all of its tree that is brought up to date here.
static void update_body(particle_system *s, system_body *x)
{
    for (int k = x->first; k < x->first + x->shape->particles; k++)
        s->at[k] = s->pool.at[k].position;
    sphere_tree_refresh(&x->tree, s->at + x->first);
    x->bound = sphere_tree_root(&x->tree, s->at + x->first);
}

// False for spheres that are not finite.
static bool spheres_meet(sphere a, sphere b, real reach)
{
    reach += a.radius + b.radius;
    return vec3_length_squared(vec3_sub(a.center, b.center)) < reach * reach;
}

// Section 5: every body against every other; a deformable one also against itself.
static void find_pair(particle_system *s, int i, int j)
{
    system_body *a = &s->body[i], *b = &s->body[j];
    real reach = s->options.margin + s->options.speculative;
    if (!spheres_meet(a->bound, b->bound, reach)) return;
    if (a->is_static && b->is_static) return;
    if (is_soft(a) && is_soft(b)) find_soft(s, a, b);
    else if (is_soft(a))          find_mixed(s, a, b);
    else if (is_soft(b))          find_mixed(s, b, a);
    else if (i != j)              find_rigid(s, i, j);
}
//<

//> system-contact
// Room for one more in a list of count; NULL if memory is refused, and then the
// old list stands.
static void *grown_list(void *list, int count, int *room, size_t size)
{
    if (count < *room) return list;
    void *more = realloc(list, (size_t)(2 * count + 64) * size);
    if (more) *room = 2 * count + 64;
    return more;
}

// A contact between two bodies (b = NULL: a plane) that is still to be filled.
static feature_contact contact_of(const system_body *a, const system_body *b,
                                  real apart)
{
    return (feature_contact){ .apart = apart, .mass_a = a->mass,
                              .mass_b = b ? b->mass : HUGE_VAL,
                              .soft_a = is_soft(a), .soft_b = b && is_soft(b) };
}

static void add_contact(particle_system *s, feature_contact c, int lifetime)
{
    system_contact *more = grown_list(s->contact, s->contacts, &s->contact_room,
                                      sizeof *more);
    if (!more) {
        s->report.dropped++;
        return;
    }
    s->contact = more;
    s->contact[s->contacts++] = (system_contact){ c, lifetime };
}

// Of two rigid bodies each find gives one point of what may be a whole face.
// Those of the last finds live on, and together they carry a face that lies on
// another (a poor man's contact manifold).
static void forget_contacts(particle_system *s)
{
    int kept = 0;
    for (int k = 0; k < s->contacts; k++) {
        system_contact c = s->contact[k];
        if (c.left-- > 0) s->contact[kept++] = c;
    }
    s->contacts = kept;
}
//<

//> system-rigid
//>   The hull of a body is its particles, where they are now. The function
//>   `hulls_meet` is chapters 04 and 05 in one. GJK says how far apart the
//>   hulls are; if they overlap, the hit face says which way out is shortest.
static hull body_hull(const particle_system *s, const system_body *x)
{
    return (hull){ s->at + x->first, x->shape->particles };
}

// Two hulls, at the hit face if they overlap, and where they are nearest if
// they are no further apart than reach: fills the points and the normal of c,
// with vertices as the hulls number them.
static bool hulls_meet(particle_system *s, hull a, hull b, real reach,
                       simplex *carried, feature_contact *c, vec3 *axis)
{
    gjk_result g = gjk_distance(a, b, reach, carried);
    s->report.capped += g.status == GJK_CAPPED;
    if (axis) *axis = g.axis;
    if (g.status == GJK_BEYOND || g.status == GJK_NOT_FINITE) return false;
    if (g.status == GJK_OVERLAP) {
        hit_result h = hit_face_find(a, b, &g.last);
        s->report.capped += h.status == HIT_CAPPED;
        c->normal = h.normal, c->a = h.a, c->b = h.b;
        return true;
    }
    if (g.distance > reach) return false;
    c->normal = vec3_unit(g.axis);
    for (int k = 0; k < g.last.count; k++) {
        feature_add(&c->a, g.last.of[k].a, g.last.weight[k]);
        feature_add(&c->b, g.last.of[k].b, g.last.weight[k]);
    }
    return true;
}

// From vertices of a body to particles of the system.
static void renumber(feature_point *f, const system_body *x)
{
    for (int k = 0; k < f->count; k++) f->vertex[k] += x->first;
}

// Sections 5.1 and 6.1: a rigid body against a rigid body.  The search starts
// from the simplex of their last query.  If two pairs share an entry of the
// table, one of them starts from none.
static void find_rigid(particle_system *s, int i, int j)
{
    const system_body *a = &s->body[i], *b = &s->body[j];
    feature_contact c = contact_of(a, b, s->options.margin);
    real reach = s->options.margin + s->options.speculative;
    carried_simplex *carried = &s->carried[((long)i * s->bodies + j)
                                           % s->carries];
    if (carried->a != i || carried->b != j)
        *carried = (carried_simplex){ .a = i, .b = j };
    if (!hulls_meet(s, body_hull(s, a), body_hull(s, b), reach, &carried->last,
                    &c, NULL)) return;
    renumber(&c.a, a);
    renumber(&c.b, b);
    add_contact(s, c, s->options.lifetime);
}
//<

//> system-mixed
//>   The paper goes down both trees, to leaves of both. Here only the leaves of
//>   the deformable body are asked, and the rigid body is taken whole. It is
//>   convex, so GJK answers for all of its faces at once.
// A leaf's point: the mean of its particles.
static feature_point leaf_point(const system_body *x, int leaf)
{
    leaf_feature f = x->tree.leaf[leaf];
    feature_point point = { .count = 0 };
    for (int k = 0; k < f.count; k++)
        feature_add(&point, x->first + f.vertex[k], 1.0 / f.count);
    return point;
}

// Does the axis that last separated them still keep them that far apart?
static bool still_apart(vec3 x, hull b, vec3 axis, real apart)
{
    hull a = { &x, 1 };
    real gap = vec3_dot(axis, hull_support(a, b, vec3_scale(-1, axis)).at);
    return gap > 0 && gap * gap > apart * apart * vec3_dot(axis, axis);
}

// Section 6.1, last paragraph: the centre of a deformable body's leaf keeps the
// leaf's thickness off a rigid body.
// Paper: a leaf is a triangle, without thickness: they have met when the centre
// of its sphere is inside, and it ends on the surface.
static void find_leaf(particle_system *s, system_body *a, int leaf,
                      const system_body *b)
{
    vec3 center = a->tree.node[leaf].ball.center;
    real thickness = a->tree.thickness;
    feature_contact c = contact_of(a, b, thickness);
    if (still_apart(center, body_hull(s, b), a->axis[leaf], thickness)) return;
    if (!hulls_meet(s, (hull){ &center, 1 }, body_hull(s, b), thickness, NULL,
                    &c, &a->axis[leaf])) return;
    renumber(&c.b, b);
    c.a = leaf_point(a, leaf);
    c.apart += vec3_dot(vec3_sub(feature_at(&c.a, s->at), center), c.normal);
    add_contact(s, c, 0);
}

// Sections 5.2 and 6.1: the leaves of a deformable body against a rigid one.
// Paper: goes down both trees to leaves of both; here: GJK takes the rigid body
// whole, so that its leaves are not needed.
static void find_mixed(particle_system *s, system_body *a, system_body *b)
{
    for (int k = 0; k < a->tree.leaves; k++)
        if (spheres_meet(a->tree.node[k].ball, b->bound, 0))
            find_leaf(s, a, k, b);
}
//<

//> system-soft
//>   Two leaves part along the line between their centres, until their spheres
//>   touch. The pairs come from the trees.
// Section 6.1, Eq. 11: two leaves part along the line between the centres of
// their spheres, until the spheres touch.
static void find_leaves(particle_system *s, const system_body *a, int leaf_a,
                        const system_body *b, int leaf_b)
{
    sphere p = a->tree.node[leaf_a].ball, q = b->tree.node[leaf_b].ball;
    vec3 d = vec3_sub(p.center, q.center);
    real length = vec3_length(d);
    if (!(length > 0)) return;
    feature_contact c = contact_of(a, b, p.radius + q.radius - length);
    c.a = leaf_point(a, leaf_a);
    c.b = leaf_point(b, leaf_b);
    c.normal = vec3_scale(1 / length, d);
    c.apart += vec3_dot(vec3_sub(feature_at(&c.a, s->at),
                                 feature_at(&c.b, s->at)), c.normal);
    add_contact(s, c, 0);
}

// s->leaf becomes the pairs of leaves of two bodies whose spheres meet, or of
// one body, without leaves that are neighbours at rest.  Returns their number.
// The trees are gone through again where there was no room for all pairs.
static int leaf_pairs(particle_system *s, system_body *a, system_body *b)
{
    const vec3 *at_a = s->at + a->first, *at_b = s->at + b->first;
    for (;;) {
        tree_result r = a == b
            ? sphere_tree_self(&a->tree, at_a, 0, 1 + 1e-9, s->leaf,
                               s->leaf_room)
            : sphere_tree_pairs(&a->tree, at_a, &b->tree, at_b, 0, s->leaf,
                                s->leaf_room);
        if (r.pairs <= s->leaf_room) return r.pairs;
        leaf_pair *more = grown_list(s->leaf, r.pairs, &s->leaf_room, sizeof *more);
        if (!more) {
            s->report.dropped += r.pairs - s->leaf_room;
            return s->leaf_room;
        }
        s->leaf = more;
    }
}

// Section 5.2: the leaves of two deformable bodies, or of one, that meet.
static void find_soft(particle_system *s, system_body *a, system_body *b)
{
    int n = leaf_pairs(s, a, b);
    for (int k = 0; k < n; k++)
        find_leaves(s, a, s->leaf[k].a, b, s->leaf[k].b);
}
//<

//> system-planes
//>   A plane needs no query: a dot product says how far a particle is from it.
// Every particle that is behind a plane, or soon may be, is a contact with the
// immovable world.
static void find_planes(particle_system *s, const system_body *x)
{
    for (int k = 0; k < s->planes && !x->is_static; k++) {
        plane p = s->plane[k];
        real keep = p.offset + (is_soft(x) ? x->tree.thickness
                                           : s->options.margin);
        real until = keep + s->options.speculative;
        if (vec3_dot(x->bound.center, p.normal) - x->bound.radius > until)
            continue;
        for (int i = x->first; i < x->first + x->shape->particles; i++) {
            if (!(vec3_dot(s->at[i], p.normal) < until)) continue;
            feature_contact c = contact_of(x, NULL, keep);
            feature_add(&c.a, i, 1);
            c.normal = p.normal;
            add_contact(s, c, 0);
        }
    }
}
//<

//> system-separate
// Eqs 8 to 11, contact after contact (chapter 7).
static void separate_contacts(particle_system *s)
{
    const system_options *o = &s->options;
    if (o->ordered)
        for (int k = 0; k < s->pool.count; k++)
            s->before[k] = s->pool.at[k].position;
    for (int k = 0; k < s->contacts; k++) {
        const feature_contact *c = &s->contact[k].contact;
        if (o->printed) response_printed(c, s->pool.at, o->errata);
        else            response_separate(c, s->pool.at, o->friction);
    }
}

// A body bent by more than this (strain) was pushed out of a deep overlap.
static const real BENT = 0.25;

// Section 6.2: a rigid body that was pushed relaxes its constraints outwards
// from the particle that moved most; any other body as they are listed.
// Of a bent body the old gradients overshoot, more in every substep, until it
// is lost.  So it is relaxed once more, along the new ones.
static relax_result relax_body(particle_system *s, const system_body *x,
                               relaxation r)
{
    const stick *list = x->shape->stick;
    int n = x->shape->sticks, from = -1;
    particle *p = s->pool.at + x->first;
    if (s->options.ordered && !is_soft(x))
        from = most_moved(p, s->before + x->first, x->shape->particles);
    if (from >= 0)
        return sticks_relax_from(&x->lists, from, list, n, p, r.iterations,
                                 r.how);
    relax_result done = sticks_relax(list, n, p, r.iterations, r.how);
    if (r.how.gradient == GRADIENT_NEW || done.worst <= BENT) return done;
    r.how.gradient = GRADIENT_NEW;
    relax_result again = sticks_relax(list, n, p, r.iterations, r.how);
    again.tested += done.tested;
    again.relaxed += done.relaxed;
    return again;
}

// Relaxes the angles of a body once.  Returns the largest error met.
static real relax_angles(particle_system *s, const system_body *x)
{
    real worst = 0;
    for (int i = 0; i < x->shape->angles; i++) {
        stick_result r = angle_relax(x->shape->angle[i],
                                     s->pool.at + x->first);
        worst = real_max(fabs(r.error), worst);
    }
    return worst;
}

static void relax_bodies(particle_system *s)
{
    s->report.unconverged = s->report.lost = 0;
    for (int k = 0; k < s->bodies; k++) {
        const system_body *x = &s->body[k];
        if (x->is_static) continue;
        relaxation r = is_soft(x) ? s->options.soft : s->options.rigid;
        relax_result done = relax_body(s, x, r);
        done.worst = real_max(relax_angles(s, x), done.worst);
        s->report.tested += done.tested;
        s->report.relaxed += done.relaxed;
        s->report.unconverged += done.worst > r.how.tolerance;
        s->report.lost += done.worst == HUGE_VAL;
    }
}
//<

//> system-defaults
//>   Each option has two defaults. They are the whole argument between the
//>   paper and us.
system_options system_options_mended(void)
{
    return (system_options){
        .dt = 1.0 / 60, .substeps = 8, .rounds = 2, .gravity = { 0, -9.81, 0 },
        .rigid = { { ROOT_EXACT, GRADIENT_OLD, 1e-4, false }, 1 },
        .soft = { { ROOT_APPROXIMATE, GRADIENT_NEW, 1e-4, false }, 2 },
        .leaves = LEAF_PARTICLES, .friction = 0.5, .margin = 0.005,
        .speculative = 0.1, .find_every = 4, .lifetime = 6,
    };
}

system_options system_options_printed(void)
{
    const relaxation jakobsen = {
        { ROOT_APPROXIMATE, GRADIENT_NEW, 0.01, true }, 10 };
    return (system_options){
        .dt = 1.0 / 60, .substeps = 1, .rounds = 1, .gravity = { 0, -9.81, 0 },
        .rigid = jakobsen, .soft = jakobsen, .ordered = true,
        .leaves = LEAF_FACES, .printed = true, .errata = { true, true },
        .find_every = 1,
    };
}
//<

//> system-check
//>   Options come from outside, so each is held to a range before anything is
//>   built.
// Names the first option that is out of its range (NaN is out of every range).
static status check_options(const system_options *o)
{
    struct { const char *name; real value, least, most; } rule[] = {
        { "dt", o->dt, 1e-9, 1 },
        { "substeps", o->substeps, 1, 10000 },
        { "rounds", o->rounds, 1, 10000 },
        { "rigid iterations", o->rigid.iterations, 1, 10000 },
        { "rigid tolerance", o->rigid.how.tolerance, 0, 1 },
        { "soft iterations", o->soft.iterations, 1, 10000 },
        { "soft tolerance", o->soft.how.tolerance, 0, 1 },
        { "friction", o->friction, 0, 1000 },
        { "margin", o->margin, 0, 1e9 },
        { "speculative", o->speculative, 0, 1e9 },
        { "find_every", o->find_every, 1, 10000 },
        { "lifetime", o->lifetime, 0, 10000 },
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

//> system-trees
//>   Then the bodies: their particles, their trees, and, as printed, their
//>   lists. What has a known size is allocated here. Only two lists grow in the
//>   steps, and once they are long enough a step allocates nothing.
// What leaf k of a body's tree encloses: a particle, a face, or a rope's link.
static leaf_feature feature_of_leaf(const shape *s, bool is_particle, int k)
{
    const int *v = &s->face[3 * k];
    if (is_particle)    return (leaf_feature){ 1, { k, 0, 0 } };
    if (!s->mesh.faces) return (leaf_feature){ 2, { s->stick[k].a,
                                                    s->stick[k].b, 0 } };
    return (leaf_feature){ 3, { v[0], v[1], v[2] } };
}

// Section 5.2: a layered tree for a deformable body; for a rigid one a wrapped
// tree, with a tenth of slack for what its constraints do not hold.
static status build_tree(system_body *x, leaf_kind kind)
{
    const shape *s = x->shape;
    bool by_particle = is_soft(x) && kind == LEAF_PARTICLES;
    int n = by_particle ? s->particles
          : s->mesh.faces ? s->mesh.faces : s->sticks;
    if (n == 0) return status_fail("a body has neither faces nor sticks");
    leaf_feature *leaf = malloc((size_t)n * sizeof *leaf);
    if (!leaf) return status_out_of_memory();
    for (int k = 0; k < n; k++) leaf[k] = feature_of_leaf(s, by_particle, k);
    status done = sphere_tree_build(&x->tree,
                                    is_soft(x) ? TREE_LAYERED : TREE_WRAPPED,
                                    s->at, leaf, n,
                                    by_particle ? 0.55 * s->spacing : 0,
                                    is_soft(x) ? 0 : 0.1);
    free(leaf);
    if (!done.ok || !is_soft(x)) return done;
    x->axis = calloc((size_t)n, sizeof *x->axis);
    return x->axis ? done : status_out_of_memory();
}

// Body k, its particles at the end of the pool.
static status add_body(particle_system *s, const scene *from, int k)
{
    const shape *own = scene_shape(from, k);
    const system_options *o = &s->options;
    system_body *x = &s->body[s->bodies++];
    *x = (system_body){ .shape = own, .first = s->pool.count,
                        .is_static = from->body[k].where.is_static };
    for (int i = 0; i < own->particles; i++) {
        real w = x->is_static ? 0 : 1 / own->mass[i];
        pool_add(&s->pool, particle_start(scene_position(from, k, i),
                                          scene_velocity(from, k, i),
                                          o->gravity, w, o->dt / o->substeps));
        x->mass += x->is_static ? HUGE_VAL : own->mass[i];
    }
    status done = build_tree(x, o->leaves);
    if (!done.ok || is_soft(x) || !o->ordered) return done;
    return stick_lists_build(&x->lists, own->stick, own->sticks,
                             own->particles, true);
}

// Everything whose size is known; the lists of contacts grow in the steps.
static status size_lists(particle_system *s, const scene *from)
{
    size_t particles = 1;
    for (int k = 0; k < from->bodies; k++)
        particles += (size_t)scene_shape(from, k)->particles;
    if (particles > INT_MAX)
        return status_fail("%zu particles are too many to number", particles);
    status done = pool_reserve(&s->pool, (int)particles);
    s->carries = 64 * int_min(from->bodies, 1 << 10) + 1;
    s->at = malloc(particles * sizeof *s->at);
    s->before = malloc(particles * sizeof *s->before);
    s->body = malloc(((size_t)from->bodies + 1) * sizeof *s->body);
    s->plane = malloc(((size_t)from->planes + 1) * sizeof *s->plane);
    s->carried = calloc((size_t)s->carries, sizeof *s->carried);
    if (s->at && s->before && s->body && s->plane && s->carried) return done;
    return status_out_of_memory();
}

status system_init(particle_system *s, const scene *from,
                   system_options options)
{
    *s = (particle_system){ .options = options };
    status done = check_options(&options);
    if (done.ok) done = size_lists(s, from);
    for (int k = 0; k < from->planes && done.ok; k++)
        s->plane[s->planes++] = from->plane[k];
    for (int k = 0; k < from->bodies && done.ok; k++)
        done = add_body(s, from, k);
    for (int k = 0; k < from->pins && done.ok; k++) {
        scene_pin pin = from->pin[k];
        particle *p = &s->pool.at[s->body[pin.body].first + pin.particle];
        p->inverse_mass = 0;
        p->previous = p->position;
    }
    if (!done.ok) system_free(s);
    return done;
}

void system_free(particle_system *s)
{
    for (int k = 0; k < s->bodies; k++) {
        sphere_tree_free(&s->body[k].tree);
        stick_lists_free(&s->body[k].lists);
        free(s->body[k].axis);
    }
    void *owned[] = { s->at, s->before, s->body, s->plane, s->contact, s->leaf,
                      s->carried };
    for (size_t k = 0; k < sizeof owned / sizeof *owned; k++) free(owned[k]);
    pool_free(&s->pool);
    *s = (particle_system){ .bodies = 0 };
}
//<
