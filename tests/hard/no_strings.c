// no_strings.c - `drape` in which no strand is stepped as a string, however taut
// it is: the links alone do it.  See chapters 12 and 16.
//
// The linker puts this in the place of the library's (--wrap).

#include "taut.h"

#include <math.h>

real __wrap_taut_most(real inverse_mass, int directions);

real __wrap_taut_most(real inverse_mass, int directions)
{
    (void)inverse_mass;
    (void)directions;
    return HUGE_VAL;
}
