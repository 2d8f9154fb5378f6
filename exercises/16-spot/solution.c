// solution.c - a push at a mean of particles, shared by their weights.

#include "spot.h"

vec3 spot_position(const particle *p, const spot *s)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < s->count; i++)
        sum = vec3_add_scaled(sum, s->weight[i], p[s->at[i]].position);
    return sum;
}

// m, that it has moved in this step.
static vec3 spot_moved(const particle *p, const spot *s)
{
    vec3 sum = spot_position(p, s);
    for (int i = 0; i < s->count; i++)
        sum = vec3_add_scaled(sum, -s->weight[i], p[s->at[i]].previous);
    return sum;
}

real spot_answer(const particle *p, const spot *s)
{
    real sum = 0;
    for (int i = 0; i < s->count; i++)
        sum += p[s->at[i]].inverse_mass * s->weight[i] * s->weight[i];
    return sum;
}

static void spot_shift(particle *p, const spot *s, real size, vec3 by)
{
    for (int i = 0; i < s->count; i++) {
        particle *q = &p[s->at[i]];
        real share = size * s->weight[i] * q->inverse_mass;
        q->position = vec3_add_scaled(q->position, share, by);
    }
}

// The least move, less what friction holds.
void spots_part(particle *p, const spot *a, const spot *b, vec3 normal,
                real apart, real friction)
{
    vec3 way = vec3_sub(spot_position(p, a), spot_position(p, b));
    real missing = apart - vec3_dot(way, normal);
    real answer = spot_answer(p, a) + spot_answer(p, b);
    if (!(missing > 0) || answer == 0) return;
    vec3 slide = vec3_sub(spot_moved(p, a), spot_moved(p, b));
    slide = vec3_add_scaled(slide, -vec3_dot(slide, normal), normal);
    real length = vec3_length(slide), most = friction * missing;
    if (length > most) slide = vec3_scale(most / length, slide);
    vec3 by = vec3_sub(vec3_scale(missing, normal), slide);
    spot_shift(p, a, 1 / answer, by);
    spot_shift(p, b, -1 / answer, by);
}
