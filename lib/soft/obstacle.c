//> hull-planes
//>   Triangles that lie in one plane give it once, so a cube has six planes and
//>   not twelve.
#include "obstacle.h"

#include <assert.h>
#include <stddef.h>

// Does face v lie in plane p, up to rounding?  It looks the same way, and no
// corner of it is off the plane by more than a billionth of the body's size.
static bool lies_in_plane(const int *v, vec3 normal, const vec3 *at, plane p,
                          real size)
{
    if (!(vec3_dot(p.normal, normal) > 0)) return false;
    for (int k = 0; k < 3; k++)
        if (!(fabs(plane_height(p, at[v[k]])) <= 1e-9 * size)) return false;
    return true;
}

int hull_planes(const shape *s, const vec3 *at, plane *out)
{
    int n = 0;
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 m = vec3_unit(triangle_normal(at[v[0]], at[v[1]], at[v[2]]));
        plane p = { m, vec3_dot(m, at[v[0]]) };
        int k = 0;
        while (k < n && !lies_in_plane(v, m, at, out[k], s->radius)) k++;
        if (k == n) out[n++] = p;
    }
    for (int k = 0; k < n; k++) out[k].offset += s->round;
    return n;
}
//<

//> hull-ahead
int hull_ahead(vec3 x, const plane *p, int count)
{
    int best = 0;
    real most = -HUGE_VAL;
    for (int k = 0; k < count; k++) {
        real up = plane_height(p[k], x);
        if (up > most) { most = up; best = k; }
    }
    return best;
}
//<

//> obstacle-over
//>   A particle that touches mostly stands over a face, the one that it stood
//>   over before. If its foot on that plane lies on the body, no other plane is
//>   as far below it, and none needs to be compared.
static surface_point under(const obstacle *b, vec3 x, int k)
{
    plane p = b->plane[k];
    return (surface_point){
        vec3_add_scaled(x, -plane_height(p, x), p.normal), p.normal };
}

// Up to rounding.
static bool is_behind_faces(const obstacle *b, vec3 x)
{
    for (int k = 0; k < b->planes; k++)
        if (plane_height(b->plane[k], x) > 1e-12 * b->size) return false;
    return true;
}

// Is x in front of plane k, and the point of the plane under x on the body?
// Then no other plane is as far under x: from there to x plane k rises with all
// of the way, another one with a part of it, and it began no higher.
static bool stands_over(const obstacle *b, vec3 x, int k)
{
    return plane_height(b->plane[k], x) > 0
        && is_behind_faces(b, under(b, x, k).at);
}
//<

//> obstacle-over-edge
// Two planes that meet at less than a thousandth of a radian have no edge that
// rounding could tell.
static const real SHARP = 1e-6;

// Of the planes that the foot of x on plane k is in front of, the foremost is
// the face beyond an edge, if one is.  The point of that edge under x is x less
// a times the one normal and b times the other.  If it is on the body, and a and
// b are positive, none is nearer: all of the body is behind the plane through it
// at right angles to the way to x.
static bool stands_over_edge(const obstacle *b, vec3 x, int k,
                             surface_point *out)
{
    plane p = b->plane[k];
    plane q = b->plane[hull_ahead(under(b, x, k).at, b->plane, b->planes)];
    real up = plane_height(p, x), beyond = plane_height(q, x);
    real both = vec3_dot(p.normal, q.normal), sine2 = 1 - both * both;
    real of_p = up - both * beyond, of_q = beyond - both * up;
    if (!(sine2 > SHARP && of_p > 0 && of_q > 0)) return false;
    vec3 delta = vec3_add_scaled(vec3_scale(of_p / sine2, p.normal),
                                 of_q / sine2, q.normal);
    *out = (surface_point){ vec3_sub(x, delta), vec3_unit(delta) };
    return is_behind_faces(b, out->at);
}
//<

//> obstacle-edge
//>   Over a corner, GJK finds the nearest point, with the particle as a body of
//>   one point.
// Over no face: an edge or a corner is nearest.  Of a corner, or an edge that is
// not seen at once, the query of two bodies finds it, one of them being a point.
static bool nearest_on_edge(const obstacle *b, vec3 x, int ahead, real reach,
                            surface_point *out)
{
    if (stands_over_edge(b, x, ahead, out))
        return vec3_dot(vec3_sub(x, out->at), out->normal) <= reach;
    hull point = { &x, 1 };
    gjk_result g = gjk_distance(point, b->vertices, reach, NULL);
    if (g.status != GJK_APART || g.distance > reach) return false;
    *out = (surface_point){ g.on_b, vec3_scale(1 / g.distance, g.axis) };
    return true;
}
//<

//> obstacle-round
//>   A ball or a capsule has no planes. One formula gives the nearest point of
//>   its core, and the surface is a radius further out.
// The nearest point of the core, and out of it along the way to x.  From a point
// of the core itself all ways out are as long: straight up, or across it.
static surface_point round_point(const obstacle *b, vec3 x)
{
    const vec3 *v = b->vertices.at;
    vec3 core = v[0], along = { 0, 0, 0 };
    if (b->vertices.count > 1) {
        along = vec3_sub(v[1], v[0]);
        real part = vec3_dot(vec3_sub(x, core), along)
                  / vec3_length_squared(along);
        core = vec3_add_scaled(core, real_max(real_min(part, 1), 0), along);
    }
    vec3 out = vec3_sub(x, core);
    if (vec3_length_squared(out) == 0)
        out = vec3_cross(along, fabs(along.x) < fabs(along.z)
                                ? vec3_make(1, 0, 0) : vec3_make(0, 0, 1));
    if (vec3_length_squared(out) == 0) out = vec3_make(0, 1, 0);
    vec3 normal = vec3_unit(out);
    return (surface_point){ vec3_add_scaled(core, b->round, normal), normal };
}

plane obstacle_plane(const obstacle *b, vec3 x, int number)
{
    if (b->planes > 0) return b->plane[number];
    surface_point p = round_point(b, x);
    return (plane){ p.normal, vec3_dot(p.normal, p.at) };
}

static bool nearest_on_round(const obstacle *b, vec3 x, real reach,
                             surface_point *out)
{
    *out = round_point(b, x);
    return vec3_dot(vec3_sub(x, out->at), out->normal) <= reach;
}
//<

//> obstacle-rounded
//>   Of a rounded hull the planes lie a radius outside of its core.  What is not
//>   in the core is out from the core's nearest point.
static bool nearest_on_rounded(const obstacle *b, vec3 x, int ahead, real reach,
                               surface_point *out)
{
    bool is_known = ahead < b->planes;
    if (is_known && plane_height(b->plane[ahead], x) > reach) return false;
    real near = reach + b->round;
    gjk_result g = gjk_distance((hull){ &x, 1 }, b->vertices, near, NULL);
    if (g.status == GJK_OVERLAP)
        *out = under(b, x, hull_ahead(x, b->plane, b->planes));
    if (g.status != GJK_APART) return g.status == GJK_OVERLAP;
    vec3 normal = vec3_scale(1 / g.distance, g.axis);
    *out = (surface_point){ vec3_add_scaled(g.on_b, b->round, normal), normal };
    return g.distance <= near;
}
//<

//> obstacle-nearest
// The commonest answers by far are two: a particle is clear of the plane that
// it was in front of, or it still stands over that face.
bool obstacle_nearest(const obstacle *b, vec3 x, int ahead, real reach,
                      surface_point *out)
{
    assert(b->planes > 0 || b->round > 0);
    if (b->planes == 0) return nearest_on_round(b, x, reach, out);
    if (b->round > 0) return nearest_on_rounded(b, x, ahead, reach, out);
    bool is_known = ahead < b->planes;
    if (is_known && plane_height(b->plane[ahead], x) > reach) return false;
    if (!is_known || !stands_over(b, x, ahead)) {
        ahead = hull_ahead(x, b->plane, b->planes);
        real up = plane_height(b->plane[ahead], x);
        if (!(up <= reach)) return false;
        if (up > 0 && !stands_over(b, x, ahead))
            return nearest_on_edge(b, x, ahead, reach, out);
    }
    *out = under(b, x, ahead);
    return true;
}
//<

//> obstacle-apart
//>   Two convex bodies are apart if there is a plane between them. That of a face
//>   mostly is one; if none is, GJK knows.
bool obstacle_is_apart(const obstacle *b, const vec3 *at, int count, int *ahead)
{
    for (int k = -1; k < count && b->planes > 0; k++) {
        if (k >= 0) *ahead = hull_ahead(at[k], b->plane, b->planes);
        plane p = b->plane[*ahead < b->planes ? *ahead : 0];
        real least = HUGE_VAL;
        for (int i = 0; i < count; i++)
            least = real_min(least, plane_height(p, at[i]));
        if (least > 0) return true;
    }
    gjk_result g = gjk_distance((hull){ at, count }, b->vertices, b->round, NULL);
    return g.status == GJK_BEYOND || g.status == GJK_NOT_FINITE
        || g.distance > b->round;
}
//<
