// 05-wrong.c - a box that has sunk a little into a floor, near its edge: pushed
// out along the line between the middles, and by the least move.
//
// Blocks, each after two blank lines; x y in metres, columns separated by
// spaces:
// 0  the floor, closed
// 1  the box, closed
// 2  the box, pushed along the line between the middles until it is free
// 3  the box, moved by the hit face
// 4  the move of 2: from x y, by dx dy, length
// 5  the move of 3, likewise

#include "hit_face.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CORNERS = 8 };

typedef struct {
    vec3 at[CORNERS];
    vec3 middle;
} box;

// A rectangle in x and y, turned, and 8 m deep in z.
static box box_make(vec3 middle, real width, real height, vec3 along)
{
    box b = { .middle = middle };
    vec3 up = vec3_cross(vec3_make(0, 0, 1), along);
    const real side[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    for (int k = 0; k < CORNERS; k++) {
        vec3 p = vec3_add_scaled(middle, side[k % 4][0] * width / 2, along);
        p = vec3_add_scaled(p, side[k % 4][1] * height / 2, up);
        p.z += k < 4 ? -4 : 4;
        b.at[k] = p;
    }
    return b;
}

static hull hull_of(const box *b)
{
    return (hull){ b->at, CORNERS };
}

static void print_box(const box *b, vec3 by, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k <= 4; k++) {
        vec3 p = vec3_add(b->at[k % 4], by);
        printf("%.6f %.6f\n", p.x, p.y);
    }
}

static void print_move(const box *b, vec3 by, const char *name)
{
    printf("\n\n# %s: %.3f m\n", name, vec3_length(by));
    printf("%.6f %.6f %.6f %.6f %.6f\n", b->middle.x, b->middle.y, by.x, by.y,
           vec3_length(by));
}

int main(void)
{
    vec3 tilt = vec3_unit(vec3_make(1, 0.12, 0));
    box floor = box_make(vec3_make(0, -0.5, 0), 8, 1, vec3_make(1, 0, 0));
    box b = box_make(vec3_make(2.75, 0.52, 0), 1.4, 1, tilt);
    gjk_result g = gjk_distance(hull_of(&b), hull_of(&floor), HUGE_VAL, NULL);
    hit_result r = hit_face_find(hull_of(&b), hull_of(&floor), &g.last);
    // Along any direction n the bodies part when A - B has passed the origin.
    vec3 n = vec3_unit(vec3_sub(b.middle, floor.middle));
    corner c = hull_support(hull_of(&b), hull_of(&floor), vec3_scale(-1, n));
    vec3 sideways = vec3_scale(-vec3_dot(n, c.at), n);
    vec3 out = vec3_scale(r.depth, r.normal);
    printf("# 05-wrong: a box at the edge of a floor, two ways out, m\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    print_box(&floor, vec3_make(0, 0, 0), "floor");
    print_box(&b, vec3_make(0, 0, 0), "box");
    print_box(&b, sideways, "pushed from middle to middle");
    print_box(&b, out, "moved by the hit face");
    print_move(&b, sideways, "from middle to middle");
    print_move(&b, out, "by the hit face");
    return 0;
}
