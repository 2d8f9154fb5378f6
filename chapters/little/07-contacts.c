//> little_meet_count 06a 06z
static long asked, touching;    // questions of GJK, and pieces that touch
static real deepest;            // m
//<
//> little_compared 06b 06z
static long compared;           // pairs of spheres
//<

//> little_meet_only 06a 06z
// Asks how far apart two pieces are.
static void meet(const piece *p, const piece *q)
{
    vec3 at_a[12], at_b[12];
    simplex s = { .count = 0 };
    real margin = p->margin + q->margin;
    hull a = piece_hull(p, at_a), b = piece_hull(q, at_b);
    asked++;
    real d = gjk(a, b, &s, margin);
    touching += d <= margin;
    if (d == 0) deepest = real_max(deepest, epa(a, b, &s));
}
//<

//> little_contact 07a 09z
// --- Contacts ---------------------------------------------------------------

// A point of A and a point of B are kept `apart` (m) along a normal, B to A.
// Each point is a weighted mean of particles: those of B have weights < 0.
typedef struct {
    int  count, vertex[6];
    real weight[6];
    vec3 normal;
    real apart;
} contact;

enum { CONTACTS = 20000 };
static contact contacts[CONTACTS];
static int contact_count;

static void contact_add(contact *c, int vertex, real weight)
{
    int i = 0;
    while (i < c->count && c->vertex[i] != vertex) i++;
    if (i == c->count) c->vertex[c->count++] = vertex;
    c->weight[i] += weight;
}

// Adds a contact of two pieces if they are nearer than their margins.
static void meet(const piece *p, const piece *q)
{
    vec3 at_a[12], at_b[12];
    simplex s = { .count = 0 };
    contact c = { .apart = p->margin + q->margin };
    hull a = piece_hull(p, at_a), b = piece_hull(q, at_b);
    real d = gjk(a, b, &s, c.apart);
    if (d > c.apart || contact_count == CONTACTS) return;
    if (d < 1e-6 && epa(a, b, &s) == 0) return;
    c.normal = vec3_unit(s.v);
    for (int i = 0; i < s.count; i++) {
        contact_add(&c, p->vertex[s.of[i].a], s.weight[i]);
        contact_add(&c, q->vertex[s.of[i].b], -s.weight[i]);
    }
    contacts[contact_count++] = c;
}

// By how much the points are nearer than they may be (m).
static real contact_depth(const contact *c)
{
    real depth = c->apart;
    for (int i = 0; i < c->count; i++)
        depth -= c->weight[i]
               * vec3_dot(particles[c->vertex[i]].position, c->normal);
    return depth;
}
//<

//> little_response_halves 07a 07a
// Parts the two points: each goes half of the way.
static void response_separate(const contact *c)
{
    real depth = contact_depth(c);
    if (depth <= 0) return;
    for (int i = 0; i < c->count; i++) {
        vec3 *x = &particles[c->vertex[i]].position;
        *x = vec3_add_scaled(*x, c->weight[i] * depth / 2, c->normal);
    }
}
//<

//> little_friction 07c 09z
static const real friction = 0.5;       // Coulomb's coefficient

// The part of a slide that friction undoes: at most friction times the depth.
static vec3 slide_held(vec3 slide, vec3 normal, real depth)
{
    slide = vec3_add_scaled(slide, -vec3_dot(slide, normal), normal);
    real length = vec3_length(slide), held = friction * depth;
    return length > held ? vec3_scale(held / length, slide) : slide;
}
//<

//> little_response 07b 09z
// Parts the two points by the least move.
static void response_separate(const contact *c)
{
    real depth = contact_depth(c), inverse_mass = 0;
    for (int i = 0; i < c->count; i++)
        inverse_mass += c->weight[i] * c->weight[i]
                      * particles[c->vertex[i]].inverse_mass;
    if (depth <= 0 || inverse_mass == 0) return;
    vec3 push = vec3_scale(depth, c->normal);
//<
//> little_response_friction 07c 09z
    vec3 slide = { 0, 0, 0 };
    for (int i = 0; i < c->count; i++) {
        const particle *p = &particles[c->vertex[i]];
        vec3 moved = vec3_sub(p->position, p->previous);
        slide = vec3_add_scaled(slide, c->weight[i], moved);
    }
    push = vec3_sub(push, slide_held(slide, c->normal, depth));
//<
//> little_response_tail 07b 09z
    for (int i = 0; i < c->count; i++) {
        particle *p = &particles[c->vertex[i]];
        real part = c->weight[i] * p->inverse_mass / inverse_mass;
        p->position = vec3_add_scaled(p->position, part, push);
    }
}
//<

//> little_planes_friction 07c 09z
// Moves what is behind a plane onto it, and undoes its slide.
static void planes_push(void)
{
    for (int i = 0; i < particle_count; i++)
        for (int k = 0; k < plane_count; k++) {
            particle *p = &particles[i];
            vec3 n = planes[k].normal;
            real depth = planes[k].offset - vec3_dot(n, p->position);
            if (depth <= 0 || p->inverse_mass == 0) continue;
            vec3 moved = vec3_sub(p->position, p->previous);
            vec3 push = vec3_sub(vec3_scale(depth, n),
                                 slide_held(moved, n, depth));
            p->position = vec3_add(p->position, push);
        }
}
//<
