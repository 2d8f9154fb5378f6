// 19b-car.c - the scene car at three moments, from beside it.
//   19b-car FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 0.3, 1.95, 2.3 };   // s
    static const strip_camera BESIDE = { 0, { 1, 1.6, 7.5 }, { 0, 0.5, 0 } };
    return strip_along(arguments, argument, "car", MOMENT, &BESIDE);
}
