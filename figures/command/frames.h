// frames.h - a scene while it runs, a file a frame: pictures, or meshes in the
// format OBJ, which Blender opens.

#ifndef TUMBLE_FRAMES_H
#define TUMBLE_FRAMES_H

#include "film.h"

// folder/frame-00000.png and so on.
typedef struct {
    const char *folder;         // NULL: not asked for
    const char *ending;
    status (*write)(const void *now, const char *path);     // of frames_add
    int  made;                  // the folder is ours
    long count;                 // written so far
} frames;

// Makes the folder, if only its last part is missing.  Fails, with a sentence,
// if it cannot be written to.
status frames_begin(frames *f);

// Writes the next frame, of what is now: something that write() understands.
status frames_add(frames *f, const void *now);

// A folder that was made for nothing goes again.
void frames_end(frames *f);

// Of a pose: a picture.
status frames_picture(const void *now, const char *path);

// Of a pose: all bodies as objects with names: vertices (m, y up) and faces,
// whose corners count from 1 through the whole file; a rope is a line.
status frames_obj(const void *now, const char *path);

#endif
