// view.c - see view.h.

#include "view.h"

static real scale = 1, cosine = 1, sine = 0;
static vec3 from, to;

void view_look(vec3 eye, vec3 target, bool has_floor)
{
    const live_camera_plan camera = VIEW_CAMERA;
    vec3 way = vec3_sub(eye, target), flat = vec3_unit(vec3_make(way.x, 0, way.z));
    real s = sin(camera.turn), c = cos(camera.turn);
    scale = 0.85 * camera.distance / vec3_length(way);
    cosine = c * flat.z + s * flat.x;
    sine = s * flat.z - c * flat.x;
    from = has_floor ? vec3_make(target.x, 0, target.z) : target;
    to = vec3_make(0, has_floor ? 0 : 1.1, 0);
}

real view_scale(void)
{
    return scale;
}

vec3 view_turn(vec3 v)
{
    return vec3_scale(scale, vec3_make(cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x));
}

vec3 view_turn_back(vec3 v)
{
    return vec3_scale(1 / scale, vec3_make(cosine * v.x - sine * v.z, v.y, cosine * v.z + sine * v.x));
}

vec3 view_of(vec3 place)
{
    return vec3_add(to, view_turn(vec3_sub(place, from)));
}

vec3 view_back(vec3 place)
{
    return vec3_add(from, view_turn_back(vec3_sub(place, to)));
}
