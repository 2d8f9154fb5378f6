// saved.h - a small world, and the bytes that hold it.

#ifndef TUMBLE_SAVED_H
#define TUMBLE_SAVED_H

#include "vec3.h"

#include <stddef.h>

enum { BALLS = 20, SAVED_VERSION = 3 };

typedef struct {
    vec3 position, velocity;    // m, m/s
    real inverse_mass;          // 1/kg
} ball;

typedef struct {
    vec3 gravity;               // m/s^2
    real time;                  // s
    int  count;                 // of balls
    ball balls[BALLS];
} small_world;

typedef struct {
    unsigned char *bytes;
    size_t size, at;            // of the buffer; of the next byte
    bool reads;                 // or writes
    bool failed;                // once, and for good
    unsigned long long sum;     // FNV-1a of all bytes so far
} archive;

// Writes or reads the next so many bytes; if they do not fit, or something has
// failed before, it copies nothing, and `failed` is true.
void saved_bytes(archive *f, void *what, size_t size);

// All that a world consists of, the version before it.
void world_parts(archive *f, small_world *w);

// Returns the number of bytes written, with the eight of the sum at the end; 0 if
// there is no room for them.
size_t world_save(const small_world *w, unsigned char *bytes, size_t room);

// Returns true if the bytes are a world of this version, whole and unharmed.  If
// not, *w is what it was.
bool world_load(small_world *w, const unsigned char *bytes, size_t size);

#endif
