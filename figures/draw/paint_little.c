// paint_little.c - paints what the little program draws:
//   stage-09b draw | paint-little FILE.png [PANELS]
// reads frames from its input and paints the last one, or so many of them side by
// side: most from the beginning, where most happens.  With `film` for PANELS, FILE
// is a folder, and every frame is a picture there: frame-0000.png and so on.
//
// A line of the input is `frame`, `body`, `line x y z x y z` or `face` with three
// corners (m).  `body` begins a new one, which has a colour of its own.  Lines
// that follow each other are a rope; many faces are a cloth.

#include "painter.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PANELS = 6, POINTS = 60000, CLOTH_FACES = 100 };
enum { WIDTH = 760, HEIGHT = 640, GUTTER = 8 };

// The body that is being read: three corners a face, two points a line.
typedef struct {
    vec3 at[POINTS];
    int  face[POINTS];
    int  corners, points, lines, number;
} sheet;

static sheet now;
static int lamps;       // as the painter wants it

static const unsigned tones[] = {
    0xe69f00, 0x56b4e9, 0x009e73, 0xefdc4a, 0x0072b2, 0xd55e00, 0xcc79a7
};

// The index of a point, which faces share if they have it to the last digit.
static int point_index(vec3 x)
{
    for (int i = now.points - 1; i >= 0; i--)
        if (vec3_distance(now.at[i], x) == 0) return i;
    if (now.points == POINTS) return POINTS - 1;
    now.at[now.points] = x;
    return now.points++;
}

static status paint_faces(painter *p)
{
    bool cloth = now.corners / 3 > CLOTH_FACES;
    colour c = colour_hex(tones[now.number % 7]), grey = colour_hex(0xd9dde2);
    painted_mesh m = { .vertices = now.points, .at = now.at,
        .faces = now.corners / 3, .face = now.face, .front = { c, c },
        .back = { cloth ? colour_mix(c, grey, 0.6) : c, c },
        .smooth = cloth, .creases = !cloth, .casts = 1,
        .gloss = cloth ? 0.04 : 0.3 };
    return painter_mesh(p, &m);
}

// Are the lines one behind the other, as those of a rope?
static bool is_chain(void)
{
    for (int i = 0; i < now.lines; i++)
        if (now.face[2 * i] != i || now.face[2 * i + 1] != i + 1) return false;
    return true;
}

static status paint_lines(painter *p)
{
    status done = status_ok();
    if (is_chain())
        return painter_rope(p, now.at, now.points,
                            0.3 * vec3_distance(now.at[0], now.at[1]),
                            colour_hex(0xead5a8), colour_hex(0xb28b4f));
    for (int i = 0; i < now.lines && done.ok; i++)
        done = painter_line(p, now.at[now.face[2 * i]],
                            now.at[now.face[2 * i + 1]], 0.004,
                            colour_hex(tones[4]));
    return done;
}

static status finish_body(painter *p)
{
    status done = status_ok();
    if (now.lines > 0) done = paint_lines(p);
    else if (now.corners > 0) done = paint_faces(p);
    now.corners = now.points = now.lines = 0;
    now.number++;
    return done;
}

// The points of a line of the input.
static void parse_points(const char *line, int n, vec3 x[3])
{
    const char *rest = line + 4;
    for (int i = 0; i < n; i++) {
        char *end;
        x[i].x = strtod(rest, &end);
        x[i].y = strtod(end, &end);
        x[i].z = strtod(end, &end);
        rest = end;
    }
}

// Adds a line of the input to the body.
static void read_points(const char *line, int n)
{
    vec3 x[3];
    if (now.corners + 3 > POINTS) return;
    parse_points(line, n, x);
    now.lines += n == 2;
    for (int i = 0; i < n; i++) now.face[now.corners++] = point_index(x[i]);
}

// What the picture must hold: a box around the first point of every line, as far
// as these are within ROOM of the middle.
static const real ROOM = 4;     // m
static vec3 low, high;

static void widen(const char *text)
{
    low = vec3_make(ROOM, ROOM, ROOM), high = vec3_make(-ROOM, 0, -ROOM);
    for (const char *at = text; at; at = strchr(at + 1, '\n')) {
        vec3 x[3];
        if (strncmp(at, "\nline ", 6) && strncmp(at, "\nface ", 6)) continue;
        parse_points(at + 1, 1, x);
        low = vec3_make(real_min(low.x, real_max(x[0].x, -ROOM)), 0,
                        real_min(low.z, real_max(x[0].z, -ROOM)));
        high = vec3_make(real_max(high.x, real_min(x[0].x, ROOM)),
                         real_max(high.y, real_min(x[0].y, ROOM)),
                         real_max(high.z, real_min(x[0].z, ROOM)));
    }
}

static void stand(painter *p)
{
    vec3 target = vec3_scale(0.5, vec3_add(low, high));
    real size = real_max(vec3_distance(low, high), 1);
    vec3 from = vec3_unit(vec3_make(2.6, 3.2, 8.6));
    target.y *= 0.8;
    real away = real_max(1.3 * size, 2.7 * high.y);
    painter_look(p, vec3_add_scaled(target, away, from), target, 32);
    painter_floor(p, vec3_make(target.x, 0, target.z), 1.6 * size, 0.5);
    p->lamp = vec3_unit(vec3_make(0.35, 1, 0.55));
}

// Paints the frame that begins at `from`, up to the next one.
static status paint_frame(const char *from, picture *out, int left)
{
    painter p;
    status done = status_ok();
    painter_init(&p);
    p.lamps = lamps;
    stand(&p);
    memset(&now, 0, sizeof now);
    now.number = -1;
    for (const char *line = strchr(from, '\n'); done.ok && line && line[1];
         line = strchr(line + 1, '\n')) {
        if (strncmp(line + 1, "frame", 5) == 0) break;
        if (strncmp(line + 1, "body", 4) == 0) done = finish_body(&p);
        if (strncmp(line + 1, "line ", 5) == 0) read_points(line + 1, 2);
        if (strncmp(line + 1, "face ", 5) == 0) read_points(line + 1, 3);
    }
    if (done.ok) done = finish_body(&p);
    if (done.ok) done = painter_paint(&p, out, left, 0, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

// All of the input, ended by a zero; NULL for want of memory.
static char *read_all(FILE *in)
{
    size_t size = 0, room = 1 << 20;
    char *text = malloc(room);
    while (text) {
        size += fread(text + size, 1, room - size - 1, in);
        if (size < room - 1) break;
        char *more = realloc(text, room *= 2);
        if (!more) free(text);
        text = more;
    }
    if (text) text[size] = 0;
    return text;
}

// Frame k, counted from 0; NULL: there are not so many.
static const char *frame_find(const char *text, int k)
{
    const char *at = strncmp(text, "frame", 5) == 0 ? text
                                                    : strstr(text, "\nframe");
    for (; at && k > 0; k--) at = strstr(at + 1, "\nframe");
    return at && *at == '\n' ? at + 1 : at;
}

// Some frames of the text side by side.
static status paint_panels(const char *text, int frames, int panels,
                           const char *path)
{
    picture out;
    status done = picture_init(&out, (WIDTH + GUTTER) * panels - GUTTER, HEIGHT,
                               vec3_make(1, 1, 1));
    for (int i = 0; i < panels && done.ok; i++) {
        int k = (i + 1) * (i + 1) * frames / (panels * panels) - 1;
        done = paint_frame(frame_find(text, k > 0 ? k : 0), &out,
                           i * (WIDTH + GUTTER));
    }
    if (done.ok) done = picture_write(&out, path);
    picture_free(&out);
    return done;
}

static status paint_film(const char *text, int frames, const char *folder)
{
    status done = status_ok();
    for (int k = 0; k < frames && done.ok; k++) {
        picture out;
        char path[1000];
        snprintf(path, sizeof path, "%s/frame-%04d.png", folder, k);
        done = picture_init(&out, WIDTH, HEIGHT, vec3_make(1, 1, 1));
        if (done.ok) done = paint_frame(frame_find(text, k), &out, 0);
        if (done.ok) done = picture_write(&out, path);
        picture_free(&out);
    }
    return done;
}

int main(int count, char **arguments)
{
    bool film = count > 2 && strcmp(arguments[2], "film") == 0;
    int panels = film ? MOST_PANELS : count > 2 ? atoi(arguments[2]) : 1;
    int frames = 0;
    char *text = count > 1 && panels > 0 && panels <= MOST_PANELS
               ? read_all(stdin) : NULL;
    while (text && frame_find(text, frames)) frames++;
    if (frames == 0) {
        fprintf(stderr, "usage: paint-little FILE.png [PANELS] < frames\n");
        free(text);
        return 1;
    }
    widen(text);
    lamps = film ? 3 : 6;
    status done = film ? paint_film(text, frames, arguments[1])
                       : paint_panels(text, frames, panels, arguments[1]);
    if (!done.ok) fprintf(stderr, "%s\n", done.why);
    free(text);
    return !done.ok;
}
