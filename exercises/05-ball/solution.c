// solution.c - outside it is cutting, inside it is looking for the least room.

#include "ball.h"

static real cut(real x, real half)
{
    if (x > half) return half;
    return x < -half ? -half : x;
}

// The centre is inside.  Its room along an axis is the way to the nearer of two
// faces; the least of three rooms is the way out.
static ball_contact face_nearest(vec3 half, vec3 centre, real radius)
{
    real room[3] = { half.x - fabs(centre.x), half.y - fabs(centre.y),
                     half.z - fabs(centre.z) };
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (room[k] < room[axis]) axis = k;

    ball_contact c = { -room[axis] - radius, { 0, 0, 0 }, centre };
    real *way[3] = { &c.normal.x, &c.normal.y, &c.normal.z };
    real *on[3] = { &c.on_box.x, &c.on_box.y, &c.on_box.z };
    real side = *on[axis] >= 0 ? 1 : -1;
    *way[axis] = side;
    *on[axis] += side * room[axis];
    return c;
}

ball_contact ball_meets_box(vec3 half, vec3 centre, real radius)
{
    vec3 nearest = { cut(centre.x, half.x), cut(centre.y, half.y),
                     cut(centre.z, half.z) };
    vec3 away = vec3_sub(centre, nearest);
    real distance = vec3_length(away);
    if (!(distance > 0)) return face_nearest(half, centre, radius);
    return (ball_contact){ distance - radius, vec3_scale(1 / distance, away),
                           nearest };
}
