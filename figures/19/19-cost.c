// 19-cost.c - what does a scene pay for what it does not use?
//
// Prints, of 200 boxes that fall on each other, how long a step takes with one
// more thing in the world, or one more question a step, and beside the world
// without it.

#include "clock.h"
#include "tumble.h"

#include <stdio.h>

enum { BOXES = 200, STEPS = 200, ROUNDS = 11 };

typedef struct {
    const char *what;
    void (*build)(tumble_world *w);
    void (*ask)(tumble_world *w);
} extra;

static tumble_body far_box(tumble_world *w, double x)
{
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                           tumble_body_at(x, 0.5, 100));
}

static void add_joint(tumble_world *w)
{
    tumble_body b = far_box(w, 100);
    tumble_joint_hinge(w, tumble_body_ground(), b, tumble_v(100, 1, 100),
                       tumble_v(0, 0, 1));
}

static void add_material(tumble_world *w)
{
    tumble_body_set_material(w, far_box(w, 100), 0.1, 0);
}

static void add_kinematic(tumble_world *w)
{
    tumble_body_options o = tumble_body_at(100, 0.5, 100);
    o.kind = TUMBLE_KINEMATIC;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), o);
}

static void add_ball(tumble_world *w)
{
    tumble_body_add(w, tumble_shape_sphere(w, 0.5, 1),
                    tumble_body_at(100, 0.5, 100));
}

static void add_rope(tumble_world *w)
{
    tumble_body b = tumble_body_add(w, tumble_shape_rope(w, 10, 2, 1),
                                    tumble_body_at(100, 5, 100));
    tumble_body_pin(w, b, 0);
}

static void ask_contacts(tumble_world *w)
{
    static tumble_contact all[4000];
    tumble_world_contacts(w, all, 4000);
}

static void ask_events(tumble_world *w)
{
    static tumble_event all[4000];
    tumble_world_events(w, all, 4000);
}

static void ask_rays(tumble_world *w)
{
    tumble_hit h;
    for (int k = 0; k < 10; k++)
        tumble_world_ray(w, tumble_v(-8, 0.1 * k, 0.3), tumble_v(8, 0.5, 0.1),
                         ~0u, &h);
}

static const extra EXTRA[] = {
    { "nothing more", NULL, NULL },
    { "a hinge", add_joint, NULL },
    { "a body of another material", add_material, NULL },
    { "a kinematic body", add_kinematic, NULL },
    { "a ball", add_ball, NULL },
    { "a rope of 10 links", add_rope, NULL },
    { "all contacts in every step", NULL, ask_contacts },
    { "all events in every step", NULL, ask_events },
    { "ten rays in every step", NULL, ask_rays } };
enum { EXTRAS = sizeof EXTRA / sizeof *EXTRA };

static void run(int way, void *with)
{
    const extra *x = &EXTRA[way];
    tumble_options o = tumble_options_default();
    (void)with;
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    tumble_shape s = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < BOXES; k++) {
        tumble_body_options at = tumble_body_at(0.7 * (k % 6),
                                                0.4 + 0.7 * (k / 36),
                                                0.7 * (k / 6 % 6));
        at.pose.rotation = tumble_quat_turn(tumble_v(1, 2, 3), k);
        tumble_body_add(w, s, at);
    }
    if (x->build) x->build(w);
    for (int k = 0; k < STEPS; k++) {
        tumble_world_step(w);
        if (x->ask) x->ask(w);
    }
    tumble_world_free(w);
}

int main(void)
{
    lap took[EXTRAS];
    race r = { .ways = EXTRAS, .rounds = ROUNDS, .work = run };
    clock_race(r, took);
    printf("what,us a step,beside nothing more\n");
    for (int k = 0; k < EXTRAS; k++)
        printf("%s,%.0f,%.2f\n", EXTRA[k].what, 1e6 * took[k].seconds / STEPS,
               took[k].ratio);
    return 0;
}
