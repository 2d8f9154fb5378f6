//> little_mat3 10b
// --- Matrices: three columns -------------------------------------------------

typedef struct { vec3 x, y, z; } mat3;

static mat3 mat3_diagonal(real s)
{
    return (mat3){ { s, 0, 0 }, { 0, s, 0 }, { 0, 0, s } };
}

static mat3 mat3_add_scaled(mat3 a, real s, mat3 b)
{
    return (mat3){ vec3_add_scaled(a.x, s, b.x), vec3_add_scaled(a.y, s, b.y),
                   vec3_add_scaled(a.z, s, b.z) };
}

// m + s a a^T
static mat3 mat3_add_outer(mat3 m, real s, vec3 a)
{
    return (mat3){ vec3_add_scaled(m.x, s * a.x, a),
                   vec3_add_scaled(m.y, s * a.y, a),
                   vec3_add_scaled(m.z, s * a.z, a) };
}
//<

//> little_mat3_apply 11a
static vec3 mat3_apply(mat3 m, vec3 v)
{
    vec3 sum = vec3_scale(v.x, m.x);
    return vec3_add_scaled(vec3_add_scaled(sum, v.y, m.y), v.z, m.z);
}

// m^T v: of a rotation, its inverse.
static vec3 mat3_back(mat3 m, vec3 v)
{
    return vec3_make(vec3_dot(m.x, v), vec3_dot(m.y, v), vec3_dot(m.z, v));
}

// Turns the columns by nearly the angle |a| (rad) about a.  Cayley's map is a
// rotation exactly.
static mat3 mat3_turned(mat3 m, vec3 a)
{
    vec3 k = vec3_scale(0.5, a), *column[3] = { &m.x, &m.y, &m.z };
    real s = 2 / (1 + vec3_dot(k, k));
    for (int i = 0; i < 3; i++) {
        vec3 t = vec3_cross(k, *column[i]);
        t = vec3_add(t, vec3_cross(k, t));
        *column[i] = vec3_add_scaled(*column[i], s, t);
    }
    return m;
}
//<

//> little_mat3_inverse 13a
static mat3 mat3_times(mat3 a, mat3 b)
{
    return (mat3){ mat3_apply(a, b.x), mat3_apply(a, b.y), mat3_apply(a, b.z) };
}

static mat3 mat3_transpose(mat3 m)
{
    return (mat3){ { m.x.x, m.y.x, m.z.x }, { m.x.y, m.y.y, m.z.y },
                   { m.x.z, m.y.z, m.z.z } };
}

static mat3 mat3_inverse(mat3 m)
{
    vec3 a = vec3_cross(m.y, m.z), b = vec3_cross(m.z, m.x);
    vec3 c = vec3_cross(m.x, m.y);
    real d = 1 / vec3_dot(m.x, a);
    mat3 rows = { vec3_scale(d, a), vec3_scale(d, b), vec3_scale(d, c) };
    return mat3_transpose(rows);
}
//<

//> little_shape 10a
// --- Shapes: convex solids ---------------------------------------------------

enum { VERTICES = 24, SIDES = 44, SIDE_CORNERS = 12 };
typedef struct {
    int  count, sides, corners[SIDES], side[SIDES][SIDE_CORNERS];
    vec3 vertex[VERTICES], normal[SIDES];       // m, from the middle; unit
    real radius;                                // m, of the sphere around it
//<
//> little_shape_weight 10b
    real volume;                                // m^3
    mat3 inertia;                               // m^2, of 1 kg
//<
//> little_shape_inverse 13a
    mat3 inverse;
//<
//> little_shape_inner 15b
    real inner;                                 // m, of a sphere inside
//<
//> little_shape_end 10a
} shape;

// Puts the corners of a side in order around its normal: each before those that
// lie to its left, seen from the first.
static void side_order(const shape *s, int *c, int n, vec3 normal)
{
    vec3 first = s->vertex[c[0]];
    for (int i = 2; i < n; i++)
        for (int j = i; j > 1; j--) {
            vec3 a = vec3_sub(s->vertex[c[j - 1]], first);
            vec3 b = vec3_sub(s->vertex[c[j]], first);
            if (vec3_dot(vec3_cross(a, b), normal) >= 0) break;
            int swap = c[j];
            c[j] = c[j - 1];
            c[j - 1] = swap;
        }
}

// Adds the side in the plane of three vertices, if no vertex is above it.  A
// side is found once, by its first three.
static void side_add(shape *s, int i, int j, int k)
{
    vec3 at = s->vertex[i];
    vec3 n = vec3_cross(vec3_sub(s->vertex[j], at), vec3_sub(s->vertex[k], at));
    vec3 up = vec3_unit(vec3_dot(n, at) < 0 ? vec3_scale(-1, n) : n);
    int *c = s->side[s->sides], count = 0;
    for (int l = 0; l < s->count; l++) {
        real height = vec3_dot(up, vec3_sub(s->vertex[l], at));
        if (height > 1e-9 * s->radius) return;
        if (height > -1e-9 * s->radius && count < SIDE_CORNERS) c[count++] = l;
    }
    if (c[0] != i || c[1] != j || c[2] != k) return;
    side_order(s, c, count, up);
    s->normal[s->sides] = up;
    s->corners[s->sides++] = count;
}
//<

//> little_weigh 10b
// Sums the tetrahedra between the origin and the triangles of all sides.
static void shape_weigh(shape *s)
{
    mat3 sum = mat3_diagonal(0);
    for (int f = 0; f < s->sides; f++)
        for (int k = 2; k < s->corners[f]; k++) {
            const int *c = s->side[f];
            vec3 p[4] = { s->vertex[c[0]], s->vertex[c[k - 1]],
                          s->vertex[c[k]], { 0, 0, 0 } };
            real v = vec3_dot(p[0], vec3_cross(p[1], p[2])) / 6;
            p[3] = vec3_add(p[0], vec3_add(p[1], p[2]));
            s->volume += v;
            for (int i = 0; i < 4; i++) sum = mat3_add_outer(sum, v / 20, p[i]);
        }
    real trace = sum.x.x + sum.y.y + sum.z.z, v = s->volume;
    s->inertia = mat3_add_scaled(mat3_diagonal(trace / v), -1 / v, sum);
}
//<

//> little_shape_make 10a
enum { SHAPES = 16 };
static shape shapes[SHAPES];
static int   shape_count;

// Of points around their centre of mass, the origin.
static const shape *shape_make(const vec3 *at, int count)
{
    shape *s = &shapes[shape_count++ % SHAPES];
    *s = (shape){ .count = count };
    for (int i = 0; i < count; i++) {
        s->vertex[i] = at[i];
        s->radius = real_max(s->radius, vec3_length(at[i]));
    }
    for (int i = 0; i < count; i++)         // all planes of three: n^4 steps
        for (int j = i + 1; j < count; j++)
            for (int k = j + 1; k < count && s->sides < SIDES; k++)
                side_add(s, i, j, k);
//<
//> little_shape_weighed 10b
    shape_weigh(s);
//<
//> little_shape_inverted 13a
    s->inverse = mat3_inverse(s->inertia);
//<
//> little_shape_find_inner 15b
    s->inner = s->radius;
    for (int f = 0; f < s->sides; f++)
        s->inner = real_min(s->inner, vec3_dot(s->normal[f],
                                               s->vertex[s->side[f][0]]));
//<
//> little_shape_made 10a
    return s;
}

static const shape *box_make(real x, real y, real z)
{
    vec3 corner[8];
    return shape_make(corner, box_points(vec3_make(x, y, z), corner));
}
//<

//> little_ball_make 10a 10z 13f 15z 18a
static const shape *icosahedron_make(real radius)
{
    vec3 at[12];
    return shape_make(at, icosahedron_points(radius, at));
}
//<

//> little_body 11a
// --- Rigid bodies ------------------------------------------------------------

typedef struct {
    const shape *shape;
    vec3 position;              // m, of its centre of mass
    mat3 axes;                  // of the shape, in the world
    vec3 vertex[VERTICES];      // m, in the world
//<
//> little_body_motion 13a
    vec3 velocity, spin;        // m/s, rad/s
    real inverse_mass;          // 1/kg; 0: it never moves
    mat3 inverse;               // 1/(kg m^2), inverse inertia in the world
//<
//> little_body_material 13c
    real friction;
//<
//> little_body_first 13e
    int  first;                 // contact before: 1 + its index; 0: none
//<
//> little_body_path 13g
    real path;                  // m, what no point has gone further than
//<
//> little_body_restitution 15c
    real restitution;
//<
//> little_body_sleep 18a
    real moved, still;          // m, in this step; s, since it was last fast
//<
//> little_rigid_end 11a
} body;

enum { BODIES = 1200 };
static body bodies[BODIES];
static int  body_count;

// Its vertices, where it is now.
static void body_place(body *b)
{
    for (int i = 0; i < b->shape->count; i++) {
        vec3 arm = mat3_apply(b->axes, b->shape->vertex[i]);
        b->vertex[i] = vec3_add(b->position, arm);
    }
}
//<

//> little_body_inverse 13a
// Its inverse inertia, as it is turned now.
static void body_turn_inverse(body *b)
{
    mat3 turned = mat3_times(b->axes, b->shape->inverse);
    turned = mat3_times(turned, mat3_transpose(b->axes));
    b->inverse = mat3_add_scaled(mat3_diagonal(0), b->inverse_mass, turned);
}
//<

//> little_body_add_head 11a
// mass 0: it never moves.  Returns it, to be changed.
static body *body_add(const shape *s, vec3 position, real mass)
{
    body *b = &bodies[body_count < BODIES ? body_count++ : BODIES - 1];
    *b = (body){ .shape = s, .position = position, .axes = mat3_diagonal(1) };
//<
//> little_body_add_unweighed 11a 12z
    (void)mass;
//<
//> little_body_add_mass 13a
    b->inverse_mass = mass > 0 ? 1 / mass : 0;
    body_turn_inverse(b);
//<
//> little_body_add_friction 13c
    b->friction = 0.5;
//<
//> little_body_added 11a
    body_place(b);
    return b;
}
//<
//> little_body_turn 11a 13b 13f 15z 18a

// By nearly the angle |a| about a.
static void body_turn(body *b, vec3 a)
{
    b->axes = mat3_turned(b->axes, a);
//<
//> little_body_turn_inverse 13a 13b 13f 15z 18a
    body_turn_inverse(b);
//<
//> little_body_turn_end 11a 13b 13f 15z 18a
    body_place(b);
}
//<

//> little_body_hull 11a

static hull body_hull(const body *b)
{
    return (hull){ b->vertex, b->shape->count };
}
//<
