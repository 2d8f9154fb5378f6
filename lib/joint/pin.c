//> pin-meet
//>   One exact impulse brings the particle to its place on the body, as a ball
//>   joint would.
#include "pin.h"

static particle *particle_of(const soft_frame *f, const joint *j)
{
    return &f->particle[f->body[j->a].first + j->particle];
}

static bool pin_holds(const soft_frame *f, const joint *j)
{
    return j->kind == JOINT_PIN && !j->is_broken && is_moving_soft(f, j->a);
}

// The place on the body that a pin means.
typedef struct {
    vec3 at, arm;       // m, in the world; from the centre
    vec3 column[TURNS]; // kg^(-1/2), how it goes when the body turns
    real inverse_mass;  // 1/kg, of the body
} pin_place;

static pin_place place_of(const soft_frame *f, const joint *j)
{
    pin_place x = { .at = j->local_b };
    if (j->b < 0) return x;
    const solver_body *now = &f->now[j->b];
    rigid_frame at = now->frame;
    if (now->basis.inverse_mass > 0)
        at = motion_frame(&at, &now->basis, &f->moved[j->b]);
    x.at = frame_point(&at, j->local_b);
    x.arm = vec3_sub(x.at, at.center);
    x.inverse_mass = now->basis.inverse_mass;
    for (int t = 0; t < TURNS; t++)
        x.column[t] = vec3_cross(now->basis.turn[t], x.arm);
    return x;
}

// An impulse of 1 / h closes what a push of 1 kg m closes: both ways at once.
static void push_pinned(const soft_frame *f, joint *j, const pin_place *x,
                        vec3 push)
{
    particle *p = particle_of(f, j);
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    if (x->inverse_mass > 0) {
        const motion_basis *basis = &f->now[j->b].basis;
        motion_push(&f->moved[j->b], basis, x->arm, vec3_scale(-1, push));
        motion_push(&f->velocity[j->b], basis, x->arm,
                    vec3_scale(-1 / f->h, push));
    }
    j->impulse[0] += push.x / f->h;
    j->impulse[1] += push.y / f->h;
    j->impulse[2] += push.z / f->h;
}

// A ball joint of a body and a particle.
static void meet_pin(const soft_frame *f, joint *j)
{
    const particle *p = particle_of(f, j);
    pin_place x = place_of(f, j);
    vec3 gap = vec3_sub(x.at, p->position);
    real k[JOINT_ROWS][JOINT_ROWS] = { { 0 } };
    real push[JOINT_ROWS] = { gap.x, gap.y, gap.z };
    for (int i = 0; i < 3; i++) k[i][i] = p->inverse_mass + x.inverse_mass;
    for (int t = 0; t < TURNS; t++) {
        const real c[3] = { x.column[t].x, x.column[t].y, x.column[t].z };
        for (int i = 0; i < 3; i++)
            for (int l = 0; l < 3; l++) k[i][l] += c[i] * c[l];
    }
    small_invert(3, k);
    small_times(3, k, push);
    push_pinned(f, j, &x, vec3_make(push[0], push[1], push[2]));
}
//<

//> pin-weigh
//>   While strands are solved the particle gets the inverse mass of both
//>   together; afterwards it gets its own again, and the body its share of the
//>   impulse.
// Together a particle and a body are as hard to move as the sum of what they
// weigh.  A point of a body weighs least along some direction; at least so much
// it weighs along all.  What cannot be moved is taken for a million particles.
static const real LIGHTEST = 1e-6;          // tuned, 1

static real inverse_of_both(const soft_frame *f, const joint *j, real own)
{
    pin_place x = place_of(f, j);
    real most = x.inverse_mass;
    for (int t = 0; t < TURNS; t++)
        most += vec3_length_squared(x.column[t]);
    real both = own * most / (own + most);
    return real_max(both, LIGHTEST * own);
}

void pins_begin(linkage *l, const soft_frame *f)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        if (!pin_holds(f, j)) continue;
        particle *p = particle_of(f, j);
        for (int i = 0; i < 3; i++) j->impulse[i] = 0;
        meet_pin(f, j);
        j->own = p->inverse_mass;
        j->start = p->position;
        if (j->own > 0) p->inverse_mass = inverse_of_both(f, j, j->own);
    }
}

// The pull that moved the heavy particle by so much would have moved it alone
// by more.
void pins_end(linkage *l, const soft_frame *f)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        if (!pin_holds(f, j)) continue;
        particle *p = particle_of(f, j);
        vec3 delta = vec3_sub(p->position, j->start);
        if (j->own > 0)
            delta = vec3_scale(j->own / p->inverse_mass, delta);
        p->position = vec3_add(j->start, delta);
        p->inverse_mass = j->own;
        meet_pin(f, j);
        j->force = vec3_length(vec3_make(j->impulse[0], j->impulse[1],
                                         j->impulse[2])) / f->h;
        // So fast do the particles of a strand swing that such a pull tightens.
        real spacing = f->body[j->a].shape->spacing;
        real swing = sqrt(j->force * j->own / spacing);
        l->rows[k].pace = real_max(l->rows[k].pace, swing);
        if (!(j->force > j->strength)) continue;
        j->is_broken = true;
        l->broken++;
    }
}
//<
