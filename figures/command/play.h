// play.h - the scenes of figures/scenes, which know nothing but tumble.h.

#ifndef TUMBLE_PLAY_H
#define TUMBLE_PLAY_H

#include "example.h"

// The scene of that name; NULL: there is none.
const example *play_find(const char *name);

// Runs it to its end, with the words that stand behind its name on the command
// line (word[words] is NULL): --seconds S, --film FILE, and for a file a step
// --frames FOLDER, --obj FOLDER.  Says what it claims, and by how much it
// holds.  Returns the exit status: 0 it holds, 1 it does not or something
// failed, 2 a word was not understood.
int play(const example *e, int words, char **word);

// A line for each scene.
void play_list(void);

#endif
