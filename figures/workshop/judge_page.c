// judge_page.c - stands between a reader's code and its tests where both run in a
// page: what Check and the sanitizers are on a desk (exercises/judge.c).
//
// The page calls page_list, which names the tests, and then page_run for each of them
// in a memory of its own.  What goes wrong is told to the page, which ends the test.

#include "judge.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define IMPORT(name) __attribute__((import_module("page"), import_name(#name)))

// Of these failed, asserted and undefined do not return.
IMPORT(test)      void page_test(const char *name, int from, int to);
IMPORT(failed)    void page_failed(const char *text);
IMPORT(asserted)  void page_asserted(const char *what, const char *file, int line);
IMPORT(undefined) void page_undefined(const char *kind, const char *file, int line);
IMPORT(tick)      void page_tick(void);
IMPORT(size)      int  page_size(const char *file);     // -1: there is no such file
IMPORT(read)      void page_read(char *to);             // that file

void page_list(void);
void page_run(int i);
char *page_room(void);       // for the name of a test

int judge_main(void);                   // the test program's main

// --- Check ------------------------------------------------------------------------
// A suite has one case, and the runner is the suite: nothing is kept but the case.
struct TCase { SFun set_up, tear_down; };
static TCase only;
static char name_asked[200];
static int  i_asked, is_listing;

Suite *suite_create(const char *name) { (void)name; return (Suite *)(void *)&only; }
TCase *tcase_create(const char *name) { (void)name; return &only; }
SRunner *srunner_create(Suite *s) { return (SRunner *)(void *)s; }
void suite_add_tcase(Suite *s, TCase *t) { (void)s; (void)t; }
void tcase_set_timeout(TCase *t, double seconds) { (void)t; (void)seconds; }
void srunner_run_all(SRunner *r, enum print_output how) { (void)r; (void)how; }
int srunner_ntests_failed(SRunner *r) { (void)r; return 0; }
void srunner_free(SRunner *r) { (void)r; }

void tcase_add_checked_fixture(TCase *t, SFun set_up, SFun tear_down)
{
    t->set_up = set_up;
    t->tear_down = tear_down;
}

static void search_for_leaks(void);

void _tcase_add_test(TCase *t, const TTest *test, int signal, int wanted,
                     int from, int to)
{
    (void)signal; (void)wanted;
    if (is_listing) page_test(test->name, from, to);
    if (is_listing || strcmp(test->name, name_asked) != 0) return;
    if (t->set_up) t->set_up();
    test->fn(i_asked);
    if (t->tear_down) t->tear_down();
    search_for_leaks();
}

void _ck_assert_failed(const char *file, int line, const char *expression,
                       const char *form, ...)
{
    static char text[1000];
    va_list rest;
    (void)file; (void)line;
    va_start(rest, form);
    if (form) vsnprintf(text, sizeof text, form, rest);
    else      snprintf(text, sizeof text, "%s", expression);
    va_end(rest);
    page_failed(text);
    __builtin_trap();
}

// A right answer may round otherwise than ours.  The page leaves out what LEAVE
// names on a desk.
int judge_wants(const char *name)
{
    return strcmp(name, "the_same_bits_everywhere") != 0;
}

void judge_trial(const char *name, void (*test)(int), int i)
{
    (void)name;
    test(i);
}

char *page_room(void) { return name_asked; }

void __wasm_call_ctors(void);           // the linker's: what stands before main

void page_list(void)
{
    __wasm_call_ctors();
    is_listing = 1;
    judge_main();
}

void page_run(int i)
{
    __wasm_call_ctors();
    i_asked = i;
    judge_main();
}

void __assert_fail(const char *what, const char *file, int line, const char *where)
{
    (void)where;
    page_asserted(what, file, line);
    __builtin_trap();
}

// --- Time -------------------------------------------------------------------------
// Called at every turn of every loop of the reader's code and of the tests.
void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    static unsigned turns;
    if ((++turns & 0x3fff) == 0) page_tick();
}

// --- Memory -----------------------------------------------------------------------
// The compiler keeps a shadow of all memory: of every 8 bytes it says how many may be
// touched, from the first on; 0 is all, and from GAP on none.  It marks what stands
// around arrays on the stack and around global ones.  Blocks stand one behind the
// other, with a gap between, and none is given out twice.
enum { GAP = 0xfa, FREED = 0xfd, EDGE = 16, FILLED = 4096 };
#define LIMIT 0x10000000u       // 256 MB, and there the shadow begins (compiler.js)
#define MOST  0x100000u         // blocks

typedef struct { size_t size; int is_held, is_found; } block;

extern unsigned char __heap_base, __global_base;
static unsigned char *const shadow = (unsigned char *)LIMIT;
static size_t end;              // of the blocks
static block **const blocks = (block **)(LIMIT / 8 * 9);
static size_t count;

static void mark(size_t at, size_t size, unsigned char how)
{
    for (size_t k = at / 8; k < (at + size) / 8; k++) shadow[k] = how;
    if (how == 0 && size % 8) shadow[(at + size) / 8] = (unsigned char)(size % 8);
}

static void *give(size_t alignment, size_t size)
{
    if (end == 0) end = ((size_t)&__heap_base + EDGE - 1) / EDGE * EDGE;
    size_t at = (end + sizeof(block) + EDGE + alignment - 1) / alignment * alignment;
    size_t next = (at + size + 2 * EDGE - 1) / EDGE * EDGE;
    if (size > LIMIT || next > LIMIT || count == MOST) return NULL;
    mark(end, next - end, GAP);
    mark(at, size, 0);
    block *b = (block *)(at - sizeof *b);
    *b = (block){ size, 1, 0 };
    blocks[count++] = b;
    end = next;
    return (void *)at;
}

// Some tests count what is asked for, and refuse it (tests/support/scarce.c): then
// their own functions stand before these.
void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void  __real_free(void *p);
#define IF_THERE __attribute__((weak))
IF_THERE void *__wrap_malloc(size_t size);
IF_THERE void *__wrap_calloc(size_t n, size_t size);
IF_THERE void *__wrap_realloc(void *p, size_t size);
IF_THERE void *__wrap_aligned_alloc(size_t alignment, size_t size);
IF_THERE void  __wrap_free(void *p);

void *malloc(size_t size) { return __wrap_malloc ? __wrap_malloc(size) : __real_malloc(size); }
void *calloc(size_t n, size_t size) { return __wrap_calloc ? __wrap_calloc(n, size) : __real_calloc(n, size); }
void *realloc(void *p, size_t size) { return __wrap_realloc ? __wrap_realloc(p, size) : __real_realloc(p, size); }
void *aligned_alloc(size_t alignment, size_t size)
{
    return __wrap_aligned_alloc ? __wrap_aligned_alloc(alignment, size) : __real_aligned_alloc(alignment, size);
}
void free(void *p)
{
    if (__wrap_free) __wrap_free(p);
    else             __real_free(p);
}

void *__real_malloc(size_t size)
{
    void *p = give(16, size);
    if (p) memset(p, 0xbe, size < FILLED ? size : FILLED);
    return p;
}

void *__real_calloc(size_t n, size_t size)
{
    return size && n > LIMIT / size ? NULL : give(16, n * size);
}

void *__real_aligned_alloc(size_t alignment, size_t size)
{
    return give(alignment < 16 ? 16 : alignment, size);
}

// The block in which that address lies, or behind which; NULL: there is none.
static block *block_at(size_t at)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if ((size_t)blocks[middle] <= at) low = middle + 1;
        else                              high = middle;
    }
    return low ? blocks[low - 1] : NULL;
}

void __real_free(void *p)
{
    if (!p) return;
    size_t at = (size_t)p;
    block *b = block_at(at);
    if (!b || (void *)(b + 1) != p) page_undefined("bad-free", NULL, 0);
    if (!b->is_held) page_undefined("double-free", NULL, 0);
    b->is_held = 0;
    mark(at, (b->size + 7) / 8 * 8, FREED);
}

void *__real_realloc(void *p, size_t size)
{
    if (!p) return __real_malloc(size);
    block *b = (block *)p - 1;
    void *q = __real_malloc(size);
    if (!q) return NULL;
    memcpy(q, p, b->size < size ? b->size : size);
    __real_free(p);
    return q;
}

// The C library's own names for them.
void *__libc_malloc(size_t size);
void *__libc_malloc(size_t size) { return __real_malloc(size); }
void *__libc_calloc(size_t n, size_t size);
void *__libc_calloc(size_t n, size_t size) { return __real_calloc(n, size); }
void __libc_free(void *p);
void __libc_free(void *p) { __real_free(p); }

// Marks the blocks that words from one address to another lead to.
static void find_from(size_t from, size_t to)
{
    for (size_t at = (from + 3) / 4 * 4; at + 4 <= to; at += 4) {
        size_t word = *(size_t *)at;
        if (word < (size_t)&__heap_base || word >= end) continue;
        block *b = block_at(word);
        if (!b || !b->is_held || b->is_found) continue;
        b->is_found = 1;
        find_from((size_t)(b + 1), (size_t)(b + 1) + b->size);
    }
}

// What is held, and nothing leads there any more, is lost.
static void search_for_leaks(void)
{
    static char text[30];
    size_t lost = 0;
    bool any = false;
    for (size_t k = 0; k < count; k++) any = any || blocks[k]->is_held;
    if (!any) return;
    find_from((size_t)&__global_base, (size_t)&__heap_base);
    for (size_t k = 0; k < count; k++)
        if (blocks[k]->is_held && !blocks[k]->is_found) lost += blocks[k]->size;
    if (!lost) return;
    snprintf(text, sizeof text, "leak %lu", (unsigned long)lost);
    page_undefined(text, NULL, 0);
}

// --- Files ------------------------------------------------------------------------
// Those that a test reads came with it, and stay where they are.
FILE *fopen(const char *restrict name, const char *restrict mode)
{
    static char *bytes;
    int size = page_size(name);
    bytes = size < 0 || mode[0] != 'r' ? NULL : __real_malloc((size_t)size);
    if (!bytes) return NULL;
    page_read(bytes);
    return fmemopen(bytes, (size_t)size, "r");
}

// --- What the compiler asks before the reader's code reads or writes -----------------
__attribute__((noinline)) static void touch_slowly(size_t at, size_t size, int is_write)
{
    size_t top = at + size, base = (size_t)&__heap_base;
    bool is_deep = (size_t)__builtin_frame_address(0) < FILLED;
    if (at < 1024) page_undefined(is_deep ? "stack" : "null", NULL, 0);
    size_t last = end > base ? end : base;
    if (at >= base && top > last && at < last + FILLED)
        page_undefined(is_write ? "writes outside" : "reads outside", NULL, 0);
    if (top < at || top > last) page_undefined("wild", NULL, 0);
    for (size_t k = at / 8; k <= (top - 1) / 8; k++) {
        unsigned char may = shadow[k];
        if (may == 0 || (may < 8 && top <= 8 * k + may)) continue;
        page_undefined(may == FREED ? is_write ? "writes after-free" : "reads after-free"
                       : is_write ? "writes outside" : "reads outside", NULL, 0);
    }
}

// Most are whole words in the stack or in a block.
static inline void touch(size_t at, size_t size, int is_write)
{
    bool is_word = size <= 8 && (at & 7) + size <= 8;
    size_t top = end ? end : (size_t)&__heap_base;
    if (is_word && at >= FILLED && at < top && shadow[at / 8] == 0) return;
    touch_slowly(at, size, is_write);
}

#define ASKED(size)                                                              \
    void __asan_load##size(size_t at);                                           \
    void __asan_load##size(size_t at) { touch(at, size, 0); }                    \
    void __asan_store##size(size_t at);                                          \
    void __asan_store##size(size_t at) { touch(at, size, 1); }
ASKED(1) ASKED(2) ASKED(4) ASKED(8) ASKED(16)
void __asan_loadN(size_t at, size_t size);
void __asan_loadN(size_t at, size_t size) { touch(at, size, 0); }
void __asan_storeN(size_t at, size_t size);
void __asan_storeN(size_t at, size_t size) { touch(at, size, 1); }
void *__asan_memcpy(void *to, const void *from, size_t size);
void *__asan_memcpy(void *to, const void *from, size_t size)
{
    if (size) touch((size_t)from, size, 0), touch((size_t)to, size, 1);
    return memcpy(to, from, size);
}
void *__asan_memmove(void *to, const void *from, size_t size);
void *__asan_memmove(void *to, const void *from, size_t size)
{
    if (size) touch((size_t)from, size, 0), touch((size_t)to, size, 1);
    return memmove(to, from, size);
}
void *__asan_memset(void *to, int what, size_t size);
void *__asan_memset(void *to, int what, size_t size)
{
    if (size) touch((size_t)to, size, 1);
    return memset(to, what, size);
}
// Its own calls at the beginning, and where a function does not return.
void __asan_init(void);
void __asan_init(void) { }
void __asan_version_mismatch_check_v8(void);
void __asan_version_mismatch_check_v8(void) { }
void __asan_handle_no_return(void);
void __asan_handle_no_return(void) { }

// Of arrays on the stack: so many bytes of the shadow from there on.
#define SHADED(how)                                                              \
    void __asan_set_shadow_##how(size_t at, size_t size);                        \
    void __asan_set_shadow_##how(size_t at, size_t size) { memset((void *)at, 0x##how, size); }
SHADED(00) SHADED(f1) SHADED(f2) SHADED(f3) SHADED(f5) SHADED(f8)
void __asan_alloca_poison(size_t at, size_t size);
void __asan_alloca_poison(size_t at, size_t size)
{
    mark(at - 32, 32, GAP);
    mark((at + size + 7) / 8 * 8, 32, GAP);
}
void __asan_allocas_unpoison(size_t top, size_t bottom);
void __asan_allocas_unpoison(size_t top, size_t bottom)
{
    if (top && bottom > top) memset(shadow + top / 8, 0, (bottom - top) / 8);
}

// Global ones: what stands behind each.
typedef struct { size_t at, size, with_gap; const void *rest[5]; } global;
void __asan_register_globals(const global *g, size_t n);
void __asan_register_globals(const global *g, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        size_t top = g[k].at + g[k].size;
        mark((top + 7) / 8 * 8, (g[k].at + g[k].with_gap) / 8 * 8 - (top + 7) / 8 * 8, GAP);
        if (top % 8) shadow[top / 8] = (unsigned char)(top % 8);
    }
}
void __asan_unregister_globals(const global *g, size_t n);
void __asan_unregister_globals(const global *g, size_t n) { (void)g; (void)n; }

// What C leaves undefined: all that is told begins with its place.
typedef struct { const char *file; unsigned line, column; } place;

// A pointer that is null, or odd where its type is not, or with too little behind it.
typedef struct { place at; const void *type; unsigned char alignment, how; } mismatch;
void __ubsan_handle_type_mismatch_v1_abort(const mismatch *m, size_t to);
void __ubsan_handle_type_mismatch_v1_abort(const mismatch *m, size_t to)
{
    size_t odd = to & (((size_t)1 << m->alignment) - 1);
    page_undefined(to == 0 ? "null" : odd ? "misaligned" : "out_of_bounds_abort",
                   m->at.file, (int)m->at.line);
}

#define TOLD(name) { (void)a; page_undefined(#name, at->file, (int)at->line); }
#define UNDEFINED1(name)                                                         \
    void __ubsan_handle_##name(const place *at);                                 \
    void __ubsan_handle_##name(const place *at) { const int a = 0; TOLD(name) }
#define UNDEFINED2(name)                                                         \
    void __ubsan_handle_##name(const place *at, size_t a);                       \
    void __ubsan_handle_##name(const place *at, size_t a) TOLD(name)
#define UNDEFINED3(name)                                                         \
    void __ubsan_handle_##name(const place *at, size_t a, size_t b);             \
    void __ubsan_handle_##name(const place *at, size_t a, size_t b)              \
    { (void)b; TOLD(name) }
UNDEFINED3(add_overflow_abort)
UNDEFINED3(sub_overflow_abort)
UNDEFINED3(mul_overflow_abort)
UNDEFINED3(divrem_overflow_abort)
UNDEFINED2(negate_overflow_abort)
UNDEFINED3(shift_out_of_bounds_abort)
UNDEFINED3(pointer_overflow_abort)
UNDEFINED2(out_of_bounds_abort)
UNDEFINED2(load_invalid_value_abort)
UNDEFINED2(vla_bound_not_positive_abort)
UNDEFINED1(nonnull_arg_abort)
UNDEFINED1(invalid_builtin_abort)
UNDEFINED1(builtin_unreachable)
