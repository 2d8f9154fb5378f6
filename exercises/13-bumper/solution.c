// solution.c - the force at the end of the substep, found at its beginning.

#include "bumper.h"

// m, how deep c is pressed between x_b and x_a.
static real depth_of(const bumper *c, vec3 xb, vec3 xa)
{
    return c->thickness - vec3_dot(vec3_sub(xb, xa), c->normal);
}

// A change l of the push lifts the depth by -K l, K = w_a + w_b.  The sum shall
// be h^2 times the force at the end:
//     pushed + l = h^2 (k (depth - K l) + d (depth - K l - before) / h),
// with k the stiffness and d the damping.  With soft = h^2 k + h d,
//     l (1 + K soft) = soft depth - h d before - pushed.
// The bottom is never less than 1: nothing explodes, however stiff.
real bumper_push(bumper *c, particle *p, real h)
{
    particle *a = &p[c->a], *b = &p[c->b];
    real weight = a->inverse_mass + b->inverse_mass;
    real depth = depth_of(c, b->position, a->position);
    real before = depth_of(c, b->previous, a->previous);
    real soft = h * h * c->stiffness + h * c->damping;
    real lack = soft * depth - h * c->damping * before - c->pushed;
    real sum = fmax(c->pushed + lack / (1 + weight * soft), 0);
    real change = sum - c->pushed;
    c->pushed = sum;
    b->position = vec3_add_scaled(b->position, b->inverse_mass * change,
                                  c->normal);
    a->position = vec3_add_scaled(a->position, -a->inverse_mass * change,
                                  c->normal);
    return change;
}

int bumpers_solve(bumper *c, int n, particle *p, real h, real enough,
                  int rounds)
{
    for (int i = 0; i < n; i++) c[i].pushed = 0;
    for (int round = 1; ; round++) {
        real most = 0;
        for (int i = 0; i < n; i++)
            most = fmax(most, fabs(bumper_push(&c[i], p, h)));
        for (int i = n - 1; i >= 0; i--)
            most = fmax(most, fabs(bumper_push(&c[i], p, h)));
        if (!(most > enough) || round >= rounds) return round;
    }
}
