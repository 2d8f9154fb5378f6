//> little_particle_euler 00a 01a
// --- Particles --------------------------------------------------------------

typedef struct {
    vec3 position;      // m
    vec3 velocity;      // m/s
} particle;
//<

//> little_particle 01b 09z 12a
// --- Particles --------------------------------------------------------------

// A point mass.  It stores no velocity: it remembers where it was.
typedef struct {
    vec3 position;      // m, now
    vec3 previous;      // m, one step ago
//<
//> little_particle_mass 02a 09z 12a
    real inverse_mass;  // 1/kg; 0: pinned, nothing moves it
//<
//> little_particle_end 01b 09z 12a
} particle;
//<

//> little_gravity 00a 09z 12a 12z 13c
static const vec3 gravity = { 0, -9.81, 0 };    // m/s^2
//<

//> little_euler 00a 01a
// One step of dt (s) by explicit Euler: first move, then change the velocity.
static void euler_step(particle *p, vec3 acceleration, real dt)
{
    p->position = vec3_add_scaled(p->position, dt, p->velocity);
    p->velocity = vec3_add_scaled(p->velocity, dt, acceleration);
}
//<

//> little_verlet_start 01b 01b
// A particle at x (m) with the velocity v (m/s), before its first step.
static particle particle_start(vec3 x, vec3 v, vec3 acceleration, real dt)
{
    vec3 before = vec3_add_scaled(x, -dt, v);
    return (particle){ x, vec3_add_scaled(before, dt * dt / 2, acceleration) };
}
//<

//> little_verlet 01b 09z 12a 12z 16a
// One step of dt (s) by Verlet: as far again as in the last step, and a dt^2.
static void verlet_step(particle *p, vec3 acceleration, real dt)
{
    vec3 moved = vec3_sub(p->position, p->previous);
    p->previous = p->position;
    p->position = vec3_add_scaled(p->position, 1, moved);
    p->position = vec3_add_scaled(p->position, dt * dt, acceleration);
}
//<

//> little_bounce_euler 00a 01a
// The floor at y = 0 turns the velocity round.
static void bounce(particle *p)
{
    if (p->position.y < 0 && p->velocity.y < 0) p->velocity.y *= -1;
}

// J, of 1 kg.
static real energy(const particle *p)
{
    return vec3_dot(p->velocity, p->velocity) / 2
         - vec3_dot(gravity, p->position);
}
//<

//> little_bounce 01b 01b
// The floor at y = 0 turns the velocity round: now and before change places.
static void bounce(particle *p)
{
    real y = p->position.y;
    if (y >= 0 || y >= p->previous.y) return;
    p->position.y = p->previous.y;
    p->previous.y = y;
}

// J, of 1 kg, in the middle of the last step.
static real energy(const particle *p, real dt)
{
    vec3 moved = vec3_sub(p->position, p->previous);
    vec3 middle = vec3_add_scaled(p->previous, 0.5, moved);
    return vec3_dot(moved, moved) / (2 * dt * dt) - vec3_dot(gravity, middle);
}
//<

//> little_attraction 01a 01b
// A planet's acceleration, in units in which a circle of radius 1 takes 2 pi.
static vec3 attraction(vec3 x)
{
    real r = vec3_length(x);
    return vec3_scale(-1 / (r * r * r), x);
}
//<

//> little_particles 02a 09z 12a 12z 16a
enum { PARTICLES = 20000 };
static particle particles[PARTICLES];
static int particle_count;

// Adds a particle at rest; mass 0 means that it is pinned.  Returns its index.
static int particle_add(vec3 x, real mass)
{
    if (particle_count == PARTICLES) return PARTICLES - 1;
    particles[particle_count] = (particle){ x, x, mass > 0 ? 1 / mass : 0 };
    return particle_count++;
}

static void particles_step(real dt)
{
    for (int i = 0; i < particle_count; i++)
        if (particles[i].inverse_mass > 0)
            verlet_step(&particles[i], gravity, dt);
}
//<
