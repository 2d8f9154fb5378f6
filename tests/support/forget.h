// forget.h - a cache that knows no past.

#ifndef TUMBLE_FORGET_H
#define TUMBLE_FORGET_H

#include "cache.h"

// Everything that is kept is forgotten: the next frame asks all.  With this
// before every frame contacts know no past: the oracle.
static inline void cache_clear(contact_cache *c)
{
    for (int b = 0; b < c->room; b++) cache_forget(c, &b, 1);
}

#endif
