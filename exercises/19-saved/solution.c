// solution.c - one list for both directions, and a sum at the end.

#include "saved.h"

#include <string.h>

static const unsigned long long FIRST_SUM = 14695981039346656037ULL;

void saved_bytes(archive *f, void *what, size_t size)
{
    if (f->failed || size > f->size - f->at) {
        f->failed = true;
        return;
    }
    if (f->reads) memcpy(what, f->bytes + f->at, size);
    else memcpy(f->bytes + f->at, what, size);
    for (size_t i = 0; i < size; i++) {
        f->sum ^= f->bytes[f->at + i];
        f->sum *= 1099511628211ULL;
    }
    f->at += size;
}

void world_parts(archive *f, small_world *w)
{
    int version = SAVED_VERSION;
    saved_bytes(f, &version, sizeof version);
    if (version != SAVED_VERSION) f->failed = true;
    saved_bytes(f, &w->gravity, sizeof w->gravity);
    saved_bytes(f, &w->time, sizeof w->time);
    saved_bytes(f, &w->count, sizeof w->count);
    if (w->count < 0 || w->count > BALLS) f->failed = true;
    if (f->failed) return;
    saved_bytes(f, w->balls, (size_t)w->count * sizeof w->balls[0]);
}

size_t world_save(const small_world *w, unsigned char *bytes, size_t room)
{
    small_world copy = *w;
    archive f = { .bytes = bytes, .size = room, .sum = FIRST_SUM };
    world_parts(&f, &copy);
    unsigned long long sum = f.sum;
    saved_bytes(&f, &sum, sizeof sum);
    return f.failed ? 0 : f.at;
}

// The bytes are only read.
bool world_load(small_world *w, const unsigned char *bytes, size_t size)
{
    small_world read = { .count = 0 };
    archive f = { .bytes = (unsigned char *)bytes, .size = size, .reads = true, .sum = FIRST_SUM };
    unsigned long long wanted = 0;
    world_parts(&f, &read);
    unsigned long long sum = f.sum;
    saved_bytes(&f, &wanted, sizeof wanted);
    if (f.failed || sum != wanted || f.at != size) return false;
    *w = read;
    return true;
}
