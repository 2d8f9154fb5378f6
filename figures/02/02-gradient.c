// 02-gradient.c - one step of a stick that spins about its pinned end: where
// Verlet puts the free end, and where PBD and SHAKE bring it back to.

#include "constraint.h"

#include <math.h>
#include <stdio.h>

static const real TURN = 0.55;      // rad a step

static void print(const char *name, vec3 v)
{
    printf("\"%s\" %.4f %.4f\n", name, v.x, v.y);
}

static vec3 end_at(real bearing)
{
    return vec3_make(cos(bearing), sin(bearing), 0);
}

// The free end after the step, corrected with this gradient until it is right.
static vec3 corrected(particle pinned, particle moved, gradient_kind gradient)
{
    const stick s = { 0, 1, 1, 1, STICK_EXACT };
    particle p[2] = { pinned, moved };
    relax_options o = relax_options_default();
    o.gradient = gradient;
    for (int k = 0; k < 30; k++) stick_relax(s, p, o);
    return p[1].position;
}

int main(void)
{
    const vec3 none = { 0, 0, 0 };
    const real bearing = 1.35;
    particle pinned = { none, none, 0 };
    particle p = { end_at(bearing), end_at(bearing + TURN), 1 };
    printf("# the free end: name x y\n");
    print("before", p.previous);
    print("now", p.position);
    verlet_step(&p, 1, none, NULL, 1);
    print("straight on", p.position);
    vec3 pbd = corrected(pinned, p, GRADIENT_NEW);
    vec3 shake = corrected(pinned, p, GRADIENT_OLD);
    print("PBD", pbd);
    print("SHAKE", shake);
    printf("# turned by %.3f rad a step; the next step turns PBD's stick by "
           "%.3f, SHAKE's by %.3f\n", TURN, bearing - atan2(pbd.y, pbd.x),
           bearing - atan2(shake.y, shake.x));
    return 0;
}
