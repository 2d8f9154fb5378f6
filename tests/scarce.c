// scarce.c - the allocations of a test program, granted or refused.

#include "scarce.h"

#include <stddef.h>

int mallocs_left = INT_MAX;

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t size);

static int malloc_allowed(void)
{
    if (mallocs_left == INT_MAX) return 1;
    return mallocs_left > 0 ? mallocs_left-- : 0;
}

void *__wrap_malloc(size_t size)
{
    return malloc_allowed() ? __real_malloc(size) : NULL;
}

void *__wrap_calloc(size_t n, size_t size)
{
    return malloc_allowed() ? __real_calloc(n, size) : NULL;
}

void *__wrap_realloc(void *p, size_t size)
{
    return malloc_allowed() ? __real_realloc(p, size) : NULL;
}
