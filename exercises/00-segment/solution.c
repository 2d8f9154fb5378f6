// solution.c - one dot product, three questions.

#include "segment.h"

// The projection of p on the line is a + t d; the segment ends at t = 0 and 1.
vec3 segment_nearest(vec3 a, vec3 b, vec3 p)
{
    vec3 d = vec3_sub(b, a);
    real square = vec3_length_squared(d);
    if (square == 0) return a;
    real t = vec3_dot(vec3_sub(p, a), d) / square;
    return vec3_add_scaled(a, real_max(0, real_min(t, 1)), d);
}

real plane_height(vec3 at, vec3 normal, vec3 p)
{
    return vec3_dot(vec3_sub(p, at), vec3_unit(normal));
}

vec3 plane_mirror(vec3 at, vec3 normal, vec3 p)
{
    real height = plane_height(at, normal, p);
    return vec3_add_scaled(p, -2 * height, vec3_unit(normal));
}
