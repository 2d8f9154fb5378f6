//> little_way_out 05a 05z
// How far A must go along a unit vector until it is out of B (m).
static real way_out(hull a, hull b, vec3 along)
{
    corner last = hull_support(a, b, vec3_scale(-1, along));
    return -vec3_dot(last.at, along);
}
//<

//> little_between_middles 05a 05a
static vec3 hull_middle(hull h)
{
    vec3 middle = { 0, 0, 0 };
    for (int i = 0; i < h.count; i++)
        middle = vec3_add_scaled(middle, 1.0 / h.count, h.at[i]);
    return middle;
}

// From middle to middle: the depth (m), and the way out of A as s->v.
static real middles_apart(hull a, hull b, simplex *s)
{
    s->v = vec3_unit(vec3_sub(hull_middle(a), hull_middle(b)));
    return way_out(a, b, s->v);
}
//<

//> little_polytope 05b 09z 11a
// --- EPA: how deep are they in each other? ----------------------------------

typedef struct {
    int  corner[3];     // counter-clockwise from outside
    vec3 normal;        // unit, outwards
    real distance;      // m, of its plane from the origin
} face;

enum { CORNERS = 150, FACES = 2 * CORNERS };

// A closed surface of corners of A - B.
typedef struct {
    corner corner[CORNERS];
    face   face[FACES];
    int corners, faces;
} polytope;
//<

//> little_span 05b 09z 11a
// Adds corners to s until it is a tetrahedron; false if A - B is flat.
static bool simplex_span(simplex *s, hull a, hull b)
{
    static const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int tried = 0; tried < 6 && s->count < 4; tried++) {
        vec3 d = axis[tried / 2];
        vec3 edge = vec3_sub(s->of[1].at, s->of[0].at);
        if (s->count == 2) d = vec3_cross(edge, d);
        if (s->count == 3)
            d = vec3_cross(edge, vec3_sub(s->of[2].at, s->of[0].at));
        d = vec3_scale(tried % 2 ? -1 : 1, vec3_unit(d));
        corner c = hull_support(a, b, d);
        if (fabs(vec3_dot(vec3_sub(c.at, s->of[0].at), d)) < 1e-9) continue;
        s->of[s->count++] = c;
        tried = -1;
    }
    return s->count == 4;
}
//<

//> little_face 05b 09z 11a
// Adds the face with these corners; false if it has no area, or no room.
static bool face_add(polytope *p, int i, int j, int k)
{
    if (p->faces == FACES) return false;
    vec3 at = p->corner[i].at;
    vec3 normal = vec3_cross(vec3_sub(p->corner[j].at, at),
                             vec3_sub(p->corner[k].at, at));
    real twice_area = vec3_length(normal);
    if (twice_area < 1e-18) return false;
    normal = vec3_scale(1 / twice_area, normal);
    p->face[p->faces++] = (face){ { i, j, k }, normal, vec3_dot(at, normal) };
    return true;
}

// The tetrahedron with which EPA begins.
static bool polytope_begin(polytope *p, const simplex *s)
{
    vec3 x = vec3_sub(s->of[1].at, s->of[0].at);
    vec3 y = vec3_sub(s->of[2].at, s->of[0].at);
    vec3 z = vec3_sub(s->of[3].at, s->of[0].at);
    bool turned = vec3_dot(vec3_cross(x, y), z) > 0;
    for (int i = 0; i < 4; i++) p->corner[i] = s->of[i];
    if (turned) p->corner[1] = s->of[2], p->corner[2] = s->of[1];
    p->corners = 4;
    p->faces = 0;
    return face_add(p, 0, 1, 2) && face_add(p, 0, 3, 1)
        && face_add(p, 0, 2, 3) && face_add(p, 1, 3, 2);
}

static const face *face_nearest(const polytope *p)
{
    const face *best = &p->face[0];
    for (int i = 1; i < p->faces; i++)
        if (p->face[i].distance < best->distance) best = &p->face[i];
    return best;
}
//<

//> little_grow 05c 09z 11a
static bool face_sees(const face *f, corner c)
{
    return vec3_dot(f->normal, c.at) - f->distance > 1e-12;
}

// Does a face that sees c have this edge?
static bool edge_sees(const polytope *p, corner c, int from, int to)
{
    for (int i = 0; i < p->faces; i++)
        for (int k = 0; k < 3 && face_sees(&p->face[i], c); k++)
            if (p->face[i].corner[k] == from
                && p->face[i].corner[(k + 1) % 3] == to) return true;
    return false;
}

// Cuts away the faces that see c, and joins c to the rim of the hole: to the
// edges whose other side stays.
static bool polytope_grow(polytope *p, corner c)
{
    const polytope old = *p;
    p->faces = 0;
    p->corner[p->corners++] = c;
    for (int i = 0; i < old.faces; i++) {
        if (!face_sees(&old.face[i], c)) p->face[p->faces++] = old.face[i];
        for (int k = 0; k < 3 && face_sees(&old.face[i], c); k++) {
            int from = old.face[i].corner[k];
            int to = old.face[i].corner[(k + 1) % 3];
            if (!edge_sees(&old, c, to, from)
                && !face_add(p, from, to, old.corners)) return false;
        }
    }
    return true;
}
//<

//> little_epa_head 05b 09z 11a
// The depth of A in B (m): the least way out, and s->v, the unit vector along
// it.  s has the corners with which gjk ended.
static real epa(hull a, hull b, simplex *s)
{
    polytope p;
    if (!simplex_span(s, a, b) || !polytope_begin(&p, s)) return 0;
    face best = *face_nearest(&p);
//<
//> little_epa_loop 05c 09z 11a
    while (p.corners < CORNERS) {
        corner c = hull_support(a, b, best.normal);
        if (vec3_dot(c.at, best.normal) - best.distance < 1e-9) break;
        if (!polytope_grow(&p, c)) break;
        best = *face_nearest(&p);
    }
//<
//> little_epa_weights 07a 09z 11a
    *s = triangle_nearest(p.corner[best.corner[0]], p.corner[best.corner[1]],
                          p.corner[best.corner[2]]);
//<
//> little_epa_end 05b 09z 11a
    s->v = vec3_scale(-1, best.normal);
    return real_max(best.distance, 0);
}
//<
