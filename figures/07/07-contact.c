// 07-contact.c - a corner of body A stands in an edge of body B: the contact,
// and the least move that parts them.  Two dimensions, all particles of 1 kg.

#include "response.h"

#include <stdio.h>

// Particles: A's corner and two that lie behind it; B's edge and two behind it.
enum { CORNER, A_LEFT, A_RIGHT, EDGE_LEFT, EDGE_RIGHT, B_RIGHT, B_LEFT, ALL };
static const real DEPTH = 0.8, LEFT = 0.7;      // m; weight of EDGE_LEFT

static void print_body(const particle *p, const int *list, int n)
{
    for (int i = 0; i <= n; i++) {
        vec3 x = p[list[i % n]].position;
        printf("%.4f %.4f\n", x.x, x.y);
    }
    printf("\n\n");
}

static void print_bodies(const particle *p)
{
    static const int A[3] = { CORNER, A_RIGHT, A_LEFT };
    static const int B[4] = { EDGE_LEFT, EDGE_RIGHT, B_RIGHT, B_LEFT };
    print_body(p, A, 3);
    print_body(p, B, 4);
}

int main(void)
{
    static const vec3 AT[ALL] = { { 0, 0, 0 }, { -1.9, 2.3, 0 },
        { 1.3, 2.6, 0 }, { -2, -0.25, 0 }, { 2.2, 0.28, 0 },
        { 2.2, -1.7, 0 }, { -2, -1.7, 0 } };
    particle p[ALL], old[ALL];
    for (int i = 0; i < ALL; i++) p[i] = (particle){ AT[i], AT[i], 1 };
    feature_contact c = { .a = { 1, { CORNER }, { 1 } },
                          .b = { 2, { EDGE_LEFT, EDGE_RIGHT },
                                { LEFT, 1 - LEFT } } };
    vec3 edge = vec3_unit(vec3_sub(AT[EDGE_RIGHT], AT[EDGE_LEFT]));
    c.normal = vec3_make(-edge.y, edge.x, 0);
    vec3 corner = vec3_add_scaled(feature_position(&c.b, p), -DEPTH, c.normal);
    vec3 by = vec3_sub(corner, p[CORNER].position);
    for (int i = CORNER; i <= A_RIGHT; i++)
        p[i].position = vec3_add(p[i].position, by);
    for (int i = 0; i < ALL; i++) old[i] = p[i];

    printf("# a corner of A, %g m deep in an edge of B: bodies before and "
           "after, then\n# the points pA and pB, the normal, the moves; all "
           "particles 1 kg\n", DEPTH);
    print_bodies(p);
    response_separate(&c, p, 0);
    print_bodies(p);

    vec3 a = feature_position(&c.a, old), b = feature_position(&c.b, old);
    vec3 q = feature_position(&c.a, p);
    printf("# x y: pA, pB, q\n%.4f %.4f\n%.4f %.4f\n%.4f %.4f\n\n\n", a.x, a.y,
           b.x, b.y, q.x, q.y);
    printf("# normal\n%.4f %.4f\n\n\n", c.normal.x, c.normal.y);
    printf("# x y dx dy part of the depth: corner, left and right end, pB\n");
    static const int MOVED[3] = { CORNER, EDGE_LEFT, EDGE_RIGHT };
    for (int i = 0; i < 4; i++) {
        vec3 from = i < 3 ? old[MOVED[i]].position : b;
        vec3 to = i < 3 ? p[MOVED[i]].position : q;
        vec3 d = vec3_sub(to, from);
        printf("%.4f %.4f %.4f %.4f %.3f\n", from.x, from.y, d.x, d.y,
               vec3_length(d) / DEPTH);
    }
    printf("\n\n# inverse effective masses of A's and B's point, 1/kg\n"
           "%.3f %.3f\n", feature_inverse_mass(&c.a, p),
           feature_inverse_mass(&c.b, p));
    return 0;
}
