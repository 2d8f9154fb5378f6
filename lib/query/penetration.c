//> penetration-scratch
#include "penetration.h"

#include "exact.h"
#include "nearest.h"

#include <assert.h>
#include <stdlib.h>

// A closed polytope of n points has 2 n - 4 triangles (Euler).
enum { POINTS_AT_MOST = 512, FACES_AT_MOST = 2 * POINTS_AT_MOST - 4 };

// A point of A - B and the vertices whose difference it is.
typedef struct {
    vec3 at;
    int  a, b;
} peak;

// A small body, seen from its first vertex, by columns; a power of two.
enum { COLUMN = 64 };
typedef struct {
    int  count;         // 0: too large for it
    real x[COLUMN], y[COLUMN], z[COLUMN];
} columns;

// The polytope: part of the hull of A - B, closed, and convex to the last bit.
struct penetration_scratch {
    point_set a, b;
    columns column_a, column_b;
    real scale;         // lengths times this: |x|, |y|, |z| <= 1 in A - B
    vec3 middle;        // m, twice that of the box round A - B
    int  points, faces;
    peak point[POINTS_AT_MOST];
    // Of face f: its corners, counter-clockwise from outside; its plane, the
    // points p with x p.x + y p.y + z p.z = offset; x, y, z is the outward
    // normal, as long as twice the area.
    int  corner[FACES_AT_MOST][3];
    real x[FACES_AT_MOST], y[FACES_AT_MOST], z[FACES_AT_MOST];
    real offset[FACES_AT_MOST];
    real square[FACES_AT_MOST];     // of the plane's height over the origin,
                                    // with the height's sign
    // left[u][v]: the face with the edge from corner u to corner v.
    unsigned short left[POINTS_AT_MOST][POINTS_AT_MOST];
    // Of a new point: > 0 for the faces that it sees; their numbers; and the
    // edges round them.
    real side[FACES_AT_MOST];
    int  seen[FACES_AT_MOST + 1];
    int  rim_from[POINTS_AT_MOST + 1], rim_to[POINTS_AT_MOST + 1];
};

// Heights that differ by less are the same: four steps of the grid.
static const real level = 0x1p-48;

penetration_scratch *penetration_scratch_new(void)
{
    return malloc(sizeof(penetration_scratch));
}

void penetration_scratch_free(penetration_scratch *scratch)
{
    free(scratch);
}
//<

//> penetration-exact
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

//> penetration-sign
// The same, mostly sooner.  What rounding drops of n . d is added up beside it.
// No part of n is above 8, none of d above 2: so these parts are below 2^-46,
// and rounding, which takes 2^-53 of each, leaves an error below 2^-90.
static int sign_along(const rounded n[3], vec3 d)
{
    rounded x = exact_product(n[0].high, d.x);
    rounded y = exact_product(n[1].high, d.y);
    rounded z = exact_product(n[2].high, d.z);
    rounded xy = exact_sum(x.high, y.high), xyz = exact_sum(xy.high, z.high);
    real dropped = (x.low + y.low + z.low) + (xy.low + xyz.low)
                 + (n[0].low * d.x + n[1].low * d.y + n[2].low * d.z);
    real along = xyz.high + dropped;
    if (fabs(along) > 0x1p-90) return along > 0 ? 1 : -1;
    return exact_sign(n, d);
}
//<

//> penetration-grid
// The point of A - B from these vertices, on the grid.  Next to 6 the doubles
// are 2^-50 apart: adding 6 rounds to the grid, subtracting it is exact.
static peak peak_make(const penetration_scratch *h, int a, int b)
{
    vec3 d = vec3_scale(h->scale, vec3_sub(h->a.at[a], h->b.at[b]));
    vec3 at = { (d.x + 6) - 6, (d.y + 6) - 6, (d.z + 6) - 6 };
    return (peak){ at, a, b };
}

// The vertex furthest along (x, y, z); of equals the first.
static int columns_furthest(const columns *c, real x, real y, real z)
{
    real best = 0;
    int furthest = 0;
    for (int i = 0; i < c->count; i++) {
        real along = x * c->x[i] + y * c->y[i] + z * c->z[i];
        furthest = along > best ? i : furthest;
        best = along > best ? along : best;
    }
    return furthest;
}

// The point of A - B furthest along n.  n is scaled as A - B is: so its
// products with the vertices, and their sums, are numbers.
static inline peak peak_along(const penetration_scratch *h, vec3 n, peak near)
{
    vec3 d = vec3_scale(h->scale, n), back = vec3_scale(-1, d);
    const columns *ca = &h->column_a, *cb = &h->column_b;
    int a = ca->count ? columns_furthest(ca, d.x, d.y, d.z)
                      : support_point(h->a, d, near.a);
    int b = cb->count ? columns_furthest(cb, back.x, back.y, back.z)
                      : support_point(h->b, back, near.b);
    return peak_make(h, a, b);
}
//<

//> penetration-columns
// Writes p in columns, unless it is too large: then they come to hold anything.
// Finds its box on the way; *poison becomes NaN if a coordinate is not finite.
static void columns_fill(columns *c, point_set p, vec3 *low, vec3 *high,
                         real *poison)
{
    vec3 base = p.at[0], l = { 0, 0, 0 }, u = { 0, 0, 0 };
    real sum = 0;
    for (int i = 0; i < p.count; i++) {
        vec3 r = vec3_sub(p.at[i], base);
        int k = i & (COLUMN - 1);
        c->x[k] = r.x;
        c->y[k] = r.y;
        c->z[k] = r.z;
        sum += (r.x + r.y) + r.z;
        l.x = l.x < r.x ? l.x : r.x;
        l.y = l.y < r.y ? l.y : r.y;
        l.z = l.z < r.z ? l.z : r.z;
        u.x = u.x > r.x ? u.x : r.x;
        u.y = u.y > r.y ? u.y : r.y;
        u.z = u.z > r.z ? u.z : r.z;
    }
    c->count = p.count <= COLUMN ? p.count : 0;
    *low = vec3_add(base, l);
    *high = vec3_add(base, u);
    *poison += sum - sum;
}
//<

//> penetration-scale
static real largest(vec3 v)
{
    real m = v.x > v.y ? v.x : v.y;
    return v.z > m ? v.z : m;
}

// Fills the columns.  Returns the power of two that brings the largest
// coordinate of A - B into 1/2 .. 1; 0 if a coordinate is not finite, or so
// large that differences are not; 1 if all of A - B is one point.
static real scale_for(penetration_scratch *h)
{
    vec3 low_a, high_a, low_b, high_b;
    real poison = 0, scale = 1;
    columns_fill(&h->column_a, h->a, &low_a, &high_a, &poison);
    columns_fill(&h->column_b, h->b, &low_b, &high_b, &poison);
    h->middle = vec3_add(vec3_sub(low_a, low_b), vec3_sub(high_a, high_b));
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

//> penetration-face
static vec3 face_edge(const penetration_scratch *h, int f, int i)
{
    const int *corner = h->corner[f];
    return vec3_sub(h->point[corner[i]].at, h->point[corner[0]].at);
}

static vec3 face_normal(const penetration_scratch *h, int f)
{
    return (vec3){ h->x[f], h->y[f], h->z[f] };
}

// Face f has the corner p and the normal n.
static inline void face_set(penetration_scratch *h, int f, vec3 p, vec3 n)
{
    real offset = vec3_dot(n, p);
    h->x[f] = n.x;
    h->y[f] = n.y;
    h->z[f] = n.z;
    h->offset[f] = offset;
    h->square[f] = offset * fabs(offset) / vec3_length_squared(n);
}

// Its normal rounded once, and not in all the products that make it.
static void face_measure_exactly(penetration_scratch *h, int f)
{
    rounded n[3];
    exact_cross(face_edge(h, f, 1), face_edge(h, f, 2), n);
    face_set(h, f, h->point[h->corner[f][0]].at,
             (vec3){ n[0].high, n[1].high, n[2].high });
}

// The edges e and g, whose cross product is n, are nearly parallel: the squared
// sine of their angle is less than that.
static inline int is_thin(vec3 n, vec3 e, vec3 g, real sine)
{
    return vec3_length_squared(n)
         < sine * vec3_length_squared(e) * vec3_length_squared(g);
}
//<

//> penetration-put
// Measures the face u, v, w, keeps it in slot f, and joins it to its
// neighbours.  In a thin triangle the cross product cancels: there the exact one
// is taken.
static inline void face_put(penetration_scratch *h, int f, int u, int v, int w)
{
    h->left[u][v] = h->left[v][w] = h->left[w][u] = (unsigned short)f;
    vec3 p = h->point[u].at;
    vec3 e = vec3_sub(h->point[v].at, p), g = vec3_sub(h->point[w].at, p);
    vec3 n = vec3_cross(e, g);
    h->corner[f][0] = u;
    h->corner[f][1] = v;
    h->corner[f][2] = w;
    face_set(h, f, p, n);
    if (is_thin(n, e, g, 0x1p-8)) face_measure_exactly(h, f);
}
//<

//> penetration-side
// Coordinates are at most 1, edges 2, parts of a normal 8: then the rounding
// errors of normal . x - offset add up to less than this, and what is smaller
// has no sure sign.
static const real doubt = 0x1p-44;

static real over_plane(const penetration_scratch *h, int f, vec3 x)
{
    return h->x[f] * x.x + h->y[f] * x.y + h->z[f] * x.z - h->offset[f];
}

// The side of the plane of f that x, which is `over` it, is on: 1 before it, 0
// in it, -1 behind it.
static int face_side(const penetration_scratch *h, int f, vec3 x, real over)
{
    if (over > doubt) return 1;
    if (over < -doubt) return -1;
    rounded n[3];
    exact_cross(face_edge(h, f, 1), face_edge(h, f, 2), n);
    return sign_along(n, vec3_sub(x, h->point[h->corner[f][0]].at));
}
//<

//> penetration-seen
// Lists the faces that x sees; returns their number.  A face that x lies in
// counts as seen, as if x were a hair further out.  (As if it were a hair
// further in would be as right, and leave more triangles: no test can tell.)
static int list_seen(penetration_scratch *h, vec3 x)
{
    int perhaps = 0, seen = 0;
    for (int f = 0; f < h->faces; f++) h->side[f] = over_plane(h, f, x);
    for (int f = 0; f < h->faces; f++) {
        // Written first, then counted or not: no branch that nobody can
        // foretell.
        h->seen[perhaps] = f;
        perhaps += h->side[f] >= -doubt;
    }
    for (int k = 0; k < perhaps; k++) {
        int f = h->seen[k];
        if (h->side[f] <= doubt)
            h->side[f] = face_side(h, f, x, h->side[f]) < 0 ? -1 : 1;
        h->seen[seen] = f;
        seen += h->side[f] > 0;
    }
    return seen;
}
//<

//> penetration-rim
// Lists the edges that have a face that is seen on their left, and one that is
// not on their right; returns their number.
static int list_rim(penetration_scratch *h, int seen)
{
    int rim = 0;
    for (int k = 0; k < seen; k++) {
        const int *corner = h->corner[h->seen[k]];
        for (int i = 0; i < 3; i++) {
            int u = corner[i], v = corner[(i + 1) % 3];
            h->rim_from[rim] = u;
            h->rim_to[rim] = v;
            rim += !(h->side[h->left[v][u]] > 0);
        }
    }
    return rim;
}

// Face f is no more: the last one moves to its slot.
static void face_drop(penetration_scratch *h, int f)
{
    int last = --h->faces;
    if (f == last) return;
    const int *corner = h->corner[last];
    for (int i = 0; i < 3; i++) {
        h->left[corner[i]][corner[(i + 1) % 3]] = (unsigned short)f;
        h->corner[f][i] = corner[i];
    }
    h->x[f] = h->x[last];
    h->y[f] = h->y[last];
    h->z[f] = h->z[last];
    h->offset[f] = h->offset[last];
    h->square[f] = h->square[last];
}
//<

//> penetration-expand
// Puts the point `number` on the polytope: the faces that it sees go, and a fan
// from their rim to the point comes, first in their slots.  (Mostly it is the
// larger by two; but a corner that only seen faces have goes, too.)
static void polytope_expand(penetration_scratch *h, int number)
{
    int seen = list_seen(h, h->point[number].at), rim = list_rim(h, seen);
    for (int k = 0; k < rim; k++) {
        int f = k < seen ? h->seen[k] : h->faces++;
        face_put(h, f, h->rim_from[k], h->rim_to[k], number);
    }
    // From the last on, so that none of them is moved.
    while (seen > rim) face_drop(h, h->seen[--seen]);
}
//<

//> penetration-flat
// The point of A - B furthest from the plane through x with this normal, on
// either side; its height over the plane in *height.
static peak peak_off_plane(const penetration_scratch *h, vec3 x, vec3 n, peak near,
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

//> penetration-off
// The point of A - B furthest from x, along three axes.
static peak peak_off_point(const penetration_scratch *h, peak x)
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
static peak peak_off_line(const penetration_scratch *h, peak x, peak y)
{
    vec3 along = vec3_unit(vec3_sub(y.at, x.at));
    vec3 n = unit_across(along), m = vec3_cross(along, n);
    real up, side;
    peak p = peak_off_plane(h, x.at, n, x, &up);
    peak q = peak_off_plane(h, x.at, m, x, &side);
    return up >= side ? p : q;
}
//<

//> penetration-small
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

//> penetration-stout
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

//> penetration-guess
// The two points furthest along d; the same twice, if there is but one.
static void columns_top_two(const columns *c, vec3 d, int two[2])
{
    real best = -HUGE_VAL, next = -HUGE_VAL;
    int first = 0, second = 0;
    for (int i = 0; i < c->count; i++) {
        real along = d.x * c->x[i] + d.y * c->y[i] + d.z * c->z[i];
        // Who does not become the first may still become the second.
        real less = along < best ? along : best;
        int lower = along > best ? first : i;
        first = along > best ? i : first;
        best = along > best ? along : best;
        second = less > next ? lower : second;
        next = less > next ? less : next;
    }
    two[0] = first;
    two[1] = second;
}

// A tetrahedron of small bodies when there is no simplex.  Three corners as gjk
// begins: as seen from middle to middle, A has a first and a second vertex, and
// so has B.  The fourth is furthest from their plane, on the origin's side.
static int tetrahedron_guess(const penetration_scratch *h, peak p[4], vec3 *normal)
{
    if (h->column_a.count == 0 || h->column_b.count == 0) return 0;
    int a[2], b[2];
    vec3 d = vec3_scale(h->scale, h->middle);
    columns_top_two(&h->column_a, vec3_scale(-1, d), a);
    columns_top_two(&h->column_b, d, b);
    p[0] = peak_make(h, a[0], b[0]);
    p[1] = peak_make(h, a[1], b[0]);
    p[2] = peak_make(h, a[0], b[1]);
    vec3 n = vec3_cross(vec3_sub(p[1].at, p[0].at), vec3_sub(p[2].at, p[0].at));
    if (vec3_dot(n, p[0].at) > 0) n = vec3_scale(-1, n);
    p[3] = peak_along(h, n, p[0]);
    return is_stout(p, normal);
}
//<

//> penetration-tetrahedron
// Fills p with the corners of a tetrahedron in A - B, from the corners of the
// simplex where they serve.  Returns how many could be had: 4, or one more than
// the dimension of A - B; then *normal is perpendicular to all of it.
static int tetrahedron_find(const penetration_scratch *h, const distance_cache *start,
                            peak p[4], vec3 *normal)
{
    int n = start->count;
    if (n == 0 && tetrahedron_guess(h, p, normal)) return 4;
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

//> penetration-begin
// The polytope is this tetrahedron.
static void polytope_begin(penetration_scratch *h, const peak p[4], vec3 normal)
{
    static const int corner[4][3] = { {0,1,2}, {0,3,1}, {1,3,2}, {2,3,0} };
    // The face 0, 1, 2 must look away from corner 3.
    int turn = vec3_dot(normal, vec3_sub(p[3].at, p[0].at)) > 0;
    for (int c = 0; c < 4; c++) h->point[c] = p[c];
    if (turn) {
        h->point[1] = p[2];
        h->point[2] = p[1];
    }
    h->points = 4;
    h->faces = 4;
    for (int f = 0; f < 4; f++)
        face_put(h, f, corner[f][0], corner[f][1], corner[f][2]);
}

// The face whose plane is lowest over the origin; the origin is outside the
// polytope if that is below it.
static int polytope_lowest(const penetration_scratch *h)
{
    int lowest = 0;
    real least = h->square[0];
    for (int f = 1; f < h->faces; f++) {
        lowest = h->square[f] < least ? f : lowest;
        least = h->square[f] < least ? h->square[f] : least;
    }
    return lowest;
}
//<

//> penetration-weights
// The weights of the corners of f for the origin's foot x on its plane: areas,
// as in chapter 4.
static void foot_weights(const penetration_scratch *h, int f, vec3 x, real weight[3])
{
    for (int i = 0; i < 3; i++) {
        vec3 p = h->point[h->corner[f][(i + 1) % 3]].at;
        vec3 q = h->point[h->corner[f][(i + 2) % 3]].at;
        vec3 cross = vec3_cross(vec3_sub(p, x), vec3_sub(q, p));
        weight[i] = vec3_dot(face_normal(h, f), cross);
    }
}

// The areas need only be divided by their sum if x lies in the triangle, and
// that is well shaped: otherwise rounding has too large a share in them.
static int areas_serve(const penetration_scratch *h, int f, real weight[3])
{
    vec3 e = face_edge(h, f, 1), g = face_edge(h, f, 2), k = vec3_sub(g, e);
    real ee = vec3_length_squared(e), gg = vec3_length_squared(g);
    real kk = vec3_length_squared(k), longest = ee > gg ? ee : gg;
    longest = kk > longest ? kk : longest;
    if (!(weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0)) return 0;
    if (!(vec3_length_squared(face_normal(h, f)) >= 0x1p-4 * longest * longest))
        return 0;
    real share = 1 / (weight[0] + weight[1] + weight[2]);
    for (int i = 0; i < 3; i++) weight[i] *= share;
    return 1;
}
//<

//> penetration-walk
// The areas made weights.  Returns the square of what these miss x by: much if
// it lies beside the face.
static real weigh_foot(const penetration_scratch *h, int f, vec3 x, real weight[3])
{
    vec3 p[3], miss = vec3_scale(-1, x);
    for (int i = 0; i < 3; i++) p[i] = h->point[h->corner[f][i]].at;
    if (!areas_serve(h, f, weight))
        triangle_weights(p[0], p[1], p[2], x, weight);
    for (int i = 0; i < 3; i++) miss = vec3_add_scaled(miss, weight[i], p[i]);
    return vec3_length_squared(miss);
}

// A side of A - B may be several triangles in one plane: walks from f to the
// one that the foot x lies in.
static int walk_to_foot(const penetration_scratch *h, int f, vec3 x, real weight[3])
{
    real floor = sqrt(fabs(h->square[f])) + 4 * level;
    for (int steps = 0; steps < 32; steps++) {
        foot_weights(h, f, x, weight);
        int least = weight[1] < weight[0];
        least = weight[2] < weight[least] ? 2 : least;
        if (weight[least] >= 0) break;
        const int *corner = h->corner[f];
        int g = h->left[corner[(least + 2) % 3]][corner[(least + 1) % 3]];
        if (!(h->square[g] <= floor * floor)) break;
        f = g;
    }
    return f;
}
//<

//> penetration-feature
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

//> penetration-kind
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

//> penetration-answer-flat
// Fills in corners, features, points and kind from three corners and weights.
static void answer_features(const penetration_scratch *h, penetration_result *r,
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
static penetration_result answer_flat(const penetration_scratch *h, const distance_cache *start,
                              vec3 normal)
{
    penetration_result r = { .status = PENETRATION_FLAT, .normal = normal };
    distance_cache s = *start;
    if (s.count == 0) s = (distance_cache){ .count = 1, .weight = { 1 } };
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
    if (vec3_length(nearest) > 8 * level) r.status = PENETRATION_APART;
    answer_features(h, &r, weight);
    return r;
}
//<

//> penetration-answer
// The answer from the lowest face, once no point lies beyond it, or there is no
// room for one; upper: how far A - B reaches along its normal.  Of an A - B
// that is all but flat, the origin may lie in the plane and beside the face:
// nothing of A - B is there.
static void answer_face(penetration_scratch *h, int f, real upper, penetration_result *r)
{
    const real beside = 0x1p-20;
    real weight[3];
    vec3 n = face_normal(h, f);
    if (is_thin(n, face_edge(h, f, 1), face_edge(h, f, 2), 0x1p-4)) {
        face_measure_exactly(h, f);
        n = face_normal(h, f);
    }
    real shorten = 1 / vec3_length(n), height = shorten * h->offset[f];
    vec3 out = vec3_scale(shorten, n), foot = vec3_scale(height, out);
    int g = walk_to_foot(h, f, foot, weight);
    real miss = weigh_foot(h, g, foot, weight);
    if (r->status == PENETRATION_FOUND && miss > beside * beside)
        r->status = PENETRATION_APART;
    if (r->status == PENETRATION_CAPPED) height = shorten * upper;
    for (int i = 0; i < 3; i++) {
        r->corner_a[i] = h->point[h->corner[g][i]].a;
        r->corner_b[i] = h->point[h->corner[g][i]].b;
    }
    r->depth = height > 0 ? height / h->scale : 0;
    r->normal = vec3_scale(-1, out);
    answer_features(h, r, weight);
}
//<

//> penetration-find
// w is the point of A - B furthest along n, the normal of face f.  Does nothing
// lie beyond?  Then the face belongs to A - B itself.
static int is_outermost(const penetration_scratch *h, int f, vec3 n, vec3 w)
{
    real over = over_plane(h, f, w);
    return over * over <= level * level * vec3_length_squared(n)
        || face_side(h, f, w, over) <= 0;
}

penetration_result penetration_find(point_set a, point_set b, const distance_cache *start,
                         penetration_scratch *scratch)
{
    assert(scratch && start && start->count >= 0 && start->count <= 4);
    penetration_scratch *h = scratch;
    h->a = a;
    h->b = b;
    h->scale = scale_for(h);
    penetration_result r = { .status = PENETRATION_NOT_FINITE };
    if (!(h->scale > 0)) return r;

    peak p[4];
    vec3 normal;
    int corners = tetrahedron_find(h, start, p, &normal);
    if (corners < 4) return answer_flat(h, start, normal);
    polytope_begin(h, p, normal);

    for (;;) {
        int f = polytope_lowest(h);
        vec3 n = face_normal(h, f);
        peak w = peak_along(h, n, h->point[h->corner[f][0]]);
        r.iterations++;
        if (is_outermost(h, f, n, w.at))
            r.status = h->square[f] < -16 * level * level ? PENETRATION_APART
                                                          : PENETRATION_FOUND;
        else if (h->points == POINTS_AT_MOST)
            r.status = PENETRATION_CAPPED;
        if (r.status != PENETRATION_NOT_FINITE) {
            answer_face(h, f, vec3_dot(n, w.at), &r);
            return r;
        }
        h->point[h->points] = w;
        polytope_expand(h, h->points++);
    }
}
//<
