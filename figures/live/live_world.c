// live_world.c - see live_world.h.

#include "live_world.h"
#include "handle.h"

#include <stdlib.h>

void live_world_pull(world *w, int b, real least_mass)
{
    placement now = world_where(w, b);
    real mass = real_max(least_mass, w->body[b].mass);
    vec3 a = live_pull(now.position, now.velocity);
    world_push(w, b, vec3_scale(mass / 60, a), now.position);
}

void live_world_hurry(world *w, int b, vec3 dv)
{
    world_push(w, b, vec3_scale(w->body[b].mass, dv), world_where(w, b).position);
}

// A ball is drawn as one; what else is round has a skin.
void live_world_body(const world *w, int b, live_colour c)
{
    const shape *s = w->body[b].shape;
    if (s->particles == 1) {
        live_ball(b, c, world_where(w, b).position, s->round);
        return;
    }
    struct skin skin = shape_skin(s);
    vec3 *at = malloc((size_t)skin.points * sizeof *at);
    if (!at) abort();
    world_skin(w, &w->body[b], at);
    if (s->kind == SHAPE_CLOTH) live_cloth(b, c, at, skin.points, skin.face, skin.faces);
    else live_mesh(b, c, at, skin.points, skin.face, skin.faces, s->round > 0);
    free(at);
}
