// solution.c - a fan of triangles around corner 0.

#include "area.h"

// Triangles that look the other way, in a dent, take away what others have
// counted too much.
vec3 polygon_area(const vec3 *at, int n)
{
    vec3 twice = { 0, 0, 0 };
    for (int k = 1; k + 1 < n; k++) {
        vec3 u = vec3_sub(at[k], at[0]), v = vec3_sub(at[k + 1], at[0]);
        twice = vec3_add(twice, vec3_cross(u, v));
    }
    return vec3_scale(0.5, twice);
}

// As seen from corner 0, the middle of a triangle is (0 + u + v) / 3.
vec3 polygon_center(const vec3 *at, int n)
{
    vec3 area = polygon_area(at, n), sum = { 0, 0, 0 };
    real whole = 2 * vec3_length_squared(area);
    if (n < 1) return sum;
    for (int k = 1; k + 1 < n && whole > 0; k++) {
        vec3 u = vec3_sub(at[k], at[0]), v = vec3_sub(at[k + 1], at[0]);
        real part = vec3_dot(vec3_cross(u, v), area) / whole;
        sum = vec3_add_scaled(sum, part / 3, vec3_add(u, v));
    }
    for (int k = 1; k < n && !(whole > 0); k++)
        sum = vec3_add_scaled(sum, 1.0 / n, vec3_sub(at[k], at[0]));
    return vec3_add(at[0], sum);
}
