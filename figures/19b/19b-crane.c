// 19b-crane.c - the scene crane at three moments.
//   19b-crane FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 5, 20, 38 };    // s
    return strip_main(arguments, argument, "crane", MOMENT);
}
