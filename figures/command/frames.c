// frames.c - folders of numbered files.

#define _POSIX_C_SOURCE 200809L

#include "frames.h"
#include "output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Of the next frame; to be freed.  NULL: no memory.
static char *frame_name(const frames *f)
{
    size_t room = strlen(f->folder) + strlen(f->ending) + 40;
    char *name = malloc(room);
    if (name) snprintf(name, room, "%s/frame-%05ld%s", f->folder, f->count,
                       f->ending);
    return name;
}

status frames_begin(frames *f)
{
    struct stat there;
    if (stat(f->folder, &there) != 0) {
        if (mkdir(f->folder, 0777) != 0)
            return status_fail("%.120s: cannot make this folder: %s",
                               f->folder, strerror(errno));
        f->made = 1;
        return status_ok();
    }
    if (!S_ISDIR(there.st_mode))
        return status_fail("%.120s: is not a folder", f->folder);
    char *name = frame_name(f);
    if (!name) return status_out_of_memory();
    status done = output_check(name);
    free(name);
    return done;
}

// A link may lead to a file that is not ours.
static status check_link(const char *name)
{
    struct stat there;
    if (lstat(name, &there) != 0 || !S_ISLNK(there.st_mode)) return status_ok();
    return status_fail("%.120s: is a link, which no frame may replace", name);
}

status frames_add(frames *f, const void *now)
{
    char *name = frame_name(f);
    if (!name) return status_out_of_memory();
    status done = check_link(name);
    if (done.ok) done = f->write(now, name);
    if (done.ok) f->count++;
    free(name);
    return done;
}

void frames_end(frames *f)
{
    if (f->made && f->count == 0) rmdir(f->folder);
}

// ---- OBJ -------------------------------------------------------------------

static void write_corner(FILE *out, int vertex)
{
    fprintf(out, " %d", vertex);
}

// first: the number of the body's first vertex in the file.
static void write_body(FILE *out, const shape *s, const vec3 *at, int number,
                       int first)
{
    static const char *const kind[] = { "body", "cloth", "rope" };
    fprintf(out, "o %s-%05d\n", kind[s->kind], number);
    for (int i = 0; i < s->particles; i++)
        fprintf(out, "v %.9g %.9g %.9g\n", at[i].x, at[i].y, at[i].z);
    for (int f = 0; f < s->mesh.faces; f++) {
        fputc('f', out);
        for (int k = 0; k < 3; k++)
            write_corner(out, first + s->face[3 * f + k]);
        fputc('\n', out);
    }
    if (s->kind != SHAPE_ROPE) return;
    fputc('l', out);
    for (int i = 0; i < s->particles; i++) write_corner(out, first + i);
    fputc('\n', out);
}

status frames_picture(const void *pose_now, const char *path)
{
    return film_write(*(const pose *)pose_now, path);
}

status frames_obj(const void *pose_now, const char *path)
{
    pose now = *(const pose *)pose_now;
    output o;
    status done = output_open(&o, path);
    if (!done.ok) return done;
    fprintf(o.file, "# %s at %.9g s, in metres, y up\n", scene_name(now.kind),
            now.time);
    for (int b = 0, first = 0; b < now.scene->bodies; b++) {
        const shape *s = scene_shape(now.scene, b);
        write_body(o.file, s, now.at + first, b, first + 1);
        first += s->particles;
    }
    return output_commit(&o);
}
