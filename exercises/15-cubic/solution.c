// solution.c - pieces on which the curve goes one way only.

#include "cubic.h"

static real value(const real c[4], real t)
{
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

// Between low and high the curve changes sign, once.
static real bisect(const real c[4], real low, real high)
{
    enum { HALVINGS = 60 };
    int rises = value(c, high) > 0;
    for (int k = 0; k < HALVINGS; k++) {
        real middle = low + (high - low) / 2;
        if ((value(c, middle) > 0) == rises) high = middle;
        else                                 low = middle;
    }
    return low + (high - low) / 2;
}

// Where the slope c1 + 2 c2 t + 3 c3 t^2 is 0, between 0 and 1, in ascending
// order.  Of the two roots one is q / 3 c3 and one c1 / q, so that nothing is
// subtracted from nearly the same.
static int turning_points(const real c[4], real turn[2])
{
    real square = c[2] * c[2] - 3 * c[3] * c[1];
    int n = 0;
    if (!(square >= 0)) return 0;
    real q = -(c[2] + (c[2] >= 0 ? sqrt(square) : -sqrt(square)));
    real t[2] = { q / (3 * c[3]), c[1] / q };
    for (int k = 0; k < 2; k++)
        if (t[k] > 0 && t[k] < 1) turn[n++] = t[k];
    if (n == 2 && turn[0] > turn[1]) {
        turn[0] = t[1];
        turn[1] = t[0];
    }
    return n;
}

// Between 0, the turning points and 1 the curve rises or falls all the way, so
// it has one root there if its ends have different signs, and none if not.  An
// end at which it is nothing is a root by itself; two such in a row are one,
// for the curve is nothing from one to the other.
int cubic_roots(const real c[4], real root[3])
{
    real size = fabs(c[0]) + fabs(c[1]) + fabs(c[2]) + fabs(c[3]);
    real end[4] = { 0 }, before = 0;
    int ends = 1, n = 0;
    if (size == 0) return -1;
    if (!(size < HUGE_VAL)) return 0;
    ends += turning_points(c, end + 1);
    end[ends++] = 1;
    for (int k = 0; k < ends; k++) {
        real now = value(c, end[k]);
        if (fabs(now) <= CUBIC_NOTHING * size) now = 0;
        if (now == 0 && (k == 0 || before != 0))
            root[n++] = end[k];
        else if (now * before < 0)
            root[n++] = bisect(c, end[k - 1], end[k]);
        before = now > 0 ? 1 : now < 0 ? -1 : 0;
    }
    return n;
}

// (a + t u) . ((b + t v) x (d + t w)), multiplied out.
void meeting_cubic(const meeting *m, real c[4])
{
    vec3 a = vec3_sub(m->at[1], m->at[0]), u = vec3_sub(m->way[1], m->way[0]);
    vec3 b = vec3_sub(m->at[2], m->at[0]), v = vec3_sub(m->way[2], m->way[0]);
    vec3 d = vec3_sub(m->at[3], m->at[0]), w = vec3_sub(m->way[3], m->way[0]);
    vec3 bd = vec3_cross(b, d), vw = vec3_cross(v, w);
    vec3 both = vec3_add(vec3_cross(b, w), vec3_cross(v, d));
    c[0] = vec3_dot(a, bd);
    c[1] = vec3_dot(a, both) + vec3_dot(u, bd);
    c[2] = vec3_dot(a, vw) + vec3_dot(u, both);
    c[3] = vec3_dot(u, vw);
}

static vec3 at_time(const meeting *m, int i, real t)
{
    return vec3_add_scaled(m->at[i], t, m->way[i]);
}

// The corner's weights are areas, with the sign of the whole triangle's.
static int is_inside(const meeting *m, real t)
{
    vec3 p = at_time(m, 0, t), x[3];
    for (int i = 0; i < 3; i++) x[i] = vec3_sub(at_time(m, i + 1, t), p);
    vec3 n = vec3_cross(vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0]));
    real whole = vec3_dot(n, n);
    if (!(whole > 0)) return 0;
    for (int i = 0; i < 3; i++) {
        real area = vec3_dot(n, vec3_cross(x[i], x[(i + 1) % 3]));
        if (!(area >= -1e-9 * whole)) return 0;
    }
    return 1;
}

int corner_hits(const meeting *m, real *time)
{
    real c[4], root[3];
    meeting_cubic(m, c);
    int n = cubic_roots(c, root);
    for (int k = 0; k < n; k++)
        if (is_inside(m, root[k])) {
            *time = root[k];
            return 1;
        }
    return 0;
}
