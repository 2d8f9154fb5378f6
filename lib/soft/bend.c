//> bend-energy
//>   The energy: bending is a spring between three particles, pushed with
//>   (1, -2, 1), which add up to 0, so that momentum stays. The system M + h^2 K
//>   is positive definite, so elimination is stable for every stiffness, and the
//>   step never gives back more energy than was stored.
#include "bend.h"

#include <assert.h>
#include <stddef.h>

// A line of particles p[0], p[step], ... of a body.
typedef struct {
    const particle *p;
    int  step, n;
    real k;             // N/m, E I / L^3
} strand;

// Where three particles in a row stand off a straight line; -1 / L^2 times the
// curvature.  None around an end.
static vec3 bend_at(const strand *s, int i)
{
    if (i < 1 || i > s->n - 2) return (vec3){ 0, 0, 0 };
    const particle *p = s->p + i * s->step;
    vec3 ends = vec3_add(p[-s->step].position, p[s->step].position);
    return vec3_add_scaled(ends, -2, p->position);
}

// The strands of one direction share the width of a cloth.
static real strand_stiffness(const shape *s, strands of, int direction,
                             real stiffness)
{
    real l = of.rest_length;
    return stiffness * shape_width(s, direction) / (l * l * l);
}

real bend_energy(const shape *s, real stiffness, const particle *p)
{
    real sum = 0;
    for (int d = 0; d < shape_directions(s) && stiffness > 0; d++) {
        strands of = shape_strands(s, d);
        real k = strand_stiffness(s, of, d, stiffness);
        for (int line = 0; line < of.lines; line++) {
            strand x = { p + line * of.across, of.along, of.particles, k };
            for (int i = 1; i < x.n - 1; i++)
                sum += k / 2 * vec3_length_squared(bend_at(&x, i));
        }
    }
    return sum;
}
//<

//> bend-rows
//>   A row of the system, with pins left out.
// How often is i the left, the middle and the right of three?
static bool is_middle(const strand *s, int i)
{
    return i >= 1 && i <= s->n - 2;
}

static real mass_of(const strand *s, int i)
{
    return 1 / s->p[i * s->step].inverse_mass;
}

static bool is_free(const strand *s, int i)
{
    return i < s->n && s->p[i * s->step].inverse_mass > 0;
}

// Row i of (M + h^2 K) d = -h^2 K x, with K the sum over all threes of
// k (1, -2, 1)^T (1, -2, 1).  A pinned particle has d = 0.  stiff: h^2 k.
static bend_row row_of(const strand *s, int i, real stiff)
{
    bend_row row = { .pivot = 1 };
    if (!is_free(s, i)) return row;
    real left = is_middle(s, i + 1), middle = is_middle(s, i);
    real right = is_middle(s, i - 1);
    row.pivot = mass_of(s, i) + stiff * (left + 4 * middle + right);
    if (is_free(s, i + 1)) row.next = -2 * stiff * (middle + left);
    if (is_free(s, i + 2)) row.after = stiff * left;
    vec3 pull = vec3_add(bend_at(s, i + 1), bend_at(s, i - 1));
    row.move = vec3_scale(-stiff, vec3_add_scaled(pull, -2, bend_at(s, i)));
    return row;
}
//<

//> bend-solve
//>   Elimination looks like Thomas's, with two numbers kept in place of one.
// L D L^T: each row takes from the two that follow what it knows of them.
static void eliminate(bend_row *row, int i, int n)
{
    bend_row *at = &row[i];
    real next = at->next / at->pivot, after = at->after / at->pivot;
    if (i + 1 < n) {
        row[1 + i].pivot -= next * at->next;
        row[1 + i].next -= next * at->after;
        row[1 + i].move = vec3_add_scaled(row[1 + i].move, -next, at->move);
    }
    if (i + 2 < n) {
        row[2 + i].pivot -= after * at->after;
        row[2 + i].move = vec3_add_scaled(row[2 + i].move, -after, at->move);
    }
    at->move = vec3_scale(1 / at->pivot, at->move);
    at->next = next;
    at->after = after;
}

static bool solve(bend_row *row, int n)
{
    bool is_finite = true;
    for (int i = 0; i < n; i++) eliminate(row, i, n);
    for (int i = n - 1; i >= 0; i--) {
        vec3 *d = &row[i].move;
        if (i + 1 < n) *d = vec3_add_scaled(*d, -row[i].next, row[i + 1].move);
        if (i + 2 < n) *d = vec3_add_scaled(*d, -row[i].after, row[i + 2].move);
        is_finite = is_finite && vec3_is_finite(*d);
    }
    return is_finite;
}
//<

//> bend-relax
//>   The whole step, strand after strand.
int bend_rows(const shape *s)
{
    return int_max(int_max(s->columns, s->rows), 0);
}

static void relax_strand(const strand *s, particle *p, real h, bend_row *row)
{
    for (int i = 0; i < s->n; i++) row[i] = row_of(s, i, h * h * s->k);
    if (!solve(row, s->n)) return;
    for (int i = 0; i < s->n; i++) {
        particle *x = &p[i * s->step];
        if (x->inverse_mass > 0)
            x->position = vec3_add(x->position, row[i].move);
    }
}

void bend_relax(const shape *s, real stiffness, particle *p, real h,
                bend_row *room)
{
    assert(stiffness >= 0 && h > 0);
    for (int d = 0; d < shape_directions(s) && stiffness > 0; d++) {
        strands of = shape_strands(s, d);
        real k = strand_stiffness(s, of, d, stiffness);
        for (int line = 0; line < of.lines; line++) {
            particle *first = p + line * of.across;
            strand x = { first, of.along, of.particles, k };
            relax_strand(&x, first, h, room);
        }
    }
}
//<
