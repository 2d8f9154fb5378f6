// solution.c - Welzl's lemma in the plane.

#include "circle.h"

// Points on one circle may chase each other by rounding.
enum { PASSES_MAX = 60 };
static const real OUTSIDE = 1 + 1e-14;

// Up to three points that make a circle, and one more that is let in.
typedef struct {
    point at[4];
    int count;
    point center;
    real reach2;        // squared distance to the farthest of them
} trial;

static real distance2(point a, point b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// The squared distance of the farthest of n points; which one, in *far.
static real reach2(point center, const point *at, int n, int *far)
{
    real most = -1;
    for (int i = 0; i < n; i++) {
        real d2 = distance2(at[i], center);
        if (d2 > most) {
            most = d2;
            *far = i;
        }
    }
    return most;
}

static point middle(point a, point b)
{
    return (point){ a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2 };
}

// As far from a as from b and c: with p = b - a, q = c - a, seen from a,
//     center . p = p . p / 2,   center . q = q . q / 2.
// 0 if the three lie in a line.
static int through(point a, point b, point c, point *center)
{
    point p = { b.x - a.x, b.y - a.y }, q = { c.x - a.x, c.y - a.y };
    real D = 2 * (p.x * q.y - p.y * q.x);
    real pp = p.x * p.x + p.y * p.y, qq = q.x * q.x + q.y * q.y;
    if (D == 0) return 0;
    center->x = a.x + (pp * q.y - qq * p.y) / D;
    center->y = a.y + (qq * p.x - pp * q.x) / D;
    return 1;
}

// The smallest circle around the supports of t and `last`, on which `last`
// lies: with each one and each two of them.
static trial let_in(trial t, point last)
{
    trial best = t;
    int far;
    best.reach2 = (real)INFINITY;
    t.at[t.count] = last;
    for (int i = 0; i < t.count; i++)
        for (int j = i; j < t.count; j++) {
            point center = middle(last, t.at[i]);
            if (j > i && !through(last, t.at[i], t.at[j], &center)) continue;
            real d2 = reach2(center, t.at, t.count + 1, &far);
            if (d2 < best.reach2)
                best = (trial){ { last, t.at[i], t.at[j] }, j > i ? 3 : 2,
                                center, d2 };
        }
    return best;
}

circle smallest_circle(const point *at, int n)
{
    if (n == 0) return (circle){ .radius = -1 };
    for (int i = 0; i < n; i++)
        if (!(at[i].x - at[i].x == 0) || !(at[i].y - at[i].y == 0))
            return (circle){ { (real)NAN, (real)NAN }, (real)NAN };

    trial t = { { at[0] }, 1, at[0], 0 };
    circle best = { at[0], (real)INFINITY };
    for (int pass = 0; pass < PASSES_MAX; pass++) {
        int far = 0;
        real far2 = reach2(t.center, at, n, &far);
        if (sqrt(far2) < best.radius) best = (circle){ t.center, sqrt(far2) };
        if (far2 <= t.reach2 * OUTSIDE) break;
        t = let_in(t, at[far]);
    }
    return best;
}
