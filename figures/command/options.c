// options.c - a table of options, and what reads and prints it.

#include "options.h"
#include "play.h"
#include "thread.h"

#include <ctype.h>
#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// ---- The table -------------------------------------------------------------

typedef enum {
    KIND_FLAG,          // int, no value
    KIND_OFF,           // bool, no value: turned off
    KIND_COUNT,         // int
    KIND_REAL,          // real; 1/60 is understood
    KIND_SEED,          // unsigned long long
    KIND_PATH           // const char *
} option_kind;

enum {
    FOR_ROOM = 1 << SCENE_ROOM,
    FOR_CLOTH = 1 << SCENE_CLOTH_ON_CUBE | 1 << SCENE_CLOTH_ON_ROPE,
    FOR_ALL = FOR_ROOM | FOR_CLOTH,
    FOR_NONE = 0,       // asks for words, not for a scene
    ASIDE = 1 << 8,     // leaves the motion as it is
    FOR_SWEEP = 1 << 9
};

typedef struct {
    const char *name;
    option_kind kind;
    const char *value;  // how the help calls it
    real   least, most;
    int    scenes;      // that it means something to
    size_t at;          // where it goes
    const char *help;
} option;

#define ENGINE(field) offsetof(settings, engine.field)

static const option options[] = {
    { "--bodies", KIND_COUNT, "N", 1, 20000, FOR_ROOM,
      offsetof(settings, bodies), "bodies thrown into the room" },
    { "--mesh", KIND_PATH, "FILE.obj", 0, 0, FOR_ROOM,
      offsetof(settings, mesh), "throw your own convex body, not icosahedra" },
    { "--cloth", KIND_COUNT, "N", 2, 512, FOR_CLOTH,
      offsetof(settings, cloth), "particles along a side of the cloth" },
    { "--seed", KIND_SEED, "N", 0, 0, FOR_ROOM,
      offsetof(settings, seed), "another number, another throw" },
    { "--plain", KIND_FLAG, "", 0, 0, FOR_ALL,
      offsetof(settings, plain), "run the paper's system, mended (Part I)" },
    { "--paper", KIND_FLAG, "", 0, 0, FOR_ALL,
      offsetof(settings, paper), "run it as the paper prints it" },
    { "--seconds", KIND_REAL, "S", 0, 100000, FOR_ALL,
      offsetof(settings, seconds), "how long the scene is followed" },
    { "--dt", KIND_REAL, "S", 1e-9, 1, FOR_ALL,
      offsetof(settings, dt), "seconds in a step, such as 1/60" },
    { "--substeps", KIND_COUNT, "N", 1, 10000, FOR_ALL,
      offsetof(settings, substeps), "integrations in a step" },
    { "--iterations", KIND_COUNT, "N", 1, 10000, FOR_ALL,
      offsetof(settings, iterations), "over a body's sticks in a substep" },
    { "--tolerance", KIND_REAL, "T", 0, 1, FOR_ALL,
      offsetof(settings, tolerance), "strain that counts as none" },
    { "--gravity", KIND_REAL, "G", 0, 1000, FOR_ALL,
      offsetof(settings, gravity), "m/s^2, downwards" },
    { "--friction", KIND_REAL, "MU", 0, 1000, FOR_ALL,
      ENGINE(friction), "Coulomb's coefficient" },
    { "--restitution", KIND_REAL, "E", 0, 1, FOR_ROOM,
      ENGINE(restitution), "speed after an impact / the speed before" },
    { "--hertz", KIND_REAL, "F", 1e-3, 1e6, FOR_ALL,
      ENGINE(hertz), "stiffness of contacts: of their springs" },
    { "--stay", KIND_REAL, "S", 0, 0.1, FOR_ROOM,
      ENGINE(stay), "radii that a body goes before it is asked again" },
    { "--most-substeps", KIND_COUNT, "N", 1, 10000, FOR_ALL,
      ENGINE(most_substeps), "that a hard frame may take" },
    { "--no-warm-start", KIND_OFF, "", 0, 0, FOR_ROOM,
      ENGINE(warm_start), "contacts begin without the last impulses" },
    { "--sleep-speed", KIND_REAL, "V", 0, 1e9, FOR_ROOM,
      ENGINE(sleep_speed), "m/s: slower bodies fall asleep; 0: none does" },
    { "--time-to-sleep", KIND_REAL, "S", 0, 1e9, FOR_ROOM,
      ENGINE(time_to_sleep), "so long they must have been slow" },
    { "--threads", KIND_COUNT, "N", 1, MOST_THREADS, FOR_ROOM | ASIDE,
      offsetof(settings, threads), "that share the work, with the same bits" },
    { "--film", KIND_PATH, "FILE.png", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, film), "draw a strip of three pictures" },
    { "--frames", KIND_PATH, "DIR", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, frames), "draw DIR/frame-00000.png and so on" },
    { "--obj", KIND_PATH, "DIR", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, obj), "write DIR/frame-00000.obj and so on" },
    { "--every", KIND_REAL, "S", 1e-9, 100000, FOR_ALL | ASIDE,
      offsetof(settings, every), "s, from one of these frames to the next" },
    { "--csv", KIND_PATH, "FILE", 0, 0, FOR_ALL | ASIDE | FOR_SWEEP,
      offsetof(settings, csv), "write a row of measures for every step" },
    { "--record", KIND_PATH, "FILE", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, record), "keep the options, and a hash every 60 "
                                  "steps" },
    { "--replay", KIND_PATH, "FILE", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, replay), "run that again: are the hashes the same?" },
    { "--bits", KIND_FLAG, "", 0, 0, FOR_ALL | ASIDE,
      offsetof(settings, bits), "print a hash of where everything ends" },
    { "--sweep", KIND_PATH, "TABLE", 0, 0, FOR_SWEEP | ASIDE,
      offsetof(settings, sweep), "run its rows, by GNU Parallel; --csv FILE" },
    { "--jobs", KIND_COUNT, "N", 1, 10000, FOR_SWEEP | ASIDE,
      offsetof(settings, jobs), "rows at a time; else one a core" },
    { "--resume", KIND_FLAG, "", 0, 0, FOR_SWEEP | ASIDE,
      offsetof(settings, resume), "go on with a sweep that was stopped" },
    { "--joblog", KIND_PATH, "FILE", 0, 0, FOR_SWEEP | ASIDE,
      offsetof(settings, joblog), "when and how each row ran; else "
                                  "TABLE.joblog" },
    { "--sshloginfile", KIND_PATH, "FILE", 0, 0, FOR_SWEEP | ASIDE,
      offsetof(settings, hosts), "machines, in the words of GNU Parallel" },
    { "--row", KIND_COUNT, "N", 1, 10000000, FOR_SWEEP | ASIDE,
      offsetof(settings, row), "run only this one, and print its line" },
    { "--list", KIND_FLAG, "", 0, 0, FOR_NONE,
      offsetof(settings, list), "name the scenes and the options" },
    { "--help", KIND_FLAG, "", 0, 0, FOR_NONE,
      offsetof(settings, help), "print this; so does -h" },
    { "--version", KIND_FLAG, "", 0, 0, FOR_NONE,
      offsetof(settings, version), "print the version" },
};

enum { OPTIONS = sizeof options / sizeof options[0] };

static const struct {
    const char *help;
    real seconds;
} scenes[SCENES] = {
    { "rigid bodies are thrown into a cubic room", 10 },
    { "a cloth falls onto a cube", 5 },
    { "a cloth falls onto a rope that hangs by its ends", 5 },
};

// ---- Names -----------------------------------------------------------------

static int least_of(int a, int b)
{
    return a < b ? a : b;
}

// How many letters must be put in, left out or changed to make a of b
// (Levenshtein), row by row; 99 for names that are too long to be a slip.
static int misspelt_by(const char *a, const char *b)
{
    enum { LONGEST = 32 };
    int row[LONGEST + 1], n = (int)strlen(b);
    if (n > LONGEST || strlen(a) > LONGEST) return 99;
    for (int j = 0; j <= n; j++) row[j] = j;
    for (int i = 0; a[i]; i++) {
        int slant = row[0];
        row[0] = i + 1;
        for (int j = 0; j < n; j++) {
            int changed = slant + (a[i] != b[j]);
            slant = row[j + 1];
            row[j + 1] = least_of(changed, 1 + least_of(row[j], slant));
        }
    }
    return row[n];
}

// The name nearest to a misspelt one, if it is near at all.
static const char *nearest_name(const char *given, const char *(*name)(int),
                                int names)
{
    int best = 4;
    const char *found = NULL;
    for (int i = 0; i < names; i++) {
        int d = misspelt_by(given, name(i));
        if (d >= best || d >= (int)strlen(given)) continue;
        best = d;
        found = name(i);
    }
    return found;
}

static const char *option_name(int i)
{
    return options[i].name;
}

// The three scenes, and behind them those of figures/scenes.
static const char *any_scene_name(int i)
{
    return i < SCENES ? scene_name((scene_kind)i) : examples[i - SCENES]->name;
}

static int count_scenes(void)
{
    int n = 0;
    while (examples[n]) n++;
    return SCENES + n;
}

// "a, b and c", of all scenes.
static const char *scene_names(char *text, size_t room)
{
    int n = count_scenes();
    size_t at = 0;
    for (int i = 0; i < n && at < room; i++)
        at += (size_t)snprintf(text + at, room - at, "%s%s", i == 0 ? ""
                               : i < n - 1 ? ", " : " and ", any_scene_name(i));
    return text;
}

// text may go on with the option's value.
static status unknown_option(const char *text)
{
    char given[81];
    snprintf(given, sizeof given, "%.*s", (int)strcspn(text, "="), text);
    const char *meant = nearest_name(given, option_name, OPTIONS);
    return status_fail("there is no option %s%s%s%s", given,
                       meant ? "; did you mean " : " (see tumble --list)",
                       meant ? meant : "", meant ? "?" : "");
}

static status unknown_scene(const char *given)
{
    if (play_find(given))
        return status_fail("the scene %s stands first: tumble %s, and then its "
                           "options", given, given);
    const char *meant = nearest_name(given, any_scene_name, count_scenes());
    if (meant)
        return status_fail("there is no scene \"%.80s\"; did you mean %s?",
                           given, meant);
    return status_fail("there is no scene \"%.80s\" (see tumble --list)",
                       given);
}

// ---- Values ----------------------------------------------------------------

static status out_of_range(const option *o, const char *text)
{
    return status_fail("%s %.40s: must lie between %g and %g", o->name, text,
                       o->least, o->most);
}

static status read_count(const option *o, const char *text, int *value)
{
    char *end;
    errno = 0;
    long n = strtol(text, &end, 10);
    if (end == text || *end || isspace((unsigned char)*text))
        return status_fail("%s %.40s: not a whole number", o->name, text);
    if (errno || (real)n < o->least || (real)n > o->most)
        return out_of_range(o, text);
    *value = (int)n;
    return status_ok();
}

static status read_seed(const option *o, const char *text,
                        unsigned long long *value)
{
    char *end;
    errno = 0;
    unsigned long long n = strtoull(text, &end, 10);
    // strtoull takes -1 for the largest number there is.
    if (!isdigit((unsigned char)*text) || *end)
        return status_fail("%s %.40s: not a whole number of at least 0",
                           o->name, text);
    if (errno)
        return status_fail("%s %.40s: larger than 2^64 - 1", o->name, text);
    *value = n;
    return status_ok();
}

// A decimal number, or two with a slash between them.
static status read_real(const option *o, const char *text, real *value)
{
    char *end;
    real x = strtod(text, &end), below = 1;
    int sound = end != text && !isspace((unsigned char)*text);
    if (sound && *end == '/') {
        const char *rest = end + 1;
        below = strtod(rest, &end);
        sound = isdigit((unsigned char)*rest) || *rest == '.';
    }
    if (!sound || *end)
        return status_fail("%s %.40s: not a number", o->name, text);
    x /= below;
    if (!(x - x == 0))
        return status_fail("%s %.40s: not a finite number", o->name, text);
    if (x < o->least || x > o->most) return out_of_range(o, text);
    *value = x;
    return status_ok();
}

static status read_path(const option *o, const char *text, const char **value)
{
    if (!*text) return status_fail("%s: the name is empty", o->name);
    *value = text;
    return status_ok();
}

static status read_value(const option *o, const char *text, settings *s)
{
    void *field = (char *)s + o->at;
    switch (o->kind) {
    case KIND_FLAG:  *(int *)field = 1; return status_ok();
    case KIND_OFF:   *(bool *)field = false; return status_ok();
    case KIND_COUNT: return read_count(o, text, field);
    case KIND_REAL:  return read_real(o, text, field);
    case KIND_SEED:  return read_seed(o, text, field);
    case KIND_PATH:  return read_path(o, text, field);
    }
    return status_ok();
}

// ---- The command line ------------------------------------------------------

static settings settings_default(void)
{
    scene_options o = scene_options_default();
    return (settings){ .scene = SCENES, .bodies = o.bodies, .cloth = o.cloth,
                       .seed = o.seed, .seconds = -1, .tolerance = -1,
                       .threads = 1, .dt = 1.0 / 60,
                       .every = 1.0 / 60, .gravity = 9.81,
                       .engine = world_options_default() };
}

// Finds --name in "--name" or "--name=value"; -1: there is none.
static int find_option(const char *text)
{
    if (!strcmp(text, "-h")) text = "--help";
    size_t n = strcspn(text, "=");
    for (int i = 0; i < OPTIONS; i++)
        if (strlen(options[i].name) == n && !strncmp(options[i].name, text, n))
            return i;
    return -1;
}

static bool is_given(const settings *s, int k)
{
    return s->given & 1ull << k;
}

// Reads the option that stands at argument[*i], and its value if it has one.
static status read_option(settings *s, int arguments, char *const *argument,
                          int *i)
{
    const char *text = argument[*i], *value = strchr(text, '=');
    int k = find_option(text);
    if (k < 0) return unknown_option(text);
    const option *o = &options[k];
    bool again = is_given(s, k);
    s->given |= 1ull << k;
    if (value) value++;
    if (o->kind == KIND_FLAG || o->kind == KIND_OFF)
        return value ? status_fail("%s takes no value", o->name)
                     : read_value(o, NULL, s);
    if (again) return status_fail("%s is given twice", o->name);
    // The next word is the value, unless it is itself an option.
    if (!value && *i + 1 < arguments && strncmp(argument[*i + 1], "--", 2))
        value = argument[++*i];
    if (!value)
        return status_fail("%s needs a value: %s %s", o->name, o->name,
                           o->value);
    return read_value(o, value, s);
}

static status read_scene(settings *s, const char *text)
{
    for (int k = 0; k < SCENES; k++) {
        if (strcmp(text, scene_name((scene_kind)k))) continue;
        if (s->scene != SCENES)
            return status_fail("two scenes are named, %s and %s; one at a time",
                               scene_name(s->scene), text);
        s->scene = (scene_kind)k;
        return status_ok();
    }
    return unknown_scene(text);
}

static bool is_engine_field(const option *o)
{
    return o->at >= ENGINE(dt) && o->at < ENGINE(dt) + sizeof(world_options);
}

// The paper's system has friction, too.
static bool is_engine_only(const option *o)
{
    return o->at == offsetof(settings, threads) ||
           (is_engine_field(o) && o->at != ENGINE(friction));
}

static status check_runner(const settings *s)
{
    for (int k = 0; k < OPTIONS; k++)
        if (is_given(s, k) && is_engine_only(&options[k]))
            return status_fail("%s is the engine's; the paper's system has no "
                               "such option", options[k].name);
    return status_ok();
}

// What no single word can tell.
static status check_together(const settings *s)
{
    char names[170];
    if (s->scene == SCENES)
        return status_fail("no scene is named; there are %s",
                           scene_names(names, sizeof names));
    if (s->paper && s->plain)
        return status_fail("--paper and --plain are two ways to run a scene; "
                           "one at a time");
    if (settings_runner(s) != BY_ENGINE && !check_runner(s).ok)
        return check_runner(s);
    if (s->seconds / s->dt > 1e7)
        return status_fail("--seconds %g in steps of --dt %g would be %.3g "
                           "steps; the most is 1e7", s->seconds, s->dt,
                           s->seconds / s->dt);
    return status_ok();
}

static status read_words(settings *s, int words, char *const *word)
{
    status done = status_ok();
    for (int i = 0; i < words && done.ok; i++)
        done = word[i][0] == '-' ? read_option(s, words, word, &i)
                                 : read_scene(s, word[i]);
    return done;
}

static bool moves_scene(const option *o)
{
    return o->scenes != FOR_NONE && !(o->scenes & ASIDE);
}

// A record says all that moves the scene.
static status check_replay(const settings *s)
{
    for (int k = 0; k < OPTIONS; k++)
        if (is_given(s, k) && moves_scene(&options[k]))
            return status_fail("%s is said by the record of --replay, and "
                               "cannot be another", options[k].name);
    if (s->scene == SCENES) return status_ok();
    return status_fail("the scene is named by the record of --replay");
}

// What is for a sweep, and what stands in its table.
static status check_sweep(const settings *s)
{
    for (int k = 0; k < OPTIONS; k++) {
        const option *o = &options[k];
        if (!is_given(s, k)) continue;
        if (s->sweep && !(o->scenes & FOR_SWEEP))
            return status_fail("%s is said by the rows of the table, and not "
                               "beside --sweep", o->name);
        if (!s->sweep && o->scenes == (FOR_SWEEP | ASIDE))
            return status_fail("%s is for a sweep: --sweep TABLE", o->name);
    }
    if (s->sweep && s->scene != SCENES)
        return status_fail("the scene is named by the table of --sweep");
    return status_ok();
}

static status finish_settings(settings *s)
{
    if (s->scene != SCENES && s->seconds < 0)
        s->seconds = scenes[s->scene].seconds;
    return check_together(s);
}

status settings_read(settings *s, int arguments, char *const *argument)
{
    *s = settings_default();
    status done = read_words(s, arguments - 1, argument + 1);
    if (!done.ok || s->help || s->list || s->version) return done;
    done = check_sweep(s);
    if (!done.ok || s->sweep) return done;
    return s->replay ? check_replay(s) : finish_settings(s);
}

status settings_read_more(settings *s, int words, char *const *word)
{
    status done = read_words(s, words, word);
    return done.ok ? finish_settings(s) : done;
}

scene_options settings_scene(const settings *s)
{
    scene_options o = scene_options_default();
    o.bodies = s->bodies;
    o.cloth = s->cloth;
    o.seed = s->seed;
    return o;
}

// Takes over the fields that were given.
static void give_engine(const settings *s, world_options *o)
{
    for (int k = 0; k < OPTIONS; k++) {
        if (!is_given(s, k) || !is_engine_field(&options[k])) continue;
        size_t size = options[k].kind == KIND_REAL ? sizeof(real)
                    : options[k].kind == KIND_COUNT ? sizeof(int)
                    : sizeof(bool);
        memcpy((char *)o + (options[k].at - offsetof(settings, engine)),
               (const char *)s + options[k].at, size);
    }
}

world_options settings_world(const settings *s)
{
    world_options o = world_scene_options(s->scene, s->cloth);
    give_engine(s, &o);
    o.dt = s->dt;
    o.gravity = vec3_make(0, -s->gravity, 0);
    if (s->substeps > 0) o.substeps = s->substeps;
    if (s->iterations > 0) o.iterations = s->iterations;
    if (s->tolerance >= 0) o.relax.tolerance = s->tolerance;
    return o;
}

system_options settings_system(const settings *s)
{
    system_options o = runner_options(settings_runner(s));
    o.dt = s->dt;
    o.gravity = vec3_make(0, -s->gravity, 0);
    if (is_given(s, find_option("--friction"))) o.friction = s->engine.friction;
    if (s->substeps > 0) o.substeps = s->substeps;
    if (s->iterations > 0)
        o.rigid.iterations = o.soft.iterations = s->iterations;
    if (s->tolerance >= 0)
        o.rigid.how.tolerance = o.soft.how.tolerance = s->tolerance;
    return o;
}

runner_kind settings_runner(const settings *s)
{
    return s->paper ? AS_PRINTED : s->plain ? BY_PLAIN : BY_ENGINE;
}

long settings_steps(const settings *s)
{
    // A whole number of steps but for rounding is that number.
    return (long)ceil(s->seconds / s->dt * (1 - 1e-12));
}

long settings_steps_a_frame(const settings *s)
{
    real steps = s->every / s->dt + 0.5;
    return steps < 1 ? 1 : (long)steps;
}

// ---- Words -----------------------------------------------------------------

// s.  Contacts are looked for once in a step: in longer ones the room's bodies
// are found more than 5 cm deep in each other.
static const real LONG_STEP = 1.0 / 20;

void settings_print_notes(const settings *s, FILE *out)
{
    for (int k = 0; k < OPTIONS; k++)
        if (is_given(s, k) && !(options[k].scenes & 1 << s->scene))
            fprintf(out, "tumble: %s means nothing to the scene %s, and is "
                    "ignored\n", options[k].name, scene_name(s->scene));
    if (s->dt > LONG_STEP)
        fprintf(out, "tumble: --dt %g is long: contacts are looked for once in "
                "a step, and in steps of more than 1/20 s bodies sink into "
                "each other\n", s->dt);
}

static void print_word(FILE *out, const option *o, const void *field)
{
    switch (o->kind) {
    case KIND_FLAG: case KIND_OFF: fprintf(out, "%s\n", o->name); break;
    case KIND_COUNT: fprintf(out, "%s=%d\n", o->name, *(const int *)field);
        break;
    case KIND_REAL: fprintf(out, "%s=%.17g\n", o->name, *(const real *)field);
        break;
    case KIND_SEED: fprintf(out, "%s=%llu\n", o->name,
                            *(const unsigned long long *)field);
        break;
    case KIND_PATH: fprintf(out, "%s=%s\n", o->name,
                            *(const char *const *)field);
        break;
    }
}

void settings_print_words(const settings *s, FILE *out)
{
    fprintf(out, "%s\n", scene_name(s->scene));
    for (int k = 0; k < OPTIONS; k++) {
        const option *o = &options[k];
        bool always = o->at == offsetof(settings, seed)
                   || o->at == offsetof(settings, seconds)
                   || o->at == offsetof(settings, dt);
        if (!moves_scene(o) || !(o->scenes & 1 << s->scene)) continue;
        if (always || is_given(s, k))
            print_word(out, o, (const char *)s + o->at);
    }
}

static void print_scenes(FILE *out)
{
    for (int k = 0; k < SCENES; k++)
        fprintf(out, "  %-22s %s (%g s)\n", scene_name((scene_kind)k),
                scenes[k].help, scenes[k].seconds);
}

// What holds where nothing else is said.
static void print_default(FILE *out, const option *o)
{
    settings s = settings_default();
    const void *field = (const char *)&s + o->at;
    if (o->kind == KIND_COUNT && *(const int *)field > 0)
        fprintf(out, " (%d)", *(const int *)field);
    if (o->kind == KIND_SEED)
        fprintf(out, " (%llu)", *(const unsigned long long *)field);
    if (o->kind == KIND_REAL && is_engine_field(o))
        fprintf(out, " (%g)", *(const real *)field);
    if (o->at == offsetof(settings, gravity)) fprintf(out, " (9.81)");
    if (o->at == offsetof(settings, dt) || o->at == offsetof(settings, every))
        fprintf(out, " (1/60)");
}

static void print_options(FILE *out)
{
    for (int k = 0; k < OPTIONS; k++) {
        const option *o = &options[k];
        int width = fprintf(out, "  %s %s", o->name, o->value);
        fprintf(out, "%*s%s", width < 25 ? 25 - width : 1, "", o->help);
        int some = o->scenes & FOR_ALL;
        if (some == FOR_ROOM) fprintf(out, "; room only");
        if (some == FOR_CLOTH) fprintf(out, "; cloth only");
        if (o->scenes == (FOR_SWEEP | ASIDE)) fprintf(out, "; sweeps only");
        print_default(out, o);
        fprintf(out, "\n");
    }
}

void settings_print_list(FILE *out)
{
    fprintf(out, "scenes\n");
    print_scenes(out);
    fprintf(out, "options\n");
    print_options(out);
}

void settings_print_help(FILE *out)
{
    fprintf(out,
        "tumble SCENE [options]\n"
        "tumble --replay FILE [options]\n"
        "tumble --sweep TABLE [options]\n\n"
        "Animates a scene with particles and sticks, and prints how large the\n"
        "errors were and how long it took.\n\n");
    settings_print_list(out);
    fprintf(out,
        "\nCtrl-C stops after the current step and keeps what is finished; a\n"
        "second one ends at once.\n"
        "Exit status: 0 done, 1 failed, 2 the command line is wrong,\n"
        "130 Ctrl-C, 143 terminated.\n");
}
