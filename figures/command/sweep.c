// sweep.c - reads the table, checks every row, and calls the script.

#define _XOPEN_SOURCE 700

#include "sweep.h"
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_CELLS = 64, MOST_TABLE_BYTES = 1 << 26 };

// ---- The table -------------------------------------------------------------

void table_free(table *t)
{
    free(t->text);
    free(t->row);
    free(t->line);
    *t = (table){ .rows = 0 };
}

static status read_text(table *t)
{
    struct stat there;
    FILE *in = fopen(t->name, "rb");
    if (!in)
        return status_fail("%.120s: cannot be opened: %s", t->name,
                           strerror(errno));
    size_t room = fstat(fileno(in), &there) == 0 && S_ISREG(there.st_mode)
                ? (size_t)there.st_size : MOST_TABLE_BYTES;
    t->text = room < MOST_TABLE_BYTES ? malloc(room + 1) : NULL;
    size_t length = t->text ? fread(t->text, 1, room, in) : 0;
    fclose(in);
    if (room >= MOST_TABLE_BYTES)
        return status_fail("%.120s: is no file, or has more than 64 MB",
                           t->name);
    if (!t->text) return status_out_of_memory();
    t->text[length] = 0;
    return status_ok();
}

// Cuts the text into lines, and keeps those that are no remarks.
static status cut_lines(table *t)
{
    int lines = 1, kept = 0, line = 1;
    for (const char *c = t->text; *c; c++) lines += *c == '\n';
    t->row = malloc((size_t)lines * sizeof *t->row);
    t->line = malloc((size_t)lines * sizeof *t->line);
    if (!t->row || !t->line) return status_out_of_memory();
    for (char *c = t->text; *c; line++) {
        char *end = c + strcspn(c, "\n");
        int is_last = !*end;
        *end = 0;
        c[strcspn(c, "\r")] = 0;
        t->line[kept] = line;
        if (*c && *c != '#') t->row[kept++] = c;
        c = is_last ? end : end + 1;
    }
    t->rows = kept - 1;
    return kept > 1 ? status_ok()
                    : status_fail("%.120s: has no row under a head", t->name);
}

static int count_cells(const char *row)
{
    int cells = 1;
    for (; *row; row++) cells += *row == ',';
    return cells;
}

static status refuse_row(const table *t, int row, const char *why)
{
    return status_fail("%.60s, line %d: %.110s", t->name, t->line[row], why);
}

static status check_cells(const table *t, int row)
{
    int cells = count_cells(t->row[row]), head = count_cells(t->row[0]);
    if (strchr(t->row[row], '"'))
        return refuse_row(t, row, "quotes are not read");
    if (cells > MOST_CELLS)
        return refuse_row(t, row, "a row may have 64 cells at most");
    return cells == head ? status_ok()
         : status_fail("%.60s, line %d: has %d cells, and the head %d", t->name,
                       t->line[row], cells, head);
}

// Adds the word for one cell, and moves past it.
static void write_word(char **to, const char *name, size_t letters,
                       const char *value, size_t length)
{
    int is_scene = letters == 5 && strncmp(name, "scene", 5) == 0;
    int is_yes = length == 3 && strncmp(value, "yes", 3) == 0;
    if (is_scene)
        *to += sprintf(*to, "%.*s", (int)length, value);
    else if (is_yes)
        *to += sprintf(*to, "--%.*s", (int)letters, name);
    else
        *to += sprintf(*to, "--%.*s=%.*s", (int)letters, name, (int)length,
                       value);
    ++*to;                      // past its zero
}

// What a row may not ask for.
static status check_row(const settings *s)
{
    if (s->sweep || s->help || s->list || s->version)
        return status_fail("a row is the run of a scene");
    return status_ok();
}

status table_row(const table *t, int row, settings *s, char **words)
{
    const char *name = t->row[0], *cell = t->row[row];
    char *word[MOST_CELLS + 1], *to;
    int count = 1;
    status done = check_cells(t, row);
    if (!done.ok) return done;
    to = *words = malloc(strlen(name) + strlen(cell) + 4 * MOST_CELLS);
    if (!*words) return status_out_of_memory();
    for (;;) {
        size_t letters = strcspn(name, ","), length = strcspn(cell, ",");
        word[count] = to;
        if (length > 0 && !(length == 2 && strncmp(cell, "no", 2) == 0)) {
            write_word(&to, name, letters, cell, length);
            count++;
        }
        if (!cell[length]) break;
        name += letters + 1;
        cell += length + 1;
    }
    done = settings_read(s, count, word);
    if (done.ok) done = check_row(s);
    return done.ok ? done : refuse_row(t, row, done.why);
}

status table_check(const table *t)
{
    status done = status_ok();
    for (int row = 1; row <= t->rows && done.ok; row++) {
        settings s;
        char *words = NULL;
        done = table_row(t, row, &s, &words);
        free(words);
    }
    return done;
}

status table_read(table *t, const char *path)
{
    *t = (table){ .name = path };
    status done = read_text(t);
    if (done.ok) done = cut_lines(t);
    if (done.ok) done = check_cells(t, 0);
    if (!done.ok) table_free(t);
    return done;
}

// ---- The folder ------------------------------------------------------------

// A path of the sweep's: base with what is added, to be freed.
static char *path_join(const char *base, const char *more)
{
    char *s = malloc(strlen(base) + strlen(more) + 1);
    if (s) sprintf(s, "%s%s", base, more);
    return s;
}

// Locks the folder for as long as a process of this sweep runs: the script and
// the rows inherit the open file.
static status lock_folder(const char *folder)
{
    int file = open(folder, O_RDONLY);
    if (file < 0)
        return status_fail("%.120s: cannot be opened: %s", folder,
                           strerror(errno));
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return status_ok();
    return status_fail("%.120s: this sweep is being run", folder);
}

// Makes the folder of a sweep that begins, or finds that of one that goes on.
static status open_folder(const char *folder, int is_resumed, int *is_new)
{
    *is_new = mkdir(folder, 0777) == 0;
    if (!*is_new && errno != EEXIST)
        return status_fail("%.120s: cannot make this folder: %s", folder,
                           strerror(errno));
    status done = lock_folder(folder);
    if (!done.ok || *is_new || is_resumed) return done;
    return status_fail("%.100s: a sweep stopped here: --resume goes on with "
                       "it; without this folder it begins again", folder);
}

static status write_file(const char *folder, const char *name, const table *t,
                         const char *head)
{
    output o;
    char *path = path_join(folder, name);
    if (!path) return status_out_of_memory();
    status done = output_open(&o, path);
    free(path);
    if (!done.ok) return done;
    if (head) fprintf(o.file, "row,%s,%s\n", t->row[0], head);
    for (int row = 0; row <= t->rows && !head; row++)
        fprintf(o.file, "%s\n", t->row[row]);
    return output_commit(&o);
}

// Is this the table that the sweep began with?
static status compare_tables(const char *folder, const table *t)
{
    table was;
    char *path = path_join(folder, "/table");
    if (!path) return status_out_of_memory();
    status done = table_read(&was, path);
    int same = done.ok && was.rows == t->rows;
    for (int row = 0; row <= t->rows && same; row++)
        same = strcmp(was.row[row], t->row[row]) == 0;
    table_free(&was);
    free(path);
    if (!done.ok || same) return done;
    return status_fail("%.80s is not the table that the sweep in %.80s began "
                       "with", t->name, folder);
}

// Parallel adds to a log: one of an earlier sweep has to go.  Only a log does.
static status drop_joblog(const char *joblog)
{
    char head[9] = "";
    FILE *f = fopen(joblog, "rb");
    if (!f) return status_ok();
    size_t length = fread(head, 1, 8, f);
    fclose(f);
    if (length > 0 && strcmp(head, "Seq\tHost") != 0)
        return status_fail("%.120s: is no job log of GNU Parallel, and is left "
                           "as it is", joblog);
    remove(joblog);
    return status_ok();
}

// ---- The sweep -------------------------------------------------------------

static status check_files(const settings *set, const char *joblog)
{
    if (set->csv && output_is_same(set->csv, set->sweep))
        return status_fail("--csv %.80s is the table of --sweep", set->csv);
    if (output_is_same(joblog, set->sweep)
        || (set->csv && output_is_same(joblog, set->csv)))
        return status_fail("--joblog %.80s is the name of another file",
                           joblog);
    return set->csv ? output_check(set->csv) : status_ok();
}

// Becomes the script, whose words are these.
static status call_script(const settings *set, const char *program,
                          const char *folder, const char *joblog, int rows)
{
    char count[24], jobs[24] = "", place[4096];
    char *rows_of = path_join(folder, "/table");
    const char *slash = strrchr(program, '/');
    int length = slash ? (int)(slash + 1 - program) : 0;
    snprintf(place, sizeof place, "%.*stumble-sweep", length, program);
    snprintf(count, sizeof count, "%d", rows);
    if (set->jobs > 0) snprintf(jobs, sizeof jobs, "%d", set->jobs);
    if (!rows_of) return status_out_of_memory();
    execlp(place, place, "--resume goes on with it", folder, count, joblog,
           set->csv ? set->csv : "", jobs, set->hosts ? set->hosts : "",
           program, "--sweep", rows_of, "--row", (char *)NULL);
    free(rows_of);
    return status_fail("%.120s: cannot be run: %s", place, strerror(errno));
}

static status prepare(const settings *set, const table *t, const char *folder,
                      const char *joblog, const char *head)
{
    int is_new = 0;
    status done = check_files(set, joblog);
    if (done.ok) done = open_folder(folder, set->resume, &is_new);
    if (!done.ok) return done;
    if (!is_new) return compare_tables(folder, t);
    done = drop_joblog(joblog);
    if (done.ok) done = write_file(folder, "/table", t, NULL);
    if (done.ok) done = write_file(folder, "/head", t, head);
    if (!done.ok) rmdir(folder);
    return done;
}

status sweep_begin(const settings *set, const char *program, const char *head)
{
    table t;
    status done = table_read(&t, set->sweep);
    if (!done.ok) return done;
    done = table_check(&t);
    char *joblog = set->joblog ? path_join(set->joblog, "")
                               : path_join(set->sweep, ".joblog");
    char *folder = joblog ? path_join(joblog, ".rows") : NULL;
    if (done.ok && !folder) done = status_out_of_memory();
    if (done.ok) done = prepare(set, &t, folder, joblog, head);
    if (done.ok) done = call_script(set, program, folder, joblog, t.rows);
    free(folder);
    free(joblog);
    table_free(&t);
    return done;
}
