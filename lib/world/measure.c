//> measure-strain
#include "measure.h"

#include <stddef.h>

static void measure_strain(const world *w, measures *m)
{
    real sum = 0;
    long count = 0;
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        const particle *p = w->pool.at + x->first;
        const stick *s = x->four ? x->four->stick : x->plan->stick;
        int sticks = x->four ? FOUR_STICKS : x->plan->sticks;
        if (body_is_nailed(x)) continue;
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
// ago; its angular momentum is taken about the place that it had then.
static void measure_motion(const world *w, measures *m)
{
    real h = w->age;
    for (int i = 0; i < w->pool.count; i++) {
        const particle *p = &w->pool.at[i];
        if (w->of.inverse_mass[i] == 0) continue;
        real mass = 1 / w->of.inverse_mass[i];
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        vec3 x = vec3_scale(0.5, vec3_add(p->position, p->previous));
        m->kinetic += mass / 2 * vec3_length_squared(v);
        m->potential -= mass * vec3_dot(w->options.gravity, p->position);
        m->momentum = vec3_add_scaled(m->momentum, mass, v);
        m->angular = vec3_add_scaled(m->angular, mass, vec3_cross(x, v));
    }
}
//<

//> measure-penetration
// A NaN enters, and nothing replaces it.
static void deepen(measures *m, real depth)
{
    if (depth > m->penetration || depth != depth) m->penetration = depth;
}

static void measure_planes(const world *w, const body *b, measures *m)
{
    if (body_is_nailed(b)) return;
    for (int p = 0; p < w->planes; p++)
        for (int i = b->corner; i < b->corner + b->plan->particles; i++)
            deepen(m, w->plane[p].offset
                      - vec3_dot(w->of.at[i], w->plane[p].normal));
}

// The depth of the hit face; bodies that are apart add nothing, and those that
// are nowhere a depth that is no number.
static void measure_rigid_pair(world *w, body *a, body *b, measures *m)
{
    hull p = { w->of.at + a->corner, a->plan->particles };
    hull q = { w->of.at + b->corner, b->plan->particles };
    if (body_is_nailed(a) && body_is_nailed(b)) return;
    gjk_result g = gjk_distance(p, q, 0, NULL);
    if (g.status == GJK_NOT_FINITE) deepen(m, (real)NAN);
    if (g.status == GJK_OVERLAP)
        deepen(m, hit_face_find(p, q, &g.last).depth);
}

// How deep the particles of a deformable body stand in a rigid one.
static void measure_points(world *w, body *soft, body *rigid, measures *m)
{
    pooled a = world_collider(w, soft), b = world_collider(w, rigid);
    int planes = hull_planes(rigid->plan, b.at, w->hull.plane, w->hull.face);
    w->hull.of = -1;
    for (int i = 0; i < soft->plan->particles; i++) {
        contact_point c;
        if (!collide_point(&a, i, &b, w->hull.plane, w->hull.face, planes, 0,
                           &c))
            continue;
        vec3 on_b = c.fixed;
        deepen(m, vec3_dot(vec3_sub(on_b, a.at[i]), c.normal));
    }
}

static void measure_pair(world *w, body *a, body *b, measures *m)
{
    sphere x = sphere_tree_root(&a->tree, w->of.at + a->corner);
    sphere y = sphere_tree_root(&b->tree, w->of.at + b->corner);
    if (vec3_distance(x.center, y.center) > x.radius + y.radius) return;
    if (!body_is_soft(a) && !body_is_soft(b)) measure_rigid_pair(w, a, b, m);
    if (body_is_soft(a) && !body_is_soft(b))  measure_points(w, a, b, m);
    if (!body_is_soft(a) && body_is_soft(b))  measure_points(w, b, a, m);
}
//<

//> world-measure
measures world_measure(world *w)
{
    measures m = { .strain = 0 };
    for (int b = 0; b < w->bodies; b++) world_look_again(w, &w->body[b]);
    measure_strain(w, &m);
    measure_motion(w, &m);
    for (int a = 0; a < w->bodies; a++) {
        measure_planes(w, &w->body[a], &m);
        for (int b = a + 1; b < w->bodies; b++)
            measure_pair(w, &w->body[a], &w->body[b], &m);
    }
    return m;
}
//<

//> world-hash
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
