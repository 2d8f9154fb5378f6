// 02-rope.c - a rope of 50 sticks, 1 m long, pinned at one end.  Hanging: how
// far it stretches.  Let go at 30 degrees: how much energy it loses.  Both
// against the cost, for the three ways, and for many iterations against many
// small steps.

#include "clock.h"
#include "constraint.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { LINKS = 50, FRAMES = 300, LAST = 60, WAYS = 3 };

static const char *const way_name[WAYS] = {
    "PBD, exact root", "PBD, approximate root", "SHAKE"
};
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const real ROOT = 0.86602540378443865;   // cos 30 degrees

static relax_options way(int k)
{
    relax_options o = relax_options_pbd();
    if (k == 1) o.root = ROOT_APPROXIMATE;
    if (k == 2) o.gradient = GRADIENT_OLD;
    return o;
}

typedef struct {
    particle p[LINKS + 1];
    stick s[LINKS];
} rope;

static rope rope_start(int swing, real end_mass, real dt)
{
    rope r;
    for (int i = 0; i <= LINKS; i++) {
        real down = (real)i / LINKS;
        vec3 x = { swing ? down / 2 : 0, swing ? -ROOT * down : -down, 0 };
        r.p[i] = particle_start(x, (vec3){ 0, 0, 0 }, GRAVITY, i > 0, dt);
        // A rope that hangs is held: it starts from rest, without a fall.
        if (!swing) r.p[i].previous = x;
    }
    r.p[LINKS].inverse_mass = 1 / end_mass;
    for (int i = 0; i < LINKS; i++)
        r.s[i] = (stick){ i, i + 1, 1.0 / LINKS, 1, STICK_EXACT };
    return r;
}

// Over the last second: the largest strain, and the mean energy (J, height 0
// at the pin; 1 kg a particle), taken half a step back in time.
typedef struct {
    real strain, energy;
    double seconds;         // of processor time, a frame
} outcome;

static void look(const rope *r, real dt, outcome *o)
{
    for (int i = 0; i < LINKS; i++)
        o->strain = fmax(o->strain, stick_strain(r->s[i], r->p));
    for (int i = 1; i <= LINKS; i++) {
        vec3 move = vec3_sub(r->p[i].position, r->p[i].previous);
        real height = (r->p[i].position.y + r->p[i].previous.y) / 2;
        o->energy += (vec3_dot(move, move) / (2 * dt * dt) + 9.81 * height)
                   / LAST;
    }
}

static outcome run(int swing, real end_mass, int k, int iterations,
                   int substeps)
{
    real dt = 1.0 / 60 / substeps;
    relax_options o = way(k);
    rope r = rope_start(swing, end_mass, dt);
    outcome out = { 0, 0, 1e9 };
    for (int frame = 0; frame < FRAMES; frame++) {
        double begin = clock_seconds();
        for (int j = 0; j < substeps; j++) {
            verlet_step(r.p, LINKS + 1, GRAVITY, NULL, dt);
            for (int i = 0; i < iterations; i++)
                sticks_iterate(r.s, LINKS, r.p, o);
        }
        // The fastest of all frames: the others were interrupted.
        out.seconds = fmin(out.seconds, clock_seconds() - begin);
        if (frame >= FRAMES - LAST) look(&r, dt, &out);
    }
    return out;
}

int main(void)
{
    printf("# A rope of 50 sticks, 60 frames a second, 5 s: strain, energy, "
           "cost\n# %s, %s\n", __VERSION__, FLAGS);
    double unit = run(0, 1, 0, 10, 1).seconds;
    printf("# cost 1 = a frame of 10 iterations of PBD, exact root = %.2f us\n",
           unit * 1e6);
    printf("# 10,000 times the weight at its end: strain %.3g with 10 "
           "iterations, %.3g with 64 substeps\n",
           run(0, 10000, 0, 10, 1).strain,
           run(0, 10000, 0, 1, 64).strain);
    // The energy at the start, and what there is to lose until it hangs.
    real first = -ROOT * 9.81 * (LINKS + 1) / 2;
    real all = first + 9.81 * (LINKS + 1) / 2;
    for (int many = 0; many < 2; many++)
        for (int k = 0; k < WAYS; k++) {
            printf("\n\n# %s, n %s\n# n cost hanging_strain swing_strain "
                   "swing_energy_lost\n", way_name[k],
                   many ? "substeps of one iteration"
                        : "iterations of one step");
            for (int n = 1; n <= 256; n *= 2) {
                outcome h = run(0, 1, k, many ? 1 : n, many ? n : 1);
                outcome l = run(1, 1, k, many ? 1 : n, many ? n : 1);
                printf("%d %.4g %.4g ", n, h.seconds / unit, h.strain);
                // A run that exploded has no number to show.
                real lost = (first - l.energy) / all;
                if (fabs(lost) < 1e3)
                    printf("%.4g %.4g\n", l.strain, lost);
                else
                    printf("nan nan\n");
            }
        }
    return 0;
}
