// solution.c - once for the mean, once for the squares.

#include "axis.h"

// Squares of what is left when the mean is gone: far from the origin x^2 has no
// digits left for it.
void axis_spreads(const vec3 *at, int n, real spread[3])
{
    vec3 mean = { 0, 0, 0 }, sum = { 0, 0, 0 };
    int count = 0;
    for (int i = 0; i < n; i++) {
        if (!vec3_is_finite(at[i])) continue;
        mean = vec3_add(mean, at[i]);
        count++;
    }
    if (count > 0) mean = vec3_scale(1.0 / count, mean);
    for (int i = 0; i < n; i++) {
        if (!vec3_is_finite(at[i])) continue;
        vec3 d = vec3_sub(at[i], mean);
        sum = vec3_add(sum, vec3_make(d.x * d.x, d.y * d.y, d.z * d.z));
    }
    spread[0] = count > 0 ? sum.x / count : 0;
    spread[1] = count > 0 ? sum.y / count : 0;
    spread[2] = count > 0 ? sum.z / count : 0;
}

int axis_widest(const vec3 *at, int n, int before)
{
    real spread[3];
    int best = 0;
    axis_spreads(at, n, spread);
    for (int k = 1; k < 3; k++)
        if (spread[k] > spread[best]) best = k;
    if (before < 0) return best;
    return spread[best] > STUBBORN * STUBBORN * spread[before] ? best : before;
}
