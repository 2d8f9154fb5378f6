//> store-head
// store.h - memory turned into bytes, and bytes into memory, by the same lines.
//
// Book: chapter 19.
// Who lists what there is to store says `this table, so many elements` once: on
// the way out its elements are copied to the bytes, on the way back it is
// allocated and filled.  What follows a failure does nothing.
//
// Numbers lie in the bytes as in memory: they are good for the same version of
// the library on the same kind of machine, and refused elsewhere.

#pragma once

#include "status.h"

#include <stddef.h>

// Memory that was written last, and where it is in the bytes.
typedef struct {
    const char *from;
    size_t size, at;
} store_span;

enum { STORE_DEPTH = 4 };

// Memory that tables had, to be used for the same tables of another world: in the
// order in which they are stored.
typedef struct {
    void  *at;              // NULL: it has been taken
    size_t size;            // bytes, at least
} store_block;

typedef struct {
    store_block *block;     // [count]
    int count, room;
    int next;               // the one that is taken next
} store_spare;

typedef struct {
    status done;
    bool is_reading;
    const char *from;       // read,
    char *into;             // or written; may be NULL:
    size_t room;            // so many are there, and what finds no room
    size_t used;            // is only counted
    store_span span[STORE_DEPTH + 1];   // [depth] was written last; those
    int depth;                          // before it are entered

    // Things outside of the bytes that pointers may mean, by number.
    const void *(*thing)(const void *owner, int number);
    const void *owner;
    int things, last;       // how many; the last one that was meant

    store_spare *spare;     // NULL: tables that are read are allocated
} store;
//<

//> store-declare
//>   Every function works in both directions. Which one it is, only the store
//>   knows.
// Bytes of this version, to be written to `room` bytes at `into`.
store  store_to(void *into, size_t room, const char *version);
// They are complete: returns how many they are.  They are good if so many had
// room.
size_t store_end(store *s);

// Such bytes.  Fails (s.done) if they are not `size` bytes as they were written,
// or of another version.
store  store_from(const void *from, size_t size, const char *version);

// No bytes are kept: each table that is stored is listed in spare, which
// must be empty.  s.done fails, and the list is empty, if memory is refused.
store  store_list(store_spare *spare);
// Frees what has not been taken of the list; empty, it goes on.
void   store_clear(store_spare *spare);
void   store_free(store_spare *spare);  // frees it; a zeroed one is fine

// n bytes of memory.
void store_memory(store *s, void *data, size_t n);

// An array whose pointer is at `array`: count elements of that size, with room
// for more; NULL stays NULL.  The pointer must be in memory that was stored
// last, or was entered; there the bytes have 0 instead.
void store_table(store *s, void *array, int count, int room, size_t size);
// The same for an array whose elements mean nothing between two frames: read,
// it is there, and they may be anything (STORE_ROOM), or zeros (STORE_ZEROS).
void store_room(store *s, void *array, int room, size_t size);
#define STORE_TABLE(s, array, count, room) \
    store_table((s), &(array), (count), (room), sizeof *(array))
#define STORE_ZEROS(s, array, room) STORE_TABLE((s), array, 0, (room))
#define STORE_ROOM(s, array, room) \
    store_room((s), &(array), (room), sizeof *(array))

// A field of such memory, of n bytes, that means nothing later: read, it is 0.
void store_forget(store *s, const void *field, size_t n);
#define STORE_FORGET(s, field) store_forget((s), &(field), sizeof (field))

// A pointer in such memory to one of the things, or else NULL.
void store_pointer(store *s, void *pointer);

// What was stored last has pointers, whose tables are stored between these.
void store_enter(store *s);
void store_leave(store *s);

// Fails, unless it failed before.
void store_fail(store *s, status why);
//<
