// 19b-walker.c - the scene walker at three moments.
//   19b-walker FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 2, 4.5, 6.9 };    // s
    return strip_main(arguments, argument, "walker", MOMENT);
}
