//> rollouts
// rollouts.c - two thousand futures of one world: which throw goes furthest?
//   cc rollouts.c -ltumble -lm -lpthread

#include "tumble.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROLLOUTS = 2000, THREADS = 2 };
static const double SPEED = 10, GRAVITY = 9.81;         // m/s, m/s^2
static tumble_body ball;
static void *bytes;                     // of the world before the throw
static size_t size;
static double reached[ROLLOUTS];        // m

static double angle_of(int k)           // rad
{
    return acos(-1) / 2 * (k + 0.5) / ROLLOUTS;
}

// The same world again, and a throw, until the ball is as low as it began.
static double roll_out(double angle)
{
    tumble_world *w = tumble_world_load(bytes, size);
    tumble_vec3 at = tumble_body_position(w, ball), before;
    tumble_body_set_velocity(w, ball, tumble_v(SPEED * cos(angle),
                                               SPEED * sin(angle), 0),
                             tumble_v(0, 0, 0));
    do {
        before = at;
        tumble_world_step(w);
        at = tumble_body_position(w, ball);
    } while (at.y > 0);
    tumble_world_free(w);
    return before.x + (at.x - before.x) * before.y / (before.y - at.y);
}

// A world is used by one thread at a time, and each rollout has its own.
static void *work(void *first)
{
    for (int k = *(int *)first; k < ROLLOUTS; k += THREADS)
        reached[k] = roll_out(angle_of(k));
    return NULL;
}

int main(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ball = tumble_body_add(w, tumble_shape_sphere(w, 0.1, 1),
                           tumble_body_at(0, 0, 0));
    size = tumble_world_save(w, NULL, 0);
    bytes = malloc(size);
    tumble_world_save(w, bytes, size);
    tumble_world_free(w);
    pthread_t thread[THREADS];
    int first[THREADS], best = 0;
    for (int k = 0; k < THREADS; k++) {
        first[k] = k;
        if (pthread_create(&thread[k], NULL, work, &first[k])) return 1;
    }
    for (int k = 0; k < THREADS; k++) pthread_join(thread[k], NULL);
    for (int k = 0; k < ROLLOUTS; k++) if (reached[k] > reached[best]) best = k;
    double angle = angle_of(best), law = SPEED * SPEED / GRAVITY;
    printf("the best of %d: %.3f rad, %.4f m far; v^2 / g is %.4f m\n",
           ROLLOUTS, angle, reached[best], law);
    free(bytes);
    return !(fabs(reached[best] / law - 1) < 1e-3 &&
             fabs(angle - acos(-1) / 4) < 0.01);
}
//<
