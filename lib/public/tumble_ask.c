//> tumble-ask-shape
#include "inside.h"
#include "swept.h"

#include <math.h>

// What a question is about: the points within `round` of a convex hull that
// moves by `way`.  A ray is one point.
typedef struct {
    hull core;
    real round;         // m
    vec3 way;           // m
    vec3 center;        // m, and all of it is nearer than
    real radius;        // m
    unsigned mask;
} question;

static question ask_point(tumble_vec3 *at, tumble_vec3 to, unsigned mask)
{
    return (question){ .core = { (const vec3 *)at, 1 }, .mask = mask };
}
//<
