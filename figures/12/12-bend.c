// 12-bend.c - a strip that is held level at one end sags under its own weight:
// how far, against the theory of the elastica, for loads q L^3 / (E I) from 0.1
// to 300, in 5, 10, 20 and 40 links.

#include "bend.h"

#include <stdio.h>
#include <stdlib.h>

enum { MOST = 50, SETTLE = 30000, LOADS = 28 };
static const real PI = 3.14159265358979323846;

// ---- The elastica ----------------------------------------------------------

// At s, of a length of 1, the strip slopes down by theta.  A piece of it carries
// all that hangs beyond it:
//     theta'' = -load (1 - s) cos theta,  theta(0) = 0,  theta'(1) = 0.
// Back from the free end, where theta is a right angle but for `less`.  Returns
// theta(0); the end hangs *sag below the clamp.
static real shoot(real load, real less, real *sag)
{
    enum { STEPS = 20000 };
    const real h = 1.0 / STEPS;
    // All angles as what they lack of a right one, which may be very little.
    real lack = less, rate = 0;
    *sag = 0;
    for (int k = 0; k < STEPS; k++) {
        // The midpoint rule; t = 1 - s, and lack'' = load t sin lack.
        real t = k * h, half = lack + rate * h / 2;
        real half_rate = rate + load * t * sin(lack) * h / 2;
        *sag += h * cos(half);
        lack += h * half_rate;
        rate += h * load * (t + h / 2) * sin(half);
    }
    return PI / 2 - lack;
}

static real elastica(real load)
{
    real low = -200, high = log(PI / 2), sag;
    for (int k = 0; k < 100; k++) {
        real middle = (low + high) / 2;
        if (shoot(load, exp(middle), &sag) > 0) low = middle;
        else                                    high = middle;
    }
    return sag;
}

// ---- The strip -------------------------------------------------------------

// One metre beyond the clamp, which grips the first link in its middle: 1 kg a
// metre, 1 m/s^2.
static real sag(int links, real load)
{
    const real h = 0.01;
    static particle p[MOST];
    static bend_row room[MOST];
    shape strip;
    real l = 1 / (links + 0.5), whole = (links + 1) * l;
    if (!shape_rope(&strip, links + 1, whole, whole).ok) exit(1);
    line_scratch *scratch = line_scratch_new(&strip);
    if (!scratch) exit(1);
    relax_options o = relax_options_default();
    o.gradient = GRADIENT_OLD;
    for (int i = 0; i < strip.particles; i++) {
        vec3 x = { i * l, 0, 0 };
        // Only half a link hangs on the last particle.
        real mass = i == strip.particles - 1 ? l / 2 : l;
        p[i] = (particle){ x, x, i > 1 ? 1 / mass : 0 };
    }
    for (int step = 0; step < SETTLE; step++) {
        for (int i = 2; i < strip.particles; i++)
            p[i].previous = vec3_add_scaled(vec3_scale(0.03, p[i].position),
                                            0.97, p[i].previous);
        verlet_step(p, strip.particles, vec3_make(0, -1, 0), NULL, h);
        bend_relax(&strip, 1 / load, p, h, room);
        lines_relax(&strip, p, 1, 10, o, NULL, 0, scratch);
    }
    real drop = -p[strip.particles - 1].position.y;
    line_scratch_free(scratch);
    shape_free(&strip);
    return drop;
}

int main(void)
{
    const int links[] = { 5, 10, 20, 40 };
    printf("# load q L^3 / (E I); sag / L: theory, 5, 10, 20, 40 links\n");
    for (int k = 0; k <= LOADS; k++) {
        real load = 0.1 * pow(10, 3.5 * k / LOADS);
        printf("%.6g %.6g", load, elastica(load));
        for (int m = 0; m < 4; m++) printf(" %.6g", sag(links[m], load));
        printf("\n");
    }
    return 0;
}
