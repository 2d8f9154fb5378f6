// output.h - a file that appears whole, or not at all.
//
// What is written goes to path.part first and takes its place by a rename.
// Something that is not a plain file (/dev/stdout, a pipe) has no place to be
// renamed to: it is written to directly.
// One program at a time writes path.part.  A program that is killed leaves its
// path.part; the next one that writes to path takes its place.

#ifndef TUMBLE_OUTPUT_H
#define TUMBLE_OUTPUT_H

#include "status.h"

#include <stdio.h>

typedef struct {
    FILE *file;         // NULL: not open
    char *path, *part;  // part = NULL: written to directly
} output;

// Opens path.part.  Fails, leaving *o empty, with a sentence that names path:
// a missing folder, a folder in the file's place, no right to write, another
// program that is writing the same file.
status output_open(output *o, const char *path);

// Hands on what was written so far.  Fails with a sentence that names the file.
status output_flush(output *o);

// Everything is on the disk and in its place; or, with a sentence, nothing is.
status output_commit(output *o);

// Takes back what was written.
void output_cancel(output *o);

// Could output_open(path) succeed?  Leaves no trace.
status output_check(const char *path);

// Do two paths name the same file, if by another way, there or not yet?  So do
// the two names of one file, and path and path.part.
int output_is_same(const char *a, const char *b);

// Does path name a file in that folder whose name begins so?
int output_is_in(const char *path, const char *folder, const char *begins);

#endif
