//> scene-lists
//>   A scene grows as it is added to, and owns what it is given.
// scene.c - see scene.h.
#include "scene.h"

#include <assert.h>
#include <stdlib.h>

void scene_init(scene *s)
{
    *s = (scene){ .size = 0 };
}

void scene_free(scene *s)
{
    for (int k = 0; k < s->shapes; k++) shape_free(&s->shape[k]);
    for (int k = 0; k < s->bodies; k++) free(s->body[k].start);
    free(s->shape);
    free(s->body);
    free(s->plane);
    free(s->pin);
    scene_init(s);
}

// The list with room for one more than count; NULL if memory is refused, and
// then the old one stands.  A list is full when it holds a power of two, and
// doubles: adding n copies O(n) of them.
static void *grown(void *list, int count, size_t size)
{
    if (count & (count - 1)) return list;
    return realloc(list, (size_t)(count > 0 ? 2 * count : 1) * size);
}
//<

//> scene-add
//>   What is added is checked first. A body on axes that are not perpendicular
//>   would be bent from its first moment on; a body too far from the origin
//>   would have no digits left for its sticks.
status scene_add_shape(scene *s, shape *moved)
{
    shape *more = grown(s->shape, s->shapes, sizeof *more);
    if (!more) return status_out_of_memory();
    s->shape = more;
    s->shape[s->shapes++] = *moved;
    *moved = (shape){ .particles = 0 };
    return status_ok();
}

static bool is_sound(const placement *p)
{
    return vec3_is_finite(p->position) && vec3_is_finite(p->velocity)
        && vec3_is_finite(p->spin)
        && vec3_distance(vec3_cross(p->x, p->y), p->z) < 1e-6
        && fabs(vec3_length(p->x) - 1) < 1e-6
        && fabs(vec3_length(p->y) - 1) < 1e-6
        && fabs(vec3_dot(p->x, p->y)) < 1e-6;
}

status placement_check(const placement *p, const shape *s, int body)
{
    if (!is_sound(p))
        return status_fail("body %d is placed at numbers that are not finite, "
                           "or on axes that are not perpendicular units", body);
    real away = vec3_length(p->position);
    if (s->spacing > 0 && away > MOST_AWAY * s->spacing)
        return status_fail("body %d is placed %.3g m from the origin: for a "
                           "stick of %.3g m the numbers there are too coarse",
                           body, away, s->spacing);
    return status_ok();
}

status scene_add(scene *s, int shape_number, placement where)
{
    assert(shape_number >= 0 && shape_number < s->shapes);
    status done = placement_check(&where, &s->shape[shape_number], s->bodies);
    if (!done.ok) return done;
    scene_body *more = grown(s->body, s->bodies, sizeof *more);
    if (!more) return status_out_of_memory();
    s->body = more;
    s->body[s->bodies++] = (scene_body){ shape_number, where, NULL };
    return status_ok();
}

status scene_add_plane(scene *s, vec3 normal, real offset)
{
    real length = vec3_length(normal), away = offset / length;
    if (!(length > 0) || !(length < HUGE_VAL) || !(away - away == 0))
        return status_fail("plane %d has no finite normal and offset",
                           s->planes);
    plane *more = grown(s->plane, s->planes, sizeof *more);
    if (!more) return status_out_of_memory();
    s->plane = more;
    s->plane[s->planes++] = (plane){ vec3_scale(1 / length, normal), away };
    return status_ok();
}

status scene_add_pin(scene *s, int body, int pinned)
{
    assert(body >= 0 && body < s->bodies);
    assert(pinned >= 0 && pinned < scene_shape(s, body)->particles);
    scene_pin *more = grown(s->pin, s->pins, sizeof *more);
    if (!more) return status_out_of_memory();
    s->pin = more;
    s->pin[s->pins++] = (scene_pin){ body, pinned };
    return status_ok();
}
//<

//> scene-read
//>   A scene is built from a description.
placement placement_at(vec3 position)
{
    return (placement){ .position = position, .x = { 1, 0, 0 },
                        .y = { 0, 1, 0 }, .z = { 0, 0, 1 } };
}

const shape *scene_shape(const scene *s, int body)
{
    return &s->shape[s->body[body].shape];
}

// From the body's origin to its particle i, along the world's axes.
static vec3 arm(const scene *s, int body, int i)
{
    const placement *p = &s->body[body].where;
    vec3 at = scene_shape(s, body)->at[i];
    return vec3_add(vec3_add(vec3_scale(at.x, p->x), vec3_scale(at.y, p->y)),
                    vec3_scale(at.z, p->z));
}

vec3 scene_position(const scene *s, int body, int i)
{
    const scene_body *b = &s->body[body];
    if (b->start) return b->start[i];
    return vec3_add(b->where.position, arm(s, body, i));
}

// v + spin x arm.
vec3 scene_velocity(const scene *s, int body, int i)
{
    const scene_body *b = &s->body[body];
    if (b->start || b->where.is_static) return vec3_make(0, 0, 0);
    return vec3_add(b->where.velocity,
                    vec3_cross(b->where.spin, arm(s, body, i)));
}
//<
