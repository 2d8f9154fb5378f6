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
