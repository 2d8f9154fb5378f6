// solution.c - line by line.

#include "clip.h"

static void put(polygon *p, vec3 x)
{
    if (p->count == CLIP_MOST) return;
    if (p->count > 0 && vec3_distance(p->at[p->count - 1], x) == 0) return;
    p->at[p->count++] = x;
}

// A corner on the line is kept, and an edge that ends there does not cross.
polygon clip_line(const polygon *p, vec3 a, vec3 b)
{
    polygon out = { .count = 0 };
    for (int i = 0; i < p->count; i++) {
        vec3 x = p->at[i], y = p->at[i + 1 < p->count ? i + 1 : 0];
        real s = vec3_cross(vec3_sub(b, a), vec3_sub(x, a)).z;
        real t = vec3_cross(vec3_sub(b, a), vec3_sub(y, a)).z;
        if (s >= 0) put(&out, x);
        if ((s > 0 && t < 0) || (s < 0 && t > 0))
            put(&out, vec3_add_scaled(x, s / (s - t), vec3_sub(y, x)));
    }
    while (out.count > 1
           && vec3_distance(out.at[out.count - 1], out.at[0]) == 0) out.count--;
    if (out.count < 3) out.count = 0;
    return out;
}

polygon clip_polygon(const polygon *p, const polygon *q)
{
    polygon rest = *p;
    if (q->count < 3) rest.count = 0;
    for (int j = 0; j < q->count; j++)
        rest = clip_line(&rest, q->at[j], q->at[j + 1 < q->count ? j + 1 : 0]);
    return rest;
}
