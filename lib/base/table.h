//> table
//>   A world may get more bodies at any time, so its tables grow.
// table.h - arrays that grow with a world.
//
// Book: chapter 13.

#pragma once

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

// How many elements a table of `room` should have room for, when it needs
// `need`: at least twice as many as before, so that adding n of them, one by
// one, copies O(n).
static inline int table_room(int need, int room)
{
    if (need <= room) return room;
    return need > 2 * room ? need : 2 * room;
}

// Gives the array whose address is in *array (`array` is the address of a
// pointer to its elements) room for `room` elements of so many bytes.  The
// first `kept` stay, the others are zero.  False, changing nothing, if memory is
// refused.
static inline bool table_grow(void *array, int kept, int room, size_t size)
{
    size_t old = (size_t)kept * size, bytes = (size_t)room * size;
    void *was, *more;
    memcpy(&was, array, sizeof was);
    more = realloc(was, bytes > 0 ? bytes : 1);
    if (!more) return false;
    memset((char *)more + old, 0, bytes - old);
    memcpy(array, &more, sizeof more);
    return true;
}

// Memory that begins with a cache line, where the system has a call for that
// whose memory may be freed as any other; Windows has none.  Only speed depends
// on it: no type of tumble needs more than the 16 bytes of malloc.
static inline void *table_lines(size_t bytes)
{
    enum { LINE = 64 };
    size_t lines = (bytes + LINE - 1) / LINE;
    size_t whole = (lines > 0 ? lines : 1) * LINE;
#ifdef _WIN32
    return malloc(whole);
#else
    return aligned_alloc(LINE, whole);
#endif
}

// The same, in memory that begins with a cache line.
static inline bool table_grow_aligned(void *array, int kept, int room,
                                      size_t size)
{
    size_t old = (size_t)kept * size, bytes = (size_t)room * size;
    void *was, *more = table_lines(bytes);
    if (!more) return false;
    memcpy(&was, array, sizeof was);
    if (kept > 0) memcpy(more, was, old);
    memset((char *)more + old, 0, bytes - old);
    memcpy(array, &more, sizeof more);
    free(was);
    return true;
}

// Gives a list of so many room for one more, if it has none.
static inline bool table_add(void *array, int count, int *room, size_t size)
{
    int more = table_room(count + 1, *room);
    if (count < *room) return true;
    if (!table_grow(array, count, more, size)) return false;
    *room = more;
    return true;
}
#define TABLE_ADD(array, count, room) \
    table_add(&(array), (count), &(room), sizeof *(array))

// Gives it room for `need` elements, if it has less, and for some more, and keeps
// nothing; it is zero, for what is never set may be saved.  False, changing
// nothing, if memory is refused.
static inline bool table_renew(void *array, int *room, int need, size_t size)
{
    enum { MOST = 1 << 28 };
    void *was, *more;
    if (need <= *room) return true;
    if (need > MOST) return false;
    more = calloc((size_t)need + (size_t)need / 8 + 4, size);
    if (!more) return false;
    memcpy(&was, array, sizeof was);
    memcpy(array, &more, sizeof more);
    free(was);
    *room = need + need / 8 + 4;
    return true;
}
#define TABLE_RENEW(array, room, need) \
    table_renew(&(array), &(room), (need), sizeof *(array))

// One of several tables of one kind of thing: *ok is false, and stays so, if one
// of them found no memory.
#define TABLE_GROW(ok, array, kept, room) \
    ((ok) = (ok) && table_grow(&(array), (kept), (room), sizeof *(array)))
#define TABLE_GROW_ALIGNED(ok, array, kept, room)               \
    ((ok) = (ok) && table_grow_aligned(&(array), (kept), (room), \
                                       sizeof *(array)))
//<
