// family.c - see family.h.

#include "family.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

// ---- Vectors ---------------------------------------------------------------

tumble_vec3 v_add(tumble_vec3 a, tumble_vec3 b)
{
    return tumble_v(a.x + b.x, a.y + b.y, a.z + b.z);
}

tumble_vec3 v_sub(tumble_vec3 a, tumble_vec3 b)
{
    return tumble_v(a.x - b.x, a.y - b.y, a.z - b.z);
}

tumble_vec3 v_scale(double s, tumble_vec3 a)
{
    return tumble_v(s * a.x, s * a.y, s * a.z);
}

double v_dot(tumble_vec3 a, tumble_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

tumble_vec3 v_cross(tumble_vec3 a, tumble_vec3 b)
{
    return tumble_v(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                    a.x * b.y - a.y * b.x);
}

double v_length(tumble_vec3 a)
{
    return sqrt(v_dot(a, a));
}

double v_distance(tumble_vec3 a, tumble_vec3 b)
{
    return v_length(v_sub(a, b));
}

tumble_vec3 v_turn(tumble_quat q, tumble_vec3 a)
{
    double m[9];
    tumble_quat_matrix(q, m);
    return tumble_v(m[0] * a.x + m[1] * a.y + m[2] * a.z,
                    m[3] * a.x + m[4] * a.y + m[5] * a.z,
                    m[6] * a.x + m[7] * a.y + m[8] * a.z);
}

tumble_quat q_times(tumble_quat a, tumble_quat b)
{
    tumble_vec3 u = { a.x, a.y, a.z }, v = { b.x, b.y, b.z };
    tumble_vec3 c = v_add(v_cross(u, v),
                          v_add(v_scale(a.w, v), v_scale(b.w, u)));
    tumble_quat q = { c.x, c.y, c.z, a.w * b.w - v_dot(u, v) };
    return q;
}

// ---- Seeds -----------------------------------------------------------------

// SplitMix64, of Steele, Lea and Flood: three multiplications mix a counter.
double family_random(family_seed *s)
{
    family_seed z = *s += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) / 9007199254740992.0;      // 2^53
}

double family_between(family_seed *s, double least, double most)
{
    return least + (most - least) * family_random(s);
}

double family_log_between(family_seed *s, double least, double most)
{
    return exp(family_between(s, log(least), log(most)));
}

tumble_vec3 family_direction(family_seed *s)
{
    double z = family_between(s, -1, 1);
    double angle = family_between(s, 0, 2 * FAMILY_PI);
    double across = sqrt(1 - z * z);
    return tumble_v(across * cos(angle), across * sin(angle), z);
}

// Shoemake's: two circles, weighed so that every rotation is as likely.
tumble_quat family_rotation(family_seed *s)
{
    double u = family_random(s), a = family_between(s, 0, 2 * FAMILY_PI),
           b = family_between(s, 0, 2 * FAMILY_PI);
    tumble_quat q = { sqrt(1 - u) * sin(a), sqrt(1 - u) * cos(a),
                      sqrt(u) * sin(b), sqrt(u) * cos(b) };
    return q;
}

// ---- Worlds and shapes -----------------------------------------------------

tumble_options family_options(double dt, double friction)
{
    tumble_options o = tumble_options_default();
    o.dt = dt;
    o.friction = friction;
    return o;
}

void family_run(tumble_world *w, double seconds)
{
    double start = tumble_world_time(w), before = start;
    tumble_world_step(w);
    double dt = tumble_world_time(w) - before;
    // A step that failed does not advance time.
    if (!(dt > 0)) return;
    int steps = (int)(seconds / dt + 0.5);
    for (int n = 1; n < steps; n++) tumble_world_step(w);
}

tumble_shape family_prism(tumble_world *w, int corners, double radius,
                          double height, double mass)
{
    enum { MOST = 64 };
    tumble_vec3 point[2 * MOST];
    if (corners > MOST) corners = MOST;
    for (int i = 0; i < corners; i++) {
        double angle = 2 * FAMILY_PI * (i + 0.5) / corners;
        double x = radius * cos(angle), z = radius * sin(angle);
        point[i] = tumble_v(x, -height / 2, z);
        point[corners + i] = tumble_v(x, height / 2, z);
    }
    return tumble_shape_hull(w, point, 2 * corners, mass);
}

double family_energy(const tumble_world *w)
{
    tumble_measures m = tumble_world_measure(w);
    return m.kinetic + m.potential;
}

// ---- The worst of many trials ----------------------------------------------

void family_trial(family_worst *f, double error, const char *where, ...)
{
    f->trials++;
    if (!(error <= f->target)) f->beyond++;
    double worse = hard_worse(f->worst, error);
    if (f->trials > 1 && !(worse > f->worst)) return;
    f->worst = worse;
    va_list words;
    va_start(words, where);
    vsnprintf(f->where, sizeof f->where, where, words);
    va_end(words);
}

void family_add(hard_report *r, const family_worst *f, const char *unit,
                const char *what)
{
    hard_add(r, f->trials > 0 ? f->worst : HUGE_VAL, f->target, unit, "%s",
             what);
    hard_note(r, "of %s: %d of %d beyond the target, worst: %s", what, f->beyond,
              f->trials, f->where);
}

int family_ok(hard_report *r, const tumble_world *w)
{
    const char *why = tumble_world_failure(w);
    if (w && !why) return 1;
    hard_add(r, HUGE_VAL, 0, "", "nothing is refused");
    hard_note(r, "refused: %s", why ? why : "no world");
    return 0;
}
