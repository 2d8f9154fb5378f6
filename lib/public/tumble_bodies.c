//> face-add
//>   A body can have several convex pieces, and each of them is a body of the
//>   engine. If one cannot be added, those before it are removed again, so that
//>   a body is there whole or not at all.
#include "handle.h"
#include "inside.h"
#include "weight.h"

#include <limits.h>
#include <stdlib.h>

tumble_body_options tumble_body_at(double x, double y, double z)
{
    return (tumble_body_options){
        .kind = TUMBLE_DYNAMIC, .pose = { { x, y, z }, { 0, 0, 0, 1 } },
        .friction = -1, .restitution = -1,
        .group = 1, .mask = UINT_MAX };
}

void inside_place(placement *p, tumble_pose pose)
{
    real m[9];
    tumble_quat_matrix(pose.rotation, m);
    p->position = from_user(pose.position);
    p->x = (vec3){ m[0], m[3], m[6] };
    p->y = (vec3){ m[1], m[4], m[7] };
    p->z = (vec3){ m[2], m[5], m[8] };
}

static placement placement_of(tumble_pose pose, const tumble_body_options *o)
{
    placement p = { .velocity = from_user(o->velocity),
                    .spin = from_user(o->spin),
                    .is_static = o->kind == TUMBLE_STATIC };
    inside_place(&p, pose);
    return p;
}

// What a new piece has beside its place.
static bool set_up(tumble_world *w, int number, const tumble_body_options *o)
{
    material m = { o->friction, o->restitution };
    if (o->kind == TUMBLE_KINEMATIC) {
        world_set_kind(&w->world, number, BODY_KINEMATIC);
        world_set_velocity(&w->world, number, from_user(o->velocity),
                           from_user(o->spin));
    }
    world_set_filter(&w->world, number, o->group, o->mask);
    return inside_is_ok(w, world_set_material(&w->world, number, m))
        && inside_is_ok(w, world_set_damping(&w->world, number, o->damping,
                                             o->spin_damping));
}

static bool add_piece(tumble_world *w, int place, tumble_shape s,
                      tumble_pose pose, const tumble_body_options *o)
{
    shape_place *made_of = inside_shape(w, s);
    body_place *x = slots_at(&w->bodies, place);
    int number;
    if (!made_of || !inside_reserve_owner(w)) return false;
    if (made_of->shape->kind != SHAPE_RIGID && o->kind == TUMBLE_KINEMATIC)
        return inside_fail(w, "a rope or a cloth cannot be kinematic: pin it");
    bool rides = x->is_whole && x->pieces > 0;
    status done = rides
        ? world_add_piece(&w->world, made_of->shape, x->piece[0].number, &number)
        : world_add(&w->world, made_of->shape, placement_of(pose, o), &number);
    if (!inside_is_ok(w, done)) return false;
    w->owner[number] = place;
    world_set_family(&w->world, number, place + 1);
    x->piece[x->pieces++] = (body_piece){ number, (int)s.place };
    made_of->bodies++;
    return set_up(w, number, o);
}

static bool check_body_options(tumble_world *w, const tumble_body_options *o)
{
    if (!inside_is_world(w) || !inside_is_group(w, o->group)) return false;
    if ((unsigned)o->kind > TUMBLE_KINEMATIC)
        return inside_fail(w, "%d is no kind of body", (int)o->kind);
    return inside_is_speed(w, o->velocity) && inside_is_speed(w, o->spin);
}

static void forget_mesh(tumble_world *w, int place)
{
    body_place *x = slots_at(&w->bodies, place);
    int *k = &w->first_mesh;
    while (*k != place + 1) {
        body_place *y = slots_at(&w->bodies, *k - 1);
        k = &y->mesh->next;
    }
    *k = x->mesh->next;
    inside_free_mesh(x->mesh);
}

static void take_away(tumble_world *w, int place)
{
    body_place *x = slots_at(&w->bodies, place);
    for (int k = x->pieces - 1; k >= 0; k--) {
        shape_place *s = slots_at(&w->shapes, x->piece[k].shape);
        world_remove(&w->world, x->piece[k].number);
        s->bodies--;
        if (x->mesh || x->is_whole) inside_drop(w, x->piece[k].shape);
    }
    if (x->mesh) forget_mesh(w, place);
    free(x->piece);
    slots_give(&w->bodies, place);
    inside_forget_joints(w);
}

// A place for a body of n pieces; -1, with a failure, where memory is refused.
static int take_body_place(tumble_world *w, int n, const tumble_body_options *o)
{
    body_piece *piece = malloc((size_t)n * sizeof *piece);
    int place = piece ? slots_take(&w->bodies) : -1;
    if (place < 0) {
        free(piece);
        inside_is_ok(w, status_out_of_memory());
        return -1;
    }
    body_place *x = slots_at(&w->bodies, place);
    *x = (body_place){ .piece = piece, .kind = o->kind, .user = o->user };
    return place;
}

// What all pieces weigh together.
static bool weigh_pieces(tumble_world *w, const tumble_shape *s,
                         const tumble_pose *pose, int n, struct weight *whole)
{
    *whole = (struct weight){ .mass = 0 };
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < n; k++) {
            placement at = { .is_static = true };
            const shape_place *x = inside_shape(w, s[k]);
            inside_place(&at, pose[k]);
            if (!x) return false;
            if (x->shape->kind != SHAPE_RIGID)
                return inside_fail(w, "piece %d is a rope or a cloth", k);
            if (!inside_is_ok(w, placement_check(&at, x->shape, k))) return false;
            if (pass == 0) weight_add(whole, x->shape, &at);
            else           weight_reach(whole, x->shape, &at);
        }
        if (pass == 0) weight_mean(whole);
    }
    return true;
}

// One more piece, which the body has as a shape of its own.
static bool add_own_piece(tumble_world *w, int place, tumble_shape s,
                          tumble_pose pose, const struct weight *whole,
                          const tumble_body_options *o)
{
    shape made;
    placement at = { .is_static = true };
    inside_place(&at, pose);
    status done = weight_piece(&made, inside_shape(w, s)->shape, &at, whole);
    tumble_shape own = inside_keep(w, &made, done);
    if (own.generation == 0) return false;
    const body_place *x = slots_at(&w->bodies, place);
    int before = x->pieces;
    if (add_piece(w, place, own, o->pose, o)) return true;
    if (x->pieces == before) inside_drop(w, (int)own.place);
    return false;
}

// whole: what the pieces weigh together, if they move as one; or NULL.
static tumble_body add_body_of(tumble_world *w, const tumble_shape *s,
                               const tumble_pose *pose, int n, struct weight *whole,
                               const tumble_body_options *o)
{
    const tumble_body none = { 0, 0 };
    int place = take_body_place(w, n, o);
    if (place < 0) return none;
    ((body_place *)slots_at(&w->bodies, place))->is_whole = whole;
    for (int k = 0; k < n; k++) {
        if (k == 1 && whole) whole->reach = 0;
        if (whole ? add_own_piece(w, place, s[k], pose[k], whole, o)
                  : add_piece(w, place, s[k], pose[k], o)) continue;
        take_away(w, place);
        return none;
    }
    return inside_body_in(w, place);
}

tumble_body tumble_body_add(tumble_world *w, tumble_shape s,
                            tumble_body_options o)
{
    if (!check_body_options(w, &o)) return (tumble_body){ 0, 0 };
    return add_body_of(w, &s, &o.pose, 1, NULL, &o);
}

static bool are_pieces(tumble_world *w, const tumble_shape *piece,
                       const tumble_pose *pose, int n)
{
    return inside_is_list(w, piece, n, "pieces")
        && inside_is_list(w, pose, n, "poses")
        && (n > 0 || inside_fail(w, "a body of %d pieces: it has at least one", n));
}

tumble_body tumble_body_add_pieces(tumble_world *w, const tumble_shape *piece,
                                   const tumble_pose *pose, int n,
                                   tumble_body_options o)
{
    o.kind = TUMBLE_STATIC;
    if (!are_pieces(w, piece, pose, n) || !check_body_options(w, &o))
        return (tumble_body){ 0, 0 };
    return add_body_of(w, piece, pose, n, NULL, &o);
}

tumble_body tumble_body_add_compound(tumble_world *w, const tumble_shape *piece,
                                     const tumble_pose *pose, int n,
                                     tumble_body_options o)
{
    const tumble_body none = { 0, 0 };
    struct weight whole;
    if (!check_body_options(w, &o) || !are_pieces(w, piece, pose, n)) return none;
    if (o.kind != TUMBLE_DYNAMIC)
        return inside_fail(w, "a body whose pieces move as one is dynamic"), none;
    if (!weigh_pieces(w, piece, pose, n, &whole)) return none;
    return add_body_of(w, piece, pose, n, &whole, &o);
}

bool tumble_body_remove(tumble_world *w, tumble_body b)
{
    if (!inside_body(w, b)) return false;
    take_away(w, (int)b.place);
    return true;
}

bool tumble_body_exists(const tumble_world *w, tumble_body b)
{
    return inside_body_of(w, b) != NULL;
}

int tumble_world_bodies(const tumble_world *w, tumble_body *out, int most)
{
    int n = 0;
    for (int k = 0; w && k < w->bodies.count; k++) {
        if (!slots_is_taken(&w->bodies, k)) continue;
        if (out && n < most) out[n] = inside_body_in(w, k);
        n++;
    }
    return n;
}
//<
