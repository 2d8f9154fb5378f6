// mended.h - what some systems' C has otherwise than the standard: it is read
// before all sources there.  tumble.c has it at its beginning.
#if defined(__MINGW32__) && defined(__SSE2__)
// The sqrt of mingw-w64 rounds twice, to 64 and to 53 bits: of a million numbers
// 234 are not the nearest.  The processor's rounds once.
#include <emmintrin.h>
#include <math.h>
static inline double sqrt_rounded_once(double x)
{
    __m128d v = _mm_set_sd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(v, v));
}
#define sqrt sqrt_rounded_once
#endif
#if defined(_MSC_VER)
// Microsoft's C has no max_align_t, or one of 8 bytes, though its calloc gives 16.
#include <stddef.h>
typedef struct { _Alignas(16) char byte[16]; } tumble_most_aligned;
#define max_align_t tumble_most_aligned
#define _Thread_local __declspec(thread)
#endif
