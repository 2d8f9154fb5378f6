// 19b-cape.c - the scene cape at three moments, from beside the runner.
//   19b-cape FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 0.9, 2.2, 2.8 };    // s
    static const strip_camera BESIDE = { 0, { 3.2, 1.9, -2.2 }, { 0, 0.9, -0.3 } };
    return strip_along(arguments, argument, "cape", MOMENT, &BESIDE);
}
