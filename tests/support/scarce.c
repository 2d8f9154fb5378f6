// scarce.c - the allocations of a test program: counted, granted or refused.

#include "scarce.h"

#include <stddef.h>

int  mallocs_left = INT_MAX;
long mallocs_made, blocks_held;

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void  __real_free(void *p);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void  __wrap_free(void *p);

static int is_granted(void)
{
    mallocs_made++;
    if (mallocs_left == INT_MAX) return 1;
    return mallocs_left > 0 ? mallocs_left-- : 0;
}

static void *counted(void *p)
{
    blocks_held += p != NULL;
    return p;
}

void *__wrap_malloc(size_t size)
{
    return is_granted() ? counted(__real_malloc(size)) : NULL;
}

void *__wrap_calloc(size_t n, size_t size)
{
    return is_granted() ? counted(__real_calloc(n, size)) : NULL;
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return is_granted() ? counted(__real_aligned_alloc(alignment, size)) : NULL;
}

void *__wrap_realloc(void *p, size_t size)
{
    if (!is_granted()) return NULL;
    void *q = __real_realloc(p, size);
    blocks_held += p == NULL && q != NULL;
    return q;
}

void __wrap_free(void *p)
{
    blocks_held -= p != NULL;
    __real_free(p);
}
