// 13-four.c - a box, the four particles that move as it does, and their frame;
// and how a straight move becomes a turn.
//
// 0      x y dx dy: the edges of the box
// 1      x y dx dy: the six sticks
// 2      x y: the four particles
// 3      x y dx dy: the axes of the frame
// 4      x y dx dy: the old radius, the tangent, the way back, the new radius
// 5      x y dx dy: the arc
// Metres, seen from afar; columns are separated by spaces.

#include "rigid4.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// Where a point is seen, from the right and above.
static vec3 seen(vec3 r)
{
    const vec3 right = { 0.94, 0, -0.34 }, up = { -0.1, 0.956, -0.276 };
    return vec3_make(vec3_dot(r, right), vec3_dot(r, up), 0);
}

static void print_arrow(vec3 from, vec3 to)
{
    printf("%.5f %.5f %.5f %.5f\n", from.x, from.y, to.x - from.x,
           to.y - from.y);
}

static void print_box(const shape *s, const rigid4 *f)
{
    const vec3 origin = { 0, 0, 0 };
    particle p[FOUR];
    printf("\n\n");
    for (int v = 0; v < 8; v++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(v & bit)) print_arrow(seen(s->at[v]), seen(s->at[v | bit]));
    printf("\n\n");
    for (int k = 0; k < FOUR_STICKS; k++)
        print_arrow(seen(f->at[f->stick[k].a]), seen(f->at[f->stick[k].b]));
    printf("\n\n");
    for (int k = 0; k < FOUR; k++) {
        vec3 x = seen(f->at[k]);
        p[k].position = f->at[k];
        printf("%.5f %.5f\n", x.x, x.y);
    }
    rigid_frame frame = rigid4_frame(p);
    printf("\n\n");
    for (int i = 0; i < FOUR_AXES; i++)
        print_arrow(seen(origin), seen(frame.axis[i]));
}

static void print_turn(void)
{
    enum { PIECES = 40 };
    const real a = 0.7;
    const vec3 middle = { 0, 0, 0 }, old = { 1, 0, 0 };
    vec3 straight = { 1, sin(a), 0 }, now = { cos(a), sin(a), 0 };
    printf("\n\n");
    print_arrow(middle, old);
    print_arrow(old, straight);
    print_arrow(straight, now);
    print_arrow(middle, now);
    printf("\n\n");
    for (int k = -8; k < PIECES; k++) {
        real b = a * k * 1.4 / PIECES, c = a * (k + 1) * 1.4 / PIECES;
        print_arrow(vec3_make(cos(b), sin(b), 0), vec3_make(cos(c), sin(c), 0));
    }
}

int main(void)
{
    shape box;
    rigid4 four;
    if (!shape_box(&box, vec3_make(2.6, 1.3, 1.8), 1).ok
        || !rigid4_build(&four, &box).ok) exit(1);
    printf("# 13-four: four particles in a box, m\n# compiler %s, flags %s",
           __VERSION__, FLAGS);
    print_box(&box, &four);
    print_turn();
    rigid4_free(&four);
    shape_free(&box);
    return 0;
}
