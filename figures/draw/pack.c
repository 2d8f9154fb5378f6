// pack.c - a PNG with the same points in fewer bytes.
//
// A row of a PNG is compressed as it is, or as what differs from the points
// beside and above.  A chart, most of which is one colour, is smaller the first
// way, a picture with light and shadow the second: the smallest is kept.

#include "pack.h"
#include "output.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>

static const int filter[] = { PNG_FILTER_NONE, PNG_FILTER_SUB,
                              PNG_ALL_FILTERS };
enum { WAYS = sizeof filter / sizeof *filter, TIGHTEST = 9 };

// 1 if the points could be written; an error of libpng's jumps back here.
static int write_points(FILE *file, const png_image *image, png_const_bytep at,
                        int way)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL,
                                              NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return 0;
    }
    png_init_io(png, file);
    png_set_IHDR(png, info, image->width, image->height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png, TIGHTEST);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, way);
    png_write_info(png, info);
    for (png_uint_32 y = 0; y < image->height; y++)
        png_write_row(png, at + (size_t)y * PNG_IMAGE_ROW_STRIDE(*image));
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    return 1;
}

// How many bytes it would be; -1: nobody knows.
static long size_of(const png_image *image, png_const_bytep at, int way)
{
    FILE *file = tmpfile();
    long size = -1;
    if (file && write_points(file, image, at, way)) size = ftell(file);
    if (file) fclose(file);
    return size;
}

static long size_of_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    long size = file && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (file) fclose(file);
    return size;
}

static status write_smallest(const char *path, const png_image *image,
                             png_const_bytep at)
{
    int best = -1;
    long least = size_of_file(path);
    for (int i = 0; i < WAYS; i++) {
        long size = size_of(image, at, filter[i]);
        if (size < 0 || size >= least) continue;
        least = size;
        best = i;
    }
    if (best < 0) return status_ok();
    output o;
    status done = output_open(&o, path);
    if (!done.ok) return done;
    if (write_points(o.file, image, at, filter[best])) return output_commit(&o);
    output_cancel(&o);
    return status_fail("%.120s: cannot write", path);
}

status picture_pack(const char *path)
{
    png_image image = { .version = PNG_IMAGE_VERSION };
    if (!png_image_begin_read_from_file(&image, path))
        return status_fail("%.120s: %.60s", path, image.message);
    if (image.format & PNG_FORMAT_FLAG_ALPHA) {
        png_image_free(&image);
        return status_fail("%.120s: this picture is seen through", path);
    }
    image.format = PNG_FORMAT_RGB;
    png_bytep at = malloc(PNG_IMAGE_SIZE(image));
    status done = status_out_of_memory();
    if (!at) png_image_free(&image);
    else if (png_image_finish_read(&image, NULL, at, 0, NULL))
        done = write_smallest(path, &image, at);
    else done = status_fail("%.120s: %.60s", path, image.message);
    free(at);
    return done;
}
