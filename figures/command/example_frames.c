#include "example_frames.h"
#include "example_paint.h"
#include "output.h"

enum { WIDE = 960, HIGH = 540, LAMPS = 3 };

status example_picture(const void *moment, const char *path)
{
    const example_moment *m = moment;
    picture p;
    status done = picture_init(&p, WIDE, HIGH, colour_hex(0xffffff));
    if (!done.ok) return done;
    done = example_paint(m->scene, m->world, LAMPS, &p, 0, 0, WIDE, HIGH);
    if (done.ok) done = picture_write(&p, path);
    picture_free(&p);
    return done;
}

// What has been written of the file, and whose part it was.
typedef struct {
    FILE *file;
    long vertices;
    int body;           // -1: none yet
} listing;

static void write_part(listing *l, int body, char kind, int corners,
                       const tumble_vec3 *at)
{
    if (body != l->body) fprintf(l->file, "o body-%05d\n", body);
    l->body = body;
    for (int k = 0; k < corners; k++)
        fprintf(l->file, "v %.9g %.9g %.9g\n", at[k].x, at[k].y, at[k].z);
    fputc(kind, l->file);
    for (int k = 0; k < corners; k++) fprintf(l->file, " %ld", ++l->vertices);
    fputc('\n', l->file);
}

static void on_triangle(void *to, tumble_body b, const tumble_vec3 at[3])
{
    write_part(to, (int)b.place, 'f', 3, at);
}

static void on_line(void *to, tumble_body b, const tumble_vec3 at[2])
{
    write_part(to, (int)b.place, 'l', 2, at);
}

status example_obj(const void *moment, const char *path)
{
    const example_moment *m = moment;
    output o;
    status done = output_open(&o, path);
    if (!done.ok) return done;
    fprintf(o.file, "# %s at %.9g s, in metres, y up\n", m->scene->name,
            tumble_world_time(m->world));
    listing all = { o.file, 0, -1 };
    tumble_pen pen = { on_triangle, on_line, NULL, &all };
    tumble_world_draw(m->world, &pen);
    return output_commit(&o);
}
