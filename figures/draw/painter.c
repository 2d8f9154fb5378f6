// painter.c - triangles, a z-buffer, many small lamps.

#include "painter.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static const real PI = 3.14159265358979323846;

// The angle that spreads the points of a spiral evenly (the golden one).
static const real GOLDEN_ANGLE = 2.39996322972865332;

enum { SHIFTS = 9 };            // pictures in a painting: 3 x 3

// ---- The scene -------------------------------------------------------------

void painter_init(painter *p)
{
    bool dark = picture_is_dark();
    *p = (painter){ 0 };
    p->floor = colour_hex(dark ? 0x3d4148 : 0xf1eee9);
    p->haze = colour_hex(dark ? 0x23262b : 0xf7f6f4);
    p->sky = colour_hex(dark ? 0x1d2025 : 0xe9eef5);
    // Whiter than white, for the light that walls throw at each other.
    p->wall = vec3_scale(1.12, colour_hex(dark ? 0x33373d : 0xfdfaf6));
    p->lamp = vec3_unit(vec3_make(-0.45, 1, 0.5));
    p->lamp_size = 0.13;
    p->lamps = 6;
    painter_look(p, vec3_make(0, 1, 5), vec3_make(0, 1, 0), 35);
}

void painter_free(painter *p)
{
    free(p->triangle);
    *p = (painter){ 0 };
}

void painter_clear(painter *p)
{
    p->count = 0;
}

void painter_look(painter *p, vec3 eye, vec3 target, real degrees)
{
    p->eye = eye;
    p->forward = vec3_unit(vec3_sub(target, eye));
    p->right = vec3_unit(vec3_cross(p->forward, vec3_make(0, 1, 0)));
    assert(vec3_length_squared(p->right) > 0);
    p->up = vec3_cross(p->right, p->forward);
    p->focal = 0.5 / tan(degrees * PI / 360);
}

void painter_floor(painter *p, vec3 centre, real radius, real tile)
{
    p->has_floor = 1;
    p->floor_centre = centre;
    p->floor_radius = radius;
    p->tile = tile;
}

static status painter_reserve(painter *p, int more)
{
    if (more <= p->capacity - p->count) return status_ok();
    size_t capacity = 2 * ((size_t)p->count + (size_t)more);
    painted_triangle *t = NULL;
    if (capacity < 1u << 30) t = realloc(p->triangle, capacity * sizeof *t);
    if (!t) return status_out_of_memory();
    p->triangle = t;
    p->capacity = (int)capacity;
    return status_ok();
}

// ---- Meshes ----------------------------------------------------------------

// Normals of the vertices: the sum of the cross products around, so that a
// large face counts for more than a sliver.
static void smooth_normals(const painted_mesh *m, vec3 *normal)
{
    for (int v = 0; v < m->vertices; v++) normal[v] = vec3_make(0, 0, 0);
    for (int f = 0; f < m->faces; f++) {
        const int *v = &m->face[3 * f];
        vec3 n = vec3_cross(vec3_sub(m->at[v[1]], m->at[v[0]]),
                            vec3_sub(m->at[v[2]], m->at[v[0]]));
        for (int k = 0; k < 3; k++) normal[v[k]] = vec3_add(normal[v[k]], n);
    }
    for (int v = 0; v < m->vertices; v++) normal[v] = vec3_unit(normal[v]);
}

// An edge of a face: its ends in rising order, and whose it is.
typedef struct {
    int low, high, face, corner;
} face_edge;

static int face_edge_compare(const void *a, const void *b)
{
    const face_edge *e = a, *f = b;
    if (e->low != f->low) return e->low < f->low ? -1 : 1;
    if (e->high != f->high) return e->high < f->high ? -1 : 1;
    return e->face < f->face ? -1 : e->face > f->face;
}

// Gives a light rim to every edge where two faces bend by more than 10 degrees.
static status find_creases(const painted_mesh *m, painted_triangle *t)
{
    const real cosine = 0.985, share = 0.022;
    int n = 3 * m->faces;
    face_edge *edge = malloc((size_t)n * sizeof *edge);
    if (!edge) return status_out_of_memory();
    for (int i = 0; i < n; i++) {
        int f = i / 3, k = i % 3;
        int a = m->face[3 * f + (k + 1) % 3], b = m->face[3 * f + (k + 2) % 3];
        edge[i] = (face_edge){ a < b ? a : b, a < b ? b : a, f, k };
    }
    qsort(edge, (size_t)n, sizeof *edge, face_edge_compare);
    for (int i = 0; i + 1 < n; i++) {
        face_edge e = edge[i], g = edge[i + 1];
        if (e.low != g.low || e.high != g.high) continue;
        if (vec3_dot(t[e.face].normal[0], t[g.face].normal[0]) > cosine)
            continue;
        real width = share * vec3_distance(m->at[e.low], m->at[e.high]);
        t[e.face].crease[e.corner] = width;
        t[g.face].crease[g.corner] = width;
    }
    free(edge);
    return status_ok();
}

static painted_triangle triangle_of(const painted_mesh *m, int f,
                                    const vec3 *normal)
{
    const int *v = &m->face[3 * f];
    real t = m->tint ? m->tint[f] : 0;
    painted_triangle out = { .front = colour_mix(m->front[0], m->front[1], t),
                             .back = colour_mix(m->back[0], m->back[1], t),
                             .gloss = m->gloss, .lit = 1, .casts = m->casts,
                             .see_through = m->see_through };
    for (int k = 0; k < 3; k++) out.corner[k] = m->at[v[k]];
    vec3 flat = vec3_unit(vec3_cross(vec3_sub(out.corner[1], out.corner[0]),
                                     vec3_sub(out.corner[2], out.corner[0])));
    for (int k = 0; k < 3; k++) out.normal[k] = normal ? normal[v[k]] : flat;
    return out;
}

// Is it within 1000 km of the origin?  (NaN is not.)
static int can_be_painted(const painted_triangle *t)
{
    const real far = 1e6;
    for (int k = 0; k < 3; k++)
        if (!(vec3_length(t->corner[k]) < far)) return 0;
    return 1;
}

status painter_mesh(painter *p, const painted_mesh *m)
{
    status s = painter_reserve(p, m->faces);
    if (!s.ok || m->faces == 0) return s;
    vec3 *normal = NULL;
    if (m->smooth) {
        normal = malloc((size_t)m->vertices * sizeof *normal);
        if (!normal) return status_out_of_memory();
        smooth_normals(m, normal);
    }
    painted_triangle *t = &p->triangle[p->count];
    for (int f = 0; f < m->faces; f++) t[f] = triangle_of(m, f, normal);
    free(normal);
    if (m->creases) s = find_creases(m, t);
    if (s.ok) p->count += m->faces;
    return s;
}

status painter_line(painter *p, vec3 a, vec3 b, real width, colour c)
{
    status s = painter_reserve(p, 2);
    if (!s.ok) return s;
    vec3 side = vec3_unit(vec3_cross(vec3_sub(b, a), vec3_sub(p->eye, a)));
    real wide_a = 0.5 * width * vec3_distance(p->eye, a) / p->focal;
    real wide_b = 0.5 * width * vec3_distance(p->eye, b) / p->focal;
    vec3 q[4] = { vec3_add_scaled(a, -wide_a, side),
                  vec3_add_scaled(a, wide_a, side),
                  vec3_add_scaled(b, wide_b, side),
                  vec3_add_scaled(b, -wide_b, side) };
    for (int k = 0; k < 2; k++) {
        painted_triangle t = { .corner = { q[0], q[1 + k], q[2 + k] },
                               .front = c, .back = c };
        p->triangle[p->count++] = t;
    }
    return s;
}

status painter_ball(painter *p, vec3 centre, real radius, colour c)
{
    enum { ROUND = 24, RINGS = 12, VERTICES = ROUND * (RINGS + 1) };
    vec3 at[VERTICES];
    int face[ROUND * RINGS * 6], *f = face;
    for (int j = 0; j <= RINGS; j++)
        for (int i = 0; i < ROUND; i++) {
            real a = 2 * PI * i / ROUND, b = PI * j / RINGS;
            vec3 d = vec3_make(sin(b) * cos(a), cos(b), -sin(b) * sin(a));
            at[j * ROUND + i] = vec3_add_scaled(centre, radius, d);
        }
    for (int j = 0; j < RINGS; j++)
        for (int i = 0; i < ROUND; i++) {
            int k = j * ROUND, next = (i + 1) % ROUND;
            int quad[6] = { k + i, k + ROUND + i, k + ROUND + next,
                            k + i, k + ROUND + next, k + next };
            memcpy(f, quad, sizeof quad);
            f += 6;
        }
    painted_mesh m = { .vertices = VERTICES, .at = at,
                       .faces = 2 * ROUND * RINGS, .face = face,
                       .front = { c, c }, .back = { c, c },
                       .smooth = 1, .casts = 1, .gloss = 0.5 };
    return painter_mesh(p, &m);
}

// ---- Ropes -----------------------------------------------------------------

enum { ROPE_SIDES = 12, ROPE_CUTS = 4 };

// The point at t in [0, 1] between at[k] and at[k + 1] of the smooth curve
// through all points (Catmull and Rom: each point's tangent is half the way
// from the one before to the one after).
static vec3 rope_point(const vec3 *at, int n, int k, real t)
{
    vec3 a = at[k], b = at[k + 1];
    vec3 before = at[k > 0 ? k - 1 : 0], after = at[k + 2 < n ? k + 2 : n - 1];
    vec3 da = vec3_scale(0.5, vec3_sub(b, before));
    vec3 db = vec3_scale(0.5, vec3_sub(after, a));
    real t2 = t * t, t3 = t2 * t;
    vec3 p = vec3_scale(2 * t3 - 3 * t2 + 1, a);
    p = vec3_add_scaled(p, t3 - 2 * t2 + t, da);
    p = vec3_add_scaled(p, 3 * t2 - 2 * t3, b);
    return vec3_add_scaled(p, t3 - t2, db);
}

// Rings of vertices around the curve.  The ring's own direction `side` is
// carried along and made square to the curve again at every ring, so that the
// tube does not twist of itself.
static void rope_rings(const vec3 *at, int n, real radius, vec3 *vertex)
{
    int rings = (n - 1) * ROPE_CUTS + 1;
    vec3 side = vec3_make(0.36, 0.48, 0.8);
    for (int r = 0; r < rings; r++) {
        int k = r / ROPE_CUTS < n - 2 ? r / ROPE_CUTS : n - 2;
        real t = (real)(r - k * ROPE_CUTS) / ROPE_CUTS;
        vec3 here = rope_point(at, n, k, t), there, along;
        if (t < 1) {
            there = rope_point(at, n, k, t + 0.25);
            along = vec3_unit(vec3_sub(there, here));
        } else {
            there = rope_point(at, n, k, t - 0.25);
            along = vec3_unit(vec3_sub(here, there));
        }
        side = vec3_add_scaled(side, -vec3_dot(side, along), along);
        // A curve that runs along the side itself: any other will do.
        if (vec3_length_squared(side) < 1e-6)
            side = vec3_cross(along, vec3_make(along.y, along.z, along.x));
        side = vec3_unit(side);
        vec3 other = vec3_cross(along, side);
        for (int i = 0; i < ROPE_SIDES; i++) {
            real a = 2 * PI * i / ROPE_SIDES;
            vec3 d = vec3_add_scaled(vec3_scale(cos(a), side), sin(a), other);
            vertex[r * ROPE_SIDES + i] = vec3_add_scaled(here, radius, d);
        }
    }
    // The two ends are closed by cones onto these points.
    vertex[rings * ROPE_SIDES] = at[0];
    vertex[rings * ROPE_SIDES + 1] = at[n - 1];
}

// The strands climb one side of the tube each ring.
static int rope_faces(int rings, int *face, real *tint)
{
    int count = 0;
    for (int r = 0; r + 1 < rings; r++)
        for (int i = 0; i < ROPE_SIDES; i++) {
            int a = r * ROPE_SIDES, b = a + ROPE_SIDES;
            int next = (i + 1) % ROPE_SIDES;
            int quad[6] = { a + i, b + next, b + i, a + i, a + next, b + next };
            memcpy(&face[3 * count], quad, sizeof quad);
            tint[count] = tint[count + 1] = (i + r) % (ROPE_SIDES / 2) < 2;
            count += 2;
        }
    for (int i = 0; i < ROPE_SIDES; i++) {
        int next = (i + 1) % ROPE_SIDES, last = (rings - 1) * ROPE_SIDES;
        int caps[6] = { rings * ROPE_SIDES, next, i,
                        rings * ROPE_SIDES + 1, last + i, last + next };
        memcpy(&face[3 * count], caps, sizeof caps);
        tint[count] = tint[count + 1] = 0;
        count += 2;
    }
    return count;
}

status painter_rope(painter *p, const vec3 *at, int n, real radius,
                    colour light, colour dark)
{
    assert(n >= 2);
    int rings = (n - 1) * ROPE_CUTS + 1;
    size_t vertices = (size_t)rings * ROPE_SIDES + 2;
    size_t faces = 2 * (size_t)rings * ROPE_SIDES;
    vec3 *vertex = malloc(vertices * sizeof *vertex);
    int *face = malloc(faces * 3 * sizeof *face);
    real *tint = malloc(faces * sizeof *tint);
    status s = status_out_of_memory();
    if (vertex && face && tint) {
        rope_rings(at, n, radius, vertex);
        painted_mesh m = { .vertices = (int)vertices, .at = vertex,
                           .faces = rope_faces(rings, face, tint),
                           .face = face, .tint = tint,
                           .front = { light, dark }, .back = { light, dark },
                           .smooth = 1, .casts = 1, .gloss = 0.1 };
        s = painter_mesh(p, &m);
    }
    free(vertex);
    free(face);
    free(tint);
    return s;
}

// ---- The z-buffer ----------------------------------------------------------

// The nearest triangle at one point of one picture.
typedef struct {
    real nearness;      // 1 / depth along the view, 1/m; 0: nothing
    real weight[3];     // of the triangle's corners
    int  triangle;
} nearest;

// The z-buffer of one picture, whose grid is shifted by less than a point.
typedef struct {
    int  width, height;
    real shift_x, shift_y;      // points
    nearest *at;                // [width * height]
} canvas;

static nearest *canvas_at(const canvas *c, int i, int j)
{
    return &c->at[(size_t)j * (size_t)c->width + (size_t)i];
}

// The direction of the ray through point (i, j); its part along forward is 1.
static vec3 canvas_ray(const painter *p, const canvas *c, int i, int j)
{
    real scale = 1 / (p->focal * c->height);
    real x = (i + c->shift_x - 0.5 * c->width) * scale;
    real y = (0.5 * c->height - j - c->shift_y) * scale;
    vec3 ray = vec3_add_scaled(p->forward, x, p->right);
    return vec3_add_scaled(ray, y, p->up);
}

// A corner on the canvas: x and y in points, z is 1 / depth.
static int canvas_corner(const painter *p, const canvas *c, vec3 at, vec3 *out)
{
    const real least = 0.02;    // m
    vec3 d = vec3_sub(at, p->eye);
    real depth = vec3_dot(d, p->forward);
    if (!(depth > least)) return 0;
    real scale = p->focal * c->height / depth;
    out->x = 0.5 * c->width + scale * vec3_dot(d, p->right) - c->shift_x;
    out->y = 0.5 * c->height - scale * vec3_dot(d, p->up) - c->shift_y;
    out->z = 1 / depth;
    return 1;
}

static real least3(real a, real b, real c)
{
    return fmin(fmin(a, b), c);
}

static real most3(real a, real b, real c)
{
    return fmax(fmax(a, b), c);
}

// The whole numbers in [low, high], cut to 0 .. size - 1.
static int first_point(real low)
{
    return low > 0 ? (int)ceil(fmin(low, 1e6)) : 0;
}

static int last_point(real high, int size)
{
    return high < 0 ? -1 : high < size - 1 ? (int)floor(high) : size - 1;
}

// Twice the signed area of a, b, (x, y).
static real area2(vec3 a, vec3 b, real x, real y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// Marks the points that triangle t covers and where nothing nearer is seen.
// The weights of the corners on the canvas are shares of area; in space each
// counts for more the nearer its corner is.
static void canvas_triangle(const painter *p, canvas *c, int t)
{
    const painted_triangle *tri = &p->triangle[t];
    vec3 q[3];
    if (!can_be_painted(tri)) return;
    for (int k = 0; k < 3; k++)
        if (!canvas_corner(p, c, tri->corner[k], &q[k])) return;
    real area = area2(q[0], q[1], q[2].x, q[2].y);
    // y runs down on the canvas: a front face has a negative area.
    if (area == 0 || (tri->see_through && area > 0)) return;
    int x0 = first_point(least3(q[0].x, q[1].x, q[2].x));
    int x1 = last_point(most3(q[0].x, q[1].x, q[2].x), c->width);
    int y0 = first_point(least3(q[0].y, q[1].y, q[2].y));
    int y1 = last_point(most3(q[0].y, q[1].y, q[2].y), c->height);
    for (int y = y0; y <= y1; y++)
        for (int x = x0; x <= x1; x++) {
            real w[3];
            for (int k = 0; k < 3; k++)
                w[k] = area2(q[(k + 1) % 3], q[(k + 2) % 3], x, y) / area;
            if (!(w[0] >= 0 && w[1] >= 0 && w[2] >= 0)) continue;
            real z = w[0] * q[0].z + w[1] * q[1].z + w[2] * q[2].z;
            nearest *n = canvas_at(c, x, y);
            if (z <= n->nearness) continue;
            n->nearness = z;
            n->triangle = t;
            for (int k = 0; k < 3; k++) n->weight[k] = w[k] * q[k].z / z;
        }
}

// ---- What is seen ----------------------------------------------------------

typedef enum { SEEN_SKY, SEEN_FLOOR, SEEN_BODY, SEEN_LINE } seen_kind;

typedef struct {
    seen_kind what;
    vec3   ray;         // from the eye, its part along forward is 1
    vec3   at, normal;  // m; unit, towards the eye
    colour skin;
    real   gloss;
    real   fade;        // of the floor into the haze, 0 to 1
} sight;

static real smooth_step(real low, real high, real x)
{
    real t = (x - low) / (high - low);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

// 1 within a crease's rim: the weight of a corner times its height above the
// opposite edge is the distance from that edge.
static int on_crease(const painted_triangle *t, const real weight[3])
{
    vec3 n = vec3_cross(vec3_sub(t->corner[1], t->corner[0]),
                        vec3_sub(t->corner[2], t->corner[0]));
    real twice = vec3_length(n);
    for (int k = 0; k < 3; k++) {
        if (t->crease[k] == 0) continue;
        real base = vec3_distance(t->corner[(k + 1) % 3],
                                  t->corner[(k + 2) % 3]);
        if (weight[k] * twice < t->crease[k] * base) return 1;
    }
    return 0;
}

static void see_triangle(const painter *p, const nearest *n, sight *s)
{
    const painted_triangle *t = &p->triangle[n->triangle];
    vec3 at = { 0 }, normal = { 0 };
    for (int k = 0; k < 3; k++) {
        at = vec3_add_scaled(at, n->weight[k], t->corner[k]);
        normal = vec3_add_scaled(normal, n->weight[k], t->normal[k]);
    }
    normal = vec3_unit(normal);
    // The side that we see is told by the flat face, not by the normal, which
    // may lean away from us at a rim.
    vec3 flat = vec3_cross(vec3_sub(t->corner[1], t->corner[0]),
                           vec3_sub(t->corner[2], t->corner[0]));
    int front = vec3_dot(flat, vec3_sub(p->eye, at)) >= 0;
    s->what = t->lit ? SEEN_BODY : SEEN_LINE;
    s->at = at;
    s->normal = front ? normal : vec3_scale(-1, normal);
    s->skin = front ? t->front : t->back;
    s->gloss = t->gloss;
    if (on_crease(t, n->weight))
        s->skin = colour_mix(s->skin, vec3_make(1, 1, 1), 0.3);
}

// The floor: where the ray meets its plane, unless something stands nearer.
static void see_floor(const painter *p, real nearness, sight *s)
{
    real drop = p->floor_centre.y - p->eye.y;
    if (!p->has_floor || !(s->ray.y * drop > 0)) return;
    real depth = drop / s->ray.y;
    if (nearness * depth >= 1) return;
    vec3 at = vec3_add_scaled(p->eye, depth, s->ray);
    real dx = at.x - p->floor_centre.x, dz = at.z - p->floor_centre.z;
    real away = sqrt(dx * dx + dz * dz) / p->floor_radius;
    if (away >= 1) return;
    s->what = SEEN_FLOOR;
    s->at = at;
    s->normal = vec3_make(0, drop < 0 ? 1 : -1, 0);
    s->gloss = 0;
    s->fade = smooth_step(0.3, 1, away);
    // Tiles, told apart by a shade that fades with the distance.
    int odd = ((int)floor(dx / p->tile) + (int)floor(dz / p->tile)) & 1;
    real shade = 0.1 * (1 - smooth_step(0.2, 0.9, away));
    s->skin = vec3_scale(odd ? 1 - shade : 1, p->floor);
}

static sight see(const painter *p, const canvas *c, int i, int j)
{
    const nearest *n = canvas_at(c, i, j);
    sight s = { .what = SEEN_SKY, .ray = canvas_ray(p, c, i, j) };
    if (n->nearness > 0) see_triangle(p, n, &s);
    see_floor(p, n->nearness, &s);
    return s;
}

// ---- Light -----------------------------------------------------------------

enum { MAP_SIDE = 512 };

// The scene as one far lamp sees it: for every point of a square map the
// height, towards the lamp, of the first thing that its light meets.
typedef struct {
    vec3   to_lamp;             // unit
    vec3   u, v;                // 1/m, points of the map per metre, square to
    real   u0, v0;              // it; points, of the world's origin
    colour light;
    real   shine;               // of its reflection; 0: the sky's lamps
    vec3   centre;              // m, of what throws shadows
    real   radius, grain;       // m, of all that; m, of one point of the map
    float *height;              // [MAP_SIDE * MAP_SIDE] m above the origin
} shadow_map;

// Does it throw a shadow that can be seen?
static int casts(const painter *p, const painted_triangle *t)
{
    if (!t->casts || !can_be_painted(t)) return 0;
    if (!p->has_floor) return 1;
    return vec3_distance(t->corner[0], p->floor_centre) < 2 * p->floor_radius;
}

// The sphere around the middle of the casters' box that holds them all.
static void casters_sphere(const painter *p, vec3 *centre, real *radius)
{
    vec3 low = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    vec3 high = vec3_scale(-1, low);
    for (int t = 0; t < p->count; t++)
        for (int k = 0; k < 3 && casts(p, &p->triangle[t]); k++) {
            vec3 q = p->triangle[t].corner[k];
            low = vec3_make(fmin(low.x, q.x), fmin(low.y, q.y),
                            fmin(low.z, q.z));
            high = vec3_make(fmax(high.x, q.x), fmax(high.y, q.y),
                             fmax(high.z, q.z));
        }
    *centre = vec3_make(0, 0, 0);
    *radius = 0;
    if (low.x > high.x) return;
    *centre = vec3_scale(0.5, vec3_add(low, high));
    *radius = 0.5 * vec3_distance(low, high);
}

static vec3 map_point(const shadow_map *m, vec3 at)
{
    return vec3_make(vec3_dot(at, m->u) + m->u0, vec3_dot(at, m->v) + m->v0,
                     vec3_dot(at, m->to_lamp));
}

static void map_triangle(shadow_map *m, const painted_triangle *t)
{
    vec3 a = map_point(m, t->corner[0]), b = map_point(m, t->corner[1]);
    vec3 c = map_point(m, t->corner[2]);
    real area = area2(a, b, c.x, c.y);
    if (area == 0) return;
    int x0 = first_point(least3(a.x, b.x, c.x));
    int x1 = last_point(most3(a.x, b.x, c.x), MAP_SIDE);
    int y0 = first_point(least3(a.y, b.y, c.y));
    int y1 = last_point(most3(a.y, b.y, c.y), MAP_SIDE);
    // The weights of a and b grow evenly from point to point of a row.
    real grow_a = (b.y - c.y) / area, grow_b = (c.y - a.y) / area;
    for (int y = y0; y <= y1; y++) {
        real wa = area2(b, c, x0, y) / area, wb = area2(c, a, x0, y) / area;
        float *held = &m->height[y * MAP_SIDE + x0];
        for (int x = x0; x <= x1; x++, held++) {
            real h = c.z + wa * (a.z - c.z) + wb * (b.z - c.z);
            if (wa >= 0 && wb >= 0 && wa + wb <= 1 && (float)h > *held)
                *held = (float)h;
            wa += grow_a;
            wb += grow_b;
        }
    }
}

static void map_draw(shadow_map *m, const painter *p, vec3 to_lamp)
{
    vec3 helper = fabs(to_lamp.y) < 0.9 ? vec3_make(0, 1, 0)
                                        : vec3_make(1, 0, 0);
    vec3 u = vec3_unit(vec3_cross(helper, to_lamp));
    m->grain = (m->radius > 0 ? 2.02 * m->radius : 1) / (MAP_SIDE - 4);
    m->to_lamp = to_lamp;
    m->u = vec3_scale(1 / m->grain, u);
    m->v = vec3_scale(1 / m->grain, vec3_cross(to_lamp, u));
    m->u0 = 0.5 * (MAP_SIDE - 1) - vec3_dot(m->centre, m->u);
    m->v0 = 0.5 * (MAP_SIDE - 1) - vec3_dot(m->centre, m->v);
    for (int i = 0; i < MAP_SIDE * MAP_SIDE; i++) m->height[i] = -1e30f;
    if (m->radius == 0) return;
    for (int t = 0; t < p->count; t++)
        if (casts(p, &p->triangle[t])) map_triangle(m, &p->triangle[t]);
}

// The share of the lamp's light that reaches a point, of four neighbours in the
// map.  The point is lifted off its surface by a grain and a half: a surface
// must not shade itself because the map is coarse.
static real map_light(const shadow_map *m, vec3 at, vec3 normal)
{
    if (m->radius == 0) return 1;
    vec3 q = map_point(m, vec3_add_scaled(at, 1.5 * m->grain, normal));
    if (!(q.x >= 0 && q.y >= 0 && q.x < MAP_SIDE - 1 && q.y < MAP_SIDE - 1))
        return 1;
    int x = (int)q.x, y = (int)q.y;
    real fx = q.x - x, fy = q.y - y;
    float limit = (float)(q.z + m->grain);
    const float *h = &m->height[y * MAP_SIDE + x];
    real top = (h[0] < limit) * (1 - fx) + (h[1] < limit) * fx;
    h += MAP_SIDE;
    real low = (h[0] < limit) * (1 - fx) + (h[1] < limit) * fx;
    return top * (1 - fy) + low * fy;
}

// Light that the floor throws back up, less in its shade close above it.
static colour bounce_light(const painter *p, const sight *s)
{
    real high = s->at.y - p->floor_centre.y;
    real open = p->has_floor ? 0.35 + 0.65 * smooth_step(0, 1.2, high) : 1;
    real down = 0.5 - 0.5 * s->normal.y;
    return vec3_scale(0.07 + 0.30 * down * open, p->floor);
}

// Blinn's highlight, to the 32nd power.
static real highlight(const painter *p, const sight *s, vec3 to_lamp)
{
    vec3 to_eye = vec3_unit(vec3_sub(p->eye, s->at));
    real b = vec3_dot(s->normal, vec3_unit(vec3_add(to_eye, to_lamp)));
    if (b < 0.7) return 0;
    for (int k = 0; k < 5; k++) b *= b;
    return b;
}

// The light that a surface sends to the eye.
static colour lit_colour(const painter *p, const sight *s,
                         const shadow_map *map, int maps)
{
    colour light = bounce_light(p, s);
    real shine = 0;
    for (int k = 0; k < maps; k++) {
        const shadow_map *m = &map[k];
        real slope = vec3_dot(s->normal, m->to_lamp);
        if (slope <= 0) continue;
        real share = map_light(m, s->at, s->normal);
        if (share == 0) continue;
        light = vec3_add_scaled(light, slope * share, m->light);
        if (m->shine > 0 && s->gloss > 0)
            shine += m->shine * share * s->gloss * highlight(p, s, m->to_lamp);
    }
    return (colour){ s->skin.x * light.x + shine, s->skin.y * light.y + shine,
                     s->skin.z * light.z + shine };
}

// Point i of n on a disc, evenly spread (Vogel's sunflower).
static void sunflower(int i, int n, real *x, real *y)
{
    real r = sqrt((i + 0.5) / n), a = i * GOLDEN_ANGLE;
    *x = r * cos(a);
    *y = r * sin(a);
}

static vec3 lamp_direction(const painter *p, int i, int n)
{
    real x, y;
    sunflower(i, n, &x, &y);
    vec3 u = vec3_unit(vec3_cross(vec3_make(0, 0, 1), p->lamp));
    vec3 v = vec3_cross(p->lamp, u);
    vec3 d = vec3_add_scaled(p->lamp, p->lamp_size * x, u);
    return vec3_unit(vec3_add_scaled(d, p->lamp_size * y, v));
}

// Evenly over the sky, but for the lowest part, whose shadows never end.
static vec3 sky_direction(int i, int n)
{
    real up = 0.12 + 0.88 * (i + 0.5) / n, out = sqrt(1 - up * up);
    real a = i * GOLDEN_ANGLE;
    return vec3_make(out * cos(a), up, out * sin(a));
}

// Draws the maps of picture k of the nine: of the lamp's points and the sky's
// numbers k, k + 9, k + 18 and so on.  A floor in full light gets about 1.
static void maps_draw(const painter *p, shadow_map *map, int k)
{
    const colour sun = { 0.86, 0.82, 0.76 }, sky = { 0.90, 0.95, 1.04 };
    int n = SHIFTS * p->lamps;
    for (int j = 0; j < p->lamps; j++) {
        int i = k + SHIFTS * j;
        shadow_map *m = &map[2 * j];
        m[0].light = vec3_scale(0.72 / p->lamps, sun);
        m[0].shine = 0.5 / p->lamps;
        map_draw(&m[0], p, lamp_direction(p, i, n));
        m[1].light = vec3_scale(0.76 / p->lamps, sky);
        map_draw(&m[1], p, sky_direction(i, n));
    }
}

static void maps_free(shadow_map *map, int n)
{
    for (int k = 0; map && k < n; k++) free(map[k].height);
    free(map);
}

static shadow_map *maps_new(const painter *p, int n)
{
    shadow_map *map = calloc((size_t)n, sizeof *map);
    for (int k = 0; map && k < n; k++) {
        casters_sphere(p, &map[k].centre, &map[k].radius);
        map[k].height = malloc((size_t)MAP_SIDE * MAP_SIDE
                               * sizeof *map[k].height);
        if (map[k].height) continue;
        maps_free(map, n);
        return NULL;
    }
    return map;
}

// ---- The picture -----------------------------------------------------------

static colour sky_colour(const painter *p, vec3 ray)
{
    real rise = vec3_unit(ray).y;
    return colour_mix(p->haze, p->sky, smooth_step(0, 0.7, rise));
}

static colour sight_colour(const painter *p, const sight *s,
                           const shadow_map *map, int maps)
{
    if (s->what == SEEN_SKY) return sky_colour(p, s->ray);
    if (s->what == SEEN_LINE) return s->skin;
    colour c = lit_colour(p, s, map, maps);
    if (s->what == SEEN_BODY) return c;
    return colour_mix(c, sky_colour(p, s->ray), s->fade);
}

// Leaves light below 0.8 alone and bends what is brighter, so that nothing
// burns out: 0.8 + 0.2 (1 - e^(-x)), with the same slope at 0.8.
static real soft_limit(real x)
{
    return x < 0.8 ? x : 0.8 + 0.2 * (1 - exp(-(x - 0.8) / 0.2));
}

// Adds one of the nine pictures to the sum.
static void add_picture(const painter *p, canvas *c, const shadow_map *map,
                        colour *sum)
{
    memset(c->at, 0, (size_t)c->width * (size_t)c->height * sizeof *c->at);
    for (int t = 0; t < p->count; t++) canvas_triangle(p, c, t);
    for (int j = 0; j < c->height; j++)
        for (int i = 0; i < c->width; i++, sum++) {
            sight s = see(p, c, i, j);
            colour v = sight_colour(p, &s, map, 2 * p->lamps);
            v = vec3_make(soft_limit(v.x), soft_limit(v.y), soft_limit(v.z));
            *sum = vec3_add_scaled(*sum, 1.0 / SHIFTS, v);
        }
}

status painter_paint(const painter *p, picture *out,
                     int left, int top, int width, int height)
{
    assert(width > 0 && height > 0 && p->lamps > 0);
    size_t n = (size_t)width * (size_t)height;
    canvas c = { .width = width, .height = height };
    c.at = malloc(n * sizeof *c.at);
    colour *sum = calloc(n, sizeof *sum);
    shadow_map *map = maps_new(p, 2 * p->lamps);
    int ready = c.at && sum && map;
    for (int k = 0; k < SHIFTS && ready; k++) {
        c.shift_x = (k % 3 + 0.5) / 3;
        c.shift_y = (real)(k / 3) / 3 + 0.5 / 3;
        maps_draw(p, map, k);
        add_picture(p, &c, map, sum);
    }
    if (ready) {
        picture all = { width, height, sum };
        picture_copy(out, left, top, &all);
    }
    free(c.at);
    free(sum);
    maps_free(map, 2 * p->lamps);
    return ready ? status_ok() : status_out_of_memory();
}
