//> measure-strain
//>   Strain is the worst of all links and sticks.
#include "measure.h"
#include "cast.h"

#include <stddef.h>
#include <stdlib.h>

static void measure_strain(const world *w, measures *m)
{
    real sum = 0;
    long count = 0;
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        const particle *p = w->pool.at + x->first;
        const stick *s = x->rigid ? x->rigid->stick : x->shape->stick;
        int sticks = x->rigid ? FOUR_STICKS : x->shape->sticks;
        if (body_is_static(x)) continue;
        for (int k = 0; k < sticks; k++) {
            real strain = stick_strain(s[k], p);
            int is_soft = s[k].stiffness < 1;
            real *worst = is_soft ? &m->shear : &m->strain;
            if (!(strain <= *worst)) *worst = strain;
            if (is_soft) continue;
            sum += strain * strain;
            count++;
        }
    }
    m->strain_rms = count > 0 ? sqrt(sum / (real)count) : 0;
}
//<

//> measure-motion
// A particle's mean velocity over the last substep is that of half a substep
// ago; its height and its lever arm are those of the place that it had then.
static void measure_motion(const world *w, measures *m)
{
    for (int i = 0; i < w->pool.count; i++) {
        const particle *p = &w->pool.at[i];
        if (w->inverse_mass[i] == 0) continue;
        real h = body_age(w, w->owner[i]);
        real mass = 1 / w->inverse_mass[i];
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        vec3 x = vec3_scale(0.5, vec3_add(p->position, p->previous));
        m->kinetic += mass / 2 * vec3_length_squared(v);
        m->potential -= mass * vec3_dot(body_gravity(w, w->owner[i]), x);
        m->momentum = vec3_add_scaled(m->momentum, mass, v);
        m->angular = vec3_add_scaled(m->angular, mass, vec3_cross(x, v));
    }
}
//<

//> measure-penetration
//>   Overlap needs the queries of chapters 04 and 05, for every kind of pair.
// Where everything is, and room for the planes of one body.
typedef struct {
    vec3 *at;           // m, the vertices of all bodies
    int  *first;        // [bodies] of each in `at`
    sphere *ball;       // [bodies] around them
    plane *plane;
} sight;

// A NaN enters, and nothing replaces it.
static void deepen(measures *m, real depth)
{
    if (depth > m->penetration || depth != depth) m->penetration = depth;
}

static void measure_planes(const world *w, const sight *s, int b, measures *m)
{
    const vec3 *at = s->at + s->first[b];
    real round = w->body[b].shape->round;
    if (body_meets_none(&w->body[b])) return;
    for (int p = 0; p < w->planes; p++)
        for (int i = 0; i < w->body[b].shape->particles; i++)
            deepen(m, round - plane_height(w->plane[p], at[i]));
}

// The depth of the hit face; bodies that are apart add nothing.
static void measure_rigid_pair(const world *w, const sight *s, int a, int b,
                               measures *m)
{
    collider x = { w->body[a].shape, s->at + s->first[a], false };
    collider y = { w->body[b].shape, s->at + s->first[b], false };
    query_cache none = { .count = 0 };
    query_result r = query_nearest(&x, &y, 0, &none);
    if (r.near) deepen(m, -r.at.gap);
}

// How deep the particles of a deformable body stand in a rigid one.
static void measure_points(const world *w, const sight *s, int soft, int rigid,
                           measures *m)
{
    const shape *plan = w->body[rigid].shape;
    const vec3 *at = s->at + s->first[rigid], *x = s->at + s->first[soft];
    obstacle b = { { at, plan->particles }, s->plane,
                   hull_planes(plan, at, s->plane), plan->radius,
                   plan->round };
    for (int i = 0; i < w->body[soft].shape->particles; i++) {
        surface_point p;
        if (obstacle_nearest(&b, x[i], b.planes, 0, &p))
            deepen(m, vec3_dot(vec3_sub(p.at, x[i]), p.normal));
    }
}

// Bodies of a joint overlap where they are joined.
static bool may_overlap(const world *w, int a, int b)
{
    a = body_whole(&w->body[a], a);
    b = body_whole(&w->body[b], b);
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        bool is_it = (j->a == a && j->b == b) || (j->a == b && j->b == a);
        if (is_it && joint_holds(j) && !j->may_touch) return true;
    }
    return false;
}

static void measure_pair(const world *w, const sight *s, int a, int b,
                         measures *m)
{
    const body *x = &w->body[a], *y = &w->body[b];
    sphere p = s->ball[a], q = s->ball[b];
    real near = p.radius + q.radius;
    if (body_is_fixed(x) && body_is_fixed(y)) return;
    if (!body_meets(x, y)) return;
    if (x->rides && x->rides == y->rides) return;
    if (vec3_length_squared(vec3_sub(p.center, q.center)) > near * near) return;
    if (may_overlap(w, a, b)) return;
    if (!body_is_soft(x) && !body_is_soft(y)) measure_rigid_pair(w, s, a, b, m);
    if (body_is_soft(x) && !body_is_soft(y))  measure_points(w, s, a, b, m);
    if (!body_is_soft(x) && body_is_soft(y))  measure_points(w, s, b, a, m);
}
//<

//> measure-look
//>   The whole of it: overlaps, strains and motion.
static void sight_free(sight *s)
{
    free(s->at);
    free(s->first);
    free(s->ball);
    free(s->plane);
}

static bool sight_make(const world *w, sight *s)
{
    size_t vertices = 1, faces = 1, bodies = (size_t)w->bodies + 1;
    for (int b = 0; b < w->bodies; b++) {
        const shape *x = w->body[b].shape;
        vertices += (size_t)x->particles;
        if ((size_t)x->mesh.faces > faces) faces = (size_t)x->mesh.faces;
    }
    *s = (sight){ malloc(vertices * sizeof *s->at),
                  malloc(bodies * sizeof *s->first),
                  malloc(bodies * sizeof *s->ball),
                  malloc(faces * sizeof *s->plane) };
    if (!s->at || !s->first || !s->ball || !s->plane) return false;
    int next = 0;
    for (int b = 0; b < w->bodies; b++) {
        const shape *x = w->body[b].shape;
        s->first[b] = next;
        world_vertices(w, &w->body[b], s->at + next);
        s->ball[b] = rounded_ball(rounded_shape(x, s->at + next));
        next += x->particles;
    }
    return true;
}

static void measure_penetration(const world *w, measures *m)
{
    sight s;
    if (!sight_make(w, &s)) deepen(m, (real)NAN);
    else for (int a = 0; a < w->bodies; a++) {
        if (!vec3_is_finite(s.ball[a].center)) deepen(m, (real)NAN);
        if (!body_is_fixed(&w->body[a])) measure_planes(w, &s, a, m);
        for (int b = a + 1; b < w->bodies; b++) measure_pair(w, &s, a, b, m);
    }
    sight_free(&s);
}
//<

//> world-measure
//>   The same as a function of the world.
measures world_measure(const world *w)
{
    measures m = { .strain = 0 };
    measure_strain(w, &m);
    measure_motion(w, &m);
    measure_penetration(w, &m);
    return m;
}
//<

//> world-hash
//>   `build/tumble room --bits` prints a hash of all positions, and two runs,
//>   or two compilers, must agree.
unsigned long long world_hash(const world *w)
{
    unsigned long long hash = 0xcbf29ce484222325ULL;
    for (int i = 0; i < w->pool.count; i++) {
        const vec3 *x = &w->pool.at[i].position;
        const unsigned char *byte = (const unsigned char *)x;
        for (size_t k = 0; k < sizeof *x; k++)
            hash = (hash ^ byte[k]) * 0x100000001b3ULL;
    }
    return hash;
}
//<
