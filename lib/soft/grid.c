//> grid-init
//>   Memory is asked for once, for the largest cloth, so that a step never
//>   fails for want of it.
#include "grid.h"
#include "aabb_tree.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

// Cells for a point.  In a box around a cloth most cells are empty, and the
// more so the finer it is.
enum { CELLS_A_POINT = 16 };                // tuned, cells

status grid_init(grid *g, int points)
{
    assert(points >= 0);
    size_t n = (size_t)points, cells = CELLS_A_POINT * n + 1;
    *g = (grid){ .points = points, .cells = CELLS_A_POINT * points + 1 };
    g->start  = malloc((cells + 2) * sizeof *g->start);
    g->cell   = malloc((n + 1) * sizeof *g->cell);
    g->sorted = malloc((n + 1) * sizeof *g->sorted);
    g->near   = malloc((n + 1) * sizeof *g->near);
    if (!g->start || !g->cell || !g->sorted || !g->near) {
        grid_free(g);
        return status_out_of_memory();
    }
    return status_ok();
}

void grid_free(grid *g)
{
    free(g->start);
    free(g->cell);
    free(g->sorted);
    free(g->near);
    *g = (grid){ 0 };
}
//<

//> grid-box
// The box of all points, cut into nx * ny * nz cells with sides of `side`.
typedef struct {
    vec3 least;         // m
    real side;          // m
    int  nx, ny, nz;
} cell_cut;

// Cells as wide as the reach, or, if there are too many of them, a quarter
// wider, and again, up to six times the reach.  0: that is not enough.
static int cut_box(cell_cut *c, const vec3 *at, int n, real reach, int cells)
{
    aabb all = { at[0], at[0] };
    real sum = 0;
    for (int i = 0; i < n; i++) {
        all = aabb_with(all, at[i]);
        sum += 0 * (at[i].x + at[i].y + at[i].z);
    }
    vec3 size = vec3_sub(all.high, all.low);
    for (real side = reach; sum == 0 && side < 6 * reach; side *= 1.25) {
        real x = size.x / side, y = size.y / side, z = size.z / side;
        if (!((x + 1) * (y + 1) * (z + 1) <= cells)) continue;
        *c = (cell_cut){ all.low, side, (int)x + 1, (int)y + 1, (int)z + 1 };
        return 1;
    }
    return 0;
}
//<

//> grid-sort
//>   Now the points are sorted into the cells. Each cell counts its points, the
//>   counts are added up, and each point goes to its place. This is a *counting
//>   sort*, in time proportional to points and cells.
// Two rows of the sheet are parted by so many empty places: so no point at the
// end of a row is beside one at the beginning of the next.
enum { CELL_MARGIN = 2 };

// Rounding may put the outermost point beyond the last cell.
static int cell_along(real x, real least, real side, int n)
{
    int k = (int)((x - least) / side);
    return k < n ? k : n - 1;
}

// A counting sort: how many there are in each cell says where the next begins.
// It counts two cells further on.  So, while the points are placed, the first
// free place of cell c stands in start[c + 1], and in the end where c + 1 begins.
static void sort_points(grid *g, const cell_cut *c, const vec3 *at, int n,
                        int columns)
{
    int cells = c->nx * c->ny * c->nz, column = 0, place = 0;
    for (int k = 0; k <= cells + 1; k++) g->start[k] = 0;
    for (int i = 0; i < n; i++) {
        int x = cell_along(at[i].x, c->least.x, c->side, c->nx);
        int y = cell_along(at[i].y, c->least.y, c->side, c->ny);
        int z = cell_along(at[i].z, c->least.z, c->side, c->nz);
        g->cell[i] = (z * c->ny + y) * c->nx + x;
        g->start[g->cell[i] + 2]++;
    }
    for (int k = 1; k <= cells; k++) g->start[k + 1] += g->start[k];
    for (int i = 0; i < n; i++) {
        g->sorted[g->start[g->cell[i] + 1]++] = (grid_point){ at[i], i, place };
        bool is_last = ++column == columns;
        column = is_last ? 0 : column;
        place += is_last ? 1 + CELL_MARGIN : 1;
    }
}
//<

//> grid-look
typedef struct {
    grid *g;
    cell_cut  c;
    real reach2;        // m^2
    int pitch;          // places from one row of the sheet to the next
    leaf_pair *out;
    int found, capacity;
} grid_search;

// By their places: neighbours in the sheet?
static bool is_grid_neighbour(int a, int b, int pitch)
{
    int steps = abs(a - b);
    return steps <= 1 || abs(steps - pitch) <= 1;
}

// Pieces of the sorted points: from one number to before another.
typedef struct {
    int from, end;
} grid_piece;

// Those of a piece that are near follow the `count` that are known.  The loop asks
// no question whose answer a processor would have to guess: what may be near is
// written, and stays if the count moves over it.
static int find_in_piece(const grid_search *s, vec3 at, grid_piece x, int count)
{
    const grid_point *sorted = s->g->sorted;
    int *near = s->g->near;
    for (int k = x.from; k < x.end; k++) {
        near[count] = k;
        vec3 d = vec3_sub(sorted[k].at, at);
        count += vec3_length_squared(d) < s->reach2;
    }
    return count;
}

static void keep_near(grid_search *s, const grid_point *a, int count)
{
    for (int k = 0; k < count; k++) {
        const grid_point *b = &s->g->sorted[s->g->near[k]];
        int p = a->number, q = b->number;
        if (is_grid_neighbour(a->place, b->place, s->pitch)) continue;
        if (s->found < s->capacity)
            s->out[s->found] = (leaf_pair){ p < q ? p : q, p < q ? q : p };
        s->found++;
    }
}
//<

//> grid-pairs
//>   What is left is the walk over all cells that hold a point.
// Of the 26 cells around one, 13 come after it: the next one in its row, and
// three in each of four rows.  Those of a row stand in one piece.
static void pair_neighbour_cells(grid_search *s, int cell)
{
    static const int row[4][2] = { { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } };
    const int *start = s->g->start;
    int nx = s->c.nx, x = cell % nx, here = cell - x;
    int y = cell / nx % s->c.ny, z = cell / nx / s->c.ny;
    int left = x > 0 ? x - 1 : 0, right = x + 1 < nx ? x + 1 : x;
    grid_piece piece[5] = { { 0, start[here + right + 1] } };
    int pieces = 1;
    for (int r = 0; r < 4; r++) {
        int v = y + row[r][0], w = z + row[r][1];
        if (v < 0 || v >= s->c.ny || w >= s->c.nz) continue;
        int there = (w * s->c.ny + v) * nx;
        piece[pieces++] = (grid_piece){ start[there + left],
                                        start[there + right + 1] };
    }
    for (int i = start[cell]; i < start[cell + 1]; i++) {
        const grid_point *a = &s->g->sorted[i];
        int count = 0;
        piece[0].from = i + 1;
        for (int k = 0; k < pieces; k++)
            count = find_in_piece(s, a->at, piece[k], count);
        keep_near(s, a, count);
    }
}

int grid_pairs(grid *g, const vec3 *at, int n, real reach, int columns,
               leaf_pair *out, int capacity)
{
    assert(n <= g->points && reach > 0 && columns > 0 && capacity >= 0);
    grid_search s = { .g = g, .reach2 = reach * reach, .pitch = columns + CELL_MARGIN,
                 .out = out, .capacity = capacity };
    if (n == 0) return 0;
    if (!cut_box(&s.c, at, n, reach, g->cells)) return -1;
    sort_points(g, &s.c, at, n, columns);
    for (int k = 0; k < n;) {
        int cell = g->cell[g->sorted[k].number];
        pair_neighbour_cells(&s, cell);
        k = g->start[cell + 1];
    }
    return s.found;
}
//<
