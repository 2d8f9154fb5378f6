//> little_point 11a
// --- Contacts ----------------------------------------------------------------

// A point of a contact, on the surface of both bodies.
typedef struct {
    vec3 local_a, local_b;      // m, in the axes of each
//<
//> little_point_arms 13c
    vec3 ra, rb;                // m, arms from both centres, in the world
    real gap, mass;             // m; kg, the effective mass along the normal
    real push;                  // kg m/s, the impulse along the normal
    vec3 rub;                   // kg m/s, and across it
//<
//> little_point_closing 15c
    real closing;               // m/s before the step, < 0: nearer
    bool was_pushed;            // in the step
//<
//> little_manifold 11a
} contact_point;

enum { CLIPPED = 26 };
//<
//> little_points_all 11a 11b
enum { POINTS = CLIPPED };
//<
//> little_points_four 11c
enum { POINTS = 4 };
//<
//> little_contact_head 11a
typedef struct {
    body *a, *b;
    int  count;
    vec3 normal;                // unit, from b to a
    real reach;                 // m, gaps up to this are contacts
    contact_point point[POINTS];
//<
//> little_contact_friction 13c
    real friction;
//<
//> little_contact_until 14c
    real until;                 // m, of both paths: then it is asked again
//<
//> little_contact_next 13e
    int  next;                  // of the same a, in the step before
//<
//> little_contact_fresh 13g
    real fresh;                 // m, of both paths: then it is renewed
//<
//> little_contact_restitution 15c
    real restitution;
//<
//> little_contact_end 11a
} contact;

static const real MARGIN = 0.02;        // m

static void point_add(contact *c, vec3 on_a, vec3 on_b)
{
    if (c->count == POINTS) return;
    vec3 a = vec3_sub(on_a, c->a->position), b = vec3_sub(on_b, c->b->position);
    c->point[c->count++] = (contact_point){
        .local_a = mat3_back(c->a->axes, a),
        .local_b = mat3_back(c->b->axes, b) };
}
//<

//> little_clip 11b
// The side of a body that looks most along d, and the cosine between them.
static int body_side(const body *b, vec3 d, real *cosine)
{
    int best = 0;
    vec3 own = mat3_back(b->axes, d);
    *cosine = -1;
    for (int f = 0; f < b->shape->sides; f++) {
        real c = vec3_dot(b->shape->normal[f], own);
        if (c <= *cosine) continue;
        *cosine = c;
        best = f;
    }
    return best;
}

static int side_polygon(const body *b, int side, vec3 *p)
{
    int n = b->shape->corners[side];
    for (int i = 0; i < n; i++) p[i] = b->vertex[b->shape->side[side][i]];
    return n;
}

// Keeps what of a polygon is below a plane through `at` (Sutherland, Hodgman).
static int polygon_clip(vec3 *p, int n, vec3 at, vec3 out)
{
    vec3 kept[CLIPPED];
    int m = 0;
    for (int i = 0; i < n && m < CLIPPED - 1; i++) {
        vec3 x = p[i], y = p[(i + 1) % n];
        real a = vec3_dot(out, vec3_sub(x, at));
        real b = vec3_dot(out, vec3_sub(y, at));
        if (a <= 0) kept[m++] = x;
        if (a * b < 0)
            kept[m++] = vec3_add_scaled(x, a / (a - b), vec3_sub(y, x));
    }
    for (int i = 0; i < m; i++) p[i] = kept[i];
    return m;
}
//<

//> little_four_points 11c
// Which point shall be the k-th?  The deepest, the one furthest from it, the
// one furthest from their line, and the one furthest on its other side.
static real point_score(const vec3 *p, int k, int i, vec3 up)
{
    vec3 from = vec3_sub(p[i], p[0]);
    vec3 across = vec3_cross(up, vec3_sub(p[1], p[0]));
    if (k == 0) return -vec3_dot(up, p[i]);
    if (k == 1) return vec3_length(from);
    if (k == 2) return fabs(vec3_dot(across, from));
    bool left = vec3_dot(across, vec3_sub(p[2], p[0])) > 0;
    return left ? -vec3_dot(across, from) : vec3_dot(across, from);
}

static int points_four(vec3 *p, int n, vec3 up)
{
    for (int k = 0; k < 4 && n > 4; k++) {
        int best = k;
        for (int i = k; i < n; i++) {
            real score = point_score(p, k, i, up);
            if (score > point_score(p, k, best, up)) best = i;
        }
        vec3 swap = p[k];
        p[k] = p[best];
        p[best] = swap;
    }
    return n < 4 ? n : 4;
}
//<

//> little_clip_contact 11b
// Two sides that look at each other, within 6 degrees: the corners of one,
// clipped by the edges of the other, the reference side.
static bool contact_clip(contact *c)
{
    real cos_a, cos_b;
    vec3 side[SIDE_CORNERS], p[CLIPPED];
    int fa = body_side(c->a, vec3_scale(-1, c->normal), &cos_a);
    int fb = body_side(c->b, c->normal, &cos_b);
    if (cos_a < 0.995 && cos_b < 0.995) return false;
    bool by_b = cos_b > cos_a - 0.001;
    const body *reference = by_b ? c->b : c->a, *other = by_b ? c->a : c->b;
    int f = by_b ? fb : fa, corners = side_polygon(reference, f, side);
    int n = side_polygon(other, by_b ? fa : fb, p);
    vec3 up = mat3_apply(reference->axes, reference->shape->normal[f]);
    for (int i = 0; i < corners; i++) {
        vec3 edge = vec3_sub(side[(i + 1) % corners], side[i]);
        n = polygon_clip(p, n, side[i], vec3_cross(edge, up));
    }
    int m = 0;
    for (int i = 0; i < n; i++)
        if (vec3_dot(up, vec3_sub(p[i], side[0])) <= c->reach) p[m++] = p[i];
//<
//> little_clip_all 11b 11b
    n = m;
//<
//> little_clip_four 11c
    n = points_four(p, m, up);
//<
//> little_clip_points 11b
    for (int i = 0; i < n; i++) {
        real gap = vec3_dot(up, vec3_sub(p[i], side[0]));
        vec3 q = vec3_add_scaled(p[i], -gap, up);
        point_add(c, by_b ? p[i] : q, by_b ? q : p[i]);
    }
    if (n > 0) c->normal = vec3_scale(by_b ? 1 : -1, up);
    return n > 0;
}
//<

//> little_meet 11a
static vec3 simplex_on(const simplex *s, const vec3 *at, bool of_b)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < s->count; i++) {
        int vertex = of_b ? s->of[i].b : s->of[i].a;
        sum = vec3_add_scaled(sum, s->weight[i], at[vertex]);
    }
    return sum;
}

// Where do two bodies touch, or where will they soon?
static bool contact_meet(contact *c)
{
    hull a = body_hull(c->a), b = body_hull(c->b);
    simplex s = { .count = 0 };
    real d = gjk(a, b, &s, c->reach);
    c->count = 0;
//<
//> little_meet_until 14c
    real paths = c->a->path + c->b->path;
    c->until = paths + real_max(MARGIN / 10, d - MARGIN);
//<
//> little_meet_normal 11a
    if (d > c->reach) return false;
    if (d > 1e-7) c->normal = vec3_scale(1 / d, s.v);
    else {
        epa(a, b, &s);
        c->normal = s.v;
    }
    if (vec3_dot(c->normal, c->normal) < 0.5) return false;
//<
//> little_meet_friction 13c
    c->friction = sqrt(c->a->friction * c->b->friction);
//<
//> little_meet_restitution 15c
    c->restitution = real_max(c->a->restitution, c->b->restitution);
//<
//> little_meet_clip 11b 13b
    if (contact_clip(c)) return true;
//<
//> little_meet_clip_or_not 13c 13c
    bool one_point = true;      // first without the sides
    if (!one_point && contact_clip(c)) return true;
//<
//> little_meet_clip_again 13d
    if (contact_clip(c)) return true;
//<
//> little_meet_point 11a
    point_add(c, simplex_on(&s, a.at, false), simplex_on(&s, b.at, true));
    return true;
}
//<
