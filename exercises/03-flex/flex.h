// flex.h - the ways in which sticks let a body fold.

#ifndef TUMBLE_FLEX_H
#define TUMBLE_FLEX_H

#include "body.h"

// How many independent flexes have n particles at `at` (m) with these sticks:
// velocities that change no stick's length and have neither momentum nor
// angular momentum, all masses equal.  Writes one of them to flex[0 .. n-1], of
// length 1 in all, or zeros if there is none.  -1, and flex is left alone, if
// memory is refused.
int flex_find(const vec3 *at, int n, const stick *s, int sticks, vec3 *flex);

#endif
