// picture.c - points, stroked letters, PNG.

#define _XOPEN_SOURCE 700

#include "picture.h"
#include "output.h"

#include <errno.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

// ---- Colour ----------------------------------------------------------------

// sRGB (IEC 61966-2-1): a straight piece near black, then a power of 2.4.
static real light_of(unsigned byte)
{
    real s = (real)byte / 255;
    return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4);
}

static unsigned char byte_of(real light)
{
    // Written so that a NaN, for which every comparison is false, turns black.
    if (!(light > 0)) return 0;
    if (light >= 1) return 255;
    real s = light <= 0.0031308 ? 12.92 * light
                                : 1.055 * pow(light, 1 / 2.4) - 0.055;
    return (unsigned char)(255 * s + 0.5);
}

colour colour_hex(unsigned rgb)
{
    return (colour){ light_of(rgb >> 16 & 255), light_of(rgb >> 8 & 255),
                     light_of(rgb & 255) };
}

colour colour_mix(colour a, colour b, real t)
{
    return vec3_add_scaled(vec3_scale(1 - t, a), t, b);
}

// ---- Paper and ink ---------------------------------------------------------

enum { DARK_PAPER = 0x16181c, LIGHT_INK = 0xe4e2dc };

bool picture_is_dark(void)
{
    return getenv("TUMBLE_DARK") != NULL;
}

// ---- Points ----------------------------------------------------------------

enum { LARGEST_SIDE = 16384 };

status picture_init(picture *p, int width, int height, colour background)
{
    *p = (picture){ 0 };
    if (width < 1 || height < 1 || width > LARGEST_SIDE
        || height > LARGEST_SIDE)
        return status_fail("a picture of %d x %d points: each side must be "
                           "1 to %d", width, height, LARGEST_SIDE);
    p->at = malloc((size_t)width * (size_t)height * sizeof *p->at);
    if (!p->at) return status_out_of_memory();
    p->width = width;
    p->height = height;
    if (picture_is_dark()) background = colour_hex(DARK_PAPER);
    picture_box(p, 0, 0, width, height, background);
    return status_ok();
}

void picture_free(picture *p)
{
    free(p->at);
    *p = (picture){ 0 };
}

static int clamp_int(int n, int low, int high)
{
    return n < low ? low : n > high ? high : n;
}

static colour *picture_at(const picture *p, int x, int y)
{
    return &p->at[(size_t)y * (size_t)p->width + (size_t)x];
}

void picture_box(picture *p, int left, int top, int width, int height,
                 colour c)
{
    int x0 = clamp_int(left, 0, p->width);
    int y0 = clamp_int(top, 0, p->height);
    int x1 = clamp_int(left + width, 0, p->width);
    int y1 = clamp_int(top + height, 0, p->height);
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++)
            *picture_at(p, x, y) = c;
}

void picture_copy(picture *p, int left, int top, const picture *from)
{
    for (int j = 0; j < from->height; j++)
        for (int i = 0; i < from->width; i++) {
            int x = left + i, y = top + j;
            if (x < 0 || y < 0 || x >= p->width || y >= p->height) continue;
            *picture_at(p, x, y) = *picture_at(from, i, j);
        }
}

// ---- Letters ---------------------------------------------------------------

// A letter is a few strokes of a round pen, our own drawing.  A stroke is a
// list of points, each two digits: x from 0, and y with the baseline at 2,
// small letters up to 7, tall ones and numbers up to 9.  After `-` the points
// are joined by straight lines; after `~` they pull a smooth curve (a
// quadratic B-spline), closed if the last point is the first.
typedef struct {
    char        letter;
    const char *strokes;
} glyph;

static const glyph glyphs[] = {
    { '0', "~024245464909060502" },     { '1', "-072922" },
    { '2', "~0709494502 -0242" },       { '3', "~0809494616 ~1646420203" },
    { '4', "-32390444" },               { '5', "-490906 ~0647430203" },
    { '6', "~0242470702 ~390904" },     { '7', "-094912" },
    { '8', "~0242460602 ~0646490906" }, { '9', "~0444490904 ~124247" },
    { 'a', "~0242470702 -4742" },       { 'b', "~0242470702 -0902" },
    { 'c', "~4647070242 43" },          { 'd', "~0242470702 -4942" },
    { 'e', "-0545 ~4547070242 43" },    { 'f', "~391916 -1612 -0737" },
    { 'g', "~0242470702 -4742 ~42400001" },
    { 'h', "-0902 ~04074744 -4442" },   { 'i', "-0702 -0909" },
    { 'j', "-1712 ~121000 -1919" },     { 'k', "-0902 -4704 -1642" },
    { 'l', "-0902" },
    { 'm', "-0702 ~04073734 -3432 ~34376764 -6462" },
    { 'n', "-0702 ~04074744 -4442" },   { 'o', "~0242470702" },
    { 'p', "-0700 ~0242470702" },       { 'q', "-4740 ~0242470702" },
    { 'r', "-0702 ~040737" },           { 's', "~464707054442 0203" },
    { 't', "~19131232 -0737" },         { 'u', "~07024245 -4742" },
    { 'v', "-072247" },                 { 'w', "-0712375267" },
    { 'x', "-0742 -4702" },             { 'y', "-0722 -4710" },
    { 'z', "-07470242" },
    { '.', "-0202" },                   { ',', "-1201" },
    { ':', "-0202 -0606" },             { '=', "-0444 -0646" },
    { '-', "-0545" },                   { '+', "-0545 -2327" },
    { '/', "-0139" },                   { '_', "-0141" },
    { '(', "~19070411" },               { ')', "~09171401" },
    { '%', "-0149 ~0727290907 ~2242442422" },
    { '<', "-370533" },                 { '>', "-073503" },
};

enum { MAX_PEN = 192, CURVE_STEPS = 6 };

// The path of the pen over one letter; lift says that a point begins anew.
typedef struct {
    int  count;
    real x[MAX_PEN], y[MAX_PEN];
    int  lift[MAX_PEN];
    real width;         // of the letter, in units of its grid
} pen_path;

static void pen_to(pen_path *path, real x, real y, int lift)
{
    if (path->count == MAX_PEN) return;
    path->x[path->count] = x;
    path->y[path->count] = y;
    path->lift[path->count++] = lift;
    if (x > path->width) path->width = x;
}

// A quadratic B-spline is a chain of parabolas: each starts at the middle of
// one edge of the control polygon and ends at the middle of the next, pulled
// by the corner c between.  An open one starts and ends at its end points.
static void pen_curve(pen_path *path, const vec3 *c, int n)
{
    int closed = c[0].x == c[n - 1].x && c[0].y == c[n - 1].y;
    int first = closed ? 0 : 1, last = n - 2;
    for (int k = first; k <= last; k++) {
        vec3 before = closed && k == 0 ? c[n - 2] : c[k - 1 < 0 ? 0 : k - 1];
        vec3 a = vec3_scale(0.5, vec3_add(before, c[k]));
        vec3 b = vec3_scale(0.5, vec3_add(c[k], c[k + 1]));
        if (!closed && k == first) a = c[0];
        if (!closed && k == last) b = c[n - 1];
        for (int i = 0; i <= CURVE_STEPS; i++) {
            real t = (real)i / CURVE_STEPS, s = 1 - t;
            pen_to(path, s * s * a.x + 2 * s * t * c[k].x + t * t * b.x,
                   s * s * a.y + 2 * s * t * c[k].y + t * t * b.y,
                   k == first && i == 0);
        }
    }
}

static const char *glyph_strokes(char letter)
{
    if (letter >= 'A' && letter <= 'Z') letter = (char)(letter - 'A' + 'a');
    for (size_t i = 0; i < sizeof glyphs / sizeof glyphs[0]; i++)
        if (glyphs[i].letter == letter) return glyphs[i].strokes;
    return "";
}

static pen_path pen_letter(char letter)
{
    enum { MAX_CORNERS = 16 };
    pen_path path = { 0 };
    const char *s = glyph_strokes(letter);
    if (!*s) path.width = 1.5;
    while (*s) {
        char kind = *s++;
        vec3 corner[MAX_CORNERS];
        int n = 0;
        for (; *s && *s != '-' && *s != '~' && n < MAX_CORNERS; s++) {
            if (*s == ' ') continue;
            corner[n++] = vec3_make(s[0] - '0', s[1] - '0' - 2, 0);
            s++;
        }
        if (kind == '~' && n >= 3) pen_curve(&path, corner, n);
        for (int i = 0; kind == '-' && i < n; i++)
            pen_to(&path, corner[i].x, corner[i].y, i == 0);
    }
    return path;
}

// The distance of (x, y) from the path of the pen, in units of the grid.
static real pen_distance(const pen_path *path, real x, real y)
{
    real least = HUGE_VAL;
    for (int i = 1; i < path->count; i++) {
        if (path->lift[i]) continue;
        real dx = path->x[i] - path->x[i - 1], dy = path->y[i] - path->y[i - 1];
        real px = x - path->x[i - 1], py = y - path->y[i - 1];
        real along = dx * dx + dy * dy;
        real t = along > 0 ? (px * dx + py * dy) / along : 0;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        px -= t * dx;
        py -= t * dy;
        real d = sqrt(px * px + py * py);
        if (d < least) least = d;
    }
    return least;
}

static void letter_draw(picture *p, const pen_path *path, real x, real y,
                        real unit, colour ink)
{
    const real half_pen = 0.5;      // units of the grid
    int x0 = clamp_int((int)floor(x - unit) - 1, 0, p->width);
    int x1 = clamp_int((int)ceil(x + (path->width + 1) * unit) + 1, 0,
                       p->width);
    int y0 = clamp_int((int)floor(y - 8 * unit) - 1, 0, p->height);
    int y1 = clamp_int((int)ceil(y + 3 * unit) + 1, 0, p->height);
    for (int j = y0; j < y1; j++)
        for (int i = x0; i < x1; i++) {
            real d = pen_distance(path, (i + 0.5 - x) / unit,
                                  (y - j - 0.5) / unit);
            // The pen's rim runs through the point: it covers a share of it.
            real cover = (half_pen - d) * unit + 0.5;
            if (!(cover > 0)) continue;
            colour *c = picture_at(p, i, j);
            *c = colour_mix(*c, ink, cover > 1 ? 1 : cover);
        }
}

real picture_text(picture *p, real x, real y, real size, colour ink,
                  const char *text)
{
    real unit = size / 7;
    if (picture_is_dark()) ink = colour_mix(ink, colour_hex(LIGHT_INK), 0.6);
    for (; *text; text++) {
        pen_path path = pen_letter(*text);
        if (p && path.count > 0) letter_draw(p, &path, x, y, unit, ink);
        x += (path.width + 2) * unit;
    }
    return x - 2 * unit;
}

// ---- PNG -------------------------------------------------------------------

static unsigned char *picture_bytes(const picture *p)
{
    size_t n = (size_t)p->width * (size_t)p->height;
    unsigned char *bytes = malloc(3 * n);
    if (!bytes) return NULL;
    for (size_t i = 0; i < n; i++) {
        bytes[3 * i] = byte_of(p->at[i].x);
        bytes[3 * i + 1] = byte_of(p->at[i].y);
        bytes[3 * i + 2] = byte_of(p->at[i].z);
    }
    return bytes;
}

status picture_check(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    if (dot && strcasecmp(dot, ".png") != 0)
        return status_fail("%.120s: a picture is written as PNG, and its name "
                           "ends in .png", path);
    struct stat there, none;
    // /dev/null takes everything; /dev/full, a terminal and their like do not.
    if (stat(path, &there) == 0 && S_ISCHR(there.st_mode)
        && stat("/dev/null", &none) == 0 && there.st_rdev != none.st_rdev)
        return status_fail("%.120s: cannot write: it is a device, and no place "
                           "for a picture", path);
    return output_check(path);
}

status picture_write(const picture *p, const char *path)
{
    output o;
    status s = output_open(&o, path);
    if (!s.ok) return s;
    unsigned char *bytes = picture_bytes(p);
    if (!bytes) {
        output_cancel(&o);
        return status_out_of_memory();
    }
    png_image image = { .version = PNG_IMAGE_VERSION,
                        .width = (png_uint_32)p->width,
                        .height = (png_uint_32)p->height,
                        .format = PNG_FORMAT_RGB };
    errno = 0;
    int written = png_image_write_to_stdio(&image, o.file, 0, bytes, 0, NULL);
    free(bytes);
    if (written) return output_commit(&o);
    const char *why = errno ? strerror(errno) : image.message;
    output_cancel(&o);
    return status_fail("%.120s: cannot write: %s", path, why);
}
