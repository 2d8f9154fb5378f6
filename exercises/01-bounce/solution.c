// solution.c - parabolas, and a geometric series.

#include "bounce.h"

// More bounces than this are no longer seen: 0.999^10,000 is 5e-5.
enum { BOUNCES_MAX = 10000 };

static ball fly(ball b, real g, real t)
{
    return (ball){ b.height + b.speed * t - g * t * t / 2, b.speed - g * t };
}

// From the floor, upwards with this speed, for `left` seconds.  One flight
// takes 2 speed / g, and each after it e times as long.
static ball bounce_on(real speed, real g, real e, real left)
{
    real flight = 2 * speed / g;
    // All flights together: flight / (1 - e).
    if (!(flight > 0) || left * (1 - e) >= flight) return (ball){ 0, 0 };
    if (e == 1) left = fmod(left, flight);
    for (int k = 0; k < BOUNCES_MAX; k++) {
        if (left < flight) return fly((ball){ 0, speed }, g, left);
        left -= flight;
        speed *= e;
        flight *= e;
    }
    return (ball){ 0, 0 };
}

ball ball_step(ball b, real g, real e, real dt)
{
    real landing = sqrt(b.speed * b.speed + 2 * g * b.height);
    real fall = (b.speed + landing) / g;
    if (dt < fall) return fly(b, g, dt);
    return bounce_on(e * landing, g, e, dt - fall);
}
