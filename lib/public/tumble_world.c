//> face-world-make
//>   A world is made of options, and given back.
#include "handle.h"
#include "inside.h"
#include "measure.h"

#include <stdalign.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// A world comes from calloc, whose memory is aligned for these types only.
_Static_assert(alignof(tumble_world) <= alignof(max_align_t),
               "a world must not need more than calloc gives");

// Of worlds that could not be made.
static _Thread_local status unmade = { .ok = true };

void inside_not_made(status s)
{
    if (unmade.ok) unmade = s;
}

static tumble_options options_to(const world_options *o)
{
    return (tumble_options){
        .dt = o->dt, .substeps = o->substeps,
        .most_substeps = o->most_substeps,
        .gravity = to_user(o->gravity), .friction = o->friction,
        .restitution = o->restitution, .sleep_speed = o->sleep_speed,
        .time_to_sleep = o->time_to_sleep, .certified = o->certified,
        .run = o->host.run.run, .context = o->host.run.context };
}

tumble_options tumble_options_default(void)
{
    world_options o = world_options_default();
    return options_to(&o);
}

static world_options world_options_of(const tumble_options *o)
{
    world_options how = world_options_default();
    if (!o) return how;
    how.dt = o->dt;
    how.substeps = o->substeps;
    how.most_substeps = o->most_substeps;
    how.gravity = from_user(o->gravity);
    how.friction = o->friction;
    how.certified = o->certified;
    how.restitution = o->restitution;
    how.sleep_speed = o->sleep_speed;
    how.time_to_sleep = o->time_to_sleep;
    how.host.run = (tasks){ o->run, o->context };
    return how;
}

tumble_world *tumble_world_make(const tumble_options *options)
{
    tumble_world *w = calloc(1, sizeof *w);
    unmade = status_ok();
    bool is_there = w && inside_reserve(w, 1);
    unmade = is_there ? world_init(&w->world, world_options_of(options))
                      : status_out_of_memory();
    if (!unmade.ok) {
        if (w) free(w->scratch);
        free(w);
        return NULL;
    }
    slots_init(&w->shapes, sizeof(shape_place));
    slots_init(&w->bodies, sizeof(body_place));
    slots_init(&w->joints, sizeof(int));
    slots_init(&w->planes, sizeof(int));
    w->failure = status_ok();
    return w;
}

void inside_free(tumble_world *w)
{
    world_free(&w->world);
    for (int k = 0; k < w->bodies.count; k++) {
        body_place *b = slots_at(&w->bodies, k);
        if (!b) continue;
        free(b->piece);
        inside_free_mesh(b->mesh);
    }
    for (int k = 0; k < w->shapes.count; k++) {
        shape_place *s = slots_at(&w->shapes, k);
        if (!s || !s->shape) continue;
        shape_free(s->shape);
        free(s->shape);
    }
    slots_free(&w->shapes);
    slots_free(&w->bodies);
    slots_free(&w->joints);
    slots_free(&w->planes);
    free(w->owner);
    free(w->scratch);
    free(w->touching);
    free(w->sensed);
    store_free(&w->spare);
}

void tumble_world_free(tumble_world *w)
{
    if (w) inside_free(w);
    free(w);
}

const char *tumble_world_failure(const tumble_world *w)
{
    const status *s = w ? &w->failure : &unmade;
    return s->ok ? NULL : s->why;
}

void tumble_world_forget_failure(tumble_world *w)
{
    if (w) w->failure = status_ok();
    else unmade = status_ok();
}
//<

//> face-world-step
//>   A step, what may be asked of a whole world, and planes: one that is
//>   removed takes its contacts with it.
void tumble_world_run_on(tumble_world *w,
                         void (*run)(void *context, void (*work)(void *, int),
                                     void *data, int items), void *context)
{
    if (inside_is_world(w)) w->world.options.host.run = (tasks){ run, context };
}

void tumble_world_step(tumble_world *w)
{
    if (!inside_is_world(w)) return;
    double time = w->world.time;
    world_step(&w->world);
    if (w->world.report.lost > 0)
        inside_fail(w, "in the step from %g s %d bodies were so fast that their "
                    "numbers were lost, and they were stopped: it needs more "
                    "substeps", time, w->world.report.lost);
    if (w->world.report.cut > 0)
        inside_fail(w, "the step from %g s was divided for what moves fast in "
                    "it, and has no more than %d substeps in all: its parts "
                    "had fewer than the options say", time, ALL_SUBSTEPS);
    if (w->world.report.broken > 0) inside_forget_joints(w);
}

tumble_options tumble_world_get_options(const tumble_world *w)
{
    return w ? options_to(&w->world.options) : tumble_options_default();
}

double tumble_world_time(const tumble_world *w)
{
    return w ? w->world.time : 0;
}

static bool add_plane(tumble_world *w, vec3 normal, double offset,
                      double friction, int place)
{
    world *all = &w->world;
    int k = world_next_plane(all);
    if (place < 0) return inside_is_ok(w, status_out_of_memory());
    if (!(friction < HUGE_VAL))
        return inside_fail(w, "a plane's friction is %g: it is not finite",
                           friction);
    if (!inside_is_ok(w, world_add_plane(all, normal, offset))) return false;
    *(int *)slots_at(&w->planes, place) = k;
    material m = { friction, -1 };
    if (inside_is_ok(w, world_set_plane_material(all, k, m))) return true;
    world_remove_plane(all, k);
    return false;
}

tumble_plane tumble_plane_add(tumble_world *w, tumble_vec3 normal,
                              double offset, double friction)
{
    if (!inside_is_world(w)) return (tumble_plane){ 0, 0 };
    int k = slots_take(&w->planes);
    if (add_plane(w, from_user(normal), offset, friction, k))
        return (tumble_plane){ (unsigned)k, slots_generation(&w->planes, k) };
    if (k >= 0) slots_give(&w->planes, k);
    return (tumble_plane){ 0, 0 };
}

bool tumble_plane_remove(tumble_world *w, tumble_plane p)
{
    if (!inside_is_world(w)) return false;
    const int *x = inside_find(w, &w->planes, "plane", p.place, p.generation);
    if (!x) return false;
    world_remove_plane(&w->world, *x);
    slots_give(&w->planes, (int)p.place);
    return true;
}

bool tumble_world_set_gravity(tumble_world *w, tumble_vec3 gravity)
{
    if (!inside_is_world(w)) return false;
    if (!vec3_is_finite(from_user(gravity)))
        return inside_fail(w, "gravity is not finite");
    world_set_gravity(&w->world, from_user(gravity));
    return true;
}

tumble_report tumble_world_last_step(const tumble_world *w)
{
    if (!w) return (tumble_report){ .substeps = 0 };
    const step_report *r = &w->world.report;
    return (tumble_report){
        .substeps = r->substeps, .bodies = tumble_world_bodies(w, NULL, 0),
        .asleep = r->asleep, .pairs = r->pairs, .contacts = r->contacts,
        .unconverged = r->unconverged, .prevented = r->prevented,
        .crossed = r->crossed, .dropped = r->dropped,
        .broken = r->broken };
}

tumble_measures tumble_world_measure(const tumble_world *w)
{
    if (!w) return (tumble_measures){ .penetration = 0 };
    measures m = world_measure(&w->world);
    return (tumble_measures){
        .penetration = m.penetration, .strain = m.strain,
        .kinetic = m.kinetic, .potential = m.potential,
        .momentum = to_user(m.momentum), .angular = to_user(m.angular) };
}

unsigned long long tumble_world_hash(const tumble_world *w)
{
    return w ? world_hash(&w->world) : 0;
}
//<
