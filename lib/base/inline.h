//> inline
//>   Much of what such a loop decides is known when its caller is compiled. Put
//>   into the caller, the loop loses these branches.
// inline.h - what a compiler makes a part of every caller, and what of none.
//
// Book: chapter 12.

#pragma once

#ifdef __GNUC__
#define ALWAYS_INLINE static inline __attribute__((always_inline))
#define NEVER_INLINE  static __attribute__((noinline))
#else
#define ALWAYS_INLINE static inline
#define NEVER_INLINE  static
#endif
//<
