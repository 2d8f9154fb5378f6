// dominoes.h - a row of dominoes, of which the first is pushed.
//
// Units: metres, seconds, radians.  y points up; the row runs along x.

#ifndef TUMBLE_DOMINOES_H
#define TUMBLE_DOMINOES_H

#include "system.h"

// rad/s: a domino of this thickness and height (m) that stands upright, and
// turns about one of its lower edges so fast, just gets over that edge, where
// gravity is g (m/s^2) and the domino's mass sits in its eight corners.
// All three > 0.
real domino_least_spin(real thickness, real height, real g);

// Adds n dominoes to a scene that has no bodies yet, of its shape `number`, a
// box of these sides (m): thickness along x, height along y.  They stand `above`
// (m) over the floor y = 0, one `gap` (m) behind the other, the first at
// x = z = 0 (its middle).  All are at rest but the first, which turns about its
// lower edge at +x with `spin` (rad/s), forwards if > 0.  Fails with the
// sentence of scene_add, and adds no more then.
status domino_row(scene *s, int number, vec3 sides, int n, real above, real gap,
                  real spin);

// rad, how far body b, a domino as above, leans from upright: 0 to pi.
real domino_lean(const particle_system *s, int b);

#endif
