//> passes-wide
//>   The same lines once more, for processors that have AVX: four numbers are one
//>   register there. A processor says which it is, so one library runs anywhere.
#include <stddef.h>

#if defined(__x86_64__) && defined(__GNUC__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx"))), apply_to = function)
#else
#pragma GCC target("avx")
#endif
#define TUMBLE_WIDE_REAL4
#define PASSES passes_wide
#include "passes.c"
#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif
//<
