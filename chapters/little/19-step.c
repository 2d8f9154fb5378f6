//> little_gravity_pulls 13c
// --- A step ------------------------------------------------------------------

static void bodies_fall(real h)
{
    for (body *b = bodies; b < bodies + body_count; b++)
        if (body_is_awake(b))
            b->velocity = vec3_add_scaled(b->velocity, h, gravity);
}

static void bodies_move(real h)
{
    for (body *b = bodies; b < bodies + body_count; b++)
        if (body_is_awake(b)) body_move(b, h);
}
//<

//> little_step_rounds 13c 13e
static void step(real dt)
{
    contacts_find(dt);
    bodies_fall(dt);
    for (int i = 0; i < contact_count; i++) contact_renew(&contacts[i]);
//<
//> little_step_rounds_warm 13e 13e
    for (int i = 0; i < contact_count; i++) contact_warm(&contacts[i]);
//<
//> little_step_rounds_end 13c 13e
    for (int round = 0; round < 10; round++)
        for (int i = 0; i < contact_count; i++) {
            contact *c = &contacts[i];
            contact_press(c, dt);
            for (int k = 0; k < c->count; k++) point_rub(c, &c->point[k]);
        }
    bodies_move(dt);
}
//<

//> little_active 13f
static contact *active[CONTACTS];       // those that something awake has
static int      active_count;

static void contacts_begin(void)
{
    active_count = 0;
    for (contact *c = contacts; c < contacts + contact_count; c++) {
        bool asleep = !body_is_awake(c->a) && !body_is_awake(c->b);
        if (c->count == 0 || asleep) continue;
        active[active_count++] = c;
        contact_renew(c);
//<
//> little_active_closing 15c
        for (contact_point *p = c->point; p < c->point + c->count; p++) {
            p->closing = vec3_dot(point_velocity(c, p), c->normal);
            p->was_pushed = false;
        }
//<
//> little_active_end 13f
    }
}

// Before the move as springs.  After it hard, without what the springs have
// added, and with friction.
static void contacts_press(real h, bool moved)
{
    softness hard = { 0, 1, 0 };
    softness soft = soft_spring(h, 1), stiffer = soft_spring(h, 2);
    for (int i = 0; i < active_count; i++) {
        contact *c = active[i];
        bool both = c->a->inverse_mass > 0 && c->b->inverse_mass > 0;
        contact_renew(c);
        contact_press(c, h, moved ? hard : both ? soft : stiffer);
        for (int k = 0; k < c->count && moved; k++) point_rub(c, &c->point[k]);
    }
}

static void substep(real h)
{
    bodies_fall(h);
//<
//> little_substep_joints_warm 17a 17a
    joints_warm();
//<
//> little_substep_warm 13f
    for (int i = 0; i < active_count; i++) contact_warm(active[i]);
    contacts_press(h, false);
//<
//> little_substep_joints 17a
    joints_hold(1 / h);
//<
//> little_substep_move 13f
    bodies_move(h);
//<
//> little_substep_joints_renew 17a
    joints_renew();
//<
//> little_substep_relax 13f
    contacts_press(h, true);
//<
//> little_substep_joints_relax 17a
    joints_hold(0);
//<
//> little_substep_soft 16a
    soft_move(h);
//<
//> little_substep_end 13f
}
//<

//> little_step_one 13f 13f
static void step(real dt)
{
    contacts_find(dt);
    contacts_begin();
    substep(dt);
}
//<

//> little_contacts_bounce 15c
// What closed fast and was pushed opens again, with a share of its speed.
static void contacts_bounce(void)
{
    for (int i = 0; i < active_count; i++) {
        contact *c = active[i];
        for (contact_point *p = c->point; p < c->point + c->count; p++) {
            if (p->closing > -0.5 || !p->was_pushed) continue;
            real lack = vec3_dot(point_velocity(c, p), c->normal);
            lack += c->restitution * p->closing;
            if (c->restitution > 0)
                point_push_to(c, p, real_max(0, p->push - p->mass * lack));
        }
    }
}
//<

//> little_substep_count 13g
static int substeps = 4;        // of half a step
//<

//> little_wanted 18b
// By how much the deepest spring of a contact sags, as a share of the smaller
// body: under the push that it has, or under the weight of the heavier body.
static real contact_sag(const contact *c, real h)
{
    real heavy = real_min(c->a->inverse_mass, c->b->inverse_mass), sag = 0;
    for (const contact_point *p = c->point; p < c->point + c->count; p++) {
        real per_push = 1.62 * h / p->mass;     // 1 / (m omega^2 h)
        real weight = heavy > 0 ? 9.81 * h / heavy : 0;
        sag = real_max(sag, real_min(per_push * p->push, -p->gap));
        sag = real_max(sag, per_push * weight);
    }
    return sag / real_min(c->a->shape->radius, c->b->shape->radius);
}
//<

//> little_substeps_wanted 18b
// A spring sags by the square of the substep: as many as the deepest rest
// wants, which is a hundredth of the smaller body.  One less if fewer will do.
static int substeps_wanted(real h)
{
    real worst = 0;
    int least = particle_count > 0 ? 4 : 2, most = 64;
    for (int i = 0; i < active_count; i++)
        worst = real_max(worst, contact_sag(active[i], h));
    real wanted = substeps * sqrt(worst / 0.01);
    if (wanted > substeps) return (int)real_min(wanted + 1, most);
    return wanted < substeps - 2 && substeps > least ? substeps - 1 : substeps;
}
//<

//> little_impulses_scale 18b
// What was given in a substep of another length is given in proportion.
static void impulses_scale(real s)
{
    for (int i = 0; i < active_count; i++)
        for (int k = 0; k < active[i]->count; k++) {
            contact_point *p = &active[i]->point[k];
            p->push *= s;
            p->rub = vec3_scale(s, p->rub);
        }
    for (particle *p = particles; p < particles + particle_count; p++) {
        vec3 moved = vec3_sub(p->position, p->previous);
        p->previous = vec3_add_scaled(p->position, -s, moved);
    }
}
//<

//> little_half_step 13g
// Contacts are sought twice in a step; between, everything is where it is.
static void half_step(real dt)
{
//<
//> little_half_h 13g 18a
    real h = dt / substeps;
//<
//> little_half_find 13g
    contacts_find(dt);
//<
//> little_half_sleep 18a
    bodies_sleep(dt);
//<
//> little_half_begin 13g
    contacts_begin();
//<
//> little_half_joints 17a
    joints_renew();
//<
//> little_half_wanted 18b
    int had = substeps;
    substeps = substeps_wanted(dt / had);
    real h = dt / substeps;
    impulses_scale(had / (real)substeps);
//<
//> little_half_run 13g
    for (int s = 0; s < substeps; s++) substep(h);
//<
//> little_half_bounce 15c
    contacts_bounce();
//<
//> little_half_end 13g
}

static void step(real dt)
{
    for (int i = 0; i < 2; i++) half_step(dt / 2);
}
//<
