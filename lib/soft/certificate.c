//> certificate-parts
//>   A cloth is halved, its halves are, and so on down to its cells. Each part
//>   has a box at both ends, but for the smallest.
#include "certificate.h"
#include "gjk.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>

enum { FEW = 4 };       // cells of a part that has no boxes within

// The boxes of a part's first half follow its own, and then those of the other:
// of n cells there are at most 2 n - 1.
typedef struct {
    cell_range cells;
    int box;            // its number; -1: none
} part;

// A look at a frame.
typedef struct {
    certificate *c;
    const soft_frame *f;
    bool tells;
} frame_look;

static int cells_in(cell_range r)
{
    return (r.right - r.left) * (r.bottom - r.top);
}

static part whole_of(const frame_look *l, int b)
{
    const body *x = &l->f->body[b];
    return (part){ { b, 0, 0, x->shape->columns - 1, x->shape->rows - 1 },
                   2 * x->first };
}

static void halve(part p, part half[2])
{
    cell_range r = p.cells;
    half[0] = half[1] = p;
    if (r.right - r.left >= r.bottom - r.top)
        half[0].cells.right = half[1].cells.left = (r.left + r.right) / 2;
    else
        half[0].cells.bottom = half[1].cells.top = (r.top + r.bottom) / 2;
    bool are_boxed = cells_in(r) > FEW;
    half[0].box = are_boxed ? p.box + 1 : -1;
    half[1].box = are_boxed ? p.box + 2 * cells_in(half[0].cells) : -1;
}

static int vertex_at(const frame_look *l, int b, int column, int row)
{
    const body *x = &l->f->body[b];
    return x->first + row * x->shape->columns + column;
}
//<

//> certificate-boxes
//>   Most parts are nowhere near each other: their boxes say so.
static vec3 low_corner(vec3 a, vec3 b)
{
    return vec3_make(real_min(a.x, b.x), real_min(a.y, b.y),
                     real_min(a.z, b.z));
}

static vec3 high_corner(vec3 a, vec3 b)
{
    return vec3_make(real_max(a.x, b.x), real_max(a.y, b.y),
                     real_max(a.z, b.z));
}

static void box_cells(const frame_look *l, cell_range r, int e, swept_box *box)
{
    const vec3 *at = l->c->at[e];
    vec3 low = at[vertex_at(l, r.body, r.left, r.top)], high = low;
    for (int j = r.top; j <= r.bottom; j++) {
        const vec3 *x = &at[vertex_at(l, r.body, 0, j)];
        for (int i = r.left; i <= r.right; i++) {
            low = low_corner(low, x[i]);
            high = high_corner(high, x[i]);
        }
    }
    box->low[e] = low;
    box->high[e] = high;
}

static void box_part(const frame_look *l, part p)
{
    part half[2];
    swept_box *box = &l->c->box[p.box];
    halve(p, half);
    for (int k = 0; k < 2 && half[0].box >= 0; k++) box_part(l, half[k]);
    for (int e = 0; e < ENDS; e++) {
        if (half[0].box < 0) {
            box_cells(l, p.cells, e, box);
            continue;
        }
        const swept_box *x = &l->c->box[half[0].box];
        const swept_box *y = &l->c->box[half[1].box];
        box->low[e] = low_corner(x->low[e], y->low[e]);
        box->high[e] = high_corner(x->high[e], y->high[e]);
    }
}

// Along which axis?
static bool are_boxes_apart(const frame_look *l, part a, part b, vec3 *normal)
{
    const swept_box *x = &l->c->box[a.box], *y = &l->c->box[b.box];
    real most = l->c->rounding;
    vec3 over = low_corner(vec3_sub(x->low[0], y->high[0]),
                           vec3_sub(x->low[1], y->high[1]));
    vec3 under = low_corner(vec3_sub(y->low[0], x->high[0]),
                            vec3_sub(y->low[1], x->high[1]));
    *normal = (vec3){ 0, 0, 0 };
    if (over.x > most || under.x > most) normal->x = over.x > most ? 1 : -1;
    else if (over.y > most || under.y > most)
        normal->y = over.y > most ? 1 : -1;
    else if (over.z > most || under.z > most)
        normal->z = over.z > most ? 1 : -1;
    else return false;
    return true;
}
//<

//> certificate-spread
//>   Most pairs of triangles that are near each other are neighbours in a cloth.
//>   Those of a patch need no planes of their own: if a projection spreads it
//>   out, it gives every pair one.
// The projection (x, y) is the one that makes the mean cell a square, at the
// middle of the frame: times a number > 0.
static bool projection_of(const frame_look *l, cell_range r, vec3 normal[2])
{
    vec3 along = { 0, 0, 0 }, down = along;
    for (int e = 0; e < ENDS; e++) {
        const vec3 *at = l->c->at[e];
        vec3 a = at[vertex_at(l, r.body, r.left, r.top)];
        vec3 b = at[vertex_at(l, r.body, r.right, r.top)];
        vec3 c = at[vertex_at(l, r.body, r.left, r.bottom)];
        vec3 d = at[vertex_at(l, r.body, r.right, r.bottom)];
        vec3 cross = vec3_sub(d, a), back = vec3_sub(b, c);
        along = vec3_add(along, vec3_add(cross, back));
        down = vec3_add(down, vec3_sub(cross, back));
    }
    along = vec3_scale(1.0 / (r.right - r.left), along);
    down = vec3_scale(1.0 / (r.bottom - r.top), down);
    real ee = vec3_dot(along, along), ef = vec3_dot(along, down);
    real ff = vec3_dot(down, down), det = ee * ff - ef * ef;
    real size = 1 / det;
    if (!(det > 0 && size < HUGE_VAL)) return false;
    normal[0] = vec3_add_scaled(vec3_scale(ff * size, along), -ef * size, down);
    normal[1] = vec3_add_scaled(vec3_scale(ee * size, down), -ef * size, along);
    return true;
}

typedef struct {
    real x, y;
} flat_point;

static flat_point flat_less(flat_point a, flat_point b)
{
    return (flat_point){ a.x - b.x, a.y - b.y };
}

// What is surely over 0 is over it by this share of what the mean cell has:
// rounding is far less.
static const real SURELY = 0x1p-20;

static bool is_spread(flat_point e, flat_point f)
{
    real mixed = f.x + e.y;
    return e.x > SURELY && f.y > SURELY
        && (4 - SURELY) * e.x * f.y > mixed * mixed;
}

static flat_point flat_of(const vec3 normal[2], vec3 x)
{
    return (flat_point){ vec3_dot(normal[0], x), vec3_dot(normal[1], x) };
}

// The cells of a row, from one column to before another.
static bool is_row_spread(const vec3 *upper, const vec3 *under, int left,
                          int right, int row, const vec3 normal[2])
{
    flat_point a = flat_of(normal, upper[left]);
    flat_point c = flat_of(normal, under[left]);
    for (int i = left; i < right; i++) {
        flat_point b = flat_of(normal, upper[i + 1]);
        flat_point d = flat_of(normal, under[i + 1]);
        flat_point above = flat_less(b, a), below = flat_less(d, c);
        flat_point before = flat_less(c, a), after = flat_less(d, b);
        bool is_odd = (i + row) % 2;        // see shape_cut_cells
        if (!is_spread(above, is_odd ? before : after)
            || !is_spread(below, is_odd ? after : before)) return false;
        a = b;
        c = d;
    }
    return true;
}

static void tell(const frame_look *l, witness w)
{
    if (l->tells) l->c->read(l->c->to, &w);
}

static bool is_range_spread(const frame_look *l, cell_range r)
{
    witness w = { .kind = WITNESS_SPREAD, .set[0].cells = r };
    if (!projection_of(l, r, w.normal)) return false;
    for (int j = r.top; j < r.bottom; j++) {
        int upper = vertex_at(l, r.body, 0, j);
        int under = vertex_at(l, r.body, 0, j + 1);
        for (int e = 0; e < ENDS; e++) {
            const vec3 *at = l->c->at[e];
            if (!is_row_spread(at + upper, at + under, r.left, r.right, j,
                               w.normal)) return false;
        }
    }
    tell(l, w);
    return true;
}
//<

//> certificate-windows
//>   A window is a part with two columns and rows more, so that parts that touch
//>   are together in one. What is no patch is tried in halves.
static void mark_windows(const frame_look *l, part p)
{
    enum { MORE = 2 };
    part half[2], all = whole_of(l, p.cells.body);
    cell_range r = p.cells, window = r;
    window.right = int_min(r.right + MORE, all.cells.right);
    window.bottom = int_min(r.bottom + MORE, all.cells.bottom);
    bool is_patch = is_range_spread(l, window);
    if (!is_patch && cells_in(r) > FEW) {
        halve(p, half);
        for (int k = 0; k < 2; k++) mark_windows(l, half[k]);
        return;
    }
    for (int j = r.top; j < r.bottom; j++)
        for (int i = r.left; i < r.right; i++) {
            certified_vertex *v = &l->c->of[vertex_at(l, r.body, i, j)];
            v->right = is_patch ? window.right : 0;
            v->bottom = is_patch ? window.bottom : 0;
        }
}

// Is there a window that has all of it?
static bool is_in_window(const frame_look *l, cell_range r)
{
    const certified_vertex *v
        = &l->c->of[vertex_at(l, r.body, r.left, r.top)];
    return r.right <= v->right && r.bottom <= v->bottom;
}
//<

//> certificate-planes
//>   Small parts that are not together in a patch, and at last two triangles,
//>   are parted by a plane. A short search for the point of their differences
//>   that is nearest to the origin (Gilbert 1966) mostly finds one. If it finds
//>   none, parts are halved; for triangles GJK tells exactly.
// The vertex that is furthest against n.
static vec3 lowest_of(const vec3 *at, const certified_set *s, vec3 n)
{
    vec3 best = { 0, 0, 0 };
    real least = HUGE_VAL;
    for (int i = 0; i < s->count; i++) {
        real height = vec3_dot(n, at[s->vertex[i]]);
        if (!(height < least)) continue;
        least = height;
        best = at[s->vertex[i]];
    }
    return best;
}

// How far is the first set over the second, along n, and where least?
static real gap_of(const frame_look *l, const certified_set set[2], int ends,
                   vec3 n, vec3 *where)
{
    real gap = HUGE_VAL;
    for (int e = 0; e < ends; e++) {
        const vec3 *at = l->c->at[e];
        vec3 d = vec3_sub(lowest_of(at, &set[0], n),
                          lowest_of(at, &set[1], vec3_scale(-1, n)));
        real height = vec3_dot(n, d);
        if (!(height < gap)) continue;
        gap = height;
        *where = d;
    }
    return gap < HUGE_VAL ? gap : 0;
}

// Of triangles, and exactly: unit.
static vec3 nearest_difference(const frame_look *l, const certified_set set[2],
                               int ends)
{
    vec3 d[ENDS * FACET * FACET], origin = { 0, 0, 0 };
    int count = 0;
    for (int e = 0; e < ends; e++)
        for (int i = 0; i < set[0].count; i++)
            for (int k = 0; k < set[1].count; k++)
                d[count++] = vec3_sub(l->c->at[e][set[0].vertex[i]],
                                      l->c->at[e][set[1].vertex[k]]);
    gjk_result g = gjk_distance((hull){ d, count }, (hull){ &origin, 1 },
                                HUGE_VAL, NULL);
    return vec3_unit(g.axis);
}

static vec3 middle_of_set(const frame_look *l, const certified_set *s)
{
    int first = s->vertex[0], last = s->vertex[s->count - 1];
    const vec3 *was = l->c->at[0], *is = l->c->at[1];
    return vec3_add(vec3_add(was[first], was[last]),
                    vec3_add(is[first], is[last]));
}

static bool is_plane(const frame_look *l, const certified_set set[2], vec3 n,
                     vec3 *where)
{
    real gap = gap_of(l, set, ENDS, n, where);
    if (!(gap > l->c->rounding * vec3_length(n))) return false;
    tell(l, (witness){ WITNESS_PLANE, { set[0], set[1] }, { n } });
    return true;
}

static bool has_plane(const frame_look *l, const certified_set set[2])
{
    enum { STEPS = 8 };
    vec3 least = { 0, 0, 0 };
    vec3 n = vec3_sub(middle_of_set(l, &set[0]), middle_of_set(l, &set[1]));
    for (int k = 0; k < STEPS; k++) {
        if (is_plane(l, set, n, &least)) return true;
        vec3 back = vec3_sub(n, least);
        real share = vec3_dot(n, back) / vec3_length_squared(back);
        if (!(share > 0)) break;
        n = vec3_add_scaled(n, -real_min(share, 1), back);
    }
    if (set[0].count > FACET || set[1].count > FACET) return false;
    return is_plane(l, set, nearest_difference(l, set, ENDS), &least);
}
//<

//> certificate-triangles
//>   What has no plane will be parted; what had none when the frame began is
//>   left out.
static void leave_out(const frame_look *l, const certified_set set[2])
{
    l->c->left_out++;
    for (int i = 0; i < 2 * FACET; i++) {
        const certified_set *s = &set[i / FACET];
        if (i % FACET < s->count) l->c->of[s->vertex[i % FACET]].crossed = true;
    }
}

static bool is_beside_crossed(const frame_look *l, const certified_set *s)
{
    bool some = false;
    for (int i = 0; i < s->count; i++) some |= l->c->of[s->vertex[i]].crossed;
    return some;
}

static void part_facets(const frame_look *l, certified_set a, certified_set b)
{
    certificate *c = l->c;
    certified_set set[2] = { a, b };
    if (has_plane(l, set)) return;
    vec3 where, n = nearest_difference(l, set, 1);
    real gap = gap_of(l, set, 1, n, &where);
    bool is_crossed = !(gap > c->rounding);
    if (is_crossed) leave_out(l, set);
    if (is_crossed || (is_beside_crossed(l, &a) && is_beside_crossed(l, &b))) {
        tell(l, (witness){ WITNESS_NONE, { a, b }, { { 0, 0, 0 } } });
        return;
    }
    if (c->clashes < c->particles)
        c->clash[c->clashes] = (facet_clash){ { a, b }, n, gap };
    c->clashes++;
}

static certified_set triangle_of(const frame_look *l, cell_range r, int k)
{
    const body *b = &l->f->body[r.body];
    int cell = r.top * (b->shape->columns - 1) + r.left;
    certified_set s = { .cells = r, .count = FACET };
    for (int i = 0; i < FACET; i++)
        s.vertex[i] = b->first + b->shape->face[FACET * (2 * cell + k) + i];
    return s;
}

// What of a is no vertex of b.
static certified_set without(certified_set a, const certified_set *b)
{
    certified_set rest = { .cells = a.cells };
    for (int i = 0; i < a.count; i++) {
        bool is_common = false;
        for (int k = 0; k < b->count; k++)
            is_common |= a.vertex[i] == b->vertex[k];
        if (!is_common) rest.vertex[rest.count++] = a.vertex[i];
    }
    return rest;
}

// Triangles that share a vertex meet there: the other edge of one must not meet
// the other.  Two that share an edge meet nowhere else, but where they lie flat
// on each other.
static void part_triangles(const frame_look *l, certified_set a,
                           certified_set b)
{
    certified_set x = without(a, &b), y = without(b, &a);
    if (x.count == 1) return;
    part_facets(l, x, b);
    if (x.count < FACET) part_facets(l, a, y);
}

static void part_cells(const frame_look *l, cell_range a, cell_range b)
{
    bool is_one = a.body == b.body && a.left == b.left && a.top == b.top;
    for (int i = 0; i < 2; i++)
        for (int k = is_one ? i + 1 : 0; k < 2; k++)
            part_triangles(l, triangle_of(l, a, i), triangle_of(l, b, k));
}
//<

//> certificate-look
//>   All pairs of triangles are looked at, from the largest parts down.
static certified_set set_of(const frame_look *l, cell_range r)
{
    certified_set s = { .cells = r };
    for (int j = r.top; j <= r.bottom; j++)
        for (int i = r.left; i <= r.right; i++)
            s.vertex[s.count++] = vertex_at(l, r.body, i, j);
    return s;
}

static bool are_parted(const frame_look *l, part p, part q)
{
    cell_range a = p.cells, b = q.cells;
    cell_range both = { a.body, int_min(a.left, b.left), int_min(a.top, b.top),
                        int_max(a.right, b.right),
                        int_max(a.bottom, b.bottom) };
    vec3 n;
    if (a.body == b.body && is_in_window(l, both)) return true;
    if (p.box >= 0 && q.box >= 0 && are_boxes_apart(l, p, q, &n)) {
        tell(l, (witness){ WITNESS_PLANE, { { .cells = a }, { .cells = b } },
                           { n } });
        return true;
    }
    if (int_max(cells_in(a), cells_in(b)) > FEW) return false;
    bool do_touch = a.body == b.body && a.left <= b.right && b.left <= a.right
                 && a.top <= b.bottom && b.top <= a.bottom;
    if (do_touch) return is_range_spread(l, both);
    certified_set set[2] = { set_of(l, a), set_of(l, b) };
    return has_plane(l, set);
}

static void look_between(const frame_look *l, part a, part b)
{
    part half[2];
    int cells = cells_in(a.cells), others = cells_in(b.cells);
    if (are_parted(l, a, b)) return;
    if (cells == 1 && others == 1) {
        part_cells(l, a.cells, b.cells);
        return;
    }
    halve(cells >= others ? a : b, half);
    for (int k = 0; k < 2; k++)
        look_between(l, cells >= others ? half[k] : a,
                     cells >= others ? b : half[k]);
}

static void look_within(const frame_look *l, part p)
{
    part half[2];
    if (is_in_window(l, p.cells)) return;
    if (cells_in(p.cells) < FEW && is_range_spread(l, p.cells)) return;
    if (cells_in(p.cells) == 1) {
        part_cells(l, p.cells, p.cells);
        return;
    }
    halve(p, half);
    for (int k = 0; k < 2; k++) look_within(l, half[k]);
    look_between(l, half[0], half[1]);
}

static bool is_certified(const soft_frame *f, int b)
{
    return body_is_soft(&f->body[b]) && f->body[b].shape->rows > 1;
}

// Pairs that no plane parts are in `clash` afterwards.
static void look_at_all(const frame_look *l)
{
    const soft_frame *f = l->f;
    l->c->clashes = l->c->left_out = 0;
    for (int b = 0; b < f->bodies; b++) {
        if (!is_certified(f, b)) continue;
        box_part(l, whole_of(l, b));
        mark_windows(l, whole_of(l, b));
        if (soft_moves(f, b) && soft_meets(f, b, b))
            look_within(l, whole_of(l, b));
        for (int a = 0; a < b; a++)
            if (is_certified(f, a) && (soft_moves(f, a) || soft_moves(f, b))
                && soft_meets(f, a, b))
                look_between(l, whole_of(l, a), whole_of(l, b));
    }
}
//<

//> certificate-part
//>   Two facets that have no plane are parted along the one that they had when
//>   the frame began, by the least moves that do it and push nothing away: those
//>   of chapter 07, of all their vertices at once.
static bool is_fixed(const frame_look *l, int v)
{
    return !(l->f->particle[v].inverse_mass > 0);
}

// kg; what is nailed outweighs all.
static real weight_of(const frame_look *l, int v)
{
    static const real NAILED = 0x1p100;
    return is_fixed(l, v) ? NAILED : 1 / l->f->particle[v].inverse_mass;
}

// A vertex must be over, or under, what parts the two.
typedef struct {
    real at, weight;    // where that may be at most, or at least: m, kg
    bool is_over;
} side_of_plane;

static bool is_beyond(const side_of_plane *s, real middle)
{
    return s->is_over ? middle > s->at : middle < s->at;
}

// Those that are not where they must be are drawn to it.  It is where their
// pulls are in balance: each side as much as the other.
static real balance(const side_of_plane *s, int count)
{
    real low = -HUGE_VAL, sum = 0, mass = 0;
    for (int k = 0; k < count; k++) {
        real pull = 0;
        for (int i = 0; i < count; i++)
            if (is_beyond(&s[i], s[k].at))
                pull += s[i].weight * (s[k].at - s[i].at);
        if (pull <= 0) low = real_max(low, s[k].at);
    }
    for (int i = 0; i < count; i++) {
        if (s[i].is_over != (s[i].at <= low)) continue;
        sum += s[i].weight * (s[i].at - low);
        mass += s[i].weight;
    }
    return low + sum / mass;
}

// They keep so much of their gap, as a share of the thickness of cloth: less
// than can be seen, and far more than rounding takes.
static const real KEEPS = 0x1p-16;

static void part_clash(const frame_look *l, const facet_clash *x)
{
    side_of_plane side[2 * FACET];
    int count = 0, vertex[2 * FACET];
    real thick = l->f->body[x->set[0].cells.body].thickness;
    real need = real_min(x->gap, KEEPS * thick);
    vec3 where = { 0, 0, 0 };
    if (!(gap_of(l, x->set, ENDS, x->normal, &where) < need)) return;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < x->set[i].count; k++, count++) {
            int v = vertex[count] = x->set[i].vertex[k];
            real height = vec3_dot(x->normal, l->c->at[1][v]);
            side[count] = (side_of_plane){ height + (i - 0.5) * need,
                                           weight_of(l, v), i == 0 };
        }
    real middle = balance(side, count);
    for (int k = 0; k < count; k++) {
        vec3 *at = &l->c->at[1][vertex[k]];
        if (is_beyond(&side[k], middle) && !is_fixed(l, vertex[k]))
            *at = vec3_add_scaled(*at, middle - side[k].at, x->normal);
    }
}
//<

//> certificate-as-one
//>   What still clashes makes a patch with all that it clashes with, which goes
//>   as one, by its mean way: so its momentum is left to it.
static int patch_of(certificate *c, int v)
{
    while (c->of[v].patch != v) {
        c->of[v].patch = c->of[c->of[v].patch].patch;
        v = c->of[v].patch;
    }
    return v;
}

static void join(certificate *c, const facet_clash *x)
{
    int first = patch_of(c, x->set[0].vertex[0]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < x->set[i].count; k++)
            c->of[patch_of(c, x->set[i].vertex[k])].patch = first;
    c->of[first].is_whole = true;
}

static void go_as_one(const frame_look *l)
{
    certificate *c = l->c;
    for (int k = 0; k < int_min(c->clashes, c->particles); k++)
        join(c, &c->clash[k]);
    for (int v = 0; v < c->particles; v++) {
        c->of[v].way = (vec3){ 0, 0, 0 };
        c->of[v].mass = 0;
    }
    for (int v = 0; v < c->particles; v++) {
        certified_vertex *p = &c->of[patch_of(c, v)];
        if (!p->is_whole) continue;
        real m = weight_of(l, v);
        vec3 way = vec3_sub(c->at[1][v], c->at[0][v]);
        p->way = vec3_add_scaled(p->way, m, way);
        p->mass += m;
    }
    for (int v = 0; v < c->particles; v++) {
        const certified_vertex *p = &c->of[patch_of(c, v)];
        if (p->is_whole && !is_fixed(l, v))
            c->at[1][v] = vec3_add_scaled(c->at[0][v], 1 / p->mass, p->way);
    }
}

// Before all of it stands still for a frame.
enum { PARTINGS = 4, ATTEMPTS = 4, ROUNDS = 60 };

static void certify(const frame_look *l)
{
    certificate *c = l->c;
    look_at_all(l);
    if (c->left_out > 0) look_at_all(l);
    c->prevented = c->clashes;
    for (int k = 0; k < PARTINGS && c->clashes > 0; k++) {
        int n = int_min(c->clashes, c->particles);
        for (int i = 0; i < ATTEMPTS * n; i++) part_clash(l, &c->clash[i % n]);
        look_at_all(l);
    }
    for (int v = 0; v < c->particles && c->clashes > 0; v++) {
        c->of[v].patch = v;
        c->of[v].is_whole = false;
    }
    for (int k = 0; k < ROUNDS && c->clashes > 0; k++) {
        go_as_one(l);
        look_at_all(l);
    }
    for (int v = 0; v < c->particles && c->clashes > 0; v++)
        if (!is_fixed(l, v)) c->at[1][v] = c->at[0][v];
}
//<

//> certificate-frame
//>   What it has added to a way, it adds to the velocity. A long frame has more
//>   than one way.
static void take_back(const frame_look *l, int v)
{
    const soft_frame *f = l->f;
    particle *p = &f->particle[v];
    vec3 by = vec3_sub(l->c->at[1][v], p->position);
    if (!(vec3_length_squared(by) > 0)) return;
    p->position = l->c->at[1][v];
    p->previous = vec3_add_scaled(p->previous, 1 - f->age / l->c->since, by);
}

// A vertex that is lost stands still for all others.
static void copy_positions(certificate *c, const soft_frame *f, int end)
{
    real most = 0;
    for (int b = 0; b < f->bodies; b++) {
        if (!is_certified(f, b)) continue;
        int n = f->body[b].first + body_particles(&f->body[b]);
        for (int v = f->body[b].first; v < n; v++) {
            vec3 x = f->particle[v].position;
            if (end > 0 && !vec3_is_finite(x)) x = c->at[0][v];
            most = real_max(real_max(fabs(x.x), fabs(x.y)),
                            real_max(fabs(x.z), most));
            c->at[end][v] = x;
        }
    }
    c->rounding = real_max(end == 0 ? 0 : c->rounding, 0x1p-40 * most);
}

void certificate_begin(certificate *c, const soft_frame *f)
{
    copy_positions(c, f, 0);
    c->since = 0;
}

// Cloth that falls as one, however fast, keeps all its planes: what counts is
// how far one vertex has gone from another.  No way is shorter than the usual
// substep of what is stiff: what cannot be is asked for in every one.
bool certificate_is_due(certificate *c, const soft_frame *f)
{
    vec3 low = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high = vec3_scale(-1, low);
    real spacing = HUGE_VAL;
    c->since += f->h;
    if (!(c->since * (f->stiff_substeps + 1) > f->frame)) return false;
    for (int b = 0; b < f->bodies; b++) {
        if (!is_certified(f, b)) continue;
        int n = f->body[b].first + body_particles(&f->body[b]);
        spacing = real_min(spacing, f->body[b].shape->spacing);
        for (int v = f->body[b].first; v < n; v++) {
            vec3 way = vec3_sub(f->particle[v].position, c->at[0][v]);
            low = low_corner(low, way);
            high = high_corner(high, way);
        }
    }
    return vec3_distance(low, high) > spacing;
}

// What is proved begins the next way.
static void begin_next(certificate *c)
{
    vec3 *ended = c->at[1];
    c->at[1] = c->at[0];
    c->at[0] = ended;
    c->since = 0;
}

void certificate_end(certificate *c, const soft_frame *f)
{
    frame_look l = { .c = c, .f = f };
    bool is_still = true;
    for (int b = 0; b < f->bodies; b++)
        is_still = is_still && !(is_certified(f, b) && soft_moves(f, b));
    c->prevented = c->left_out = 0;
    if (is_still || !(c->since > 0)) return;
    copy_positions(c, f, 1);
    for (int v = 0; v < c->particles; v++) c->of[v].crossed = false;
    certify(&l);
    l.tells = c->read != NULL;
    if (l.tells) look_at_all(&l);
    for (int b = 0; b < f->bodies && c->prevented > 0; b++) {
        if (!is_certified(f, b)) continue;
        int n = f->body[b].first + body_particles(&f->body[b]);
        for (int v = f->body[b].first; v < n; v++) take_back(&l, v);
    }
    begin_next(c);
}
//<

//> certificate-room
//>   At last, its memory.
status certificate_grow(certificate *c, int kept, int particles)
{
    bool ok = true;
    for (int e = 0; e < ENDS; e++) TABLE_GROW(ok, c->at[e], kept, particles);
    TABLE_GROW(ok, c->of, kept, particles);
    TABLE_GROW(ok, c->box, 2 * kept, 2 * particles);
    TABLE_GROW(ok, c->clash, kept, particles);
    if (!ok) return status_out_of_memory();
    c->particles = particles;
    return status_ok();
}

void certificate_free(certificate *c)
{
    for (int e = 0; e < ENDS; e++) free(c->at[e]);
    free(c->of);
    free(c->box);
    free(c->clash);
    *c = (certificate){ .particles = 0 };
}
//<
