// picture.h - a rectangle of coloured points, captions on it, a PNG file of it.
//
// Used by the painter and by the command `tumble`; the only file that knows
// libpng.  Colours are linear light, as a lamp would add them up; the file is
// sRGB, as a screen wants them.

#ifndef TUMBLE_PICTURE_H
#define TUMBLE_PICTURE_H

#include "status.h"
#include "vec3.h"

// Red, green and blue as x, y and z; 0 is none, 1 is white's share.
typedef vec3 colour;

// 0xRRGGBB as it stands in a stylesheet (sRGB), made linear.
colour colour_hex(unsigned rgb);

// a where t = 0, b where t = 1.
colour colour_mix(colour a, colour b, real t);

typedef struct {
    int     width, height;
    colour *at;         // [width * height], row by row, from the top left
} picture;

// For a page with light letters on dark paper?  TUMBLE_DARK says so, and then
// pictures are dark where they are empty, and ink is light.
bool picture_is_dark(void);

// Sides of 1 to 16384 points.  Fails, and leaves *p empty, for want of memory
// or if a side is out of range.
status picture_init(picture *p, int width, int height, colour background);
void   picture_free(picture *p);

// Paints over the part of the box that lies inside the picture.
void picture_box(picture *p, int left, int top, int width, int height,
                 colour c);

// Copies all of `from` to that place, as far as it lies inside.
void picture_copy(picture *p, int left, int top, const picture *from);

// Writes text with its baseline at y (points from the top), the first letter
// at x, in letters `size` points high.  Knows digits, letters (capitals are
// drawn small) and the usual signs; others are left blank.  Returns the x at
// which the text ends; p may be NULL, to measure only.
real picture_text(picture *p, real x, real y, real size, colour ink,
                  const char *text);

// Writes a PNG.  The file appears whole or not at all: it is written beside
// its place under the name path.part and then renamed.  What is not a plain
// file (a device, a pipe) is written to directly.  Fails with a sentence that
// names the file, and leaves nothing behind.
status picture_write(const picture *p, const char *path);

// Could picture_write(p, path) succeed?  Leaves no trace.  A name that ends like
// another kind of file is refused.
status picture_check(const char *path);

#endif
