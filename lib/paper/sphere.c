//> sphere-weights
//>   The recipe comes first: the centre of two, three or four points as a
//>   weighted mean. These are the three cases above.
#include "sphere.h"

#include <assert.h>

// The centre of the circle through a, b and c as a weighted mean of them: each
// has the square of the side opposite times the dot product of the sides at it.
// False if a weight is not positive: an angle is right or obtuse, and the side
// opposite alone is a diameter.
static bool weigh_triangle(vec3 a, vec3 b, vec3 c, real weight[3])
{
    vec3 ab = vec3_sub(b, a), bc = vec3_sub(c, b), ca = vec3_sub(a, c);
    weight[0] = -vec3_length_squared(bc) * vec3_dot(ab, ca);
    weight[1] = -vec3_length_squared(ca) * vec3_dot(ab, bc);
    weight[2] = -vec3_length_squared(ab) * vec3_dot(bc, ca);
    real sum = weight[0] + weight[1] + weight[2];
    for (int i = 0; i < 3; i++) {
        if (!(weight[i] > 0)) return false;
        weight[i] /= sum;
    }
    return true;
}

// The centre of the sphere through four points.  With a, b and c the points seen
// from the first and d = a . (b x c), it stands at x = (|a|^2 b x c + |b|^2 c x a +
// |c|^2 a x b) / 2 d, and the weight of a is x . (b x c) / d.  False if a weight is
// negative, that is, the centre lies outside, or if the points lie in a plane.
static bool weigh_tetrahedron(const vec3 *q, real weight[4])
{
    vec3 a = vec3_sub(q[1], q[0]), b = vec3_sub(q[2], q[0]);
    vec3 c = vec3_sub(q[3], q[0]);
    vec3 bc = vec3_cross(b, c), ca = vec3_cross(c, a), ab = vec3_cross(a, b);
    real d = vec3_dot(a, bc);
    vec3 x = vec3_scale(vec3_length_squared(a) / (2 * d), bc);
    x = vec3_add_scaled(x, vec3_length_squared(b) / (2 * d), ca);
    x = vec3_add_scaled(x, vec3_length_squared(c) / (2 * d), ab);
    weight[1] = vec3_dot(x, bc) / d;
    weight[2] = vec3_dot(x, ca) / d;
    weight[3] = vec3_dot(x, ab) / d;
    weight[0] = 1 - weight[1] - weight[2] - weight[3];
    for (int i = 0; i < 4; i++)
        if (!(weight[i] >= 0)) return false;
    return true;
}

// The centre of the smallest sphere that has all n points on it, 1 to 4, as
// their weighted mean; false if fewer of them fix a smaller one.
static bool weigh_points(const vec3 *q, int n, real weight[4])
{
    if (n == 4) return weigh_tetrahedron(q, weight);
    if (n == 3) return weigh_triangle(q[0], q[1], q[2], weight);
    weight[0] = weight[1] = 1 / (real)n;
    return true;
}
//<

//> sphere-trial
//>   A `trial` is a sphere under test, and `fix_by` makes one from a set of
//>   support points. All positions are relative to the first point. Far from
//>   the origin, sums of world coordinates would lose the digits that tell one
//>   point from the next.
// A sphere on trial, fixed by its support points.  Positions are relative to
// the first point given, so that a body far from the origin loses no digits.
typedef struct {
    int  count;         // support points, 1 to 4
    int  index[5];      // one more while a point is let in
    vec3 at[5];         // m
    real weight[4];
    vec3 center;        // m
    real reach2;        // m^2, to the farthest point that it must enclose
} trial;

static real distance2(vec3 a, vec3 b)
{
    return vec3_length_squared(vec3_sub(a, b));
}

// Makes *s the sphere through the last point of *all and those points before it
// that have a bit in `bits`.  False if there is none.
static bool fix_by(trial *s, const trial *all, int bits)
{
    int last = all->count - 1;
    s->count = 0;
    for (int i = last; i >= 0; i--) {
        if (i < last && !(bits & 1 << i)) continue;
        s->index[s->count] = all->index[i];
        s->at[s->count++] = all->at[i];
    }
    if (s->count > 4 || !weigh_points(s->at, s->count, s->weight)) return false;

    s->center = s->at[0];
    for (int i = 1; i < s->count; i++)
        s->center = vec3_add_scaled(s->center, s->weight[i],
                                    vec3_sub(s->at[i], s->at[0]));
    s->reach2 = 0;
    for (int i = 0; i <= last; i++)
        s->reach2 = real_max(distance2(all->at[i], s->center), s->reach2);
    return true;
}
//<

//> sphere-let-in
// The smallest sphere around the support points of s and one more, which lies
// outside s and is therefore a support point of the new one (Welzl).  All sets
// of the others are tried; any centre gives a sphere that encloses them all,
// and the smallest is kept.  count = 0: there is none: squares overflow.
static trial let_in(trial s, int index, vec3 at)
{
    trial best = { .count = 0, .reach2 = (real)INFINITY }, other;
    int sets = 1 << s.count;
    s.index[s.count] = index;
    s.at[s.count++] = at;
    for (int bits = 0; bits < sets; bits++)
        if (fix_by(&other, &s, bits) && other.reach2 < best.reach2)
            best = other;
    return best;
}

// Which point is farthest from center, both relative to `from`, and the square
// of its distance (m^2).
static int farthest(const vec3 *at, const int *index, int n, vec3 from,
                    vec3 center, real *far2)
{
    int far = 0;
    *far2 = -1;
    for (int i = 0; i < n; i++) {
        real d2 = distance2(vec3_sub(at[index[i]], from), center);
        if (d2 > *far2) {
            *far2 = d2;
            far = i;
        }
    }
    return far;
}
//<

//> sphere-of-points
// Beyond this the farthest point lies outside the sphere by more than rounding.
static const real OUTSIDE = 1 + 1e-14;

// Every round enlarges the sphere, so no set of supports returns; three to ten
// rounds are usual.  Points that lie on one sphere up to rounding may displace
// each other in turn: then the cap ends it, with a sphere as good as the next.
enum { ROUNDS_MAX = 60 };

sphere sphere_of_points(const vec3 *at, const int *index, int n,
                        int support[4], real weight[4], int *supports)
{
    assert(n >= 0);
    *supports = 0;
    if (n == 0) return (sphere){ .radius = -1 };
    for (int i = 0; i < n; i++)
        if (!vec3_is_finite(at[index[i]]))
            return (sphere){ { (real)NAN, (real)NAN, (real)NAN }, (real)NAN };

    vec3 from = at[index[0]];
    trial s = { .count = 1, .index = { index[0] }, .weight = { 1 } };
    real far2;
    int far = farthest(at, index, n, from, s.center, &far2);
    for (int round = 0; round < ROUNDS_MAX && far2 > s.reach2 * OUTSIDE;
         round++) {
        trial next = let_in(s, index[far], vec3_sub(at[index[far]], from));
        if (next.count == 0) break;
        s = next;
        far = farthest(at, index, n, from, s.center, &far2);
    }
    *supports = s.count;
    for (int i = 0; i < s.count; i++) {
        support[i] = s.index[i];
        weight[i]  = s.weight[i];
    }
    vec3 center = vec3_add(from, s.center);
    farthest(at, index, n, (vec3){ 0, 0, 0 }, center, &far2);
    return (sphere){ center, sqrt(far2) };
}
//<

//> sphere-of-spheres
// Two spheres, their centres d apart.  If d <= |a - b|, with radii a and b, the
// larger holds the other (equal centres are such a case).  Otherwise the smallest
// sphere reaches from the far side of one to the far side of the other.
sphere sphere_of_spheres(sphere a, sphere b)
{
    if (a.radius < 0) return b;
    if (b.radius < 0) return a;
    vec3 along = vec3_sub(b.center, a.center);
    real d2 = vec3_length_squared(along), more = a.radius - b.radius;
    if (d2 <= more * more) return more >= 0 ? a : b;

    real d = sqrt(d2), radius = (a.radius + d + b.radius) / 2;
    return (sphere){ vec3_add_scaled(a.center, (radius - a.radius) / d, along),
                     radius };
}
//<
