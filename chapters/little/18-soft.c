//> little_bodies_place_soft 16a
static void bodies_place(void)
{
    for (body *b = bodies; b < bodies + body_count; b++)
        if (body_is_awake(b)) body_place(b);
}
//<

//> little_soft_piece 16a
// --- Cloth that touches ------------------------------------------------------

// A triangle of cloth; its first vertex stands at the end again.  Of triangles
// that share a corner or an edge, one owns it: bit k.
typedef struct {
    int  vertex[4], corners;
//<
//> little_soft_edges 16c
    int  edges;
//<
//> little_soft_feature 16a
    real margin;                // m, it is kept that far from others
} soft_piece;

// A mean of three particles.
typedef struct { int at[3]; real weight[3]; } feature;
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

static void space_limit(int i, real most)
{
    space[i] = real_min(space[i], most);
}
//<

//> little_soft_corner 16a
static void piece_at(const soft_piece *p, vec3 at[4])
{
    for (int k = 0; k < 4; k++) at[k] = particles[p->vertex[k]].position;
}

static vec3 feature_position(const feature *f)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < 3; i++)
        sum = vec3_add_scaled(sum, f->weight[i], particles[f->at[i]].position);
    return sum;
}

// m, that it has moved in this substep.
static vec3 feature_moved(const feature *f)
{
    vec3 sum = feature_position(f);
    for (int i = 0; i < 3; i++)
        sum = vec3_add_scaled(sum, -f->weight[i], particles[f->at[i]].previous);
    return sum;
}
//<

//> little_feature_answer 16a
static real feature_answer(const feature *f)
{
    real sum = 0;
    for (int i = 0; i < 3; i++)
        sum += particles[f->at[i]].inverse_mass * f->weight[i] * f->weight[i];
    return sum;
}

static void feature_shift(const feature *f, real s, vec3 by)
{
    for (int i = 0; i < 3; i++) {
        particle *p = &particles[f->at[i]];
        real share = s * f->weight[i] * p->inverse_mass;
        p->position = vec3_add_scaled(p->position, share, by);
    }
}

static touch *touch_add(feature a, vec3 way, real apart)
{
    touch *t = &touches[touch_count < TOUCHES ? touch_count++ : TOUCHES - 1];
    *t = (touch){ .a = a, .normal = vec3_unit(way), .apart = apart };
    return t;
}
//<

//> little_touch_body 16a
// Where n corners of a piece, from the k-th on, are nearest to a body; false if
// they are further than `reach`.
static bool body_touch(const soft_piece *p, int k, int n, body *b, real reach)
{
    vec3 at[4];
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
    feature f = { { p->vertex[0], p->vertex[1], p->vertex[2] }, { 0 } };
    for (int i = 0; i < s.count; i++) f.weight[k + s.of[i].a] += s.weight[i];
    touch *t = touch_add(f, s.v, p->margin);
    vec3 on_b = simplex_on(&s, b->vertex, true);
    t->body = b;
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
    vec3 at[4];
    piece_at(&soft_pieces[i], at);
    return box_grown(box_around(at, 3, i), REACH * soft_pieces[i].margin);
}

static void body_touch_cloth(body *b)
{
    box around = box_around(b->vertex, b->shape->count, 0);
    for (int i = 0; i < soft_count; i++) {
        soft_piece *p = &soft_pieces[piece_boxes[i].of];
        real reach = 2 * REACH * p->margin;
        box near = box_grown(around, reach / 2);    // the rest is in its own
        if (boxes_apart(&near, &piece_boxes[i])) continue;
//<
//> little_touch_whole 16b
        if (!body_touch(p, 0, 3, b, reach)) continue;
//<
//> little_touch_corners 16a
        for (int k = 0; k < 3; k++)
            if (p->corners >> k & 1) body_touch(p, k, 1, b, reach);
    }
}
//<

//> little_touch_pieces 16c
// --- Cloth that touches itself -----------------------------------------------

// Two features, `way` (m) from b to a.
static void features_touch(feature a, feature b, vec3 way, real apart)
{
//<
//> little_touch_space 16d
    // Neither goes further than nearly half of the way to the other.
    for (int i = 0; i < 3; i++) {
        space_limit(a.at[i], 0.45 * vec3_length(way));
        space_limit(b.at[i], 0.45 * vec3_length(way));
    }
//<
//> little_touch_pieces_end 16c
    if (vec3_dot(way, way) > 0) touch_add(a, way, apart)->b = b;
}
//<

//> little_corner_touch 16c
// A corner, over the inside of a triangle whose corners `at` are at y.
static void corner_touch(int corner, const int *at, const vec3 *y, real apart)
{
    if (at[0] == corner || at[1] == corner || at[2] == corner) return;
    real reach = REACH * apart;
    vec3 r = vec3_sub(particles[corner].position, y[0]);
    vec3 u = vec3_sub(y[1], y[0]), v = vec3_sub(y[2], y[0]);
    vec3 n = vec3_cross(u, v);
    real nn = vec3_dot(n, n), height = vec3_dot(r, n);
    if (height * height > reach * reach * nn) return;
    real s = vec3_dot(vec3_cross(r, v), n) / nn;
    real t = vec3_dot(vec3_cross(u, r), n) / nn;
    if (s < 0 || t < 0 || s + t > 1) return;
    feature f = { { corner, corner, corner }, { 1 } };
    feature g = { { at[0], at[1], at[2] }, { 1 - s - t, s, t } };
    features_touch(f, g, vec3_scale(height / nn, n), apart);
}
//<

//> little_edge_touch 16c
static real clamped(real t) { return real_max(0, real_min(1, t)); }

// The nearest points of two edges (Ericson): x[0] + s u and y[0] + t v.
static void edge_touch(const int *a, const vec3 *x, const int *b,
                       const vec3 *y, real apart)
{
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return;
    vec3 r = vec3_sub(x[0], y[0]);
    vec3 u = vec3_sub(x[1], x[0]), v = vec3_sub(y[1], y[0]);
    real uu = vec3_dot(u, u), vv = vec3_dot(v, v), uv = vec3_dot(u, v);
    real ur = vec3_dot(u, r), vr = vec3_dot(v, r), det = uu * vv - uv * uv;
    real s = 0.5, t;
    if (det > 1e-12 * uu * vv) s = clamped((uv * vr - ur * vv) / det);
    t = clamped((uv * s + vr) / vv);
    s = clamped((uv * t - ur) / uu);
    vec3 way = vec3_add_scaled(vec3_add_scaled(r, s, u), -t, v);
    if (vec3_dot(way, way) > REACH * REACH * apart * apart) return;
    feature f = { { a[0], a[1], a[1] }, { 1 - s, s } };
    feature g = { { b[0], b[1], b[1] }, { 1 - t, t } };
    features_touch(f, g, way, apart);
}
//<

//> little_pieces_touch 16c
static void pieces_touch(const soft_piece *a, const soft_piece *b)
{
    vec3 x[4], y[4];
    const int *p = a->vertex, *q = b->vertex;
    real apart = a->margin + b->margin;
    if (!a->edges && !b->edges) return;
    piece_at(a, x), piece_at(b, y);
    for (int i = 0; i < 3; i++) {
        if (a->corners >> i & 1) corner_touch(p[i], q, y, apart);
        if (b->corners >> i & 1) corner_touch(q[i], p, x, apart);
        for (int j = 0; j < 3 && a->edges && b->edges; j++)
            if (a->edges >> i & 1 && b->edges >> j & 1)
                edge_touch(p + i, x + i, q + j, y + j, apart);
    }
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
//> little_find_touches_asked 16d
    for (int i = 0; i < particle_count; i++) {
        space[i] = HUGE_VAL;
        asked_at[i] = particles[i].position;
    }
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
//<
//> little_find_touches_way 16d
    bodies_way = 0;
//<
//> little_find_touches_close 16a
}
//<

//> little_touch_part 16a
// Apart again, by the least move, less what friction holds.
static void touch_part(touch *t, real h)
{
    vec3 way = feature_position(&t->a), gone, arm;
    real answer = feature_answer(&t->a);
    if (t->body) {
        arm = mat3_apply(t->body->axes, t->local);
        way = vec3_sub(way, vec3_add(t->body->position, arm));
        gone = vec3_scale(h, body_velocity_at(t->body, arm));
        answer += body_answer(t->body, arm, t->normal);
    }
//<
//> little_touch_part_b 16c
    else {
        way = vec3_sub(way, feature_position(&t->b));
        gone = feature_moved(&t->b);
        answer += feature_answer(&t->b);
    }
//<
//> little_touch_solve 16a
    t->gap = vec3_dot(way, t->normal) - t->apart;
    if (t->gap >= 0 || answer == 0) return;
    vec3 slide = vec3_across(vec3_sub(feature_moved(&t->a), gone), t->normal);
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
    for (int i = 0; t->body && i < 3; i++)
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
static soft_piece *soft_piece_add(int a, int b, int c, real margin)
{
    int k = soft_count < SOFT_PIECES ? soft_count++ : SOFT_PIECES - 1;
    soft_pieces[k] = (soft_piece){ { a, b, c, a }, .margin = margin };
    piece_boxes[k].of = k;
    return &soft_pieces[k];
}
//<

//> little_cloth_add 16a
// Triangles of a cell.  The first owns its corner and three edges; at the last
// row and column there is more to own.
static void cell_add(int k, int n, real margin, bool right, bool below)
{
    soft_piece *p = soft_piece_add(k, k + n, k + 1, margin);
    soft_piece *q = soft_piece_add(k + 1, k + n, k + n + 1, margin);
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
