//> little_hull 04a 09z 11a
// --- GJK: how far apart are two convex bodies? ------------------------------

// The convex hull of some points.
typedef struct { const vec3 *at; int count; } hull;     // m

// A corner of the Minkowski difference A - B: vertex a of A less vertex b of B.
typedef struct { int a, b; vec3 at; } corner;

// Up to four corners, and the point v of their hull nearest to the origin.
typedef struct {
    int    count;
    corner of[4];
    real   weight[4];   // barycentric coordinates of v
    vec3   v;           // m, from B to A where they are nearest
} simplex;
//<

//> little_support 04a 09z 11a
// The vertex that lies furthest along d.
static int hull_furthest(hull h, vec3 d)
{
    int best = 0;
    for (int i = 1; i < h.count; i++)
        if (vec3_dot(h.at[i], d) > vec3_dot(h.at[best], d)) best = i;
    return best;
}

// The corner of A - B that lies furthest along d.
static corner hull_support(hull a, hull b, vec3 d)
{
    int i = hull_furthest(a, d), j = hull_furthest(b, vec3_scale(-1, d));
    return (corner){ i, j, vec3_sub(a.at[i], b.at[j]) };
}
//<

//> little_nearest_corners 04a 04a
// The distance of the two nearest vertices.
static real corner_distance(hull a, hull b, simplex *s)
{
    s->v = vec3_sub(a.at[0], b.at[0]);
    for (int i = 0; i < a.count; i++)
        for (int j = 0; j < b.count; j++) {
            vec3 v = vec3_sub(a.at[i], b.at[j]);
            if (vec3_length(v) < vec3_length(s->v)) s->v = v;
        }
    return vec3_length(s->v);
}
//<

//> little_segment 04b 09z 11a
// The simplex of the corners that have a part in v, their weighted mean.
static simplex simplex_of(int count, const corner *of, const real *weight)
{
    simplex s = { .count = 0 };
    for (int i = 0; i < count; i++) {
        if (weight[i] <= 0) continue;
        s.v = vec3_add_scaled(s.v, weight[i], of[i].at);
        s.weight[s.count] = weight[i];
        s.of[s.count++] = of[i];
    }
    return s;
}

// The point of a segment nearest to the origin.
static simplex segment_nearest(corner a, corner b)
{
    vec3 along = vec3_sub(b.at, a.at);
    real squared = vec3_dot(along, along);
    real t = squared > 0 ? -vec3_dot(a.at, along) / squared : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return simplex_of(2, (corner[]){ a, b }, (real[]){ 1 - t, t });
}
//<

//> little_crawl 04b 04b
static int rounds_used;         // of the last question

// From v to the nearest point on the way to the support along -v, and again.
static real crawl(hull a, hull b, simplex *s)
{
    corner at = hull_support(a, b, vec3_sub(b.at[0], a.at[0]));
    for (rounds_used = 0; rounds_used < 100; rounds_used++) {
        corner next = hull_support(a, b, vec3_scale(-1, at.at));
        if (vec3_dot(next.at, at.at) >= vec3_dot(at.at, at.at)) break;
        *s = segment_nearest(at, next);
        at.at = s->v;
    }
    s->v = at.at;
    return vec3_length(s->v);
}
//<

//> little_triangle 04c 09z 11a
static simplex simplex_nearer(simplex s, simplex t)
{
    return vec3_dot(s.v, s.v) <= vec3_dot(t.v, t.v) ? s : t;
}

// The point of a triangle nearest to the origin: inside it, or on an edge.
static simplex triangle_nearest(corner a, corner b, corner c)
{
    vec3 normal = vec3_cross(vec3_sub(b.at, a.at), vec3_sub(c.at, a.at));
    real wa = vec3_dot(normal, vec3_cross(b.at, c.at));
    real wb = vec3_dot(normal, vec3_cross(c.at, a.at));
    real wc = vec3_dot(normal, vec3_cross(a.at, b.at)), sum = wa + wb + wc;
    if (wa > 0 && wb > 0 && wc > 0)
        return simplex_of(3, (corner[]){ a, b, c },
                          (real[]){ wa / sum, wb / sum, wc / sum });
    return simplex_nearer(segment_nearest(a, b), simplex_nearer(
                          segment_nearest(b, c), segment_nearest(c, a)));
}
//<

//> little_four_triangles 04c 04c
// The nearest point of four corners, as if there was nothing inside.
static simplex tetrahedron_nearest(const corner *c)
{
    return simplex_nearer(
        simplex_nearer(triangle_nearest(c[0], c[1], c[2]),
                       triangle_nearest(c[0], c[1], c[3])),
        simplex_nearer(triangle_nearest(c[0], c[2], c[3]),
                       triangle_nearest(c[1], c[2], c[3])));
}
//<

//> little_tetrahedron 04d 09z 11a
// The point of a tetrahedron nearest to the origin.  If the origin is on the
// inner side of all four faces, all four corners stay, and v is zero.
static simplex tetrahedron_nearest(const corner *c)
{
    static const int face[4][4] = { { 0, 1, 2, 3 }, { 0, 3, 1, 2 },
                                    { 0, 2, 3, 1 }, { 1, 3, 2, 0 } };
    simplex best = { 4, { c[0], c[1], c[2], c[3] }, { 0 }, { 0, 0, 0 } };
    bool outside = false;
    for (int i = 0; i < 4; i++) {
        corner x = c[face[i][0]], y = c[face[i][1]], z = c[face[i][2]];
        vec3 normal = vec3_cross(vec3_sub(y.at, x.at), vec3_sub(z.at, x.at));
        real fourth = vec3_dot(normal, vec3_sub(c[face[i][3]].at, x.at));
        if (-vec3_dot(normal, x.at) * fourth > 0) continue;
        simplex s = triangle_nearest(x, y, z);
        best = outside ? simplex_nearer(best, s) : s;
        outside = true;
    }
    return best;
}
//<

//> little_simplex_nearest 04c 09z 11a
static simplex simplex_nearest(const simplex *s)
{
    switch (s->count) {
    case 1:  return simplex_of(1, s->of, (real[]){ 1 });
    case 2:  return segment_nearest(s->of[0], s->of[1]);
    case 3:  return triangle_nearest(s->of[0], s->of[1], s->of[2]);
    default: return tetrahedron_nearest(s->of);
    }
}
//<

//> little_gjk_has 04e 09z 11a
static bool simplex_has(const simplex *s, corner c)
{
    for (int i = 0; i < s->count; i++)
        if (s->of[i].a == c.a && s->of[i].b == c.b) return true;
    return false;
}
//<

//> little_gjk_rounds 04c 09z 11a
static int rounds_used;         // of the last question
//<

//> little_gjk_naive 04c 04d
// The distance of A and B (m).
static real gjk(hull a, hull b, simplex *s)
{
    s->count = 1;
    s->of[0] = hull_support(a, b, vec3_sub(b.at[0], a.at[0]));
    for (rounds_used = 0; rounds_used < 100; rounds_used++) {
        *s = simplex_nearest(s);
//<
//> little_gjk_inside 04d 04d
        if (s->count == 4) return 0;
//<
//> little_gjk_naive_end 04c 04d
        corner c = hull_support(a, b, vec3_scale(-1, s->v));
        if (vec3_dot(c.at, s->v) >= vec3_dot(s->v, s->v)) break;
        s->of[s->count++] = c;
    }
    return vec3_length(s->v);
}
//<

//> little_gjk 04e 09z 11a
// The distance of A and B (m), 0 if they overlap or are nearer than 1e-10 m.
// As soon as it is surely above `enough` (m), a lower bound will do.  The
// search begins with the corners of s, if it has any: an earlier answer's.
static real gjk(hull a, hull b, simplex *s, real enough)
{
    if (s->count == 0)
        s->of[s->count++] = hull_support(a, b, vec3_sub(b.at[0], a.at[0]));
    for (int i = 0; i < s->count; i++)
        s->of[i].at = vec3_sub(a.at[s->of[i].a], b.at[s->of[i].b]);
    for (rounds_used = 0; rounds_used < 100; rounds_used++) {
        *s = simplex_nearest(s);
        real squared = vec3_dot(s->v, s->v);
        if (s->count == 4 || squared < 1e-20) return 0;
        corner c = hull_support(a, b, vec3_scale(-1, s->v));
        real low = vec3_dot(c.at, s->v);
        if (low > enough * sqrt(squared)) return low / sqrt(squared);
        if (squared - low <= 1e-10 * squared || simplex_has(s, c)) break;
        s->of[s->count++] = c;
    }
    return vec3_length(s->v);
}
//<
