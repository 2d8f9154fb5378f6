//> obj-file
#include "obj.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_OBJ_VERTICES = 4096,
    MOST_OBJ_BYTES    = 1 << 24,
    MOST_NAME         = 40      // of a path, in a sentence
};

// What is known of the file.  Vertices count from 0 here, from 1 in the file.
typedef struct {
    char  name[MOST_NAME + 4];  // the path, or its end
    char *text;                 // the bytes and a 0 after them
    size_t length;
    int   vertices, triangles;
    vec3 *at;                   // [vertices]
    int  *vertex_line;          // [vertices] where it stands, for the sentences
    int (*triangle)[3];         // [triangles]
    int  *triangle_line;        // [triangles]
} obj_file;

// The end of a path tells more than its beginning.
static void obj_name(obj_file *o, const char *path)
{
    size_t length = strlen(path);
    int cut = length > MOST_NAME;
    snprintf(o->name, sizeof o->name, "%s%s", cut ? "..." : "",
             cut ? path + length - MOST_NAME : path);
}

static void obj_free(obj_file *o)
{
    free(o->text);
    free(o->at);
    free(o->vertex_line);
    free(o->triangle);
    free(o->triangle_line);
}
//<

//> obj-read-text
// The whole file in one block, which doubles as it fills.
static status read_stream(obj_file *o, FILE *in)
{
    size_t room = 0, got;
    do {
        if (o->length + 1 >= room) {
            room = room ? 2 * room : 4096;
            char *more = realloc(o->text, room);
            if (!more) return status_out_of_memory();
            o->text = more;
        }
        got = fread(o->text + o->length, 1, room - 1 - o->length, in);
        o->length += got;
    } while (got > 0 && o->length <= MOST_OBJ_BYTES);
    o->text[o->length] = 0;

    if (ferror(in))
        return status_fail("%s: cannot be read: %s", o->name, strerror(errno));
    if (o->length > MOST_OBJ_BYTES)
        return status_fail("%s: the file is larger than %d MB", o->name,
                           MOST_OBJ_BYTES >> 20);
    return status_ok();
}

static status read_text(obj_file *o, const char *path)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return status_fail("%s: cannot be opened: %s", o->name,
                           strerror(errno));
    status s = read_stream(o, in);
    fclose(in);
    if (!s.ok) return s;

    if (o->length == 0) return status_fail("%s: the file is empty", o->name);
    if (memchr(o->text, 0, o->length))
        return status_fail("%s: the file is not text: it holds a zero byte",
                           o->name);

    // Some editors write three bytes before UTF-8 text that say that it is.
    if (strncmp(o->text, "\xEF\xBB\xBF", 3) == 0) memset(o->text, ' ', 3);
    return s;
}
//<

//> obj-words
static int is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// A line ends at its newline, at a comment or with the file.
static int is_end(char c)
{
    return c == '\n' || c == '#' || c == 0;
}

static const char *skip_space(const char *c)
{
    while (is_space(*c)) c++;
    return c;
}

static const char *skip_word(const char *c)
{
    while (!is_space(*c) && !is_end(*c)) c++;
    return c;
}

static const char *next_line(const char *c)
{
    while (*c && *c != '\n') c++;
    return *c ? c + 1 : c;
}
//<

//> obj-lines
// The first word of a line, if it is that one letter, else NULL; returns what
// stands after it.
static const char *after_key(const char *line, char key)
{
    line = skip_space(line);
    return line[0] == key && (is_space(line[1]) || is_end(line[1]))
         ? line + 1 : NULL;
}

static int count_words(const char *c)
{
    int words = 0;
    for (c = skip_space(c); !is_end(*c); c = skip_space(skip_word(c))) words++;
    return words;
}

// How many characters of a bad word a sentence quotes.
static int quoted(const char *c)
{
    int length = (int)(skip_word(c) - c < 20 ? skip_word(c) - c : 20);
    return length;
}
//<

//> obj-number
static int is_digit(char c) { return c >= '0' && c <= '9'; }

// digits * 10^power.  Powers of ten are exact up to 1e22, and so is the result
// of one step, rounded once, for the up to 15 digits that files hold.
static real scale_by_ten(real digits, int power)
{
    int left = power < 0 ? -power : power;
    while (left > 0 && digits != 0) {
        real ten = 1;
        for (int k = 0; k < 22 && left > 0; k++, left--) ten *= 10;
        digits = power < 0 ? digits / ten : digits * ten;
    }
    return digits;
}

// The exponent of a number, e+12, or 0 if there is none.  *c moves behind it;
// 1 if it is well formed.
static int read_exponent(const char **c, int *power)
{
    *power = 0;
    if (**c != 'e' && **c != 'E') return 1;
    (*c)++;
    int negative = **c == '-';
    if (**c == '-' || **c == '+') (*c)++;
    if (!is_digit(**c)) return 0;
    for (; is_digit(**c); (*c)++)
        if (*power < 10000) *power = 10 * *power + (**c - '0');
    if (negative) *power = -*power;
    return 1;
}
//<

//> obj-decimal
// Reads one decimal number, the same in every locale (strtod would take a
// comma in some).  Returns what follows it, or NULL if it is not a number.
static const char *read_number(const char *c, real *value)
{
    int negative = *c == '-', digits = 0, power = 0, exponent;
    if (*c == '-' || *c == '+') c++;
    unsigned long long all = 0;
    for (int point = 0; is_digit(*c) || (*c == '.' && !point); c++) {
        if (*c == '.') { point = 1; continue; }
        digits = 1;
        int fits = all < 100000000000000000ULL;     // 18 digits fit in 64 bits
        if (fits) all = 10 * all + (unsigned long long)(*c - '0');
        power += !fits - point;
    }
    if (!digits || !read_exponent(&c, &exponent)) return NULL;
    if (!is_space(*c) && !is_end(*c)) return NULL;
    *value = scale_by_ten((real)all, power + exponent);
    if (negative) *value = -*value;
    return c;
}
//<

//> obj-vertex
// Reads x, y and z; a weight or a colour behind them is passed over.
static status read_vertex(obj_file *o, const char *c, int line)
{
    real xyz[3];
    for (int k = 0; k < 3; k++) {
        c = skip_space(c);
        if (is_end(*c))
            return status_fail("%s, line %d: a vertex needs three numbers, "
                               "this one has %d", o->name, line, k);
        const char *after = read_number(c, &xyz[k]);
        if (!after)
            return status_fail("%s, line %d: '%.*s' is not a number", o->name,
                               line, quoted(c), c);
        if (!(fabs(xyz[k]) <= 1e30))
            return status_fail("%s, line %d: the coordinate %.*s is too large: "
                               "1e30 is the most", o->name, line, quoted(c), c);
        c = after;
    }
    o->vertex_line[o->vertices] = line;
    o->at[o->vertices++] = vec3_make(xyz[0], xyz[1], xyz[2]);
    return status_ok();
}
//<

//> obj-corner
// Reads `7`, `7/1`, `7//3` or `7/1/3`, or with a minus sign, counting back from
// the last vertex above the line.  *corner counts from 0; it may lie beyond the
// vertices read so far, never below 0.
static status read_corner(const obj_file *o, const char *c, int line,
                          int *corner)
{
    const char *word = c;
    int negative = *c == '-', index = 0, digits = 0;
    if (*c == '-' || *c == '+') c++;
    for (; is_digit(*c); c++, digits++)
        if (index < 100000000) index = 10 * index + (*c - '0');
    int well_formed = digits > 0;
    while (is_digit(*c) || *c == '/' || *c == '-') {
        if (*c == '-' && c[-1] != '/') well_formed = 0;
        c++;
    }
    if (!well_formed || (!is_space(*c) && !is_end(*c)))
        return status_fail("%s, line %d: '%.*s' is not the index of a vertex",
                           o->name, line, quoted(word), word);
    if (index == 0)
        return status_fail("%s, line %d: a face uses vertex 0, but vertices "
                           "count from 1", o->name, line);
    *corner = negative ? o->vertices - index : index - 1;
    if (*corner < 0)
        return status_fail("%s, line %d: a face uses vertex -%d, but only %d "
                           "stand above it", o->name, line, index, o->vertices);
    return status_ok();
}
//<

//> obj-face
// Cuts a face of n corners into the n - 2 triangles at its first corner.
static status read_face(obj_file *o, const char *c, int line)
{
    int corners = count_words(c), first = 0, last = 0;
    if (corners < 3)
        return status_fail("%s, line %d: a face needs three corners, this one "
                           "has %d", o->name, line, corners);
    for (int k = 0; k < corners; k++) {
        int corner = 0;
        c = skip_space(c);
        status s = read_corner(o, c, line, &corner);
        if (!s.ok) return s;
        c = skip_word(c);
        if (k == 0) first = corner;
        if (k >= 2) {
            int *v = o->triangle[o->triangles];
            v[0] = first;
            v[1] = last;
            v[2] = corner;
            o->triangle_line[o->triangles++] = line;
        }
        last = corner;
    }
    return status_ok();
}
//<

//> obj-reserve
// Counts first, so that nothing grows while it is filled.
static status reserve(obj_file *o)
{
    int vertices = 0, triangles = 0, line = 1;
    for (const char *c = o->text; *c; c = next_line(c), line++) {
        const char *face = after_key(c, 'f');
        if (after_key(c, 'v') && ++vertices > MOST_OBJ_VERTICES)
            return status_fail("%s, line %d: this is vertex %d: a body may "
                               "have %d at most", o->name, line, vertices,
                               MOST_OBJ_VERTICES);
        if (face && count_words(face) > 2) triangles += count_words(face) - 2;
    }
    if (vertices == 0)
        return status_fail("%s: no vertex: no line begins with v", o->name);

    size_t n = (size_t)vertices, t = (size_t)(triangles > 0 ? triangles : 1);
    o->at            = malloc(n * sizeof *o->at);
    o->vertex_line   = malloc(n * sizeof *o->vertex_line);
    o->triangle      = malloc(t * sizeof *o->triangle);
    o->triangle_line = malloc(t * sizeof *o->triangle_line);
    if (o->at && o->vertex_line && o->triangle && o->triangle_line)
        return status_ok();
    return status_out_of_memory();
}
//<

//> obj-parse
static status check_indices(const obj_file *o)
{
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++)
            if (o->triangle[t][k] >= o->vertices)
                return status_fail("%s, line %d: a face uses vertex %d, but "
                                   "there are only %d", o->name,
                                   o->triangle_line[t], o->triangle[t][k] + 1,
                                   o->vertices);
    return status_ok();
}

static status parse(obj_file *o)
{
    status s = reserve(o);
    int line = 1;
    for (const char *c = o->text; s.ok && *c; c = next_line(c), line++) {
        const char *vertex = after_key(c, 'v'), *face = after_key(c, 'f');
        if (vertex) s = read_vertex(o, vertex, line);
        if (face) s = read_face(o, face, line);
    }
    if (s.ok && o->triangles == 0)
        s = status_fail("%s: no face: no line begins with f", o->name);
    return s.ok ? check_indices(o) : s;
}
//<

//> obj-drop-unused
// Drops the vertices that no face uses; the others keep their order.
static status drop_unused(obj_file *o)
{
    int *place = malloc((size_t)o->vertices * sizeof *place);
    if (!place) return status_out_of_memory();
    for (int v = 0; v < o->vertices; v++) place[v] = -1;
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++) place[o->triangle[t][k]] = 0;

    int kept = 0;
    for (int v = 0; v < o->vertices; v++) {
        if (place[v] < 0) continue;
        o->at[kept] = o->at[v];
        o->vertex_line[kept] = o->vertex_line[v];
        place[v] = kept++;
    }
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++)
            o->triangle[t][k] = place[o->triangle[t][k]];
    o->vertices = kept;
    free(place);
    return status_ok();
}
//<

//> obj-scale
static real largest_component(vec3 a)
{
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

// Centre of mass to the origin, farthest vertex to distance radius.  In two
// steps, first by the largest component: its square may be 0 or infinite.
static status centre_and_scale(obj_file *o, real radius)
{
    vec3 sum = { 0, 0, 0 };
    real largest = 0, farthest = 0;
    for (int v = 0; v < o->vertices; v++)
        sum = vec3_add(sum, vec3_scale(1 / (real)o->vertices, o->at[v]));
    for (int v = 0; v < o->vertices; v++) {
        o->at[v] = vec3_sub(o->at[v], sum);
        largest = fmax(largest, largest_component(o->at[v]));
    }
    if (!(largest > 0))
        return status_fail("%s: all vertices stand in the same place", o->name);

    for (int v = 0; v < o->vertices; v++) {
        vec3 a = o->at[v];
        o->at[v] = vec3_make(a.x / largest, a.y / largest, a.z / largest);
        farthest = fmax(farthest, vec3_length(o->at[v]));
    }
    for (int v = 0; v < o->vertices; v++)
        o->at[v] = vec3_scale(radius / farthest, o->at[v]);
    return status_ok();
}
//<

//> obj-turn
// A closed mesh with a negative volume looks inwards: some programs count the
// other way round.  Turns every triangle.
static void turn_outwards(obj_file *o)
{
    real volume = 0;
    for (int t = 0; t < o->triangles; t++) {
        const int *v = o->triangle[t];
        volume += vec3_dot(o->at[v[0]],
                           vec3_cross(o->at[v[1]], o->at[v[2]]));
    }
    for (int t = 0; t < o->triangles && volume < 0; t++) {
        int *v = o->triangle[t], second = v[1];
        v[1] = v[2];
        v[2] = second;
    }
}
//<

//> obj-translate
// If text begins with kind and a number, that number, and *after is what
// follows it; else -1.
static int names(const char *text, const char *kind, const char **after)
{
    size_t length = strlen(kind);
    if (strncmp(text, kind, length) != 0 || !is_digit(text[length])) return -1;
    int number = 0;
    for (*after = text + length; is_digit(**after); ++*after)
        number = 10 * number + (**after - '0');
    return number;
}

// A complaint about the mesh speaks of `triangle 7` and `vertex 12`; whoever
// wrote the file knows lines.  The triangle becomes the face of its line, the
// vertex that of its own.  `vertex 7` may grow to three times its length, and
// to 29 characters: four times the room holds a sentence full of them.
static status translate(const obj_file *o, status s)
{
    char why[4 * sizeof s.why] = "";
    size_t length = 0;
    for (const char *c = s.why; *c; ) {
        const char *after = c + 1;
        int t = names(c, "triangle ", &after);
        int v = t < 0 ? names(c, "vertex ", &after) : -1;
        assert(t < o->triangles && v < o->vertices);
        size_t room = sizeof why - length;
        int put = t >= 0 ? snprintf(why + length, room, "the face of line %d",
                                    o->triangle_line[t])
                : v >= 0 ? snprintf(why + length, room, "the vertex of line %d",
                                    o->vertex_line[v])
                         : snprintf(why + length, room, "%c", *c);
        length += (size_t)put;
        c = after;
    }
    return status_fail("%s: %s", o->name, why);
}
//<

//> obj-read
static status build(obj_file *o, const char *path, real radius, real mass,
                    shape *s)
{
    status r = read_text(o, path);
    if (r.ok) r = parse(o);
    if (r.ok) r = drop_unused(o);
    if (r.ok) r = centre_and_scale(o, radius);
    if (!r.ok) return r;

    turn_outwards(o);
    r = shape_convex(s, o->vertices, (const vec3 *)o->at, o->triangles,
                     (const int (*)[3])o->triangle, mass);
    return r.ok ? r : translate(o, r);
}

status obj_read(const char *path, real radius, real mass, shape *s)
{
    assert(path && s);
    *s = (shape){ .kind = SHAPE_RIGID };
    obj_file o = { 0 };
    obj_name(&o, path);
    if (!(radius >= 1e-30 && radius <= 1e30))
        return status_fail("%s: the radius is %g m: it must be a number from "
                           "1e-30 to 1e30", o.name, radius);
    status r = build(&o, path, radius, mass, s);
    obj_free(&o);
    return r;
}
//<
