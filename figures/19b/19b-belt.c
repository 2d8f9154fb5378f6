// 19b-belt.c - the scene belt at three moments.
//   19b-belt FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 2, 3.5, 6 };    // s
    return strip_main(arguments, argument, "belt", MOMENT);
}
