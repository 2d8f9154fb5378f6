// events.h - touching that begins, and touching that ends.

#ifndef TUMBLE_EVENTS_OF_TOUCHING_H
#define TUMBLE_EVENTS_OF_TOUCHING_H

#include "vec3.h"

typedef struct {
    unsigned long long a, b;    // ids of two bodies
} id_pair;

typedef struct {
    id_pair pair;
    bool    began;              // or ended
} event;

// Sorts the pairs in place, each with the smaller id first, and once; a pair of
// one id with itself goes.  Returns how many are left.
int pairs_tidy(id_pair *p, int count);

// Of two tidy lists, what is in one of them alone, in ascending order.  Writes up
// to `room` events, and returns how many there are, which may be more.
int events_between(const id_pair *before, int olds, const id_pair *now, int news,
                   event *out, int room);

#endif
