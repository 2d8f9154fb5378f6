// solution.c - branch and bound.

#include "nearest_leaf.h"

enum { STACK_MAX = 64 };

// A node, and what nothing below it can be nearer than.
typedef struct {
    int node;
    real bound;
} place;

static place measure(const sphere_tree *t, int k, vec3 p, int *visited)
{
    const sphere *ball = &t->node[k].ball;
    ++*visited;
    return (place){ k, vec3_distance(p, ball->center) - ball->radius };
}

int nearest_leaf(const sphere_tree *t, vec3 p, real *distance, int *visited)
{
    place stack[STACK_MAX], best = { -1, (real)INFINITY };
    int top = 0;
    *visited = 0;
    *distance = (real)NAN;
    if (!vec3_is_finite(p)) return -1;

    stack[top++] = measure(t, t->nodes - 1, p, visited);
    while (top > 0) {
        place here = stack[--top];
        if (here.bound >= best.bound) continue;
        if (here.node < t->leaves) {
            best = here;
            continue;
        }
        const int *child = t->node[here.node].child;
        place a = measure(t, child[0], p, visited);
        place b = measure(t, child[1], p, visited);
        // The nearer is pushed last, to be taken first.
        stack[top++] = a.bound < b.bound ? b : a;
        stack[top++] = a.bound < b.bound ? a : b;
    }
    *distance = best.bound;
    return best.node;
}
