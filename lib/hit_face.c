//> hit-face-scratch
#include "hit_face.h"

#include <assert.h>
#include <float.h>
#include <stdlib.h>

// A closed polytope of n points has 2 n - 4 triangles (Euler), and while a
// point is put on it a fan of at most n more: no face ever wants for a slot.
enum { POINTS_AT_MOST = 512, FACES_AT_MOST = 3 * POINTS_AT_MOST };

// A point of A - B and the vertices whose difference it is.
typedef struct {
    vec3 at;
    int  a, b;
} peak;

// A triangle of the polytope, counter-clockwise from outside.
typedef struct {
    int  corner[3];
    int  across[3];     // the face beyond the edge corner[i], corner[i + 1]
    vec3 normal;        // outward, as long as twice the area
    real shorten;       // normal times this is a unit vector
    real doubt;         // a smaller |normal . (x - corner)| has no sure sign
    int  asked;         // twice the number of the point that last looked at
                        // this face, plus 1 if it saw the front
} face;

// The polytope: part of the hull of A - B, closed, and convex to the last bit.
struct hit_scratch {
    point_set a, b;
    real scale;         // lengths times this: |x|, |y|, |z| <= 1 in A - B
    int  points, faces, unused;
    peak point[POINTS_AT_MOST];
    face face[FACES_AT_MOST];
    real height[FACES_AT_MOST];  // of its plane over the origin; no face here:
                                 // infinite
    int  unused_face[FACES_AT_MOST];
    int  front[FACES_AT_MOST];   // the faces that a new point sees
    int  fan[POINTS_AT_MOST];    // the new face whose edge starts at this point
};

// Heights that differ by less are the same: four steps of the grid.
static const real level = 0x1p-48;

hit_scratch *hit_scratch_new(void)
{
    return malloc(sizeof(hit_scratch));
}

void hit_scratch_free(hit_scratch *scratch)
{
    free(scratch);
}
//<

//> hit-face-exact
// The cross product e x f of two edges on the grid, exactly.
static void exact_cross(vec3 e, vec3 f, rounded n[3])
{
    n[0] = exact_minor(e.y, f.z, e.z, f.y);
    n[1] = exact_minor(e.z, f.x, e.x, f.z);
    n[2] = exact_minor(e.x, f.y, e.y, f.x);
}

// The exact sign of n . d: 1, 0 or -1.  Every product of a part of n with a
// coordinate is a pair; the twelve parts are added one by one to an expansion,
// a sum of doubles of which each lies wholly below the next.
static int exact_sign(const rounded n[3], vec3 d)
{
    real coordinate[3] = { d.x, d.y, d.z };
    real sum[12] = { 0 };
    int terms = 0;
    for (int k = 0; k < 3; k++) {
        rounded part[2] = { exact_product(n[k].high, coordinate[k]),
                        exact_product(n[k].low, coordinate[k]) };
        real term[4] = { part[1].low, part[1].high, part[0].low, part[0].high };
        for (int t = 0; t < 4; t++) {
            real carry = term[t];
            for (int i = 0; i < terms; i++) {
                rounded s = exact_sum(carry, sum[i]);
                sum[i] = s.low;
                carry = s.high;
            }
            sum[terms++] = carry;
        }
    }
    for (int i = terms - 1; i >= 0; i--)
        if (sum[i] > 0 || sum[i] < 0) return sum[i] > 0 ? 1 : -1;
    return 0;
}
//<

//> hit-face-grid
// The point of A - B from these vertices, on the grid.  Next to 6 the doubles
// are 2^-50 apart: adding 6 rounds to the grid, subtracting it is exact.
static peak peak_make(const hit_scratch *h, int a, int b)
{
    vec3 d = vec3_scale(h->scale, vec3_sub(h->a.at[a], h->b.at[b]));
    vec3 at = { (d.x + 6) - 6, (d.y + 6) - 6, (d.z + 6) - 6 };
    return (peak){ at, a, b };
}

// The point of A - B furthest along n.  n is scaled as A - B is: so its
// products with the vertices, and their sums, are numbers.
static peak peak_along(const hit_scratch *h, vec3 n, peak near)
{
    int a = support_point(h->a, vec3_scale(h->scale, n), near.a);
    int b = support_point(h->b, vec3_scale(-h->scale, n), near.b);
    return peak_make(h, a, b);
}
//<

//> hit-face-scale
// The box of p; *poison becomes NaN if a coordinate is not finite.  Two points
// at a time, so that two components share one instruction of the machine: the
// odd slots are the second point's.
static void box_of(point_set p, vec3 *low, vec3 *high, real *poison)
{
    real l[6], u[6], sum[6] = { 0 };
    for (int c = 0; c < 6; c++)
        l[c] = u[c] = c % 3 == 0 ? p.at[0].x : c % 3 == 1 ? p.at[0].y
                                                          : p.at[0].z;
    for (int i = p.count % 2; i < p.count; i += 2) {
        const real x[6] = { p.at[i].x, p.at[i].y, p.at[i].z, p.at[i + 1].x,
                            p.at[i + 1].y, p.at[i + 1].z };
        for (int c = 0; c < 6; c++) {
            l[c] = x[c] < l[c] ? x[c] : l[c];
            u[c] = x[c] > u[c] ? x[c] : u[c];
            sum[c] += x[c] - x[c];
        }
    }
    for (int c = 0; c < 3; c++) {
        l[c] = l[c + 3] < l[c] ? l[c + 3] : l[c];
        u[c] = u[c + 3] > u[c] ? u[c + 3] : u[c];
        *poison += (sum[c] + sum[c + 3]) + (u[c] - u[c]);
    }
    *low = (vec3){ l[0], l[1], l[2] };
    *high = (vec3){ u[0], u[1], u[2] };
}

static real largest(vec3 v)
{
    real m = v.x > v.y ? v.x : v.y;
    return v.z > m ? v.z : m;
}

// The power of two that brings the largest coordinate of A - B into 1/2 .. 1.
// 0 if a coordinate is not finite, or so large that differences are not; 1 if
// all of A - B is one point.
static real scale_for(point_set a, point_set b)
{
    vec3 low_a, high_a, low_b, high_b;
    real poison = 0, scale = 1;
    box_of(a, &low_a, &high_a, &poison);
    box_of(b, &low_b, &high_b, &poison);
    real x = largest(vec3_sub(high_a, low_b));
    real y = largest(vec3_sub(high_b, low_a));
    real reach = (x > y ? x : y) + poison;
    if (!(reach <= 0x1p1020)) return 0;
    if (!(reach > 0)) return 1;
    static const real step[] = { 0x1p512, 0x1p256, 0x1p128, 0x1p64, 0x1p32,
                                 0x1p16, 0x1p8, 0x1p4, 0x1p2, 0x1p1 };
    // Bodies of ordinary size need small steps only.
    int ordinary = reach > 0x1p-8 && reach < 0x1p8;
    for (int k = ordinary ? 6 : 0; k < 10; k++) {
        if (reach * scale * step[k] <= 1) scale *= step[k];
        if (reach * scale > step[k]) scale /= step[k];
    }
    return reach * scale > 1 ? scale / 2 : scale;
}
//<

//> hit-face-face
static vec3 face_edge(const hit_scratch *h, const face *f, int i)
{
    return vec3_sub(h->point[f->corner[i]].at, h->point[f->corner[0]].at);
}

// Normal and height, correctly rounded.
static void face_measure_exactly(const hit_scratch *h, face *f, real *height)
{
    rounded n[3];
    exact_cross(face_edge(h, f, 1), face_edge(h, f, 2), n);
    f->normal = (vec3){ n[0].high, n[1].high, n[2].high };
    f->shorten = 1 / vec3_length(f->normal);
    *height = vec3_dot(f->normal, h->point[f->corner[0]].at)
            / vec3_length(f->normal);
}

// Normal and height.  In a thin triangle the cross product cancels: there the
// exact one is taken.
static void face_measure(const hit_scratch *h, face *f, real *height)
{
    vec3 e = face_edge(h, f, 1), g = face_edge(h, f, 2);
    real ee = vec3_length_squared(e), gg = vec3_length_squared(g);
    f->normal = vec3_cross(e, g);
    real nn = vec3_length_squared(f->normal);
    f->asked = 0;
    f->doubt = 64 * DBL_EPSILON * (fabs(e.x) + fabs(e.y) + fabs(e.z))
                                * (fabs(g.x) + fabs(g.y) + fabs(g.z));
    f->shorten = 1 / sqrt(nn);
    *height = vec3_dot(f->normal, h->point[f->corner[0]].at) * f->shorten;
    if (nn < ee * gg * 0x1p-8) face_measure_exactly(h, f, height);
}
//<

//> hit-face-side
// The side of the plane of f that x is on: 1 before it, 0 in it, -1 behind it.
static int face_side(const hit_scratch *h, const face *f, vec3 x)
{
    vec3 d = vec3_sub(x, h->point[f->corner[0]].at);
    real along = vec3_dot(f->normal, d);
    if (along > f->doubt) return 1;
    if (along < -f->doubt) return -1;
    rounded n[3];
    exact_cross(face_edge(h, f, 1), face_edge(h, f, 2), n);
    return exact_sign(n, d);
}

// A slot for a face.
static int face_take(hit_scratch *h)
{
    if (h->unused > 0) return h->unused_face[--h->unused];
    assert(h->faces < FACES_AT_MOST);
    return h->faces++;
}
//<

//> hit-face-front
// Marks the faces that `x` sees, from face f on, and lists them in front.  A
// face that x lies in counts as seen: so no new triangle has an edge through x
// in its own plane, and none is flat.  Returns their number.
static int mark_front(hit_scratch *h, int f, int number)
{
    vec3 x = h->point[number].at;
    int found = 0;
    h->front[found++] = f;
    h->face[f].asked = 2 * number + 1;
    for (int next = 0; next < found; next++) {
        for (int i = 0; i < 3; i++) {
            int g = h->face[h->front[next]].across[i];
            face *other = &h->face[g];
            if (other->asked >> 1 == number) continue;
            int seen = face_side(h, other, x) >= 0;
            other->asked = 2 * number + seen;
            if (seen) h->front[found++] = g;
        }
    }
    return found;
}
//<

//> hit-face-raise
// A new face from the edge u, v (beyond which lies face `old`) to the point
// `number`.
static void raise_face(hit_scratch *h, int u, int v, int number, int old,
                       int front)
{
    int made = face_take(h);
    face *f = &h->face[made], *beyond = &h->face[old];
    f->corner[0] = u;
    f->corner[1] = v;
    f->corner[2] = number;
    f->across[0] = old;
    for (int j = 0; j < 3; j++)
        if (beyond->across[j] == front) beyond->across[j] = made;
    face_measure(h, f, &h->height[made]);
    h->fan[u] = made;
}
//<

//> hit-face-expand
// Puts the point `number` on the polytope, whose face f it sees: the faces that
// it sees go, and a fan from their rim to the point comes.
static void polytope_expand(hit_scratch *h, int f, int number)
{
    int seen = mark_front(h, f, number), rim = 0, u = -1;
    for (int s = 0; s < seen; s++) {
        int g = h->front[s];
        for (int i = 0; i < 3; i++) {
            int old = h->face[g].across[i];
            if (h->face[old].asked == 2 * number + 1) continue;
            u = h->face[g].corner[i];
            raise_face(h, u, h->face[g].corner[(i + 1) % 3], number, old, g);
            rim++;
        }
    }
    for (int s = 0; s < seen; s++) {
        h->height[h->front[s]] = HUGE_VAL;
        h->unused_face[h->unused++] = h->front[s];
    }
    // The rim is one ring of edges: each new face's neighbour starts where its
    // own edge ends.
    for (; rim > 0; rim--) {
        int made = h->fan[u], v = h->face[made].corner[1], after = h->fan[v];
        h->face[made].across[1] = after;
        h->face[after].across[2] = made;
        u = v;
    }
}
//<

//> hit-face-flat
// The point of A - B furthest from the plane through x with this normal, on
// either side; its height over the plane in *height.
static peak peak_off_plane(const hit_scratch *h, vec3 x, vec3 n, peak near,
                           real *height)
{
    peak up = peak_along(h, n, near);
    peak down = peak_along(h, vec3_scale(-1, n), near);
    real over = vec3_dot(n, vec3_sub(up.at, x));
    real under = vec3_dot(n, vec3_sub(x, down.at));
    *height = over >= under ? over : under;
    return over >= under ? up : down;
}

// The unit vector along that axis to which v is most nearly perpendicular.
static vec3 axis_across(vec3 v)
{
    real x = fabs(v.x), y = fabs(v.y), z = fabs(v.z);
    if (x <= y && x <= z) return (vec3){ 1, 0, 0 };
    return y <= z ? (vec3){ 0, 1, 0 } : (vec3){ 0, 0, 1 };
}

// Any unit vector perpendicular to v, which has a direction.
static vec3 unit_across(vec3 v)
{
    return vec3_unit(vec3_cross(v, axis_across(v)));
}
//<

//> hit-face-off
// The point of A - B furthest from x, along three axes.
static peak peak_off_point(const hit_scratch *h, peak x)
{
    peak best = x;
    real furthest = 0;
    for (int k = 0; k < 6; k++) {
        real way = k % 2 ? -1 : 1;
        vec3 d = { way * (k / 2 == 0), way * (k / 2 == 1), way * (k / 2 == 2) };
        peak y = peak_along(h, d, x);
        real dd = vec3_length_squared(vec3_sub(y.at, x.at));
        if (dd > furthest) {
            furthest = dd;
            best = y;
        }
    }
    return best;
}

// The point of A - B furthest from the line x, y, along two normals of it.
static peak peak_off_line(const hit_scratch *h, peak x, peak y)
{
    vec3 along = vec3_unit(vec3_sub(y.at, x.at));
    vec3 n = unit_across(along), m = vec3_cross(along, n);
    real up, side;
    peak p = peak_off_plane(h, x.at, n, x, &up);
    peak q = peak_off_plane(h, x.at, m, x, &side);
    return up >= side ? p : q;
}
//<

//> hit-face-small
// Twice the area of x, y, z is too small for a plane.
static int is_line(peak x, peak y, peak z)
{
    vec3 e = vec3_sub(y.at, x.at), f = vec3_sub(z.at, x.at);
    real ee = vec3_length_squared(e), ff = vec3_length_squared(f);
    real nn = vec3_length_squared(vec3_cross(e, f));
    real longest = ee > ff ? ee : ff;
    return nn <= longest * level * level;
}

static int is_point(peak x, peak y)
{
    return vec3_length_squared(vec3_sub(y.at, x.at)) <= level * level;
}
//<

//> hit-face-stout
// A tetrahedron with so much room inside that rounding is no matter: mostly
// gjk's is one.  *normal is that of the first three corners.
static int is_stout(const peak p[4], vec3 *normal)
{
    vec3 e = vec3_sub(p[1].at, p[0].at), f = vec3_sub(p[2].at, p[0].at);
    vec3 g = vec3_sub(p[3].at, p[0].at);
    *normal = vec3_cross(e, f);
    return fabs(vec3_dot(*normal, g)) > 0x1p-20;
}
//<

//> hit-face-tetrahedron
// Fills p with the corners of a tetrahedron in A - B, from the corners of the
// simplex where they serve.  Returns how many could be had: 4, or one more than
// the dimension of A - B; then *normal is perpendicular to all of it.
static int tetrahedron_find(const hit_scratch *h, const simplex *start,
                            peak p[4], vec3 *normal)
{
    int n = start->count;
    for (int c = 0; c < n; c++) p[c] = peak_make(h, start->a[c], start->b[c]);
    if (n == 4 && is_stout(p, normal)) return 4;
    if (n == 0) p[0] = peak_make(h, 0, 0);
    if (n < 2 || is_point(p[0], p[1])) p[1] = peak_off_point(h, p[0]);
    *normal = (vec3){ 0, 0, 1 };
    if (is_point(p[0], p[1])) return 1;

    if (n < 3 || is_line(p[0], p[1], p[2])) p[2] = peak_off_line(h, p[0], p[1]);
    // The start's corners may lie too near to each other to show the line.
    if (is_line(p[0], p[1], p[2])) {
        p[1] = peak_off_point(h, p[0]);
        p[2] = peak_off_line(h, p[0], p[1]);
    }
    vec3 e = vec3_sub(p[1].at, p[0].at);
    *normal = unit_across(e);
    if (is_line(p[0], p[1], p[2])) return 2;

    rounded cross[3];
    exact_cross(e, vec3_sub(p[2].at, p[0].at), cross);
    *normal = vec3_unit((vec3){ cross[0].high, cross[1].high, cross[2].high });
    if (n == 4) {
        real height = vec3_dot(*normal, vec3_sub(p[3].at, p[0].at));
        if (fabs(height) > level) return 4;
    }
    real height;
    p[3] = peak_off_plane(h, p[0].at, *normal, p[0], &height);
    return height > level ? 4 : 3;
}
//<

//> hit-face-begin
// The polytope is this tetrahedron.
static void polytope_begin(hit_scratch *h, const peak p[4], vec3 normal)
{
    static const int corner[4][3] = { {0,1,2}, {0,3,1}, {1,3,2}, {2,3,0} };
    static const int across[4][3] = { {1,2,3}, {3,2,0}, {1,3,0}, {2,1,0} };
    // The face 0, 1, 2 must look away from corner 3.
    int turn = vec3_dot(normal, vec3_sub(p[3].at, p[0].at)) > 0;
    for (int c = 0; c < 4; c++) h->point[c] = p[c];
    if (turn) {
        h->point[1] = p[2];
        h->point[2] = p[1];
    }
    h->points = 4;
    h->faces = 4;
    h->unused = 0;
    for (int f = 0; f < 4; f++) {
        for (int i = 0; i < 3; i++) {
            h->face[f].corner[i] = corner[f][i];
            h->face[f].across[i] = across[f][i];
        }
        face_measure(h, &h->face[f], &h->height[f]);
    }
}

// The face whose plane is lowest over the origin; the origin is outside the
// polytope if that is below it.
static int polytope_lowest(const hit_scratch *h)
{
    int lowest = 0;
    real least = h->height[0];
    for (int f = 1; f < h->faces; f++) {
        lowest = h->height[f] < least ? f : lowest;
        least = h->height[f] < least ? h->height[f] : least;
    }
    return lowest;
}
//<

//> hit-face-weights
// The weights of the corners of f for the origin's foot x on its plane: areas,
// as in chapter 4.
static void foot_weights(const hit_scratch *h, const face *f, vec3 x,
                         real weight[3])
{
    for (int i = 0; i < 3; i++) {
        vec3 p = h->point[f->corner[(i + 1) % 3]].at;
        vec3 q = h->point[f->corner[(i + 2) % 3]].at;
        vec3 cross = vec3_cross(vec3_sub(p, x), vec3_sub(q, p));
        weight[i] = vec3_dot(f->normal, cross);
    }
}

// The areas need only be divided by their sum if x lies in the triangle, and
// that is well shaped: otherwise rounding has too large a share in them.
static int areas_serve(const hit_scratch *h, const face *f, real weight[3])
{
    vec3 e = face_edge(h, f, 1), g = face_edge(h, f, 2), k = vec3_sub(g, e);
    real ee = vec3_length_squared(e), gg = vec3_length_squared(g);
    real kk = vec3_length_squared(k), longest = ee > gg ? ee : gg;
    longest = kk > longest ? kk : longest;
    if (!(weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0)) return 0;
    if (!(vec3_length_squared(f->normal) >= 0x1p-4 * longest * longest))
        return 0;
    real share = 1 / (weight[0] + weight[1] + weight[2]);
    for (int i = 0; i < 3; i++) weight[i] *= share;
    return 1;
}
//<

//> hit-face-walk
// A side of A - B may be several triangles in one plane: walks from f to the
// one that the foot x lies in.
static int walk_to_foot(const hit_scratch *h, int f, vec3 x, real weight[3])
{
    real floor = h->height[f] + 4 * level;
    for (int steps = 0; steps < 32; steps++) {
        foot_weights(h, &h->face[f], x, weight);
        int least = 0;
        for (int i = 1; i < 3; i++)
            if (weight[i] < weight[least]) least = i;
        if (weight[least] >= 0) break;
        int g = h->face[f].across[(least + 1) % 3];
        if (!(h->height[g] <= floor)) break;
        f = g;
    }
    const int *corner = h->face[f].corner;
    if (areas_serve(h, &h->face[f], weight)) return f;
    triangle_weights(h->point[corner[0]].at, h->point[corner[1]].at,
                     h->point[corner[2]].at, x, weight);
    return f;
}
//<

//> hit-face-feature
static int same_place(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// The corners as one feature: equal vertices merged, their weights added.
static feature_point feature_merge(point_set p, const int *corner,
                                   const real *weight)
{
    feature_point f = { 0 };
    for (int i = 0; i < 3; i++) {
        int k = 0;
        while (k < f.count && f.vertex[k] != corner[i]
               && !same_place(p.at[f.vertex[k]], p.at[corner[i]])) k++;
        if (k == f.count) {
            f.vertex[f.count++] = corner[i];
            f.weight[k] = 0;
        }
        f.weight[k] += weight[i];
    }
    return f;
}

// The point that f stands for.
static vec3 feature_point_at(point_set p, const feature_point *f)
{
    vec3 base = p.at[f->vertex[0]], sum = { 0, 0, 0 };
    for (int k = 1; k < f->count; k++)
        sum = vec3_add_scaled(sum, f->weight[k],
                              vec3_sub(p.at[f->vertex[k]], base));
    return vec3_add(base, sum);
}
//<

//> hit-face-kind
// 0 a vertex, 1 an edge, 2 a face.  Three vertices that nearly lie in a line,
// or of which two nearly coincide, are an edge: the triangle's height is
// compared with its longest side.
static int feature_dimension(point_set p, const feature_point *f)
{
    if (f->count < 3) return f->count - 1;
    vec3 e = vec3_sub(p.at[f->vertex[1]], p.at[f->vertex[0]]);
    vec3 g = vec3_sub(p.at[f->vertex[2]], p.at[f->vertex[0]]);
    real ee = vec3_length_squared(e), gg = vec3_length_squared(g);
    real nn = vec3_length_squared(vec3_cross(e, g));
    real longest = ee > gg ? ee : gg;
    return nn / longest <= longest * 0x1p-80 ? 1 : 2;
}

// Paper: section 5.1 names two cases, vertex-face and edge-edge, and says that
// others "can be mapped" to them; here: the smaller feature plays the vertex,
// two edges are edge-edge, and of two equals, A's plays the vertex.
static touch_kind touch_of(int dimension_a, int dimension_b)
{
    if (dimension_a == 1 && dimension_b == 1) return TOUCH_EDGE_EDGE;
    return dimension_a > dimension_b ? TOUCH_FACE_VERTEX : TOUCH_VERTEX_FACE;
}
//<

//> hit-face-answer-flat
// Fills in corners, features, points and kind from three corners and weights.
static void answer_features(const hit_scratch *h, hit_result *r,
                            const real weight[3])
{
    r->a = feature_merge(h->a, r->corner_a, weight);
    r->b = feature_merge(h->b, r->corner_b, weight);
    r->on_a = feature_point_at(h->a, &r->a);
    r->on_b = feature_point_at(h->b, &r->b);
    r->kind = touch_of(feature_dimension(h->a, &r->a),
                       feature_dimension(h->b, &r->b));
}

// A - B has no volume: the bodies touch at the simplex that they came with, if
// that reaches the origin, and any move along the normal parts them.
static hit_result answer_flat(const hit_scratch *h, const simplex *start,
                              vec3 normal)
{
    hit_result r = { .status = HIT_FLAT, .normal = normal };
    simplex s = *start;
    if (s.count == 0) s = (simplex){ .count = 1, .weight = { 1 } };
    real weight[3] = { 0, 0, 0 }, sum = 0;
    vec3 nearest = { 0, 0, 0 };
    for (int c = 0; c < s.count && c < 3; c++) sum += s.weight[c];
    for (int i = 0; i < 3; i++) {
        int c = i < s.count ? i : 0;
        if (i < s.count) weight[i] = sum > 0 ? s.weight[i] / sum : i == 0;
        r.corner_a[i] = s.a[c];
        r.corner_b[i] = s.b[c];
        vec3 at = peak_make(h, s.a[c], s.b[c]).at;
        nearest = vec3_add_scaled(nearest, weight[i], at);
    }
    if (vec3_length(nearest) > 8 * level) r.status = HIT_APART;
    answer_features(h, &r, weight);
    return r;
}
//<

//> hit-face-answer
// The point that these weights of the corners of f make, less x.
static vec3 face_miss(const hit_scratch *h, const face *f, vec3 x,
                      const real weight[3])
{
    vec3 miss = vec3_scale(-1, x);
    for (int i = 0; i < 3; i++)
        miss = vec3_add_scaled(miss, weight[i], h->point[f->corner[i]].at);
    return miss;
}

// The answer from face f, in whose plane the foot lies at these weights.
static void answer_at(const hit_scratch *h, int f, real height, vec3 out,
                      const real weight[3], hit_result *r)
{
    for (int i = 0; i < 3; i++) {
        r->corner_a[i] = h->point[h->face[f].corner[i]].a;
        r->corner_b[i] = h->point[h->face[f].corner[i]].b;
    }
    r->depth = height / h->scale;
    r->normal = vec3_scale(-1, out);
    answer_features(h, r, weight);
}

// The answer from the lowest face, once no point lies beyond it.  Of an A - B
// that is all but flat, the origin may lie in the plane and beside the face:
// nothing of A - B is there.
static hit_result answer_face(hit_scratch *h, int f, hit_result r, real upper)
{
    const real beside = 0x1p-20;
    real weight[3];
    face_measure_exactly(h, &h->face[f], &h->height[f]);
    vec3 out = vec3_unit(h->face[f].normal);
    vec3 foot = vec3_scale(h->height[f], out);
    real height = h->height[f] > 0 ? h->height[f] : 0;
    int g = walk_to_foot(h, f, foot, weight);
    vec3 miss = face_miss(h, &h->face[g], foot, weight);
    if (r.status == HIT_FOUND && vec3_length(miss) > beside)
        r.status = HIT_APART;
    if (r.status == HIT_CAPPED) height = upper;
    answer_at(h, g, height, out, weight, &r);
    return r;
}
//<

//> hit-face-find
hit_result hit_face_find(point_set a, point_set b, const simplex *start,
                         hit_scratch *scratch)
{
    assert(scratch && start && start->count >= 0 && start->count <= 4);
    hit_scratch *h = scratch;
    h->a = a;
    h->b = b;
    h->scale = scale_for(a, b);
    hit_result r = { .status = HIT_NOT_FINITE };
    if (!(h->scale > 0)) return r;

    peak p[4];
    vec3 normal;
    int corners = tetrahedron_find(h, start, p, &normal);
    if (corners < 4) return answer_flat(h, start, normal);
    polytope_begin(h, p, normal);

    for (;;) {
        int f = polytope_lowest(h);
        vec3 out = vec3_scale(h->face[f].shorten, h->face[f].normal);
        peak w = peak_along(h, out, h->point[h->face[f].corner[0]]);
        r.iterations++;
        real upper = vec3_dot(out, w.at);
        // Nothing lies beyond: this face belongs to A - B itself.
        if (upper - h->height[f] <= level
            || face_side(h, &h->face[f], w.at) <= 0) {
            r.status = h->height[f] < -4 * level ? HIT_APART : HIT_FOUND;
            return answer_face(h, f, r, upper);
        }
        r.status = HIT_CAPPED;
        if (h->points == POINTS_AT_MOST) return answer_face(h, f, r, upper);
        h->point[h->points] = w;
        polytope_expand(h, f, h->points++);
    }
}
//<

//> hit-face-remember
void hit_face_remember(const hit_scratch *h, hit_memory *m)
{
    m->faces = 0;
    if (h->points > HIT_MEMORY_POINTS) return;
    m->scale = h->scale;
    m->points = h->points;
    for (int c = 0; c < h->points; c++) {
        m->a[c] = h->point[c].a;
        m->b[c] = h->point[c].b;
    }
    for (int f = 0; f < h->faces; f++) {
        if (!(h->height[f] < HUGE_VAL)) continue;
        for (int i = 0; i < 3; i++)
            m->corner[m->faces][i] = (unsigned char)h->face[f].corner[i];
        m->faces++;
    }
}
//<

//> hit-face-recall
// The normal of face f, and the square of its plane's height over the origin.
// 0 if the origin is not behind it, or the triangle is so thin that the normal
// is rough.
static int face_square(hit_scratch *h, face *f, real *square)
{
    vec3 p = h->point[f->corner[0]].at;
    vec3 e = face_edge(h, f, 1), g = face_edge(h, f, 2);
    f->normal = vec3_cross(e, g);
    real nn = vec3_length_squared(f->normal), up = vec3_dot(f->normal, p);
    real ee = vec3_length_squared(e), gg = vec3_length_squared(g);
    *square = up * up / nn;
    return up > 0 && nn >= 0x1p-8 * ee * gg;
}

// The polytope as remembered, with its points where they are now.  Returns the
// face whose plane is lowest over the origin; -1: the origin is not behind all.
static int polytope_recall(hit_scratch *h, const hit_memory *m)
{
    int lowest = -1, sound = 1;
    real least = HUGE_VAL;
    h->scale = m->scale;
    h->points = m->points;
    for (int c = 0; c < m->points; c++) {
        assert(m->a[c] < h->a.count && m->b[c] < h->b.count);
        h->point[c] = peak_make(h, m->a[c], m->b[c]);
    }
    for (int f = 0; f < m->faces; f++) {
        for (int i = 0; i < 3; i++) h->face[f].corner[i] = m->corner[f][i];
        sound &= face_square(h, &h->face[f], &h->height[f]);
        lowest = h->height[f] < least ? f : lowest;
        least = h->height[f] < least ? h->height[f] : least;
    }
    return sound ? lowest : -1;
}
//<

//> hit-face-again
// 1 if the foot x lies in face f, not only before it; and its weights.
static int holds_foot(const hit_scratch *h, int f, vec3 x, real weight[3])
{
    const int *corner = h->face[f].corner;
    foot_weights(h, &h->face[f], x, weight);
    if (!(weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0)) return 0;
    if (!areas_serve(h, &h->face[f], weight))
        triangle_weights(h->point[corner[0]].at, h->point[corner[1]].at,
                         h->point[corner[2]].at, x, weight);
    vec3 miss = face_miss(h, &h->face[f], x, weight);
    return vec3_length_squared(miss) <= 0x1p-80;
}

// Of the faces as low as f the one that the foot x lies in; -1: none.
static int face_of_foot(const hit_scratch *h, int f, int faces, vec3 x,
                        real weight[3])
{
    if (holds_foot(h, f, x, weight)) return f;
    real floor = h->height[f] * (1 + 0x1p-40);
    for (int g = 0; g < faces; g++)
        if (g != f && h->height[g] <= floor && holds_foot(h, g, x, weight))
            return g;
    return -1;
}

int hit_face_again(point_set a, point_set b, const hit_memory *m,
                   hit_scratch *h, hit_result *r)
{
    if (m->faces == 0) return 0;
    h->a = a;
    h->b = b;
    int f = polytope_recall(h, m);
    if (f < 0) return 0;
    vec3 out = vec3_unit(h->face[f].normal);
    real height = vec3_dot(out, h->point[h->face[f].corner[0]].at), weight[3];
    // Something lies beyond the lowest plane, or is not a number.
    real upper = -h->scale * support_gap(a, b, vec3_scale(-1, out));
    if (!(upper - height <= level)) return 0;
    // The foot lies beside the triangles in that plane.
    int g = face_of_foot(h, f, m->faces, vec3_scale(height, out), weight);
    if (g < 0) return 0;
    r->status = HIT_FOUND;
    r->iterations = 1;
    answer_at(h, g, height, out, weight, r);
    return 1;
}
//<
