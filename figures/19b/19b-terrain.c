// 19b-terrain.c - the scene terrain at three moments.
//   19b-terrain FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 3, 6, 9 };    // s
    return strip_main(arguments, argument, "terrain", MOMENT);
}
