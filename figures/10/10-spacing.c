// 10-spacing.c - how far apart are the numbers that a coordinate may be?
//
// Between two neighbouring numbers there is no other: what is smaller than
// half their distance is rounded away.  A Verlet step adds g dt^2 to a
// coordinate; where that is less than half a spacing, gravity is gone.
//
// The first block: spacing of float and double at a distance from the origin.
// The second: the largest coordinate at which a step still falls.

#include <math.h>
#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const double GRAVITY = 9.81;     // m/s^2

static double float_spacing(float x)
{
    return (double)nextafterf(x, INFINITY) - (double)x;
}

static double double_spacing(double x)
{
    return nextafter(x, HUGE_VAL) - x;
}

// Tries each power of two: does x move when g dt^2 is added to it?
static void print_reach(double steps_per_second)
{
    double move = GRAVITY / (steps_per_second * steps_per_second);
    int in_float = -40, in_double = -40;
    while (in_float < 127) {
        volatile float x = ldexpf(1, in_float), moved = x + (float)move;
        if (moved == x) break;
        in_float++;
    }
    while (in_double < 1023) {
        volatile double x = ldexp(1, in_double), moved = x + move;
        if (moved == x) break;
        in_double++;
    }
    printf("%g %.6g %.6g %.6g\n", steps_per_second, move,
           ldexp(1, in_float), ldexp(1, in_double));
}

int main(void)
{
    printf("# Distance between neighbouring numbers, by distance from the origin\n");
    printf("# compiler: %s; flags: %s\n", __VERSION__, FLAGS);
    printf("# distance_m float_m double_m\n");
    // The spacing doubles at each power of two and is even in between.
    for (int i = -10; i <= 24; i++) {
        double x = ldexp(1, i);
        printf("%.6g %.6g %.6g\n", x, float_spacing((float)x), double_spacing(x));
    }
    printf("\n\n# A step of gravity: the first power of two at which x + g dt^2 is x\n");
    printf("# steps_per_s g_dt2_m float_m double_m\n");
    print_reach(60);
    print_reach(600);
    print_reach(6000);
    return 0;
}
