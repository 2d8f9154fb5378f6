// queries_jolt.cpp - Jolt's side of the program queries: its headers alone.

#include "queries.h"

#include <Jolt/Jolt.h>
#include <Jolt/Geometry/EPAPenetrationDepth.h>
#include <Jolt/Geometry/GJKClosestPoint.h>

using namespace JPH;

// Pair after pair, each as long as it is.
static Vec3 at[QUERY_PAIRS * 2 * QUERY_CORNERS];
static int count;

struct corners {
    typedef const Vec3 *const_iterator;
    const Vec3 *from;
    const Vec3 *begin() const { return from; }
    const Vec3 *end() const { return from + count; }
    const Vec3 &operator[](int i) const { return from[i]; }
};

static struct {
    Vec3 guess, next;
} kept[QUERY_PAIRS];

static Vec3 make(const double *x)
{
    return Vec3((float)x[0], (float)x[1], (float)x[2]);
}

static corners side_of(int k, int side)
{
    return corners{ at + (2 * k + side) * count };
}

static void place(int k, const query_pair *p)
{
    const double *from[2] = { p->a, p->b };
    count = p->corners;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < count; i++)
            at[(2 * k + side) * count + i] = make(from[side] + 3 * i);
}

void jolt_put(int k, const query_pair *p)
{
    place(k, p);
    kept[k].guess = kept[k].next = make(p->guess);
}

void jolt_move(int k, const query_pair *p)
{
    place(k, p);
    kept[k].guess = kept[k].next;
}

int jolt_overlap(int k)
{
    corners x = side_of(k, 0), y = side_of(k, 1);
    PolygonConvexSupport<corners> a(x), b(y);
    GJKClosestPoint gjk;
    return gjk.Intersects(a, b, 1e-4f, kept[k].guess);
}

void jolt_learn(int k)
{
    jolt_overlap(k);
    kept[k].next = kept[k].guess;
}

double jolt_depth(int k)
{
    corners x = side_of(k, 0), y = side_of(k, 1);
    PolygonConvexSupport<corners> a(x), b(y);
    EPAPenetrationDepth epa;
    Vec3 on_a, on_b, guess = kept[k].guess;
    if (!epa.GetPenetrationDepth(a, a, 0.0f, b, b, 0.0f, 1e-8f, 1e-4f,
                                 guess, on_a, on_b)) return 0;
    return (double)(on_a - on_b).Length();
}
