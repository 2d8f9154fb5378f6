//> loop
// loop.c - a game loop: steps of one length, pictures at any time.
//   cc loop.c -ltumble -lm

#include "tumble.h"

#include <math.h>
#include <stdio.h>

static const double DT = 1.0 / 60, UP = 12, SPIN = 6, GRAVITY = 9.81;

// s, that a picture took.  A game asks a clock; here it is by chance from 1/144
// to 1/20, and once a file is read meanwhile.
static double picture_took(int k)
{
    static unsigned dice = 1;
    const double least = 1.0 / 144, most = 1.0 / 20;
    dice = 1664525 * dice + 1013904223;
    return k == 40 ? 0.5 : least + (most - least) * (dice >> 8) / (1 << 24);
}

static double mix(double a, double b, double part)
{
    return a + part * (b - a);
}

// From one rotation to another, the shorter way: q and -q are the same.  A step
// turns by little, so a straight line will do, made a unit long again.
static tumble_quat mix_turn(tumble_quat a, tumble_quat b, double part)
{
    double s = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
    tumble_quat q = { mix(a.x, s * b.x, part), mix(a.y, s * b.y, part),
                      mix(a.z, s * b.z, part), mix(a.w, s * b.w, part) };
    double r = sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    tumble_quat unit = { q.x / r, q.y / r, q.z / r, q.w / r };
    return unit;
}

static tumble_pose mix_pose(tumble_pose a, tumble_pose b, double part)
{
    tumble_vec3 p = a.position, q = b.position;
    tumble_pose m = { { mix(p.x, q.x, part), mix(p.y, q.y, part),
                        mix(p.z, q.z, part) },
                      mix_turn(a.rotation, b.rotation, part) };
    return m;
}

int main(void)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.velocity.y = UP;
    o.spin.z = SPIN;
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.1, 1), o);
    tumble_pose before = tumble_body_pose(w, b), after = before;
    double owed = 0, mixed = 0, plain = 0, turned = 0;      // s, m, m, rad
    for (int k = 0; tumble_world_time(w) < 2; k++) {
        owed += fmin(picture_took(k), 0.25);    // a game that stood still waits
        for (; owed >= DT; owed -= DT) {
            before = after;
            tumble_world_step(w);
            after = tumble_body_pose(w, b);
        }
        tumble_pose drawn = mix_pose(before, after, owed / DT);
        // What is drawn is the world as it was a step ago.
        double t = tumble_world_time(w) + owed - DT,
               y = UP * t - GRAVITY * t * t / 2;
        tumble_quat q = drawn.rotation;
        tumble_quat is = tumble_quat_turn(tumble_v(0, 0, 1), SPIN * t);
        if (t < 0) continue;
        mixed = fmax(mixed, fabs(drawn.position.y - y));
        plain = fmax(plain, fabs(after.position.y - y));
        turned = fmax(turned, 2 * fabs(q.z * is.w - q.w * is.z));
    }
    tumble_world_free(w);
    printf("drawn within %.3f mm and %.1e rad of where it is; without mixing,"
           " %.0f mm\n", 1000 * mixed, turned, 1000 * plain);
    return !(mixed <= 1.001 * GRAVITY * DT * DT / 8 && turned < 1e-4);
}
//<
