// pack.h - a PNG with the same points in fewer bytes.

#ifndef TUMBLE_PACK_H
#define TUMBLE_PACK_H

#include "status.h"

// Writes the PNG at path anew, with fewer bytes if that can be.
// Fails, and leaves the file as it was, with a sentence that names it: it is no
// PNG, or one that is seen through, or it cannot be written.
status picture_pack(const char *path);

#endif
