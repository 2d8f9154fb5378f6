// 10-tin.c - a tin on the floor, seen from the side: its outline, its axis, and the
// capsule that the floor meets in its place, when the tin lies and when it leans.

#include "vec3.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const real RADIUS = 0.4, HALF = 0.75;    // m

static void print_line(vec3 a, vec3 b)
{
    printf("%.6g,%.6g\n%.6g,%.6g\n\n\n", a.x, a.y, b.x, b.y);
}

// The axis leans by the angle with this cosine and sine.  The lowest point of
// either end is straight below a place of the axis.
static void print_tin(real cosine, real sine)
{
    real tangent = sine / cosine, thick = RADIUS / cosine;
    vec3 along = vec3_make(cosine, sine, 0), up = vec3_make(-sine, cosine, 0);
    vec3 middle = vec3_make(0, HALF * sine + RADIUS * cosine, 0);
    vec3 left = vec3_add_scaled(middle, -HALF, along);
    vec3 right = vec3_add_scaled(middle, HALF, along);
    vec3 corner[] = { vec3_add_scaled(left, -RADIUS, up),
                      vec3_add_scaled(right, -RADIUS, up),
                      vec3_add_scaled(right, RADIUS, up),
                      vec3_add_scaled(left, RADIUS, up) };
    for (int k = 0; k <= 4; k++)
        printf("%.6g,%.6g\n", corner[k % 4].x, corner[k % 4].y);
    printf("\n\n");

    vec3 first = vec3_add_scaled(middle, -HALF + RADIUS * tangent, along);
    vec3 last = vec3_add_scaled(middle, HALF + RADIUS * tangent, along);
    print_line(left, last);
    for (int side = -1; side <= 1; side += 2)
        print_line(vec3_add_scaled(first, side * thick, up),
                   vec3_add_scaled(last, side * thick, up));
    printf("%.6g,%.6g,%.6g\n%.6g,%.6g,%.6g\n\n\n", first.x, first.y, thick,
           last.x, last.y, thick);
    print_line(first, corner[0]);
    print_line(last, corner[1]);
}

int main(void)
{
    printf("# a tin, and the capsule that the floor meets in its place (m)\n"
           "# compiler: %s\n# flags: %s\nx,y,radius\n\n\n", __VERSION__, FLAGS);
    print_tin(1, 0);
    print_tin(0.96, 0.28);
    return 0;
}
