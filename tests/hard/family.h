// family.h - what the rows of the second list share: vectors, seeds, shapes,
// worlds, and the worst of many trials.  All of it through tumble.h.
//
// Units: metres, kilograms, seconds, radians.

#ifndef TUMBLE_FAMILY_H
#define TUMBLE_FAMILY_H

#include "hard.h"
#include "tumble.h"

#define FAMILY_PI 3.14159265358979323846
#define FAMILY_G  9.81                  // m/s^2, of tumble_options_default

// ---- Vectors ---------------------------------------------------------------

tumble_vec3 v_add(tumble_vec3 a, tumble_vec3 b);
tumble_vec3 v_sub(tumble_vec3 a, tumble_vec3 b);
tumble_vec3 v_scale(double s, tumble_vec3 a);
double      v_dot(tumble_vec3 a, tumble_vec3 b);
tumble_vec3 v_cross(tumble_vec3 a, tumble_vec3 b);
double      v_length(tumble_vec3 a);
double      v_distance(tumble_vec3 a, tumble_vec3 b);
// q applied to a, from the axes of a shape to the world's.
tumble_vec3 v_turn(tumble_quat q, tumble_vec3 a);
// First b, then a.
tumble_quat q_times(tumble_quat a, tumble_quat b);

// ---- Seeds -----------------------------------------------------------------

typedef unsigned long long family_seed;

// 0 to 1; from least to most; the same, evenly in its logarithm (least > 0).
double      family_random(family_seed *s);
double      family_between(family_seed *s, double least, double most);
double      family_log_between(family_seed *s, double least, double most);
tumble_vec3 family_direction(family_seed *s);       // of length 1
tumble_quat family_rotation(family_seed *s);        // evenly among all

// ---- Worlds and shapes -----------------------------------------------------

// The defaults, but for the step (s) and the friction of all bodies.
tumble_options family_options(double dt, double friction);

// Steps until `seconds` more have passed, and half a step is not begun.
void family_run(tumble_world *w, double seconds);

// An upright prism about y: a coin or a drum with so many corners.
tumble_shape family_prism(tumble_world *w, int corners, double radius,
                          double height, double mass);

// Kinetic and potential energy (J), from tumble_world_measure.
double family_energy(const tumble_world *w);

// ---- The worst of many trials ----------------------------------------------

// A number over a range of trials: the largest, where it was, and how many were
// beyond the target.  Begin with { .target = ... }.
typedef struct {
    double target, worst;
    int trials, beyond;
    char where[80];
} family_worst;

// Adds a trial, and the words of printf that say which.
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
void family_trial(family_worst *f, double error, const char *where, ...);

// Adds what the trials found as a number of the row: a row without a trial
// does not hold.  In a note: how many were beyond, and where the worst was.
void family_add(hard_report *r, const family_worst *f, const char *unit,
                const char *what);

// Says so, as a number that does not hold, if something failed in w (or w is
// NULL).  Returns 1 if all is well.
int family_ok(hard_report *r, const tumble_world *w);

#endif
