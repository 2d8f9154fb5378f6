//> oracle-vectors
// oracle.c - see oracle.h.

#include "oracle.h"

typedef long double wide;
typedef struct { wide x, y, z; } vec;

static const wide endless = (wide)HUGE_VAL;

// A double fits into a long double whole: nothing is rounded.
static vec widened(vec3 a)
{
    return (vec){ (wide)a.x, (wide)a.y, (wide)a.z };
}

static vec point(hull p, int i) { return widened(p.at[i]); }

static vec minus(vec a, vec b) { return (vec){ a.x-b.x, a.y-b.y, a.z-b.z }; }
static vec times(wide t, vec a) { return (vec){ t*a.x, t*a.y, t*a.z }; }
static wide dot(vec a, vec b) { return a.x*b.x + a.y*b.y + a.z*b.z; }

static vec cross(vec a, vec b)
{
    return (vec){ a.y*b.z - a.z*b.y, a.z*b.x - a.x*b.z, a.x*b.y - a.y*b.x };
}

static wide lesser(wide s, wide t) { return s < t ? s : t; }
static wide clamp(wide t) { return t < 0 ? 0 : t > 1 ? 1 : t; }
//<

//> oracle-vertex-edge
//>   The arithmetic is in `long double`. A point and a segment are the first
//>   pair.
// Squared distance of p from the segment a, b (which may be one point).
static wide vertex_edge(vec p, vec a, vec b)
{
    vec e = minus(b, a), g = minus(p, a);
    wide ee = dot(e, e), t = ee > 0 ? clamp(dot(g, e) / ee) : 0;
    vec d = minus(g, times(t, e));
    return dot(d, d);
}
//<

//> oracle-edge-edge
// Squared distance of two segments: of an end from the other segment, or of the
// point a + s e where the two lines are nearest.  That point is measured like
// any other: an s that rounding has spoilt, because the segments are nearly
// parallel, may give too much, and never too little.
static wide edge_edge(vec a, vec b, vec c, vec d)
{
    vec e = minus(b, a), f = minus(d, c), g = minus(c, a), n = cross(e, f);
    wide nn = dot(n, n), s = nn > 0 ? clamp(dot(cross(g, f), n) / nn) : 0;
    wide ends = lesser(lesser(vertex_edge(a, c, d), vertex_edge(b, c, d)),
                       lesser(vertex_edge(c, a, b), vertex_edge(d, a, b)));
    // All from a, so that bodies far from the origin lose nothing.
    return lesser(ends, vertex_edge(times(s, e), g, minus(d, a)));
}
//<

//> oracle-vertex-face
// Squared distance of p from the triangle a, b, c, if the foot of p on its
// plane, a + u e + v f, lies inside.  If not, an edge is nearer.
static wide vertex_face(vec p, vec a, vec b, vec c)
{
    vec e = minus(b, a), f = minus(c, a), g = minus(p, a), n = cross(e, f);
    wide nn = dot(n, n);
    if (!(nn > 0)) return endless;          // a segment: tried as one
    wide u = dot(cross(g, f), n) / nn, v = dot(cross(e, g), n) / nn;
    if (u < 0 || v < 0 || u + v > 1) return endless;
    vec d = minus(minus(g, times(u, e)), times(v, f));
    return dot(d, d);
}
//<

//> oracle-distance
//>   The distance is the least over all of them.
// The vertices of b against all triangles that the points of a span.
static wide vertices_faces(hull b, hull a)
{
    wide best = endless;
    for (int i = 0; i < a.count; i++)
        for (int j = i + 1; j < a.count; j++)
            for (int k = j + 1; k < a.count; k++)
                for (int v = 0; v < b.count; v++)
                    best = lesser(best, vertex_face(point(b, v), point(a, i),
                                                    point(a, j), point(a, k)));
    return best;
}

// All segments of a against all of b.  One of no length, i == j, is a point.
static wide edges_edges(hull a, hull b)
{
    wide best = endless;
    for (int i = 0; i < a.count; i++)
        for (int j = i; j < a.count; j++)
            for (int k = 0; k < b.count; k++)
                for (int l = k; l < b.count; l++)
                    best = lesser(best, edge_edge(point(a, i), point(a, j),
                                                  point(b, k), point(b, l)));
    return best;
}

long double oracle_distance(hull a, hull b)
{
    wide faces = lesser(vertices_faces(a, b), vertices_faces(b, a));
    return sqrtl(lesser(faces, edges_edges(a, b)));
}
//<

//> oracle-width
// How far p reaches along n, measured from the point `from`.
static wide reach(hull p, vec from, vec n)
{
    wide most = -endless;
    for (int i = 0; i < p.count; i++) {
        wide here = dot(n, minus(point(p, i), from));
        if (here > most) most = here;
    }
    return most;
}

// How far A - B reaches along n: A's furthest along n, less B's least, which is
// B's furthest the other way.  A direction of no length
// tells nothing.
static wide width(hull a, hull b, vec n)
{
    wide length = sqrtl(dot(n, n));
    if (!(length > 0)) return endless;
    vec from = point(a, 0);
    return (reach(a, from, n) + reach(b, from, times(-1, n))) / length;
}

long double oracle_width(hull a, hull b, vec3 n)
{
    return width(a, b, widened(n));
}
//<

//> oracle-depth
// A direction is tried both ways.
static wide width_both(hull a, hull b, vec n)
{
    return lesser(width(a, b, n), width(a, b, times(-1, n)));
}

// Over the normals of all triangles that the points of p span.
static wide width_faces(hull a, hull b, hull p)
{
    wide best = endless;
    for (int i = 0; i < p.count; i++)
        for (int j = i + 1; j < p.count; j++)
            for (int k = j + 1; k < p.count; k++) {
                vec e = minus(point(p, j), point(p, i));
                vec f = minus(point(p, k), point(p, i));
                best = lesser(best, width_both(a, b, cross(e, f)));
            }
    return best;
}

// Over all that is perpendicular to a segment of a and to one of b.
static wide width_edges(hull a, hull b)
{
    wide best = endless;
    for (int i = 0; i < a.count; i++)
        for (int j = i + 1; j < a.count; j++)
            for (int k = 0; k < b.count; k++)
                for (int l = k + 1; l < b.count; l++) {
                    vec e = minus(point(a, j), point(a, i));
                    vec f = minus(point(b, l), point(b, k));
                    best = lesser(best, width_both(a, b, cross(e, f)));
                }
    return best;
}

long double oracle_depth(hull a, hull b)
{
    wide faces = lesser(width_faces(a, b, a), width_faces(a, b, b));
    return lesser(faces, width_edges(a, b));
}
//<
