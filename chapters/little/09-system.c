//> little_step 07a 09a
// --- The system -------------------------------------------------------------

// One step: move, find contacts, then contacts, sticks and planes in rounds.
static void step(int rounds, real dt)
{
    particles_step(dt);
    find();
    for (int r = 0; r < rounds; r++) {
        for (int i = 0; i < contact_count; i++)
            response_separate(&contacts[i]);
        for (int i = 0; i < stick_count; i++) stick_relax(&sticks[i]);
        planes_push();
    }
    if (drawing) draw();
}
//<

//> little_substeps 09b 09z
// --- The system -------------------------------------------------------------

enum { SUBSTEPS = 8, ROUNDS = 4 };

// One frame of substeps: move, find contacts, then contacts, sticks and planes
// in rounds.
static void step(real dt)
{
    for (int s = 0; s < SUBSTEPS; s++) {
        particles_step(dt / SUBSTEPS);
        find();
        for (int r = 0; r < ROUNDS; r++) {
            for (int i = 0; i < contact_count; i++)
                response_separate(&contacts[i]);
            for (int i = 0; i < stick_count; i++) stick_relax(&sticks[i]);
            planes_push();
        }
    }
}
//<

//> little_clear 07a 09z
// Forgets all bodies, and all planes but the floor.
static void clear(void)
{
    particle_count = stick_count = piece_count = body_count = 0;
    planes[0] = (plane){ { 0, 1, 0 }, 0 };
    plane_count = 1;
}
//<

//> little_middle 07a 08z
// The mean of the positions of n particles.
static vec3 middle_of(int first, int n)
{
    vec3 middle = { 0, 0, 0 };
    for (int i = first; i < first + n; i++)
        middle = vec3_add_scaled(middle, 1.0 / n, particles[i].position);
    return middle;
}
//<

//> little_rope_add 09a 09z
// A rope of 0.5 kg, pinned at both ends, `slack` times as long as its span.
static void rope_add(vec3 from, vec3 to, int links, real slack)
{
    int first = particle_count;
    real link = slack * vec3_distance(from, to) / links;
    vec3 along = vec3_sub(to, from);
    for (int i = 0; i <= links; i++)
        particle_add(vec3_add_scaled(from, i / (real)links, along),
                     i % links > 0 ? 0.5 / links : 0);
    body_begin();
    for (int i = first; i < first + links; i++) {
        stick_add(i, i + 1);
        sticks[stick_count - 1].rest_length = link;
        piece_add(2, (int[]){ i, i + 1 }, 0.3 * link);
    }
}

// Walls around a square of that side (m).
static void walls_add(real side)
{
    static const vec3 inwards[4] = { { 1, 0, 0 }, { -1, 0, 0 },
                                     { 0, 0, 1 }, { 0, 0, -1 } };
    for (int k = 0; k < 4; k++)
        planes[1 + k] = (plane){ inwards[k], -side / 2 };
    plane_count = 5;
}

// Icosahedra of 1 kg that fall in a grid of cells x cells, in layers.
static void balls_add(int n, real radius, int cells, real side, real height)
{
    vec3 ball[12];
    int vertices = icosahedron_points(radius, ball);
    for (int i = 0; i < n; i++) {
        real x = (i % cells + 0.5) / cells - 0.5;
        real z = (i / cells % cells + 0.5) / cells - 0.5;
        real y = height + i / (cells * cells) * 2.2 * radius;
        vec3 center = vec3_make(side * x, y, side * z);
        body_add(ball, vertices, vec3_add(center, random_vec3(0.05)), 1);
    }
}
//<

//> little_overlap 09a 09z
// The deepest overlap of two pieces (m).
static real overlap(void)
{
    real deepest = 0;
    find();
    for (int i = 0; i < contact_count; i++)
        deepest = real_max(deepest,
                           contact_depth(&contacts[i]) - contacts[i].apart);
    return deepest;
}
//<

//> little_draw 09b 09z
// --- Drawing ----------------------------------------------------------------

static void print_points(const char *what, int n, const vec3 *at)
{
    printf("%s", what);
    for (int i = 0; i < n; i++)
        printf(" %.4f %.4f %.4f", at[i].x, at[i].y, at[i].z);
    printf("\n");
}

// Prints a triangle of vertices if no vertex is outside of it.
static void draw_face(hull h, vec3 x, vec3 y, vec3 z)
{
    vec3 normal = vec3_unit(vec3_cross(vec3_sub(y, x), vec3_sub(z, x)));
    vec3 top = h.at[hull_furthest(h, normal)];
    if (vec3_dot(vec3_sub(top, x), normal) < 1e-3)
        print_points("face", 3, (vec3[]){ x, y, z });
}

static void draw(void)
{
    printf("frame\n");
    for (int n = 0; n < piece_count; n++) {
        vec3 at[12];
        hull h = piece_hull(&pieces[n], at);
        if (bodies[pieces[n].body].first == n) printf("body\n");
        if (h.count == 2) print_points("line", 2, at);
        if (h.count == 3) print_points("face", 3, at);
        for (int i = 0; i < h.count && h.count > 3; i++)
            for (int j = i + 1; j < h.count; j++)
                for (int k = i + 1; k < h.count; k++)
                    if (k != j) draw_face(h, at[i], at[j], at[k]);
    }
}
//<
