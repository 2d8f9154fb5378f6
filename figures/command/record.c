// record.c - writes a record, reads it again, compares.

#define _POSIX_C_SOURCE 200809L

#include "record.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

status record_open(output *o, const settings *s)
{
    if (s->mesh && strpbrk(s->mesh, "\r\n"))
        return status_fail("--mesh: a name of two lines cannot be recorded");
    status done = output_open(o, s->record);
    if (!done.ok) return done;
    fprintf(o->file, "# tumble --replay %s runs this again and compares the "
            "hashes\n", s->record);
    settings_print_words(s, o->file);
    return output_flush(o);
}

status record_look(output *o, const runner *run, long step, int is_last)
{
    if (!o->file || (step % RECORD_EVERY == 0) == is_last) return status_ok();
    fprintf(o->file, "%ld %016llx\n", step, runner_hash(run));
    return output_flush(o);
}

// ---- Replay ----------------------------------------------------------------

static status refuse(const replay *p, const char *what)
{
    return status_fail("%.80s, line %d: %s", p->name, p->line, what);
}

// The next line that says something, to be freed; NULL: there is none.
static char *next_line(replay *p)
{
    char *text = NULL;
    size_t room = 0;
    while (getline(&text, &room, p->file) > 0) {
        p->line++;
        text[strcspn(text, "\r\n")] = 0;
        if (*text && *text != '#') return text;
    }
    free(text);
    return NULL;
}

static status read_hash(replay *p, const char *text)
{
    char *end;
    long step = strtol(text, &end, 10);
    if (!isdigit((unsigned char)*text) || *end != ' ')
        return refuse(p, "not a step and its hash");
    if (step < 0 || step > 10000000 || (p->equal > 0 && step <= p->equal_step))
        return refuse(p, "this step cannot come here");
    const char *digits = end + 1;
    p->hash = strtoull(digits, &end, 16);
    if (strlen(digits) != 16 || strspn(digits, "0123456789abcdef") != 16)
        return refuse(p, "not a hash of 16 hexadecimal digits");
    p->step = step;
    return status_ok();
}

// Where the file ends, so does the replay.
static status next_hash(replay *p)
{
    p->step = -1;
    char *text = next_line(p);
    status done = text ? read_hash(p, text) : status_ok();
    free(text);
    return done;
}

// Takes over the text.
static status keep_word(replay *p, char *text)
{
    if (p->words == p->room) {
        int room = 2 * p->room + 16;
        char **word = realloc(p->word, (size_t)room * sizeof *word);
        if (!word) {
            free(text);
            return status_out_of_memory();
        }
        p->word = word;
        p->room = room;
    }
    p->word[p->words++] = text;
    return status_ok();
}

static status read_words(replay *p)
{
    char *text;
    status done = status_ok();
    while (done.ok && (text = next_line(p))) {
        if (isdigit((unsigned char)*text)) {
            done = read_hash(p, text);
            free(text);
            return done;
        }
        done = keep_word(p, text);
    }
    return done.ok ? refuse(p, "the file ends without a hash") : done;
}

status replay_open(replay *p, settings *s)
{
    *p = (replay){ .name = s->replay, .step = -1 };
    p->file = fopen(s->replay, "rb");
    if (!p->file)
        return status_fail("%.120s: cannot be opened: %s", s->replay,
                           strerror(errno));
    status done = read_words(p);
    if (!done.ok) return done;
    done = settings_read_more(s, p->words, p->word);
    return done.ok ? done : status_fail("%.80s: %.110s", p->name, done.why);
}

void replay_close(replay *p)
{
    for (int i = 0; i < p->words; i++) free(p->word[i]);
    free(p->word);
    if (p->file) fclose(p->file);
    *p = (replay){ .step = -1 };
}

status replay_look(replay *p, const runner *run, long step, long steps)
{
    if (p->step > steps)
        return refuse(p, "this hash stands after the last step of the run");
    if (!p->file || step != p->step) return status_ok();
    if (runner_hash(run) != p->hash) {
        p->parted = 1;
        return status_ok();
    }
    p->equal++;
    p->equal_step = step;
    return next_hash(p);
}
