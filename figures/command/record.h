// record.h - what a run was, kept to be compared with later ones.
//
// A record is a text file: the words of a command line, one a line, and then
// lines of a step and a hash of all positions after it, every 60 steps and at
// the end.  A # opens a remark.

#ifndef TUMBLE_RECORD_H
#define TUMBLE_RECORD_H

#include "options.h"
#include "output.h"

enum { RECORD_EVERY = 60 };     // steps

// Opens the file and writes the options that move the scene.
status record_open(output *o, const settings *s);

// Writes the hash after that step, if it is due; is_last: it is.
status record_look(output *o, const runner *run, long step, int is_last);

typedef struct {
    FILE *file;                 // NULL: nothing is replayed
    const char *name;
    int   line;                 // read so far
    int   words, room;          // of the command line
    char **word;                // [words], each with memory of its own
    long  step;                 // of the hash that comes next; -1: none does
    unsigned long long hash;
    long  equal, equal_step;    // how many were equal; the last of them
    int   parted;               // the next hash is another
} replay;

// Opens s->replay and adds its words to the settings, which must not outlive
// the replay.  Fails with a sentence that names the file and the line.
status replay_open(replay *p, settings *s);
void   replay_close(replay *p);

// Compares the hash after that step of so many, if there is one.
status replay_look(replay *p, const runner *run, long step, long steps);

#endif
