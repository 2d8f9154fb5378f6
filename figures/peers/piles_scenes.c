// piles_scenes.c - a pyramid, a tower, boxes that are dropped, and thrown ones.

#include "piles.h"
#include "random.h"

#include <stdlib.h>

static const vec3 X = { 1, 0, 0 }, Y = { 0, 1, 0 }, Z = { 0, 0, 1 };

static unsigned long long state;

static void turn_anyhow(pose *p)
{
    p->x = random_direction(&state);
    p->y = vec3_unit(vec3_cross(p->x, random_direction(&state)));
    p->z = vec3_cross(p->x, p->y);
}

// ---- Parts -----------------------------------------------------------------

static solid cube_of(real half)
{
    solid s = { .corners = 4, .normals = 3, .edges = 3,
                .normal = { X, Y, Z }, .edge = { X, Y, Z } };
    for (int k = 0; k < 4; k++)
        s.corner[k] = vec3_make(k & 1 ? half : -half, k & 2 ? half : -half, half);
    return s;
}

static pile pile_begin(const char *name, int bodies, int frames)
{
    pile p = { .name = name, .boxes = bodies, .frames = frames,
               .friction = 0.6, .dt = 1.0 / 60 };
    p.box = calloc((size_t)bodies, sizeof *p.box);
    if (!p.box) give_up("there is no memory for a pile");
    state = 12;
    return p;
}

static pile pile_of(const char *name, int boxes, real half, int frames)
{
    pile p = pile_begin(name, boxes, frames);
    p.half = half;
    p.radius = sqrt(3) * half;
    p.body = cube_of(half);
    return p;
}

static void put(pile *p, int k, real x, real y, real z)
{
    p->box[k].at = (pose){ .middle = { x, y, z }, .x = X, .y = Y, .z = Z };
}

static void add_wall(pile *p, vec3 normal, real offset)
{
    p->normal[p->walls] = normal;
    p->offset[p->walls++] = offset;
}

// Walls around the y axis, `far` off.
static void add_sides(pile *p, real far)
{
    for (int way = -1; way <= 1; way += 2) {
        add_wall(p, vec3_scale(way, X), -far);
        add_wall(p, vec3_scale(way, Z), -far);
    }
}

// The place of box k in a cubic grid of so many cells, around the y axis.
static vec3 cell(int k, int cells, real wide)
{
    real half = (cells - 1) / 2.0;
    return vec3_scale(wide, vec3_make(k % cells - half, k / (cells * cells),
                                      k / cells % cells - half));
}

static int cells_for(int boxes)
{
    int cells = 1;
    while (cells * cells * cells < boxes) cells++;
    return cells;
}

// ---- The scenes ------------------------------------------------------------

pile pile_pyramid(int rows)
{
    pile p = pile_of("pyramid", rows * (rows + 1) / 2, 0.5, 1200);
    p.is_built = true;
    for (int row = 0, k = 0; row < rows; row++)
        for (int i = 0; i < rows - row; i++)
            put(&p, k++, i + row / 2.0 - rows / 2.0, row + 0.5, 0);
    add_wall(&p, Y, 0);
    return p;
}

pile pile_tower(int boxes)
{
    pile p = pile_of("tower", boxes, 0.5, 1200);
    p.is_built = true;
    for (int k = 0; k < boxes; k++) put(&p, k, 0, k + 0.5, 0);
    add_wall(&p, Y, 0);
    return p;
}

pile pile_drop(int boxes)
{
    const real wide = 1.8;      // so that none overlaps however it is turned
    pile p = pile_of("drop", boxes, 0.5, 600);
    int cells = cells_for(boxes);
    for (int k = 0; k < boxes; k++) {
        vec3 c = cell(k, cells, wide);
        put(&p, k, c.x + 0.03 * random_real(&state), c.y + 1,
            c.z + 0.03 * random_real(&state));
        turn_anyhow(&p.box[k].at);
    }
    add_wall(&p, Y, 0);
    add_sides(&p, wide / 2 * (cells + 0.5));
    return p;
}

// Into a closed room, one in each cell of a grid, turned at random.
static void throw_all(pile *p, real side)
{
    int cells = cells_for(p->boxes);
    real wide = side / cells;
    p->friction = 0.5;
    for (int k = 0; k < p->boxes; k++) {
        vec3 c = cell(k, cells, wide);
        put(p, k, c.x, c.y + wide / 2, c.z);
        turn_anyhow(&p->box[k].at);
        p->box[k].velocity = random_vec3(&state, 5);
        p->box[k].spin = random_vec3(&state, 5);
    }
    add_wall(p, Y, 0);
    add_wall(p, vec3_scale(-1, Y), -side);
    add_sides(p, side / 2);
}

pile pile_thrown(int boxes)
{
    pile p = pile_of("thrown", boxes, 0.3, 600);
    throw_all(&p, cbrt(2.1 * boxes));
    return p;
}

void pile_free(pile *p)
{
    free(p->box);
}
