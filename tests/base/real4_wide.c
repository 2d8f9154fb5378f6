// real4_wide.c - real4.h in one register, for check_real4.c, where the compiler and
// the processor have it.

#include "real4_run.h"

#if defined(__x86_64__) && defined(__GNUC__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx"))), apply_to = function)
#else
#pragma GCC target("avx")
#endif
#define TUMBLE_WIDE_REAL4
#define NAME real4_run_wide
#include "real4_forms.h"

#if defined(__clang__)
#pragma clang attribute pop
#endif

bool real4_has_wide(void)
{
    return __builtin_cpu_supports("avx");
}
#else
bool real4_has_wide(void)
{
    return false;
}

void real4_run_wide(int operation, const real_lanes *in, real out[2 * REAL4])
{
    real4_run_plain(operation, in, out);
}
#endif
