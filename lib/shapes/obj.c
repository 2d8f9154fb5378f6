//> obj-file
#include "obj.h"
#include "convex.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_OBJ_VERTICES  = 4096,
    MOST_OBJ_TRIANGLES = 2 * MOST_OBJ_VERTICES, // a sphere has 2 n - 4
    MOST_OBJ_BYTES     = 1 << 24
};

// What is known of the file.  Vertices count from 0 here, from 1 in the file.
typedef struct {
    char name[44];              // the path, or its end
    char *text;                 // the file, and a 0 after it
    int  vertices, triangles;
    vec3 at[MOST_OBJ_VERTICES];
    int  vertex_line[MOST_OBJ_VERTICES];
    int  triangle[MOST_OBJ_TRIANGLES][3];
    int  triangle_line[MOST_OBJ_TRIANGLES];
} obj_file;
//<

//> obj-read-text
static status read_stream(obj_file *o, FILE *in)
{
    size_t length = fread(o->text, 1, MOST_OBJ_BYTES + 1, in);
    if (ferror(in))
        return status_fail("%s: cannot be read: %s", o->name, strerror(errno));
    if (length > MOST_OBJ_BYTES)
        return status_fail("%s: the file is larger than %d MB", o->name,
                           MOST_OBJ_BYTES >> 20);
    if (length == 0) return status_fail("%s: the file is empty", o->name);
    if (memchr(o->text, 0, length))
        return status_fail("%s: the file is not text: it holds a zero byte",
                           o->name);
    o->text[length] = 0;

    // Some editors write three bytes before UTF-8 text that say that it is.
    if (strncmp(o->text, "\xEF\xBB\xBF", 3) == 0) memset(o->text, ' ', 3);
    return status_ok();
}

static status read_text(obj_file *o, const char *path)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return status_fail("%s: cannot be opened: %s", o->name,
                           strerror(errno));
    o->text = malloc(MOST_OBJ_BYTES + 2);
    status s = o->text ? read_stream(o, in) : status_out_of_memory();
    fclose(in);
    return s;
}
//<

//> obj-words
// A word ends at a space, and the last word of a line at its newline, at a
// comment or with the file.
static const char *skip_space(const char *c) { return c + strspn(c, " \t\r"); }

static const char *skip_word(const char *c)
{
    return c + strcspn(c, " \t\r\n#");
}

static bool is_end(const char *c) { return *c == '\n' || *c == '#' || !*c; }

// What stands after the first word of a line, if that word is the letter key.
static const char *after_key(const char *line, char key)
{
    const char *word = skip_space(line), *end = skip_word(word);
    return word[0] == key && end == word + 1 ? end : NULL;
}

static status refuse_word(const obj_file *o, int line, const char *word,
                          const char *what)
{
    int length = int_min((int)(skip_word(word) - word), 20);
    return status_fail("%s, line %d: '%.*s' is not %s", o->name, line, length,
                       word, what);
}
//<

//> obj-vertex
// Reads x, y and z; a weight or a colour after them is ignored.  strtod alone
// would read nan and 0x10 as numbers, too.
static status read_vertex(obj_file *o, const char *c, int line)
{
    real xyz[3];
    if (o->vertices == MOST_OBJ_VERTICES)
        return status_fail("%s, line %d: this is vertex %d: a body may have %d "
                           "at most", o->name, line, o->vertices + 1,
                           MOST_OBJ_VERTICES);
    for (int k = 0; k < 3; k++) {
        c = skip_space(c);
        if (is_end(c))
            return status_fail("%s, line %d: a vertex needs three numbers, "
                               "this one has %d", o->name, line, k);
        char *end;
        xyz[k] = strtod(c, &end);
        if (end != skip_word(c) || end != c + strspn(c, "+-.eE0123456789"))
            return refuse_word(o, line, c, "a number");
        if (!(fabs(xyz[k]) <= 1e30))
            return refuse_word(o, line, c, "a coordinate of at most 1e30");
        c = end;
    }
    o->vertex_line[o->vertices] = line;
    o->at[o->vertices++] = vec3_make(xyz[0], xyz[1], xyz[2]);
    return status_ok();
}
//<

//> obj-face
// Reads `7`, `7/1`, `7//3` or `7/1/3`, or with a minus sign, which counts back
// from the last vertex above the line.  *corner counts from 0.  It may lie
// beyond the vertices read so far, but not below 0.
static status read_corner(const obj_file *o, const char *word, int line,
                          int *corner)
{
    char *end;
    long index = strtol(word, &end, 10);
    if (end == word || (*end != '/' && end != skip_word(word)))
        return refuse_word(o, line, word, "the index of a vertex");
    if (index == 0 || index < -o->vertices)
        return status_fail("%s, line %d: a face uses vertex %ld, but vertices "
                           "count from 1, and %d stand above it", o->name,
                           line, index, o->vertices);
    index = index < 0 ? o->vertices + index : index - 1;
    *corner = index < MOST_OBJ_VERTICES ? (int)index : MOST_OBJ_VERTICES;
    return status_ok();
}

static status add_triangle(obj_file *o, int a, int b, int c, int line)
{
    if (o->triangles == MOST_OBJ_TRIANGLES)
        return status_fail("%s, line %d: this is triangle %d: a body may have "
                           "%d at most", o->name, line, o->triangles + 1,
                           MOST_OBJ_TRIANGLES);
    int *v = o->triangle[o->triangles];
    v[0] = a;
    v[1] = b;
    v[2] = c;
    o->triangle_line[o->triangles++] = line;
    return status_ok();
}

// Cuts a face of n corners into the n - 2 triangles at its first corner.
static status read_face(obj_file *o, const char *c, int line)
{
    int corners = 0, first = 0, last = 0, corner = 0;
    for (c = skip_space(c); !is_end(c); c = skip_space(skip_word(c))) {
        status s = read_corner(o, c, line, &corner);
        if (corners == 0) first = corner;
        if (s.ok && corners++ > 1)
            s = add_triangle(o, first, last, corner, line);
        if (!s.ok) return s;
        last = corner;
    }
    if (corners >= 3) return status_ok();
    return status_fail("%s, line %d: a face needs three corners, this one has "
                       "%d", o->name, line, corners);
}
//<

//> obj-parse
static status check_indices(const obj_file *o)
{
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++)
            if (o->triangle[t][k] >= o->vertices)
                return status_fail("%s, line %d: a face uses a vertex beyond "
                                   "the last, which is number %d", o->name,
                                   o->triangle_line[t], o->vertices);
    return status_ok();
}

static status parse(obj_file *o)
{
    status s = status_ok();
    const char *c = o->text;
    for (int line = 1; s.ok && *c; line++) {
        const char *vertex = after_key(c, 'v'), *face = after_key(c, 'f');
        if (vertex) s = read_vertex(o, vertex, line);
        if (face) s = read_face(o, face, line);
        c += strcspn(c, "\n");
        if (*c) c++;
    }
    if (s.ok && o->vertices == 0)
        s = status_fail("%s: no vertex: no line begins with v", o->name);
    if (s.ok && o->triangles == 0)
        s = status_fail("%s: no face: no line begins with f", o->name);
    return s.ok ? check_indices(o) : s;
}
//<

//> obj-tidy
// Drops the vertices that no face uses; the others keep their order.
static void drop_unused(obj_file *o)
{
    int place[MOST_OBJ_VERTICES] = { 0 }, kept = 0;
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++) place[o->triangle[t][k]] = 1;
    for (int v = 0; v < o->vertices; v++) {
        if (!place[v]) continue;
        o->at[kept] = o->at[v];
        o->vertex_line[kept] = o->vertex_line[v];
        place[v] = kept++;
    }
    for (int t = 0; t < o->triangles; t++)
        for (int k = 0; k < 3; k++)
            o->triangle[t][k] = place[o->triangle[t][k]];
    o->vertices = kept;
}

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

// A closed mesh with a negative volume looks inwards, because some programs
// count the other way round.  Turns every triangle.
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
static status build(obj_file *o, const char *path, real radius, real mass,
                    shape *s)
{
    status r = read_text(o, path);
    if (r.ok) r = parse(o);
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
    if (radius >= 1e-30 && radius <= 1e30) r = build(o, path, radius, mass, s);
    free(o->text);
    free(o);
    return r;
}
//<
