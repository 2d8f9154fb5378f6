// 19b-car.c - the scene car at three moments.
//   19b-car FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 0.9, 1.6, 2.2 };    // s
    return strip_main(arguments, argument, "car", MOMENT);
}
