//> status-head
// status.h - an answer that says why not.
//
// Book: chapter 0.  A programmer's misuse of the library stops at an assert.
// Bad input (a file, a mesh, an option) does not stop the program: the function
// that meets it leaves nothing half built and returns one sentence that says
// what is wrong, where, and why.

#pragma once

#include <stdbool.h>

// why is one sentence without a full stop, empty if ok.
typedef struct {
    bool ok;
    char why[200];
} status;

status status_ok(void);

// Fails, with the sentence that printf would make of the arguments, cut to fit.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
status status_fail(const char *format, ...);

// The status of an allocation that was refused.
status status_out_of_memory(void);
//<
