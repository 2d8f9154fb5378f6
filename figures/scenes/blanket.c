// blanket.c - a cloth that falls over a pile of boxes.
#include "example.h"

enum { BOXES = 27 };

static void build(tumble_world *w)
{
    tumble_shape box = tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), 3);
    tumble_shape cloth = tumble_shape_cloth(w, 50, 50, 3, 3, 0.5);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < BOXES; k++) {
        tumble_body_options at = tumble_body_at(0.5 * (k % 3 - 1),
                                                0.25 + 0.5 * (k / 9),
                                                0.5 * (k / 3 % 3 - 1));
        at.pose.rotation = tumble_quat_turn(tumble_v(1, 2, 3), k);
        tumble_body_add(w, box, at);
    }
    tumble_body_add(w, cloth, tumble_body_at(0, 2.5, 0));
}

static double strain(tumble_world *w)
{
    return tumble_world_measure(w).strain;
}

const example blanket = {
    .name = "blanket", .about = "a cloth over a pile", .seconds = 6,
    .has_floor = true, .eye = { 2.8, 2.4, 3.2 }, .target = { 0, 0.5, 0 },
    .build = build, .claim = "no thread is strained by more than 2 %",
    .error = strain, .most = 0.02 };
