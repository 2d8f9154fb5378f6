//> slots
#include "slots.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

void slots_init(slots *s, size_t size)
{
    *s = (slots){ .size = size, .free = -1 };
}

void slots_free(slots *s)
{
    free(s->slot);
    free(s->thing);
    slots_init(s, s->size);
}

static bool reserve(slots *s)
{
    if (s->count < s->capacity) return true;
    if (s->capacity > INT_MAX / 2) return false;
    int more = s->capacity > 0 ? 2 * s->capacity : 16;
    slot *at = realloc(s->slot, (size_t)more * sizeof *at);
    if (at) s->slot = at;
    char *thing = realloc(s->thing, (size_t)more * s->size);
    if (thing) s->thing = thing;
    if (!at || !thing) return false;
    s->capacity = more;
    return true;
}

int slots_take(slots *s)
{
    int k = s->free;
    if (k >= 0) {
        s->free = s->slot[k].next_free;
    } else {
        if (!reserve(s)) return -1;
        k = s->count++;
        s->slot[k] = (slot){ .generation = 0 };
    }
    s->slot[k].generation++;
    memset(s->thing + (size_t)k * s->size, 0, s->size);
    return k;
}

void slots_give(slots *s, int k)
{
    assert(slots_is_taken(s, k));
    s->slot[k].generation++;
    if (s->slot[k].generation == UINT_MAX - 1) return;
    s->slot[k].next_free = s->free;
    s->free = k;
}

bool slots_is_taken(const slots *s, int k)
{
    return k >= 0 && k < s->count && s->slot[k].generation % 2 == 1;
}

unsigned slots_generation(const slots *s, int k)
{
    return s->slot[k].generation;
}

void *slots_at(const slots *s, int k)
{
    return slots_is_taken(s, k) ? s->thing + (size_t)k * s->size : NULL;
}

void *slots_find(const slots *s, unsigned place, unsigned generation)
{
    if (place > INT_MAX || !slots_is_taken(s, (int)place)) return NULL;
    if (s->slot[place].generation != generation) return NULL;
    return slots_at(s, (int)place);
}
//<
