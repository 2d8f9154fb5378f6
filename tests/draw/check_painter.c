// check_painter.c - pictures: the file, the letters, what hides what, light.
//
// Links with figures/draw/painter.c, figures/draw/picture.c, figures/draw/output.c and -lpng.

#define _XOPEN_SOURCE 700

#include "output.h"
#include "pack.h"
#include "painter.h"
#include "suite.h"

#include <check.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// Pictures are compared by eye: a hundredth of full light cannot be seen.
static const real SEEN = 0.01;

static char folder[] = "/tmp/check_painter.XXXXXX";

static const char *in_folder(const char *name)
{
    static char path[200];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static int exists(const char *path)
{
    struct stat there;
    return lstat(path, &there) == 0;
}

// ---- Files -----------------------------------------------------------------

// Reads a PNG as bytes of red, green and blue; to be freed.
static unsigned char *read_png(const char *path, int *width, int *height)
{
    png_image image = { .version = PNG_IMAGE_VERSION };
    ck_assert_msg(png_image_begin_read_from_file(&image, path),
                  "%s", image.message);
    image.format = PNG_FORMAT_RGB;
    unsigned char *bytes = malloc(PNG_IMAGE_SIZE(image));
    ck_assert(png_image_finish_read(&image, NULL, bytes, 0, NULL));
    *width = (int)image.width;
    *height = (int)image.height;
    return bytes;
}

// Rejects: light written as it is, without sRGB's curve; a rounding down.
START_TEST(every_byte_comes_back)
{
    picture p;
    ck_assert(picture_init(&p, 256, 2, vec3_make(0, 0, 0)).ok);
    for (unsigned i = 0; i < 256; i++)
        p.at[i] = colour_hex(i << 16 | (255 - i) << 8 | (i ^ 1));
    ck_assert(picture_write(&p, in_folder("bytes.png")).ok);
    int width, height;
    unsigned char *b = read_png(in_folder("bytes.png"), &width, &height);
    ck_assert(width == 256 && height == 2);
    for (int i = 0; i < 256; i++) {
        ck_assert_int_eq(b[3 * i], i);
        ck_assert_int_eq(b[3 * i + 1], 255 - i);
        ck_assert_int_eq(b[3 * i + 2], i ^ 1);
    }
    free(b);
    picture_free(&p);
    ck_assert_ptr_null(p.at);
}
END_TEST

// Rejects: a cast of NaN or of a large number to a byte.
START_TEST(impossible_light_is_black_or_white)
{
    const real nan = (real)NAN;
    picture p;
    ck_assert(picture_init(&p, 4, 1, vec3_make(nan, -nan, nan)).ok);
    p.at[1] = vec3_make((real)INFINITY, 1e300, 2);
    p.at[2] = vec3_make(-(real)INFINITY, -1, -0.0);
    ck_assert(picture_write(&p, in_folder("odd.png")).ok);
    int width, height;
    unsigned char *b = read_png(in_folder("odd.png"), &width, &height);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(b[k], 0);
        ck_assert_int_eq(b[3 + k], 255);
        ck_assert_int_eq(b[6 + k], 0);
    }
    free(b);
    picture_free(&p);
}
END_TEST

START_TEST(sizes_out_of_range_are_refused)
{
    int bad[][2] = { { 0, 5 }, { 5, 0 }, { -1, 5 }, { 16385, 1 },
                     { 1, 2147483647 } };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        picture p;
        status s = picture_init(&p, bad[i][0], bad[i][1], vec3_make(1, 1, 1));
        ck_assert(!s.ok && strstr(s.why, "1 to 16384"));
        ck_assert_ptr_null(p.at);
        picture_free(&p);
    }
}
END_TEST

// Rejects: a sentence without the name, a .part that stays.
START_TEST(a_file_that_cannot_be_leaves_nothing)
{
    picture p;
    ck_assert(picture_init(&p, 4, 4, vec3_make(1, 1, 1)).ok);
    status s = picture_write(&p, in_folder("none/x.png"));
    ck_assert(!s.ok && strstr(s.why, "none/x.png: cannot write: No such"));
    s = picture_write(&p, folder);
    ck_assert(!s.ok && strstr(s.why, "it is a folder"));
    s = picture_write(&p, "");
    ck_assert(!s.ok && strstr(s.why, "empty"));
    if (exists("/dev/full")) {
        s = picture_write(&p, "/dev/full");
        ck_assert(!s.ok && strstr(s.why, "/dev/full: cannot write"));
        ck_assert(exists("/dev/full"));
    }
    picture_free(&p);
}
END_TEST

// Rejects: writing into the old file, removing it first.
START_TEST(an_old_file_stays_until_the_new_one_is_whole)
{
    char path[200], part[220];
    snprintf(path, sizeof path, "%s", in_folder("old"));
    snprintf(part, sizeof part, "%s.part", path);
    output o;
    ck_assert(output_open(&o, path).ok);
    fputs("one\n", o.file);
    ck_assert(exists(part) && !exists(path));
    ck_assert(output_commit(&o).ok);
    ck_assert(exists(path) && !exists(part));

    ck_assert(output_open(&o, path).ok);
    fputs("two, half writ", o.file);
    output_cancel(&o);
    ck_assert(!exists(part));
    char text[20] = "";
    FILE *f = fopen(path, "r");
    ck_assert_ptr_nonnull(fgets(text, sizeof text, f));
    fclose(f);
    ck_assert_str_eq(text, "one\n");
    output_cancel(&o);          // nothing open: nothing happens
}
END_TEST

// Rejects: a rename that puts a file in the place of the link.
START_TEST(a_link_stays_a_link)
{
    char target[200], link[200];
    snprintf(target, sizeof target, "%s", in_folder("target"));
    snprintf(link, sizeof link, "%s", in_folder("link"));
    fclose(fopen(target, "w"));
    ck_assert_int_eq(symlink(target, link), 0);
    output o;
    ck_assert(output_open(&o, link).ok);
    fputs("through", o.file);
    ck_assert(output_commit(&o).ok);
    struct stat there;
    ck_assert(lstat(link, &there) == 0 && S_ISLNK(there.st_mode));
    ck_assert(stat(target, &there) == 0 && there.st_size == 7);
}
END_TEST

// Rejects: a second program that writes into the same path.part, or removes it.
START_TEST(two_programs_do_not_write_one_file)
{
    char path[200];
    snprintf(path, sizeof path, "%s", in_folder("shared"));
    output o, other;
    ck_assert(output_open(&o, path).ok);
    fputs("first", o.file);
    pid_t child = fork();
    if (child == 0) {
        status s = output_open(&other, path);
        _exit(!s.ok && strstr(s.why, "another program is writing it") ? 0 : 1);
    }
    int how;
    ck_assert(waitpid(child, &how, 0) == child && how == 0);
    ck_assert(output_commit(&o).ok);
    struct stat there;
    ck_assert(stat(path, &there) == 0 && there.st_size == 5);
}
END_TEST

// Rejects: a file that cannot be written again, for a program was killed that
// wrote it; rows of that program behind ours.
START_TEST(what_a_killed_program_left_is_taken_over)
{
    char path[200];
    snprintf(path, sizeof path, "%s", in_folder("left"));
    FILE *f = fopen(in_folder("left.part"), "w");
    fputs("much that was never finished", f);
    fclose(f);
    output o;
    ck_assert(output_open(&o, path).ok);
    fputs("new", o.file);
    ck_assert(output_commit(&o).ok);
    struct stat there;
    ck_assert(stat(path, &there) == 0 && there.st_size == 3);
    ck_assert(!exists(in_folder("left.part")));
}
END_TEST

START_TEST(one_file_is_known_by_all_its_names)
{
    char plain[200], other[220], alias[200];
    snprintf(plain, sizeof plain, "%s", in_folder("named"));
    snprintf(other, sizeof other, "%s/./named", folder);
    snprintf(alias, sizeof alias, "%s", in_folder("alias"));
    ck_assert(output_is_same(plain, other));        // not there yet
    fclose(fopen(plain, "w"));
    ck_assert_int_eq(symlink(plain, alias), 0);
    ck_assert(output_is_same(plain, other) && output_is_same(alias, other));
    ck_assert(!output_is_same(plain, in_folder("unnamed")));
    ck_assert(output_is_same("/tumble-none", "/./tumble-none"));
    ck_assert(output_is_same("none/x", "none/x"));
    // Rejects: a file that is written under another file's name.
    ck_assert(output_is_same("none/x", "none/x.part"));
    ck_assert(output_is_same("none/x.part", "none/x"));
    ck_assert(!output_is_same("none/x", "none/x.parts"));
    ck_assert_int_eq(link(plain, in_folder("second")), 0);
    ck_assert(output_is_same(plain, in_folder("second")));
}
END_TEST

START_TEST(a_file_is_known_by_its_folder)
{
    char path[220];
    snprintf(path, sizeof path, "%s/./frame-1", folder);
    ck_assert(output_is_in(path, folder, "frame-"));
    ck_assert(!output_is_in(path, folder, "frames"));
    ck_assert(!output_is_in(path, in_folder("frame-"), "frame-"));
    ck_assert(!output_is_in(path, "/", "frame-"));
    ck_assert(output_is_in("/frame-1", "/", "frame-"));
}
END_TEST

START_TEST(a_check_leaves_no_trace)
{
    ck_assert(output_check(in_folder("maybe")).ok);
    ck_assert(!exists(in_folder("maybe")));
    ck_assert(!exists(in_folder("maybe.part")));
    ck_assert(!output_check(in_folder("none/maybe")).ok);
}
END_TEST

// A chart: letters and bars on white.
static void paint_packed(picture *p)
{
    ck_assert(picture_init(p, 300, 200, vec3_make(1, 1, 1)).ok);
    for (int i = 0; i < 9; i++) {
        picture_box(p, 20 + 30 * i, 150 - 9 * i, 20, 9 * i, colour_hex(0x0072b2));
        picture_text(p, 20 + 30 * i, 180, 12, colour_hex(0xd55e00), "how");
    }
    ck_assert(picture_write(p, in_folder("pack.png")).ok);
}

static long bytes_in(const char *path)
{
    struct stat there;
    return stat(path, &there) == 0 ? (long)there.st_size : -1;
}

// Rejects: a row less; red for blue; the way that is larger; growing again.
START_TEST(a_packed_picture_has_the_same_points_in_fewer_bytes)
{
    picture p;
    paint_packed(&p);
    const char *path = in_folder("pack.png");
    int width, height, again_width, again_height;
    long before = bytes_in(path);
    unsigned char *b = read_png(path, &width, &height);
    status s = picture_pack(path);
    ck_assert_msg(s.ok, "%s", s.why);
    ck_assert_msg(bytes_in(path) < before, "%ld bytes, before %ld",
                  bytes_in(path), before);
    unsigned char *again = read_png(path, &again_width, &again_height);
    ck_assert(again_width == width && again_height == height);
    ck_assert(memcmp(b, again, (size_t)(3 * width * height)) == 0);
    long packed = bytes_in(path);
    ck_assert(picture_pack(path).ok && bytes_in(path) == packed);
    free(b);
    free(again);
    picture_free(&p);
}
END_TEST

// Rejects: bytes from nowhere where there is no picture, or half a one.
START_TEST(what_is_no_picture_is_not_packed)
{
    picture p;
    paint_packed(&p);
    const char *path = in_folder("pack.png");
    ck_assert(truncate(path, bytes_in(path) / 2) == 0);
    long half = bytes_in(path);
    status s = picture_pack(path);
    ck_assert(!s.ok && strstr(s.why, "pack.png: "));
    ck_assert_int_eq(bytes_in(path), half);
    s = picture_pack(in_folder("none.png"));
    ck_assert(!s.ok && strstr(s.why, "none.png: "));
    ck_assert(!exists(in_folder("none.png")));
    picture_free(&p);
}
END_TEST

// ---- Letters ---------------------------------------------------------------

static real ink_of(const char *text, real x, real y)
{
    picture p;
    ck_assert(picture_init(&p, 60, 30, vec3_make(0, 0, 0)).ok);
    picture_text(&p, x, y, 14, vec3_make(1, 1, 1), text);
    real sum = 0;
    for (int i = 0; i < 60 * 30; i++) sum += p.at[i].x;
    picture_free(&p);
    return sum;
}

// Rejects: a letter missing from the table or drawn like another one.
START_TEST(every_letter_is_drawn_and_no_two_alike)
{
    const char *all = "0123456789abcdefghijklmnopqrstuvwxyz.,:=-+/_()%<>";
    for (const char *a = all; *a; a++) {
        char one[2] = { *a, 0 };
        ck_assert_msg(ink_of(one, 10, 20) > 2, "'%c' is not drawn", *a);
        picture p, q;
        ck_assert(picture_init(&p, 60, 30, vec3_make(0, 0, 0)).ok);
        picture_text(&p, 10, 20, 14, vec3_make(1, 1, 1), one);
        for (const char *b = all; b < a; b++) {
            char other[2] = { *b, 0 };
            ck_assert(picture_init(&q, 60, 30, vec3_make(0, 0, 0)).ok);
            picture_text(&q, 10, 20, 14, vec3_make(1, 1, 1), other);
            ck_assert_msg(memcmp(p.at, q.at, 60 * 30 * sizeof *p.at),
                          "'%c' looks like '%c'", *a, *b);
            picture_free(&q);
        }
        picture_free(&p);
    }
}
END_TEST

// The sanitizer sees a letter that is drawn outside of the picture.
START_TEST(letters_are_cut_at_the_rim)
{
    ck_assert(ink_of("mmmm", -8, 2) > 0);
    ck_assert(ink_of("gggg", 55, 29) > 0);
    ck_assert(ink_of("g", 1000, -1000) == 0);
}
END_TEST

START_TEST(text_is_as_wide_as_it_measures)
{
    picture p;
    ck_assert(picture_init(&p, 200, 30, vec3_make(0, 0, 0)).ok);
    const char *text = "t = 0.25 s";
    real end = picture_text(NULL, 5, 20, 14, vec3_make(1, 1, 1), text);
    ck_assert(end == picture_text(&p, 5, 20, 14, vec3_make(1, 1, 1), text));
    int last = 0;
    for (int i = 0; i < 200 * 30; i++)
        if (p.at[i].x > 0.2 && i % 200 > last) last = i % 200;
    // Half a pen (one point at this size) stands out beyond the end.
    ck_assert_msg(fabs(last - end) < 2, "ends at %d, not %g", last, end);
    picture_free(&p);
}
END_TEST

// ---- What hides what -------------------------------------------------------

enum { SIDE = 60 };

static painter studio(void)
{
    painter p;
    painter_init(&p);
    p.lamps = 1;
    painter_look(&p, vec3_make(0, 0, 5), vec3_make(0, 0, 0), 40);
    return p;
}

// A square of that half side around a point, facing +z; unlit, so that its
// colour is known.
static void add_square(painter *p, vec3 c, real half, colour front, colour back)
{
    vec3 at[4];
    for (int i = 0; i < 4; i++)
        at[i] = vec3_add(c, vec3_make(i & 1 ? half : -half,
                                      i & 2 ? half : -half, 0));
    const int face[] = { 0, 1, 2, 1, 3, 2 };
    painted_mesh m = { .vertices = 4, .at = at, .faces = 2, .face = face,
                       .front = { front, front }, .back = { back, back } };
    ck_assert(painter_mesh(p, &m).ok);
    for (int k = 1; k <= 2; k++) p->triangle[p->count - k].lit = 0;
}

static picture painted(const painter *p)
{
    picture out;
    ck_assert(picture_init(&out, SIDE, SIDE, vec3_make(0, 0, 0)).ok);
    ck_assert(painter_paint(p, &out, 0, 0, SIDE, SIDE).ok);
    return out;
}

static colour point_of(const picture *p, int x, int y)
{
    return p->at[y * p->width + x];
}

static int same_colour(colour a, colour b)
{
    return vec3_distance(a, b) < SEEN;
}

static const colour RED = { 0.7, 0, 0 }, GREEN = { 0, 0.7, 0 },
                    BLUE = { 0, 0, 0.7 };

// Rejects: the last one painted wins; far hides near.
START_TEST(the_nearer_hides_the_farther)
{
    for (int order = 0; order < 2; order++) {
        painter p = studio();
        for (int k = 0; k < 2; k++) {
            int near = k ^ order;
            add_square(&p, vec3_make(0, 0, near), 0.5, near ? RED : GREEN,
                       BLUE);
        }
        picture out = painted(&p);
        ck_assert(same_colour(point_of(&out, SIDE / 2, SIDE / 2), RED));
        picture_free(&out);
        painter_free(&p);
    }
}
END_TEST

// Rejects: a mirrored picture, one upside down.
START_TEST(right_is_right_and_up_is_up)
{
    painter p = studio();
    add_square(&p, vec3_make(1, 0, 0), 0.3, RED, RED);
    add_square(&p, vec3_make(0, 1, 0), 0.3, GREEN, GREEN);
    picture out = painted(&p);
    // 1 m at 5 m is 1 / (10 tan 20 degrees) = 0.27 of the height: 16 points.
    ck_assert(same_colour(point_of(&out, 30 + 16, 30), RED));
    ck_assert(same_colour(point_of(&out, 30, 30 - 16), GREEN));
    ck_assert(!same_colour(point_of(&out, 30 - 16, 30), RED));
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// A square of 1 m at 5 m covers (60 / (10 tan 20 degrees))^2 points.  The nine
// pictures see its rim at thirds of a point: at most a third of a point is
// missed along each side.
START_TEST(a_square_covers_its_area)
{
    painter p = studio();
    add_square(&p, vec3_make(0.11, 0.07, 0), 0.5, RED, RED);
    picture out = painted(&p);
    real side = SIDE / (10 * 0.36397023426620234), area = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        area += out.at[i].z < 0.5 ? 1 - out.at[i].z / out.at[0].z : 0;
    ck_assert_msg(fabs(area - side * side) < 4 * side / 3,
                  "%g points, not %g", area, side * side);
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// Points that are partly covered by a sliver along x, or along y.
static int partly_covered(int along_y)
{
    painter p = studio();
    vec3 at[3] = { { -1, -1, 0 }, { 1, -0.8, 0 }, { 1, -1, 0 } };
    for (int i = 0; i < 3 && along_y; i++)
        at[i] = vec3_make(at[i].y, at[i].x, 0);
    const int face[] = { 0, 2, 1 };
    painted_mesh m = { .vertices = 3, .at = at, .faces = 1, .face = face,
                       .front = { RED, RED }, .back = { RED, RED } };
    ck_assert(painter_mesh(&p, &m).ok);
    p.triangle[0].lit = 0;
    picture out = painted(&p);
    int between = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        between += out.at[i].y > 0.1 && out.at[i].y < out.at[0].y - 0.1;
    picture_free(&out);
    painter_free(&p);
    return between;
}

// Rejects: one sample a point, whose rims are stairs; samples in one row.
START_TEST(a_rim_is_smooth)
{
    ck_assert_int_gt(partly_covered(0), 20);
    ck_assert_int_gt(partly_covered(1), 20);
}
END_TEST

// Rejects: the front's colour on both sides; a wall that hides the room.
START_TEST(the_back_has_its_own_colour)
{
    for (int through = 0; through < 2; through++) {
        painter p = studio();
        painter_look(&p, vec3_make(0, 0, -5), vec3_make(0, 0, 0), 40);
        add_square(&p, vec3_make(0, 0, 0), 0.5, RED, BLUE);
        add_square(&p, vec3_make(0, 0, 1), 0.2, GREEN, GREEN);
        for (int k = 0; k < 2; k++) p.triangle[k].see_through = through;
        picture out = painted(&p);
        ck_assert(same_colour(point_of(&out, SIDE / 2, SIDE / 2),
                              through ? GREEN : BLUE));
        picture_free(&out);
        painter_free(&p);
    }
}
END_TEST

// Rejects: NaN that paints, an index out of the canvas (the sanitizer).
START_TEST(what_cannot_be_seen_is_left_out)
{
    const real bad[] = { (real)NAN, (real)INFINITY, -(real)INFINITY, 1e300,
                         -1e150 };
    painter p = studio();
    add_square(&p, vec3_make(0, 0, 0), 0.5, RED, RED);
    picture plain = painted(&p);
    for (int k = 0; k < 5; k++)
        for (int axis = 0; axis < 3; axis++) {
            vec3 at = vec3_make(axis == 0 ? bad[k] : 0, axis == 1 ? bad[k] : 0,
                                axis == 2 ? bad[k] : 0.5);
            add_square(&p, at, 1, GREEN, GREEN);
        }
    add_square(&p, vec3_make(0, 0, 6), 9, GREEN, GREEN);    // behind
    add_square(&p, vec3_make(0, 0, 5), 9, GREEN, GREEN);    // at the eye
    for (int t = 0; t < p.count; t++) p.triangle[t].casts = 1;
    picture out = painted(&p);
    ck_assert_mem_eq(plain.at, out.at, SIDE * SIDE * sizeof *out.at);
    picture_free(&plain);
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// Only the box is painted, and what lies outside of the picture is cut.
START_TEST(a_box_is_kept_to)
{
    painter p = studio();
    picture out;
    ck_assert(picture_init(&out, SIDE, SIDE, GREEN).ok);
    ck_assert(painter_paint(&p, &out, -10, 40, 30, 40).ok);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            ck_assert_int_eq(same_colour(point_of(&out, x, y), GREEN),
                             !(x < 20 && y >= 40));
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// ---- Light -----------------------------------------------------------------

// The floor seen from straight above but a little, and a plate `high` over it.
static painter above(real high)
{
    painter p = studio();
    p.lamps = 4;
    painter_look(&p, vec3_make(0, 10, 0.01), vec3_make(0, 0, 0), 40);
    painter_floor(&p, vec3_make(0, 0, 0), 100, 50);
    if (high > 0) {
        vec3 at[4] = { { -0.5, high, -0.5 }, { 0.5, high, -0.5 },
                       { -0.5, high, 0.5 }, { 0.5, high, 0.5 } };
        const int face[] = { 0, 2, 1, 1, 2, 3 };
        painted_mesh m = { .vertices = 4, .at = at, .faces = 2, .face = face,
                           .front = { RED, RED }, .back = { RED, RED },
                           .casts = 1 };
        ck_assert(painter_mesh(&p, &m).ok);
    }
    return p;
}

// Rejects: a floor that shades itself, lamps that do not add up to one.
START_TEST(an_empty_floor_is_evenly_lit)
{
    painter p = above(0);
    picture out = painted(&p);
    colour here = point_of(&out, 10, 10), there = point_of(&out, 22, 25);
    ck_assert(same_colour(here, there));
    // The floor's skin is 0.86; about that much comes back.
    ck_assert_msg(here.y > 0.75 && here.y < 0.92, "%g", here.y);
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// A plate of that side and height, as a mesh, faces up or down.
static void add_plate(painter *p, real half, real high, colour c, int down)
{
    vec3 at[4] = { { -half, high, -half }, { half, high, -half },
                   { -half, high, half }, { half, high, half } };
    const int up_face[] = { 0, 2, 1, 1, 2, 3 };
    const int down_face[] = { 0, 1, 2, 1, 3, 2 };
    painted_mesh m = { .vertices = 4, .at = at, .faces = 2,
                       .face = down ? down_face : up_face, .front = { c, c },
                       .back = { c, c }, .casts = 1 };
    ck_assert(painter_mesh(p, &m).ok);
}

// Rejects: a normal that is not turned towards the eye.
START_TEST(a_back_is_lit_as_a_front)
{
    picture out[2];
    for (int down = 0; down < 2; down++) {
        painter p = above(0);
        add_plate(&p, 1, 1, RED, down);
        out[down] = painted(&p);
        painter_free(&p);
    }
    ck_assert(point_of(&out[0], SIDE / 2, SIDE / 2).x > 0.4);
    for (int i = 0; i < SIDE * SIDE; i++)
        ck_assert(same_colour(out[0].at[i], out[1].at[i]));
    for (int down = 0; down < 2; down++) picture_free(&out[down]);
}
END_TEST

// Whichever is added first, the upper plate shades the lower one.
// Rejects: a map that keeps the last thing that it met.
START_TEST(the_first_thing_met_throws_the_shadow)
{
    for (int order = 0; order < 2; order++) {
        painter p = above(0);
        p.lamp = vec3_unit(vec3_make(1, 1, 0));
        add_plate(&p, order ? 0.8 : 2, order ? 1.5 : 0.2, RED, 0);
        add_plate(&p, order ? 2 : 0.8, order ? 0.2 : 1.5, RED, 0);
        picture out = painted(&p);
        real metre = SIDE / 7.28;
        real shaded = point_of(&out, (int)(30 - 1.4 * metre), 30).x;
        real open = point_of(&out, (int)(30 + 1.4 * metre), 30).x;
        ck_assert_msg(shaded < 0.75 * open, "order %d: %g, %g", order, shaded,
                      open);
        picture_free(&out);
        painter_free(&p);
    }
}
END_TEST

// Seen at a slant, a plane made of two large triangles shows the shadow where
// the floor, which is found by its own formula, shows it.
// Rejects: weights that forget that what is far looks small.
START_TEST(a_shadow_lies_right_in_perspective)
{
    picture out[2];
    for (int mesh = 0; mesh < 2; mesh++) {
        painter p = studio();
        p.lamps = 4;
        p.floor = RED;
        painter_look(&p, vec3_make(0, 3, 5), vec3_make(0, 0, 0), 40);
        painter_floor(&p, vec3_make(-100, 0, -100), 1e4, 1e4);   // one tile
        add_plate(&p, 0.5, 1, GREEN, 0);
        if (mesh) {
            p.has_floor = 0;
            add_plate(&p, 4, 0, RED, 0);
            for (int k = 1; k <= 2; k++) p.triangle[p.count - k].casts = 0;
        }
        out[mesh] = painted(&p);
        painter_free(&p);
    }
    int different = 0;
    for (int i = 0; i < SIDE * SIDE / 2; i++) {
        int k = SIDE * SIDE / 4 + i;
        different += fabs(out[0].at[k].x - out[1].at[k].x) > 0.06;
    }
    ck_assert_int_eq(different, 0);
    for (int k = 0; k < 2; k++) picture_free(&out[k]);
}
END_TEST

// The plate is 1 m over the floor, the lamp's direction (1, 1, 0): the middle
// of the shadow is 1 m to the left of the plate.  7.28 m are 60 points.
// Rejects: a shadow on the lamp's side, light that goes through.
START_TEST(a_shadow_falls_away_from_the_lamp)
{
    painter p = above(1);
    p.lamp = vec3_unit(vec3_make(1, 1, 0));
    picture out = painted(&p);
    real metre = SIDE / 7.28;
    int left = (int)(30 - metre), right = (int)(30 + metre);
    real open = point_of(&out, 5, 5).y;
    ck_assert(point_of(&out, left, 30).y < 0.75 * open);
    ck_assert(point_of(&out, right, 30).y > 0.8 * open);
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// The widest step of light from point to point along the middle row.
static real sharpest(real high)
{
    painter p = above(high);
    p.lamp = vec3_unit(vec3_make(1, 1, 0));
    p.lamp_size = 0.25;
    painter_look(&p, vec3_make(-high, 10, 0.01), vec3_make(-high, 0, 0), 20);
    picture out = painted(&p);
    real most = 0;
    for (int x = 1; x < SIDE; x++) {
        colour a = point_of(&out, x - 1, 30), b = point_of(&out, x, 30);
        // Leave the plate itself out, which is red.
        if (a.y > 0.1 && b.y > 0.1) most = fmax(most, fabs(a.y - b.y));
    }
    picture_free(&out);
    painter_free(&p);
    return most;
}

// Rejects: one lamp, whose shadow is as sharp from any height.
START_TEST(the_higher_the_softer)
{
    real low = sharpest(0.4), high = sharpest(2);
    ck_assert_msg(high < 0.7 * low, "%g at 0.4 m, %g at 2 m", low, high);
}
END_TEST

// A ball throws a shadow on itself only where it turns away from the lamp.
// Rejects: the dark speckles of a map without its lift.
START_TEST(a_ball_is_smoothly_shaded)
{
    painter p = studio();
    p.lamps = 4;
    p.lamp = vec3_unit(vec3_make(0, 0.3, 1));
    ck_assert(painter_ball(&p, vec3_make(0, 0, 0), 1,
                           vec3_make(0.5, 0.5, 0.5)).ok);
    picture out = painted(&p);
    // It is not in its own shadow: half of the lamp's and the sky's light.
    ck_assert(point_of(&out, SIDE / 2, SIDE / 2).y > 0.4);
    // The middle two thirds face us and the lamp: no step there is large.
    for (int y = 22; y < 38; y++)
        for (int x = 22; x < 37; x++) {
            real step = fabs(point_of(&out, x, y).y
                             - point_of(&out, x + 1, y).y);
            ck_assert_msg(step < 0.08, "%g at %d, %d", step, x, y);
        }
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// ---- Ropes and creases -----------------------------------------------------

// Rejects: a ring that has no direction left to stand on.
START_TEST(a_rope_is_whole_whichever_way_it_runs)
{
    const vec3 ways[] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0.001, 0 },
                          { 0.36, 0.48, 0.8 }, { -0.36, -0.48, -0.8 } };
    for (size_t k = 0; k < sizeof ways / sizeof *ways; k++) {
        painter p = studio();
        vec3 at[3] = { { 0, 0, 0 }, ways[k], vec3_scale(2, ways[k]) };
        ck_assert(painter_rope(&p, at, 3, 0.1, RED, GREEN).ok);
        ck_assert_int_gt(p.count, 100);
        for (int t = 0; t < p.count; t++)
            for (int i = 0; i < 3; i++) {
                ck_assert(vec3_is_finite(p.triangle[t].corner[i]));
                ck_assert(vec3_is_finite(p.triangle[t].normal[i]));
            }
        // The first ring stands square to the rope, a radius around its end.
        for (int t = 0; t < 24; t++) {
            vec3 out = vec3_sub(p.triangle[t].corner[0], at[0]);
            ck_assert_msg(fabs(vec3_length(out) - 0.1) < 1e-9
                          && fabs(vec3_dot(out, vec3_unit(ways[k]))) < 1e-9,
                          "way %zu, face %d: %g m", k, t, vec3_length(out));
        }
        painter_free(&p);
    }
}
END_TEST

START_TEST(a_rope_of_coincident_points_is_finite)
{
    painter p = studio();
    vec3 at[4] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 } };
    ck_assert(painter_rope(&p, at, 4, 0.1, RED, GREEN).ok);
    for (int t = 0; t < p.count; t++)
        ck_assert(vec3_is_finite(p.triangle[t].corner[0]));
    picture out = painted(&p);
    for (int i = 0; i < SIDE * SIDE; i++) ck_assert(vec3_is_finite(out.at[i]));
    picture_free(&out);
    painter_free(&p);
}
END_TEST

// Rejects: a rim along the diagonal of a box's side.
START_TEST(only_bent_edges_are_creases)
{
    vec3 at[6] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
                   { 0, 0, -1 }, { 0, 1, -1 } };
    // A flat square and, bent by 90 degrees at its left side, one more face.
    const int face[] = { 0, 1, 2, 1, 3, 2, 0, 2, 5 };
    painted_mesh m = { .vertices = 6, .at = at, .faces = 3, .face = face,
                       .creases = 1 };
    painter p = studio();
    ck_assert(painter_mesh(&p, &m).ok);
    ck_assert(p.triangle[0].crease[0] == 0);    // the diagonal
    ck_assert(p.triangle[0].crease[1] > 0);     // 2 to 0, bent
    ck_assert(p.triangle[0].crease[2] == 0);    // 0 to 1, a rim
    ck_assert(p.triangle[2].crease[2] > 0);     // the other side of the bend
    painter_free(&p);
}
END_TEST

START_TEST(nothing_is_painted_of_nothing)
{
    painter p = studio();
    painted_mesh none = { .faces = 0 };
    ck_assert(painter_mesh(&p, &none).ok);
    ck_assert_int_eq(p.count, 0);
    picture out = painted(&p);
    for (int i = 0; i < SIDE * SIDE; i++)
        ck_assert(out.at[i].x > 0.7 && out.at[i].x < 1);
    picture_free(&out);
    painter_free(&p);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        every_byte_comes_back,
        impossible_light_is_black_or_white,
        sizes_out_of_range_are_refused,
        a_file_that_cannot_be_leaves_nothing,
        an_old_file_stays_until_the_new_one_is_whole,
        a_link_stays_a_link,
        two_programs_do_not_write_one_file,
        what_a_killed_program_left_is_taken_over,
        one_file_is_known_by_all_its_names,
        a_file_is_known_by_its_folder,
        a_check_leaves_no_trace,
        a_packed_picture_has_the_same_points_in_fewer_bytes,
        what_is_no_picture_is_not_packed,
        every_letter_is_drawn_and_no_two_alike,
        letters_are_cut_at_the_rim,
        text_is_as_wide_as_it_measures,
        the_nearer_hides_the_farther,
        right_is_right_and_up_is_up,
        a_square_covers_its_area,
        a_rim_is_smooth,
        the_back_has_its_own_colour,
        what_cannot_be_seen_is_left_out,
        a_box_is_kept_to,
        an_empty_floor_is_evenly_lit,
        a_back_is_lit_as_a_front,
        the_first_thing_met_throws_the_shadow,
        a_shadow_lies_right_in_perspective,
        a_shadow_falls_away_from_the_lamp,
        the_higher_the_softer,
        a_ball_is_smoothly_shaded,
        a_rope_is_whole_whichever_way_it_runs,
        a_rope_of_coincident_points_is_finite,
        only_bent_edges_are_creases,
        nothing_is_painted_of_nothing,
        NULL
    };
    if (!mkdtemp(folder)) return 2;
    int failed = suite_run((suite){
        .name = "painter", .tests = tests, .seconds = 20
    });
    const char *made[] = { "bytes.png", "odd.png", "old", "link", "target",
                           "pack.png" };
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        remove(in_folder(made[i]));
    rmdir(folder);
    return failed;
}
