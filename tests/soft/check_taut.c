// check_taut.c - tests of lib/soft/taut.c, a string stepped by the pull at the
// substep's end.  Each names the mistake that it rejects.

#include "taut.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>

static const real PI = 3.14159265358979323846;
static const vec3 NOTHING = { 0, 0, 0 };

static unsigned long long seed = 1;

// ------------------------------------------------------------ a string alone

enum { MOST = 40 };

static real x[MOST], y[MOST], z[MOST], weight[MOST], stiffness[MOST];

static void step(int n, int along)
{
    real room[4 * MOST];
    taut_step((taut_string){ n, along, x, y, z, weight, stiffness }, room);
}

// Rejects: an elimination that is none.  Each particle must stand where the
// pulls of the links, as they are now, have taken it.
START_TEST(links_pull_by_what_is_between_their_ends_afterwards)
{
    for (int round = 0; round < 20; round++) {
        int n = 2 + round % 12, along = 1 + round % 3;
        real was[MOST];
        for (int i = 0; i < n * along; i++) {
            was[i] = x[i] = random_real(&seed);
            y[i] = z[i] = 0;
            weight[i] = random_fraction(&seed) < 0.2
                      ? 0 : random_between(&seed, 0.1, 10);
        }
        for (int k = 0; k + 1 < n; k++)
            stiffness[k] = random_fraction(&seed) < 0.2
                         ? 0 : random_between(&seed, 0, 50);
        step(n, along);
        for (int k = 0; k < n; k++) {
            int i = k * along;
            real pull = 0;
            if (k + 1 < n) pull += stiffness[k] * (x[i + along] - x[i]);
            if (k > 0) pull -= stiffness[k - 1] * (x[i] - x[i - along]);
            near(x[i], was[i] + weight[i] * pull, 1e-12, "place");
        }
        for (int i = 0; i < n * along; i++)
            if (i % along) ck_assert(x[i] == was[i]);
    }
}
END_TEST

// Rejects: a pull without its counterpart; one along another line than that
// between the ends.
START_TEST(string_keeps_momentum_and_angular_momentum)
{
    enum { N = 17 };
    vec3 was[N], sum = NOTHING, turn = NOTHING;
    for (int i = 0; i < N; i++) {
        was[i] = random_vec3(&seed, 1);
        x[i] = was[i].x;
        y[i] = was[i].y;
        z[i] = was[i].z;
        weight[i] = random_between(&seed, 0.1, 10);
        stiffness[i] = random_between(&seed, 0, 50);
    }
    step(N, 1);
    for (int i = 0; i < N; i++) {
        vec3 now = vec3_make(x[i], y[i], z[i]);
        vec3 push = vec3_scale(1 / weight[i], vec3_sub(now, was[i]));
        sum = vec3_add(sum, push);
        turn = vec3_add(turn, vec3_cross(now, push));
    }
    near_vec3(sum, NOTHING, 1e-11, "momentum");
    near_vec3(turn, NOTHING, 1e-11, "angular momentum");
}
END_TEST

// Between two pins, n links: mode j has s = 4 T h^2 / (m L) sin^2(j pi / 2 n).
// Verlet and the string's step take it round by the angle atan(sqrt(s)), and
// leave 1 / sqrt(1 + s) of it.  Rejects: a string that is not one; one that
// loses of a slow motion more than Euler's step must; a fast one that grows.
START_TEST(each_mode_of_a_string_turns_and_dies_as_it_should)
{
    enum { LINKS = 20, STEPS = 200 };
    static const real share[3] = { 0.25, 10, 1e6 };
    for (int round = 0; round < 3; round++)
        for (int j = 1; j < LINKS; j += 6) {
            real before[LINKS + 1], half = sin(j * PI / (2 * LINKS));
            real s = 4 * share[round] * half * half, left = 1 / sqrt(1 + s);
            real turn = atan(sqrt(s));
            for (int i = 0; i <= LINKS; i++) {
                real mode = sin(j * PI * i / LINKS);
                x[i] = before[i] = mode;
                before[i] = mode * cos(turn) / left;   // a substep earlier
                y[i] = z[i] = 0;
                weight[i] = i > 0 && i < LINKS ? 3 : 0;
                stiffness[i] = share[round] / 3;
            }
            real most = 1;
            for (int k = 1; k <= STEPS; k++) {
                for (int i = 0; i <= LINKS; i++) {
                    real now = x[i];
                    x[i] += weight[i] > 0 ? now - before[i] : 0;
                    before[i] = now;
                }
                step(LINKS + 1, 1);
                most *= left;
                for (int i = 0; i <= LINKS; i++)
                    near(x[i], most * cos(k * turn) * sin(j * PI * i / LINKS),
                         1e-10, "mode");
            }
        }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        links_pull_by_what_is_between_their_ends_afterwards,
        string_keeps_momentum_and_angular_momentum,
        each_mode_of_a_string_turns_and_dies_as_it_should,
        NULL
    };
    return suite_run((suite){ .name = "taut", .tests = tests });
}
