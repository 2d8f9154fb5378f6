// solution.c - along the line in the direction of the ray, and no further.

#include "ray.h"

// Between two planes across one axis the ray is from the time (low - x) / v to
// (high - x) / v, or the other way round.  A ray along the planes is between
// them always or never: nothing may be divided there, for 0 / 0 is no answer.
static int cut_slab(real low, real high, real x, real v, real *enter,
                    real *leave)
{
    if (v == 0) return x >= low && x <= high;
    real one = (low - x) / v, other = (high - x) / v;
    real in = v > 0 ? one : other, out = v > 0 ? other : one;
    if (!(in <= out)) return 0;
    if (in > *enter) *enter = in;
    if (out < *leave) *leave = out;
    return *enter <= *leave;
}

int ray_box(const crate *box, ray r, real *time)
{
    real enter = 0, leave = r.most;
    vec3 l = box->low, h = box->high, x = r.from, v = r.way;
    if (!(enter <= leave)) return 0;
    if (!cut_slab(l.x, h.x, x.x, v.x, &enter, &leave)) return 0;
    if (!cut_slab(l.y, h.y, x.y, v.y, &enter, &leave)) return 0;
    if (!cut_slab(l.z, h.z, x.z, v.z, &enter, &leave)) return 0;
    *time = enter;
    return 1;
}

void ray_reaches(const crate *box, int n, real *reach)
{
    for (int k = 0; k < n; k++) {
        reach[k] = box[k].high.x;
        if (k > 0 && !(reach[k] >= reach[k - 1])) reach[k] = reach[k - 1];
    }
}

// The first k with reach[k] >= x: nobody before it gets as far as x.
static int first_that_reaches(const real *reach, int n, real x)
{
    int low = 0, high = n;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (reach[middle] >= x) high = middle;
        else                    low = middle + 1;
    }
    return low;
}

// The first k with low.x > x: from there on everybody begins further right.
static int first_behind(const crate *box, int n, real x)
{
    int low = 0, high = n;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (box[middle].low.x > x) high = middle;
        else                       low = middle + 1;
    }
    return low;
}

// To the right: nobody counts who ends before the ray begins, or begins behind
// where it has met somebody.  To the left: nobody who begins right of the ray;
// and who, with all before him, ends left of where it has met somebody.
ray_hit ray_first(const crate *box, const real *reach, int n, ray r)
{
    ray_hit hit = { -1, r.most, 0 };
    int right = r.way.x >= 0, step = right ? 1 : -1;
    int k = right ? first_that_reaches(reach, n, r.from.x)
                  : first_behind(box, n, r.from.x) - 1;
    for (; k >= 0 && k < n; k += step) {
        // inf times 0 is no place.
        real end = r.way.x != 0 ? r.from.x + hit.time * r.way.x : r.from.x;
        if (right ? box[k].low.x > end : reach[k] < end) break;
        real time = hit.time;
        hit.looked++;
        if (!ray_box(&box[k], r, &time)) continue;
        if (hit.box >= 0 && !(time < hit.time || (time == hit.time && !right)))
            continue;
        hit.box = k;
        hit.time = time;
    }
    return hit;
}
