// race_tumble.c - the scenes in this library: with tumble.h, and nothing else of
// it.

#include "race.h"
#include "tumble.h"

#include <stdlib.h>

typedef struct {
    tumble_world *world;
    tumble_body  *body, cloth;      // [bodies]
} room;

static tumble_vec3 out(vec3 v)
{
    return tumble_v(v.x, v.y, v.z);
}

static tumble_shape add_form(tumble_world *w, const body_form *f)
{
    switch (f->kind) {
    case FORM_BOX:
        return tumble_shape_box(w, out(vec3_scale(2, f->half)), f->mass);
    case FORM_ICOSAHEDRON:
        return tumble_shape_icosahedron(w, f->radius, f->mass);
    case FORM_BALL:
        break;
    }
    return tumble_shape_sphere(w, f->radius, f->mass);
}

static tumble_body add_body(tumble_world *w, tumble_shape shape,
                            const body_start *s, bool is_fixed)
{
    const pose *p = &s->at;
    tumble_body_options o = tumble_body_at(p->middle.x, p->middle.y,
                                           p->middle.z);
    o.pose.rotation = tumble_quat_from_matrix((double[9]){
        p->x.x, p->y.x, p->z.x, p->x.y, p->y.y, p->z.y, p->x.z, p->y.z, p->z.z });
    o.velocity = out(s->velocity);
    o.spin = out(s->spin);
    if (is_fixed) o.kind = TUMBLE_STATIC;
    return tumble_body_add(w, shape, o);
}

static void add_sheet(room *r, const cloth_sheet *c)
{
    tumble_shape s = tumble_shape_cloth(r->world, c->side, c->side, c->width,
                                        c->width, c->mass);
    r->cloth = tumble_body_add(r->world, s,
                               tumble_body_at(c->middle.x, c->middle.y,
                                              c->middle.z));
    for (int k = 0; k < c->pins; k++)
        tumble_body_pin(r->world, r->cloth, sheet_corner(c, k));
}

static void *begin(const scene *s, int setting, bool may_sleep)
{
    room *r = calloc(1, sizeof *r);
    if (r) r->body = calloc((size_t)s->bodies + 1, sizeof *r->body);
    if (!r || !r->body) give_up("there is no memory for a world");
    tumble_shape shape[FORMS];
    tumble_options o = tumble_options_default();
    o.dt = s->dt;
    o.friction = s->friction;
    if (setting) o.substeps = o.most_substeps = setting;
    if (!may_sleep) o.sleep_speed = 0;
    tumble_world *w = r->world = tumble_world_make(&o);
    if (!w) give_up(tumble_world_failure(NULL));
    for (int k = 0; k < s->walls; k++)
        tumble_plane_add(w, out(s->normal[k]), s->offset[k], -1);
    for (int k = 0; k < s->forms; k++) shape[k] = add_form(w, &s->form[k]);
    for (int k = 0; k < s->bodies; k++)
        r->body[k] = add_body(w, shape[s->body[k].form], &s->body[k], k < s->fixed);
    for (int k = 0; k < s->joints; k++) {
        const ball_joint *j = &s->joint[k];
        tumble_joint_ball(w, j->b < 0 ? tumble_body_ground() : r->body[j->b],
                          r->body[j->a], out(j->at));
    }
    if (s->sheet.side) add_sheet(r, &s->sheet);
    if (tumble_world_failure(w)) give_up(tumble_world_failure(w));
    return r;
}

static void step(void *self)
{
    tumble_world_step(((room *)self)->world);
}

static pose look(const void *self, int body)
{
    const room *r = self;
    tumble_pose p = tumble_body_pose(r->world, r->body[body]);
    double m[9];
    tumble_quat_matrix(p.rotation, m);
    return (pose){ vec3_make(p.position.x, p.position.y, p.position.z),
                   vec3_make(m[0], m[3], m[6]), vec3_make(m[1], m[4], m[7]),
                   vec3_make(m[2], m[5], m[8]) };
}

static void vertices(const void *self, vec3 *at)
{
    const room *r = self;
    int n = tumble_body_vertices(r->world, r->cloth, NULL, 0);
    for (int k = 0; k < n; k++) {
        tumble_vec3 v = tumble_body_vertex(r->world, r->cloth, k);
        at[k] = vec3_make(v.x, v.y, v.z);
    }
}

static int asleep(const void *self)
{
    const room *r = self;
    return tumble_world_last_step(r->world).asleep;
}

static void end(void *self)
{
    room *r = self;
    tumble_world_free(r->world);
    free(r->body);
    free(r);
}

const mover tumble_mover = { begin, step, look, vertices, asleep, end };
