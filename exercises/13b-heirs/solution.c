// solution.c - the nearest pair first, and each impulse once.

#include "heirs.h"

// The nearest pair that is left, as 1 + HEIRS * new + old; 0 if there is none.
static int nearest_pair(const heir *now, int count, const bool *has,
                        const heir *old, int olds, const bool *spent, real near)
{
    int best = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < olds; k++) {
            real d = vec3_distance(now[i].at, old[k].at);
            if (has[i] || spent[k] || !(d < near)) continue;
            near = d;
            best = 1 + HEIRS * i + k;
        }
    return best;
}

int points_inherit(heir *now, int count, const heir *old, int olds, real near)
{
    bool has[HEIRS] = { false }, spent[HEIRS] = { false };
    int found = 0;
    for (int i = 0; i < count; i++) {
        now[i].push = 0;
        now[i].rub = vec3_make(0, 0, 0);
    }
    for (int round = 0; round < HEIRS; round++) {
        int pair = nearest_pair(now, count, has, old, olds, spent, near);
        if (!pair) break;
        int i = (pair - 1) / HEIRS, k = (pair - 1) % HEIRS;
        now[i].push = old[k].push;
        now[i].rub = old[k].rub;
        has[i] = spent[k] = true;
        found++;
    }
    return found;
}

vec3 rub_carried(vec3 rub, vec3 normal, real most)
{
    vec3 across = vec3_add_scaled(rub, -vec3_dot(rub, normal), normal);
    real length = vec3_length(across);
    return length > most ? vec3_scale(most / length, across) : across;
}
