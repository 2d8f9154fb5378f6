// piles_judge.c - how deep do cubes lie in each other, and in walls?
//
// From where they lie alone, and with no function that moves any of them: two
// cubes are apart if they are along one of 15 directions, the normals of their
// faces and the products of their edges; else they overlap by the least that
// they do along one of these.

#include "piles.h"
#include "oracle.h"

#include <stdlib.h>

// Along n (unit): half the shadow of a cube.
static real shadow(const pose *p, vec3 n, real half)
{
    return half * (fabs(vec3_dot(p->x, n)) + fabs(vec3_dot(p->y, n))
                   + fabs(vec3_dot(p->z, n)));
}

static real depth_along(const pose *a, const pose *b, real half, vec3 n)
{
    return shadow(a, n, half) + shadow(b, n, half)
         - fabs(vec3_dot(n, vec3_sub(b->middle, a->middle)));
}

real cubes_depth(const pose *a, const pose *b, real half)
{
    vec3 of_a[3] = { a->x, a->y, a->z }, of_b[3] = { b->x, b->y, b->z };
    real least = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        least = fmin(least, depth_along(a, b, half, of_a[i]));
        least = fmin(least, depth_along(a, b, half, of_b[i]));
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            vec3 n = vec3_cross(of_a[i], of_b[j]);
            real l = vec3_length(n);
            if (l > 1e-6)       // else the edges are parallel: a face's normal
                least = fmin(least, depth_along(a, b, half,
                                                vec3_scale(1 / l, n)));
        }
    return least;
}

static void look_at_walls(const pile *p, const pose *box, verdict *v)
{
    bool is_outside = false;
    for (int k = 0; k < p->walls; k++) {
        real up = vec3_dot(box->middle, p->normal[k]) - p->offset[k];
        v->overlap = fmax(v->overlap,
                          shadow(box, p->normal[k], p->half) - up);
        is_outside |= !(up > 0);
    }
    v->outside += is_outside;
}

static void look_at_pair(const pile *p, const pose *a, const pose *b,
                         verdict *v)
{
    real depth = cubes_depth(a, b, p->half);
    v->overlap = fmax(v->overlap, depth);
    if (depth <= v->pair) return;
    v->pair = depth;
    v->a = *a;
    v->b = *b;
}

static int is_right_of(const void *a, const void *b)
{
    real x = (*(const pose *const *)a)->middle.x;
    real y = (*(const pose *const *)b)->middle.x;
    return (x > y) - (x < y);
}

void judge_overlap(const pile *p, const pose *at, verdict *v)
{
    const pose **by_x = malloc((size_t)p->boxes * sizeof *by_x);
    real far = 2 * sqrt(3) * p->half;
    if (!by_x) give_up("there is no memory for the judge");
    v->outside = 0;
    for (int k = 0; k < p->boxes; k++) {
        look_at_walls(p, &at[k], v);
        by_x[k] = &at[k];
    }
    qsort(by_x, (size_t)p->boxes, sizeof *by_x, is_right_of);
    for (int i = 0; i < p->boxes; i++)
        for (int j = i + 1; j < p->boxes; j++) {
            vec3 d = vec3_sub(by_x[j]->middle, by_x[i]->middle);
            if (d.x > far) break;
            if (vec3_length_squared(d) < far * far)
                look_at_pair(p, by_x[i], by_x[j], v);
        }
    free(by_x);
}

static void corners_of(const pose *p, real half, vec3 *at)
{
    for (int k = 0; k < 8; k++) {
        at[k] = vec3_add_scaled(p->middle, k & 1 ? half : -half, p->x);
        at[k] = vec3_add_scaled(at[k], k & 2 ? half : -half, p->y);
        at[k] = vec3_add_scaled(at[k], k & 4 ? half : -half, p->z);
    }
}

void judge_the_judge(const pile *p, const verdict *v)
{
    vec3 a[8], b[8];
    if (!(v->pair > 0)) return;
    corners_of(&v->a, p->half, a);
    corners_of(&v->b, p->half, b);
    real truth = (real)oracle_depth((hull){ a, 8 }, (hull){ b, 8 });
    // Other engines count in float: their axes are not quite perpendicular.
    if (!(fabs(v->pair - truth) <= 1e-5 * p->half))
        give_up("the oracle does not agree about the deepest pair");
}
