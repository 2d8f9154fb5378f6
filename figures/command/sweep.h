// sweep.h - many runs: a table of options, a row a run.
//
// The table is a CSV file without quotes.  Its head names options, without the
// two dashes, and `scene`; each row below is one run.  An empty cell, or no:
// the option is not given.  An option without a value is given by yes.  Empty
// lines, and those that begin with #, are remarks.
// A sweep keeps what it has in a folder beside its job log: the table, and a
// file for each row.  sweep.sh runs the rows and puts their lines together.

#ifndef TUMBLE_SWEEP_H
#define TUMBLE_SWEEP_H

#include "options.h"

typedef struct {
    const char *name;           // of the file
    char  *text;                // of all of it
    char **row;                 // [rows + 1] the head, and each row
    int   *line;                // [rows + 1] where they stand, from 1
    int    rows;
} table;

// Fails with a sentence that names the file, and the line where there is one,
// leaving *t empty: cannot be read, no row, a head with a quote or more than 64
// cells.
status table_read(table *t, const char *path);
void   table_free(table *t);

// The settings of a row, from 1; *words, NULL before, is the memory that they
// stand in, to be freed when they are not needed any more.  Fails with a
// sentence: another number of cells than the head has, a quote, options that
// settings_read refuses.
status table_row(const table *t, int row, settings *s, char **words);

// Does table_row succeed for every row?
status table_check(const table *t);

// Begins or resumes the sweep of set->sweep, with that head over what the rows
// print: becomes the script, which stands beside the program.  Returns only if
// it fails.
status sweep_begin(const settings *set, const char *program, const char *head);

#endif
