// check_contact.c - do gaps follow the bodies, and impulses their points?
// Book: chapter 13.

#include "contact.h"
#include "solids.h"
#include "suite.h"

static const vec3 UP = { 0, 1, 0 }, ZERO = { 0, 0, 0 };

static rigid_frame any_frame(vec3 at)
{
    matrix m = any_rotation();
    return (rigid_frame){ at, { vec3_scale(0.3, m.x), vec3_scale(0.5, m.y),
                                vec3_scale(0.2, m.z) } };
}

static contact_point any_point(void)
{
    return (contact_point){ .local_a = random_vec3(&seed, 1),
                            .local_b = random_vec3(&seed, 1),
                            .own = floor(3 * random_fraction(&seed)) / 2 };
}

// --- gaps --------------------------------------------------------------------

// Two boxes of a metre, one on the other, whose cores overlap by 1 cm; the lower one
// is round by 2 cm.  A then rises by 3 cm and turns by a small angle.
// Rejects: heights of the corners at rest; a normal the other way round; a roundness
// that is left out, or has the wrong sign.
START_TEST(gaps_are_those_of_the_points_by_hand)
{
    const vec3 axis[3] = { { 0.5, 0, 0 }, { 0, 0.5, 0 }, { 0, 0, 0.5 } };
    rigid_frame a = { { 0, 1.49, 0 }, { axis[0], axis[1], axis[2] } };
    rigid_frame b = { { 0, 0.5, 0 }, { axis[0], axis[1], axis[2] } };
    contact c = { .a = 0, .b = 1, .count = 2, .normal = UP, .round_b = 0.02,
                  .point = { { .local_a = { 1, -1, 1 },
                               .local_b = { 1, 1, 1 } },
                             { .local_a = { -1, -1, 1 },
                               .local_b = { -1, 1, 1 } } } };
    real gap[CONTACT_POINTS];
    contact_gaps(&c, &a, &b, 0, gap);
    ck_assert(fabs(gap[0] + 0.03) <= ROUNDING);
    ck_assert(fabs(gap[1] + 0.03) <= ROUNDING);
    a.center.y += 0.03;
    a.axis[0] = vec3_make(0.4, 0.3, 0);
    a.axis[1] = vec3_make(-0.3, 0.4, 0);
    contact_gaps(&c, &a, &b, 0, gap);
    ck_assert(fabs(gap[0] - (1.52 + 0.3 - 0.4 - 1.02)) <= ROUNDING);
    ck_assert(fabs(gap[1] - (1.52 - 0.3 - 0.4 - 1.02)) <= ROUNDING);
}
END_TEST

// Rejects: an axis of the other body; the centre left out.
START_TEST(gaps_follow_bodies_wherever_they_go)
{
    for (int n = 0; n < 500; n++) {
        rigid_frame a = any_frame(random_vec3(&seed, 3));
        rigid_frame b = any_frame(random_vec3(&seed, 3));
        contact c = { .a = 3, .b = 5, .count = n % 5,
                      .round_a = random_fraction(&seed),
                      .round_b = random_fraction(&seed),
                      .normal = random_direction(&seed) };
        for (int k = 0; k < c.count; k++) c.point[k] = any_point();
        real gap[CONTACT_POINTS];
        contact_gaps(&c, &a, &b, 17, gap);
        for (int k = 0; k < c.count; k++) {
            vec3 d = vec3_sub(frame_point(&a, c.point[k].local_a),
                              frame_point(&b, c.point[k].local_b));
            real wanted = vec3_dot(c.normal, d) - c.round_a - c.round_b;
            ck_assert(fabs(gap[k] - wanted) <= 10 * ROUNDING);
        }
    }
}
END_TEST

// Rejects: a plane through the origin, or on the wrong side of it.
START_TEST(gap_to_a_plane_is_the_height_over_it)
{
    for (int n = 0; n < 200; n++) {
        rigid_frame a = any_frame(random_vec3(&seed, 1));
        contact c = { .a = 0, .b = contact_with_plane(n % 3), .count = 3,
                      .round_a = random_fraction(&seed),
                      .normal = random_direction(&seed) };
        ck_assert_int_eq(-1 - c.b, n % 3);
        for (int k = 0; k < 3; k++) c.point[k] = any_point();
        real gap[CONTACT_POINTS], height = random_real(&seed);
        contact_gaps(&c, &a, NULL, height, gap);
        for (int k = 0; k < 3; k++) {
            vec3 x = frame_point(&a, c.point[k].local_a);
            real wanted = vec3_dot(c.normal, x) - height - c.round_a;
            ck_assert(fabs(gap[k] - wanted) <= 10 * ROUNDING);
        }
    }
}
END_TEST

// --- arms --------------------------------------------------------------------

// A vertex pushes where it is, two edges halfway between them; and each of the two
// sides is where its own body has it.
// Rejects: an arm from the origin; a place that is not the same for both; a side
// that is moved there; the vertex of the other body.
START_TEST(impulses_act_at_one_place_between_both_sides)
{
    for (int n = 0; n < 200; n++) {
        rigid_frame a = any_frame(random_vec3(&seed, 1)),
            b = any_frame(random_vec3(&seed, 1));
        contact c = { .b = n % 4 ? 1 : -1, .count = 4 };
        const rigid_frame *to = c.b < 0 ? NULL : &b;
        for (int k = 0; k < 4; k++) {
            contact_point p = c.point[k] = any_point();
            contact_arms side = contact_sides_of(&c, k, &a, to);
            contact_arms arm = contact_arms_of(&c, k, &a, to);
            vec3 on_a = frame_point(&a, p.local_a);
            vec3 on_b = frame_point(&b, p.local_b);
            vec3 place = vec3_add(vec3_scale(p.own, on_a),
                                  vec3_scale(1 - p.own, on_b));
            if (c.b < 0) on_b = b.center;
            ck_assert(vec3_distance(vec3_add(a.center, side.a), on_a)
                      <= 10 * ROUNDING);
            ck_assert(vec3_distance(vec3_add(b.center, side.b), on_b)
                      <= 10 * ROUNDING);
            if (c.b >= 0) on_a = on_b = place;
            ck_assert(vec3_distance(vec3_add(a.center, arm.a), on_a)
                      <= 10 * ROUNDING);
            ck_assert(vec3_distance(vec3_add(b.center, arm.b), on_b)
                      <= 10 * ROUNDING);
        }
    }
}
END_TEST

// --- impulses ----------------------------------------------------------------

START_TEST(load_is_the_sum_of_the_impulses)
{
    contact c = { .count = 3 };
    for (int k = 0; k < CONTACT_POINTS; k++) c.impulse[k] = k + 1;
    ck_assert(contact_load(&c) == 6);
    c.count = 0;
    ck_assert(contact_load(&c) == 0);
}
END_TEST

// Rejects: an impulse that is lost, or given to two; one that goes to the point
// that happens to have its number; friction of before that is left out.
START_TEST(each_impulse_goes_to_the_nearest_new_point)
{
    for (int n = 0; n < 2000; n++) {
        contact was = { .count = n % 5, .normal = UP,
                        .friction = random_vec3(&seed, 1),
                        .twist = random_real(&seed) };
        contact now = { .count = n / 5 % 5, .normal = UP };
        real wanted[CONTACT_POINTS] = { 0 };
        for (int k = 0; k < was.count; k++) {
            was.point[k] = any_point();
            was.impulse[k] = 1 + random_real(&seed);
        }
        for (int k = 0; k < now.count; k++) now.point[k] = any_point();
        for (int k = 0; k < was.count && now.count > 0; k++) {
            int best = 0;
            for (int j = 1; j < now.count; j++)
                if (vec3_distance(now.point[j].local_a, was.point[k].local_a)
                    < vec3_distance(now.point[best].local_a,
                                    was.point[k].local_a)) best = j;
            wanted[best] += was.impulse[k];
        }
        contact_inherit(&now, &was);
        for (int k = 0; k < now.count; k++)
            ck_assert(now.impulse[k] == wanted[k]);
        if (now.count > 0) {
            ck_assert(fabs(contact_load(&now) - contact_load(&was))
                      <= ROUNDING * 10);
            ck_assert(vec3_distance(now.friction, was.friction) == 0);
            ck_assert(now.twist == was.twist);
        } else {
            ck_assert(vec3_distance(now.friction, ZERO) == 0);
            ck_assert(now.twist == 0);
        }
    }
}
END_TEST

// A heavy body rolls over a light one: what pushed it up pushes it aside now.
// Rejects: a load along a normal that it has never had.
START_TEST(impulses_along_another_normal_are_forgotten)
{
    for (int n = 0; n < 1000; n++) {
        contact was = { .count = 3, .normal = random_direction(&seed),
                        .friction = random_vec3(&seed, 1), .twist = 1 };
        contact now = { .count = 4, .normal = random_direction(&seed) };
        for (int k = 0; k < 3; k++) {
            was.point[k] = any_point();
            was.impulse[k] = 1 + k;
        }
        for (int k = 0; k < 4; k++) now.point[k] = any_point();
        contact_inherit(&now, &was);
        bool is_near = vec3_dot(now.normal, was.normal) >= 0.7;
        ck_assert(fabs(contact_load(&now) - (is_near ? 6 : 0)) <= ROUNDING);
        ck_assert(now.twist == (is_near ? 1 : 0));
        ck_assert((vec3_length(now.friction) > 0) == is_near);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        gaps_are_those_of_the_points_by_hand,
        gaps_follow_bodies_wherever_they_go,
        gap_to_a_plane_is_the_height_over_it,
        load_is_the_sum_of_the_impulses,
        impulses_act_at_one_place_between_both_sides,
        each_impulse_goes_to_the_nearest_new_point,
        impulses_along_another_normal_are_forgotten,
        NULL
    };
    return suite_run((suite){
        .name = "contact", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
