// printed.c - stands in the place of printf (-Dprintf=printf_noted) in a stage of the
// little program: what is printed is the same, and the bits of every number with a
// point join a hash.  So two programs of the same hash have computed the same, whatever
// they round to when they print.

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int printf_noted(const char *form, ...);

static unsigned long long hash = 0xcbf29ce484222325ULL;

static void note(double x)
{
    unsigned char bytes[sizeof x];
    memcpy(bytes, &x, sizeof x);
    for (size_t k = 0; k < sizeof x; k++) hash = (hash ^ bytes[k]) * 0x100000001b3ULL;
}

// Takes what a conversion takes: its widths, and its value.
static const char *take(const char *at, va_list *rest)
{
    int longs = 0;
    for (; *at && strchr("-+ #0123456789.*lhz", *at); at++) {
        if (*at == '*') (void)va_arg(*rest, int);
        longs += *at == 'l' || *at == 'z';
    }
    switch (*at) {
    case 'e': case 'f': case 'g': case 'a': note(va_arg(*rest, double)); break;
    case 's': case 'p': (void)va_arg(*rest, void *); break;
    case '%': break;
    default:
        if (longs > 1)  (void)va_arg(*rest, long long);
        else if (longs) (void)va_arg(*rest, long);
        else            (void)va_arg(*rest, int);
    }
    return *at ? at + 1 : at;
}

int printf_noted(const char *form, ...)
{
    va_list rest, same;
    va_start(rest, form);
    va_copy(same, rest);
    for (const char *at = form; *at;) at = *at == '%' ? take(at + 1, &rest) : at + 1;
    int printed = vprintf(form, same);
    va_end(same);
    va_end(rest);
    return printed;
}

#ifdef __wasm__
// In the page: main is called by its own name, with the argument `draw` or without.
__attribute__((import_module("page"), import_name("tick"))) void page_tick(void);
__attribute__((weak)) int __main_void(void);
__attribute__((weak)) int __main_argc_argv(int count, char **arguments);
void page_begin(int draws);
unsigned long long page_hash(void);

void page_begin(int draws)
{
    char *arguments[] = { "little", "draw", NULL };
    if (!draws) arguments[1] = NULL;
    if (__main_argc_argv) __main_argc_argv(1 + draws, arguments);
    else if (__main_void) __main_void();
    fflush(stdout);
}

unsigned long long page_hash(void) { return hash; }

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    static unsigned turns;
    if ((++turns & 0x3ffff) == 0) page_tick();
}
#else
// At the desk: the hash stands below all that was printed.
__attribute__((destructor)) static void say_hash(void)
{
    fprintf(stderr, "%016llx\n", hash);
}
#endif
