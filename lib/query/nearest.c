//> nearest-normal
#include "nearest.h"

#include "exact.h"

#include <assert.h>
#include <float.h>

static const real thin = 0x1p-10;   // squared sine of an angle

// The normal e x f of a triangle with these two edges.
static vec3 triangle_normal(vec3 e, vec3 f)
{
    vec3 n = vec3_cross(e, f);
    real nn = vec3_length_squared(n);
    if (nn >= thin * vec3_length_squared(e) * vec3_length_squared(f)) return n;
    return cross_of_parallels(e, f);
}
//<

//> nearest-edges
// The nearest point on one of several edges: so far on that from j to k.
typedef struct {
    vec3 at;
    real squared, wj, wk;
    int  j, k;
} on_edge;

static inline void edge_try(on_edge *best, const vec3 *of, int j, int k)
{
    real wj, wk;
    vec3 v = nearest_of_segment(of[j], of[k], &wj, &wk);
    real vv = vec3_length_squared(v);
    if (vv < best->squared) *best = (on_edge){ v, vv, wj, wk, j, k };
}

// The nearest point on those edges of a triangle that face a corner whose area
// is not positive; all three if `all`.
static vec3 nearest_of_edges(const vec3 *of, const int at[3],
                             const real area[3], int all, real weight[4])
{
    on_edge best = { of[at[0]], HUGE_VAL, 0, 0, at[0], at[0] };
    if (all || !(area[0] > 0)) edge_try(&best, of, at[1], at[2]);
    if (all || !(area[1] > 0)) edge_try(&best, of, at[2], at[0]);
    if (all || !(area[2] > 0)) edge_try(&best, of, at[0], at[1]);
    weight[best.j] = best.wj;
    weight[best.k] = best.wk;
    return best.at;
}
//<

//> nearest-triangle
// The point of the triangle i, j, k nearest the origin.  With the normal n the
// weights of the origin's foot on the plane are areas:
//   n . ((p_j - p_i) x (0 - p_i)) = weight of k times |n|^2, and so on round.
// If all are positive the foot is the answer (the areas stand for the weights
// until the end).  If not, the answer lies on an edge opposite a corner whose
// area is not positive.  If they do not add up to the whole, |n|^2, they are
// rounding: the triangle is lower than that, and its edges say as much.
static vec3 nearest_of_triangle(const vec3 *of, int i, int j, int k,
                                real weight[4])
{
    vec3 ij = vec3_sub(of[j], of[i]), ik = vec3_sub(of[k], of[i]);
    vec3 jk = vec3_sub(of[k], of[j]);
    vec3 n = triangle_normal(ij, ik);
    real area[3] = { vec3_dot(n, vec3_cross(of[j], jk)),
                     vec3_dot(n, vec3_cross(ik, of[i])),
                     vec3_dot(n, vec3_cross(of[i], ij)) };
    real nn = vec3_length_squared(n), sum = area[0] + area[1] + area[2];
    int sound = fabs(sum - nn) < nn / 16;
    weight[0] = weight[1] = weight[2] = weight[3] = 0;
    if (area[0] > 0 && area[1] > 0 && area[2] > 0 && sound) {
        weight[i] = area[0];
        weight[j] = area[1];
        weight[k] = area[2];
        return vec3_scale(vec3_dot(n, of[i]) / nn, n);
    }
    int at[3] = { i, j, k };
    return nearest_of_edges(of, at, area, !sound, weight);
}
//<

//> nearest-inside
// 1 if six times the volume v > 0, made of edges with these squared lengths, is
// so large that rounding cannot have made it.
static int volume_is_sure(real v, real aa, real bb, real cc)
{
    const real rounding = 16 * DBL_EPSILON;
    return v * v > rounding * rounding * aa * bb * cc;
}

// volume[c] becomes the volume with corner c replaced by the origin: c's weight
// times the whole volume.  1 if all are surely positive: the origin is inside.
static int volumes_of_tetrahedron(const vec3 of[4], real volume[4])
{
    vec3 p0 = of[0], p1 = of[1];
    vec3 e1 = vec3_sub(p1, p0), e2 = vec3_sub(of[2], p0);
    vec3 e3 = vec3_sub(of[3], p0);
    vec3 f2 = vec3_sub(of[2], p1), f3 = vec3_sub(of[3], p1);
    vec3 n = vec3_cross(e2, e3);
    real side = vec3_dot(e1, n) < 0 ? -1 : 1;
    volume[0] = side * vec3_dot(p1, vec3_cross(f2, f3));
    volume[1] = -side * vec3_dot(p0, n);
    volume[2] = -side * vec3_dot(p0, vec3_cross(e3, e1));
    volume[3] = -side * vec3_dot(p0, vec3_cross(e1, e2));
    if (!(volume[0] > 0 && volume[1] > 0 && volume[2] > 0 && volume[3] > 0))
        return 0;
    real a0 = vec3_length_squared(p0), a1 = vec3_length_squared(e1);
    real a2 = vec3_length_squared(e2), a3 = vec3_length_squared(e3);
    real b1 = vec3_length_squared(p1), b2 = vec3_length_squared(f2);
    real b3 = vec3_length_squared(f3);
    return volume_is_sure(volume[0], b1, b2, b3)
        && volume_is_sure(volume[1], a0, a2, a3)
        && volume_is_sure(volume[2], a0, a3, a1)
        && volume_is_sure(volume[3], a0, a1, a2);
}
//<

//> nearest-tetrahedron
// The point of the tetrahedron nearest the origin: the origin itself, or a
// point of a face opposite a corner whose volume is not positive.  All positive
// but not surely: the tetrahedron is so flat that every face is tried.
static vec3 nearest_of_tetrahedron(const vec3 of[4], real weight[4])
{
    static const int face[4][3] = { {1,2,3}, {0,2,3}, {0,1,3}, {0,1,2} };
    real volume[4];
    if (volumes_of_tetrahedron(of, volume)) {
        real sum = volume[0] + volume[1] + volume[2] + volume[3];
        for (int c = 0; c < 4; c++) weight[c] = volume[c] / sum;
        return (vec3){ 0, 0, 0 };
    }
    int flat = volume[0] > 0 && volume[1] > 0 && volume[2] > 0 && volume[3] > 0;
    vec3 best = of[0];
    real least = HUGE_VAL;
    for (int c = 0; c < 4; c++) {
        real w[4];
        if (volume[c] > 0 && !flat) continue;
        vec3 v = nearest_of_triangle(of, face[c][0], face[c][1], face[c][2], w);
        real vv = vec3_length_squared(v);
        if (vv >= least) continue;
        least = vv;
        best = v;
        for (int k = 0; k < 4; k++) weight[k] = w[k];
    }
    return best;
}
//<

//> nearest-simplex
vec3 nearest_of_simplex(const vec3 *of, int count, real weight[4])
{
    assert(count >= 1 && count <= 4);
    weight[0] = 1;
    weight[1] = weight[2] = weight[3] = 0;
    switch (count) {
    case 1:  return of[0];
    case 2:  return nearest_of_segment(of[0], of[1], &weight[0], &weight[1]);
    case 3:  return nearest_of_triangle(of, 0, 1, 2, weight);
    default: return nearest_of_tetrahedron(of, weight);
    }
}
//<

//> triangle-weights-in-plane
// From r = x - p[0] = weight[1] e + weight[2] f follow, by a cross product with
// f and one with e,  r x f = weight[1] n  and  e x r = weight[2] n.
// In a thin triangle the first solution is rough: what it leaves of r is solved
// for once more.
static void weights_in_plane(vec3 e, vec3 f, vec3 r, real weight[3])
{
    vec3 n = triangle_normal(e, f);
    real nn = vec3_length_squared(n), share = nn > 0 ? 1 / nn : 0;
    weight[1] = weight[2] = 0;
    for (int round = 0; round < 2; round++) {
        real we = vec3_dot(n, vec3_cross(r, f)) * share;
        real wf = vec3_dot(n, vec3_cross(e, r)) * share;
        weight[1] += we;
        weight[2] += wf;
        r = vec3_add_scaled(vec3_add_scaled(r, -we, e), -wf, f);
    }
    weight[0] = 1 - weight[1] - weight[2];
    real sum = 0;
    for (int c = 0; c < 3; c++) {
        weight[c] = weight[c] > 0 ? weight[c] : 0;
        sum += weight[c];
    }
    for (int c = 0; c < 3; c++) weight[c] /= sum;
}

// The weights that make the point of the side from 0 to e which is nearest r.
static void weights_on_side(vec3 e, vec3 r, real weight[3])
{
    real part = vec3_dot(r, e) / vec3_length_squared(e);
    part = part > 0 ? part : 0;
    part = part < 1 ? part : 1;
    weight[0] = 1 - part;
    weight[1] = part;
    weight[2] = 0;
}
//<

//> triangle-weights
// A triangle whose height is less than a thousandth of its longest side.
static int is_thin(const vec3 p[3])
{
    vec3 e = vec3_sub(p[1], p[0]), f = vec3_sub(p[2], p[0]);
    real ee = vec3_length_squared(e), ff = vec3_length_squared(f);
    real gg = vec3_length_squared(vec3_sub(f, e));
    real longest = ee > ff ? ee : ff;
    longest = gg > longest ? gg : longest;
    return vec3_length_squared(triangle_normal(e, f))
        <= 0x1p-20 * longest * longest;
}

// The weights as seen from corner c, in the plane, or on the side that begins
// there.  Returns the square of what they miss x by: NaN if there are none.
static real weights_from(const vec3 p[3], int c, vec3 x, int on_side,
                         real weight[3])
{
    int next = (c + 1) % 3, last = (c + 2) % 3;
    vec3 e = vec3_sub(p[next], p[c]), f = vec3_sub(p[last], p[c]);
    vec3 r = vec3_sub(x, p[c]);
    real w[3];
    if (on_side) weights_on_side(e, r, w);
    else weights_in_plane(e, f, r, w);
    weight[c] = w[0];
    weight[next] = w[1];
    weight[last] = w[2];
    r = vec3_add_scaled(vec3_add_scaled(r, -w[1], e), -w[2], f);
    return vec3_length_squared(r);
}

// In a thin triangle a foot that rounding has put beside it makes weights that
// are wrong and large.  Of all that the corners and the sides say, those are
// taken that miss x by least.
void triangle_weights(vec3 p0, vec3 p1, vec3 p2, vec3 x, real weight[3])
{
    const vec3 p[3] = { p0, p1, p2 };
    real least = weights_from(p, 0, x, 0, weight);
    if (least == least && !is_thin(p)) return;
    for (int way = 1; way < 6; way++) {
        real w[3], missed = weights_from(p, way / 2, x, way % 2, w);
        if (!(missed < least || least != least)) continue;
        least = missed;
        for (int c = 0; c < 3; c++) weight[c] = w[c];
    }
}
//<
