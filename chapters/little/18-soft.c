//> little_bodies_place_soft 16a
static void bodies_place(void)
{
    for (body *b = bodies; b < bodies + body_count; b++)
        if (body_is_awake(b)) body_place(b);
}
//<

//> little_soft_piece 16a
// --- Rope and cloth that touch -----------------------------------------------

// A link of rope (2 vertices) or a triangle of cloth (3); the first vertex
// stands at the end again.  Of pieces that share a corner or an edge, one owns
// it: bit k.
typedef struct {
    int  count, vertex[4], corners;
    real margin;                // m, it is kept that far from others
    vec3 low, high;             // m, the box around it
//<
//> little_soft_edges 16c
    int  edges;
//<
//> little_soft_feature 16a
} soft_piece;

// A mean of up to three particles.
typedef struct { int count, at[3]; real weight[3]; } feature;
//<

//> little_touch 16a
// Feature a keeps `apart` (m) along the normal from a body's point.
typedef struct {
    feature a;
    body *body;
    vec3 local, normal;         // m, in the body's axes; unit
    real apart, gap;            // m
//<
//> little_touch_b 16c
    feature b;                  // of another piece, if there is no body
//<
//> little_touch_end 16a
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
//<

//> little_soft_corner 16a
static vec3 piece_corner(const soft_piece *p, int k)
{
    return particles[p->vertex[k]].position;
}

static vec3 feature_position(const feature *f)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < f->count; i++) {
        vec3 x = particles[f->at[i]].position;
        sum = vec3_add_scaled(sum, f->weight[i], x);
    }
    return sum;
}

// m, that it has moved in this substep.
static vec3 feature_moved(const feature *f)
{
    vec3 sum = feature_position(f);
    for (int i = 0; i < f->count; i++) {
        vec3 x = particles[f->at[i]].previous;
        sum = vec3_add_scaled(sum, -f->weight[i], x);
    }
    return sum;
}
//<

//> little_feature_answer 16a
static real feature_answer(const feature *f)
{
    real sum = 0;
    for (int i = 0; i < f->count; i++)
        sum += particles[f->at[i]].inverse_mass * f->weight[i] * f->weight[i];
    return sum;
}

static void feature_shift(const feature *f, real s, vec3 by)
{
    for (int i = 0; i < f->count; i++) {
        particle *p = &particles[f->at[i]];
        real share = s * f->weight[i] * p->inverse_mass;
        p->position = vec3_add_scaled(p->position, share, by);
    }
}
//<

//> little_feature_add 16a
static void feature_add(feature *f, int at, real weight)
{
    int i = 0;
    while (i < f->count && f->at[i] != at) i++;
    if (i == f->count) {
        f->at[f->count++] = at;
        f->weight[i] = 0;
    }
    f->weight[i] += weight;
}

static touch *touch_add(vec3 normal, real apart)
{
    touch *t = &touches[touch_count < TOUCHES ? touch_count++ : TOUCHES - 1];
    *t = (touch){ .normal = normal, .apart = apart };
    return t;
}
//<

//> little_touch_body 16a
// Is a side of the body further than `reach` below all corners?
static bool corners_off(const vec3 *at, int n, const body *b, real reach)
{
    for (int f = 0; f < b->shape->sides; f++) {
        vec3 normal = mat3_apply(b->axes, b->shape->normal[f]);
        vec3 foot = b->vertex[b->shape->side[f][0]];
        real least = HUGE_VAL;
        for (int i = 0; i < n; i++)
            least = real_min(least, vec3_dot(normal, vec3_sub(at[i], foot)));
        if (least > reach) return true;
    }
    return false;
}

// Where n corners of a piece, from the k-th on, are nearest to a body.
static void body_touch(const soft_piece *p, int k, int n, body *b, real reach)
{
    vec3 at[3];
    simplex s = { .count = 0 };
    for (int i = 0; i < n; i++) at[i] = piece_corner(p, k + i);
    if (corners_off(at, n, b, reach)) return;
    hull a = { at, n };
    real d = gjk(a, body_hull(b), &s, reach);
    if (d > reach) return;
//<
//> little_touch_body_space 16d
    // It would cross the body after d; a twentieth of its margin it always has.
    for (int i = 0; i < n; i++) {
        real *room = &space[p->vertex[k + i]];
        *room = real_min(*room, real_max(0.9 * d, 0.05 * p->margin));
    }
//<
//> little_touch_body_epa 16a
    if (d < 1e-7) epa(a, body_hull(b), &s);
    if (vec3_dot(s.v, s.v) < 1e-20 || (n > 1 && s.count > 0
        && s.weight[0] > 0.999)) return;        // a corner asks for itself
    touch *t = touch_add(vec3_unit(s.v), p->margin);
    t->body = b;
    for (int i = 0; i < s.count; i++)
        feature_add(&t->a, p->vertex[k + s.of[i].a], s.weight[i]);
    vec3 on_b = simplex_on(&s, b->vertex, true);
    t->local = mat3_back(b->axes, vec3_sub(on_b, b->position));
//<
//> little_touch_wakes 18a
    if (b->inverse_mass > 0) {
        b->awake = true;
        b->still = 0;
    }
//<
//> little_touch_body_end 16a
}

//<
//> little_reach_bodies 16a
static const real REACH = 1.1;  // of what is kept apart, to be asked

static void piece_bound(soft_piece *p)
{
    real far = REACH * p->margin;
    vec3 margin = vec3_make(far, far, far);
    p->low = p->high = piece_corner(p, 0);
    for (int i = 1; i < p->count; i++) {
        p->low = vec3_min(p->low, piece_corner(p, i));
        p->high = vec3_max(p->high, piece_corner(p, i));
    }
    p->low = vec3_sub(p->low, margin);
    p->high = vec3_add(p->high, margin);
}

static void bodies_touch(void)
{
    for (body *b = bodies; b < bodies + body_count; b++)
        for (soft_piece *p = soft_pieces; p < soft_pieces + soft_count; p++) {
            real reach = 2 * REACH * p->margin;
            vec3 more = vec3_make(reach, reach, reach);
            vec3 low = vec3_sub(b->low, more), high = vec3_add(b->high, more);
            if (boxes_apart(p->low, p->high, low, high)) continue;
//<
//> little_touch_whole 16b
            body_touch(p, 0, p->count, b, reach);
//<
//> little_touch_corners 16a
            for (int k = 0; k < p->count; k++)
                if (p->corners >> k & 1) body_touch(p, k, 1, b, reach);
        }
}
//<

//> little_touch_pieces 16c
// --- Rope and cloth that touch themselves ------------------------------------

// Two features at a distance d, `way` from b to a.
static void features_touch(feature a, feature b, vec3 way, real apart)
{
    real d = vec3_length(way);
//<
//> little_touch_space 16d
    // Neither goes further than nearly half of the way to the other.
    for (int i = 0; i < 3; i++) {
        if (i < a.count)
            space[a.at[i]] = real_min(space[a.at[i]], 0.45 * d);
        if (i < b.count)
            space[b.at[i]] = real_min(space[b.at[i]], 0.45 * d);
    }
//<
//> little_touch_pieces_end 16c
    if (d == 0) return;
    touch *t = touch_add(vec3_scale(1 / d, way), apart);
    t->a = a;
    t->b = b;
}
//<

//> little_corner_touch 16c
// Corner k of a, over the inside of triangle b.
static void corner_touch(const soft_piece *a, int k, const soft_piece *b,
                         real reach, real apart)
{
    const int *at = b->vertex;
    for (int i = 0; i < 3; i++)
        if (at[i] == a->vertex[k]) return;
    vec3 o = piece_corner(b, 0), x = vec3_sub(piece_corner(a, k), o);
    vec3 u = vec3_sub(piece_corner(b, 1), o);
    vec3 v = vec3_sub(piece_corner(b, 2), o), n = vec3_cross(u, v);
    real nn = vec3_dot(n, n), height = vec3_dot(x, n);
    if (height * height > reach * reach * nn) return;
    real s = vec3_dot(vec3_cross(x, v), n) / nn;
    real t = vec3_dot(vec3_cross(u, x), n) / nn;
    if (s < 0 || t < 0 || s + t > 1) return;
    feature f = { 1, { a->vertex[k] }, { 1 } };
    feature g = { 3, { at[0], at[1], at[2] }, { 1 - s - t, s, t } };
    features_touch(f, g, vec3_scale(height / nn, n), apart);
}
//<

//> little_edge_touch 16c
static real clamped(real t)
{
    return real_max(0, real_min(1, t));
}

// The nearest points of edge i of a and edge j of b (Ericson): p + s u and
// q + t v.
static void edge_touch(const soft_piece *a, int i, const soft_piece *b, int j,
                       real reach, real apart)
{
    int a0 = a->vertex[i], a1 = a->vertex[i + 1];
    int b0 = b->vertex[j], b1 = b->vertex[j + 1];
    if (a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1) return;
    vec3 p = piece_corner(a, i), q = piece_corner(b, j), r = vec3_sub(p, q);
    vec3 u = vec3_sub(piece_corner(a, i + 1), p);
    vec3 v = vec3_sub(piece_corner(b, j + 1), q);
    real uu = vec3_dot(u, u), vv = vec3_dot(v, v), uv = vec3_dot(u, v);
    real ur = vec3_dot(u, r), vr = vec3_dot(v, r), det = uu * vv - uv * uv;
    real s = 0.5, t;
    if (det > 1e-12 * uu * vv) s = clamped((uv * vr - ur * vv) / det);
    t = clamped((uv * s + vr) / vv);
    s = clamped((uv * t - ur) / uu);
    vec3 way = vec3_add_scaled(vec3_add_scaled(r, s, u), -t, v);
    if (vec3_dot(way, way) > reach * reach) return;
    feature f = { 2, { a0, a1 }, { 1 - s, s } };
    feature g = { 2, { b0, b1 }, { 1 - t, t } };
    features_touch(f, g, way, apart);
}
//<

//> little_pieces_touch 16c
static void pieces_touch(const soft_piece *a, const soft_piece *b)
{
    real apart = a->margin + b->margin, reach = REACH * apart;
    for (int k = 0; k < 3; k++) {
        if (a->corners >> k & 1 && b->count == 3)
            corner_touch(a, k, b, reach, apart);
        if (b->corners >> k & 1 && a->count == 3)
            corner_touch(b, k, a, reach, apart);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (a->edges >> i & 1 && b->edges >> j & 1)
                edge_touch(a, i, b, j, reach, apart);
}
//<

//> little_touch_cells 16c
// A grid of cells as large as the largest box, hashed: each piece looks around
// for those that came before it.
enum { CELLS = 1 << 15 };
static int cell_first[CELLS], cell_next[SOFT_PIECES];

static int *cell_at(int x, int y, int z)
{
    unsigned k = (unsigned)x * 73856093u ^ (unsigned)y * 19349663u
               ^ (unsigned)z * 83492791u;
    return &cell_first[k % CELLS];
}

// Cells are numbered from -1000 on: a cast to int cuts towards zero.
static int cell_number(real x)
{
    return (int)(x + 1000);
}

static void piece_touch_around(int i, real size)
{
    const soft_piece *p = &soft_pieces[i];
    vec3 m = vec3_scale(0.5 / size, vec3_add(p->low, p->high));
    int x = cell_number(m.x), y = cell_number(m.y), z = cell_number(m.z);
    for (int k = 0; k < 27; k++) {
        int *c = cell_at(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1);
        for (int j = *c; j; j = cell_next[j - 1]) {
            const soft_piece *q = &soft_pieces[j - 1];
            if ((p->edges || q->edges)
                && !boxes_apart(p->low, p->high, q->low, q->high))
                pieces_touch(p, q);
        }
    }
    int *c = cell_at(x, y, z);
    cell_next[i] = *c;
    *c = i + 1;
}
//<

//> little_find_touches 16a
static long sought;             // how often all touches were sought

static void touches_find(void)
{
    touch_count = 0;
    sought++;
    bodies_place();
//<
//> little_find_touches_cells 16c
    real size = 0;
    for (int i = 0; i < CELLS; i++) cell_first[i] = 0;
//<
//> little_find_touches_loop 16a
    for (soft_piece *p = soft_pieces; p < soft_pieces + soft_count; p++) {
        piece_bound(p);
//<
//> little_find_touches_size 16c
        vec3 e = vec3_sub(p->high, p->low);
        size = real_max(size, real_max(e.x, real_max(e.y, e.z)));
//<
//> little_find_touches_space 16d
        for (int k = 0; k < p->count; k++)
            if (p->corners >> k & 1) {
                space[p->vertex[k]] = 0.9 * REACH * p->margin;
                asked_at[p->vertex[k]] = piece_corner(p, k);
            }
//<
//> little_find_touches_ask 16a
    }
//<
//> little_find_touches_self 16c
    for (int i = 0; i < soft_count; i++) piece_touch_around(i, size);
//<
//> little_find_touches_end 16a
    bodies_touch();
//<
//> little_find_touches_way 16d
    bodies_way = 0;
//<
//> little_find_touches_close 16a
}
//<

//> little_touch_part 16a
// The body or feature that it touches gives way, too.  Returns the share.
static real touch_answer(const touch *t, vec3 arm)
{
    if (t->body) return body_answer(t->body, arm, t->normal);
//<
//> little_touch_part_b 16c
    return feature_answer(&t->b);
//<
//> little_touch_part_no_b 16a 16b
    return 0;
//<
//> little_touch_move 16a
}

// m, a's move in this substep, as seen from what it touches.
static vec3 touch_slide(const touch *t, vec3 arm, real h)
{
    vec3 moved = feature_moved(&t->a);
    if (t->body) {
        vec3 v = body_velocity_at(t->body, arm);
        return vec3_across(vec3_add_scaled(moved, -h, v), t->normal);
    }
//<
//> little_touch_move_b 16c
    moved = vec3_sub(moved, feature_moved(&t->b));
//<
//> little_touch_solve 16a
    return vec3_across(moved, t->normal);
}

// m, from what it touches to a.
static vec3 touch_way(const touch *t, vec3 arm)
{
    vec3 a = feature_position(&t->a);
    if (t->body) return vec3_sub(a, vec3_add(t->body->position, arm));
//<
//> little_touch_way_b 16c
    a = vec3_sub(a, feature_position(&t->b));
//<
//> little_touch_way_end 16a
    return a;
}

// Apart again, by the least move, less what friction holds.
static void touch_part(touch *t, real h)
{
    vec3 arm = { 0, 0, 0 };
    if (t->body) arm = mat3_apply(t->body->axes, t->local);
    t->gap = vec3_dot(touch_way(t, arm), t->normal) - t->apart;
    real answer = feature_answer(&t->a) + touch_answer(t, arm);
    if (t->gap >= 0 || answer == 0) return;
    vec3 slide = touch_slide(t, arm, h);
    real length = vec3_length(slide), most = 0.5 * -t->gap;
    if (length > most) slide = vec3_scale(most / length, slide);
    vec3 by = vec3_sub(vec3_scale(-t->gap, t->normal), slide);
    feature_shift(&t->a, 1 / answer, by);
    if (t->body) body_push(t->body, arm, -1 / (answer * h), by);
//<
//> little_touch_solve_b 16c
    else feature_shift(&t->b, -1 / answer, by);
//<
//> little_touch_hold 16e
    for (int i = 0; t->body && i < t->a.count; i++)
        if (t->a.weight[i] > 0.3) {
            real w = particles[t->a.at[i]].inverse_mass;
            held[t->a.at[i]] = vec3_scale(sqrt(0.4 * w), t->normal);
        }
//<
//> little_touch_solve_end 16a
}

//<
//> little_space 16d
// Will one go as far in the next substep as it may?  Nothing crosses before.
static bool space_is_used(real h)
{
    real fastest = 0;
    for (body *b = bodies; b < bodies + body_count; b++) {
        if (!body_is_awake(b)) continue;
        real v = vec3_length(b->velocity);
        v += b->shape->radius * vec3_length(b->spin);
        fastest = real_max(fastest, v);
    }
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
        vec3 way = vec3_sub(particles[i].position, asked_at[i]);
        real length = vec3_length(way);
        if (length > space[i])
            particles[i].position =
                vec3_add_scaled(asked_at[i], space[i] / length, way);
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
    for (int i = 0; i < strand_count; i++) strand_string(&strands[i]);
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

//> little_piece_add 16a
static soft_piece *soft_piece_add(int count, int a, int b, int c, real margin)
{
    int k = soft_count < SOFT_PIECES ? soft_count++ : SOFT_PIECES - 1;
    soft_pieces[k] = (soft_piece){ .count = count, .margin = margin,
                                   .vertex = { a, b, count < 3 ? a : c, a } };
    return &soft_pieces[k];
}
//<

//> little_cloth_add 16a
// Triangles of a cell.  The first owns its corner and three edges; at the last
// row and column there is more to own.
static void cell_add(int k, int n, real margin, bool right, bool below)
{
    soft_piece *p = soft_piece_add(3, k, k + n, k + 1, margin);
    soft_piece *q = soft_piece_add(3, k + 1, k + n, k + n + 1, margin);
    p->corners = 1 | below << 1 | right << 2;
    q->corners = (right && below) << 2;
//<
//> little_cloth_edges 16c
    p->edges = 7;
    q->edges = below << 1 | right << 2;
//<
//> little_cloth_add_grid 16a
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
