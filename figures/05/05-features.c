// 05-features.c - what the three corners of the hit face say: a vertex in a face,
// and an edge across an edge.
//
// For each of the two cases these blocks, after two blank lines:
// 0  the edges of A, pairs of points seen from the side: x y of both
// 1  the edges of B
// 2  the feature of A: x y of its vertices, and their names
// 3  the feature of B
// 4  the hit face: x y of its corners in its own plane, and the vertices that
//    they are made of; then the point closest to the origin
// Metres; columns separated by spaces.

#include "hit_face.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CUBE = 8 };

typedef struct { vec3 at[CUBE]; } body;

static hull hull_of(const body *b) { return (hull){ b->at, CUBE }; }

static body box(vec3 size)
{
    body b;
    for (int k = 0; k < CUBE; k++)
        b.at[k] = (vec3){ k & 1 ? size.x / 2 : -size.x / 2,
                          k & 2 ? size.y / 2 : -size.y / 2,
                          k & 4 ? size.z / 2 : -size.z / 2 };
    return b;
}

// From axes of its own to those of the world, the last one up.
static void place(body *b, vec3 x, vec3 y, vec3 at)
{
    vec3 z = vec3_cross(x, y);
    for (int k = 0; k < CUBE; k++) {
        vec3 p = b->at[k];
        b->at[k] = vec3_add_scaled(vec3_add_scaled(vec3_add_scaled(at, p.x, x),
                                                   p.y, y), p.z, z);
    }
}

// Seen from the right and a little above: the paper's x and y.
static vec3 seen(vec3 p)
{
    return (vec3){ p.x + 0.45 * p.y, p.z + 0.28 * p.y, 0 };
}

static void print_edges(const body *b, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k < CUBE; k++)
        for (int bit = 1; bit < CUBE; bit *= 2) {
            if (k & bit) continue;
            vec3 p = seen(b->at[k]), q = seen(b->at[k | bit]);
            printf("%.5f %.5f %.5f %.5f\n", p.x, p.y, q.x - p.x, q.y - p.y);
        }
}

static void print_feature(const body *b, const feature_point *f, char name)
{
    printf("\n\n# feature of %c, %d vertices\n", name, f->count);
    for (int k = 0; k < f->count; k++) {
        vec3 p = seen(b->at[f->vertex[k]]);
        printf("%.5f %.5f %c_%d %.3f\n", p.x, p.y, name, f->vertex[k],
               f->weight[k]);
    }
}

// The hit face in its own plane: its first edge points right.
static void print_hit(const hit_result *r)
{
    vec3 o = r->hit[0].at, x = vec3_unit(vec3_sub(r->hit[1].at, o));
    vec3 y = vec3_cross(vec3_scale(-1, r->normal), x);
    vec3 v = vec3_scale(-r->depth, r->normal);
    printf("\n\n# the hit face, %.4f m from the origin\n", r->depth);
    for (int k = 0; k < 4; k++) {
        vec3 d = vec3_sub(k < 3 ? r->hit[k].at : v, o);
        printf("%.5f %.5f %d %d\n", vec3_dot(d, x), vec3_dot(d, y),
               k < 3 ? r->hit[k].a : -1, k < 3 ? r->hit[k].b : -1);
    }
}

static void print_case(const body *a, const body *b)
{
    gjk_result g = gjk_distance(hull_of(a), hull_of(b), HUGE_VAL, NULL);
    hit_result r = hit_face_find(hull_of(a), hull_of(b), &g.last);
    print_edges(a, "A");
    print_edges(b, "B");
    print_feature(a, &r.a, 'a');
    print_feature(b, &r.b, 'b');
    print_hit(&r);
}

int main(void)
{
    printf("# 05-features: the hit face and the features, m\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    body a = box((vec3){ 1, 1, 1 }), b = box((vec3){ 2.6, 1.9, 0.6 });
    vec3 z = vec3_unit((vec3){ 0.5, 0.8, 1 });
    vec3 x = vec3_unit(vec3_cross((vec3){ 0.2, 1, 0 }, z));
    place(&a, x, vec3_cross(z, x), (vec3){ 0.15, -0.1, 0.98 });
    print_case(&a, &b);
    const vec3 along = { 0, 1, 0 }, across = { 1, 0, 0 };
    a = box((vec3){ 1.9, 0.8, 0.8 });
    b = box((vec3){ 2.4, 0.8, 0.8 });
    vec3 slope = vec3_unit((vec3){ 0.1, 1, 1 });
    x = vec3_unit(vec3_cross(slope, across));
    place(&a, vec3_cross(x, slope), x, (vec3){ 0.12, 0.1, 1.0 });
    slope = vec3_unit((vec3){ 1, -0.1, 0.9 });
    x = vec3_unit(vec3_cross(slope, along));
    place(&b, vec3_cross(x, slope), x, (vec3){ 0.05, 0.1, 0 });
    print_case(&a, &b);
    return 0;
}
