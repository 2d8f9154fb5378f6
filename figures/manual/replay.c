//> replay
// replay.c - two players over a network see the same bits.  Pushes come late:
// then the client goes back, and plays those steps again.
//   cc replay.c -ltumble -lm

#include "tumble.h"

#include <stdio.h>
#include <stdlib.h>

enum { BOXES = 60, STEPS = 300, JOINS = 100, EVERY = 25, LATE = 6 };
static tumble_body box[BOXES];

// A world in bytes, for a file or a wire.
typedef struct { void *bytes; size_t size; } saved;

static saved save(const tumble_world *w)
{
    saved s = { NULL, tumble_world_save(w, NULL, 0) };
    s.bytes = malloc(s.size);
    if (s.bytes) tumble_world_save(w, s.bytes, s.size);
    return s;
}

static tumble_world *build(void)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape s = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 5);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < BOXES; k++)
        box[k] = tumble_body_add(w, s, tumble_body_at(0.6 * (k % 4),
                                                      0.3 + 0.6 * (k / 16),
                                                      0.6 * (k / 4 % 4)));
    return w;
}

// What the player at the server does at the beginning of a step.
static void play(tumble_world *w, int step)
{
    tumble_body b = box[7 * step % BOXES];
    if (step % EVERY == 0)
        tumble_body_push(w, b, tumble_v(10, 20, -5),
                         tumble_body_position(w, b));
}

// The client did not know of a push that was made LATE steps ago: from what it
// saved then it goes on again, with the push.
static tumble_world *go_back(tumble_world *w, saved then, int step)
{
    tumble_world_free(w);
    w = tumble_world_load(then.bytes, then.size);
    for (int k = step - LATE; k < step; k++) {
        play(w, k);
        tumble_world_step(w);
    }
    return w;
}

int main(void)
{
    tumble_world *server = build(), *client = NULL;
    saved then = { NULL, 0 };
    int apart = 0, wrong = 0;           // steps
    for (int step = 0; step < STEPS; step++) {
        int since = step % EVERY;       // steps, the last push
        if (step >= JOINS && since == 0) {
            free(then.bytes);
            then = save(client ? client : server);
            if (!client) client = tumble_world_load(then.bytes, then.size);
        }
        if (client && since == LATE) client = go_back(client, then, step);
        play(server, step);
        tumble_world_step(server);
        if (!client) continue;
        tumble_world_step(client);
        bool same = tumble_world_hash(client) == tumble_world_hash(server);
        if (since < LATE) apart += !same;
        else wrong += !same;
    }
    printf("%d steps were apart until the push came, %d after it; "
           "a world is %zu bytes\n", apart, wrong, then.size);
    bool good = client && !tumble_world_failure(server)
        && !tumble_world_failure(client);
    tumble_world_free(server);
    tumble_world_free(client);
    free(then.bytes);
    return !(good && apart == LATE * (STEPS - JOINS) / EVERY && wrong == 0);
}
//<
