//> pairs-head
//>   What is asked and what is kept are two structs, because the question
//>   belongs to the caller and changes in every frame.
// pairs.h - the list of pairs that may meet, kept as long as it holds.
//
// Paper: section 5.2 tests every pair of spheres.  Book: chapter 14.
// Units: metres, in the world's frame.

#pragma once

#include "broad.h"
#include "scene.h"

#include <string.h>

// The question: bounding spheres, and how far beyond them each body may move in this
// frame.
typedef struct {
    const sphere *ball; // [bodies] radius < 0: meets nothing
    const real *reach;  // [bodies] m
    const char *moves;  // [bodies] 0: it does not; two such bodies do not meet
    const int *awake;   // [awakes] by number, the bodies that have moved since the
    int awakes;         // last frame, may move in this one, or are new
    int bodies;
    const plane *plane;
    int planes;
} pair_query;

// Pairs are found for spheres that are a little larger.  While no body leaves its
// larger sphere, the list has all pairs that may meet, and a few more.
//
// Bodies that lie still are *settled*.  Pairs of two settled bodies are found once,
// when they settle, and then leave the list, which is of the others: these are *loose*.
// When a settled body wakes, all pairs are found again.
typedef struct {
    int  (*pair)[2];    // [count] a < b, sorted by a, then by b,
    int  count, capacity;
    int  walls;         // and behind these so many pairs of a body and a plane
                        // (contact_with_plane), sorted by the numbers of both
    long lists;         // how often pairs were found
    bool is_cut;        // some pairs found no memory: the list does not hold

    broad  broad;
    sphere *listed;     // [bodies] the larger spheres
    bool   *is_new;     // [bodies] it is new, or was moved, since pairs were found
    int    bodies, room;
    bool   has_new;     // some body is, or there is a new plane
    char   *is_settled; // [bodies]
    int    *loose;      // [looses] by number
    int    looses;
    bool   is_whole;    // the list has all pairs, see pair_list_part
    bool   is_due;      // all pairs must be found again
    int    parted;      // pairs that pair_list_part has left out
    int    asked;       // how often a body has left its larger sphere since all
                        // moving bodies got new ones
    int  (*fresh)[2];   // [fresh_capacity] pairs of those bodies
    int    fresh_capacity;
} pair_list;

// Its tables, and for how much there is room: a saved list keeps what is KEPT.
#define PAIR_TABLES(KEPT, ROOM, l)                                            \
    KEPT(listed, (l)->bodies, (l)->room) KEPT(is_new, (l)->bodies, (l)->room) \
    KEPT(is_settled, 0, (l)->room) ROOM(loose, 0, (l)->room)                  \
    ROOM(pair, 0, (l)->capacity) ROOM(fresh, 0, (l)->fresh_capacity)
//<

//> pairs-declare
//>   One function answers. It says whether the list is a new one, because
//>   tables that go along with the pairs must follow it.
// Makes room for so many bodies, if there is less; a zeroed list has room for none.
// False, changing nothing, if memory is refused.
bool   pair_list_grow(pair_list *l, int bodies);
void   pair_list_free(pair_list *l);    // an empty or zeroed one is fine

// Finds the pairs of body b again in the next frame, because it came, went, was put
// elsewhere, or may meet other bodies than before.  b < 0: there are more planes.
void pair_list_renew(pair_list *l, int b);

// Brings the list up to date for this frame.  Returns true if pairs were found again,
// false if those of the last frame still hold.  Allocates if there are more pairs than
// ever before; if memory is refused, *lost is how many were left out.
bool pair_list_update(pair_list *l, const pair_query *q, int *lost);

// The same later in the frame, after bodies have woken: larger spheres stay.
bool pair_list_wake(pair_list *l, const pair_query *q, int *lost);

// Are both bodies of a pair settled?
static inline bool pair_is_settled(const pair_list *l, const int pair[2])
{
    return l->is_settled[pair[0]] && (pair[1] < 0 || l->is_settled[pair[1]]);
}

// Leaves only the pairs for which `stays` returns true.
typedef bool pair_stays(const void *context, const int pair[2]);
static inline void pair_list_filter(pair_list *l, pair_stays *stays,
                                    const void *context)
{
    int kept = 0, count = 0;
    for (int k = 0; k < l->count + l->walls; k++) {
        if (!stays(context, l->pair[k])) continue;
        memmove(l->pair[kept++], l->pair[k], sizeof l->pair[k]);
        count += k < l->count;
    }
    l->count = count;
    l->walls = kept - count;
}

// Removes settled pairs from a whole list, after tables with a place for each pair have
// followed it.
void pair_list_part(pair_list *l);
//<
