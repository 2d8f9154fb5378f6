//> little_box_points 03a
// --- Bodies -----------------------------------------------------------------

// The corners of a box with these sides (m) around the origin.  Returns 8.
static int box_points(vec3 side, vec3 at[8])
{
    for (int i = 0; i < 8; i++)
        at[i] = vec3_make(i & 1 ? side.x / 2 : -side.x / 2,
                          i & 2 ? side.y / 2 : -side.y / 2,
                          i & 4 ? side.z / 2 : -side.z / 2);
    return 8;
}
//<

//> little_icosahedron_points 04a 10z 13f 15z 18a
// The corners of an icosahedron of that radius (m).  Returns 12.
static int icosahedron_points(real radius, vec3 at[12])
{
    real golden = (1 + sqrt(5)) / 2;
    real s = radius / sqrt(1 + golden * golden), t = s * golden;
    for (int i = 0; i < 4; i++) {
        real a = i & 1 ? s : -s, b = i & 2 ? t : -t;
        at[3 * i] = vec3_make(a, b, 0);
        at[3 * i + 1] = vec3_make(0, a, b);
        at[3 * i + 2] = vec3_make(b, 0, a);
    }
    return 12;
}
//<

//> little_body_add 03a 09z
// Adds n particles around `center`, and sticks.  Returns the first particle.
static int body_add(const vec3 *at, int n, vec3 center, real mass)
{
    int first = particle_count;
    for (int i = 0; i < n; i++) particle_add(vec3_add(center, at[i]), mass / n);
    for (int i = 0; i < n; i++)
//<
//> little_join_edges 03a 03a
        for (int j = 0; j < i; j++)
            if (vec3_distance(at[i], at[j]) < 1.1)
                stick_add(first + j, first + i);
//<
//> little_join_all 03b 09z
        for (int j = 0; j < i; j++) stick_add(first + j, first + i);
//<
//> little_body_piece 06a 09z
    int vertex[12];
    for (int i = 0; i < n; i++) vertex[i] = first + i;
    body_begin();
    piece_add(n, vertex, 0.005);
//<
//> little_body_end 03a 09z
    return first;
}

static int box_add(vec3 side, vec3 center, real mass)
{
    vec3 corner[8];
    return body_add(corner, box_points(side, corner), center, mass);
}
//<

//> little_cloth 06a 09z
// A level square of n x n particles and two triangles a cell, 1 kg.
static void cloth_add(int n, real side, vec3 center)
{
    int first = particle_count;
    real cell = side / (n - 1);
    for (int k = 0; k < n * n; k++) {
        vec3 at = { k % n * cell - side / 2, 0, k / n * cell - side / 2 };
        particle_add(vec3_add(center, at), 1.0 / (n * n));
    }
    body_begin();
    for (int k = first; k < first + n * n; k++) {
        bool right = (k - first) % n + 1 < n, below = k + n < first + n * n;
        if (right) stick_add(k, k + 1);
        if (below) stick_add(k, k + n);
        if (!right || !below) continue;
        piece_add(3, (int[]){ k, k + n, k + 1 }, 0.15 * cell);
        piece_add(3, (int[]){ k + 1, k + n, k + n + 1 }, 0.15 * cell);
    }
}
//<

//> little_planes 03a 09z
// --- Planes -----------------------------------------------------------------

// The free side is normal . x >= offset.
typedef struct { vec3 normal; real offset; } plane;     // unit, m

static plane planes[6] = { { { 0, 1, 0 }, 0 } };
static int plane_count = 1;
//<

//> little_planes_push 03a 07b
// Moves what is behind a plane onto it.
static void planes_push(void)
{
    for (int i = 0; i < particle_count; i++)
        for (int k = 0; k < plane_count; k++) {
            vec3 *x = &particles[i].position;
            real depth = planes[k].offset - vec3_dot(planes[k].normal, *x);
            if (depth > 0 && particles[i].inverse_mass > 0)
                *x = vec3_add_scaled(*x, depth, planes[k].normal);
        }
}
//<

//> little_drawing 03a 09z
static bool drawing;            // as the argument draw wants it
//<

//> little_draw_sticks 03a 09a
// Prints all sticks as they lie now.
static void draw(void)
{
    printf("frame\n");
    for (int i = 0; i < stick_count; i++) {
        vec3 a = particles[sticks[i].a].position;
        vec3 b = particles[sticks[i].b].position;
        printf("line %.4f %.4f %.4f", a.x, a.y, a.z);
        printf(" %.4f %.4f %.4f\n", b.x, b.y, b.z);
    }
}
//<

//> little_body_step 03a 06z
// m^3, spanned by three edges of a box whose first particle is `first`.
static real box_volume(int first)
{
    const particle *p = &particles[first];
    vec3 x = vec3_sub(p[1].position, p[0].position);
    vec3 y = vec3_sub(p[2].position, p[0].position);
    vec3 z = vec3_sub(p[4].position, p[0].position);
    return fabs(vec3_dot(x, vec3_cross(y, z)));
}

static void body_step(int rounds, real dt)
{
    particles_step(dt);
    for (int r = 0; r < rounds; r++) {
        for (int i = 0; i < stick_count; i++) stick_relax(&sticks[i]);
        planes_push();
    }
    if (drawing) draw();
}
//<
