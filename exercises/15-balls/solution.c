// solution.c - a point flies at a ball that is as large as both.

#include "balls.h"

// Seen from B, A's centre is at d + t w.  Its distance is r = ra + rb when
//     w.w t^2 + 2 d.w t + (d.d - r^2) = 0.
// With q = -d.w > 0, for they come nearer, and c = d.d - r^2 > 0, for they are
// apart, the roots are (q -+ root) / w.w; the first is also c / (q + root),
// which subtracts nothing from nearly the same.  Nor does the root: A's centre
// is nearest to B's at d + (q / w.w) w, m away, and
//     root^2 = q^2 - w.w c = w.w (r^2 - m^2).
int balls_touch(const flying_ball *a, const flying_ball *b, real *time,
                vec3 *normal)
{
    vec3 d = vec3_sub(a->center, b->center), w = vec3_sub(a->way, b->way);
    real r = a->radius + b->radius, length = vec3_length(d);
    real q = -vec3_dot(d, w), w2 = vec3_dot(w, w), t = 0;
    // (length + r) (length - r), and not d.d - r^2, keeps the gap's digits.
    real gap = (length + r) * (length - r);
    if (!(gap < HUGE_VAL) || !(w2 < HUGE_VAL)) return 0;
    if (gap >= 0 && !(q > 0)) return 0;
    if (gap > 0) {
        real m = vec3_length(vec3_add_scaled(d, q / w2, w));
        if (!(m <= r)) return 0;
        t = gap / (q + sqrt(w2 * (r + m) * (r - m)));
        if (!(t <= 1)) return 0;
    }
    *time = t;
    *normal = vec3_unit(vec3_add_scaled(d, t, w));
    return 1;
}

int balls_limit(vec3 way, real inner, int most)
{
    real steps = ceil(vec3_length(way) / inner);
    if (!(steps < most)) return most;
    return steps > 1 ? (int)steps : 1;
}
