// fuzz.h - what the four fuzz targets share: bytes, taken as numbers.
//
// A fuzzer (libFuzzer, of clang) calls a target millions of times with bytes
// that it varies until something breaks or new code is reached.  Plain bytes
// would seldom be an interesting number: here most of them are.

#ifndef TUMBLE_FUZZ_H
#define TUMBLE_FUZZ_H

#include "vec3.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Called by libFuzzer; returns 0.
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// Ends the run, and has the bytes kept, if what must hold does not.
#define MUST(holds, ...) \
    do { \
        if (holds) break; \
        fprintf(stderr, "%s:%d: %s: ", __FILE__, __LINE__, #holds); \
        fprintf(stderr, __VA_ARGS__); \
        fputc('\n', stderr); \
        abort(); \
    } while (0)

// What is left of them, and the number taken last.
typedef struct {
    const uint8_t *at;
    size_t left;
    real last;
} bytes;

// 0 when none is left.
static inline int take_byte(bytes *b)
{
    if (b->left == 0) return 0;
    b->left--;
    return *b->at++;
}

// From least to most.
static inline int take_count(bytes *b, int least, int most)
{
    return least + take_byte(b) % (most - least + 1);
}

// Four bytes or eight as they are.
static inline void take_raw(bytes *b, void *to, size_t size)
{
    uint8_t raw[8] = { 0 };
    for (size_t i = 0; i < size; i++) raw[i] = (uint8_t)take_byte(b);
    memcpy(to, raw, size);
}

// A number: small and round, the last again or next to it, far off, or what
// sums and products go wrong with.
static inline real take_real(bytes *b)
{
    static const real odd[16] = {
        0, -0.0, 1, -1, 1e300, -1e300, 1e-300, -1e-300, 0x1p-1022, 0x1p-1074,
        0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023, 0x1.0000000000001p0,
        (real)NAN, (real)INFINITY, -(real)INFINITY
    };
    int kind = take_byte(b), small = take_byte(b) - 128;
    switch (kind % 8) {
    case 0: case 1: case 2: b->last = small / 4.0; break;
    case 3: b->last += b->last * small * 0x1p-52; break;
    case 4: b->last = ldexp(small, 8 * (take_byte(b) - 128)); break;
    case 5: b->last = odd[small & 15]; break;
    case 6: take_raw(b, &b->last, sizeof b->last); break;
    default: break;
    }
    return b->last;
}

static inline vec3 take_vec3(bytes *b)
{
    real x = take_real(b), y = take_real(b), z = take_real(b);
    return vec3_make(x, y, z);
}

#endif
