// hashes.c - four small worlds, each as the hash of where its bodies end.  It
// sees tumble.h and nothing else, so it is built against any form of the library,
// by any compiler: all must print the same lines.
//   cc hashes.c tumble.c -lm

#include <tumble.h>

#include <stdio.h>

static void run(tumble_world *w, const char *name, int steps)
{
    for (int step = 0; step < steps; step++) tumble_world_step(w);
    const char *why = tumble_world_failure(w);
    printf("%s %016llx%s%s\n", name, tumble_world_hash(w), why ? " " : "",
           why ? why : "");
    tumble_world_free(w);
}

static tumble_world *on_ground(void)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    return w;
}

// README's program.
static void readme(void)
{
    tumble_world *w = on_ground();
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body falling = tumble_body_add(w, box, tumble_body_at(0, 3, 0));
    tumble_body sign = tumble_body_add(w, box, tumble_body_at(4, 2, 0));
    tumble_joint_hinge(w, tumble_body_ground(), sign, tumble_v(4, 2.5, 0),
                       tumble_v(0, 0, 1));
    tumble_body_push(w, falling, tumble_v(4, 0, 0), tumble_v(0, 3, 0));
    run(w, "readme", 300);
}

// One of each shape, thrown together.
static void heap(void)
{
    tumble_world *w = on_ground();
    tumble_shape shape[] = {
        tumble_shape_box(w, tumble_v(0.4, 0.5, 0.6), 1),
        tumble_shape_sphere(w, 0.3, 2),
        tumble_shape_icosahedron(w, 0.3, 1),
        tumble_shape_capsule(w, 0.5, 0.2, 3) };
    for (int k = 0; k < 16; k++) {
        tumble_body_options o = tumble_body_at(0.1 * (k % 3), 0.5 + 0.7 * k,
                                               0.05 * k);
        o.pose.rotation = tumble_quat_turn(tumble_v(1, k, 2), 0.3 * k);
        tumble_body_add(w, shape[k % 4], o);
    }
    run(w, "heap", 120);
}

// A cloth on a ball that stands still, and a rope beside it.
static void cloth(void)
{
    tumble_world *w = on_ground();
    tumble_body_options o = tumble_body_at(0, 1, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_sphere(w, 0.5, 1), o);
    tumble_body_add(w, tumble_shape_cloth(w, 12, 12, 1.6, 1.6, 0.5),
                    tumble_body_at(0.1, 1.6, 0));
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 12, 1.5, 0.3),
                                       tumble_body_at(2, 1, 0));
    tumble_body_pin(w, rope, 0);
    run(w, "cloth", 40);
}

// Boxes on a terrain.
static void hills(void)
{
    enum { SIDE = 9 };
    double height[SIDE * SIDE];
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    for (int k = 0; k < SIDE * SIDE; k++) height[k] = 0.1 * (k * 7 % 5);
    tumble_body_add_heights(w, height, SIDE, SIDE, 4, 4, 0, o);
    tumble_shape box = tumble_shape_box(w, tumble_v(0.4, 0.3, 0.4), 1);
    for (int k = 0; k < 6; k++)
        tumble_body_add(w, box, tumble_body_at(0.5 * (k % 3) - 0.4, 1 + 0.4 * k,
                                               0.2 * k - 0.5));
    run(w, "hills", 120);
}

int main(void)
{
    readme();
    heap();
    cloth();
    hills();
}
