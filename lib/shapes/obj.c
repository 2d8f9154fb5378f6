//> obj-file
//>   Every refusal names the line of the file, because that is what an author
//>   can find.
#include "obj.h"
#include "convex.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_OBJ_BYTES     = 1 << 24,
    MOST_OBJ_LINE      = 1 << 16,               // characters, lines joined
    MOST_OBJ_VERTICES  = 4096,
    MOST_OBJ_TRIANGLES = 2 * MOST_OBJ_VERTICES  // a sphere has 2 n - 4
};

// What is known of the file.  Vertices count from 0 here, from 1 in the file.
typedef struct {
    char name[44];              // the path, or its end
    int  bytes, newlines;       // read so far
    int  line;                  // where the text begins, from 1
    char text[MOST_OBJ_LINE];   // one line, its comment cut off
    int  vertices, triangles;
    vec3 at[MOST_OBJ_VERTICES];
    int  vertex_line[MOST_OBJ_VERTICES];
    int  triangle[MOST_OBJ_TRIANGLES][3];
    int  triangle_line[MOST_OBJ_TRIANGLES];
    int  place[MOST_OBJ_VERTICES];      // of a vertex, without the unused ones
} obj_file;

static status refuse_line(const obj_file *o, const char *what)
{
    return status_fail("%s, line %d: %s", o->name, o->line, what);
}
//<

//> obj-text
//>   A line is read character by character, so that a comment needs no memory
//>   and a zero byte is noticed.
// A newline ends the line, unless the text ends in a backslash: then the next
// line goes on with the same statement.  Comments are not in the text.
static bool is_continued(obj_file *o, int *length)
{
    int last = *length - 1;
    if (last >= 0 && o->text[last] == '\r') last--;
    if (last < 0 || o->text[last] != '\\') return false;
    o->text[last] = ' ';
    *length = last + 1;
    return true;
}

// Puts the next line into the text; *more is false where the file ends.
static status next_line(obj_file *o, FILE *in, bool *more)
{
    int c, length = 0;
    bool comment = false;
    o->line = o->newlines + 1;
    while ((c = getc(in)) != EOF) {
        if (++o->bytes > MOST_OBJ_BYTES)
            return status_fail("%s: the file is larger than 16 MB", o->name);
        if (c == 0)
            return refuse_line(o, "the file is not text: here is a zero byte");
        o->newlines += c == '\n';
        if (c == '\n' && !is_continued(o, &length)) break;
        comment = c != '\n' && (comment || c == '#');
        if (comment || c == '\n') continue;
        if (length == MOST_OBJ_LINE - 1)
            return refuse_line(o, "the line is longer than 65535 characters");
        o->text[length++] = (char)c;
    }
    if (ferror(in))
        return status_fail("%s: cannot be read: %s", o->name, strerror(errno));
    o->text[length] = 0;
    *more = c != EOF;
    return status_ok();
}
//<

//> obj-words
//>   The words of a line, one after the other.
static const char SPACES[] = " \t\r\v\f";

static const char *skip_space(const char *c) { return c + strspn(c, SPACES); }
static const char *skip_word(const char *c) { return c + strcspn(c, SPACES); }

static status refuse_word(const obj_file *o, const char *word, const char *what)
{
    int length = int_min((int)(skip_word(word) - word), 20);
    return status_fail("%s, line %d: '%.*s' is not %s", o->name, o->line,
                       length, word, what);
}
//<

//> obj-number
//>   We read numbers ourselves. In a German locale the C library takes a comma
//>   for the decimal point.
static bool is_digit(char c) { return c >= '0' && c <= '9'; }

// digits * 10^power.  Powers of ten are exact up to 1e22: the up to 15 digits
// that most files hold are rounded once.
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

// Reads the exponent of a number, e+12, or 0 if there is none.  Returns what
// follows it, or NULL if it has no digit.
static const char *read_exponent(const char *c, int *power)
{
    *power = 0;
    if (*c != 'e' && *c != 'E') return c;
    bool negative = *++c == '-';
    if (*c == '-' || *c == '+') c++;
    if (!is_digit(*c)) return NULL;
    for (; is_digit(*c); c++)
        if (*power < 10000) *power = 10 * *power + (*c - '0');
    if (negative) *power = -*power;
    return c;
}

// Reads one decimal number, the same in every locale: in some, strtod takes a
// comma for the point.  Returns what follows the number, or NULL if the word is
// no number.
static const char *read_number(const char *c, real *value)
{
    bool negative = *c == '-', point = false, any = false;
    int power = 0, exponent;
    unsigned long long digits = 0;
    if (*c == '-' || *c == '+') c++;
    for (; is_digit(*c) || (*c == '.' && !point); c++) {
        if (*c == '.') { point = true; continue; }
        any = true;
        bool fits = digits < 100000000000000000ULL;     // 18 digits do
        if (fits) digits = 10 * digits + (unsigned long long)(*c - '0');
        power += !fits - point;
    }
    c = any ? read_exponent(c, &exponent) : NULL;
    if (!c || c != skip_word(c)) return NULL;
    *value = scale_by_ten((real)digits, power + exponent);
    if (negative) *value = -*value;
    return c;
}
//<

//> obj-vertex
// Reads x, y and z; a weight or a colour after them is ignored.
static status read_vertex(obj_file *o, const char *c)
{
    real xyz[3];
    if (o->vertices == MOST_OBJ_VERTICES)
        return refuse_line(o, "a file may have 4096 vertices at most");
    for (int k = 0; k < 3; k++) {
        c = skip_space(c);
        if (!*c) return refuse_line(o, "a vertex needs three numbers");
        const char *end = read_number(c, &xyz[k]);
        if (!end) return refuse_word(o, c, "a number");
        if (!(fabs(xyz[k]) <= 1e30))
            return refuse_word(o, c, "a coordinate of at most 1e30");
        c = end;
    }
    o->vertex_line[o->vertices] = o->line;
    o->at[o->vertices++] = vec3_make(xyz[0], xyz[1], xyz[2]);
    return status_ok();
}
//<

//> obj-face
//>   A corner of a face may name a texture and a normal after slashes, and may
//>   count from the end. Larger faces are cut into a fan.
// Reads `7`, `7/1`, `7//3` or `7/1/3`, or with a minus sign, which counts back
// from the last vertex above the line.  *corner counts from 0; its vertex may
// still be to come.
static status read_corner(const obj_file *o, const char *word, int *corner)
{
    char *end;
    long index = strtol(word, &end, 10);
    if (end == word || (*end != '/' && end != skip_word(word)))
        return refuse_word(o, word, "the index of a vertex");
    if (index == 0 || index > MOST_OBJ_VERTICES)
        return refuse_word(o, word, "an index from 1 to 4096");
    if (index < -o->vertices)
        return status_fail("%s, line %d: a face uses vertex %ld, but only %d "
                           "stand above it", o->name, o->line, index,
                           o->vertices);
    *corner = (int)(index < 0 ? o->vertices + index : index - 1);
    return status_ok();
}

// Cuts a face of n corners into the n - 2 triangles at its first corner.
static status read_face(obj_file *o, const char *c)
{
    int corners = 0, first = 0, last = 0, corner = 0;
    for (c = skip_space(c); *c; c = skip_space(skip_word(c))) {
        status s = read_corner(o, c, &corner);
        if (!s.ok) return s;
        if (corners == 0) first = corner;
        if (corners++ > 1) {
            if (o->triangles == MOST_OBJ_TRIANGLES)
                return refuse_line(o, "a body may have 8192 triangles at most");
            int *v = o->triangle[o->triangles];
            v[0] = first;
            v[1] = last;
            v[2] = corner;
            o->triangle_line[o->triangles++] = o->line;
        }
        last = corner;
    }
    return corners < 3 ? refuse_line(o, "a face needs three corners") : status_ok();
}
//<

//> obj-lines
// Some editors begin UTF-8 text with three bytes, the byte order mark.
static status read_line(obj_file *o)
{
    const char *mark = "\xEF\xBB\xBF", *text = o->text;
    bool marked = o->line == 1 && strncmp(text, mark, 3) == 0;
    const char *word = skip_space(text + 3 * marked), *end = skip_word(word);
    if (end == word + 1 && *word == 'v') return read_vertex(o, end);
    if (end == word + 1 && *word == 'f') return read_face(o, end);
    return status_ok();
}

static status read_lines(obj_file *o, FILE *in)
{
    bool more = true;
    while (more) {
        status s = next_line(o, in, &more);
        if (s.ok) s = read_line(o);
        if (!s.ok) return s;
    }
    if (o->vertices == 0)
        return status_fail("%s: no vertex: no line begins with v", o->name);
    if (o->triangles == 0)
        return status_fail("%s: no face: no line begins with f", o->name);
    return status_ok();
}

// Faces may stand before their vertices, so this waits for the last line.
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
//<

//> obj-drop-unused
//>   A vertex that no face uses would move the centre, so it is dropped.
// Drops the vertices that no face uses; the others keep their order.
static void drop_unused(obj_file *o)
{
    int kept = 0;
    for (int v = 0; v < o->vertices; v++) o->place[v] = -1;
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++) o->place[o->triangle[t][k]] = 0;
    for (int v = 0; v < o->vertices; v++) {
        if (o->place[v] < 0) continue;
        o->at[kept] = o->at[v];
        o->vertex_line[kept] = o->vertex_line[v];
        o->place[v] = kept++;
    }
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++)
            o->triangle[t][k] = o->place[o->triangle[t][k]];
    o->vertices = kept;
}
//<

//> obj-scale
//>   A mesh in millimetres would be a giant, so each is scaled to the size that
//>   is asked for.
// Moves the centre of mass to the origin, the farthest vertex to `radius`.
static status centre_and_scale(obj_file *o, real radius)
{
    vec3 centre = { 0, 0, 0 };
    real farthest = 0;
    for (int v = 0; v < o->vertices; v++)
        centre = vec3_add_scaled(centre, 1 / (real)o->vertices, o->at[v]);
    for (int v = 0; v < o->vertices; v++)
        farthest = real_max(farthest, vec3_distance(o->at[v], centre));
    if (!(farthest > 0))
        return status_fail("%s: all vertices stand in the same place", o->name);
    for (int v = 0; v < o->vertices; v++)
        o->at[v] = vec3_scale(radius / farthest, vec3_sub(o->at[v], centre));
    return status_ok();
}
//<

//> obj-turn
//>   If all faces are turned inwards, the volume is negative, and they are
//>   turned round. If only some are, nothing can be guessed.
// A closed mesh of negative volume looks inwards: some programs count the
// corners clockwise.  Turns every triangle round.
static void turn_outwards(obj_file *o)
{
    real volume = 0;
    for (int t = 0; t < o->triangles; t++) {
        const int *v = o->triangle[t];
        volume += vec3_dot(o->at[v[0]],
                           vec3_cross(o->at[v[1]], o->at[v[2]]));
    }
    for (int t = 0; t < o->triangles && volume < 0; t++)
        SWAP(int, o->triangle[t][1], o->triangle[t][2]);
}
//<

//> obj-translate
//>   The mesh names a faulty triangle by its number, from 0. An author wants
//>   the line of the file, so the sentence is translated.
// A sentence about the mesh says `triangle 7` and `vertex 12`; the author of
// the file knows lines.  `vertex 7` may grow to 29 characters: four times the
// room holds a sentence full of them.
static status translate(const obj_file *o, status s)
{
    char why[4 * sizeof s.why] = "", *out = why;
    for (const char *c = s.why; *c; ) {
        int t = -1, v = -1, used = 1;
        sscanf(c, "triangle %d%n", &t, &used);
        sscanf(c, "vertex %d%n", &v, &used);
        if (t >= 0)
            out += sprintf(out, "the face of line %d", o->triangle_line[t]);
        else if (v >= 0)
            out += sprintf(out, "the vertex of line %d", o->vertex_line[v]);
        else
            *out++ = *c;
        c += used;
    }
    return status_fail("%s: %s", o->name, why);
}
//<

//> obj-read
//>   A file becomes a mesh, or a sentence that says what is wrong with it, and
//>   in which line.
static status read_file(obj_file *o, const char *path, real radius, real mass,
                        shape *s)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return status_fail("%s: cannot be opened: %s", o->name,
                           strerror(errno));
    status r = read_lines(o, in);
    fclose(in);
    if (r.ok) r = check_indices(o);
    if (!r.ok) return r;

    drop_unused(o);
    r = centre_and_scale(o, radius);
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
    obj_file *o = calloc(1, sizeof *o);
    if (!o) return status_out_of_memory();

    // The end of a path says more than its beginning.
    size_t length = strlen(path);
    snprintf(o->name, sizeof o->name, "%s%s", length > 40 ? "..." : "",
             length > 40 ? path + length - 40 : path);
    status r = status_fail("%s: the radius is %g m: it must be a number from "
                           "1e-30 to 1e30", o->name, radius);
    if (radius >= 1e-30 && radius <= 1e30)
        r = read_file(o, path, radius, mass, s);
    free(o);
    return r;
}
//<
