// 01-order.c - a planet, an orbit and a quarter: the error that each step
// leaves, against the time it took; and the energy over a hundred orbits.
// (After whole orbits the errors of first order of the symplectic step cancel:
// it would look better than it is.)

#include "clock.h"
#include "euler.h"
#include "verlet.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const real PI = 3.14159265358979323846;
static const vec3 NO_GRAVITY = { 0, 0, 0 };

typedef enum { EULER, SYMPLECTIC, VERLET, CARELESS, METHODS } method;
static const char *const name[METHODS] = {
    "explicit Euler", "symplectic Euler", "Verlet", "Verlet, careless start"
};

// The planet is let go at its nearest point, 0.7 from a sun of G M = 1, with
// the speed that makes the orbit 1 long in half its axis: period 2 pi.
static const vec3 START = { 0.7, 0, 0 };
static const vec3 SPEED = { 0, 1.3627702877384937, 0 };   // sqrt(1.3 / 0.7)

static vec3 pull(vec3 x)
{
    real r = vec3_length(x);
    return vec3_scale(-1 / (r * r * r), x);
}

typedef struct {
    euler_particle e;
    particle p;
} planet;

static planet planet_start(method m, real dt)
{
    vec3 a0 = m == CARELESS ? NO_GRAVITY : pull(START);
    return (planet){ { START, SPEED },
                     particle_start(START, SPEED, a0, 1, dt) };
}

static void planet_step(planet *s, method m, real dt)
{
    vec3 force = pull(m <= SYMPLECTIC ? s->e.position : s->p.position);
    if (m == EULER)
        euler_step_explicit(&s->e, force, dt);
    else if (m == SYMPLECTIC)
        euler_step_symplectic(&s->e, force, dt);
    else
        verlet_step(&s->p, 1, NO_GRAVITY, &force, dt);
}

static vec3 planet_at(const planet *s, method m)
{
    return m <= SYMPLECTIC ? s->e.position : s->p.position;
}

static real planet_energy(const planet *s, method m, real dt)
{
    vec3 x = planet_at(s, m);
    vec3 v = m <= SYMPLECTIC ? s->e.velocity
                             : verlet_velocity(&s->p, pull(x), dt);
    return vec3_dot(v, v) / 2 - 1 / vec3_length(x);
}

// Where the planet is an orbit and a quarter after its start.  Kepler: at the
// time t the angle E of the ellipse has E - 0.3 sin E = t; Newton finds it.
static vec3 kepler(void)
{
    real e = PI / 2;
    for (int k = 0; k < 20; k++)
        e -= (e - 0.3 * sin(e) - PI / 2) / (1 - 0.3 * cos(e));
    return (vec3){ cos(e) - 0.3, sqrt(1 - 0.09) * sin(e), 0 };
}

// The error in the end, and the best time of five that it took.
static real orbit(method m, int per_orbit, double *took)
{
    real dt = 2 * PI / per_orbit, error = 0;
    int steps = per_orbit / 4 * 5;
    *took = 1e9;
    for (int k = 0; k < 5; k++) {
        planet s = planet_start(m, dt);
        double begin = clock_seconds();
        int rounds = 1 + 20000 / steps;
        for (int j = 0; j < rounds; j++) {
            s = planet_start(m, dt);
            for (int i = 0; i < steps; i++) planet_step(&s, m, dt);
        }
        double t = (clock_seconds() - begin) / rounds;
        if (t < *took) *took = t;
        error = vec3_distance(planet_at(&s, m), kepler());
    }
    return error;
}

int main(void)
{
    printf("# A planet (eccentricity 0.3): error of its position after 1.25 "
           "orbits, in half axes, against cost\n# %s, %s\n",
           __VERSION__, FLAGS);
    double unit;
    orbit(VERLET, 1000, &unit);
    printf("# cost 1 = Verlet, 1000 steps an orbit, here %.1f us\n",
           unit * 1e6);
    for (int m = 0; m < METHODS; m++) {
        printf("\n\n# %s\n# steps_an_orbit cost error\n", name[m]);
        for (int steps = 64; steps <= 262144; steps *= 2) {
            double took;
            real error = orbit((method)m, steps, &took);
            printf("%d %.4g %.4g\n", steps, took / unit, error);
        }
    }
    for (int m = 0; m <= VERLET; m++) {
        printf("\n\n# %s: relative error of the energy, 200 steps an orbit\n"
               "# orbits error\n", name[m]);
        int steps = 200;
        real dt = 2 * PI / steps, worst = 0, next = 0.05;
        planet s = planet_start((method)m, dt);
        for (int i = 1; i <= 100 * steps; i++) {
            planet_step(&s, (method)m, dt);
            real e = fabs(planet_energy(&s, (method)m, dt) + 0.5) / 0.5;
            if (e > worst) worst = e;
            if (i >= next * steps) {
                printf("%.4g %.4g\n", (double)i / steps, worst);
                next *= 1.15;
                worst = 0;
            }
        }
    }
    return 0;
}
