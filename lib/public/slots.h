//> slots-head
// slots.h - things that come and go, called by ids that are never used twice.
//
// Book: chapter 19.
// A thing in a table is called by its place.  When it goes, another may take
// the place; so an id has the generation of the place beside it.

#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    unsigned generation;    // odd: taken
    int next_free;          // -1: none
} slot;

typedef struct {
    slot *slot;             // [count]
    char *thing;            // [count * size]
    size_t size;            // bytes, of a thing
    int count, capacity;
    int free;               // the place that is taken next; -1: none is free
} slots;
//<

//> slots-declare
void slots_init(slots *s, size_t size);     // empty, owns nothing
void slots_free(slots *s);

// Takes a place: the one that was given back last, or a new one; the thing in
// it is zeroed.  Returns it, or -1 if memory is refused.  Things may move.
int  slots_take(slots *s);

// Gives place k back; it must be taken.  A place whose generations are used up
// is never taken again.
void slots_give(slots *s, int k);

bool slots_is_taken(const slots *s, int k);
unsigned slots_generation(const slots *s, int k);

// The thing of that place and generation; NULL if it is gone.
void *slots_find(const slots *s, unsigned place, unsigned generation);

// The thing in place k, from 0 to count - 1; NULL if it is not taken.
void *slots_at(const slots *s, int k);
//<
