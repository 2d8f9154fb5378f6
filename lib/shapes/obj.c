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
    MOST_OBJ_LINES     = 1 << 20
};

// What is known of the file.  Vertices count from 0 here, from 1 in the file.
typedef struct {
    char name[44];              // the path, or its end
    int  line;                  // the one in hand, from 1
    char text[1 << 16];         // of this line
    int  vertices, triangles;
    vec3 at[MOST_OBJ_VERTICES];
    int  vertex_line[MOST_OBJ_VERTICES];
    int  triangle[MOST_OBJ_TRIANGLES][3];
    int  triangle_line[MOST_OBJ_TRIANGLES];
} obj_file;

static status refuse(const obj_file *o, const char *what)
{
    return status_fail("%s, line %d: %s", o->name, o->line, what);
}
//<

//> obj-words
// A word ends at a space, and the last word of a line with the line or at a
// comment.
static const char *skip_space(const char *c) { return c + strspn(c, " \t\r"); }

static const char *skip_word(const char *c)
{
    return c + strcspn(c, " \t\r\n#");
}

static bool is_end(const char *c) { return *c == '\n' || *c == '#' || !*c; }

static status refuse_word(const obj_file *o, const char *word, const char *what)
{
    int length = int_min((int)(skip_word(word) - word), 20);
    return status_fail("%s, line %d: '%.*s' is not %s", o->name, o->line,
                       length, word, what);
}
//<

//> obj-vertex
// Reads x, y and z; a weight or a colour after them is ignored.  strtod alone
// would read nan and 0x10 as numbers, too.
static status read_vertex(obj_file *o, const char *c)
{
    real xyz[3];
    if (o->vertices == MOST_OBJ_VERTICES)
        return refuse(o, "a body may have 4096 vertices at most");
    for (int k = 0; k < 3; k++) {
        char *end;
        c = skip_space(c);
        if (is_end(c)) return refuse(o, "a vertex needs three numbers");
        xyz[k] = strtod(c, &end);
        if (end != skip_word(c) || end != c + strspn(c, "+-.eE0123456789"))
            return refuse_word(o, c, "a number");
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
// Reads `7`, `7/1`, `7//3` or `7/1/3`, or with a minus sign, which counts back
// from the last vertex above the line.  *corner counts from 0.
static status read_corner(const obj_file *o, const char *word, int *corner)
{
    char *end;
    long index = strtol(word, &end, 10);
    if (end == word || (*end != '/' && end != skip_word(word)))
        return refuse_word(o, word, "the index of a vertex");
    if (index == 0 || index < -o->vertices || index > o->vertices)
        return status_fail("%s, line %d: a face uses vertex %ld, but vertices "
                           "count from 1, and %d stand above it", o->name,
                           o->line, index, o->vertices);
    *corner = (int)(index < 0 ? o->vertices + index : index - 1);
    return status_ok();
}

// Cuts a face of n corners into the n - 2 triangles at its first corner.
static status read_face(obj_file *o, const char *c)
{
    int corners = 0, first = 0, last = 0, corner = 0;
    for (c = skip_space(c); !is_end(c); c = skip_space(skip_word(c))) {
        status s = read_corner(o, c, &corner);
        if (!s.ok) return s;
        if (corners == 0) first = corner;
        if (corners++ > 1) {
            if (o->triangles == MOST_OBJ_TRIANGLES)
                return refuse(o, "a body may have 8192 triangles at most");
            int *v = o->triangle[o->triangles];
            v[0] = first;
            v[1] = last;
            v[2] = corner;
            o->triangle_line[o->triangles++] = o->line;
        }
        last = corner;
    }
    return corners < 3 ? refuse(o, "a face needs three corners") : status_ok();
}
//<

//> obj-lines
static status read_line(obj_file *o)
{
    const char *word = skip_space(o->text), *end = skip_word(word);
    if (end == word + 1 && *word == 'v') return read_vertex(o, end);
    if (end == word + 1 && *word == 'f') return read_face(o, end);
    return status_ok();
}

static status read_lines(obj_file *o, FILE *in)
{
    for (o->line = 1; fgets(o->text, sizeof o->text, in); o->line++) {
        if (o->line > MOST_OBJ_LINES)
            return refuse(o, "a file may have a million lines at most");
        if (!strchr(o->text, '\n') && !feof(in))
            return refuse(o, "the line is too long, or no text");
        status s = read_line(o);
        if (!s.ok) return s;
    }
    if (ferror(in))
        return status_fail("%s: cannot be read: %s", o->name, strerror(errno));
    if (o->vertices == 0)
        return status_fail("%s: no vertex: no line begins with v", o->name);
    if (o->triangles == 0)
        return status_fail("%s: no face: no line begins with f", o->name);
    return status_ok();
}
//<

//> obj-scale
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
static status read_file(obj_file *o, const char *path, real radius, real mass,
                        shape *s)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return status_fail("%s: cannot be opened: %s", o->name,
                           strerror(errno));
    status r = read_lines(o, in);
    fclose(in);
    if (r.ok) r = centre_and_scale(o, radius);
    if (!r.ok) return r;
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
