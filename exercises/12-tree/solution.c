// solution.c - from the leaves to the root, and back.

#include "tree.h"

static vec3 times(const vec3 m[3], vec3 a)
{
    return vec3_add(vec3_scale(a.x, m[0]),
           vec3_add(vec3_scale(a.y, m[1]), vec3_scale(a.z, m[2])));
}

// What hangs on a stick d is to what holds it a mass along d and no more.
// The child wants to go by `free`, and takes the stick's error with it:
//     wrong = (d^2 - rest^2) / 2 + d . free.
// If the parent goes by x, the stick's multiplier must mend wrong - d . x, and
// the child yields d . give d.  So the parent bears, beside its own, the energy
//     (wrong - d . x)^2 / (2 yield),
// a mass d d^T / yield that wants to be at d . x = wrong.  After Sherman and
// Morrison its own give loses q q^T / (yield + d . q), q = give d, and it would
// go by q (wrong - d . free) / (yield + d . q) further.  (Kalman's
// filter does the same.)
static void hang_on(tree_node *above, const tree_node *below)
{
    vec3 d = below->stick, q = times(above->give, d);
    real bottom = below->yield + vec3_dot(d, q);
    if (!(bottom > 0)) return;
    real lack = (below->wrong - vec3_dot(d, above->free)) / bottom;
    above->free = vec3_add_scaled(above->free, lack, q);
    above->give[0] = vec3_add_scaled(above->give[0], -q.x / bottom, q);
    above->give[1] = vec3_add_scaled(above->give[1], -q.y / bottom, q);
    above->give[2] = vec3_add_scaled(above->give[2], -q.z / bottom, q);
}

// `free` becomes the way that it goes: what the one above did not mend of the
// stick, the stick does.
static void go_down(tree_node *below, vec3 above)
{
    if (!(below->yield > 0)) return;
    real left = (below->wrong - vec3_dot(below->stick, above)) / below->yield;
    below->free = vec3_add_scaled(below->free, -left,
                                  times(below->give, below->stick));
}

real tree_step(particle *p, int n, const int *parent, const real *rest,
               tree_node *node)
{
    real worst = 0;
    for (int i = 0; i < n; i++) {
        real w = p[i].inverse_mass;
        node[i] = (tree_node){ .give = { { w, 0, 0 }, { 0, w, 0 },
                                         { 0, 0, w } } };
    }
    for (int i = n - 1; i > 0; i--) {
        tree_node *me = &node[i];
        me->stick = vec3_sub(p[i].position, p[parent[i]].position);
        real d2 = vec3_dot(me->stick, me->stick), rest2 = rest[i] * rest[i];
        me->yield = vec3_dot(me->stick, times(me->give, me->stick));
        if (!(me->yield > 1e-9 * p[i].inverse_mass * d2)) me->yield = 0;
        me->wrong = (d2 - rest2) / 2 + vec3_dot(me->stick, me->free);
        worst = fmax(worst, fabs(d2 - rest2) / (2 * rest2));
        hang_on(&node[parent[i]], me);
    }
    for (int i = 1; i < n; i++) go_down(&node[i], node[parent[i]].free);
    for (int i = 0; i < n; i++)
        p[i].position = vec3_add(p[i].position, node[i].free);
    return worst;
}
