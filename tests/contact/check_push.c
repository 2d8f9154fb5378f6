// check_push.c - do contacts push as much as they must, and remember it?
// Book: chapter 13.

#include <check.h>
#include <string.h>

#include "push.h"

// A push is a few products and sums; the matrix of a body's sticks multiplies
// their roundings by up to 100.
#define ROUNDING 1e-13

// --- chance ------------------------------------------------------------------

static unsigned long long seed;

// Numbers in [-1, 1) from a linear congruence; the same on every machine.
static real any(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static real between(real least, real most)
{
    return least + (most - least) * (any() + 1) / 2;
}

static vec3 any_vec3(void)
{
    real x = any(), y = any();
    return vec3_make(x, y, any());
}

static vec3 any_unit(void)
{
    vec3 d = any_vec3();
    real length = vec3_length(d);
    return length > 0.1 && length < 1 ? vec3_scale(1 / length, d) : any_unit();
}

// --- particles, bodies and contacts ------------------------------------------

// A sixteenth of a second cut in sixteen: a power of two, without rounding.
#define H (1.0 / 256)

enum { MOST = 64 };

static const vec3 UP = { 0, 1, 0 }, ZERO = { 0, 0, 0 };
static const push_options SMOOTH = { .mend = 0.2, .mend_speed = 3,
                                     .book = 1 };
static const push_options ROUGH = { .friction = 0.5, .mend = 0.2,
                                    .mend_speed = 3, .book = 1 };

static particle p[MOST];
static vec3 found[MOST];        // where they were, for the ways
static rigid4_ways ways[MOST];    // of the body that begins with each
static int count;
static shape box;
static rigid4 plan;

static void set_up(void)
{
    seed = 7;
    count = 0;
    ck_assert(shape_box(&box, vec3_make(1, 0.5, 2), 3).ok);
    ck_assert(rigid4_build(&plan, &box).ok);
}

static void tear_down(void)
{
    rigid4_free(&plan);
    shape_free(&box);
}

// Adds a particle that was there, and is now here; mass 0: nailed.
static int add(vec3 before, vec3 now, real mass)
{
    p[count] = (particle){ now, before, mass > 0 ? 1 / mass : 0 };
    found[count] = before;
    return count++;
}

// The axes of a turned frame.
typedef struct {
    vec3 x, y, z;
} axes;

static const axes UPRIGHT = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

static axes any_axes(void)
{
    axes m = { .x = any_unit() };
    m.y = vec3_unit(vec3_cross(m.x, any_unit()));
    m.z = vec3_cross(m.x, m.y);
    return m;
}

static vec3 turned(const axes *m, vec3 r)
{
    return vec3_add(vec3_scale(r.x, m->x),
           vec3_add(vec3_scale(r.y, m->y), vec3_scale(r.z, m->z)));
}

// Adds the box, with its centre where it says, on its way for a substep with
// this velocity and spin (both times H); returns its first particle.
static int add_box(const axes *m, vec3 at, vec3 move, vec3 turn, int nailed)
{
    int first = count;
    for (int k = 0; k < FOUR; k++) {
        vec3 r = turned(m, plan.at[k]), x = vec3_add(at, r);
        vec3 step = vec3_add(move, vec3_cross(turn, r));
        add(x, nailed ? x : vec3_add(x, step), nailed ? 0 : plan.mass);
    }
    return first;
}

static push_side of_particle(int i)
{
    return (push_side){ .first = i, .count = 1, .share = { 1 } };
}

// The point r of the box's own frame.
static push_side of_box(int first, vec3 r)
{
    push_side s = { .ways = &ways[first], .first = first, .count = FOUR };
    rigid4_find_ways(found + first, p[first].inverse_mass, &ways[first]);
    // The corner 0 is at (-, -, -), 1, 2 and 4 one side further along x, y, z.
    vec3 low = box.at[0];
    real x = (r.x - low.x) / (box.at[1].x - low.x);
    real y = (r.y - low.y) / (box.at[2].y - low.y);
    real z = (r.z - low.z) / (box.at[4].z - low.z);
    for (int k = 0; k < FOUR; k++)
        s.share[k] = (1 - x - y - z) * plan.weight[0][k] + x * plan.weight[1][k]
                   + y * plan.weight[2][k] + z * plan.weight[4][k];
    return s;
}

static push contact_of(push_side a, push_side b, vec3 normal, real thickness)
{
    push c = { .a = a, .b = b, .thickness = thickness };
    push_directions(&c, normal);
    return c;
}

// A plane: immovable.
static push at_plane(push_side a, vec3 on_plane, vec3 normal, real thickness)
{
    push c = contact_of(a, (push_side){ .count = 0 }, normal, thickness);
    c.fixed = on_plane;
    return c;
}

// A pile of this contact alone, on the left.
static push_pile pile_of(push *c)
{
    static const int first = 0;
    static push_drift drift[2 + PILE_PARTS];
    static push_near near;
    near = (push_near){ &drift[0], &drift[1], 0, 1, 0, -1, 0 };
    c->a.body = 0;
    c->b.body = 1;
    drift[0] = drift[1] = (push_drift){ .stirred = 0 };
    return (push_pile){ c, &first, { 1, 1, 1 }, drift, 2, &near, { 1 } };
}

static void apply(const push_side *s, const push_drift *d)
{
    particle *x = &p[s->first];
    if (s->count == 0) return;
    if (s->ways) {
        drift_apply(d, s->ways, x);
        return;
    }
    vec3 way = { d->pushed[0], d->pushed[1], d->pushed[2] };
    x->position = vec3_add_scaled(x->position, sqrt(x->inverse_mass), way);
}

// The contact pushes once more what it has pushed.
static void push_again(push *c)
{
    push_pile s = pile_of(c);
    pile_begin(&s, PILE_LEFT, p, (push_options){ .book = 1 }, H);
    if (s.nears[PILE_LEFT] == 0) return;
    apply(&c->a, &s.drift[0]);
    apply(&c->b, &s.drift[1]);
}

static void push_mark(push *c)
{
    for (int d = 0; d < DIRECTIONS; d++)
        c->from[d] = c->last[d] = c->pushed[d];
}

static real push_leads_on(const push *c)
{
    real sum = 0;
    for (int d = 0; d < DIRECTIONS; d++)
        sum += c->weight[d] * (c->pushed[d] - c->from[d])
                            * (c->pushed[d] - c->last[d]);
    return sum;
}

static void push_lean(push *c, real share)
{
    push_pile s = pile_of(c);
    push_limit(c, p, (push_options){ .book = 1 }, H);
    pile_lean(&s, PILE_LEFT, share, ROUGH);
    apply(&c->a, &s.drift[0]);
    apply(&c->b, &s.drift[1]);
}

static vec3 point_of(const push_side *s, int before)
{
    vec3 sum = ZERO;
    for (int k = 0; k < s->count; k++) {
        const particle *x = &p[s->first + k];
        sum = vec3_add_scaled(sum, s->share[k],
                              before ? x->previous : x->position);
    }
    return sum;
}

static vec3 apart(const push *c, int before)
{
    vec3 b = c->b.count > 0 ? point_of(&c->b, before) : c->fixed;
    return vec3_sub(point_of(&c->a, before), b);
}

static real gap_of(const push *c, int before)
{
    return vec3_dot(apart(c, before), c->along[NORMAL]) - c->thickness;
}

// How far the points have slid across the normal in this substep.
static vec3 slide_of(const push *c)
{
    vec3 d = vec3_sub(apart(c, 0), apart(c, 1));
    return vec3_add_scaled(d, -vec3_dot(d, c->along[NORMAL]),
                           c->along[NORMAL]);
}

// kg m, what the contact has pushed in all, in the world's frame.
static vec3 pushed_by(const push *c)
{
    vec3 sum = ZERO;
    for (int d = 0; d < DIRECTIONS; d++)
        sum = vec3_add_scaled(sum, c->pushed[d], c->along[d]);
    return sum;
}

// Of the particles on their way, times H.
static vec3 momentum(void)
{
    vec3 sum = ZERO;
    for (int i = 0; i < count; i++)
        if (p[i].inverse_mass > 0)
            sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass,
                                  vec3_sub(p[i].position, p[i].previous));
    return sum;
}

static vec3 turning(void)
{
    vec3 sum = ZERO;
    for (int i = 0; i < count; i++)
        if (p[i].inverse_mass > 0)
            sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass,
                                  vec3_cross(p[i].previous, p[i].position));
    return sum;
}

// J s^2: kinetic energy times H^2.
static real energy(void)
{
    real sum = 0;
    for (int i = 0; i < count; i++)
        if (p[i].inverse_mass > 0)
            sum += vec3_length_squared(vec3_sub(p[i].position, p[i].previous))
                 / (2 * p[i].inverse_mass);
    return sum;
}

static particle kept[MOST];

static void keep(void)
{
    memcpy(kept, p, sizeof p);
}

static int nothing_moved(void)
{
    return memcmp(kept, p, sizeof p) == 0;
}

static int nothing_moved_before(void)
{
    int same = 1;
    for (int i = 0; i < count; i++)
        same &= memcmp(&kept[i].previous, &p[i].previous, sizeof(vec3)) == 0;
    return same;
}

static void is_near(real got, real wanted, real error)
{
    ck_assert_msg(fabs(got - wanted) <= error, "got %.17g, wanted %.17g", got,
                  wanted);
}

static void is_near_vec3(vec3 got, vec3 wanted, real error)
{
    ck_assert_msg(vec3_distance(got, wanted) <= error,
                  "got (%.17g, %.17g, %.17g), wanted (%.17g, %.17g, %.17g)",
                  got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
}

// --- one push ----------------------------------------------------------------

// Rejects: directions that are not perpendicular, not units, or left-handed;
// an axis that n may be parallel to.
START_TEST(directions_are_three_perpendicular_units)
{
    for (int n = 0; n < 1000; n++) {
        push c = { .ready = 0 };
        vec3 d = any_unit();
        if (n < 6) {
            d = vec3_make(n % 3 == 0, n % 3 == 1, n % 3 == 2);
            d = vec3_scale(n < 3 ? 1 : -1, d);
        }
        push_directions(&c, d);
        ck_assert(vec3_distance(c.along[NORMAL], d) == 0);
        for (int i = 0; i < DIRECTIONS; i++) {
            is_near(vec3_length(c.along[i]), 1, ROUNDING);
            is_near(vec3_dot(c.along[i], c.along[(i + 1) % 3]), 0, ROUNDING);
        }
        is_near_vec3(vec3_cross(c.along[NORMAL], c.along[ACROSS]),
                     c.along[ASIDE], ROUNDING);
    }
}
END_TEST

// Rejects: a push at a distance; a push for a gap that is exactly closed.
START_TEST(what_does_not_touch_is_left)
{
    int i = add(vec3_make(0, 1, 0), vec3_make(1, 0.25, 0), 2);
    int b = add_box(&UPRIGHT, vec3_make(0, 5, 0), vec3_make(0, -0.5, 0), ZERO,
                    0);
    push c[] = {
        at_plane(of_particle(i), ZERO, UP, 0.2),
        at_plane(of_particle(i), ZERO, UP, 0.25),
        at_plane(of_box(b, vec3_make(0, -0.25, 0)), ZERO, UP, 0.1),
        contact_of(of_box(b, vec3_make(0, -0.25, 0)), of_particle(i), UP, 0.1),
    };
    keep();
    for (int k = 0; k < 4; k++) {
        ck_assert(push_solve(&c[k], p, SMOOTH) == 0);
        push_again(&c[k]);
        push_limit(&c[k], p, SMOOTH, H);
        push_mend(&c[k], p, SMOOTH);
        for (int d = 0; d < DIRECTIONS; d++) ck_assert(c[k].pushed[d] == 0);
    }
    ck_assert(nothing_moved());
}
END_TEST

// Rejects: a push by the overlap of the points that forgets the thickness, or
// where the plane is; one that moves where the particle was; a push that is not
// mass times way.
START_TEST(particle_in_a_plane_is_put_onto_it)
{
    for (int n = 0; n < 500; n++) {
        count = 0;
        vec3 on = any_vec3(), normal = any_unit();
        real depth = between(0.01, 1), high = between(0, 1), mass = 2 + any();
        real thick = between(0, 0.3);
        vec3 slid = vec3_cross(normal, any_vec3());
        int i = add(vec3_add_scaled(on, thick + high, normal),
                    vec3_add(slid, vec3_add_scaled(on, thick - depth, normal)),
                    mass);
        push c = at_plane(of_particle(i), on, normal, thick);
        keep();
        is_near(push_solve(&c, p, SMOOTH), depth, ROUNDING);
        is_near(gap_of(&c, 0), 0, ROUNDING);
        is_near(c.pushed[NORMAL], mass * depth, ROUNDING * mass);
        ck_assert(nothing_moved_before());
        is_near_vec3(slide_of(&c), slid, ROUNDING);
        // Content: once more changes nothing.
        is_near(push_solve(&c, p, SMOOTH), 0, ROUNDING);
    }
}
END_TEST

// Rejects: sides that are pushed alike, or in proportion to their masses; one
// that takes the other's sign.
START_TEST(particles_part_by_their_inverse_masses)
{
    for (int n = 0; n < 500; n++) {
        count = 0;
        vec3 normal = any_unit(), x = any_vec3();
        real light = between(0.1, 1), heavy = light * between(1, 1000);
        int a = add(vec3_add(x, normal), vec3_add_scaled(x, -0.25, normal),
                    light);
        int b = add(x, vec3_add_scaled(x, 0.5, normal), heavy);
        push c = contact_of(of_particle(a), of_particle(b), normal, 0.25);
        vec3 before = momentum(), from_a = p[a].position;
        vec3 from_b = p[b].position;
        is_near(push_solve(&c, p, SMOOTH), 1, ROUNDING);
        is_near(gap_of(&c, 0), 0, ROUNDING);
        is_near_vec3(momentum(), before, ROUNDING * heavy);
        is_near_vec3(vec3_sub(p[a].position, from_a),
                     vec3_scale(heavy / (light + heavy), normal), ROUNDING);
        is_near_vec3(vec3_sub(p[b].position, from_b),
                     vec3_scale(-light / (light + heavy), normal), ROUNDING);
    }
}
END_TEST

// An overlap that was there when the substep began is left to push_mend.
// Rejects: a speed out of an old overlap; one that may grow.
START_TEST(old_overlap_is_kept_but_not_deepened)
{
    int i = add(vec3_make(0, -0.125, 0), vec3_make(0, -0.5, 0), 1);
    push c = at_plane(of_particle(i), ZERO, UP, 0);
    is_near(push_solve(&c, p, SMOOTH), 0.375, 0);
    ck_assert(p[i].position.y == -0.125 && p[i].previous.y == -0.125);
    // On its way out.
    i = add(vec3_make(0, -0.5, 0), vec3_make(0, -0.25, 0), 1);
    c = at_plane(of_particle(i), ZERO, UP, 0);
    keep();
    ck_assert(push_solve(&c, p, SMOOTH) == 0);
    ck_assert(nothing_moved() && c.pushed[NORMAL] == 0);
}
END_TEST

// Rejects: a memory that glues; one that is not taken back, and so throws what
// is already parting.
START_TEST(push_is_never_a_pull)
{
    // Pushed by 3 kg m from memory, it needs only 1.
    int i = add(vec3_make(0, 0.5, 0), vec3_make(0, -0.5, 0), 2);
    push c = at_plane(of_particle(i), ZERO, UP, 0);
    c.pushed[NORMAL] = 3;
    push_again(&c);
    is_near(p[i].position.y, 1, ROUNDING);
    is_near(push_solve(&c, p, SMOOTH), 1, ROUNDING);
    is_near(p[i].position.y, 0, ROUNDING);
    is_near(c.pushed[NORMAL], 1, ROUNDING);
    // Parting, it needs none.
    i = add(vec3_make(0, 0, 0), vec3_make(0, 0.5, 0), 2);
    c = at_plane(of_particle(i), ZERO, UP, 0);
    c.pushed[NORMAL] = 3;
    push_again(&c);
    is_near(p[i].position.y, 2, ROUNDING);
    push_solve(&c, p, SMOOTH);
    is_near(p[i].position.y, 0.5, ROUNDING);
    ck_assert(c.pushed[NORMAL] == 0);
    keep();
    push_again(&c);
    // What is left of a turned memory rubs only where it pushes.
    c.pushed[ACROSS] = 1;
    push_again(&c);
    ck_assert(nothing_moved() && c.worn == 0);
    c.pushed[ACROSS] = 0;
    for (int n = 0; n < 1000; n++) {
        p[i].position.y += any() / 4;
        push_again(&c);
        push_solve(&c, p, SMOOTH);
        ck_assert(c.pushed[NORMAL] >= 0);
    }
}
END_TEST

// Rejects: a division by the weight of what cannot move.
START_TEST(two_immovable_sides_are_left)
{
    int i = add(UP, vec3_scale(-1, UP), 0);
    int b = add_box(&UPRIGHT, vec3_make(0, -1, 0), ZERO, ZERO, 1);
    push c[] = {
        at_plane(of_particle(i), ZERO, UP, 0),
        at_plane(of_box(b, ZERO), ZERO, UP, 0),
        contact_of(of_box(b, ZERO), of_particle(i), UP, 1),
    };
    const push_options rough = { .friction = 1, .restitution = 1, .mend = 1,
                                 .mend_speed = 1000 };
    keep();
    for (int k = 0; k < 3; k++) {
        c[k].pushed[NORMAL] = 1;
        push_again(&c[k]);
        push_limit(&c[k], p, rough, H);
        push_mend(&c[k], p, rough);
        ck_assert(push_solve(&c[k], p, rough) == 0);
        ck_assert_int_eq(push_blow(&c[k], 1, p, rough, 0), 0);
        ck_assert(c[k].worn == 0);
    }
    ck_assert(nothing_moved());
}
END_TEST

// --- bodies ------------------------------------------------------------------

// Two boxes anywhere, that come near each other: `from` the first's centre.
static push two_boxes(real gap, real closing, real mu_way)
{
    count = 0;
    axes m = any_axes(), o = any_axes();
    vec3 r = vec3_scale(0.5, any_vec3()), s = vec3_scale(0.5, any_vec3());
    vec3 at = any_vec3(), normal = any_unit();
    vec3 on = vec3_add(at, turned(&m, r));
    vec3 center = vec3_sub(vec3_add_scaled(on, -gap, normal), turned(&o, s));
    vec3 slide = vec3_scale(mu_way, vec3_unit(vec3_cross(normal, any_vec3())));
    int a = add_box(&m, at, vec3_add(slide, vec3_scale(-closing, normal)), ZERO,
                    0);
    int b = add_box(&o, center, ZERO, ZERO, 0);
    return contact_of(of_box(a, r), of_box(b, s), normal, 0);
}

// Rejects: an answer of the particles without their sticks, which closes the
// gap before they are relaxed and not after; an answer of one side for both.
START_TEST(bodies_part_as_rigid_ones_and_keep_their_momentum)
{
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(0, 0.125, 0);
        vec3 linear = momentum(), angular = turning();
        is_near(push_solve(&c, p, SMOOTH), 0.125, ROUNDING);
        is_near(gap_of(&c, 0), 0, ROUNDING);
        is_near_vec3(momentum(), linear, ROUNDING);
        is_near_vec3(turning(), angular, ROUNDING);
        // Sticks keep their lengths, to first order in their turning.
        for (int b = 0; b < 2; b++)
            for (int k = 0; k < FOUR_STICKS; k++) {
                const stick *s = &plan.stick[k];
                const particle *x = &p[FOUR * b + s->a], *y = &p[FOUR * b
                                                                 + s->b];
                vec3 o = vec3_sub(y->previous, x->previous);
                vec3 d = vec3_sub(vec3_sub(y->position, x->position), o);
                is_near(vec3_dot(o, d), 0, ROUNDING);
            }
    }
}
END_TEST

// Rejects: answers that a later place of the body, or the other body's, gives.
START_TEST(answers_are_made_for_where_the_contacts_were_found)
{
    for (int n = 0; n < 200; n++) {
        push c = two_boxes(0, 0.125, 0), again = c;
        push_solve(&c, p, SMOOTH);
        for (int i = 0; i < count; i++)
            p[i].position = vec3_add_scaled(p[i].position, 0.1, any_vec3());
        again.pushed[NORMAL] = 1;
        push_again(&again);
        for (int d = 0; d < DIRECTIONS; d++) {
            ck_assert(again.weight[d] == c.weight[d]);
            ck_assert(again.skew[d] == c.skew[d]);
        }
        rigid4_ways w;
        real rows[DIRECTIONS][FOUR_WAYS], sum = 0;
        for (int k = 0; k < 2; k++) {
            const push_side *side = k ? &c.b : &c.a;
            rigid4_find_ways(found + side->first, 1 / plan.mass, &w);
            rigid4_rows(&w, side->share, c.along, rows);
            const real *row = rows[NORMAL];
            for (int i = 0; i < FOUR_WAYS; i++) sum += row[i] * row[i];
        }
        is_near(c.weight[NORMAL], sum, ROUNDING);
        // Made once: a contact is that of its frame.
        push kept_answers = c;
        for (int k = 0; k < FOUR; k++) ways[0].turn[0][k] = any_vec3();
        push_again(&c);
        push_solve(&c, p, SMOOTH);
        for (int d = 0; d < DIRECTIONS; d++)
            ck_assert(c.weight[d] == kept_answers.weight[d]);
    }
}
END_TEST

// What a push at one corner does to the gap at another is what a push there
// would do here: without that the passes need not come to an end.
START_TEST(pushes_act_on_each_other_alike)
{
    for (int n = 0; n < 200; n++) {
        real moved[2];
        for (int k = 0; k < 2; k++) {
            seed = (unsigned long long)n + 99;
            count = 0;
            axes m = any_axes();
            int b = add_box(&m, ZERO, ZERO, ZERO, 0);
            push c[2];
            for (int i = 0; i < 2; i++)
                c[i] = at_plane(of_box(b, any_vec3()), ZERO, any_unit(), 0);
            for (int i = 0; i < count; i++)
                p[i].position = vec3_add_scaled(p[i].position, 0.2, any_vec3());
            real before = gap_of(&c[1 - k], 0);
            c[k].pushed[NORMAL] = 1;
            push_again(&c[k]);
            moved[k] = gap_of(&c[1 - k], 0) - before;
        }
        is_near(moved[0], moved[1], ROUNDING * 10);
    }
}
END_TEST

// Rejects: a nailed body that gives way, or a push that is shared with it.
START_TEST(nailed_body_gives_no_way)
{
    int a = add_box(&UPRIGHT, vec3_make(0, 0.25, 0), vec3_make(0, -0.125, 0),
                    ZERO, 0);
    int b = add_box(&UPRIGHT, vec3_make(0, -0.25, 0), ZERO, ZERO, 1);
    push c = contact_of(of_box(a, vec3_make(0, -0.25, 0)),
                        of_box(b, vec3_make(0, 0.25, 0)), UP, 0);
    is_near(push_solve(&c, p, SMOOTH), 0.125, ROUNDING);
    is_near(c.weight[NORMAL], 1.0 / 3, ROUNDING);
    for (int k = 0; k < FOUR; k++) {
        is_near_vec3(p[a + k].position, p[a + k].previous, ROUNDING);
        is_near_vec3(p[b + k].position, p[b + k].previous, 0);
    }
}
END_TEST

// How far the points of c are parted, along each of its directions, by a unit
// push along direction i.
static void unit_push(push *c, int i, real parted[DIRECTIONS])
{
    vec3 before = apart(c, 0);
    push one = *c;
    for (int d = 0; d < DIRECTIONS; d++) one.pushed[d] = d == i;
    // Only what pushes is pushed again: a push along the normal goes with it,
    // and is taken back.
    one.pushed[NORMAL] = 1;
    push_again(&one);
    vec3 went = vec3_sub(apart(c, 0), before);
    *c = one;
    for (int d = 0; d < DIRECTIONS; d++)
        parted[d] = vec3_dot(went, c->along[d]);
}

// Rejects: a skew of the wrong pair of directions or the wrong sign; one side's
// alone; a table that is not symmetric, over which passes need not converge.
START_TEST(weights_and_skews_are_what_unit_pushes_do)
{
    for (int n = 0; n < 200; n++) {
        push c = two_boxes(0.1, 0, 0);
        real table[DIRECTIONS][DIRECTIONS];
        for (int i = 0; i < DIRECTIONS; i++) unit_push(&c, i, table[i]);
        for (int i = ACROSS; i < DIRECTIONS; i++)
            for (int d = 0; d < DIRECTIONS; d++)
                table[i][d] -= table[NORMAL][d];
        for (int i = 0; i < DIRECTIONS; i++) {
            is_near(c.weight[i], table[i][i], ROUNDING * 10);
            int next = (i + 1) % DIRECTIONS;
            is_near(table[i][next], table[next][i], ROUNDING * 10);
        }
        is_near(c.skew[ACROSS], table[NORMAL][ACROSS], ROUNDING * 10);
        is_near(c.skew[ASIDE], table[NORMAL][ASIDE], ROUNDING * 10);
        is_near(c.skew[NORMAL], table[ACROSS][ASIDE], ROUNDING * 10);
    }
}
END_TEST

// --- friction ----------------------------------------------------------------

// Two bodies at rest are pushed into each other, by a push within the cone; the
// contact remembers some other push.
// Rejects: one direction after the other, each of which undoes part of the last
// one; an old push that is forgotten, or counted twice.
START_TEST(hold_finds_the_push_in_all_three_directions_at_once)
{
    const push_options rough = { .friction = 1, .book = 1 };
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(0, 0, 0);
        push back = contact_of(c.b, c.a, c.along[NORMAL], 0);
        real deep = between(0.05, 0.2), most = 0.7 * deep;
        back.pushed[NORMAL] = deep;
        for (int d = ACROSS; d < DIRECTIONS; d++)
            back.pushed[d] = between(-most, most);
        push_again(&back);
        for (int d = 0; n % 2 && d < DIRECTIONS; d++)
            c.pushed[d] = between(0, 0.1);
        push_again(&c);

        ck_assert(push_solve(&c, p, rough) > 0);
        is_near_vec3(pushed_by(&c), pushed_by(&back), ROUNDING);
        for (int i = 0; i < count; i++)
            is_near_vec3(p[i].position, p[i].previous, ROUNDING);
        is_near(push_solve(&c, p, rough), 0, ROUNDING);
    }
}
END_TEST

// The point is at the end of a lever ten million times as long as the body:
// that goes aside so easily that what goes along it is lost in rounding.
// Rejects: a volume of nothing but rounding that is divided by.
START_TEST(lever_too_long_to_hold_throws_nobody)
{
    const push_options rough = { .friction = 1, .book = 1 };
    for (int n = 0; n < 200; n++) {
        count = 0;
        axes m = any_axes();
        int b = add_box(&m, ZERO, ZERO, ZERO, 0);
        vec3 r = vec3_scale(1e7, any_unit()), normal = any_unit();
        vec3 on = vec3_add_scaled(turned(&m, r), 0.125, normal);
        push c = at_plane(of_box(b, r), on, normal, 0);
        for (int k = 0; k < FOUR; k++)
            p[k].previous = vec3_add_scaled(p[k].position, 0.25, normal);
        real had = energy();
        push_solve(&c, p, rough);
        ck_assert(c.pushed[NORMAL] > 0);
        ck_assert(energy() <= had);
        for (int k = 0; k < FOUR; k++)
            ck_assert(vec3_distance(p[k].position, found[k]) < 0.25);
    }
}
END_TEST

// A particle of mass m, driven by `depth` into a plane and `slid` along it.
static push rub(real mass, real depth, vec3 slid)
{
    count = 0;
    int i = add(ZERO, vec3_add_scaled(slid, -depth, UP), mass);
    return at_plane(of_particle(i), ZERO, UP, 0);
}

// Rejects: friction that only slows; one along one direction alone; its work
// booked as the push times the whole slide.
START_TEST(friction_holds_whatever_is_within_the_cone)
{
    for (int n = 0; n < 500; n++) {
        real a = between(0, 6.3), far = between(0, 0.499);
        vec3 slid = { far * cos(a), 0, far * sin(a) };
        real mass = 2 + any();
        push c = rub(mass, 1, slid);
        push_solve(&c, p, ROUGH);
        is_near_vec3(p[0].position, ZERO, ROUNDING);
        is_near(c.pushed[ACROSS] * c.pushed[ACROSS]
                + c.pushed[ASIDE] * c.pushed[ASIDE],
                mass * mass * far * far, ROUNDING * 10);
        // All of its sliding was worn away.
        is_near(c.worn, -mass * far * far / 2, ROUNDING);
    }
}
END_TEST

// Rejects: a square instead of a cone; friction along one direction first;
// friction of the step's last push instead of all of it; work of the push
// times the slide before it alone.
START_TEST(friction_brakes_by_exactly_its_share_of_the_push)
{
    for (int n = 0; n < 500; n++) {
        real a = between(0, 6.3), far = between(0.501, 2);
        vec3 way = { cos(a), 0, sin(a) };
        real mass = 2 + any();
        push c = rub(mass, 1, vec3_scale(far, way));
        real had = energy();
        // In two passes: the second finds nothing left to push.
        push_solve(&c, p, ROUGH);
        push_solve(&c, p, ROUGH);
        is_near_vec3(p[0].position, vec3_scale(far - 0.5, way), ROUNDING);
        vec3 across = vec3_add(vec3_scale(c.pushed[ACROSS], c.along[ACROSS]),
                               vec3_scale(c.pushed[ASIDE], c.along[ASIDE]));
        is_near_vec3(across, vec3_scale(-0.5 * mass, way), ROUNDING * 10);
        is_near(energy() - had, c.worn - mass / 2, ROUNDING * 10);
    }
}
END_TEST

// Rejects: friction at one side alone; friction without a push.
START_TEST(friction_between_bodies_keeps_their_momentum)
{
    const push_options rough = { .friction = 0.3, .book = 1 };
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(0, 0.0625, 0.25);
        vec3 linear = momentum(), angular = turning();
        for (int k = 0; k < 3; k++) push_solve(&c, p, rough);
        is_near_vec3(momentum(), linear, ROUNDING);
        is_near_vec3(turning(), angular, ROUNDING);
        real across2 = c.pushed[ACROSS] * c.pushed[ACROSS]
                     + c.pushed[ASIDE] * c.pushed[ASIDE];
        ck_assert(across2 <= pow(0.3 * c.pushed[NORMAL], 2) + ROUNDING);
        ck_assert(c.pushed[NORMAL] > 0 && c.worn < 0);
    }
    push c = two_boxes(0.01, -0.0625, 0.25);
    keep();
    push_solve(&c, p, rough);
    ck_assert(nothing_moved() && c.worn == 0);
}
END_TEST

// A pass forward and one backward; returns the largest change of a gap.
static real pass_twice(push *c, int n, push_options how)
{
    real most = 0;
    for (int k = 0; k < n; k++) most = fmax(most, push_solve(&c[k], p, how));
    for (int k = n - 1; k >= 0; k--)
        most = fmax(most, push_solve(&c[k], p, how));
    return most;
}

static void mend(push *c, int n, push_options how)
{
    for (int k = 0; k < n; k++) push_limit(&c[k], p, how, H);
    for (int k = 0; k < n; k++) push_mend(&c[k], p, how);
}

// One substep as the world takes it.
static void substep(push *c, int n, vec3 gravity, push_options how, int pairs)
{
    verlet_step(p, count, gravity, NULL, H);
    for (int k = 0; k < n; k++) push_again(&c[k]);
    mend(c, n, how);
    for (int k = 0; k < pairs; k++) pass_twice(c, n, how);
}

// On a slope of tangent t under g: what is gentler than the friction holds for
// good; on a steeper one a = g (sin - mu cos).
START_TEST(particle_slides_on_a_slope_as_coulomb_says)
{
    const real tangent[] = { 0, 0.2, 0.49, 0.51, 0.8, 2 };
    for (int k = 0; k < 6; k++) {
        count = 0;
        real cosine = 1 / sqrt(1 + tangent[k] * tangent[k]);
        real sine = tangent[k] * cosine;
        vec3 down = vec3_make(sine * 10, -cosine * 10, 0);
        int i = add(ZERO, ZERO, 2);
        push c = at_plane(of_particle(i), ZERO, UP, 0);
        for (int n = 0; n < 256; n++) substep(&c, 1, down, ROUGH, 1);
        real a = tangent[k] > 0.5 ? 10 * (sine - 0.5 * cosine) : 0;
        // A second of Verlet's sums from rest: n (n + 1) / 2 steps of a H^2.
        is_near(p[i].position.x, a * (256 * 257 / 2) * H * H, 1e-11);
        is_near(p[i].position.y, 0, 1e-11);
    }
}
END_TEST

// The box upright on a plane, at its four lower corners.
static void stand(push c[4], real height, vec3 move)
{
    count = 0;
    int b = add_box(&UPRIGHT, vec3_make(0, 0.25 + height, 0), move, ZERO, 0);
    static const int corner[4] = { 0, 1, 4, 5 };
    for (int k = 0; k < 4; k++) {
        vec3 foot = box.at[corner[k]];
        foot.y = 0;
        c[k] = at_plane(of_box(b, box.at[corner[k]]), foot, UP, 0);
    }
}

// --- mending -----------------------------------------------------------------

static const push_options MENDS_ALL = { .mend = 1, .mend_speed = 1000 };

// Rejects: mending through the velocity, which throws what overlapped; by more
// than its share; faster than it may.
START_TEST(mending_moves_without_giving_speed)
{
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(-between(0.001, 0.2), 0.01, 0.02);
        push_options how = { .mend = between(0, 1),
                             .mend_speed = between(0.5, 20) };
        vec3 u[MOST];
        for (int i = 0; i < count; i++)
            u[i] = vec3_sub(p[i].position, p[i].previous);
        vec3 linear = momentum();
        real old = -gap_of(&c, 1), now = -gap_of(&c, 0);
        mend(&c, 1, how);
        real mended = fmin(how.mend * old, how.mend_speed * H);
        is_near(-gap_of(&c, 1), old - mended, ROUNDING);
        is_near(-gap_of(&c, 0), now - mended, ROUNDING);
        for (int i = 0; i < count; i++)
            is_near_vec3(vec3_sub(p[i].position, p[i].previous), u[i],
                         ROUNDING);
        is_near_vec3(momentum(), linear, ROUNDING);
        ck_assert(c.pushed[NORMAL] == 0);
    }
}
END_TEST

// Rejects: mending of what has only just come to overlap, which is push_solve's
// business.
START_TEST(new_overlap_is_not_mended)
{
    push c = two_boxes(0.01, 0.1, 0);
    keep();
    mend(&c, 1, MENDS_ALL);
    ck_assert(nothing_moved());
}
END_TEST

// Rejects: mending of what goes by itself, which ends in a gap, into which the
// body falls: the deeper of the two places counted, or the one before alone.
START_TEST(overlap_that_parts_by_itself_is_left_to_go)
{
    const struct { real before, now, mended; } way[] = {
        { -0.5, 0.001, 0 }, { -0.5, 0, 0 }, { -0.5, -0.125, 0.0625 },
        { -0.5, -0.5, 0.25 }, { -0.5, -0.75, 0.25 }, { 0.125, -0.5, 0 },
    };
    for (size_t k = 0; k < sizeof way / sizeof *way; k++) {
        count = 0;
        add(vec3_scale(way[k].before, UP), vec3_scale(way[k].now, UP), 2);
        push c = at_plane(of_particle(0), ZERO, UP, 0);
        mend(&c, 1, (push_options){ .mend = 0.5, .mend_speed = 1000 });
        is_near(p[0].previous.y, way[k].before + way[k].mended, ROUNDING);
        is_near(p[0].position.y, way[k].now + way[k].mended, ROUNDING);
    }
}
END_TEST

// Rejects: a slop in metres; one that is mended as soon as it is passed; one
// that keeps the whole overlap.
START_TEST(slop_of_the_thickness_is_let_be)
{
    push_options how = { .mend = 0.25, .mend_speed = 1000, .slop = 0.125 };
    for (int n = 0; n < 200; n++) {
        count = 0;
        real thick = between(0.01, 1), deep = between(0, 3 * how.slop * thick);
        vec3 x = vec3_scale(thick - deep, UP);
        add(x, x, 2);
        push c = at_plane(of_particle(0), ZERO, UP, thick);
        real more = fmax(deep - 0.125 * thick, 0);
        mend(&c, 1, how);
        is_near(-gap_of(&c, 1), deep - 0.25 * more, ROUNDING);
        // In the end the slop is left, and no more.
        for (int k = 0; k < 200; k++) mend(&c, 1, how);
        is_near(-gap_of(&c, 1), fmin(deep, 0.125 * thick), ROUNDING);
    }
}
END_TEST

// Rejects: a limit for each contact alone: a face with n contacts is thrown out
// n times as fast; one that is taken after others have mended.
START_TEST(contacts_of_a_pair_mend_together_no_faster_than_one)
{
    const push_options how = { .mend = 0.5, .mend_speed = 3 };
    enum { CONTACTS = 8 };
    push c[CONTACTS];
    for (int n = 1; n <= CONTACTS; n++) {
        count = 0;
        int b = add_box(&UPRIGHT, ZERO, ZERO, ZERO, 0);
        for (int k = 0; k < n; k++)
            c[k] = at_plane(of_box(b, vec3_make(0, -0.25, 0)), ZERO, UP, 0);
        mend(c, n, how);
        is_near(gap_of(&c[0], 1), -0.25 + 3 * H, ROUNDING);
        is_near(p[b].previous.y, found[b].y + 3 * H, ROUNDING);
        is_near_vec3(momentum(), ZERO, ROUNDING);
    }
    // At the four corners of a face, the face does not.
    stand(c, -0.2, ZERO);
    mend(c, 4, how);
    real rise = 0;
    for (int k = 0; k < 4; k++) rise += (gap_of(&c[k], 1) + 0.2) / 4;
    ck_assert_msg(rise > 0 && rise <= 3 * H, "the face mends by %g m", rise);
}
END_TEST

// --- memory ------------------------------------------------------------------

// m, of the 1.5e-4 that gravity brings in a substep; and how far the box goes
// until the four corners agree on who carries what.
#define CONTENT 1e-12
#define SETTLING 1.5e-5

// Rejects: a memory that is applied twice, not at all, or at one side; a first
// guess that leaves work for ever.
START_TEST(memory_leaves_a_block_at_rest_nothing_to_do)
{
    const struct { vec3 gravity; real friction; int pairs; } rule[] = {
        { { 0, -10, 0 }, 0, 1 }, { { 0, -10, 0 }, 0.5, 1 },
        { { 1, -10, 2 }, 0.5, 1 }, { { 1, -10, 2 }, 0.5, 5 },
    };
    push c[4];
    for (int r = 0; r < 4; r++) {
        push_options how = ROUGH;
        how.friction = rule[r].friction;
        stand(c, 0, ZERO);
        for (int n = 0; n < 2000; n++)
            substep(c, 4, rule[r].gravity, how, rule[r].pairs);
        verlet_step(p, count, rule[r].gravity, NULL, H);
        for (int k = 0; k < 4; k++) push_again(&c[k]);
        vec3 sum = ZERO;
        for (int k = 0; k < 4; k++) {
            real left = push_solve(&c[k], p, how);
            ck_assert_msg(left <= CONTENT, "corner %d was pushed by %g m", k,
                          left);
            sum = vec3_add(sum, pushed_by(&c[k]));
        }
        // Together they carry the box of 3 kg.
        is_near_vec3(sum, vec3_scale(-3 * H * H, rule[r].gravity), CONTENT);
        for (int k = 0; k < FOUR; k++) {
            is_near_vec3(p[k].position, found[k], SETTLING);
            is_near_vec3(p[k].position, p[k].previous, CONTENT);
        }
    }
}
END_TEST

static void forget(push *c)
{
    for (int i = 0; i < DIRECTIONS; i++) c->pushed[i] = 0;
}

// Rejects: pushes kept along the old frame's directions; a push across that is
// dropped, or changes sign; a pull out of a turned push.
START_TEST(memory_keeps_its_push_when_the_directions_turn)
{
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(0.1, 0.05, 0.1);
        for (int d = 0; d < DIRECTIONS; d++) c.pushed[d] = between(0.1, 1);
        vec3 was = pushed_by(&c);
        push_memory m = push_remember(&c, H);
        for (int k = 0; k < FOUR; k++) ck_assert(m.share[k] == c.a.share[k]);
        is_near_vec3(vec3_scale(H * H, m.force), was, ROUNDING);

        // The same normal, the others turned about it.
        push d = c;
        d.along[ACROSS] = vec3_unit(vec3_add_scaled(
            vec3_scale(any(), c.along[ACROSS]), 1, c.along[ASIDE]));
        d.along[ASIDE] = vec3_cross(d.along[NORMAL], d.along[ACROSS]);
        forget(&d);
        push_recall(&d, &m, H);
        is_near_vec3(pushed_by(&d), was, ROUNDING);

        // Another normal: what was across it is along it, in part.
        push_directions(&d, any_unit());
        forget(&d);
        push_recall(&d, &m, H);
        if (vec3_dot(d.along[NORMAL], was) >= 0)
            is_near_vec3(pushed_by(&d), was, ROUNDING);

        // Upside down: nothing is left of the push.
        push_directions(&d, vec3_scale(-1, c.along[NORMAL]));
        forget(&d);
        push_recall(&d, &m, H);
        ck_assert(d.pushed[NORMAL] == 0);
    }
}
END_TEST

// Rejects: a second memory that wipes out the first; one turned to a pull that
// takes from it.
START_TEST(memories_of_several_contacts_add_up)
{
    push c = two_boxes(0.1, 0.05, 0.1);
    for (int d = 0; d < DIRECTIONS; d++) c.pushed[d] = between(0.1, 1);
    vec3 was = pushed_by(&c);
    push_memory m = push_remember(&c, H), n = m;
    forget(&c);
    push_recall(&c, &m, H);
    push_recall(&c, &m, H);
    is_near_vec3(pushed_by(&c), vec3_scale(2, was), ROUNDING);
    n.force = vec3_scale(-100, c.along[NORMAL]);
    push_recall(&c, &n, H);
    is_near_vec3(pushed_by(&c), vec3_scale(2, was), ROUNDING);
}
END_TEST

// The next frame's substeps are of another length: what carries a weight is the
// force, and a push is force times h^2.
// Rejects: a push that is taken over as it is, or times h.
START_TEST(memory_carries_the_same_weight_in_longer_substeps)
{
    for (int k = 1; k <= 4; k++) {
        real h = k * H;
        count = 0;
        add(ZERO, ZERO, 2);
        push c = at_plane(of_particle(0), ZERO, UP, 0);
        c.pushed[NORMAL] = 2 * 10 * H * H;
        push_memory m = push_remember(&c, H);
        is_near_vec3(m.force, vec3_scale(20, UP), ROUNDING);
        forget(&c);
        push_recall(&c, &m, h);
        verlet_step(p, count, vec3_scale(-10, UP), NULL, h);
        push_again(&c);
        is_near_vec3(p[0].position, ZERO, ROUNDING);
    }
}
END_TEST

// For the ledger.
// Rejects: the slide before the push alone; the sideways answer of the push
// along the normal, or of one across along the other, left out.
START_TEST(work_of_the_memory_is_booked)
{
    for (int n = 0; n < 200; n++) {
        push c = two_boxes(0, 0.0625, 0.25);
        c.pushed[NORMAL] = between(0.05, 0.2);
        for (int d = ACROSS; d < DIRECTIONS; d++)
            c.pushed[d] = between(-0.05, 0.05);
        real had = energy();
        vec3 d = vec3_sub(apart(&c, 0), apart(&c, 1));
        push_again(&c);
        real normal = c.pushed[NORMAL]
            * (vec3_dot(d, c.along[NORMAL])
               + c.weight[NORMAL] * c.pushed[NORMAL] / 2);
        is_near(energy() - had, normal + c.worn, ROUNDING);
    }
}
END_TEST

// --- momentum between passes -------------------------------------------------

// Where the particle is must always be what its contact has pushed it to.
static void is_carried(const push *c, vec3 freely, real mass)
{
    is_near_vec3(p[c->a.first].position,
                 vec3_add_scaled(freely, 1 / mass, pushed_by(c)), ROUNDING);
}

// Rejects: a lean by the whole push instead of what the last two passes and the
// lean before them have changed; one that is not booked in c->pushed, or not in
// the places; a share taken twice.
START_TEST(lean_goes_on_by_its_share_of_the_last_change)
{
    const vec3 freely = { 0.25, -1, 0.5 };
    for (int n = 0; n < 100; n++) {
        count = 0;
        add(ZERO, freely, 2);
        push c = at_plane(of_particle(0), ZERO, UP, 0);
        for (int d = 0; d < DIRECTIONS; d++) c.pushed[d] = between(0, 1);
        push_again(&c);
        push_mark(&c);
        ck_assert(push_leads_on(&c) == 0);
        // Nothing has changed yet: there is nothing to go on with.
        keep();
        push_lean(&c, 0.5);
        ck_assert(nothing_moved());

        real was[DIRECTIONS], is[DIRECTIONS], share = between(0, 1);
        for (int d = 0; d < DIRECTIONS; d++) was[d] = c.pushed[d];
        push_solve(&c, p, ROUGH);
        for (int d = 0; d < DIRECTIONS; d++) is[d] = c.pushed[d];
        push_lean(&c, share);
        for (int d = 0; d < DIRECTIONS; d++)
            is_near(c.pushed[d], is[d] + share * (is[d] - was[d]), ROUNDING);
        is_carried(&c, freely, 2);

        // The next one counts from what was pushed before this lean.
        push_solve(&c, p, ROUGH);
        for (int d = 0; d < DIRECTIONS; d++) was[d] = c.pushed[d];
        push_lean(&c, share);
        for (int d = 0; d < DIRECTIONS; d++)
            is_near(c.pushed[d], was[d] + share * (was[d] - is[d]), ROUNDING);
        is_carried(&c, freely, 2);
    }
}
END_TEST

// Rejects: a push that is leant below nothing; one that is cut off in c->pushed
// and not in the places.
START_TEST(lean_is_never_a_pull)
{
    const vec3 freely = { 0, -0.5, 0 };
    add(ZERO, freely, 2);
    push c = at_plane(of_particle(0), ZERO, UP, 0);
    c.pushed[NORMAL] = 3;
    push_again(&c);
    push_mark(&c);
    // 3 kg m were too many by 2; as many again would be a pull.
    push_solve(&c, p, SMOOTH);
    is_near(c.pushed[NORMAL], 1, ROUNDING);
    push_lean(&c, 1);
    ck_assert(c.pushed[NORMAL] == 0);
    is_carried(&c, freely, 2);
    push_solve(&c, p, SMOOTH);
    is_near(c.pushed[NORMAL], 1, ROUNDING);
    is_near(p[0].position.y, 0, ROUNDING);
}
END_TEST

// Rejects: momentum that goes on when it has gone too far; a sum over contacts
// that forgets how far each push moves its points.
START_TEST(momentum_knows_when_it_leads_back)
{
    const struct { real last, from, pushed, leads; } way[] = {
        { 1, 1, 2, 1 }, { 1, 2, 3, 2 }, { 1, 3, 2, -1 }, { 1, 3, 0, 3 },
        { 2, 2, 1, 1 }, { 1, 3, 3, 0 }, { 1, 3, 1, 0 },
    };
    for (size_t k = 0; k < sizeof way / sizeof *way; k++)
        for (int d = 0; d < DIRECTIONS; d++) {
            push c = { .weight = { 0.5, 0.25, 2 } };
            c.last[d] = way[k].last;
            c.from[d] = way[k].from;
            c.pushed[d] = way[k].pushed;
            is_near(push_leads_on(&c), c.weight[d] * way[k].leads, 0);
        }
}
END_TEST

// A column of particles on a plane, each a metre above the last, pressed down.
static void make_column(push *c, int n)
{
    count = 0;
    for (int k = 0; k < n; k++) {
        vec3 x = vec3_make(0, k + 1, 0);
        add(x, vec3_add_scaled(x, -0.001, UP), 1);
        c[k] = k == 0 ? at_plane(of_particle(0), ZERO, UP, 1)
                      : contact_of(of_particle(k), of_particle(k - 1), UP, 1);
    }
}

// Pairs of passes until no gap changes by more than a millionth of the way that
// the column was pressed, with the momentum of lib/contact/solver.c, or without.
static int pairs_of_passes(push *c, int n, int with_momentum)
{
    real pace = 1;
    int pairs = 1;
    make_column(c, n);
    for (int k = 0; k < n; k++) push_mark(&c[k]);
    for (; pass_twice(c, n, SMOOTH) > 1e-9 && pairs < 10000; pairs++) {
        real leads_on = 0;
        for (int k = 0; k < n; k++) leads_on += push_leads_on(&c[k]);
        if (leads_on < 0) pace = 1;
        real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
        for (int k = 0; with_momentum && k < n; k++)
            push_lean(&c[k], (pace - 1) / next);
        pace = next;
    }
    return pairs;
}

// Passes alone shrink what is wrong in a column of n by 1 - 1/n^2; those with
// momentum by 1 - 1/n.
// Rejects: a lean that is taken back by the next pass, or leads elsewhere.
START_TEST(momentum_saves_most_of_the_passes_over_a_column)
{
    enum { BALLS = 40 };
    push c[BALLS];
    int alone = pairs_of_passes(c, BALLS, 0);
    int leaning = pairs_of_passes(c, BALLS, 1);
    ck_assert_msg(leaning < alone / 4, "%d pairs of passes, %d without",
                  leaning, alone);
    // What they end in is the same: each carries all above it.
    for (int k = 0; k < BALLS; k++)
        is_near(c[k].pushed[NORMAL], 0.001 * (BALLS - k), 1e-6);
}
END_TEST

// --- blows -------------------------------------------------------------------

// m: of a fall of 0.05 m, what 20 rounds over four corners leave.
#define LANDING 1e-6
// m: of a fall of 2 m, what a few hundred substeps round off.
#define TOUCHING 1e-12

static push_options bouncing(real restitution)
{
    return (push_options){ .restitution = restitution, .book = 1 };
}

// Of the contact's points, towards each other, in this substep.
static real closing_of(const push *c)
{
    return gap_of(c, 1) - gap_of(c, 0);
}

// Rejects: a bounce of the whole substep, as if they had met at its start; one
// that leaves the particle in the plane; the speed of the overlap.
START_TEST(particle_bounces_at_the_moment_of_touching)
{
    const real e[] = { 0, 0.5, 1 };
    for (int n = 0; n < 300; n++) {
        count = 0;
        vec3 normal = any_unit(), on = any_vec3();
        real high = between(0, 1), fall = high + between(0.01, 1);
        vec3 slid = vec3_cross(normal, any_vec3());
        vec3 start = vec3_add_scaled(on, high + 0.125, normal);
        int i = add(start, vec3_add(slid,
                                    vec3_add_scaled(start, -fall, normal)), 2);
        push c = at_plane(of_particle(i), on, normal, 0.125);
        real r = e[n % 3];
        ck_assert_int_eq(push_blow(&c, 1, p, bouncing(r), 0.001), 1);
        // It touches after high / fall of the substep, and has the rest of it
        // to rise at r times the speed.
        is_near(gap_of(&c, 0), r * (fall - high), ROUNDING);
        is_near(closing_of(&c), -r * fall, ROUNDING);
        is_near_vec3(slide_of(&c), slid, ROUNDING);
        for (int d = 0; d < DIRECTIONS; d++) ck_assert(c.pushed[d] == 0);
    }
}
END_TEST

// m above the plane, where a particle that rose and falls as a parabola is, was
// or will be at the top.
static real top_of(const particle *x, real g, real h)
{
    real speed = (x->position.y - x->previous.y) / h;
    real middle = (x->position.y + x->previous.y) / 2 + g * h * h / 8;
    return middle + speed * speed / (2 * g);
}

// The fall is a parabola within the substep, too.
// Rejects: the speed in the middle of the substep taken for that of the touch,
// and its moment for that of a straight line: 0.3 to 4.4 % of the height.
START_TEST(bounce_height_is_exact_whatever_the_substep)
{
    const real e[] = { 0.25, 0.5, 1 }, g = 9.81;
    for (int n = 0; n < 60; n++) {
        real h = 1.0 / (20 + 7 * n), high = between(0.5, 2), r = e[n % 3];
        count = 0;
        vec3 x = vec3_make(0, high, 0), gravity = vec3_scale(-g, UP);
        p[0] = particle_start(x, ZERO, gravity, 0.5, h);
        count = 1;
        push c = at_plane(of_particle(0), ZERO, UP, 0);
        push_options how = bouncing(r);
        how.fall = vec3_scale(h * h, gravity);
        int blows = 0;
        for (int k = 0; k < 400 && !blows; k++) {
            verlet_step(p, 1, gravity, NULL, h);
            blows = push_blow(&c, 1, p, how, 0.001 * h);
        }
        ck_assert(blows);
        is_near(top_of(&p[0], g, h), r * r * high, TOUCHING);
    }
}
END_TEST

// Who falls onto what is nailed comes faster and faster, who rises towards it
// slower and slower; two that both fall near each other evenly.
// Rejects: gravity counted for a pair that falls together; its sign for B.
START_TEST(only_a_fall_onto_the_immovable_is_a_parabola)
{
    const real g = 0.02, gap = 0.05, way = 0.1;
    for (int k = 1; k <= 3; k++) {
        count = 0;
        int a_falls = k & 1, b_falls = k & 2;
        int a = add(vec3_scale(gap, UP),
                    vec3_scale(a_falls ? gap - way : gap, UP), a_falls ? 2 : 0);
        int b = add(ZERO, vec3_scale(a_falls ? 0 : way, UP), b_falls ? 2 : 0);
        push c = contact_of(of_particle(a), of_particle(b), UP, 0);
        push_options how = bouncing(1);
        how.fall = vec3_scale(-g, UP);
        // Acceleration of the gap's closing, in m a substep squared.
        real more = k == 1 ? g : k == 2 ? -g : 0;
        real t = gap / way;
        for (int i = 0; i < 50; i++) t = gap / (way - (1 - t) * more / 2);
        ck_assert_int_eq(push_blow(&c, 1, p, how, 0.001), 1);
        is_near(-closing_of(&c), way + 2 * (t - 0.5) * more, TOUCHING);
    }
}
END_TEST

// It still rises when the substep begins, and falls back within it.
// Rejects: the first of the two times at which it passes the plane's height, or
// a search that swings between two others.
START_TEST(who_falls_back_within_a_substep_bounces_too)
{
    const real a = 0.05, rise = 0.005;
    for (int n = 0; n < 50; n++) {
        count = 0;
        real high = 0.0011 * (n % 25), e = n < 25 ? 1 : 0.5;
        add(vec3_make(0, high, 0), vec3_make(0, high + rise - a / 2, 0), 2);
        push c = at_plane(of_particle(0), ZERO, UP, 0);
        push_options how = bouncing(e);
        how.fall = vec3_scale(-a, UP);
        real over = rise * rise + 2 * a * high;
        int touches = high + rise - a / 2 < 0;
        ck_assert_int_eq(push_blow(&c, 1, p, how, 0.001), touches);
        if (!touches) continue;
        // high + rise t - a t^2 / 2 = 0, where it falls at sqrt(over).
        real t = (rise + sqrt(over)) / a, up = e * sqrt(over);
        is_near(-closing_of(&c), up + (t - 0.5) * a, ROUNDING);
        is_near(gap_of(&c, 0), up * (1 - t) - a * (1 - t) * (1 - t) / 2,
                ROUNDING);
    }
}
END_TEST

// Rejects: a bounce that is not shared by inverse mass; one that adds energy,
// or takes some with restitution 1.
START_TEST(particles_that_meet_head_on_part_at_restitution_times_their_speed)
{
    const real e[] = { 0, 0.5, 1 };
    for (int n = 0; n < 300; n++) {
        count = 0;
        real light = between(0.5, 1), heavy = light * between(1, 100);
        real u = between(0.2, 1), v = between(-0.1, 0.1), gap = between(0, 0.1);
        real r = e[n % 3], sum = light + heavy;
        int a = add(vec3_make(gap, 0, 0), vec3_make(gap - u, 0, 0), light);
        int b = add(ZERO, vec3_make(v, 0, 0), heavy);
        push c = contact_of(of_particle(a), of_particle(b),
                            vec3_make(1, 0, 0), 0);
        vec3 had = momentum();
        ck_assert_int_eq(push_blow(&c, 1, p, bouncing(r), 0.001), 1);
        is_near_vec3(momentum(), had, ROUNDING * heavy);
        // The textbook: each goes with the common speed, and r times its own
        // share of the closing.
        real common = (heavy * v - light * u) / sum, closing = u + v;
        real a_goes = common + r * closing * heavy / sum;
        real b_goes = common - r * closing * light / sum;
        is_near(p[a].position.x - p[a].previous.x, a_goes, ROUNDING);
        is_near(p[b].position.x - p[b].previous.x, b_goes, ROUNDING);
        // And each is where it is when it turned back after gap / closing.
        real t = gap / closing;
        is_near(p[a].position.x, gap - u * t + a_goes * (1 - t), ROUNDING);
        is_near(p[b].position.x, v * t + b_goes * (1 - t), ROUNDING);
    }
}
END_TEST

// Rejects: a blow of bodies that spins them wrongly: momentum, angular momentum
// or, with restitution 1, energy would change.
START_TEST(bodies_bounce_with_their_momentum_and_energy)
{
    for (int n = 0; n < 500; n++) {
        push c = two_boxes(0, between(0.05, 0.2), between(0, 0.2));
        vec3 linear = momentum(), angular = turning();
        real had = energy(), e = n % 2 ? 1 : between(0, 1);
        real closing = closing_of(&c);
        ck_assert_int_eq(push_blow(&c, 1, p, bouncing(e), 0.001), 1);
        is_near(closing_of(&c), -e * closing, ROUNDING);
        is_near_vec3(momentum(), linear, ROUNDING);
        is_near_vec3(turning(), angular, ROUNDING);
        if (e == 1) is_near(energy(), had, ROUNDING);
        else        ck_assert(energy() < had);
    }
}
END_TEST

// Rejects: friction that the blow forgets, or that outlives its cone.
START_TEST(blow_brakes_sliding_by_its_share)
{
    for (int n = 0; n < 200; n++) {
        real mu = between(0, 1), far = between(0, 1), e = between(0, 1);
        push c = rub(2, 0.5, vec3_make(far, 0, 0));
        push_options how = { .friction = mu, .restitution = e };
        ck_assert_int_eq(push_blow(&c, 1, p, how, 0.001), 1);
        is_near(p[0].position.x, fmax(0, far - mu * (1 + e) * 0.5), ROUNDING);
        is_near(p[0].position.y, e * 0.5, ROUNDING);
    }
}
END_TEST

// Before the blow the contact still holds what it pushed in the last substep.
// Rejects: a blow that takes back what was never given in this one.
START_TEST(blow_begins_with_nothing_pushed)
{
    for (int n = 0; n < 100; n++) {
        push c = rub(2, 0.5, vec3_make(0.25, 0, 0));
        const push_options how = { .friction = 0.5, .restitution = 0 };
        for (int d = 0; n > 0 && d < DIRECTIONS; d++)
            c.pushed[d] = between(0, 3);
        ck_assert_int_eq(push_blow(&c, 1, p, how, 0.001), 1);
        is_near_vec3(p[0].position, ZERO, ROUNDING);
    }
}
END_TEST

// Rejects: a bounce of the unrest of a pile; of what parts already; of what
// will not touch in this substep; rounding that decides whether what touches at
// its very end takes part.
START_TEST(slow_or_parting_contacts_are_no_blow)
{
    const struct { real before, now; int blow; } way[] = {
        { 0.1, -0.149, 0 }, { 0.1, -0.151, 1 }, { 0.5, 0.001, 0 },
        { 0.5, -0.001, 1 }, { 0.5, 0.0004, 1 }, { -0.5, -0.1, 0 },
        { 0, 0.5, 0 }, { -0.1, -0.149, 0 },
    };
    for (size_t k = 0; k < sizeof way / sizeof *way; k++) {
        count = 0;
        int i = add(vec3_scale(way[k].before, UP), vec3_scale(way[k].now, UP),
                    2);
        push c = at_plane(of_particle(i), ZERO, UP, 0);
        keep();
        ck_assert_int_eq(push_blow(&c, 1, p, bouncing(1), 0.25), way[k].blow);
        ck_assert_int_eq(nothing_moved(), !way[k].blow);
    }
}
END_TEST

// Rejects: corners that strike in turn, and leave the last word to the last
// one; the moment of touching settled corner by corner.
START_TEST(box_that_lands_flat_leaves_flat)
{
    const real e[] = { 0, 0.5, 1 };
    for (int n = 0; n < 30; n++) {
        push c[4];
        real high = n % 2 ? between(0, 0.02) : 0;
        real fall = high + between(0.01, 0.05), r = e[n % 3];
        vec3 move = { 0.01, -fall, -0.02 };
        stand(c, high, move);
        ck_assert_int_eq(push_blow(c, 4, p, bouncing(r), 0.001), 1);
        vec3 went = { 0.01, r * fall, -0.02 };
        for (int k = 0; k < FOUR; k++)
            is_near_vec3(vec3_sub(p[k].position, p[k].previous), went, LANDING);
        for (int k = 0; k < 4; k++)
            is_near(gap_of(&c[k], 0), r * (fall - high), LANDING);
    }
}
END_TEST

// The box leans on one edge of its foot, and falls without turning: two corners
// strike, the other two hang in the air.  An edge is struck as one point at its
// middle is: w = 1/m + r^2/I, r its distance from the centre, across the fall.
// Rejects: a blow at what does not touch; corners that share it unevenly; a
// turning that is not the solid's.
START_TEST(box_that_lands_on_an_edge_turns_as_a_rigid_one)
{
    for (int n = 0; n < 60; n++) {
        const int corner[] = { 0, 4, 1, 5 };
        real lean = between(0.05, 0.5), fall = between(0.01, 0.05);
        real e = n % 2 ? 1 : between(0, 1);
        axes m = { { cos(lean), sin(lean), 0 }, { -sin(lean), cos(lean), 0 },
                   { 0, 0, 1 } };
        vec3 foot = turned(&m, box.at[0]);
        push c[4];
        count = 0;
        int b = add_box(&m, vec3_make(0, -foot.y, 0), vec3_make(0, -fall, 0),
                        ZERO, 0);
        for (int k = 0; k < 4; k++) {
            int i = n % 3 ? k : 3 - k;
            c[i] = at_plane(of_box(b, box.at[corner[k]]), ZERO, UP, 0);
        }
        real had = energy();
        ck_assert_int_eq(push_blow(c, 4, p, bouncing(e), 0.001), 1);
        real inertia = 3 * (1 + 0.25) / 12;
        real weight = 1.0 / 3 + foot.x * foot.x / inertia;
        real given = (1 + e) * fall / weight;
        is_near_vec3(momentum(), vec3_make(0, given - 3 * fall, 0), LANDING);
        is_near(energy() - had, given * (given * weight / 2 - fall), LANDING);
        // Level along z: both corners part alike.
        for (int k = 0; k < 4; k++) {
            int i = n % 3 ? k : 3 - k;
            if (k < 2) is_near(-closing_of(&c[i]), e * fall, LANDING);
            else       ck_assert(closing_of(&c[i]) > fall);
        }
    }
}
END_TEST

// Two corners of one side land, the inner one slower: the blow at the outer one
// lifts it more than it asks for.
// Rejects: a blow that pulls, so that both part as each would alone.
START_TEST(blow_is_never_a_pull)
{
    for (int order = 0; order < 2; order++) {
        count = 0;
        int b = add_box(&UPRIGHT, vec3_make(0, 0.25, 0),
                        vec3_make(0, -0.01, 0), vec3_make(0, 0, -0.1), 0);
        push c[2];
        for (int k = 0; k < 2; k++) {
            vec3 r = { k == order ? 0.5 : 0.1, -0.25, 0 };
            c[k] = at_plane(of_box(b, r), vec3_make(r.x, 0, 0), UP, 0);
        }
        real slow = closing_of(&c[1 - order]), fast = closing_of(&c[order]);
        ck_assert(slow > 0 && fast > slow);
        ck_assert_int_eq(push_blow(c, 2, p, bouncing(0), 0.001), 1);
        is_near(closing_of(&c[order]), 0, ROUNDING);
        ck_assert_msg(closing_of(&c[1 - order]) <= ROUNDING, "it closes by %g",
                      closing_of(&c[1 - order]));
        // No more momentum than one blow at the outer corner gives.
        real weight = 1.0 / 3 + 0.25 / (3 * (1 + 0.25) / 12);
        is_near(momentum().y, -0.03 + fast / weight, ROUNDING);
    }
}
END_TEST

// Balls in a row that touch, and a quick one; contact k is between k and k + 1.
static void make_cradle(push *c, int balls, real gap)
{
    count = 0;
    for (int k = 0; k < balls; k++) {
        vec3 x = vec3_make(k - (k == 0) * gap, 0, 0);
        add(x, vec3_add(x, vec3_make((k == 0) * 0.25, 0, 0)), 3);
    }
    for (int k = 0; k + 1 < balls; k++)
        c[k] = contact_of(of_particle(k), of_particle(k + 1),
                          vec3_make(-1, 0, 0), 1);
}

// Rejects: a blow that is shared by the whole row; one that stops on its way;
// time lost at each of its stations.
START_TEST(blow_goes_through_a_cradle_whatever_the_order)
{
    enum { BALLS = 5, ROUNDS = 8 };
    for (int backwards = 0; backwards < 2; backwards++) {
        push c[BALLS];
        int again = 1, rounds = 0;
        make_cradle(c, BALLS, 0.0625);
        for (; again && rounds < ROUNDS; rounds++) {
            again = 0;
            for (int i = 0; i + 1 < BALLS; i++) {
                int k = backwards ? BALLS - 2 - i : i;
                again |= push_blow(&c[k], 1, p, bouncing(1), 0.001);
            }
        }
        ck_assert_int_eq(rounds, backwards ? BALLS : 2);
        for (int k = 0; k < BALLS; k++) {
            int last = k == BALLS - 1;
            is_near(p[k].position.x - p[k].previous.x, last * 0.25, ROUNDING);
            // A quarter of its way was over when the row was hit.
            is_near(p[k].position.x, k + last * 0.1875, ROUNDING);
        }
    }
}
END_TEST

// A particle of 3 kg between a floor, in which it lies by `old`, and which once
// took it up by `up`; and a ceiling that is 1 m over it.  Which comes first, as
// in a pile that is passed backward.  Does the ceiling push?
static int ceiling_pushes(real old, real up)
{
    static const int order[2] = { 1, 0 };
    const push_options how = { .mend = 1, .mend_speed = 1000 };
    push_drift drift[1 + PILE_PARTS];
    push_near near[2];
    count = 0;
    int i = add(ZERO, ZERO, 3);
    push c[2] = {
        at_plane(of_particle(i), vec3_make(0, old, 0), UP, 0),
        at_plane(of_particle(i), UP, vec3_scale(-1, UP), 0),
    };
    push_pile s = { c, order, { 2, 2, 2 }, drift, 1, near, { 0 } };
    drift[0] = (push_drift){ .stirred = 0 };
    c[0].pushed[NORMAL] = 3 * up;
    for (int k = 0; k < 2; k++) {
        c[k].near = HUGE_VAL;
        c[k].a.body = 0;
    }
    if (pile_begin(&s, PILE_LEFT, p, how, H)
        && pile_mend(&s, PILE_LEFT, how)) pile_settle(&s, PILE_LEFT);
    pile_pass(&s, PILE_LEFT, 1, 0, how);
    return c[1].pushed[NORMAL] > 0;
}

// A thousandth of the gap is no rounding.  (What the push takes up need not be
// mended: both together are as far as it lay in the floor.)
// Rejects: open contacts that nobody looks at, or with more room than they have;
// mending, or what is pushed once more, that takes no room.
START_TEST(open_contact_pushes_as_soon_as_its_room_is_used_up)
{
    ck_assert(ceiling_pushes(0, 1.001));
    ck_assert(!ceiling_pushes(0, 0.999));
    ck_assert(ceiling_pushes(1.001, 0.3));
    ck_assert(!ceiling_pushes(0.999, 0.3));
}
END_TEST

// Rejects: a crash, or an endless loop, over what is lost; a pushed NaN that is
// remembered as a push.
START_TEST(lost_numbers_do_no_harm)
{
    const push_options rough = { .friction = 0.5, .restitution = 1,
                                 .mend = 0.2, .mend_speed = 3 };
    push c = two_boxes(0, 0.1, 0.1);
    p[2].position.x = (real)NAN;
    push_again(&c);
    push_limit(&c, p, rough, H);
    push_mend(&c, p, rough);
    push_solve(&c, p, rough);
    push_blow(&c, 1, p, rough, 0.001);
    ck_assert(c.pushed[NORMAL] == 0);
    push_memory m = push_remember(&c, H);
    push_recall(&c, &m, H);
    ck_assert(c.pushed[NORMAL] == 0);
    for (int i = FOUR; i < 2 * FOUR; i++)
        ck_assert(vec3_is_finite(p[i].position));
}
END_TEST

int main(void)
{
    const TTest *const test[] = {
        directions_are_three_perpendicular_units,
        what_does_not_touch_is_left,
        particle_in_a_plane_is_put_onto_it,
        particles_part_by_their_inverse_masses,
        old_overlap_is_kept_but_not_deepened,
        push_is_never_a_pull,
        two_immovable_sides_are_left,
        bodies_part_as_rigid_ones_and_keep_their_momentum,
        answers_are_made_for_where_the_contacts_were_found,
        pushes_act_on_each_other_alike,
        nailed_body_gives_no_way,
        weights_and_skews_are_what_unit_pushes_do,
        hold_finds_the_push_in_all_three_directions_at_once,
        lever_too_long_to_hold_throws_nobody,
        friction_holds_whatever_is_within_the_cone,
        friction_brakes_by_exactly_its_share_of_the_push,
        friction_between_bodies_keeps_their_momentum,
        particle_slides_on_a_slope_as_coulomb_says,
        mending_moves_without_giving_speed,
        new_overlap_is_not_mended,
        overlap_that_parts_by_itself_is_left_to_go,
        slop_of_the_thickness_is_let_be,
        contacts_of_a_pair_mend_together_no_faster_than_one,
        memory_leaves_a_block_at_rest_nothing_to_do,
        memory_keeps_its_push_when_the_directions_turn,
        memories_of_several_contacts_add_up,
        memory_carries_the_same_weight_in_longer_substeps,
        work_of_the_memory_is_booked,
        lean_goes_on_by_its_share_of_the_last_change,
        lean_is_never_a_pull,
        open_contact_pushes_as_soon_as_its_room_is_used_up,
        momentum_knows_when_it_leads_back,
        momentum_saves_most_of_the_passes_over_a_column,
        particle_bounces_at_the_moment_of_touching,
        bounce_height_is_exact_whatever_the_substep,
        only_a_fall_onto_the_immovable_is_a_parabola,
        who_falls_back_within_a_substep_bounces_too,
        particles_that_meet_head_on_part_at_restitution_times_their_speed,
        bodies_bounce_with_their_momentum_and_energy,
        blow_brakes_sliding_by_its_share,
        blow_begins_with_nothing_pushed,
        slow_or_parting_contacts_are_no_blow,
        box_that_lands_flat_leaves_flat,
        box_that_lands_on_an_edge_turns_as_a_rigid_one,
        blow_is_never_a_pull,
        blow_goes_through_a_cradle_whatever_the_order,
        lost_numbers_do_no_harm,
    };
    Suite *s = suite_create("push");
    TCase *t = tcase_create("push");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof test / sizeof *test; i++)
        tcase_add_test(t, test[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
