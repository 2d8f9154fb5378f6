//> surface-box
//>   A box is asked in one of two ways: when does a box that moves meet it, or
//>   how far is it?
#include "surface.h"
#include "table.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// On one axis, from when to when is what begins at 0 between low and high, on a way
// of that length?
static void overlap(real low, real high, real delta, real *begin, real *end)
{
    if (delta == 0) {
        if (low > 0 || high < 0) *end = -HUGE_VAL;
        return;
    }
    real first = (delta > 0 ? low : high) / delta;
    real last = (delta > 0 ? high : low) / delta;
    *begin = real_max(*begin, first);
    *end = real_min(*end, last);
}

// The share of the way after which the origin is in the box; HUGE_VAL: never.
static real box_time_of_impact(const aabb *box, vec3 delta)
{
    real begin = 0, end = 1;
    overlap(box->low.x, box->high.x, delta.x, &begin, &end);
    overlap(box->low.y, box->high.y, delta.y, &begin, &end);
    overlap(box->low.z, box->high.z, delta.z, &begin, &end);
    return begin <= end ? begin : HUGE_VAL;
}

// Box b, larger by the box that is asked about, is what that one is as a point.
static real reaches(const surface_query *q, const aabb *b)
{
    const vec3 origin = { 0, 0, 0 };
    aabb box = { vec3_sub(b->low, q->thing.high),
                 vec3_sub(b->high, q->thing.low) };
    return q->by_distance ? sqrt(aabb_distance_squared(&box, origin))
                          : box_time_of_impact(&box, q->delta);
}
//<

//> surface-prism
//>   Each triangle is the top of a prism.
static vec3 normal_of(const surface *s, const int v[3])
{
    return vec3_cross(vec3_sub(s->point[v[1]], s->point[v[0]]),
                      vec3_sub(s->point[v[2]], s->point[v[0]]));
}

static vec3 middle_of(const surface *s, const int v[3])
{
    return vec3_scale(1.0 / 3, vec3_add(s->point[v[0]],
                      vec3_add(s->point[v[1]], s->point[v[2]])));
}

void surface_prism(const surface *s, int triangle, vec3 at[PRISM_CORNERS])
{
    const int *v = s->triangle[triangle];
    vec3 down = s->down, middle = middle_of(s, v);
    real size = s->thickness > 0 ? 0.5 : 1;     // of the lower triangle
    if (s->thickness > 0)
        down = vec3_scale(-s->deep[triangle], vec3_unit(normal_of(s, v)));
    for (int k = 0; k < 3; k++) {
        at[k] = s->point[v[k]];
        vec3 in = vec3_scale(1 - size, vec3_sub(middle, at[k]));
        at[k + 3] = vec3_add(vec3_add(at[k], in), down);
    }
}

// A little larger, by what rounding may take away.
static aabb box_of(const surface *s, int triangle)
{
    vec3 at[PRISM_CORNERS];
    aabb b = aabb_empty();
    real size = 0;
    surface_prism(s, triangle, at);
    for (int k = 0; k < PRISM_CORNERS; k++) {
        b = aabb_with(b, at[k]);
        size = real_max(size, vec3_length_squared(at[k]));
    }
    return aabb_wider(b, 0x1p-40 * sqrt(size));
}

static const real THIN_FACE = 1e-6;

// m, of the sides of a triangle.
typedef struct {
    real least, most;
} side_range;

static side_range sides_of(const surface *s, const int v[3])
{
    side_range r = { HUGE_VAL, 0 };
    for (int i = 0; i < 3; i++) {
        vec3 side = vec3_sub(s->point[v[(i + 1) % 3]], s->point[v[i]]);
        r.least = real_min(r.least, vec3_length(side));
        r.most = real_max(r.most, vec3_length(side));
    }
    return r;
}

static const int PRISM[8][3] = {
    { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4 }, { 0, 4, 1 },
    { 1, 4, 5 }, { 1, 5, 2 }, { 2, 5, 3 }, { 2, 3, 0 } };

status surface_shape(const surface *s, int triangle, shape *made, vec3 *center)
{
    vec3 at[PRISM_CORNERS], sum = { 0, 0, 0 };
    status done = shape_begin(made, SHAPE_RIGID, PRISM_CORNERS, 12, 1);
    if (done.ok) done = shape_span(made, PRISM, 8);
    if (!done.ok) return shape_finish(made, done);
    surface_prism(s, triangle, at);
    for (int k = 0; k < PRISM_CORNERS; k++) sum = vec3_add(sum, at[k]);
    *center = vec3_scale(1.0 / PRISM_CORNERS, sum);
    for (int k = 0; k < PRISM_CORNERS; k++)
        made->at[k] = vec3_sub(at[k], *center);
    shape_add_edges(made);
    return shape_finish(made, done);
}
//<

//> surface-entry
//>   Seen along the way, a triangle is one of a plane, and the way is its origin.
//>   Has it that inside? Of a x b - c d, where each product is rounded once, the
//>   sign is right, or the result is 0. And two triangles see a corner that they
//>   share at the same place. So where an edge is met as inside, no way gets
//>   between triangles (after Woop, Benthin and Wald 2013).
static plane plane_of(vec3 normal, vec3 x)
{
    vec3 n = vec3_unit(normal);
    return (plane){ n, vec3_dot(n, x) };
}

plane surface_plane(const surface *s, int triangle)
{
    const int *v = s->triangle[triangle];
    return plane_of(normal_of(s, v), s->point[v[0]]);
}

// Point p, from where the way begins, seen along it.
static void project_along(vec3 delta, vec3 p, real seen[2])
{
    const real d[3] = { delta.x, delta.y, delta.z }, at[3] = { p.x, p.y, p.z };
    int k = fabs(d[0]) > fabs(d[1]) ? 0 : 1;
    if (fabs(d[2]) > fabs(d[k])) k = 2;
    for (int i = 0; i < 2; i++) {
        int axis = (k + 1 + i) % 3;
        seen[i] = at[axis] - d[axis] / d[k] * at[k];
    }
}

real surface_entry(const surface *s, int triangle, vec3 from, vec3 to)
{
    const int *v = s->triangle[triangle];
    vec3 n = normal_of(s, v), delta = vec3_sub(to, from);
    real over = vec3_dot(n, vec3_sub(from, s->point[v[0]]));
    real under = -vec3_dot(n, vec3_sub(to, s->point[v[0]]));
    real seen[3][2];
    bool is_left = true, is_right = true;
    if (!(over >= 0 && under > 0)) return HUGE_VAL;
    for (int i = 0; i < 3; i++)
        project_along(delta, vec3_sub(s->point[v[i]], from), seen[i]);
    for (int i = 0; i < 3; i++) {
        const real *a = seen[i], *b = seen[(i + 1) % 3];
        real side = a[0] * b[1] - a[1] * b[0];
        is_left &= side >= 0;
        is_right &= side <= 0;
    }
    return is_left || is_right ? over / (over + under) : HUGE_VAL;
}
//<

//> surface-below
//>   From behind, a way is in a prism when it is behind all of its five planes.
real surface_entry_below(const surface *s, int triangle, vec3 from, vec3 to,
                         plane *side)
{
    static const int face[] = { 0, 1, 2, 4, 6 };    // of PRISM
    vec3 at[PRISM_CORNERS];
    real in = -1, out = 1;
    int through = -1;
    surface_prism(s, triangle, at);
    for (int i = 0; i < 5; i++) {
        const int *v = PRISM[face[i]];
        vec3 n = vec3_cross(vec3_sub(at[v[1]], at[v[0]]),
                            vec3_sub(at[v[2]], at[v[0]]));
        real start = vec3_dot(n, vec3_sub(from, at[v[0]]));
        real end = vec3_dot(n, vec3_sub(to, at[v[0]]));
        real fraction = start / (start - end);
        if (start > 0 && !(end < 0)) return HUGE_VAL;
        if (start > 0 && fraction > in) {
            in = fraction;
            through = i;
            *side = plane_of(n, at[v[0]]);
        }
        if (!(start > 0) && end > 0) out = real_min(out, fraction);
    }
    if (through < 0) return -1;
    return through > 0 && in <= out ? in : HUGE_VAL;
}
//<

//> surface-ask
//>   The nearer of two boxes is asked first, so that what it holds may leave out
//>   the other.
static void query_leaf(surface_query *q, const aabb_tree *t, int leaf)
{
    for (int k = leaf * A_LEAF; k < aabb_tree_end(t, leaf); k++)
        if (reaches(q, &t->around[k]) <= q->most)
            q->most = q->meets(q->context, t->number[k]);
}

// Box k, which begins there.  It calls itself no deeper than an int has bits.
static void query_boxes(surface_query *q, const aabb_tree *t, int k, real begins)
{
    if (!(begins <= q->most)) return;
    if (k >= t->leaves) {
        query_leaf(q, t, k - t->leaves);
        return;
    }
    real one = reaches(q, &t->node[2 * k]);
    real other = reaches(q, &t->node[2 * k + 1]);
    bool is_one_first = one <= other;
    query_boxes(q, t, 2 * k + !is_one_first, is_one_first ? one : other);
    query_boxes(q, t, 2 * k + is_one_first, is_one_first ? other : one);
}

void surface_visit(const surface *s, surface_query *q)
{
    query_boxes(q, &s->prisms, 1, reaches(q, &s->prisms.node[1]));
}
//<

//> surface-deep
//>   Behind the face of a thin wall is its other face. What is solid there ends
//>   halfway: no prism sticks out of another face. It is asked at four places,
//>   behind the middle and behind the corners of the lower triangle.
enum { LOOKS = 4 };

typedef struct {
    const surface *s;
    int  triangle;          // whose
    vec3 from[LOOKS], delta;  // m
    real fraction;          // of the way to what is behind
} look_behind;

static real measure_behind(void *context, int triangle)
{
    look_behind *l = context;
    const int *v = l->s->triangle[triangle];
    aabb b = aabb_empty();
    for (int i = 0; i < 3; i++) b = aabb_with(b, l->s->point[v[i]]);
    for (int k = 0; k < LOOKS && triangle != l->triangle; k++) {
        vec3 from = l->from[k], to = vec3_add(from, l->delta);
        aabb w = aabb_with((aabb){ from, from }, to);
        if (!aabbs_meet(&w, &b)) continue;
        real in = surface_entry(l->s, triangle, from, to);
        real out = 1 - surface_entry(l->s, triangle, to, from);
        if (in <= 1) l->fraction = real_min(l->fraction, in);
        if (out >= 0) l->fraction = real_min(l->fraction, out);
    }
    return 1;
}

// (It begins a little before the triangle, at whose place may be another.)
static real depth_of(const surface *s, int triangle)
{
    const int *v = s->triangle[triangle];
    vec3 middle = middle_of(s, v), n = vec3_unit(normal_of(s, v));
    look_behind l = { s, triangle, { { 0, 0, 0 } },
                      vec3_scale(-2 * s->thickness, n), 1 };
    surface_query q = { .thing = aabb_empty(), .most = 1, .meets = measure_behind,
                        .context = &l };
    for (int k = 0; k < LOOKS; k++) {
        vec3 x = middle;
        if (k < 3) x = vec3_scale(0.5, vec3_add(x, s->point[v[k]]));
        l.from[k] = vec3_add_scaled(x, -1e-6, l.delta);
        q.thing = aabb_with(q.thing, l.from[k]);
        q.thing = aabb_with(q.thing, vec3_add(l.from[k], l.delta));
    }
    surface_visit(s, &q);
    real thinnest = real_max(0.01 * s->thickness,
                             2 * THIN_FACE * sides_of(s, v).most);
    return real_min(real_max(s->thickness * l.fraction, thinnest), s->thickness);
}

// All are as deep as can be while the tree is asked, and have their boxes then.
static bool find_depths(surface *s)
{
    aabb_tree *t = &s->prisms;
    real *deep = malloc((size_t)s->triangles * sizeof *deep);
    if (!deep) return false;
    for (int k = 0; k < t->things; k++)
        deep[t->number[k]] = depth_of(s, t->number[k]);
    for (int k = 0; k < t->things; k++)
        s->deep[t->number[k]] = deep[t->number[k]];
    for (int k = 0; k < t->things; k++)
        t->around[k] = box_of(s, t->number[k]);
    free(deep);
    aabb_tree_build(t);
    return true;
}
//<

//> surface-check
//>   Bad input is refused when a surface is made.
static status check_counts(int points, int triangles)
{
    enum { MOST = 1 << 28 };
    if (points < 3 || points > MOST)
        return status_fail("a surface of %d points is none: it has from 3 to "
                           "%d", points, MOST);
    if (triangles < 1 || triangles > MOST)
        return status_fail("a surface of %d triangles is none: it has from 1 "
                           "to %d", triangles, MOST);
    return status_ok();
}

static status check_numbers(const vec3 *point, int points,
                            const int (*triangle)[3], int triangles)
{
    const real far = 1e60;      // m, as corners of bodies
    for (int k = 0; k < points; k++)
        if (!(vec3_length(point[k]) <= far))
            return status_fail("point %d of a surface is (%g, %g, %g): it must "
                               "be finite, and no further away than 1e60 m", k,
                               point[k].x, point[k].y, point[k].z);
    for (int k = 0; k < triangles; k++)
        for (int i = 0; i < 3; i++)
            if (triangle[k][i] < 0 || triangle[k][i] >= points)
                return status_fail("triangle %d of a surface names point %d, "
                                   "and there are %d", k, triangle[k][i],
                                   points);
    return status_ok();
}

// m, the prism of a triangle at right angles to it; 0: it has no area.
static real triangle_height(const surface *s, int k, real longest)
{
    vec3 n = normal_of(s, s->triangle[k]);
    real area = vec3_length(n);
    if (!(area > THIN_FACE * longest * longest)) return 0;
    return s->thickness > 0 ? s->thickness : -vec3_dot(n, s->down) / area;
}

// Can bodies be where it is, as placement_check has it?
static status check_place(const surface *s, int k, side_range sides, real height)
{
    real away = vec3_length(s->point[s->triangle[k][0]]);
    if (!(height > THIN_FACE * sides.most))
        return status_fail("triangle %d of a surface is %g m thick, and %g m "
                           "long: that is too thin", k, height, sides.most);
    if (!(away + sides.most <= MOST_AWAY * real_min(sides.least, height)))
        return status_fail("triangle %d of a surface is too small to be %g m "
                           "away", k, away);
    return status_ok();
}

static status list_prisms(surface *s)
{
    for (int k = 0; k < s->triangles; k++) {
        side_range sides = sides_of(s, s->triangle[k]);
        real height = triangle_height(s, k, sides.most);
        if (height == 0) continue;
        status done = check_place(s, k, sides, height);
        if (!done.ok) return done;
        s->prisms.around[s->prisms.things] = box_of(s, k);
        s->prisms.number[s->prisms.things++] = k;
    }
    if (s->prisms.things > 0) return status_ok();
    return status_fail("no triangle of a surface has an area");
}
//<

//> surface-make
//>   So what is there is good.
static bool copy(surface *s, const vec3 *point, const int (*triangle)[3])
{
    bool ok = true;
#define GROW(table, n) TABLE_GROW(ok, s->table, 0, n);
    SURFACE_TABLES(GROW, s)
#undef GROW
    if (!ok) return false;
    for (int k = 0; k < s->triangles; k++) s->deep[k] = s->thickness;
    memcpy(s->point, point, (size_t)s->points * sizeof *point);
    memcpy(s->triangle, triangle, (size_t)s->triangles * sizeof *triangle);
    return true;
}

status surface_make(surface *s, const vec3 *point, int points,
                    const int (*triangle)[3], int triangles, vec3 down,
                    real thickness)
{
    *s = (surface){ .points = points, .triangles = triangles, .down = down,
                    .thickness = thickness };
    status done = check_counts(points, triangles);
    if (done.ok) done = check_numbers(point, points, triangle, triangles);
    if (done.ok && !copy(s, point, triangle)) done = status_out_of_memory();
    if (done.ok) done = list_prisms(s);
    if (done.ok) aabb_tree_build(&s->prisms);
    if (done.ok && thickness > 0 && !find_depths(s))
        done = status_out_of_memory();
    if (!done.ok) surface_free(s);
    return done;
}

void surface_free(surface *s)
{
#define FREE(table, n) free(s->table);
    SURFACE_TABLES(FREE, s)
#undef FREE
    *s = (surface){ .points = 0 };
}
//<
