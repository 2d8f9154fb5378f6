// main.c - the command: runs a scene, draws it, measures it.
//
// Exit status: 0 done, 1 failed, 2 the command line is wrong, 128 + the
// signal's number if Ctrl-C, a termination or a closed terminal ended it.

#define _POSIX_C_SOURCE 200809L

#include "tumble.h"
#include "frames.h"
#include "obj.h"
#include "play.h"
#include "record.h"
#include "sweep.h"
#include "thread.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif


enum { EXIT_WRONG_USE = 2, EXIT_SIGNAL = 128 };

// ---- The clock and the signals ---------------------------------------------

static real clock_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (real)t.tv_sec + 1e-9 * (real)t.tv_nsec;
}

// The signal that asked us to stop; 0: none did.
static volatile sig_atomic_t stop_signal = 0;

static void on_signal(int number)
{
    stop_signal = number;
}

// The first one is heard, a second one ends the program at once.  Without
// SA_RESTART a signal also ends the wait for a pipe's other end.
static void catch_signals(int flags)
{
    struct sigaction act = { .sa_handler = on_signal,
                             .sa_flags = flags | (int)SA_RESETHAND };
    sigemptyset(&act.sa_mask);
    sigaction(SIGINT, &act, NULL);
    sigaction(SIGTERM, &act, NULL);
    sigaction(SIGHUP, &act, NULL);
}

// ---- A run -----------------------------------------------------------------

// The largest value met, and when.
typedef struct {
    real value, time;           // time in s
} peak;

typedef struct {
    settings set;
    const char *cells;          // of a row of a sweep; NULL: it is none
    runner   run;
    thread_pool *pool;          // NULL: there is one thread
    long     steps, done;       // wanted; finished
    output   csv;
    strip    strip;
    frames   pictures, meshes;
    output   record;
    replay   replay;
    real    *step_time;         // [steps] s
    real     phase_time[PHASES];
    real     began, told;       // s, by the clock: the run, the last progress
    peak     strain, penetration, kinetic, momentum, unconverged;
    measures last;              // of the last step that was finite
    int      lost;              // the motion grew beyond all numbers
} run;

static void raise_peak(peak *p, real value, real time)
{
    if (!(value <= p->value)) *p = (peak){ value, time };
}

// s, of the scene's own time.
static real time_done(const run *r)
{
    return (real)r->done * r->set.dt;
}

// A file that the command line names.
typedef struct {
    const char *option, *path;  // path = NULL: not asked for
    int is_read;
} named_file;

// A pipe would wait for ever.  The library says why a file cannot be opened.
static status check_read(const named_file *f)
{
    struct stat there;
    if (!f->path || !f->is_read || stat(f->path, &there) != 0
        || S_ISREG(there.st_mode)) return status_ok();
    return status_fail("%.100s: is not a regular file: %s is read from one",
                       f->path, f->option);
}

// Does one overwrite the other?
static status check_pair(const named_file *a, const named_file *b)
{
    if (!a->path || !b->path || (a->is_read && b->is_read)
        || !output_is_same(a->path, b->path)) return status_ok();
    return status_fail("%s %.60s and %s %.60s name the same file",
                       a->option, a->path, b->option, b->path);
}

// Does one of the frames?
static status check_frames(const named_file *f, const char *folder)
{
    if (!f->path || !folder || !output_is_in(f->path, folder, "frame-"))
        return status_ok();
    return status_fail("%s %.60s has the name of a frame that is written into "
                       "%.60s", f->option, f->path, folder);
}

// Before anything is opened: what is opened to be written may be overwritten.
static status check_names(const settings *set)
{
    const named_file file[] = {
        { "--mesh", set->mesh, 1 }, { "--replay", set->replay, 1 },
        { "--film", set->film, 0 }, { "--csv", set->csv, 0 },
        { "--record", set->record, 0 },
    };
    int files = (int)(sizeof file / sizeof file[0]);
    status done = status_ok();
    for (int i = 0; i < files && done.ok; i++) {
        done = check_read(&file[i]);
        if (done.ok) done = check_frames(&file[i], set->frames);
        if (done.ok) done = check_frames(&file[i], set->obj);
        for (int k = i + 1; k < files && done.ok; k++)
            done = check_pair(&file[i], &file[k]);
    }
    return done;
}

static status check_outputs(run *r)
{
    status done = check_names(&r->set);
    if (done.ok && r->set.film) done = picture_check(r->set.film);
    if (done.ok && r->set.csv) done = output_check(r->set.csv);
    if (done.ok && r->set.record) done = output_check(r->set.record);
    r->pictures = (frames){ .folder = r->set.frames, .ending = ".png",
                            .write = frames_picture };
    r->meshes = (frames){ .folder = r->set.obj, .ending = ".obj",
                          .write = frames_obj };
    if (done.ok && r->set.frames) done = frames_begin(&r->pictures);
    if (done.ok && r->set.obj) done = frames_begin(&r->meshes);
    return done;
}

static status write_csv_head(run *r)
{
    if (!r->csv.file) return status_ok();
    fprintf(r->csv.file, "time_s,strain,penetration_m,kinetic_J,"
                         "momentum_kg_m_s,contacts,relaxations,step_s\n");
    return output_flush(&r->csv);
}

// The scene knows a shape, its user a file.
static status name_mesh(const settings *set, status s)
{
    if (s.ok || !set->mesh) return s;
    return status_fail("%.100s: %s", set->mesh, s.why);
}

static status begin_scene(run *r)
{
    scene_options what = settings_scene(&r->set);
    shape thrown;
    if (r->set.mesh) {
        status read = obj_read(r->set.mesh, SCENE_BODY_RADIUS, 1, &thrown);
        if (!read.ok) return read;
        what.thrown = &thrown;
    }
    runner_kind kind = settings_runner(&r->set);
    if (kind != BY_ENGINE)
        return name_mesh(&r->set, runner_begin_system(&r->run, kind,
                         r->set.scene, what, settings_system(&r->set)));
    world_options how = settings_world(&r->set);
    how.host.clock = clock_seconds;
    if (r->set.threads > 1) {
        r->pool = thread_pool_new(r->set.threads);
        if (!r->pool) {
            if (what.thrown) shape_free(what.thrown);
            return status_fail("there are no %d threads to be had",
                               r->set.threads);
        }
        how.host.run = thread_pool_tasks(r->pool);
    }
    return name_mesh(&r->set, runner_begin_world(&r->run, r->set.scene, what,
                                                 how));
}

// Everything that can go wrong before the first step goes wrong here.
static status run_begin(run *r)
{
    if (!r->cells) settings_print_notes(&r->set, stderr);
    if (r->set.scene != SCENE_ROOM) r->set.mesh = NULL;     // nothing reads it
    status done = check_outputs(r);
    if (!done.ok) return done;
    done = begin_scene(r);
    if (!done.ok) return done;
    r->steps = settings_steps(&r->set);
    r->step_time = malloc((size_t)(r->steps + 1) * sizeof *r->step_time);
    if (!r->step_time) return status_out_of_memory();
    if (r->set.csv) done = output_open(&r->csv, r->set.csv);
    if (done.ok) done = write_csv_head(r);
    if (done.ok && r->set.record) done = record_open(&r->record, &r->set);
    r->strip = strip_begin(r->set.scene, r->steps, r->set.dt);
    r->began = r->told = clock_seconds();
    return done;
}

static void run_free(run *r)
{
    output_cancel(&r->csv);
    output_cancel(&r->record);
    replay_close(&r->replay);
    frames_end(&r->pictures);
    frames_end(&r->meshes);
    strip_free(&r->strip);
    runner_free(&r->run);
    thread_pool_free(r->pool);
    free(r->step_time);
}

// ---- Steps -----------------------------------------------------------------

// What is due after a step, or before the first one.
static status look_at_run(run *r)
{
    pose now = { r->set.scene, &r->run.scene, r->run.at, r->run.time };
    status done = replay_look(&r->replay, &r->run, r->done,
                              r->steps);
    if (done.ok) done = record_look(&r->record, &r->run, r->done, 0);
    if (done.ok && r->set.film) done = strip_look(&r->strip, now, r->done);
    if (r->done % settings_steps_a_frame(&r->set)) return done;
    if (done.ok && r->set.frames) done = frames_add(&r->pictures, &now);
    if (done.ok && r->set.obj) done = frames_add(&r->meshes, &now);
    return done;
}

static status write_csv_row(run *r)
{
    if (!r->csv.file) return status_ok();
    const measures *m = &r->last;
    fprintf(r->csv.file, "%.9g,%.6g,%.6g,%.9g,%.9g,%d,%ld,%.6g\n",
            r->run.time, m->strain, m->penetration, m->kinetic,
            vec3_length(m->momentum), r->run.contacts, r->run.relaxed,
            r->step_time[r->done - 1]);
    return output_flush(&r->csv);
}

// Measures the scene, unless it has grown beyond all numbers.
static void measure_run(run *r)
{
    real now = r->run.time;
    measures m = runner_measure(&r->run);
    real sum = m.strain + m.penetration + m.kinetic + vec3_length(m.momentum);
    r->lost = !(sum - sum == 0);
    if (r->lost) return;
    r->last = m;
    raise_peak(&r->strain, m.strain, now);
    raise_peak(&r->penetration, m.penetration, now);
    raise_peak(&r->kinetic, m.kinetic, now);
    raise_peak(&r->momentum, vec3_length(m.momentum), now);
    raise_peak(&r->unconverged, r->run.unconverged, now);
}

static status step_run(run *r)
{
    real start = clock_seconds();
    runner_step(&r->run);
    real taken = clock_seconds() - start;
    measure_run(r);
    // A step that ended in no number at all counts as not taken.
    if (r->lost) return status_ok();
    r->step_time[r->done++] = taken;
    for (int k = 0; k < PHASES && r->run.kind == BY_ENGINE; k++)
        r->phase_time[k] += r->run.world.report.time[k];
    status done = write_csv_row(r);
    return done.ok ? look_at_run(r) : done;
}

// A line that says how far we are, five times a second, where somebody looks.
static void tell_progress(run *r, int to_terminal)
{
    real now = clock_seconds();
    if (!to_terminal || now - r->told < 0.2) return;
    r->told = now;
    real share = (real)r->done / (real)r->steps;
    fprintf(stderr, "\r%s: %5.1f %%, at %.2f s of %g s, %.0f s left\033[K",
            scene_name(r->set.scene), 100 * share, time_done(r),
            r->set.seconds, (now - r->began) * (1 - share) / share);
}

// A replay ends where its record does, and where they part.
static int is_on(const run *r)
{
    return r->done < r->steps && !r->lost && !stop_signal
        && (!r->replay.file || (r->replay.step >= 0 && !r->replay.parted));
}

static status run_steps(run *r)
{
    int to_terminal = isatty(STDERR_FILENO);
    measure_run(r);
    status done = look_at_run(r);
    while (done.ok && is_on(r)) {
        done = step_run(r);
        tell_progress(r, to_terminal);
    }
    if (to_terminal && r->told > r->began) fprintf(stderr, "\r\033[K");
    return done;
}

// ---- The closing table -----------------------------------------------------

static int compare_real(const void *a, const void *b)
{
    real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}

static void print_plural(int n, const char *word)
{
    printf("%d %s%s", n, word, n == 1 ? "" : "s");
}

static void print_way(const run *r)
{
    const system_options *o = &r->run.plain.options;
    if (r->run.kind == BY_ENGINE) {
        print_plural(r->run.world.options.substeps, "substep");
        printf(", ");
        print_plural(r->run.world.options.iterations, "iteration");
        printf("\n");
        return;
    }
    print_plural(o->substeps, "substep");
    printf(", ");
    print_plural(o->rounds, "round");
    printf(" of ");
    print_plural(r->set.scene == SCENE_ROOM ? o->rigid.iterations
                                            : o->soft.iterations, "iteration");
    printf(", the paper's system %s\n", runner_name(r->run.kind));
}

static void print_title(const run *r)
{
    printf("%s: ", scene_name(r->set.scene));
    if (r->set.scene == SCENE_ROOM)
        printf("%d bod%s%s%s", r->set.bodies, r->set.bodies == 1 ? "y" : "ies",
               r->set.mesh ? " of " : "", r->set.mesh ? r->set.mesh : "");
    else
        printf("a cloth of %d x %d", r->set.cloth, r->set.cloth);
    printf(", %.4g s in %ld steps of %.4g s, ", time_done(r), r->done,
           r->set.dt);
    print_way(r);
}

static void print_errors(const run *r)
{
    printf("error\n");
    printf("  largest strain       %10.3g      at %.3g s\n", r->strain.value,
           r->strain.time);
    printf("  largest penetration  %10.3g m    at %.3g s", r->penetration.value,
           r->penetration.time);
    if (r->set.scene == SCENE_ROOM)
        printf(", %.2g %% of a body's radius",
               100 * r->penetration.value / SCENE_BODY_RADIUS);
    printf("\n  kinetic energy       %10.3g J    at the end, most %.3g J at "
           "%.3g s\n", r->last.kinetic, r->kinetic.value, r->kinetic.time);
    printf("  momentum             %10.3g kg m/s at the end, "
           "most %.3g kg m/s\n",
           vec3_length(r->last.momentum), r->momentum.value);
    if (r->unconverged.value > 0)
        printf("  not converged        %10.0f contacts and bodies at most, at "
               "%.3g s\n", r->unconverged.value, r->unconverged.time);
    if (r->run.dropped > 0)
        printf("  without room         %10ld contacts in all\n", r->run.dropped);
    if (r->run.capped > 0)
        printf("  cut off              %10ld queries in all\n", r->run.capped);
}

static void print_times(run *r)
{
    static const char *const phase[PHASES] = {
        "find pairs", "find contacts", "prepare", "solve contacts",
        "cloth and rope", "move", "sleep"
    };
    if (r->done == 0) return;
    qsort(r->step_time, (size_t)r->done, sizeof *r->step_time, compare_real);
    real sum = 0;
    for (long i = 0; i < r->done; i++) sum += r->step_time[i];
    printf("time\n");
    printf("  a step, median       %10.3g ms   worst %.3g ms\n",
           1e3 * r->step_time[r->done / 2], 1e3 * r->step_time[r->done - 1]);
    for (int k = 0; k < PHASES && r->run.kind == BY_ENGINE; k++)
        printf("    %-18s %10.3g ms   %4.1f %%\n", phase[k],
               1e3 * r->phase_time[k] / (real)r->done,
               sum > 0 ? 100 * r->phase_time[k] / sum : 0);
    printf("  all steps            %10.3g s    with measuring and drawing "
           "%.3g s\n", sum, clock_seconds() - r->began);
}

static void print_frames(const frames *f)
{
    if (f->count > 0)
        printf("wrote %s/frame-00000%s and on: %ld frame%s\n", f->folder,
               f->ending, f->count, f->count == 1 ? "" : "s");
}

static void print_files(const run *r)
{
    if (r->set.film && r->strip.taken > 0)
        printf("wrote %s: %d picture%s\n", r->set.film, r->strip.taken,
               r->strip.taken == 1 ? "" : "s");
    print_frames(&r->pictures);
    print_frames(&r->meshes);
    if (r->set.csv)
        printf("wrote %s: %ld row%s\n", r->set.csv, r->done,
               r->done == 1 ? "" : "s");
    if (r->set.record) printf("wrote %s\n", r->set.record);
    if (r->replay.equal > 0)
        printf("%s: %ld hash%s equal, to step %ld\n", r->set.replay,
               r->replay.equal, r->replay.equal == 1 ? "" : "es",
               r->replay.equal_step);
}

// ---- The line of a sweep ----------------------------------------------------

static const char row_head[] =
    "steps,end,strain,penetration_m,kinetic_J,momentum_kg_m_s,unconverged,"
    "dropped,hash,time_s";

// Times stand last: all before them is the same in every run.
static void print_row(const run *r)
{
    real sum = 0;
    for (long i = 0; i < r->done; i++) sum += r->step_time[i];
    const char *end = r->lost ? "lost" : r->replay.parted ? "parted" : "done";
    printf("%d,%s,%ld,%s,%.9g,%.9g,%.9g,%.9g,%.0f,%ld,", r->set.row, r->cells,
           r->done, end, r->strain.value, r->penetration.value,
           r->last.kinetic, vec3_length(r->last.momentum),
           r->unconverged.value, r->run.dropped);
    if (!r->lost) printf("%016llx", runner_hash(&r->run));
    printf(",%.6g\n", sum);
}

// ---- The whole -------------------------------------------------------------

static int complain(status s, int code)
{
    fprintf(stderr, "tumble: %s\n", s.why);
    return code;
}

// Nobody has seen what the standard output did not take.
static int close_output(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return code;
    return complain(status_fail("cannot write to the standard output: %s",
                                strerror(errno)), EXIT_FAILURE);
}

// Puts the files in their places and prints the table.
static status run_finish(run *r)
{
    status done = status_ok();
    if (r->set.film) done = strip_write(&r->strip, r->set.film);
    if (done.ok && r->csv.file) done = output_commit(&r->csv);
    // Where numbers are lost there is nothing to compare.
    if (done.ok && !r->lost)
        done = record_look(&r->record, &r->run, r->done, 1);
    if (done.ok && r->record.file) done = output_commit(&r->record);
    if (!done.ok) return done;
    if (r->cells) {
        // A row that was stopped is run again.
        if (!stop_signal) print_row(r);
        return done;
    }
    print_title(r);
    print_errors(r);
    print_times(r);
    if (r->set.bits) printf("bits %016llx\n", runner_hash(&r->run));
    print_files(r);
    return done;
}

// Why a run that did not fail ended early, if it did; its exit status.
static int tell_end(const run *r)
{
    if (r->cells && !stop_signal) return EXIT_SUCCESS;
    if (r->lost) {
        fprintf(stderr, "tumble: the motion grew beyond all numbers in step "
                "%ld of %ld; a smaller --dt or more --substeps may hold it; "
                "what was finished is kept\n", r->done + 1, r->steps);
        return EXIT_FAILURE;
    }
    if (r->replay.parted) {
        fprintf(stderr, "tumble: the motion is not that of %s: the hashes part "
                "at step %ld", r->set.replay, r->replay.step);
        if (r->replay.equal > 0)
            fprintf(stderr, ", after step %ld", r->replay.equal_step);
        fprintf(stderr, "\n");
        return EXIT_FAILURE;
    }
    if (r->done == r->steps || (r->replay.file && r->replay.step < 0))
        return EXIT_SUCCESS;
    fprintf(stderr, "tumble: stopped after step %ld of %ld; what was finished "
            "is kept\n", r->done, r->steps);
    return EXIT_SIGNAL + stop_signal;
}

static int run_scene(const settings *set, const char *cells)
{
    run r = { .set = *set, .cells = cells };
    catch_signals(0);
    status done = check_names(set);
    if (done.ok && set->replay) done = replay_open(&r.replay, &r.set);
    if (done.ok) done = run_begin(&r);
    if (!done.ok && stop_signal)
        done = status_fail("stopped before the first step");
    catch_signals(SA_RESTART);
    if (done.ok) done = run_steps(&r);
    if (done.ok) done = run_finish(&r);
    int code = done.ok ? tell_end(&r)
             : complain(done, stop_signal ? EXIT_SIGNAL + stop_signal
                                          : EXIT_FAILURE);
    run_free(&r);
    return code;
}

// How a row ended stands in its line.
static int run_row(const settings *set)
{
    table t;
    settings row;
    char *words = NULL;
    status done = table_read(&t, set->sweep);
    if (done.ok && set->row > t.rows)
        done = status_fail("%.120s: has only %d rows", set->sweep, t.rows);
    if (done.ok) done = table_row(&t, set->row, &row, &words);
    int code = EXIT_FAILURE;
    if (done.ok) {
        row.row = set->row;
        code = run_scene(&row, t.row[set->row]);
    } else complain(done, code);
    free(words);
    table_free(&t);
    return code;
}

int main(int arguments, char **argument)
{
    settings set;
    const example *e = arguments > 1 ? play_find(argument[1]) : NULL;
    if (e) return close_output(play(e, arguments - 2, argument + 2));
    status done = settings_read(&set, arguments, argument);
    if (!done.ok) return complain(done, EXIT_WRONG_USE);
    int code = EXIT_SUCCESS;
    if (set.help) settings_print_help(stdout);
    else if (set.list) {
        settings_print_list(stdout);
        printf("\nscenes of figures/scenes, with --seconds S and --film FILE:\n");
        play_list();
    }
    else if (set.version)
        printf("tumble %s (%s, %s)\n", TUMBLE_VERSION, __VERSION__, FLAGS);
    else if (set.row > 0) code = run_row(&set);
    else if (set.sweep)
        code = complain(sweep_begin(&set, argument[0], row_head), EXIT_FAILURE);
    else code = run_scene(&set, NULL);
    return close_output(code);
}
