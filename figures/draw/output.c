// output.c - write beside, then rename.

#define _XOPEN_SOURCE 700

#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// folder/name, and what is added to it.
static char *text_join(const char *folder, const char *slash, const char *name)
{
    size_t n = strlen(folder) + strlen(slash) + strlen(name) + 1;
    char *s = malloc(n);
    if (s) snprintf(s, n, "%s%s%s", folder, slash, name);
    return s;
}

// Where a chain of symbolic links ends.  A file that is not there yet will stand
// in the folder where the path to it ends; path itself if there is none.
static char *text_of_target(const char *path)
{
    char *end = realpath(path, NULL);
    if (end) return end;
    char *start = text_join(path, "", "");
    if (!start) return NULL;
    char *slash = strrchr(start, '/'), *name = slash ? slash + 1 : start;
    if (slash) *slash = 0;
    char *folder = realpath(!slash ? "." : *start ? start : "/", NULL);
    end = folder ? text_join(folder, "/", name) : text_join(path, "", "");
    free(folder);
    free(start);
    return end;
}

static void forget(output *o)
{
    free(o->path);
    free(o->part);
    *o = (output){ 0 };
}

// Closes and removes what was written.  Removed first: as long as it is open no
// other program can begin a file of that name.
static void take_back(output *o)
{
    if (o->part) remove(o->part);
    if (o->file) fclose(o->file);
    forget(o);
}

static status refuse(const char *path, int error)
{
    if (error == EAGAIN)
        return status_fail("%.120s: cannot write: another program is writing "
                           "it", path);
    return status_fail("%.120s: cannot write: %s", path, strerror(error));
}

// ---- One writer at a time ---------------------------------------------------

// Locks an open file; it stays so until it is closed, or the program ends, by
// whatever signal.  Returns 0, or EAGAIN if another program holds it.  Where
// the file system has no locks, there is no way to know.
static int lock(int file)
{
    struct flock all = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
    if (fcntl(file, F_SETLK, &all) == 0) return 0;
    return errno == EACCES || errno == EAGAIN ? EAGAIN : 0;
}

// Is this open file still the one of that name?
static int is_at(int file, const char *path)
{
    struct stat open, there;
    return fstat(file, &open) == 0 && stat(path, &there) == 0
        && open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

// Opens an empty file that no other program writes to; one that a program left
// which was killed is taken over.  Returns 0, or what is wrong.  Between
// opening and locking, another program may have put the file in its place by a
// rename: then it is left alone.
static int open_alone(FILE **file, const char *part)
{
    int open_file = open(part, O_RDWR | O_CREAT, 0666);
    if (open_file < 0) return errno;
    int error = lock(open_file);
    if (!error && !is_at(open_file, part)) error = EAGAIN;
    if (!error && ftruncate(open_file, 0) != 0) error = errno;
    *file = error ? NULL : fdopen(open_file, "wb");
    if (*file) return 0;
    if (!error) error = errno;
    close(open_file);
    return error;
}

// ---- Open, write, commit ----------------------------------------------------

// A plain file that we may not write to would still let itself be replaced;
// that is not what its owner meant.
static int probe(const char *path)
{
    FILE *f = fopen(path, "r+b");
    if (!f) return errno;
    fclose(f);
    return 0;
}

static int open_file(output *o, int exists, int plain)
{
    if (!plain) {
        o->file = fopen(o->path, "wb");
        return o->file ? 0 : errno;
    }
    int error = exists ? probe(o->path) : 0;
    if (error) return error;
    char *part = text_join(o->path, ".part", "");
    if (!part) return ENOMEM;
    error = open_alone(&o->file, part);
    if (error) free(part);
    else o->part = part;
    return error;
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
    int error = open_file(o, exists, !exists || S_ISREG(there.st_mode));
    if (!error) return status_ok();
    forget(o);
    return refuse(path, error);
}

status output_flush(output *o)
{
    if (fflush(o->file) == 0 && !ferror(o->file)) return status_ok();
    return refuse(o->path, errno);
}

status output_commit(output *o)
{
    errno = 0;
    int bad = fflush(o->file) != 0 || ferror(o->file)
           || (o->part && rename(o->part, o->path) != 0);
    status s = bad ? refuse(o->path, errno ? errno : EIO) : status_ok();
    if (bad) {
        take_back(o);
        return s;
    }
    // Renamed before it is closed: a file that is closed is locked no more.
    if (fclose(o->file) != 0) {
        s = refuse(o->path, errno);
        if (o->part) remove(o->path);
    }
    forget(o);
    return s;
}

void output_cancel(output *o)
{
    if (o->file) take_back(o);
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

// ---- Names that clash -------------------------------------------------------

static int is_part_of(const char *part, const char *path)
{
    size_t n = strlen(path);
    return strncmp(part, path, n) == 0 && strcmp(part + n, ".part") == 0;
}

static int is_linked(const char *a, const char *b)
{
    struct stat first, second;
    return stat(a, &first) == 0 && stat(b, &second) == 0
        && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

int output_is_same(const char *a, const char *b)
{
    char *end_a = text_of_target(a), *end_b = text_of_target(b);
    int same = end_a && end_b && (strcmp(end_a, end_b) == 0 || is_linked(a, b)
               || is_part_of(end_a, end_b) || is_part_of(end_b, end_a));
    free(end_a);
    free(end_b);
    return same;
}

int output_is_in(const char *path, const char *folder, const char *begins)
{
    char *end = text_of_target(path), *room = text_of_target(folder);
    char *slash = end ? strrchr(end, '/') : NULL;
    int in = 0;
    if (slash && room) {
        *slash = 0;
        in = strcmp(*end ? end : "/", room) == 0
             && strncmp(slash + 1, begins, strlen(begins)) == 0;
    }
    free(end);
    free(room);
    return in;
}
