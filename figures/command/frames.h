// frames.h - a scene while it runs, a file a frame: pictures, or meshes in the
// format OBJ, which Blender opens.

#ifndef TUMBLE_FRAMES_H
#define TUMBLE_FRAMES_H

#include "film.h"

// folder/frame-00000.png and so on.
typedef struct {
    const char *folder;         // NULL: not asked for
    const char *ending;
    status (*write)(pose now, const char *path);
    int  made;                  // the folder is ours
    long count;                 // written so far
} frames;

// Makes the folder, if only its last part is missing.  Fails, with a sentence,
// if it cannot be written to.
status frames_begin(frames *f);

// Writes the next frame.
status frames_add(frames *f, pose now);

// A folder that was made for nothing goes again.
void frames_end(frames *f);

// All bodies as objects with names: vertices (m, y up) and faces, whose corners
// count from 1 through the whole file; a rope is a line.
status obj_write(pose now, const char *path);

#endif
