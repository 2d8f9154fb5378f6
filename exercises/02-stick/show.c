// show.c - a rope that swings, held by the reader's own sticks.

#include "constraint.h"
#include "show.h"

enum { LINKS = 24, SUBSTEPS = 20 };

int main(void)
{
    particle p[LINKS + 1];
    stick s[LINKS];
    vec3 gravity = { 0, -9.81, 0 }, none = { 0, 0, 0 };
    real dt = 1.0 / 30 / SUBSTEPS, link = 1.6 / LINKS;
    for (int i = 0; i <= LINKS; i++)
        p[i] = particle_start((vec3){ -i * link * 0.8, 0.8 - i * link * 0.6, 0 },
                              none, gravity, i > 0, dt);
    for (int i = 0; i < LINKS; i++)
        s[i] = (stick){ i, i + 1, link, 1, STICK_EXACT };
    for (int frame = 0; frame < 240; frame++) {
        for (int k = 0; k < SUBSTEPS; k++) {
            verlet_step(p, LINKS + 1, gravity, NULL, dt);
            sticks_iterate(s, LINKS, p, relax_options_default());
        }
        show_clear();
        for (int i = LINKS; i >= 0; i--)
            show_put(p[i].position.x, p[i].position.y, i ? 'o' : '#');
        show_frame();
    }
    if (!isatty(1)) show_print();
    printf("A rope of your own sticks, swinging.\n");
    return 0;
}
