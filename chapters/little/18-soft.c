//> little_soft_piece 16a
// --- Cloth that touches ------------------------------------------------------

// A triangle of cloth; its first vertex stands at the end again.  Of triangles
// that share a corner or an edge, one owns it: bit k.
typedef struct {
    int  vertex[4], corners, edges;
    real margin;                // m, it is kept that far from others
} soft_piece;

// A weighted sum of particles keeps `apart` (m) along the normal from a point
// of a body.
typedef struct {
    int  at[4];
    real weight[4];
    body *body;
    vec3 local, normal;         // m, in the body's axes; unit
    real apart, gap;            // m
} touch;

enum { SOFT_PIECES = 8000, TOUCHES = 60000 };
static soft_piece soft_pieces[SOFT_PIECES];
static int        soft_count;
static touch      touches[TOUCHES];
static int        touch_count;
//<
//> little_space_data 16d
// How far may a particle go before it is asked again, and from where?
static real space[PARTICLES];           // m
static vec3 asked_at[PARTICLES];        // m
static real bodies_way;                 // m, that bodies have gone since

static void space_limit(int i, real most)
{
    space[i] = real_min(space[i], most);
}
//<

//> little_touch_add 16a
static void piece_at(const soft_piece *p, vec3 at[3])
{
    for (int k = 0; k < 3; k++) at[k] = particles[p->vertex[k]].position;
}

static touch *touch_add(body *b, const int *at, vec3 way, real apart)
{
    touch *t = &touches[touch_count < TOUCHES ? touch_count++ : TOUCHES - 1];
    *t = (touch){ .body = b, .normal = vec3_unit(way), .apart = apart };
    for (int i = 0; i < 4; i++) t->at[i] = at[i];
    return t;
}
//<

//> little_touch_body 16a
// Where n corners of a piece, from the k-th on, are nearest to a body; false if
// they are further than `reach`.
static bool body_touch(const soft_piece *p, int k, int n, body *b, real reach)
{
    vec3 at[3];
    simplex s = { .count = 0 };
    piece_at(p, at);
    real d = gjk((hull){ at + k, n }, body_hull(b), &s, reach);
    if (d > reach) return false;
//<
//> little_touch_body_space 16d
    // It would cross the body after d; a twentieth of its margin it always has.
    for (int i = k; i < k + n; i++)
        space_limit(p->vertex[i], real_max(0.9 * d, 0.05 * p->margin));
//<
//> little_touch_body_epa 16a
    if (d < 1e-7) epa((hull){ at + k, n }, body_hull(b), &s);
    bool is_corner = s.count > 0 && s.weight[0] > 0.999;
    if (vec3_dot(s.v, s.v) < 1e-20 || (n > 1 && is_corner)) return true;
    touch *t = touch_add(b, p->vertex, s.v, p->margin);
    for (int i = 0; i < s.count; i++) t->weight[k + s.of[i].a] += s.weight[i];
    vec3 on_b = simplex_on(&s, b->vertex, true);
    t->local = mat3_back(b->axes, vec3_sub(on_b, b->position));
//<
//> little_touch_wakes 18a
    b->still = 0;
//<
//> little_touch_body_end 16a
    return true;
}
//<

//> little_reach_bodies 16a
static const real REACH = 1.1;  // of what is kept apart, to be asked

static box piece_boxes[SOFT_PIECES];    // sorted

static box piece_box(int i)
{
    vec3 at[3];
    piece_at(&soft_pieces[i], at);
    return box_around(at, 3, REACH * soft_pieces[i].margin, i);
}

static void body_touch_cloth(body *b)
{
    box around = box_around(b->vertex, b->shape->count, 0, 0);
    for (int i = 0; i < soft_count; i++) {
        const soft_piece *p = &soft_pieces[piece_boxes[i].of];
        real half = REACH * p->margin;      // the other half is in its box
        if (boxes_apart(&around, &piece_boxes[i], half)) continue;
//<
//> little_touch_whole 16b
        if (!body_touch(p, 0, 3, b, 2 * half)) continue;
//<
//> little_touch_corners 16a
        for (int k = 0; k < 3; k++)
            if (p->corners >> k & 1) body_touch(p, k, 1, b, 2 * half);
    }
}
//<

//> little_touch_particles 16c
// --- Cloth that touches itself -----------------------------------------------

static body nobody;             // at rest in the origin; nothing moves it

// Where two features of cloth are nearest: a weighted mean of particles less
// another.
static void particles_touch(const int *at, const real *weight, real apart)
{
    vec3 way = { 0, 0, 0 };
    for (int i = 0; i < 4; i++)
        way = vec3_add_scaled(way, weight[i], particles[at[i]].position);
    if (vec3_length(way) > REACH * apart) return;
    touch *t = touch_add(&nobody, at, way, apart);
    for (int i = 0; i < 4; i++) t->weight[i] = weight[i];
//<
//> little_touch_space 16d
    // No particle goes further than nearly half of the way between the two.
    for (int i = 0; i < 4; i++) space_limit(at[i], 0.45 * vec3_length(way));
//<
//> little_touch_particles_end 16c
}

static vec3 between(int from, int to)
{
    return vec3_sub(particles[to].position, particles[from].position);
}
//<

//> little_corner_touch 16c
static bool all_differ(const int *at)
{
    return at[0] != at[1] && at[0] != at[2] && at[0] != at[3]
        && at[1] != at[2] && at[1] != at[3] && at[2] != at[3];
}

// A corner, at[0], over the inside of a triangle, the other three.
static void corner_touch(const int *at, real apart)
{
    if (!all_differ(at)) return;
    vec3 r = between(at[1], at[0]);
    vec3 u = between(at[1], at[2]), v = between(at[1], at[3]);
    vec3 n = vec3_cross(u, v);
    real s = vec3_dot(vec3_cross(r, v), n) / vec3_dot(n, n);
    real t = vec3_dot(vec3_cross(u, r), n) / vec3_dot(n, n);
    if (s < 0 || t < 0 || s + t > 1) return;
    particles_touch(at, (real[]){ 1, s + t - 1, -s, -t }, apart);
}
//<

//> little_edge_touch 16c
static real clamped(real t) { return real_max(0, real_min(1, t)); }

// The nearest points of two edges (Ericson): s along the first, t along the
// second.
static void edges_touch(const int *at, real apart)
{
    if (!all_differ(at)) return;
    vec3 r = between(at[2], at[0]);
    vec3 u = between(at[0], at[1]), v = between(at[2], at[3]);
    real uu = vec3_dot(u, u), vv = vec3_dot(v, v), uv = vec3_dot(u, v);
    real ur = vec3_dot(u, r), vr = vec3_dot(v, r), det = uu * vv - uv * uv;
    real s = 0.5, t;
    if (det > 1e-12 * uu * vv) s = clamped((uv * vr - ur * vv) / det);
    t = clamped((uv * s + vr) / vv);
    s = clamped((uv * t - ur) / uu);
    particles_touch(at, (real[]){ 1 - s, s, t - 1, -t }, apart);
}
//<

//> little_pieces_touch 16c
// All corners of each over the other, and all edges, as far as they own them.
static void pieces_touch(const soft_piece *a, const soft_piece *b)
{
    const int *p = a->vertex, *q = b->vertex;
    real apart = a->margin + b->margin;
    for (int i = 0; i < 3; i++) {
        if (a->corners >> i & 1)
            corner_touch((int[]){ p[i], q[0], q[1], q[2] }, apart);
        if (b->corners >> i & 1)
            corner_touch((int[]){ q[i], p[0], p[1], p[2] }, apart);
        for (int j = 0; j < 3; j++)
            if (a->edges >> i & b->edges >> j & 1)
                edges_touch((int[]){ p[i], p[i + 1], q[j], q[j + 1] }, apart);
    }
}
//<

//> little_find_touches 16a
static long sought;             // how often all touches were sought

static void touches_find(void)
{
    touch_count = 0;
    sought++;
//<
//> little_find_touches_asked 16d
    for (int i = 0; i < particle_count; i++) {
        space[i] = HUGE_VAL;
        asked_at[i] = particles[i].position;
    }
    bodies_way = 0;
//<
//> little_find_touches_boxes 16a
    for (int i = 0; i < soft_count; i++) {
        piece_boxes[i] = piece_box(piece_boxes[i].of);
//<
//> little_find_touches_space 16d
        const soft_piece *p = &soft_pieces[i];
        for (int k = 0; k < 3; k++)
            space_limit(p->vertex[k], 0.9 * REACH * p->margin);
//<
//> little_find_touches_ask 16a
    }
//<
//> little_find_touches_self 16c
    int n = boxes_sweep(piece_boxes, soft_count);
    for (int i = 0; i < n; i++)
        pieces_touch(&soft_pieces[pairs[i].a], &soft_pieces[pairs[i].b]);
//<
//> little_find_touches_end 16a
    for (int i = 0; i < body_count; i++) body_touch_cloth(&bodies[i]);
}
//<

//> little_touch_part 16a
// Apart again, by the least move, less what friction holds.
static void touch_part(touch *t, real h)
{
    body *b = t->body;
    vec3 arm = mat3_apply(b->axes, t->local);
    vec3 way = vec3_scale(-1, vec3_add(b->position, arm));
    for (int i = 0; i < 4; i++)
        way = vec3_add_scaled(way, t->weight[i], particles[t->at[i]].position);
    t->gap = vec3_dot(way, t->normal) - t->apart;
    if (t->gap >= 0) return;
    vec3 slide = vec3_scale(-h, body_velocity_at(b, arm));
    real answer = body_answer(b, arm, t->normal) + 1e-12;
    for (int i = 0; i < 4; i++) {
        const particle *p = &particles[t->at[i]];
        vec3 moved = vec3_sub(p->position, p->previous);
        slide = vec3_add_scaled(slide, t->weight[i], moved);
        answer += t->weight[i] * t->weight[i] * p->inverse_mass;
    }
    vec3 held_back = vec3_limit(vec3_across(slide, t->normal), -0.5 * t->gap);
    vec3 by = vec3_sub(vec3_scale(-t->gap, t->normal), held_back);
    for (int i = 0; i < 4; i++) {
        particle *p = &particles[t->at[i]];
        real share = t->weight[i] * p->inverse_mass / answer;
        p->position = vec3_add_scaled(p->position, share, by);
//<
//> little_touch_hold 16e
        if (b != &nobody && t->weight[i] > 0.3)
            held[t->at[i]] = vec3_scale(sqrt(0.4 * p->inverse_mass), t->normal);
//<
//> little_touch_part_end 16a
    }
    body_push(b, arm, -1 / (answer * h), by);
}
//<

//> little_space 16d
// Will one go as far in the next substep as it may?  Nothing crosses before.
static bool space_is_used(real h)
{
    real fastest = 0;
    for (body *b = bodies; b < bodies + body_count; b++)
        fastest = real_max(fastest, body_speed(b));
    bodies_way += h * fastest;
    for (int i = 0; i < particle_count; i++) {
        const particle *p = &particles[i];
        vec3 moved = vec3_sub(p->position, p->previous);
        vec3 next = vec3_add(p->position, moved);
        if (vec3_distance(next, asked_at[i]) + bodies_way > space[i])
            return true;
    }
    return false;
}

static void space_stop(void)
{
    for (int i = 0; i < particle_count; i++) {
        vec3 *x = &particles[i].position;
        vec3 way = vec3_limit(vec3_sub(*x, asked_at[i]), space[i]);
        *x = vec3_add(asked_at[i], way);
    }
}
//<

//> little_soft_move 16a
enum { SOFT_ROUNDS = 2 };

static void soft_move(real h)
{
    if (particle_count == 0) return;
//<
//> little_soft_move_find 16a 16c
    touches_find();
//<
//> little_soft_move_space 16d
    if (space_is_used(h)) touches_find();
//<
//> little_soft_move_held 16e
    for (int i = 0; i < particle_count; i++) held[i] = vec3_make(0, 0, 0);
//<
//> little_soft_move_strands 16a
    particles_step(h);
    for (int r = 0; r < SOFT_ROUNDS; r++) {
        for (touch *t = touches; t < touches + touch_count; t++)
            if (r == 0 || t->gap < 0.2 * t->apart) touch_part(t, h);
        for (int i = 0; i < strand_count; i++) strand_solve(&strands[i]);
    }
//<
//> little_soft_move_stop 16d
    space_stop();
//<
//> little_soft_move_end 16a
}
//<

//> little_cloth_add 16a
static void piece_add(int a, int b, int c, int corners, int edges, real margin)
{
    int k = soft_count < SOFT_PIECES ? soft_count++ : SOFT_PIECES - 1;
    soft_pieces[k] = (soft_piece){ { a, b, c, a }, corners, edges, margin };
    piece_boxes[k].of = k;
}

// Triangles of a cell.  The first owns its corner and three edges; at the last
// row and column there is more to own.
static void cell_add(int k, int n, real margin, bool right, bool below)
{
    int corners = 1 | below << 1 | right << 2;
    piece_add(k, k + n, k + 1, corners, 7, margin);
    corners = (right && below) << 2;
    int edges = below << 1 | right << 2;
    piece_add(k + 1, k + n, k + n + 1, corners, edges, margin);
}

// A level square of n x n particles and 1 kg, turned by 15 degrees.
static int cloth_add(int n, real side, vec3 center)
{
    int first = particle_count;
    real d = side / (n - 1), c = 0.9659258262890683, s = 0.2588190451025208;
    for (int k = 0; k < n * n; k++) {
        real x = k % n * d - side / 2, z = k / n * d - side / 2;
        vec3 at = { c * x + s * z, 0, c * z - s * x };
        particle_add(vec3_add(center, at), 1.0 / (n * n));
    }
    for (int i = 0; i < n; i++) {
        strand_add(first + i * n, 1, n - 1, d)->over = 1.2;
        strand_add(first + i, n, n - 1, d)->over = 1.2;
    }
    for (int j = 0; j + 1 < n; j++)
        for (int i = 0; i + 1 < n; i++)
            cell_add(first + j * n + i, n, 0.25 * d, i + 2 == n, j + 2 == n);
//<
//> little_cloth_ask 16d
    touches_find();
//<
//> little_cloth_add_end 16a
    return first;
}
//<
