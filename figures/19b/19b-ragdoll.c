// 19b-ragdoll.c - the scene ragdoll at three moments.
//   19b-ragdoll FILE.png

#include "strip.h"

int main(int arguments, char **argument)
{
    static const double MOMENT[STRIP_PICTURES] = { 0.4, 1, 2 };    // s
    return strip_main(arguments, argument, "ragdoll", MOMENT);
}
