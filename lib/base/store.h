//> store-head
// store.h - writes memory to bytes, and reads it back, with the same lines of code.
//
// Book: chapter 19.
// A table is listed once, with its number of elements.  When a store writes, they are
// copied to the bytes; when it reads, the table is allocated and filled.  After a
// failure nothing more is done.
//
// Numbers have the form of memory, so bytes are good for the same version of the
// library on the same kind of machine, and refused elsewhere.

#pragma once

#include "status.h"

#include <stddef.h>

// A piece of memory, and where it is in the bytes.
typedef struct {
    const char *from;
    size_t size, at;
} store_span;

enum { STORE_DEPTH = 4 };

// Memory of the tables of a world, for the tables of the next one, in the order in
// which they are stored.
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
    const char *from;       // the bytes to read,
    char *into;             // or to write; may be NULL
    size_t room;            // how many there are; bytes without room are only
    size_t used;            // counted
    store_span span[STORE_DEPTH + 1];   // [depth] was stored last; those before
    int depth;                          // it are entered

    // Things outside of the bytes to which pointers may point, by number.
    const void *(*thing)(const void *owner, int number);
    const void *owner;
    int things, last;       // how many; the last one that was found

    store_spare *spare;     // NULL: memory of tables that are read is allocated
} store;
//<

//> store-declare
//>   Every function works in both directions. Which one it is, only the store
//>   knows.
// Begins to write bytes of this version to `room` bytes at `into`.
store  store_to(void *into, size_t room, const char *version);
// Ends it, and returns how many bytes there are.  They are good if they all had room.
size_t store_end(store *s);

// Begins to read such bytes.  Fails (s.done) if they are not the `size` bytes that were
// written, or of another version.
store  store_from(const void *from, size_t size, const char *version);

// Begins to list the memory of each table in spare, which must be empty; no bytes are
// written.  Fails (s.done), with an empty list, if memory is refused.
store  store_list(store_spare *spare);
// Frees what has not been taken from the list; then the list is empty.
void   store_clear(store_spare *spare);
void   store_free(store_spare *spare);  // frees it; a zeroed one is fine

// Stores n bytes of memory.
void store_memory(store *s, void *data, size_t n);

// Stores an array whose pointer is at `array`: count elements of that size, with room
// for more.  NULL stays NULL.  The pointer must be in memory that was stored last, or
// was entered; the bytes have 0 in its place.
void store_table(store *s, void *array, int count, int room, size_t size);
// The same for an array whose elements have no meaning between two frames: when it is
// read, they may be anything.
void store_room(store *s, void *array, int room, size_t size);
#define STORE_TABLE(s, array, count, room) \
    store_table((s), &(array), (count), (room), sizeof *(array))
#define STORE_ZEROS(s, array, room) STORE_TABLE((s), array, 0, (room))
#define STORE_ROOM(s, array, room) \
    store_room((s), &(array), (room), sizeof *(array))

// Makes a field of n bytes of such memory 0 when it is read.
void store_forget(store *s, const void *field, size_t n);
#define STORE_FORGET(s, field) store_forget((s), &(field), sizeof (field))

// Stores a pointer in such memory to one of the things, or NULL.
void store_pointer(store *s, void *pointer);

// Between these two, the tables of what was stored last are stored.
void store_enter(store *s);
void store_leave(store *s);

// Fails, unless it failed before.
void store_fail(store *s, status why);
//<
