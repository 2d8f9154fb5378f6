//> poses-strain
//>   Strain first, over all sticks of all bodies.
// poses.c - how far from right do the bodies of a scene lie?
#include "poses.h"
#include "hit_face.h"

#include <stddef.h>

typedef struct {
    const scene *scene;
    const vec3  *at;
    poses        found;
} survey;

static bool is_soft(const scene *s, int body)
{
    return scene_shape(s, body)->kind != SHAPE_RIGID;
}

static real strain_of(stick s, const vec3 *at)
{
    real error = vec3_distance(at[s.a], at[s.b]) - s.rest_length;
    if (s.kind == STICK_AT_LEAST && error > 0) return 0;
    if (s.kind == STICK_AT_MOST && error < 0) return 0;
    return fabs(error) / s.rest_length;
}

static void measure_strain(survey *v)
{
    const vec3 *at = v->at;
    real sum = 0;
    long count = 0;
    for (int b = 0; b < v->scene->bodies; b++) {
        const shape *s = scene_shape(v->scene, b);
        for (int k = 0; k < s->sticks && !v->scene->body[b].where.is_static;
             k++) {
            real strain = strain_of(s->stick[k], at);
            bool is_stiff = s->stick[k].stiffness >= 1;
            real *worst = is_stiff ? &v->found.strain : &v->found.shear;
            if (!(strain <= *worst)) *worst = strain;
            if (!is_stiff) continue;
            sum += strain * strain;
            count++;
        }
        at += s->particles;
    }
    v->found.strain_rms = count > 0 ? sqrt(sum / (real)count) : 0;
}
//<

//> poses-overlap
//>   Overlaps come from GJK and the hit face; boxes around the bodies sort out
//>   most pairs.
static hull hull_of(const scene *s, int body, const vec3 *at)
{
    return (hull){ at, scene_shape(s, body)->particles };
}

// m: how deep two hulls stand in each other; 0 where they are apart.
static real depth_of(hull a, hull b)
{
    gjk_result g = gjk_distance(a, b, 0, NULL);
    return g.status == GJK_OVERLAP ? hit_face_find(a, b, &g.last).depth : 0;
}

// The deepest particle of a deformable body in a rigid one.
static void measure_inside(survey *v, hull soft, hull rigid)
{
    for (int k = 0; k < soft.count; k++) {
        real depth = depth_of((hull){ &soft.at[k], 1 }, rigid);
        v->found.particles_in += depth > 1e-9;
        if (depth > v->found.inside) v->found.inside = depth;
    }
}

static bool boxes_meet(hull a, hull b)
{
    for (int d = 0; d < 6; d++) {
        vec3 n = { d / 2 == 0, d / 2 == 1, d / 2 == 2 };
        if (d % 2) n = vec3_scale(-1, n);
        if (vec3_dot(hull_support(a, b, vec3_scale(-1, n)).at, n) > 0)
            return false;
    }
    return true;
}

static void measure_overlaps(survey *v)
{
    const scene *s = v->scene;
    const vec3 *at = v->at;
    for (int i = 0; i < s->bodies; i++) {
        hull a = hull_of(s, i, at);
        const vec3 *at_b = at += a.count;
        for (int j = i + 1; j < s->bodies; j++) {
            hull b = hull_of(s, j, at_b);
            at_b += b.count;
            if (s->body[i].where.is_static && s->body[j].where.is_static)
                continue;
            if ((is_soft(s, i) && is_soft(s, j)) || !boxes_meet(a, b)) continue;
            if (is_soft(s, i))      measure_inside(v, a, b);
            else if (is_soft(s, j)) measure_inside(v, b, a);
            else v->found.overlap = real_max(v->found.overlap, depth_of(a, b));
        }
    }
}
//<

//> poses-planes
//>   Then the planes, and the kinetic energy.
static void measure_planes(survey *v, int body, const vec3 *at)
{
    int n = scene_shape(v->scene, body)->particles;
    vec3 center = { 0, 0, 0 };
    bool is_outside = false;
    for (int i = 0; i < n; i++)
        center = vec3_add_scaled(center, 1.0 / n, at[i]);
    for (int k = 0; k < v->scene->planes; k++) {
        plane p = v->scene->plane[k];
        is_outside |= vec3_dot(center, p.normal) < p.offset;
        for (int i = 0; i < n; i++)
            v->found.behind = real_max(p.offset - vec3_dot(at[i], p.normal),
                                       v->found.behind);
    }
    v->found.outside += is_outside;
}

poses poses_measure(const scene *s, const vec3 *at)
{
    survey v = { .scene = s, .at = at, .found = { .finite = true } };
    for (int b = 0; b < s->bodies; b++) {
        for (int i = 0; i < scene_shape(s, b)->particles; i++)
            v.found.finite &= vec3_is_finite(at[i]);
        if (!s->body[b].where.is_static) measure_planes(&v, b, at);
        at += scene_shape(s, b)->particles;
    }
    measure_strain(&v);
    measure_overlaps(&v);
    return v.found;
}

real poses_kinetic(const scene *s, const vec3 *before, const vec3 *at, real dt)
{
    real sum = 0;
    for (int b = 0, first = 0; b < s->bodies; b++) {
        const shape *x = scene_shape(s, b);
        for (int i = 0; i < x->particles && !s->body[b].where.is_static; i++) {
            vec3 move = vec3_sub(at[first + i], before[first + i]);
            sum += x->mass[i] / 2 * vec3_length_squared(move) / (dt * dt);
        }
        first += x->particles;
    }
    return sum;
}
//<

//> poses-triangles
//>   For cloth it is not enough to look at particles. A triangle may stand in a
//>   corner of the cube while its three particles are outside.
int poses_triangles_in(const scene *s, const vec3 *at)
{
    int count = 0;
    const vec3 *at_a = at;
    for (int a = 0; a < s->bodies; at_a += scene_shape(s, a++)->particles) {
        const shape *cloth = scene_shape(s, a);
        const vec3 *at_b = at;
        if (cloth->kind != SHAPE_CLOTH) continue;
        for (int b = 0; b < s->bodies; at_b += scene_shape(s, b++)->particles) {
            if (is_soft(s, b)) continue;
            for (int f = 0; f < cloth->mesh.faces; f++) {
                const int *v = &cloth->face[3 * f];
                vec3 t[3] = { at_a[v[0]], at_a[v[1]], at_a[v[2]] };
                count += depth_of((hull){ t, 3 }, hull_of(s, b, at_b)) > 1e-9;
            }
        }
    }
    return count;
}
//<

//> poses-crossings
//>   And a cloth may pass through itself: then a link of it passes through a
//>   triangle.
// Does the segment from p to q pass through the triangle?
static bool passes_through(vec3 p, vec3 q, const vec3 t[3])
{
    vec3 n = vec3_cross(vec3_sub(t[1], t[0]), vec3_sub(t[2], t[0]));
    real from = vec3_dot(n, vec3_sub(p, t[0]));
    real to = vec3_dot(n, vec3_sub(q, t[0]));
    if (!(from * to < 0)) return false;
    vec3 x = vec3_add_scaled(p, from / (from - to), vec3_sub(q, p));
    for (int k = 0; k < 3; k++) {
        vec3 edge = vec3_sub(t[(k + 1) % 3], t[k]);
        if (!(vec3_dot(n, vec3_cross(edge, vec3_sub(x, t[k]))) > 0))
            return false;
    }
    return true;
}

// Links of x through triangle v of the cloth at `at` (the same body: its own).
static int crossings_of(const shape *x, const vec3 *at_x, const int *v,
                        const vec3 *at, real far)
{
    int count = 0;
    vec3 t[3] = { at[v[0]], at[v[1]], at[v[2]] };
    for (int k = 0; k < x->sticks; k++) {
        stick s = x->stick[k];
        vec3 p = at_x[s.a], q = at_x[s.b];
        if (!(fabs(p.x - t[0].x) < far && fabs(p.y - t[0].y) < far
              && fabs(p.z - t[0].z) < far)) continue;
        bool shares = false;
        for (int i = 0; i < 3; i++)
            shares |= at_x == at && (v[i] == s.a || v[i] == s.b);
        count += !shares && passes_through(p, q, t);
    }
    return count;
}

int poses_crossings(const scene *s, const vec3 *at)
{
    int count = 0;
    const vec3 *at_a = at;
    for (int a = 0; a < s->bodies; at_a += scene_shape(s, a++)->particles) {
        const shape *cloth = scene_shape(s, a);
        const vec3 *at_b = at;
        if (cloth->kind != SHAPE_CLOTH) continue;
        for (int b = 0; b < s->bodies; at_b += scene_shape(s, b++)->particles)
            for (int f = 0; f < cloth->mesh.faces && is_soft(s, b); f++)
                count += crossings_of(scene_shape(s, b), at_b,
                                      &cloth->face[3 * f], at_a,
                                      4 * real_max(cloth->spacing,
                                          scene_shape(s, b)->spacing));
    }
    return count;
}
//<
