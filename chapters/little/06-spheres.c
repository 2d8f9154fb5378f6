//> little_spheres_head 06a 09z
// --- Finding pairs ----------------------------------------------------------

static hull piece_hull(const piece *p, vec3 at[12])
{
    for (int i = 0; i < p->count; i++) at[i] = particles[p->vertex[i]].position;
    return (hull){ at, p->count };
}
//<

//> little_spheres 06b 09z
typedef struct { vec3 center; real radius; } sphere;    // m

static sphere sphere_of_piece(const piece *p)
{
    sphere s = { { 0, 0, 0 }, 0 };
    vec3 at[12];
    piece_hull(p, at);
    for (int i = 0; i < p->count; i++)
        s.center = vec3_add_scaled(s.center, 1.0 / p->count, at[i]);
    for (int i = 0; i < p->count; i++)
        s.radius = real_max(s.radius, vec3_distance(at[i], s.center));
    s.radius += p->margin;
    return s;
}

static bool spheres_apart(sphere a, sphere b)
{
    return vec3_distance(a.center, b.center) > a.radius + b.radius;
}
//<

//> little_tree 06c 09z
// A branch of a body's tree: a sphere around a range of its pieces.  Its halves
// are the branches behind it.
typedef struct { int node, first, count; } branch;

static sphere nodes[2 * PIECES];

static branch branch_of(const body *b)
{
    return (branch){ 2 * b->first, b->first, b->count };
}

static branch branch_half(branch b, int which)
{
    int half = b.count / 2;
    if (which == 0) return (branch){ b.node + 1, b.first, half };
    return (branch){ b.node + 2 * half, b.first + half, b.count - half };
}

// The smallest sphere that encloses two.
static sphere sphere_of_spheres(sphere a, sphere b)
{
    vec3 along = vec3_sub(b.center, a.center);
    real d = vec3_length(along), radius = (d + a.radius + b.radius) / 2;
    if (d + b.radius <= a.radius) return a;
    if (d + a.radius <= b.radius) return b;
    return (sphere){ vec3_add_scaled(a.center, (radius - a.radius) / d, along),
                     radius };
}

static void branch_update(branch b)
{
    if (b.count == 1) {
        nodes[b.node] = sphere_of_piece(&pieces[b.first]);
        return;
    }
    branch left = branch_half(b, 0), right = branch_half(b, 1);
    branch_update(left);
    branch_update(right);
    nodes[b.node] = sphere_of_spheres(nodes[left.node], nodes[right.node]);
}
//<
