// pyramid.c - 210 boxes on each other: does the pile stand, and sleep?
#include "example.h"

enum { ROWS = 20, BOXES = ROWS * (ROWS + 1) / 2 };
static tumble_body top;

static void build(tumble_world *w)
{
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int row = 0; row < ROWS; row++)
        for (int k = 0; k < ROWS - row; k++)
            top = tumble_body_add(w, box, tumble_body_at(1.1 * (k + row / 2.0),
                                                         row + 0.5, 0));
}

// m, by which the highest box has moved.
static double moved(tumble_world *w)
{
    tumble_vec3 at = tumble_body_position(w, top);
    double x = at.x - 1.1 * (ROWS - 1) / 2.0, y = at.y - (ROWS - 0.5);
    bool sleeps = tumble_world_last_step(w).asleep == BOXES;
    return sleeps ? x * x + y * y + at.z * at.z : 1;
}

const example pyramid = {
    .name = "pyramid", .about = "210 boxes on each other", .seconds = 8,
    .has_floor = true, .eye = { 29, 16, 37 }, .target = { 10.5, 9.3, 0 },
    .build = build,
    .claim = "all sleep, and the top has moved by three centimetres at most",
    .error = moved, .most = 1e-3 };
