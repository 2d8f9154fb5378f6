// 10-ride.c - the points of one query ride with their bodies: outlines, points,
// normal and gap when the query is asked, and when both have moved; and a
// capsule, of which the query sees the core.  Seen from the front.

#include "capsule.h"
#include "query.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { MOST = 8 };

// A body whose shape's z axis looks at us.
typedef struct {
    const shape *shape;
    vec3 at[MOST];
} posed;

// Turned about z by the angle whose cosine and sine these are, then moved.
static posed pose(const shape *s, real x, real y, real cosine, real sine)
{
    posed p = { .shape = s };
    for (int i = 0; i < s->particles; i++) {
        vec3 r = s->at[i];
        p.at[i] = vec3_make(x + cosine * r.x - sine * r.y,
                            y + sine * r.x + cosine * r.y, r.z);
    }
    return p;
}

static query_result ask(const posed *a, const posed *b)
{
    collider ca = { a->shape, a->at, false }, cb = { b->shape, b->at, false };
    query_cache none = { .count = 0 };
    return query_nearest(&ca, &cb, HUGE_VAL, &none);
}

// The four corners of a box in front.
static void print_box(const posed *p)
{
    const int around[] = { 4, 5, 7, 6, 4 };
    for (int i = 0; i < 5; i++)
        printf("%.6g,%.6g\n", p->at[around[i]].x, p->at[around[i]].y);
    printf("\n\n");
}

static void print_points(vec3 a, vec3 b)
{
    printf("%.6g,%.6g\n%.6g,%.6g\n\n\n", a.x, a.y, b.x, b.y);
}

// From the point of B along n as far as the gap: start, way.
static void print_gap(vec3 b, vec3 n, real gap)
{
    printf("%.6g,%.6g,%.6g,%.6g\n\n\n", b.x, b.y, gap * n.x, gap * n.y);
}

// Around a core from p to q: half a circle at each end.
static void print_capsule(vec3 p, vec3 q, real radius)
{
    vec3 along = vec3_unit(vec3_sub(q, p));
    real c = 1, s = 0, dc = 0.99144486137381038, ds = 0.13052619222005157;
    vec3 left = vec3_make(-along.y, along.x, 0);
    for (int i = 0; i <= 48; i++) {
        vec3 middle = i <= 24 ? p : q;
        vec3 x = vec3_add_scaled(middle, radius * c, left);
        x = vec3_add_scaled(x, -radius * s, along);
        printf("%.6g,%.6g\n", x.x, x.y);
        if (i == 24) {
            x = vec3_add_scaled(vec3_add_scaled(q, radius * c, left),
                                -radius * s, along);
            printf("%.6g,%.6g\n", x.x, x.y);
        }
        real next = dc * c - ds * s;
        s = dc * s + ds * c;
        c = next;
    }
    vec3 first = vec3_add_scaled(p, radius, left);
    printf("%.6g,%.6g\n\n\n", first.x, first.y);
}

int main(void)
{
    shape box, rod;
    if (!shape_box(&box, vec3_make(1, 1, 1), 1).ok
        || !shape_capsule(&rod, 0.9, 0.22, 1).ok) return 1;
    printf("# the points of a query ride with their bodies (m)\n"
           "# compiler: %s\n# flags: %s\nx,y\n\n\n", __VERSION__, FLAGS);

    // 1 to 4: A, B, the nearest points, the gap; when asked.
    posed b = pose(&box, 0, 0, 1, 0), a = pose(&box, 0.05, 1.55, 0.8, 0.6);
    query_result q = ask(&a, &b);
    print_box(&a);
    print_box(&b);
    print_points(feature_at(&q.at.a, a.at), feature_at(&q.at.b, b.at));
    print_gap(feature_at(&q.at.b, b.at), q.normal, q.at.gap);

    // 5 to 9: both have moved; the points ride; the gap along the old normal;
    // and the points that are nearest now.
    posed moved = pose(&box, -0.04, 1.46, 0.5, 0.86602540378443865);
    posed later = pose(&box, 0.02, 0.02, 0.995, 0.0998749217771909);
    vec3 on_a = feature_at(&q.at.a, moved.at), on_b = feature_at(&q.at.b, later.at);
    real gap = vec3_dot(vec3_sub(on_a, on_b), q.normal);
    query_result now = ask(&moved, &later);
    print_box(&moved);
    print_box(&later);
    print_points(on_a, on_b);
    print_gap(on_b, q.normal, gap);
    print_points(feature_at(&now.at.a, moved.at),
                 feature_at(&now.at.b, later.at));
    printf("# gaps: asked, ridden, now (m)\n%.6g,%.6g,%.6g\n\n\n", q.at.gap, gap,
           now.at.gap);

    // 11 to 15: a capsule over a box: outline, core, core's nearest points,
    // those of the surfaces, the gap.
    posed c = pose(&rod, -0.05, 1.4, 0.5, 0.86602540378443865);
    q = ask(&c, &b);
    vec3 core = feature_at(&q.at.a, c.at), foot = feature_at(&q.at.b, b.at);
    print_capsule(c.at[0], c.at[1], rod.round);
    print_points(c.at[0], c.at[1]);
    print_points(core, foot);
    print_points(vec3_add_scaled(core, -rod.round, q.normal), foot);
    print_gap(foot, q.normal, q.at.gap);
    shape_free(&box);
    shape_free(&rod);
    return 0;
}
