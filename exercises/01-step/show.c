// show.c - a planet on its ellipse, under the reader's own step.

#include "show.h"
#include "verlet.h"

int main(void)
{
    vec3 none = { 0, 0, 0 }, start = { 1.2, 0, 0 }, speed = { 0, 0.7, 0 };
    real dt = 0.03;
    vec3 pull = vec3_scale(-1 / (1.2 * 1.2 * 1.2), start);
    particle planet = particle_start(start, speed, pull, 1, dt);
    show_clear();
    for (int step = 0; step < 450; step++) {
        vec3 at = planet.position;
        real r = vec3_length(at);
        vec3 force = vec3_scale(-1 / (r * r * r), at);
        verlet_step(&planet, 1, none, &force, dt);
        show_put(0, 0, '*');
        show_put(planet.position.x, planet.position.y, 'O');
        if (step % 2 == 0) show_frame();
        show_put(planet.position.x, planet.position.y, '.');
    }
    show_put(planet.position.x, planet.position.y, 'O');
    if (!isatty(1)) show_print();
    printf("A planet under your own step: it goes round and round, and stays "
           "on its ellipse.\n");
    return 0;
}
