// piles_judge.c - how deep do bodies lie in each other, and in walls?
//
// From where they lie alone, and with no function that moves any of them: two
// convex bodies are apart if they are along the normal of a face, or along the
// product of two edges; else they overlap by the least that they do along one of
// these.  For two cubes that makes 15 directions, for two icosahedra 245.

#include "piles.h"
#include "oracle.h"

#include <stdlib.h>

// Along n (unit): half the shadow of a body that lies there.
static real shadow(const solid *s, const pose *p, vec3 n)
{
    vec3 own = { vec3_dot(p->x, n), vec3_dot(p->y, n), vec3_dot(p->z, n) };
    real most = 0;
    for (int k = 0; k < s->corners; k++)
        most = fmax(most, fabs(vec3_dot(s->corner[k], own)));
    return most;
}

static real depth_along(const solid *s, const pose *a, const pose *b, vec3 n)
{
    return shadow(s, a, n) + shadow(s, b, n)
         - fabs(vec3_dot(n, vec3_sub(b->middle, a->middle)));
}

static vec3 turned(const pose *p, vec3 own)
{
    vec3 v = vec3_scale(own.x, p->x);
    return vec3_add_scaled(vec3_add_scaled(v, own.y, p->y), own.z, p->z);
}

real solids_depth(const solid *s, const pose *a, const pose *b)
{
    real least = HUGE_VAL;
    for (int k = 0; k < s->normals; k++) {
        least = fmin(least, depth_along(s, a, b, turned(a, s->normal[k])));
        least = fmin(least, depth_along(s, a, b, turned(b, s->normal[k])));
    }
    for (int i = 0; i < s->edges && least > 0; i++)
        for (int j = 0; j < s->edges; j++) {
            vec3 n = vec3_cross(turned(a, s->edge[i]), turned(b, s->edge[j]));
            real l = vec3_length(n);
            if (l > 1e-6)       // else the edges are parallel: a face's normal
                least = fmin(least, depth_along(s, a, b, vec3_scale(1 / l, n)));
        }
    return least;
}

static void look_at_walls(const pile *p, const pose *box, verdict *v)
{
    bool is_outside = false;
    for (int k = 0; k < p->walls; k++) {
        real up = vec3_dot(box->middle, p->normal[k]) - p->offset[k];
        v->overlap = fmax(v->overlap,
                          shadow(&p->body, box, p->normal[k]) - up);
        is_outside |= !(up > 0);
    }
    v->outside += is_outside;
}

static void look_at_pair(const pile *p, const pose *a, const pose *b,
                         verdict *v)
{
    real depth = solids_depth(&p->body, a, b);
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
    real far = 2 * p->radius;
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

static hull hull_of(const solid *s, const pose *p, vec3 *at)
{
    for (int k = 0; k < s->corners; k++) {
        vec3 arm = turned(p, s->corner[k]);
        at[2 * k] = vec3_add(p->middle, arm);
        at[2 * k + 1] = vec3_sub(p->middle, arm);
    }
    return (hull){ at, 2 * s->corners };
}

void judge_the_judge(const pile *p, const verdict *v)
{
    vec3 a[PILE_CORNERS], b[PILE_CORNERS];
    if (!(v->pair > 0)) return;
    real truth = (real)oracle_depth(hull_of(&p->body, &v->a, a),
                                    hull_of(&p->body, &v->b, b));
    // Other engines count in float: their axes are not quite perpendicular.
    if (!(fabs(v->pair - truth) <= 1e-5 * p->radius))
        give_up("the oracle does not agree about the deepest pair");
}
