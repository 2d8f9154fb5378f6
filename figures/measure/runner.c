// runner.c - a scene, and the system that moves it.

#include "runner.h"
#include "step.h"

#include <stdlib.h>

const char *runner_name(runner_kind kind)
{
    static const char *const name[RUNNERS] = {
        "engine", "as mended", "as printed"
    };
    return name[kind];
}

system_options runner_options(runner_kind kind)
{
    return kind == AS_PRINTED ? system_options_printed()
                              : system_options_mended();
}

// Where the vertices are now, and were a substep ago.
static void look(runner *r)
{
    if (r->kind != BY_ENGINE) {
        for (int i = 0; i < r->particles; i++) {
            r->at[i] = r->plain.pool.at[i].position;
            r->before[i] = r->plain.pool.at[i].previous;
        }
        return;
    }
    int first = 0;
    for (int b = 0; b < r->world.bodies; b++) {
        world_vertices(&r->world, &r->world.body[b], r->at + first);
        first += scene_shape(&r->scene, b)->particles;
    }
}

static status make_room(runner *r)
{
    for (int b = 0; b < r->scene.bodies; b++)
        r->particles += scene_shape(&r->scene, b)->particles;
    size_t n = (size_t)r->particles + 1;
    r->at = calloc(n, sizeof *r->at);
    r->before = calloc(n, sizeof *r->before);
    if (!r->at || !r->before) return status_out_of_memory();
    look(r);
    return status_ok();
}

static status finish(runner *r, status done)
{
    if (done.ok) done = make_room(r);
    if (!done.ok) runner_free(r);
    return done;
}

status runner_begin_world(runner *r, scene_kind which, scene_options what,
                          world_options how)
{
    *r = (runner){ .kind = BY_ENGINE, .scene_kind = which };
    status done = scene_build(&r->scene, which, what);
    if (done.ok) done = world_of_scene(&r->world, &r->scene, how);
    return finish(r, done);
}

status runner_begin_system(runner *r, runner_kind kind, scene_kind which,
                           scene_options what, system_options how)
{
    *r = (runner){ .kind = kind, .scene_kind = which };
    if (kind == AS_PRINTED) what.diagonal = 1;
    status done = scene_build(&r->scene, which, what);
    if (done.ok) done = system_init(&r->plain, &r->scene, how);
    return finish(r, done);
}

status runner_begin(runner *r, runner_kind kind, scene_kind which,
                    scene_options what)
{
    if (kind == BY_ENGINE)
        return runner_begin_world(r, which, what,
                                  world_scene_options(which, what.cloth));
    return runner_begin_system(r, kind, which, what, runner_options(kind));
}

status runner_begin_scene(runner *r, runner_kind kind, scene *taken)
{
    *r = (runner){ .kind = kind, .scene_kind = SCENES, .scene = *taken };
    scene_init(taken);
    status done = kind == BY_ENGINE
        ? world_of_scene(&r->world, &r->scene, world_options_default())
        : system_init(&r->plain, &r->scene, runner_options(kind));
    return finish(r, done);
}

void runner_free(runner *r)
{
    world_free(&r->world);
    system_free(&r->plain);
    scene_free(&r->scene);
    free(r->at);
    free(r->before);
    *r = (runner){ .particles = 0 };
}

void runner_step(runner *r)
{
    if (r->kind == BY_ENGINE) {
        world_step(&r->world);
        const step_report *report = &r->world.report;
        r->time = r->world.time;
        r->relaxed = report->relaxed;
        r->tested = report->tested;
        r->contacts = report->contacts + report->touching;
        r->unconverged = report->unconverged;
        r->dropped += report->dropped;
    } else {
        system_report report = system_step(&r->plain);
        r->time += r->plain.options.dt;
        r->relaxed = report.relaxed;
        r->tested = report.tested;
        r->contacts = report.contacts;
        r->unconverged = report.unconverged;
        r->lost = report.lost;
        r->dropped += report.dropped;
        r->capped += report.capped;
    }
    look(r);
}

measures runner_measure(runner *r)
{
    if (r->kind == BY_ENGINE) return world_measure(&r->world);
    const system_options *o = &r->plain.options;
    real h = o->dt / o->substeps;
    poses p = runner_poses(r);
    measures m = { .strain = p.strain, .strain_rms = p.strain_rms,
                   .shear = p.shear };
    m.penetration = real_max(p.inside, real_max(p.overlap, p.behind));
    m.kinetic = poses_kinetic(&r->scene, r->before, r->at, h);
    for (int i = 0; i < r->particles; i++) {
        real w = r->plain.pool.at[i].inverse_mass;
        vec3 step = vec3_sub(r->at[i], r->before[i]);
        if (w > 0)
            m.momentum = vec3_add_scaled(m.momentum, 1 / (w * h), step);
    }
    return m;
}

poses runner_poses(const runner *r)
{
    return poses_measure(&r->scene, r->at);
}

vec3 runner_middle(const runner *r, int b)
{
    const vec3 *at = r->at;
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < b; k++) at += scene_shape(&r->scene, k)->particles;
    int n = scene_shape(&r->scene, b)->particles;
    for (int i = 0; i < n; i++) sum = vec3_add_scaled(sum, 1.0 / n, at[i]);
    return sum;
}

unsigned long long runner_hash(const runner *r)
{
    if (r->kind == BY_ENGINE) return world_hash(&r->world);
    unsigned long long hash = 0xcbf29ce484222325ULL;
    const unsigned char *byte = (const unsigned char *)r->at;
    for (size_t k = 0; k < (size_t)r->particles * sizeof *r->at; k++)
        hash = (hash ^ byte[k]) * 0x100000001b3ULL;
    return hash;
}
