// 00b-spin.c - two weights turn about their middle, and a string pulls them in:
// what is kept, and who pays; and the moment of inertia of a box cut into points.

#include "vec3.h"

#include <stdio.h>

static const real PI = 3.14159265358979323846;
static const real M = 2;                    // kg, each
static const real FAR = 1, NEAR = 0.4;      // m, from the middle
static const real OMEGA = 3;                // rad/s, at first
static const real STIFFNESS = 40000;        // N/m, of the string
static const real DT = 1e-5, LASTS = 5;     // s

typedef struct {
    vec3 x, v;
} weight;

static real turning(const weight *p)        // kg m^2/s
{
    return M * (vec3_cross(p[0].x, p[0].v).z + vec3_cross(p[1].x, p[1].v).z);
}

static real motion(const weight *p)
{
    return M * (vec3_length_squared(p[0].v) + vec3_length_squared(p[1].v)) / 2;
}

// One step; returns the work of the string.
static real step(weight *p, real length)
{
    vec3 along = vec3_sub(p[1].x, p[0].x);
    real stretched = vec3_length(along) - length;
    vec3 force = vec3_scale(STIFFNESS * stretched, vec3_unit(along));
    vec3 was[2] = { p[0].v, p[1].v };
    p[0].v = vec3_add_scaled(p[0].v, DT / M, force);
    p[1].v = vec3_add_scaled(p[1].v, -DT / M, force);
    real work = 0;
    for (int i = 0; i < 2; i++) {
        vec3 way = vec3_scale(DT / 2, vec3_add(was[i], p[i].v));
        work += (i ? -1 : 1) * vec3_dot(force, way);
        p[i].x = vec3_add_scaled(p[i].x, DT, p[i].v);
    }
    return work;
}

static void pull_in(void)
{
    weight p[2] = { { { -FAR, 0, 0 }, { 0, -OMEGA * FAR, 0 } }, { { FAR, 0, 0 }, { 0, OMEGA * FAR, 0 } } };
    real first = turning(p), energy = motion(p), work = 0, off = 0;
    real length = 2 * FAR - M * OMEGA * OMEGA * FAR / STIFFNESS;     // it holds them already
    int steps = (int)(LASTS / DT);
    printf("# t distance turns a second, motion, inertia\n");
    for (int k = 0; k <= steps; k++) {
        real r = vec3_length(p[1].x), inertia = 2 * M * r * r;
        if (k % (steps / 50) == 0)
            printf("%.2f %.4f %.4f %.4f %.4f\n", k * DT, r, turning(p) / inertia / (2 * PI), motion(p), inertia);
        if (k == steps) break;
        work += step(p, length);
        length -= 2 * (FAR - NEAR) / steps;
        off = real_max(off, fabs(turning(p) - first));
    }
    printf("# angular momentum %.3f kg m^2/s, off by %.0e\n", first, off);
    printf("# energy of motion: before %.3f J, after %.3f J, work of the string %.3f J\n", energy, motion(p), work);
}

// About the axis through the middle, of n x n x n points of equal mass.
static real box(int n, real mass, real a, real b)
{
    real sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            real x = a * ((i + 0.5) / n - 0.5), y = b * ((j + 0.5) / n - 0.5);
            sum += n * (x * x + y * y);
        }
    return mass * sum / (n * n * n);
}

int main(void)
{
    pull_in();
    const real m = 6, a = 2, b = 1, formula = m * (a * a + b * b) / 12;
    printf("#box| points along an edge,moment of inertia,too small by\n");
    for (int n = 1; n <= 64; n = n == 1 ? 2 : 2 * n)
        printf("#box| %d,%.4f,%.3g\n", n, box(n, m, a, b), 1 - box(n, m, a, b) / formula);
    printf("# box: formula %.4f kg m^2\n", formula);
    return 0;
}
