// output.c - write beside, then rename.

#define _XOPEN_SOURCE 700

#include "output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static char *text_join(const char *a, const char *b)
{
    size_t na = strlen(a), nb = strlen(b);
    char *s = malloc(na + nb + 1);
    if (!s) return NULL;
    memcpy(s, a, na);
    memcpy(s + na, b, nb + 1);
    return s;
}

// Where a chain of symbolic links ends; path itself if there is none.
static char *text_of_target(const char *path)
{
    char *end = realpath(path, NULL);
    return end ? end : text_join(path, "");
}

static status refuse(output *o, const char *path, const char *what, int error)
{
    if (o->file) fclose(o->file);
    if (o->part) remove(o->part);
    free(o->path);
    free(o->part);
    *o = (output){ 0 };
    return status_fail("%.120s: cannot %s: %s", path, what, strerror(error));
}

status output_open(output *o, const char *path)
{
    *o = (output){ 0 };
    if (!*path) return status_fail("the name of the file is empty");
    struct stat there;
    int exists = stat(path, &there) == 0;
    if (exists && S_ISDIR(there.st_mode))
        return status_fail("%.120s: cannot write: it is a folder", path);

    o->path = text_of_target(path);
    if (!o->path) return status_out_of_memory();
    // A plain file that we may not write to would still let itself be replaced;
    // that is not what its owner meant.
    int plain = !exists || S_ISREG(there.st_mode);
    if (exists && plain) {
        FILE *probe = fopen(o->path, "r+b");
        if (!probe) return refuse(o, path, "write", errno);
        fclose(probe);
    }
    if (plain) {
        o->part = text_join(o->path, ".part");
        if (!o->part) return refuse(o, path, "write", ENOMEM);
    }
    o->file = fopen(plain ? o->part : o->path, "wb");
    if (!o->file) {
        int error = errno;
        free(o->part);
        o->part = NULL;
        return refuse(o, path, "write", error);
    }
    return status_ok();
}

status output_flush(output *o)
{
    if (fflush(o->file) == 0 && !ferror(o->file)) return status_ok();
    return status_fail("%.120s: cannot write: %s", o->path, strerror(errno));
}

status output_commit(output *o)
{
    int bad = ferror(o->file) || fflush(o->file) != 0;
    int error = bad && errno ? errno : EIO;
    if (fclose(o->file) != 0 && !bad) {
        bad = 1;
        error = errno;
    }
    o->file = NULL;
    if (!bad && o->part && rename(o->part, o->path) != 0) {
        bad = 1;
        error = errno;
    }
    status s = status_ok();
    if (bad)
        s = status_fail("%.120s: cannot write: %s", o->path, strerror(error));
    if (bad && o->part) remove(o->part);
    free(o->path);
    free(o->part);
    *o = (output){ 0 };
    return s;
}

void output_cancel(output *o)
{
    if (!o->file) return;
    fclose(o->file);
    if (o->part) remove(o->part);
    free(o->path);
    free(o->part);
    *o = (output){ 0 };
}

status output_check(const char *path)
{
    output o;
    struct stat there;
    // Opening a device or a pipe could already do something: ask, do not try.
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)
        && !S_ISDIR(there.st_mode))
        return status_ok();
    status s = output_open(&o, path);
    if (s.ok) output_cancel(&o);
    return s;
}
