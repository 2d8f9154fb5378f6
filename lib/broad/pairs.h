//> pairs-head
//>   What is asked and what is kept are two structs, because the question
//>   belongs to the caller and changes in every frame.
// pairs.h - which bodies may meet in this frame, as long as the answer holds.
//
// Paper: section 5.2 tests every pair of spheres.  Book: chapter 14.
// Units: metres, in the world's frame.

#pragma once

#include "broad.h"
#include "scene.h"

#include <string.h>

// What is asked: balls around bodies, and how far beyond them each may get in
// this frame.
typedef struct {
    const sphere *ball; // [bodies] radius < 0: meets nothing
    const real *reach;  // [bodies] m
    const char *moves;  // [bodies] 0: never, so that two such do not meet
    const int *awake;   // [awakes] all that is elsewhere than in the last frame,
    int awakes;         // may go further in this one, or has come; by number
    int bodies;
    const plane *plane;
    int planes;
} pair_query;

// The pairs are found for balls that are a little larger.  While no body leaves
// its larger ball they are a superset of those that may meet.
//
// What lies still is *settled*: pairs of two such are found once, when they
// settle, and are in no list after that.  The list is of the others, which are
// *loose*.  When one that is settled wakes, all pairs are found again.
typedef struct {
    int  (*pair)[2];    // [count] a < b, sorted by a, then by b,
    int  count, capacity;
    int  walls;         // and behind these so many of a body and a plane
                        // (contact_with_plane), sorted by the numbers of both
    long lists;         // how often they were found
    bool is_cut;        // some found no memory: the list does not hold

    broad  broad;
    sphere *listed;     // [bodies] the larger balls
    bool   *is_new;     // [bodies] it has come, or gone elsewhere, since then
    int    bodies, room;
    bool   has_new;     // there is one, or there is a plane more
    char   *is_settled; // [bodies]
    int    *loose;      // [looses] by number
    int    looses;
    bool   is_whole;    // the list has all pairs, see pair_list_part
    bool   is_due;      // all must be found, whatever is awake
    int    parted;      // pairs that pair_list_part has left out
    int    asked;       // so often a body has left its larger ball, since all
                        // that moved were given new ones
    int  (*fresh)[2];   // [fresh_capacity] of these
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
// For that many bodies, if it was for fewer; at first a zeroed one is for none.
// Fails, changing nothing, for want of memory.
status pair_list_grow(pair_list *l, int bodies);
void   pair_list_free(pair_list *l);    // an empty or zeroed one is fine

// Body b has come, gone, or been put elsewhere, or what it may meet is another:
// its pairs are found again in the next frame.  Those of others stay as they
// are.  b < 0: there are more planes.
void pair_list_renew(pair_list *l, int b);

// The pairs of this frame.  Returns true if they were found again, false if
// those of the last frame still hold.  Allocates if there are more pairs than
// ever before; where memory is refused, *lost is how many were left out.
bool pair_list_update(pair_list *l, const pair_query *q, int *lost);

// The same later in the frame, when some have woken: their balls stay.
bool pair_list_wake(pair_list *l, const pair_query *q, int *lost);

// Is nothing of a pair loose?
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

// Leaves those out of a whole list of which nothing is loose.  Until then it is
// good for what goes along with all pairs.
void pair_list_part(pair_list *l);
//<
