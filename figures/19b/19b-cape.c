// 19b-cape.c - the scene cape at three moments.
//   19b-cape FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 0.9, 2.2, 2.8 };    // s
    return strip_main(arguments, argument, "cape", MOMENT);
}
