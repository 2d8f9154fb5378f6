// peers.h - the parts of the program peers: the same work by us and by others,
// timed in turn, and one table of it.
//
#ifndef TUMBLE_PEERS_H
#define TUMBLE_PEERS_H

#include "vec3.h"

// ---- The table -------------------------------------------------------------

enum { TEXT = 80 };

// A line of the table.  Times in its unit; 0: there is none.
typedef struct {
    const char *what, *against, *unit;
    real ours, theirs;
    real ratio;         // target: ours at most so many times theirs; 0: none
    real most;          // target: ours at most that; 0: none
    int  is_quoted;     // theirs was measured elsewhere
    int  is_wrong;      // our error is not what it has to be
    char our_error[TEXT], their_error[TEXT];
} row;

// Shows the row, and keeps it for the CSV.
void table_add(row r);

// ---- The clock -------------------------------------------------------------

// A way to do a piece of work.
typedef struct {
    void (*prepare)(int piece);     // not timed; NULL: nothing to prepare
    void (*run)(int piece);
} way;

// Every round does every piece in every way, one way after the other, each of
// them first in turn; of several rounds one more is for warming up.  The time
// of a piece (s) is the median over the rounds: time[w * pieces + piece].
// Exits if memory is refused.
real *time_in_turn(const way *ways, int count, int pieces, int rounds);

// The times of all pieces of way w.
real time_sum(const real *time, int pieces, int w);

_Noreturn void give_up(const char *why);

// ---- The parts, each adds its rows -----------------------------------------

void peers_pairs(void);
void peers_rooms(void);
void peers_sticks(void);

#endif
