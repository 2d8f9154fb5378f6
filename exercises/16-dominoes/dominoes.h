// dominoes.h - a row of dominoes, of which the first is pushed.
//
// Units: metres, seconds, radians.  y points up; the row runs along x.

#ifndef TUMBLE_DOMINOES_H
#define TUMBLE_DOMINOES_H

#include "step.h"

// rad/s: a domino of this thickness and height (m) that stands upright, and
// turns about one of its lower edges so fast, just gets over that edge, where
// gravity is g (m/s^2).  All three > 0.
real domino_least_spin(real thickness, real height, real g);

// Adds n dominoes to a world that has no bodies yet, built to plan s, a box of
// these sides (m): thickness along x, height along y.  They stand on the floor
// y = 0, one `gap` (m) behind the other, the first at x = z = 0 (its middle);
// each as high over the floor as its skin keeps it: w->options.skin of the
// plan's radius.  All are at rest but the first, which turns about its lower
// edge at +x with `spin` (rad/s), forwards if > 0.  Fails with the sentence of
// world_add, and adds no more then.
status domino_row(world *w, const shape *s, vec3 sides, int n, real gap,
                  real spin);

// rad, how far body b, a domino as above, leans from upright: 0 to pi.
real domino_lean(const world *w, int b);

#endif
