// solution.c - colours spread in rings, and odd rings close.

#include "colours.h"

// From particle v on, through its piece, ring by ring.  A particle is one
// deeper than its parent, from whom it has its colour.
static void spread(const stick *s, int sticks, int v, int *colour, int *parent,
                   int *depth)
{
    colour[v] = RED;
    parent[v] = v;
    depth[v] = 0;
    int found = 1;
    for (int ring = 0; found; ring++) {
        found = 0;
        for (int k = 0; k < sticks; k++) {
            int from = s[k].a, to = s[k].b;
            if (colour[from] < 0) { from = s[k].b; to = s[k].a; }
            if (colour[from] < 0 || colour[to] >= 0) continue;
            if (depth[from] != ring) continue;
            colour[to] = RED + BLACK - colour[from];
            parent[to] = from;
            depth[to] = ring + 1;
            found = 1;
        }
    }
}

// The stick a, b joins two of one colour.  Their depths are both even or both
// odd, and the ends of a stick are at most one apart: so they are equal, and
// both ways up to the first common ancestor are as long.  Up, down and across:
// an odd number.
static int ring_close(int a, int b, const int *parent, int *ring)
{
    int up = 0;
    for (int x = a, y = b; x != y; x = parent[x], y = parent[y]) up++;
    int count = 2 * up + 1;
    for (int i = 0; i < up; i++) {
        ring[i] = a;
        ring[count - 1 - i] = b;
        a = parent[a];
        b = parent[b];
    }
    ring[up] = a;
    return count;
}

int two_colours(const stick *s, int sticks, int particles, int *colour,
                int *ring, int *scratch)
{
    int *parent = scratch, *depth = scratch + particles;
    for (int i = 0; i < particles; i++) colour[i] = -1;
    for (int i = 0; i < particles; i++)
        if (colour[i] < 0) spread(s, sticks, i, colour, parent, depth);
    for (int k = 0; k < sticks; k++)
        if (colour[s[k].a] == colour[s[k].b])
            return ring_close(s[k].a, s[k].b, parent, ring);
    return 0;
}
