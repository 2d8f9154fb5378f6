// solution.c - a ring is a line and one thing more.

#include "closed.h"

#include <string.h>

// Thomas, as in 12/thomas: x holds the right side, and then the answer.
static int thomas(int n, const real *lower, const real *diagonal,
                  const real *upper, real *x, real *share)
{
    real g = 0, h = 0;
    for (int k = 0; k < n; k++) {
        real down = k > 0 ? lower[k] : 0;
        real pivot = diagonal[k] - down * h;
        if (!(fabs(pivot) > 1e-12 * fabs(diagonal[k]))) return 0;
        h = k + 1 < n ? upper[k] / pivot : 0;
        g = (x[k] - down * g) / pivot;
        share[k] = h;
        x[k] = g;
    }
    for (int k = n - 2; k >= 0; k--) x[k] -= share[k] * x[k + 1];
    return 1;
}

// With a = lower[0] and b = upper[n - 1], the corners, and any number c,
//     ring = line + u v^T,   u = (c, 0, .., 0, b),   v = (1, 0, .., 0, a / c):
// u v^T has the corners, and too much of two diagonal entries, which the line
// has too little of.  Sherman and Morrison (1950): where line y = right and
// line z = u, the ring's answer is
//     x = y - z (v . y) / (1 + v . z).
// c = -diagonal[0] doubles the first pivot of the line rather than lose it.
int ring_solve(int n, const real *lower, const real *diagonal,
               const real *upper, real *x, real *room)
{
    real *line = room, *z = line + n, *share = z + n;
    real a = lower[0], b = upper[n - 1], c = -diagonal[0];
    if (!(fabs(c) > 0)) return 0;
    memcpy(line, diagonal, (size_t)n * sizeof *line);
    line[0] -= c;
    line[n - 1] -= a * b / c;
    for (int k = 0; k < n; k++) z[k] = 0;
    z[0] = c;
    z[n - 1] = b;
    if (!thomas(n, lower, line, upper, x, share)) return 0;
    if (!thomas(n, lower, line, upper, z, share)) return 0;
    real first = z[0], last = a / c * z[n - 1];
    real bottom = 1 + first + last;
    if (!(fabs(bottom) > 1e-12 * (1 + fabs(first) + fabs(last)))) return 0;
    real along = (x[0] + a / c * x[n - 1]) / bottom;
    for (int k = 0; k < n; k++) x[k] -= along * z[k];
    return 1;
}

static vec3 link_of(const particle *p, int n, int k)
{
    return vec3_sub(p[(k + 1) % n].position, p[k].position);
}

// As for a rope, but each particle has two neighbours.  The pull of the last
// link, which particle 0 needs first, is looked at before any particle moves.
int ring_step(particle *p, int n, real rest, real *room)
{
    real *lower = room, *diagonal = lower + n, *upper = diagonal + n;
    real *x = upper + n;
    for (int k = 0; k < n; k++) {
        vec3 u = link_of(p, n, k);
        real w = p[k].inverse_mass, next = p[(k + 1) % n].inverse_mass;
        lower[k] = -w * vec3_dot(u, link_of(p, n, (k + n - 1) % n));
        diagonal[k] = (w + next) * vec3_dot(u, u);
        upper[k] = -next * vec3_dot(u, link_of(p, n, (k + 1) % n));
        x[k] = (vec3_dot(u, u) - rest * rest) / 2;
    }
    if (!ring_solve(n, lower, diagonal, upper, x, x + n)) return 0;
    vec3 last = vec3_scale(x[n - 1], link_of(p, n, n - 1)), before = last;
    for (int k = 0; k < n; k++) {
        vec3 pull = last;
        if (k < n - 1) pull = vec3_scale(x[k], link_of(p, n, k));
        p[k].position = vec3_add_scaled(p[k].position, p[k].inverse_mass,
                                        vec3_sub(pull, before));
        before = pull;
    }
    return 1;
}
