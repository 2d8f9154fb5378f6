//> face-kind
//>   A body may change its kind, feel another gravity than the rest, and be held
//>   along some axes: a lift that stops, a balloon, a game in two dimensions.
#include "handle.h"
#include "inside.h"

static const tumble_vec3 AT_REST = { 0, 0, 0 };

bool tumble_body_set_kind(tumble_world *w, tumble_body b, tumble_kind kind)
{
    int number = inside_rigid(w, b, AT_REST, AT_REST);
    if (number < 0) return false;
    if ((unsigned)kind > TUMBLE_KINEMATIC)
        return inside_fail(w, "%d is no kind of body", (int)kind);
    body_place *x = inside_body(w, b);
    if (kind == x->kind) return true;
    inside_lock(w, x, 0);
    world_set_kind(&w->world, number, (body_kind)kind);
    x->kind = kind;
    return true;
}
//<

//> face-gravity
//>   Gravity is a number of the body; velocities go on from what they are.
bool tumble_body_set_gravity_scale(tumble_world *w, tumble_body b, double scale)
{
    int number = inside_rigid(w, b, AT_REST, AT_REST);
    return number >= 0
        && inside_is_ok(w, world_set_gravity_scale(&w->world, number, scale));
}

double tumble_body_gravity_scale(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    return x ? w->world.body[x->piece[0].number].gravity : 0;
}
//<

//> face-lock
//>   Locked axes are a joint to the ground with a row for each of them, which no id
//>   stands for.
bool tumble_body_set_locked(tumble_world *w, tumble_body b, unsigned axes)
{
    int number = inside_rigid(w, b, AT_REST, AT_REST);
    if (number < 0) return false;
    body_place *x = inside_body(w, b);
    if (axes >= 2 * TUMBLE_LOCK_TURN_Z)
        return inside_fail(w, "axes 0x%x are none that can be locked", axes);
    if (axes > 0 && x->kind != TUMBLE_DYNAMIC)
        return inside_fail(w, "body %u is not dynamic: it goes nowhere by itself, "
                           "and no axis of it is locked", b.place);
    return inside_lock(w, x, axes);
}

unsigned tumble_body_locked(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    return x ? inside_locked(w, x) : 0;
}
//<

//> face-sensor
//>   A sensor is a body in no group. So no pair, no ray and no piece of cloth finds
//>   it, and nothing in the engine needs to know of it.
bool tumble_body_set_sensor(tumble_world *w, tumble_body b, bool is_sensor)
{
    body_place *x = inside_body(w, b);
    if (!x || x->is_sensor == is_sensor) return x != NULL;
    const body *first = &w->world.body[x->piece[0].number];
    if (x->mesh || body_is_soft(first))
        return inside_fail(w, "body %u is a surface, a rope or a cloth: no sensor",
                           b.place);
    if (is_sensor) {
        x->group = first->group;
        x->mask = first->mask;
    }
    x->is_sensor = is_sensor;
    for (int k = 0; k < x->pieces; k++)
        world_set_filter(&w->world, x->piece[k].number,
                         is_sensor ? 0 : x->group, is_sensor ? 0 : x->mask);
    return true;
}

bool tumble_body_is_sensor(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    return x && x->is_sensor;
}
//<
