// live_wasm.c - what only the browser's build has: an assertion that tells the
// page its sentence, and a limit for loops that never end.

#include "live_page.h"

#include <assert.h>
#include <string.h>

__attribute__((import_module("page"), import_name("failed")))
void page_failed(const char *what, const char *file, int line, const char *where);

__attribute__((import_module("page"), import_name("endless")))
void page_endless(void);

// The C library's own would print, and bring all of printf along.
void __assert_fail(const char *what, const char *file, int line, const char *where)
{
    page_failed(what, file, line, where);
    __builtin_trap();
}

// A reader's module (MINE=) is compiled so that it calls this at every turn of
// every loop.  The page fills it up before each frame.
static long long fuel;

PAGE(fuel) void page_fuel(double turns);
void page_fuel(double turns)
{
    fuel = (long long)turns;
}

__attribute__((no_sanitize("coverage"))) void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    if (--fuel >= 0) return;
    page_endless();
    __builtin_trap();
}
