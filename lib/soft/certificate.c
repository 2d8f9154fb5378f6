//> certificate-tiles
//>   A cloth is cut into tiles of two by two cells, these four and four, and so
//>   on: a pyramid. Each tile has a box at both ends.
#include "certificate.h"
#include "gjk.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>

// Level 0 is a cell; level n, 2^n by 2^n of them.
enum { TILE = 1 };      // the lowest with a box

typedef struct {
    int body, level, column, row;
} tile;

// A look at a frame.
typedef struct {
    certificate *c;
    const soft_frame *f;
    bool tells;
} frame_look;

static int columns_of(const frame_look *l, int b)
{
    return l->f->body[b].shape->columns - 1;
}

static int rows_of(const frame_look *l, int b)
{
    return l->f->body[b].shape->rows - 1;
}

static cell_range cells_of(const frame_look *l, tile t)
{
    int n = 1 << t.level;
    return (cell_range){
        t.body, t.column * n, t.row * n,
        int_min((t.column + 1) * n, columns_of(l, t.body)),
        int_min((t.row + 1) * n, rows_of(l, t.body)) };
}

static int tiles_in(int cells, int level)
{
    return ((cells - 1) >> level) + 1;
}

static int index_of(const frame_look *l, tile t)
{
    int columns = columns_of(l, t.body), rows = rows_of(l, t.body);
    int at = l->f->body[t.body].first;
    for (int n = TILE; n < t.level; n++)
        at += tiles_in(columns, n) * tiles_in(rows, n);
    return at + t.row * tiles_in(columns, t.level) + t.column;
}

static tile top_of(const frame_look *l, int b)
{
    tile t = { b, TILE, 0, 0 };
    int most = int_max(columns_of(l, b), rows_of(l, b));
    while (1 << t.level < most) t.level++;
    return t;
}

// Its four, of which some may be none.  Returns how many there are.
static int split(const frame_look *l, tile t, tile part[4])
{
    int count = 0, level = t.level - 1;
    for (int k = 0; k < 4; k++) {
        tile p = { t.body, level, 2 * t.column + k % 2, 2 * t.row + k / 2 };
        if (p.column << level < columns_of(l, t.body)
            && p.row << level < rows_of(l, t.body)) part[count++] = p;
    }
    return count;
}

static int vertex_at(const frame_look *l, int b, int column, int row)
{
    const body *x = &l->f->body[b];
    return x->first + row * x->shape->columns + column;
}
//<

//> certificate-boxes
//>   Most tiles are nowhere near each other: their boxes say so.
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

static void box_cells(const frame_look *l, cell_range r, swept_box *box)
{
    for (int e = 0; e < ENDS; e++) {
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
}

static void box_parts(const frame_look *l, tile t, swept_box *box)
{
    tile part[4];
    int parts = split(l, t, part);
    *box = l->c->box[index_of(l, part[0])];
    for (int k = 1; k < parts; k++)
        for (int e = 0; e < ENDS; e++) {
            const swept_box *x = &l->c->box[index_of(l, part[k])];
            box->low[e] = low_corner(box->low[e], x->low[e]);
            box->high[e] = high_corner(box->high[e], x->high[e]);
        }
}

static void box_all(const frame_look *l, int b)
{
    int columns = columns_of(l, b), rows = rows_of(l, b);
    for (tile t = { b, TILE, 0, 0 }; t.level <= top_of(l, b).level; t.level++)
        for (t.row = 0; t.row < tiles_in(rows, t.level); t.row++)
            for (t.column = 0; t.column < tiles_in(columns, t.level);
                 t.column++) {
                swept_box *box = &l->c->box[index_of(l, t)];
                if (t.level == TILE) box_cells(l, cells_of(l, t), box);
                else box_parts(l, t, box);
            }
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
//>   Windows overlap by a tile, so that tiles which touch are together in one:
//>   one of level n has 2^n + 1 of them a side, and begins at a multiple of 2^n.
enum { NOT_SPREAD = -1 };

static void mark_windows(const frame_look *l, int b, int level, int column,
                         int row)
{
    int columns = columns_of(l, b), rows = rows_of(l, b), n = 1 << level;
    int across = tiles_in(columns, TILE), down = tiles_in(rows, TILE);
    if (column >= across || row >= down) return;
    cell_range r = { b, column << TILE, row << TILE,
                     int_min((column + n + 1) << TILE, columns),
                     int_min((row + n + 1) << TILE, rows) };
    bool is_flat = is_range_spread(l, r);
    if (!is_flat && level > 0) {
        for (int k = 0; k < 4; k++)
            mark_windows(l, b, level - 1, column + k % 2 * n / 2,
                         row + k / 2 * n / 2);
        return;
    }
    for (int j = row; j < int_min(row + n, down); j++)
        for (int i = column; i < int_min(column + n, across); i++)
            l->c->spread[index_of(l, (tile){ b, TILE, i, j })] =
                (signed char)(is_flat ? level : NOT_SPREAD);
}

static cell_range both_of(cell_range a, cell_range b)
{
    return (cell_range){ a.body, int_min(a.left, b.left),
                         int_min(a.top, b.top), int_max(a.right, b.right),
                         int_max(a.bottom, b.bottom) };
}

// Is there a window that has all of it?
static bool is_in_window(const frame_look *l, cell_range r)
{
    tile t = { r.body, TILE, r.left >> TILE, r.top >> TILE };
    int n = l->c->spread[index_of(l, t)];
    if (n == NOT_SPREAD) return false;
    int right = (t.column >> n << n) + (1 << n) + 1;
    int bottom = (t.row >> n << n) + (1 << n) + 1;
    return r.right <= right << TILE && r.bottom <= bottom << TILE;
}
//<

//> certificate-planes
//>   Tiles that are not together in a patch are parted by a plane: along an
//>   axis, if their boxes say so; or the search for the point of their
//>   differences that is nearest to the origin (Gilbert 1966) finds one.
static bool are_boxes_apart(const frame_look *l, tile a, tile b, vec3 *normal)
{
    const swept_box *x = &l->c->box[index_of(l, a)];
    const swept_box *y = &l->c->box[index_of(l, b)];
    vec3 over = vec3_sub(x->low[0], y->high[0]);
    vec3 under = vec3_sub(y->low[0], x->high[0]);
    over = low_corner(over, vec3_sub(x->low[1], y->high[1]));
    under = low_corner(under, vec3_sub(y->low[1], x->high[1]));
    real most = l->c->rounding;
    normal->x = (real)(over.x > most) - (real)(under.x > most);
    normal->y = (real)(over.y > most) - (real)(under.y > most);
    normal->z = (real)(over.z > most) - (real)(under.z > most);
    if (normal->x != 0) normal->y = 0;
    if (normal->x != 0 || normal->y != 0) normal->z = 0;
    return normal->x != 0 || normal->y != 0 || normal->z != 0;
}

// The vertex of a range that is furthest against n.
static vec3 lowest_in(const frame_look *l, cell_range r, int end, vec3 n)
{
    vec3 best = { 0, 0, 0 };
    real least = HUGE_VAL;
    for (int j = r.top; j <= r.bottom; j++) {
        const vec3 *x = &l->c->at[end][vertex_at(l, r.body, 0, j)];
        for (int i = r.left; i <= r.right; i++) {
            real height = vec3_dot(n, x[i]);
            if (!(height < least)) continue;
            least = height;
            best = x[i];
        }
    }
    return best;
}

static vec3 middle_of_cells(const frame_look *l, cell_range r)
{
    vec3 sum = { 0, 0, 0 };
    for (int e = 0; e < ENDS; e++) {
        const vec3 *at = l->c->at[e];
        sum = vec3_add(sum, at[vertex_at(l, r.body, r.left, r.top)]);
        sum = vec3_add(sum, at[vertex_at(l, r.body, r.right, r.bottom)]);
    }
    return vec3_scale(1.0 / (2 * ENDS), sum);
}

// After so many steps a tile is better split.
enum { STEPS = 8 };

static bool is_plane_between(const frame_look *l, cell_range a, cell_range b)
{
    vec3 n = vec3_sub(middle_of_cells(l, a), middle_of_cells(l, b));
    for (int k = 0; k < STEPS; k++) {
        vec3 least = n;
        real gap = HUGE_VAL, length = vec3_length(n);
        for (int e = 0; e < ENDS; e++) {
            vec3 d = vec3_sub(lowest_in(l, a, e, n),
                              lowest_in(l, b, e, vec3_scale(-1, n)));
            real height = vec3_dot(n, d);
            if (!(height < gap)) continue;
            gap = height;
            least = d;
        }
        if (gap > l->c->rounding * length && gap < HUGE_VAL) {
            tell(l, (witness){ WITNESS_PLANE,
                               { { a, 0, { 0 } }, { b, 0, { 0 } } }, { n } });
            return true;
        }
        vec3 back = vec3_sub(n, least);
        real share = vec3_dot(n, back) / vec3_length_squared(back);
        if (!(share > 0)) return false;
        n = vec3_add_scaled(n, -real_min(share, 1), back);
    }
    return false;
}
//<

//> certificate-facets
//>   At last two triangles are asked, exactly: the origin and the hull of all
//>   their differences, at both ends.
static real gap_of(const vec3 *at, const certified_set set[2], vec3 n)
{
    real low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < set[0].count; i++)
        low = real_min(vec3_dot(n, at[set[0].vertex[i]]), low);
    for (int k = 0; k < set[1].count; k++)
        high = real_max(vec3_dot(n, at[set[1].vertex[k]]), high);
    return low - high;
}

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

static void leave_out(const frame_look *l, const certified_set set[2])
{
    l->c->left_out++;
    tell(l, (witness){ WITNESS_NONE, { set[0], set[1] }, { { 0, 0, 0 } } });
    for (int i = 0; i < 2 * FACET; i++) {
        const certified_set *s = &set[i / FACET];
        if (i % FACET < s->count) l->c->crossed[s->vertex[i % FACET]] = true;
    }
}

static bool is_beside_crossed(const frame_look *l, const certified_set *s)
{
    bool some = false;
    for (int i = 0; i < s->count; i++) some |= l->c->crossed[s->vertex[i]];
    return some;
}

static bool has_plane(const frame_look *l, certified_set a, certified_set b)
{
    certified_set set[2] = { a, b };
    vec3 n = nearest_difference(l, set, ENDS);
    real gap = real_min(gap_of(l->c->at[0], set, n),
                        gap_of(l->c->at[1], set, n));
    if (!(gap > l->c->rounding)) return false;
    tell(l, (witness){ WITNESS_PLANE, { a, b }, { n } });
    return true;
}

// Vertex k of it; or the edge from there, of which there is one if it has two.
static certified_set feature_of(const certified_set *s, int k, int count)
{
    certified_set part = { s->cells, count, { s->vertex[k] } };
    if (count > 1) part.vertex[1] = s->vertex[(k + 1) % s->count];
    return part;
}

// Two that do not cross only begin to where a corner of one meets the other, or
// two edges meet.
static bool have_features_planes(const frame_look *l,
                                 const certified_set set[2])
{
    const certified_set *a = &set[0], *b = &set[1];
    if (a->count == 1 || b->count == 1) return false;
    for (int i = 0; i < a->count; i++)
        if (!has_plane(l, feature_of(a, i, 1), *b)) return false;
    for (int k = 0; k < b->count; k++)
        if (!has_plane(l, *a, feature_of(b, k, 1))) return false;
    for (int i = 0; i < (a->count > 2 ? a->count : 1); i++)
        for (int k = 0; k < (b->count > 2 ? b->count : 1); k++)
            if (!has_plane(l, feature_of(a, i, 2), feature_of(b, k, 2)))
                return false;
    return true;
}

static void part_facets(const frame_look *l, certified_set a, certified_set b)
{
    certificate *c = l->c;
    certified_set set[2] = { a, b };
    if (has_plane(l, a, b)) return;
    vec3 n = nearest_difference(l, set, 1);
    real gap = gap_of(c->at[0], set, n);
    if (!(gap > c->rounding)) {
        leave_out(l, set);
        return;
    }
    if (have_features_planes(l, set)) return;
    if (is_beside_crossed(l, &a) && is_beside_crossed(l, &b)) {
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
    int cell = r.top * columns_of(l, r.body) + r.left;
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
//>   All pairs of triangles are looked at, from the largest tiles down.
static bool do_touch(cell_range a, cell_range b)
{
    return a.body == b.body && a.left <= b.right && b.left <= a.right
        && a.top <= b.bottom && b.top <= a.bottom;
}

static bool are_parted(const frame_look *l, tile a, tile b)
{
    cell_range x = cells_of(l, a), y = cells_of(l, b);
    vec3 n;
    if (a.body == b.body && is_in_window(l, both_of(x, y))) return true;
    if (a.level >= TILE && b.level >= TILE && are_boxes_apart(l, a, b, &n)) {
        tell(l, (witness){ WITNESS_PLANE, { { x, 0, { 0 } }, { y, 0, { 0 } } },
                           { n } });
        return true;
    }
    if (int_max(a.level, b.level) > TILE) return false;
    if (!do_touch(x, y)) return is_plane_between(l, x, y);
    return a.level == b.level && is_range_spread(l, both_of(x, y));
}

static void look_between(const frame_look *l, tile a, tile b)
{
    tile part[4];
    if (are_parted(l, a, b)) return;
    if (a.level == 0 && b.level == 0) {
        part_cells(l, cells_of(l, a), cells_of(l, b));
        return;
    }
    bool is_a = a.level >= b.level;
    int parts = split(l, is_a ? a : b, part);
    for (int k = 0; k < parts; k++)
        look_between(l, is_a ? part[k] : a, is_a ? b : part[k]);
}

static void look_within(const frame_look *l, tile t)
{
    tile part[4];
    cell_range r = cells_of(l, t);
    if (is_in_window(l, r)) return;
    if (t.level < TILE && is_range_spread(l, r)) return;
    if (t.level == 0) {
        part_cells(l, r, r);
        return;
    }
    int parts = split(l, t, part);
    for (int k = 0; k < parts; k++) {
        look_within(l, part[k]);
        for (int i = 0; i < k; i++) look_between(l, part[i], part[k]);
    }
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
        box_all(l, b);
        mark_windows(l, b, top_of(l, b).level - TILE, 0, 0);
        if (soft_moves(f, b) && soft_meets(f, b, b))
            look_within(l, top_of(l, b));
        for (int a = 0; a < b; a++)
            if (is_certified(f, a) && (soft_moves(f, a) || soft_moves(f, b))
                && soft_meets(f, a, b))
                look_between(l, top_of(l, a), top_of(l, b));
    }
}
//<

//> certificate-part
//>   Two facets that have no plane are parted along the one that they had when
//>   the frame began. What is nailed stays.
static bool is_fixed(const frame_look *l, int v)
{
    return !(l->f->particle[v].inverse_mass > 0);
}

// Is any of it?
static bool holds_still(const frame_look *l, const certified_set *s)
{
    bool some = false;
    for (int i = 0; i < s->count; i++) some |= is_fixed(l, s->vertex[i]);
    return some;
}

static real height_of_set(const frame_look *l, const certified_set *s, vec3 n)
{
    real least = HUGE_VAL;
    for (int i = 0; i < s->count; i++)
        least = real_min(vec3_dot(n, l->c->at[1][s->vertex[i]]), least);
    return least;
}

static void lift(const frame_look *l, const certified_set *s, vec3 n, real to)
{
    for (int i = 0; i < s->count; i++) {
        vec3 *x = &l->c->at[1][s->vertex[i]];
        real low = to - vec3_dot(n, *x);
        if (low > 0 && !is_fixed(l, s->vertex[i]))
            *x = vec3_add_scaled(*x, low, n);
    }
}

// They keep so much of their gap, as a share of the thickness of cloth: less
// than can be seen, and far more than rounding takes.
static const real KEEPS = 0x1p-16;

static void part_clash(const frame_look *l, const facet_clash *x)
{
    const certified_set *a = &x->set[0], *b = &x->set[1];
    real thick = l->f->body[a->cells.body].thickness;
    real need = real_min(x->gap, KEEPS * thick);
    vec3 n = x->normal, down = vec3_scale(-1, n);
    real low = height_of_set(l, a, n), high = -height_of_set(l, b, down);
    if (!(low - high < need)) return;
    real middle = (low + high) / 2;
    if (holds_still(l, a)) middle = low - need / 2;
    else if (holds_still(l, b)) middle = high + need / 2;
    lift(l, a, n, middle + need / 2);
    lift(l, b, down, need / 2 - middle);
}
//<

//> certificate-shorten
//>   Where that does not help, the ways of all that clashes are halved, and then
//>   taken away, but for one translation of all.
static void shorten(const frame_look *l, const certified_set *s, vec3 together)
{
    certificate *c = l->c;
    for (int i = 0; i < s->count; i++) {
        int v = s->vertex[i];
        if (c->is_done[v] || is_fixed(l, v)) continue;
        c->is_done[v] = true;
        c->share[v] = c->share[v] > 0.5 ? 0.5 : 0;
        vec3 stay = vec3_add(c->at[0][v], together);
        vec3 way = vec3_sub(c->goal[v], stay);
        c->at[1][v] = vec3_add_scaled(stay, c->share[v], way);
    }
}

// What all that clashes goes in the mean; nothing, if some of it is nailed.
static vec3 go_together(const frame_look *l)
{
    const certificate *c = l->c;
    vec3 sum = { 0, 0, 0 };
    int count = 0;
    for (int k = 0; k < int_min(c->clashes, c->particles); k++)
        for (int i = 0; i < 2; i++) {
            const certified_set *s = &c->clash[k].set[i];
            if (holds_still(l, s)) return (vec3){ 0, 0, 0 };
            for (int n = 0; n < s->count; n++, count++)
                sum = vec3_add(sum, vec3_sub(c->at[1][s->vertex[n]],
                                             c->at[0][s->vertex[n]]));
        }
    return vec3_scale(1.0 / count, sum);
}

// Before all of it stands still for a frame.
enum { PARTINGS = 4, ATTEMPTS = 4, SHORTENINGS = 60 };

static void mend(const frame_look *l, int round, vec3 together)
{
    certificate *c = l->c;
    int n = int_min(c->clashes, c->particles);
    for (int k = 0; k < ATTEMPTS * n && round < PARTINGS; k++)
        part_clash(l, &c->clash[k % n]);
    if (round < PARTINGS) return;
    for (int v = 0; v < c->particles; v++) {
        c->is_done[v] = false;
        if (round > PARTINGS) continue;
        c->goal[v] = c->at[1][v];
        c->share[v] = 1;
    }
    for (int k = 0; k < 2 * n; k++)
        shorten(l, &c->clash[k / 2].set[k % 2], together);
}

static void certify(const frame_look *l)
{
    certificate *c = l->c;
    look_at_all(l);
    if (c->left_out > 0) look_at_all(l);
    c->prevented = c->clashes;
    if (c->clashes == 0) return;
    vec3 together = go_together(l);
    for (int k = 0; k < PARTINGS + SHORTENINGS; k++) {
        mend(l, k, together);
        look_at_all(l);
        if (c->clashes == 0) return;
    }
    for (int v = 0; v < c->particles; v++)
        if (!is_fixed(l, v)) c->at[1][v] = c->at[0][v];
}
//<

//> certificate-frame
//>   What it has taken of a way, it takes of the velocity.
static void take_back(const frame_look *l, int v)
{
    const soft_frame *f = l->f;
    particle *p = &f->particle[v];
    vec3 by = vec3_sub(l->c->at[1][v], p->position);
    if (vec3_length_squared(by) == 0) return;
    p->position = l->c->at[1][v];
    p->previous = vec3_add_scaled(p->previous, 1 - f->age / f->frame, by);
}

static void copy_positions(certificate *c, const soft_frame *f, int end)
{
    real most = 0;
    for (int b = 0; b < f->bodies; b++) {
        if (!is_certified(f, b)) continue;
        int n = f->body[b].first + body_particles(&f->body[b]);
        for (int v = f->body[b].first; v < n; v++) {
            vec3 x = c->at[end][v] = f->particle[v].position;
            most = real_max(real_max(fabs(x.x), fabs(x.y)),
                            real_max(fabs(x.z), most));
        }
    }
    c->rounding = real_max(end == 0 ? 0 : c->rounding, 0x1p-40 * most);
}

void certificate_begin(certificate *c, const soft_frame *f)
{
    copy_positions(c, f, 0);
}

void certificate_end(certificate *c, const soft_frame *f)
{
    frame_look l = { .c = c, .f = f };
    copy_positions(c, f, 1);
    if (c->particles > 0)
        memset(c->crossed, 0, (size_t)c->particles * sizeof *c->crossed);
    certify(&l);
    l.tells = c->read != NULL;
    if (l.tells) look_at_all(&l);
    for (int b = 0; b < f->bodies && c->prevented > 0; b++) {
        if (!is_certified(f, b)) continue;
        int n = f->body[b].first + body_particles(&f->body[b]);
        for (int v = f->body[b].first; v < n; v++) take_back(&l, v);
    }
}
//<

//> certificate-room
//>   At last, its memory.
status certificate_grow(certificate *c, int kept, int particles)
{
    bool ok = true;
    for (int e = 0; e < ENDS; e++) TABLE_GROW(ok, c->at[e], kept, particles);
    TABLE_GROW(ok, c->goal, kept, particles);
    TABLE_GROW(ok, c->share, kept, particles);
    TABLE_GROW(ok, c->is_done, kept, particles);
    TABLE_GROW(ok, c->box, kept, particles);
    TABLE_GROW(ok, c->spread, kept, particles);
    TABLE_GROW(ok, c->crossed, kept, particles);
    TABLE_GROW(ok, c->clash, kept, particles);
    if (!ok) return status_out_of_memory();
    c->particles = particles;
    return status_ok();
}

void certificate_free(certificate *c)
{
    for (int e = 0; e < ENDS; e++) free(c->at[e]);
    free(c->goal);
    free(c->share);
    free(c->is_done);
    free(c->box);
    free(c->spread);
    free(c->crossed);
    free(c->clash);
    *c = (certificate){ .particles = 0 };
}
//<
