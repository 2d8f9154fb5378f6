// solution.c - pair by pair, until no ball runs into another.

#include "cradle.h"

// m, by how much more ball i has moved than ball i + 1: the way that they have
// come nearer, were they not touching.
static real approach(const particle *p, int i)
{
    return (p[i].position.x - p[i].previous.x)
         - (p[i + 1].position.x - p[i + 1].previous.x);
}

// m, the longest way of all.
static real fastest(const particle *p, int n)
{
    real most = 0;
    for (int i = 0; i < n; i++) {
        real way = fabs(p[i].position.x - p[i].previous.x);
        if (way > most) most = way;
    }
    return most;
}

// An impulse J slows the left one by w J and speeds the right one by w' J:
// momentum stays.  u = v - v' becomes u - (w + w') J, and that shall be -e u.
// (Ways in one step stand for speeds.)
static void bounce(particle *p, int i, real restitution, real weight)
{
    real push = (1 + restitution) * approach(p, i) / weight;
    p[i].previous.x += p[i].inverse_mass * push;
    p[i + 1].previous.x -= p[i + 1].inverse_mass * push;
}

int cradle_bounce(particle *p, int n, real restitution, int cap)
{
    int bounces = 0, found = 1;
    real least = 1e-12 * fastest(p, n);
    while (found) {
        found = 0;
        for (int i = 0; i + 1 < n; i++) {
            real weight = p[i].inverse_mass + p[i + 1].inverse_mass;
            if (!(approach(p, i) > least) || !(weight > 0)) continue;
            if (bounces == cap) return bounces;
            bounce(p, i, restitution, weight);
            bounces++;
            found = 1;
        }
    }
    return bounces;
}
