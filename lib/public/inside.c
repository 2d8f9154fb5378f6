//> inside
//>   Every function of the library begins with one of these: look up an id, or
//>   keep a sentence and return nothing.
#include "inside.h"
#include "join.h"
#include "table.h"

#include <limits.h>
#include <stdlib.h>

bool inside_is_ok(tumble_world *w, status s)
{
    if (s.ok) return true;
    if (!w)                   inside_not_made(s);
    else if (w->failure.ok)   w->failure = s;
    return false;
}

bool inside_is_world(tumble_world *w)
{
    return w || inside_fail(w, "there is no world: it was not made");
}

bool inside_is_list(tumble_world *w, const void *list, int n, const char *of)
{
    return list || n <= 0 || inside_fail(w, "the list of %s is NULL", of);
}

void *inside_find(tumble_world *w, const slots *s, const char *what,
                  unsigned place, unsigned generation)
{
    void *found = slots_find(s, place, generation);
    if (!found && generation == 0)
        inside_fail(w, "the id of a %s is zero: it was not made", what);
    else if (!found)
        inside_fail(w, "%s %u is gone, or was never in this world", what, place);
    return found;
}

shape_place *inside_shape(tumble_world *w, tumble_shape s)
{
    if (!inside_is_world(w)) return NULL;
    return inside_find(w, &w->shapes, "shape", s.place, s.generation);
}

bool inside_reserve(tumble_world *w, int vertices)
{
    if (vertices <= w->most_vertices) return true;
    vec3 *more = realloc(w->scratch, 4 * (size_t)vertices * sizeof *more);
    if (!more) return false;
    w->scratch = more;
    w->most_vertices = vertices;
    return true;
}

bool inside_is_speed(tumble_world *w, tumble_vec3 v)
{
    if (vec3_length(from_user(v)) < MOST_SPEED) return true;
    return inside_fail(w, "a velocity of (%g, %g, %g) is too much to be counted "
                       "with", v.x, v.y, v.z);
}

bool inside_is_group(tumble_world *w, unsigned group)
{
    return group != 0
        || inside_fail(w, "a body of group 0 meets nothing, and no question "
                       "finds it: options begin with tumble_body_at");
}

int *inside_joint(tumble_world *w, tumble_joint j)
{
    if (!inside_is_world(w)) return NULL;
    return inside_find(w, &w->joints, "joint", j.place, j.generation);
}

const body_place *inside_body_of(const tumble_world *w, tumble_body b)
{
    return w ? slots_find(&w->bodies, b.place, b.generation) : NULL;
}

body_place *inside_body(tumble_world *w, tumble_body b)
{
    if (!inside_is_world(w)) return NULL;
    return inside_find(w, &w->bodies, "body", b.place, b.generation);
}

bool inside_reserve_owner(tumble_world *w)
{
    return TABLE_ADD(w->owner, w->world.bodies, w->owners)
        || inside_is_ok(w, status_out_of_memory());
}

unsigned inside_locked(const tumble_world *w, const body_place *x)
{
    return x->lock > 0 ? w->world.joints.joint[x->lock - 1].locked : 0;
}

bool inside_lock(tumble_world *w, body_place *x, unsigned axes)
{
    int number = x->piece[0].number, lock;
    if (x->lock > 0) world_unjoin(&w->world, x->lock - 1);
    x->lock = 0;
    if (axes == 0) return true;
    joint_plan plan = { .kind = JOINT_LOCK, .a = -1, .b = number, .locked = axes,
                        .point = inside_frame(w, number).center };
    if (!inside_is_ok(w, world_join(&w->world, plan, &lock))) return false;
    x->lock = 1 + lock;
    return true;
}

void inside_drop(tumble_world *w, int place)
{
    shape_place *x = slots_at(&w->shapes, place);
    shape_free(x->shape);
    free(x->shape);
    slots_give(&w->shapes, place);
}

body_mesh *inside_mesh(const tumble_world *w, int b)
{
    if (w->first_mesh == 0 || body_is_gone(&w->world.body[b])) return NULL;
    const body_place *x = slots_at(&w->bodies, w->owner[b]);
    return x ? x->mesh : NULL;
}

int inside_next_mesh(const tumble_world *w, int k)
{
    const body_place *x = slots_at(&w->bodies, k - 1);
    return x->mesh->next;
}

void inside_free_mesh(body_mesh *m)
{
    if (!m) return;
    surface_free(&m->surface);
    free(m->piece);
    free(m->of);
    free(m->seen);
    free(m);
}

tumble_body tumble_body_ground(void)
{
    return (tumble_body){ UINT_MAX, UINT_MAX };
}

rigid_frame inside_frame(const tumble_world *w, int b)
{
    if (b < 0) return JOINT_WORLD;
    return rigid4_frame(w->world.pool.at + w->world.body[b].first);
}

tumble_body inside_body_in(const tumble_world *w, int k)
{
    return (tumble_body){ (unsigned)k, slots_generation(&w->bodies, k) };
}

tumble_body inside_owner(const tumble_world *w, int b)
{
    return b < 0 ? tumble_body_ground() : inside_body_in(w, w->owner[b]);
}
//<
