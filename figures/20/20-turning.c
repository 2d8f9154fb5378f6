// 20-turning.c - hard cases 4, 6, 11 and 12: what turns, along the gradient at
// the old positions (ours) and at the new ones (Jakobsen's).  Blocks for
// gnuplot: errors of a pendulum and of a double one against the step; the spin
// of a box about its middle axis; the path of a top's axis.

#include "body.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

typedef long double wide;

static const real PI = 3.14159265358979323846, G = 9.81;
static const vec3 ORIGIN = { 0, 0, 0 }, GRAVITY = { 0, -9.81, 0 };
static const gradient_kind WAY[2] = { GRADIENT_OLD, GRADIENT_NEW };
static const char *const NAME[2] = { "old gradient", "new gradient" };

static relax_options along(gradient_kind gradient, real tolerance)
{
    relax_options o = relax_options_default();
    o.gradient = gradient;
    o.tolerance = tolerance;
    return o;
}

// ---- 4 and 6: pendulums ----------------------------------------------------

// Rods of 1 and 0.7 m with 1 and 2 kg at their ends; or the upper one alone.
static const real LENGTH[2] = { 1, 0.7 }, MASS[2] = { 1, 2 };

// The angles from the vertical, and their speeds.
typedef struct { wide a[2], u[2]; } angles;

// Their rates, from Lagrange's equations.
static angles rates(int rods, angles s)
{
    wide m = (wide)MASS[0], n = rods > 1 ? (wide)MASS[1] : 0;
    wide l = (wide)LENGTH[0], k = (wide)LENGTH[1], g = (wide)G;
    wide d = s.a[0] - s.a[1], c = cosl(d), u = s.u[0], v = s.u[1];
    wide bottom = 2 * m + n - n * cosl(2 * d);
    wide up = -g * (2 * m + n) * sinl(s.a[0])
            - n * g * sinl(s.a[0] - 2 * s.a[1])
            - 2 * sinl(d) * n * (v * v * k + u * u * l * c);
    wide low = 2 * sinl(d) * (u * u * l * (m + n) + g * (m + n) * cosl(s.a[0])
                              + v * v * k * n * c);
    return (angles){ { u, v }, { up / (l * bottom), low / (k * bottom) } };
}

static angles moved(angles s, wide h, angles r)
{
    for (int i = 0; i < 2; i++) {
        s.a[i] += h * r.a[i];
        s.u[i] += h * r.u[i];
    }
    return s;
}

// After 2 s: Runge and Kutta's fourth order, in long double.
static angles reference(int rods, angles s)
{
    const int steps = 40000;
    wide h = 2 / (wide)steps;
    for (int n = 0; n < steps; n++) {
        angles a = rates(rods, s), b = rates(rods, moved(s, h / 2, a));
        angles c = rates(rods, moved(s, h / 2, b));
        angles d = rates(rods, moved(s, h, c));
        s = moved(s, h / 6, a);
        s = moved(s, h / 3, b);
        s = moved(s, h / 3, c);
        s = moved(s, h / 6, d);
    }
    return s;
}

static vec3 rod(int i, wide turn)
{
    return vec3_make(LENGTH[i] * (real)sinl(turn),
                     -LENGTH[i] * (real)cosl(turn), 0);
}

// m, how far the lower end is off after 2 s at so many steps a second.
static real pendulum_error(int rods, angles s, angles truth, int rate,
                           gradient_kind gradient)
{
    real dt = 1.0 / rate;
    angles r = rates(rods, s);
    particle p[3] = { particle_start(ORIGIN, ORIGIN, ORIGIN, 0, dt) };
    stick link[2];
    vec3 x = ORIGIN, fall = ORIGIN, end = ORIGIN;
    for (int i = 0; i < rods; i++) {
        x = vec3_add(x, rod(i, s.a[i]));
        fall = vec3_add_scaled(fall, (real)r.u[i],
                               rod(i, s.a[i] + (wide)PI / 2));
        end = vec3_add(end, rod(i, truth.a[i]));
        p[i + 1] = particle_start(x, ORIGIN, fall, 1 / MASS[i], dt);
        link[i] = (stick){ i, i + 1, LENGTH[i], 1, STICK_EXACT };
    }
    relax_options o = along(gradient, 1e-15);
    for (int n = 0; n < 2 * rate; n++) {
        verlet_step(p, rods + 1, GRAVITY, NULL, dt);
        sticks_relax(link, rods, p, 200, o);
    }
    return vec3_distance(p[rods].position, end);
}

static void print_pendulum(int rods)
{
    const angles start = { { (wide)PI / 2, (wide)PI / 6 }, { 0, 0 } };
    angles truth = reference(rods, start);
    for (int k = 0; k < 2; k++) {
        printf("\n\n# %s pendulum, %s\n# dt [s] error [m]\n",
               rods > 1 ? "a double" : "a", NAME[k]);
        for (int rate = rods > 1 ? 120 : 60; rate <= 3840; rate *= 2)
            printf("%.6g %.4g\n", 1.0 / rate,
                   pendulum_error(rods, start, truth, rate, WAY[k]));
    }
}

// ---- 11 and 12: free boxes -------------------------------------------------

typedef struct {
    shape plan;
    particle p[8];
    vec3 inertia;       // kg m^2, about its axes
    real dt;
} top;

static vec3 divided(vec3 a, vec3 b)
{
    return vec3_make(a.x / b.x, a.y / b.y, a.z / b.z);
}

// (I w) x w, by the moments: Euler's equation.
static vec3 euler(vec3 inertia, vec3 w)
{
    vec3 l = { inertia.x * w.x, inertia.y * w.y, inertia.z * w.z };
    return divided(vec3_cross(l, w), inertia);
}

static void top_start(top *t, vec3 sides, vec3 w, real dt)
{
    vec3 s = { sides.x * sides.x, sides.y * sides.y, sides.z * sides.z };
    *t = (top){ .dt = dt };
    if (!shape_box(&t->plan, sides, 8).ok) {
        fprintf(stderr, "20-turning: out of memory\n");
        exit(1);
    }
    t->inertia = vec3_make(2 * (s.y + s.z), 2 * (s.z + s.x), 2 * (s.x + s.y));
    vec3 turn = euler(t->inertia, w);
    for (int i = 0; i < 8; i++) {
        vec3 r = t->plan.at[i], v = vec3_cross(w, r);
        vec3 a = vec3_add(vec3_cross(turn, r), vec3_cross(w, v));
        t->p[i] = particle_start(r, v, a, 1, dt);
    }
}

static void top_step(top *t, gradient_kind gradient)
{
    verlet_step(t->p, 8, ORIGIN, NULL, t->dt);
    sticks_relax(t->plan.stick, t->plan.sticks, t->p, 100,
                 along(gradient, 1e-10));
}

// kg m^2/s, of the last step.
static vec3 top_momentum(const top *t)
{
    vec3 sum = ORIGIN;
    for (int i = 0; i < 8; i++)
        sum = vec3_add(sum, vec3_cross(t->p[i].previous, t->p[i].position));
    return vec3_scale(1 / t->dt, sum);
}

// Bit 1, 2 or 4 of a particle's number: on which side of the axis x, y or z.
static vec3 top_axis(const top *t, int bit)
{
    vec3 sum = ORIGIN;
    for (int i = 0; i < 8; i++)
        sum = vec3_add_scaled(sum, i & bit ? 1 : -1, t->p[i].position);
    return vec3_unit(sum);
}

enum { SUBSTEPS = 8, FEW = 2 };

// By Euler's equation, again by Runge and Kutta.
static void print_truth(vec3 inertia, vec3 w)
{
    const int inner = 100;
    const real h = 1.0 / 60 / inner;
    printf("\n\n# the middle axis, Euler's equation\n# t [s] spin [rad/s]\n");
    for (int n = 0; n <= 1200 * inner; n++) {
        if (n % (3 * inner) == 0) printf("%.6g %.6g\n", n * h, w.y);
        vec3 a = euler(inertia, w);
        vec3 b = euler(inertia, vec3_add_scaled(w, h / 2, a));
        vec3 c = euler(inertia, vec3_add_scaled(w, h / 2, b));
        vec3 d = euler(inertia, vec3_add_scaled(w, h, c));
        w = vec3_add_scaled(w, h / 6, vec3_add(a, d));
        w = vec3_add_scaled(w, h / 3, vec3_add(b, c));
    }
}

static void print_middle_axis(void)
{
    const vec3 sides = { 1, 2, 3 }, w = { 0.01, 5, 0.01 };
    top t;
    for (int k = 0; k < 2; k++) {
        top_start(&t, sides, w, 1.0 / 60 / SUBSTEPS);
        if (k == 0) print_truth(t.inertia, w);
        printf("\n\n# the middle axis, %s, %d substeps\n# t [s] spin [rad/s]\n",
               NAME[k], SUBSTEPS);
        for (int n = 1; n <= 1200 * SUBSTEPS; n++) {
            top_step(&t, WAY[k]);
            real spin = vec3_dot(top_momentum(&t), top_axis(&t, 2));
            if (n % (3 * SUBSTEPS) == 0)
                printf("%.6g %.6g\n", n * t.dt, spin / t.inertia.y);
        }
        shape_free(&t.plan);
    }
}

// Seen along the angular momentum that it began with.
static void print_top(void)
{
    top t;
    for (int k = 0; k < 2; k++) {
        const vec3 w = { 3, 0, 5 };
        top_start(&t, vec3_make(1, 1, 2), w, 1.0 / 60 / FEW);
        vec3 up = vec3_unit(vec3_make(t.inertia.x * w.x, 0, t.inertia.z * w.z));
        vec3 north = vec3_make(0, 1, 0), east = vec3_cross(north, up);
        printf("\n\n# the axis of a top, %s, %d substeps\n# east north\n",
               NAME[k], FEW);
        for (int n = 0; n <= 600 * FEW; n++) {
            vec3 axis = top_axis(&t, 4);
            printf("%.6g %.6g\n", vec3_dot(axis, east), vec3_dot(axis, north));
            top_step(&t, WAY[k]);
        }
        shape_free(&t.plan);
    }
}

int main(void)
{
    printf("# Hard cases 4, 6, 11 and 12: pendulums, a box and a top, along "
           "the old gradient and the new one\n# %s, %s\n", __VERSION__, FLAGS);
    print_pendulum(1);
    print_pendulum(2);
    print_middle_axis();
    print_top();
    return 0;
}
