//> store-head-of-bytes
//>   The head of the bytes: a number that no other file has, the version, the
//>   length, and a checksum.
#include "store.h"
#include "table.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// With these the bytes begin.  Where numbers begin with their other end, MAGIC
// is another one.
typedef struct {
    uint64_t magic;
    char version[24];       // zeros behind it
    uint64_t bytes;         // all, with these
    uint64_t sum;           // of those behind these
} head;

static const uint64_t MAGIC = 0x656c626d75740a1aU;

// Each word of eight bytes takes its part in the sum by steps that can be undone:
// so another word gives another sum, whatever the others are.
static uint64_t sum_with(uint64_t sum, uint64_t word)
{
    sum = (sum ^ word) * 0x100000001b3U;
    return sum ^ sum >> 32;
}

// A step waits for the one before, so four sums go side by side.
static uint64_t sum_of(const char *at, size_t n)
{
    enum { SUMS = 4 };
    uint64_t word[SUMS], sum[SUMS] = { 0xcbf29ce484222325U, 1, 2, 3 };
    for (; n >= sizeof word; at += sizeof word, n -= sizeof word) {
        memcpy(word, at, sizeof word);
        for (int k = 0; k < SUMS; k++) sum[k] = sum_with(sum[k], word[k]);
    }
    memset(word, 0, sizeof word);
    memcpy(word, at, n);
    for (int k = 0; k < SUMS; k++) sum[k] = sum_with(sum[k], word[k]);
    for (int k = 1; k < SUMS; k++) sum[0] = sum_with(sum[0], sum[k]);
    return sum[0];
}

static head head_of(const char *version)
{
    head h = { .magic = MAGIC };
    strncpy(h.version, version, sizeof h.version - 1);
    return h;
}
//<

//> store-to
//>   Writing counts first and copies second, so that a program can ask how many
//>   bytes it needs.
void store_fail(store *s, status why)
{
    if (s->done.ok) s->done = why;
}

store store_to(void *into, size_t room, const char *version)
{
    head h = head_of(version);
    store s = { .done = status_ok(), .into = into, .room = into ? room : 0,
                .used = sizeof h };
    if (s.room >= sizeof h) memcpy(into, &h, sizeof h);
    return s;
}

size_t store_end(store *s)
{
    head h;
    if (s->used > s->room) return s->used;
    memcpy(&h, s->into, sizeof h);
    h.bytes = s->used;
    h.sum = sum_of(s->into + sizeof h, s->used - sizeof h);
    memcpy(s->into, &h, sizeof h);
    return s->used;
}
//<

//> store-from
//>   Reading believes nothing: a head that is wrong, a sum that is wrong, a
//>   length that is too long are each refused with a sentence.
static status check_head(const char *from, size_t size, const char *version)
{
    head h, wanted = head_of(version);
    unsigned long long given = size;    // Windows knows no %zu
    if (size >= sizeof h) memcpy(&h, from, sizeof h);
    if (size < sizeof h || h.magic != MAGIC)
        return status_fail("these %llu bytes are no saved world", given);
    if (memcmp(h.version, wanted.version, sizeof h.version) != 0)
        return status_fail("the world was saved by another version of the "
                           "library than %s", version);
    if (h.bytes != size)
        return status_fail("a saved world of %llu bytes has %llu",
                           (unsigned long long)h.bytes, given);
    if (h.sum != sum_of(from + sizeof h, size - sizeof h))
        return status_fail("the saved world was altered: its checksum is "
                           "another one");
    return status_ok();
}

store store_from(const void *from, size_t size, const char *version)
{
    if (!from) size = 0;
    return (store){ .done = check_head(from, size, version),
                    .is_reading = true, .from = from, .room = size,
                    .used = sizeof(head) };
}
//<

//> store-bytes
//>   One function moves bytes, whichever way they go. Where both ways must
//>   agree on a number, it compares them.
static void put_bytes(store *s, const void *data, size_t n)
{
    if (n > 0 && s->used + n <= s->room) memcpy(s->into + s->used, data, n);
    s->used += n;
}

// The checksum was right, and yet the bytes are not what is read.
static void refuse(store *s)
{
    store_fail(s, status_fail("the saved world is of another build of the "
                              "library"));
}

static bool get(store *s, void *data, size_t n)
{
    if (n > s->room - s->used) refuse(s);
    if (!s->done.ok) return false;
    if (n > 0) memcpy(data, s->from + s->used, n);
    s->used += n;
    return true;
}

// So many bytes follow; read, they must be as many.
static bool agree(store *s, uint64_t n)
{
    uint64_t there = n;
    if (!s->is_reading) put_bytes(s, &there, sizeof there);
    else if (get(s, &there, sizeof there) && there != n) refuse(s);
    return s->done.ok;
}

void store_memory(store *s, void *data, size_t n)
{
    if (!agree(s, n)) return;
    s->span[s->depth] = (store_span){ data, n, s->used };
    if (s->is_reading) get(s, data, n);
    else               put_bytes(s, data, n);
}
//<

//> store-forget
//>   What has been read is remembered in a list, so that it can be freed if the
//>   rest cannot be read.
void store_enter(store *s)
{
    assert(s->depth < STORE_DEPTH);
    s->depth++;
    s->span[s->depth] = (store_span){ NULL, 0, 0 };
}

void store_leave(store *s)
{
    s->depth--;
}

void store_forget(store *s, const void *field, size_t n)
{
    const char *at = field;
    if (s->is_reading || !s->done.ok) return;
    for (int k = s->depth; k >= 0; k--) {
        store_span x = s->span[k];
        if (!x.from || at < x.from || at >= x.from + x.size) continue;
        size_t in = x.at + (size_t)(at - x.from);
        if (in + n <= s->room) memset(s->into + in, 0, n);
        return;
    }
    assert(s->is_reading && "a field of memory that was not stored");
}
//<

//> store-spare
//>   A world that is put back has the tables that it had before, as a rule. So what
//>   they were in is listed, and the next one takes its tables from the list.
store store_list(store_spare *spare)
{
    assert(spare->count == 0);
    return (store){ .done = status_ok(), .spare = spare };
}

void store_clear(store_spare *spare)
{
    for (int k = 0; k < spare->count; k++) free(spare->block[k].at);
    spare->count = spare->next = 0;
}

void store_free(store_spare *spare)
{
    store_clear(spare);
    free(spare->block);
    *spare = (store_spare){ .count = 0 };
}

static void list(store *s, void *at, size_t size)
{
    store_spare *x = s->spare;
    if (!x || !s->done.ok) return;
    int room = table_room(x->count + 1, x->room);
    if (room > x->room) {
        if (!table_grow(&x->block, x->count, room, sizeof *x->block)) {
            x->count = 0;       // they stay with their tables
            store_fail(s, status_out_of_memory());
            return;
        }
        x->room = room;
    }
    x->block[x->count++] = (store_block){ at, size };
}

// The smallest of the list that is large enough: as a rule the one behind that
// which was taken last, and of the very size.  NULL: there is none.
static void *take_spare(store_spare *x, size_t bytes)
{
    store_block *best = NULL;
    for (int k = 0; x && k < x->count; k++) {
        store_block *b = &x->block[(x->next + k) % x->count];
        if (!b->at || b->size < bytes) continue;
        if (!best || b->size < best->size) best = b;
        if (best->size == bytes) break;
    }
    if (!best) return NULL;
    void *at = best->at;
    best->at = NULL;
    x->next = (int)(best - x->block) + 1;
    return at;
}
//<

//> store-table
// Room for an array: any other may grow out of it.
static void *allocate(store *s, int room, size_t size)
{
    size_t bytes = (size_t)room * size;
    void *memory = take_spare(s->spare, bytes);
    if (!memory) memory = table_lines(bytes);
    if (!memory) store_fail(s, status_out_of_memory());
    return memory;
}

// Is there an array?  Then for so many elements.
static bool is_there(store *s, void *array, int room, size_t size)
{
    void *at;
    memcpy(&at, array, sizeof at);
    char is = at != NULL;
    if (!s->is_reading) {
        store_forget(s, array, sizeof at);
        put_bytes(s, &is, 1);
        if (is) list(s, at, (size_t)room * size);
        return is;
    }
    if (!get(s, &is, 1) || !is) return false;
    if (room < 0) refuse(s);
    at = s->done.ok ? allocate(s, room, size) : NULL;
    memcpy(array, &at, sizeof at);
    return at;
}

void store_table(store *s, void *array, int count, int room, size_t size)
{
    char *at;
    size_t n = (size_t)count * size;
    if (!is_there(s, array, room > count ? room : count, size)) return;
    memcpy(&at, array, sizeof at);
    store_memory(s, at, n);
    if (s->is_reading && room > count)
        memset(at + n, 0, (size_t)(room - count) * size);
    if (s->done.ok || !s->is_reading) return;
    free(at);
    at = NULL;
    memcpy(array, &at, sizeof at);
}

void store_room(store *s, void *array, int room, size_t size)
{
    is_there(s, array, room, size);
}
//<

//> store-pointer
//>   A pointer to a thing that was stored becomes the number of the thing.
// The number of the thing at this address; -1 if it is none.
static int place_of_shape(store *s, const void *thing)
{
    if (!thing) return -1;
    for (int k = 0; k < s->things; k++) {
        int number = (s->last + k) % s->things;
        if (s->thing(s->owner, number) != thing) continue;
        return s->last = number;
    }
    return -1;
}

void store_pointer(store *s, void *pointer)
{
    const void *thing;
    memcpy(&thing, pointer, sizeof thing);
    int number = s->is_reading ? -1 : place_of_shape(s, thing);
    if (!s->is_reading) {
        store_forget(s, pointer, sizeof thing);
        put_bytes(s, &number, sizeof number);
        return;
    }
    thing = NULL;
    if (get(s, &number, sizeof number) && number >= 0 && number < s->things)
        thing = s->thing(s->owner, number);
    memcpy(pointer, &thing, sizeof thing);
}
//<
