//> little_stick 02a 09z
// --- Sticks -----------------------------------------------------------------

// Two particles, by their indices, that keep their distance.
typedef struct {
    int  a, b;
    real rest_length;   // m
} stick;

enum { STICKS = 40000 };
static stick sticks[STICKS];
static int stick_count;

// Joins two particles at the distance that they have.
static void stick_add(int a, int b)
{
    if (stick_count == STICKS) return;
    real d = vec3_distance(particles[a].position, particles[b].position);
    sticks[stick_count++] = (stick){ a, b, d };
}

// The largest |length / rest length - 1| of all sticks; NaN if there is one.
static real strain(void)
{
    real worst = 0;
    for (int i = 0; i < stick_count; i++) {
        const stick *s = &sticks[i];
        real d = vec3_distance(particles[s->a].position,
                               particles[s->b].position);
        real error = fabs(d / s->rest_length - 1);
        if (!(error <= worst)) worst = error;
    }
    return worst;
}
//<

//> little_spring 02a 02a
// A stick as a spring.  A force moves its particle by F dt^2 / m in a step: as
// if it had moved so much further in the last one.
static void spring_pull(const stick *s, real stiffness, real dt)
{
    particle *a = &particles[s->a], *b = &particles[s->b];
    vec3 along = vec3_sub(b->position, a->position);
    real force = stiffness * (vec3_length(along) - s->rest_length);     // N
    vec3 push = vec3_scale(force * dt * dt / vec3_length(along), along);
    a->previous = vec3_add_scaled(a->previous, -a->inverse_mass, push);
    b->previous = vec3_add_scaled(b->previous, b->inverse_mass, push);
}
//<

//> little_stick_halves 02b 02b
// Jakobsen's five lines: each end goes half of the way.
static void stick_relax(const stick *s)
{
    particle *a = &particles[s->a], *b = &particles[s->b];
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along), error = length - s->rest_length;
    a->position = vec3_add_scaled(a->position, error / (2 * length), along);
    b->position = vec3_add_scaled(b->position, -error / (2 * length), along);
}
//<

//> little_stick_relax 02c 09z
// Moves both ends along the stick until it has its rest length again, each in
// proportion to its inverse mass.
static void stick_relax(const stick *s)
{
    particle *a = &particles[s->a], *b = &particles[s->b];
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along);
    real weight = a->inverse_mass + b->inverse_mass;
    if (length == 0 || weight == 0) return;
    real k = (length - s->rest_length) / (length * weight);
    a->position = vec3_add_scaled(a->position, k * a->inverse_mass, along);
    b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, along);
}
//<

//> little_rope 02a 02c
// Forgets the last rope, and hangs up one of 1 m and 1 kg by one end, level.
static void hang_rope(int links)
{
    particle_count = stick_count = 0;
    for (int i = 0; i <= links; i++) {
        real mass = i > 0 ? 1.0 / links : 0;
        particle_add(vec3_make(i / (real)links, 0, 0), mass);
    }
    for (int i = 0; i < links; i++) stick_add(i, i + 1);
}
//<

//> little_rope_springs 02a 02a
static void rope_step(real stiffness, real dt)
{
    for (int i = 0; i < stick_count; i++)
        spring_pull(&sticks[i], stiffness, dt);
    particles_step(dt);
}
//<

//> little_rope_sticks 02b 02c
static void rope_step(int rounds, real dt)
{
    particles_step(dt);
    for (int r = 0; r < rounds; r++)
        for (int i = 0; i < stick_count; i++) stick_relax(&sticks[i]);
}
//<
