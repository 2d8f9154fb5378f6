//> actuator-set
//>   Motors and springs are set between two steps. As long as a joint has one of
//>   them, the row of its free way is always there, and holds its limits as well.
#include "actuator.h"

static const char *name_of(const joint *j)
{
    const char *name[JOINT_KINDS] = {
        "none", "ball joint", "hinge", "fixed joint", "distance", "pin", "slider"
    };
    return name[j->kind];
}

static status check_free_axis(const joint *j, const char *what)
{
    if (joint_is_free(j)) return status_ok();
    return status_fail("a %s has no free way: there is no %s for it", name_of(j),
                       what);
}

void actuator_set_limits(joint *j, real least, real most, bool has_limits)
{
    j->least = least;
    j->most = most;
    j->has_limits = has_limits;
    j->is_limited = has_limits && !j->is_driven;
}

status actuator_set_friction(joint *j, real torque)
{
    if (j->kind != JOINT_BALL)
        return status_fail("a %s is no ball joint: a motor of speed 0 is its "
                           "friction", name_of(j));
    if (!(torque >= 0 && torque < HUGE_VAL))
        return status_fail("a friction of %g N m is none: it must be finite, and "
                           "0 or more", torque);
    j->friction = torque;
    j->slips = false;
    j->extra = joint_ball_rows(j);
    for (int k = 3; k < JOINT_ROWS; k++) j->impulse[k] = 0;
    return status_ok();
}

// Its row becomes another one: what it gave is not what the new one gives.
static void arrange(joint *j)
{
    const joint_drive *d = &j->drive;
    bool is_driven = d->force > 0 || d->stiffness > 0 || d->damping > 0;
    if (is_driven != j->is_driven)
        for (int k = 0; k < JOINT_ROWS; k++) j->impulse[k] = 0;
    j->drive.is_new |= is_driven && !j->is_driven;
    j->is_driven = is_driven;
    j->extra = is_driven;
    j->given = 0;
    j->drive.limit = j->drive.motor = j->drive.spring = 0;
    actuator_set_limits(j, j->least, j->most, j->has_limits);
}

status actuator_set_motor(joint *j, real speed, real force)
{
    status done = check_free_axis(j, "motor");
    if (!done.ok) return done;
    if (!(fabs(speed) < HUGE_VAL && force >= 0))
        return status_fail("a motor of speed %g and force %g: the speed must be "
                           "finite, and the force 0 or more", speed, force);
    j->drive.speed = speed;
    j->drive.force = force;
    arrange(j);
    return done;
}

// A hinge's place is one of a turn, and its spring pulls the shorter way.
status actuator_set_spring(joint *j, real rest, real stiffness, real damping,
                           real bound)
{
    status done = check_free_axis(j, "spring");
    if (!done.ok) return done;
    if (!(fabs(rest) < HUGE_VAL && stiffness >= 0 && stiffness < HUGE_VAL
          && damping >= 0 && damping < HUGE_VAL && bound >= 0))
        return status_fail("a spring of stiffness %g and damping %g, to %g, of "
                           "%g at most: they must be finite, but for the most, "
                           "and, but for the place, 0 or more", stiffness,
                           damping, rest, bound);
    if (j->kind == JOINT_HINGE && fabs(rest) > JOINT_HALF_TURN)
        return status_fail("a hinge is never at %g rad: its angles go from -pi "
                           "to pi", rest);
    j->drive.rest = rest;
    j->drive.stiffness = stiffness;
    j->drive.damping = damping;
    j->drive.bound = bound;
    arrange(j);
    return done;
}
//<

//> actuator-inverse
//>   How hard is it to move a body along the free way of its joint? A door turns
//>   about its hinge, and not about its centre. So the row alone does not say it:
//>   it is the last number of the inverse of $`K`$, with the rows that hold.
real actuator_inverse(const joint_rows *r, real mass_a, real mass_b)
{
    real k[JOINT_ROWS][JOINT_ROWS];
    int last = r->held;
    for (int i = 0; i <= last; i++)
        for (int m = 0; m <= last; m++)
            k[i][m] = joint_coupling(JOINT_ROWS, r, i, m, mass_a, mass_b);
    small_invert(last + 1, k);
    return k[last][last] > 0 ? 1 / k[last][last] : 0;
}
//<

//> actuator-spring
//>   A spring that is asked where it is pushes too late: with a step of $`h`$ (s)
//>   and an angular frequency $`\omega`$ (rad/s) it gains energy if $`h \omega >
//>   2`$. Asked where it will be, it never does, but loses energy that it should
//>   keep. So it is asked for its mean in three substeps, $`(x_- + 2x + x_+)/4`$,
//>   which does neither (Newmark, 1959), and for the more of where it will be, the
//>   less the substep can follow it. The damper is likewise asked for a mean of
//>   the speeds before and after, and the stronger it is, the more of the one
//>   after.
// The way from one place to another; of an angle, the shorter one.
static real displacement(const joint *j, real from, real to)
{
    real d = to - from;
    if (j->kind != JOINT_HINGE) return d;
    if (d > JOINT_HALF_TURN)  return d - 2 * JOINT_HALF_TURN;
    return d < -JOINT_HALF_TURN ? d + 2 * JOINT_HALF_TURN : d;
}

// In a substep the spring gives pull - slope v, with v the speed at its end.
static void find_spring(const joint *j, joint_rows *r, real h)
{
    const joint_drive *d = &j->drive;
    real followed = h * h * d->stiffness * d->inverse;      // (h omega)^2
    real braked = h * d->damping * d->inverse;
    // The half of it is where it will be, if a Verlet step could not follow it.
    real late = followed / (4 + followed);
    real after = (1 + 3 * late) / 4, before = (1 - late) / 4;
    // exp(-x) is 1 / (1 + x + x^2 / 2) here: what it leaves of a speed.
    real later = (1 + braked) / (2 + braked);
    real left = displacement(j, r->error[r->held], d->rest);
    r->pull = r->kick * (d->stiffness * (left + h * before * r->before)
                         - d->damping * (1 - later) * r->before);
    r->slope = r->kick * (d->stiffness * h * after + d->damping * later);
}

// An impulse p moves what answers by K with p^2 K / 2; a spring has no more than
// is stored in it.
real actuator_energy(const joint *j, real place, real seconds)
{
    const joint_drive *d = &j->drive;
    real stretch = fabs(displacement(j, place, d->rest)), push = d->force * seconds;
    real stored = d->stiffness * stretch * stretch / 2;
    if (d->bound < HUGE_VAL) stored = real_min(stored, d->bound * stretch);
    real sum = sqrt(stored) + push * sqrt(d->inverse / 2);
    return sum * sum;
}

static real spring_at(const joint *j, const joint_rows *r, real speed)
{
    real most = j->drive.bound * r->kick;
    return real_max(real_min(r->pull - r->slope * speed, most), -most);
}
//<

//> actuator-law
//>   Each of the three says which speed goes with which impulse. A limit that
//>   pushes and a motor that can do what it should want a speed, at any impulse. A
//>   spring gives the less the faster it goes. What gives its most gives that at
//>   any speed, and is no row at all.
// Does a row want a speed, at any impulse?
static bool is_hard(const joint_drive *d)
{
    return d->limit != 0 || (d->motor == 0 && d->force > 0);
}

static bool is_spring(const joint_drive *d, const joint_rows *r)
{
    return !is_hard(d) && d->spring == 0 && r->slope > 0;
}

// What motor and spring give at no speed, if none of them holds.
static real given(const joint_drive *d, const joint_rows *r)
{
    real spring = d->spring == 0 ? r->pull : d->spring * d->bound * r->kick;
    return spring + d->motor * d->force * r->kick;
}

void actuator_begin(joint *j, joint_rows *r, real h, real kick)
{
    joint_drive *d = &j->drive;
    r->kick = d->is_new ? h / 2 : kick;
    d->is_new = false;
    find_spring(j, r, h);
    if (!is_hard(d) && !is_spring(d, r)) j->impulse[r->held] = given(d, r);
    r->kept = j->impulse[r->held];
}

static void soften(const joint *j, joint_rows *r, int n,
                   real k[JOINT_ROWS][JOINT_ROWS])
{
    int own = r->held;
    real hard = r->give[own];
    real give = is_spring(&j->drive, r) ? 1 / r->slope : hard;
    k[own][own] += give - hard;
    r->hard = hard;
    r->give[own] = give;
    if (is_hard(&j->drive) || is_spring(&j->drive, r)) return;
    for (int i = 0; i < n; i++) k[own][i] = k[i][own] = 0;
    r->give[own] = 0;
}

// From here to a limit, at its end; what has passed it comes back as errors do.
// (An angle comes back by radians, and a way by radii.)
static real speed_to(const joint *j, const joint_rows *r, int side, real h,
                     real joint_rate, bool is_over)
{
    real most = j->kind == JOINT_HINGE ? joint_rate : joint_rate * r->size;
    real left = (side < 0 ? j->least : j->most) - r->error[r->held];
    bool is_open = side < 0 ? left < 0 : left > 0;
    if (is_open)    return left / h;
    if (is_over)    return 0;
    return real_max(real_min(r->fraction * left / h, most), -most);
}

real actuator_bias(const joint *j, joint_rows *r, real h, real joint_rate,
                   const real *end, real speed)
{
    const joint_drive *d = &j->drive;
    real impulse = j->impulse[r->held];
    r->speed = end ? displacement(j, r->error[r->held], *end) / h : speed;
    for (int s = 0; s < 2; s++)
        r->room[s] = j->has_limits ? speed_to(j, r, 2 * s - 1, h, joint_rate, !end)
                                   : (2 * s - 1) * HUGE_VAL;
    if (d->limit != 0)
        return r->room[d->limit > 0] - r->hard * impulse - r->speed;
    // It gives way to what is new, so that a brake does not creep under a load.
    if (is_hard(d))
        return d->speed - r->speed - r->hard * (impulse - r->kept);
    if (is_spring(d, r))
        return (given(d, r) - impulse) / r->slope - r->speed;
    return 0;
}
//<

//> actuator-switch
//>   Which of them is at its end is not known beforehand. As with limits, the
//>   joint is solved, looked at, and solved again where something has changed.
// A limit holds, and would be left if it let go: then the motor, which gives its
// most one way or the other, brings more than all that is needed.
static void release_limit(joint_drive *d, const joint_rows *r, real needed)
{
    int off = -d->limit;
    bool helps = off * (d->speed - r->room[d->limit > 0]) > 0;
    if (!(off * needed < (helps ? 1 : -1) * d->force * r->kick)) return;
    d->limit = 0;
    d->motor = d->force > 0 && d->force < HUGE_VAL ? helps ? off : -off : 0;
}

// What it could not do it can, if the bodies come to be faster than it wants.
static void switch_motor(joint_drive *d, const joint_rows *r, real impulse,
                         real needed)
{
    real most = d->force * r->kick;
    real slip = r->speed - d->speed + r->hard * (impulse - r->kept);
    if (d->force == 0)              return;
    if (d->motor == 0)              d->motor = (needed > most) - (needed < -most);
    else if (d->motor * slip > 0)   d->motor = 0;
}

bool actuator_switch(joint *j, const joint_rows *r, real *more)
{
    joint_drive *d = &j->drive, was = *d;
    real impulse = j->impulse[r->held], most = d->bound * r->kick;
    real gives = r->pull - r->slope * r->speed;
    real needed = impulse - spring_at(j, r, r->speed);
    *more = 0;
    if (d->limit != 0)                  release_limit(d, r, needed);
    else if (r->speed < r->room[0])     d->limit = -1;
    else if (r->speed > r->room[1])     d->limit = 1;
    else                                switch_motor(d, r, impulse, needed);
    d->spring = (gives > most) - (gives < -most);
    if (d->limit == was.limit && d->motor == was.motor
        && d->spring == was.spring) return false;
    if (!is_hard(d) && !is_spring(d, r)) *more = given(d, r) - impulse;
    return true;
}
//<

//> actuator-cone
//>   Swing and twist of a ball joint are two limits, and each may hold without the
//>   other. Both rows are always there, and what does not hold is none, unless there
//>   is friction that holds.
static bool holds_cone(const joint *j, int i)
{
    return j->is_coned && i < 2 && j->cone_holds[i];
}

static void open_ball(const joint *j, joint_rows *r, int n,
                      real k[JOINT_ROWS][JOINT_ROWS])
{
    bool rubs = j->friction > 0 && !j->slips;
    for (int i = 0; i < j->extra; i++) {
        int own = r->held + i;
        r->firm[i] = r->give[own];
        if (holds_cone(j, i) || rubs) continue;
        for (int m = 0; m < n; m++) k[own][m] = k[m][own] = 0;
    }
}

void actuator_weigh(const joint *j, joint_rows *r, int n,
                    real k[JOINT_ROWS][JOINT_ROWS])
{
    if (j->kind == JOINT_BALL)  open_ball(j, r, n, k);
    else                        soften(j, r, n, k);
}

real actuator_bias_cone(const joint *j, joint_rows *r, int i, real h,
                        real joint_rate, const real *end, real speed)
{
    int k = r->held + i;
    real room = r->error[k], back = real_min(-r->fraction * room / h, joint_rate);
    if (!end)           r->cone_want[i] = -real_max(room, 0) / h - speed;
    else if (room > 0)  r->cone_want[i] = -*end / h;
    else                r->cone_want[i] = (room - *end) / h + back;
    if (end && j->cone_holds[i]) r->cone_want[i] -= r->give[k] * j->impulse[k];
    return j->cone_holds[i] ? r->cone_want[i] : 0;
}

bool actuator_switch_cone(joint *j, const joint_rows *r, real more[JOINT_ROWS])
{
    bool has_changed = false;
    for (int i = 0; i < 2; i++) {
        int k = r->held + i;
        bool pulls = j->cone_holds[i] && j->impulse[k] < 0;
        bool is_passed = !j->cone_holds[i] && r->cone_want[i] > 0;
        if (pulls) more[k] = -j->impulse[k];
        if (pulls || is_passed) j->cone_holds[i] = is_passed;
        has_changed |= pulls || is_passed;
    }
    return has_changed;
}
//<

//> actuator-friction
//>   Friction of a ball joint is a motor of no speed about three axes at once. What it
//>   gives is a vector, and not its parts but its length is bounded. While it slips
//>   it gives its most against the turning, and is no row.
static real size_of(const joint_rows *r, int i)
{
    return i == 1 ? r->twist_size : 1;
}

static real length_of_free(const joint *j, const joint_rows *r, const real *x,
                           bool are_speeds)
{
    real sum = 0;
    for (int i = 0; i < 3; i++) {
        real size = are_speeds ? 1 / size_of(r, i) : size_of(r, i);
        if (!holds_cone(j, i)) sum += size * size * x[i] * x[i];
    }
    return sqrt(sum);
}

void actuator_begin_friction(joint *j, joint_rows *r, real kick)
{
    real *p = &j->impulse[r->held];
    real speed = length_of_free(j, r, r->turning, true);
    r->kick = kick;
    for (int i = 0; i < 3; i++) {
        real size = size_of(r, i);
        if (j->slips && speed > 0 && !holds_cone(j, i))
            p[i] = -j->friction * kick * r->turning[i] / (size * size * speed);
        r->resisted[i] = p[i];
    }
}

real actuator_bias_friction(const joint *j, const joint_rows *r, int i)
{
    real more = j->impulse[r->held + i] - r->resisted[i];
    return j->slips ? 0 : -r->turning[i] - r->firm[i] * more;
}

bool actuator_switch_friction(joint *j, const joint_rows *r,
                              real more[JOINT_ROWS])
{
    const real *p = &j->impulse[r->held];
    real most = j->friction * r->kick, helps = 0;
    real gives = length_of_free(j, r, p, false);
    if (!j->slips && !(gives > most)) return false;
    for (int i = 0; i < 3; i++) {
        if (holds_cone(j, i)) continue;
        helps += p[i] * r->turning[i];
        if (!j->slips) more[r->held + i] = (most / gives - 1) * p[i];
    }
    // It would push on what has come to rest.
    if (j->slips && !(helps > 0)) return false;
    j->slips = !j->slips;
    return true;
}
//<
