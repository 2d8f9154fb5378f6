//> little_strand 12a 12z 16a
// --- Strands: rope, and the threads of cloth ---------------------------------

// Particles in a row, and links of one length between them.
enum { STRANDS = 400, LINKS = 200 };
typedef struct {
    int  links, at[LINKS + 1];
    real rest_length;           // m
//<
//> little_strand_over 16a
    real over;                  // asks for so much of the error
//<
//> little_strand_pull 12c 12z
    real pull[LINKS];           // kg m, of the last step, along each link
//<
//> little_strand_end 12a 12z 16a
} strand;

static strand strands[STRANDS];
static int    strand_count;

// A strand of so many particles, `stride` apart in the list.
static strand *strand_add(int first, int stride, int links, real rest_length)
{
    strand *s = &strands[strand_count < STRANDS ? strand_count++ : 0];
    *s = (strand){ .links = links, .rest_length = rest_length };
    for (int i = 0; i <= links; i++) s->at[i] = first + i * stride;
//<
//> little_strand_add_over 16a
    s->over = 1;
//<
//> little_strand_added 12a 12z 16a
    return s;
}

static vec3 strand_link(const strand *s, int i)
{
    return vec3_sub(particles[s->at[i + 1]].position,
                    particles[s->at[i]].position);
}

// The largest |length / rest length - 1| of all links.
static real strain(void)
{
    real worst = 0;
    for (const strand *s = strands; s < strands + strand_count; s++)
        for (int i = 0; i < s->links; i++) {
            real length = vec3_length(strand_link(s, i));
            worst = real_max(worst, fabs(length / s->rest_length - 1));
        }
    return worst;
}
//<

//> little_strand_one_by_one 12a 12a
// Corrects one link after the other, as chapter 02 does.
static void strand_solve(strand *s)
{
    for (int i = 0; i < s->links; i++) {
        particle *a = &particles[s->at[i]], *b = &particles[s->at[i + 1]];
        vec3 along = strand_link(s, i);
        real length = vec3_length(along), error = length - s->rest_length;
        real k = error / (length * (a->inverse_mass + b->inverse_mass));
        a->position = vec3_add_scaled(a->position, k * a->inverse_mass, along);
        b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, along);
    }
}
//<

//> little_hold 16e
static vec3 held[PARTICLES];    // 1/sqrt(kg), along the normal of what holds it
//<

//> little_between 12b 12z 16a 16d
// How far particle i goes along u for a pull along v.
static real pull_between(int i, vec3 u, vec3 v)
{
    return particles[i].inverse_mass * vec3_dot(u, v);
}

static void particle_pull(int i, vec3 pull)
{
    vec3 *x = &particles[i].position;
    *x = vec3_add_scaled(*x, particles[i].inverse_mass, pull);
}
//<
//> little_between_held 16e
// How far particle i goes along u for a pull along v: by W = w (1 - n n^T), if
// something with the normal n holds it.
static real pull_between(int i, vec3 u, vec3 v)
{
    real along = vec3_dot(held[i], u) * vec3_dot(held[i], v);
    return particles[i].inverse_mass * vec3_dot(u, v) - along;
}

// What holds a particle holds it from outside: a pull away from it is free.
static void particle_pull(int i, vec3 pull)
{
    vec3 *x = &particles[i].position;
    real into = vec3_dot(held[i], pull);
    *x = vec3_add_scaled(*x, particles[i].inverse_mass, pull);
    if (into < 0) *x = vec3_add_scaled(*x, -into, held[i]);
}
//<

//> little_strand_thomas 12b 12z 16a
// All links at once: the pulls that correct them solve a system with three
// diagonals.  Thomas's algorithm walks down, and up again.  u: the unit links;
// g: on entry the errors (m), on exit the pulls (kg m).
static void strand_pulls(const strand *s, const vec3 *u, real *g)
{
    real up[LINKS];
    for (int i = 0; i < s->links; i++) {
        int a = s->at[i], b = s->at[i + 1];
        real lower = i > 0 ? -pull_between(a, u[i], u[i - 1]) : 0;
        real pivot = pull_between(a, u[i], u[i])
                   + pull_between(b, u[i], u[i]) + 1e-12;
//<
//> little_strand_spare 16e
        // Between two that are held a link does not ask for quite all.
        pivot += 0.005 * vec3_dot(held[a], held[a]);
        pivot += 0.005 * vec3_dot(held[b], held[b]);
//<
//> little_strand_thomas_down 12b 12z 16a
        if (i > 0) {
            pivot -= lower * up[i - 1];
            g[i] -= lower * g[i - 1];
        }
        up[i] = i + 1 < s->links ? -pull_between(b, u[i], u[i + 1]) / pivot : 0;
        g[i] /= pivot;
    }
    for (int i = s->links - 2; i >= 0; i--) g[i] -= up[i] * g[i + 1];
}

// One step of Newton's method.  The last link of a particle pulls it on, the
// one before it back.
static void strand_solve(strand *s)
{
    vec3 u[LINKS], back = { 0, 0, 0 };
    real g[LINKS];
    for (int i = 0; i < s->links; i++) {
        u[i] = strand_link(s, i);
        g[i] = vec3_length(u[i]) - s->rest_length;
        u[i] = vec3_unit(u[i]);
    }
    strand_pulls(s, u, g);
    for (int i = 0; i <= s->links; i++) {
        vec3 on = { 0, 0, 0 };
        if (i < s->links) {
//<
//> little_strand_keep_pull 12c 12z
            s->pull[i] += g[i];
//<
//> little_strand_pull_plain 12b 12z
            on = vec3_scale(g[i], u[i]);
//<
//> little_strand_pull_over 16a
            on = vec3_scale(s->over * g[i], u[i]);
//<
//> little_strand_thomas_end 12b 12z 16a
        }
        particle_pull(s->at[i], vec3_sub(on, back));
        back = on;
    }
}
//<

//> little_string 12c 12z
// A taut strand is a string: pulls as strong as in the last step act along the
// links as they lie afterwards.  Three diagonals again.
static void strand_string(strand *s)
{
    vec3 y[LINKS + 1];
    real up[LINKS + 1], a = 0, b = 0, taut = 0;
    for (int i = 0; i <= s->links; i++, a = b) {
        particle *p = &particles[s->at[i]];
        b = i < s->links ? real_max(0, s->pull[i] / s->rest_length) : 0;
        taut = real_max(taut, p->inverse_mass * b);
        real wa = p->inverse_mass * a, wb = p->inverse_mass * b;
        real pivot = 1 + wa + wb - (i > 0 ? wa * up[i - 1] : 0);
        vec3 sum = i > 0 ? vec3_add_scaled(p->position, wa, y[i - 1])
                         : p->position;
        up[i] = wb / pivot;
        y[i] = vec3_scale(1 / pivot, sum);
    }
    for (int i = 0; i < s->links; i++)
        s->pull[i] = taut < 0.1 ? 0 : real_max(0, s->pull[i]);
    if (taut < 0.1) return;
    for (int i = s->links; i >= 0; i--) {
        if (i < s->links) y[i] = vec3_add_scaled(y[i], up[i], y[i + 1]);
        particles[s->at[i]].position = y[i];
    }
}
//<

//> little_rope_hang 12a 12z
// A rope of 1 m and 1 kg, level, pinned at one end, with a load at the other.
static void hang_rope(int links, real load)
{
    particle_count = strand_count = 0;
    for (int i = 0; i <= links; i++) {
        real mass = i == 0 ? 0 : i < links ? 1.0 / links : load;
        particle_add(vec3_make(i / (real)links, 0, 0), mass);
    }
    strand_add(0, 1, links, 1.0 / links);
}

static void rope_step(int rounds, real dt)
{
    particles_step(dt);
//<
//> little_rope_string 12c 12z
    strand_string(&strands[0]);
//<
//> little_rope_rounds 12a 12z
    for (int r = 0; r < rounds; r++) strand_solve(&strands[0]);
}
//<
