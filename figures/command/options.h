// options.h - what the command line of `tumble` says.
//
// One table drives the parser, the help and the list, so they cannot drift.

#ifndef TUMBLE_OPTIONS_H
#define TUMBLE_OPTIONS_H

#include "runner.h"

#include <stdio.h>

typedef struct {
    scene_kind scene;
    int  bodies, cloth;         // how many; particles along a side
    unsigned long long seed;
    real seconds, dt;           // s
    int  substeps, iterations;  // 0: as the scene needs
    real tolerance;             // strain; < 0: as the scene needs
    real gravity;               // m/s^2, downwards
    world_options engine;       // some of its fields; the others are unused
    int  paper, plain;          // the paper's system: as printed; as mended
    int  bits;
    int  threads;
    const char *mesh, *film, *frames, *obj, *csv, *record, *replay;
                                // NULL: not asked for
    real every;                 // s, from one frame to the next
    const char *sweep, *joblog, *hosts;     // NULL: not asked for
    int  row, jobs;             // 0: all; as many as there are cores
    int  resume;
    int  help, list, version;
    unsigned long long given;   // bit i: option i of the table was given
} settings;

// Reads the command line.  Fails with a sentence that names the option.  With
// --replay it holds no scene, which the record names; with --sweep neither.
status settings_read(settings *s, int arguments, char *const *argument);

// The words of a record are read after those of the command line.
status settings_read_more(settings *s, int words, char *const *word);

// Prints the words that make the same motion, one a line: the scene, and of the
// options those that were given and move it, and its seed, seconds and dt.
void settings_print_words(const settings *s, FILE *out);

// Which system is to run the scene; what it wants to know.
runner_kind    settings_runner(const settings *s);
scene_options  settings_scene(const settings *s);
world_options  settings_world(const settings *s);
system_options settings_system(const settings *s);

// How many steps of dt fill the seconds, and lie from one frame to the next.
long settings_steps(const settings *s);
long settings_steps_a_frame(const settings *s);

// Names the options that were given and mean nothing to the scene, and says
// what a long step does.
void settings_print_notes(const settings *s, FILE *out);

void settings_print_help(FILE *out);
void settings_print_list(FILE *out);

#endif
