// fuzz_obj.c - obj_read on a file of any bytes.  See fuzz.h.
//
// The file is memory: the linker gives this program its own fopen.

#define _POSIX_C_SOURCE 200809L

#include "fuzz.h"
#include "convex.h"
#include "obj.h"
#include "validate.h"

static const uint8_t *file;
static size_t length;

FILE *__real_fopen(const char *path, const char *mode);
FILE *__wrap_fopen(const char *path, const char *mode);

FILE *__wrap_fopen(const char *path, const char *mode)
{
    if (strcmp(path, "fuzz.obj") != 0) return __real_fopen(path, mode);
    return fmemopen((void *)(uintptr_t)file, length, mode);
}

// One sentence, that names the file, and nothing half built.
static void check_refused(status r, const shape *s)
{
    MUST(strncmp(r.why, "fuzz.obj", 8) == 0 || !strcmp(r.why, "out of memory"),
         "says \"%s\"", r.why);
    MUST(!strchr(r.why, '\n') && memchr(r.why, 0, sizeof r.why),
         "is not one sentence");
    MUST(s->particles == 0 && s->sticks == 0 && s->mesh.edges == 0, "counts");
    MUST(!s->at && !s->mass && !s->stick && !s->face && !s->mesh.half,
         "something is left");
}

static void check_sticks(const shape *s)
{
    for (int k = 0; k < s->sticks; k++) {
        stick at = s->stick[k];
        MUST(at.a >= 0 && at.a < s->particles && at.b >= 0
             && at.b < s->particles && at.a != at.b, "stick %d", k);
        MUST(at.rest_length > 0 && at.rest_length <= 2.0000001, "stick %d: %g",
             k, at.rest_length);
    }
}

// A convex body of radius 1 with its centre at the origin.
static void check_body(const shape *s)
{
    vec3 sum = { 0, 0, 0 };
    MUST(s->particles >= 4 && s->particles <= 4096, "%d", s->particles);
    for (int i = 0; i < s->particles; i++) {
        MUST(vec3_is_finite(s->at[i]), "particle %d", i);
        MUST(vec3_length(s->at[i]) <= 1 + 1e-9, "particle %d", i);
        MUST(s->mass[i] > 0, "mass %d", i);
        sum = vec3_add(sum, s->at[i]);
    }
    MUST(vec3_length(sum) <= 1e-12 * s->particles, "%g off its centre",
         vec3_length(sum));
    MUST(fabs(s->radius - 1) <= 1e-12, "radius %.17g", s->radius);
    MUST(mesh_validate(&s->mesh).ok, "%s", mesh_validate(&s->mesh).why);
    status r = mesh_check_convex(&s->mesh, s->at);
    MUST(r.ok, "%s", r.why);
    MUST(s->sticks >= 3 * s->particles - 6, "%d sticks", s->sticks);
    check_sticks(s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    shape s;
    memset(&s, 0x55, sizeof s);
    file = data;
    length = size;
    status r = obj_read("fuzz.obj", 1, 1, &s);
    if (r.ok) check_body(&s);
    else check_refused(r, &s);
    shape_free(&s);
    return 0;
}
