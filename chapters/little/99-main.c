//> little_main_ball_euler 00a 01a
// --- Scenes -----------------------------------------------------------------

// Drops a ball from 1 m, for ten seconds.
static void show_ball(void)
{
    particle ball = { { 0, 1, 0 }, { 0, 0, 0 } };
    real highest = 0;
    printf("energy at first %.3f J\n", energy(&ball));
    for (int i = 0; i < 600; i++) {
        euler_step(&ball, gravity, 1 / 60.0);
        bounce(&ball);
        highest = real_max(highest, ball.position.y);
    }
    printf("highest %.3f m\n", highest);
    printf("energy %.3f J\n", energy(&ball));
}
//<

//> little_main_ball 01b 01b
// --- Scenes -----------------------------------------------------------------

// Drops a ball from 1 m, for ten seconds.
static void show_ball(void)
{
    real dt = 1 / 60.0, highest = 0;
    vec3 x = { 0, 1, 0 }, v = { 0, 0, 0 };
    particle ball = particle_start(x, v, gravity, dt);
    printf("energy at first %.3f J\n", energy(&ball, dt));
    for (int i = 0; i < 600; i++) {
        verlet_step(&ball, gravity, dt);
        bounce(&ball);
        highest = real_max(highest, ball.position.y);
    }
    printf("highest %.3f m\n", highest);
    printf("energy %.3f J\n", energy(&ball, dt));
}
//<

//> little_main_planet_head 01a 01b
// A planet on a circle of radius 1, five times round, 60 steps each.
static void show_planet(void)
{
    real dt = 6.283185307179586 / 60, furthest = 0;
//<
//> little_main_planet_euler 01a 01a
    particle planet = { { 1, 0, 0 }, { 0, 1, 0 } };
    for (int i = 0; i < 300; i++) {
        euler_step(&planet, attraction(planet.position), dt);
//<
//> little_main_planet_verlet 01b 01b
    vec3 x = { 1, 0, 0 }, v = { 0, 1, 0 };
    particle planet = particle_start(x, v, attraction(x), dt);
    for (int i = 0; i < 300; i++) {
        verlet_step(&planet, attraction(planet.position), dt);
//<
//> little_main_planet_tail 01a 01b
        furthest = real_max(furthest, vec3_length(planet.position));
    }
    printf("planet furthest %.3f radii\n", furthest);
}
//<

//> little_main_00 00a 00a
int main(void)
{
    show_ball();
}
//<

//> little_main_01 01a 01b
int main(void)
{
    show_ball();
    show_planet();
}
//<

//> little_main_02a 02a 02a
// --- Scenes -----------------------------------------------------------------

// How long does a rope of springs last?  At most 5 s, that is 300 steps.
int main(void)
{
    for (real stiffness = 100; stiffness <= 1e5; stiffness *= 10) {
        real worst = 0;
        int steps = 0;
        hang_rope(10);
        while (steps < 300 && worst < 1000) {
            rope_step(stiffness, 1 / 60.0);
            steps++;
            if (!(strain() <= worst)) worst = strain();
            if (!(worst < 1000)) worst = 1000;
        }
        printf("with %g N/m: lasts %d steps\n", stiffness, steps);
        printf("with %g N/m: strain %.0f %%\n", stiffness, 100 * worst);
    }
}
//<

//> little_main_02b 02b 02c
// --- Scenes -----------------------------------------------------------------

// The worst strain from the moment on when the rope hangs in a bow, to 5 s.
static real rope_strain(int links, int rounds)
{
    real worst = 0;
    hang_rope(links);
    for (int i = 0; i < 300; i++) {
        rope_step(rounds, 1 / 60.0);
        if (i > 30) worst = real_max(worst, strain());
    }
    return worst;
}

int main(void)
{
    for (int links = 10; links <= 40; links *= 2)
        for (int rounds = 1; rounds <= 64; rounds *= 8) {
            real worst = rope_strain(links, rounds);
            printf("%d links, rounds %d: strain %.2f %%\n", links, rounds,
                   100 * worst);
        }
    printf("the pin fell %.3f m\n",
           real_max(-particles[0].position.y, 0));
}
//<

//> little_cube 03a 06z
// --- Scenes -----------------------------------------------------------------

// A cube of 1 m falls from 0.5 m, a little out of shape, for 5 s.
static void show_cube(void)
{
    int n = 8, cube = box_add(vec3_make(1, 1, 1), vec3_make(0, 1, 0), 1);
    for (int i = cube; i < cube + n; i++)
        particles[i].position =
            vec3_add(particles[i].position, random_vec3(0.02));
    for (int i = 0; i < 300; i++) body_step(16, 1 / 60.0);
    printf("sticks %d pieces\n", stick_count);
    printf("volume %.4f m^3\n", box_volume(cube));
    printf("strain %.4f %%\n", 100 * strain());
}
//<

//> little_main_03 03a 03b
int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_cube();
}
//<

//> little_pairs 04a 05z
// Two bodies, A a box of 1 m and B an icosahedron; `size` (m): how far apart.
typedef struct {
    vec3 box[8], ball[12];
    hull a, b;
} pair;

static void random_pair(pair *p, real size)
{
    vec3 center = random_vec3(size);
    p->a = (hull){ p->box, box_points(vec3_make(1, 1, 1), p->box) };
    p->b = (hull){ p->ball, icosahedron_points(0.5, p->ball) };
    for (int i = 0; i < 12; i++) p->ball[i] = vec3_add(p->ball[i], center);
}
//<

//> little_distances 04a 04e
// A distance d along v is right if no corner of A - B is lower along v: `doubt`
// is how much lower one is.
static void show_distances(void)
{
    int right = 0, overlap = 0, capped = 0, rounds = 0;
    real worst = 0;
    for (int i = 0; i < 20000; i++) {
        pair p;
        simplex s = { .count = 0 };
        random_pair(&p, 2);
//<
//> little_ask_corners 04a 04a
        real d = corner_distance(p.a, p.b, &s);
        int rounds_used = 0;
//<
//> little_ask_crawl 04b 04b
        real d = crawl(p.a, p.b, &s);
//<
//> little_ask_naive 04c 04d
        real d = gjk(p.a, p.b, &s);
//<
//> little_ask_gjk 04e 04e
        real d = gjk(p.a, p.b, &s, HUGE_VAL);
//<
//> little_distances_tail 04a 04e
        rounds += rounds_used;
        capped += rounds_used == 100;
        if (d == 0) { overlap++; continue; }
        corner low = hull_support(p.a, p.b, vec3_scale(-1, s.v));
        real doubt = d - vec3_dot(low.at, s.v) / vec3_length(s.v);
        right += doubt < 1e-9;
        worst = real_max(worst, doubt);
    }
    printf("right %d pairs\n", right);
    printf("overlap %d pairs\n", overlap);
    printf("no end %d pairs\n", capped);
    printf("rounds %.2f each\n", rounds / 20000.0);
    printf("largest doubt %.2g m\n", worst);
}

int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_cube();
    show_distances();
}
//<

//> little_depths_head 05a 05z
// Pushes A out of B, where they overlap, and asks again.
static void show_depths(void)
{
    int overlap = 0, still = 0, longer = 0;
    for (int i = 0; i < 2000; i++) {
        pair p;
        simplex s = { .count = 0 };
        random_pair(&p, 0.6);
        if (gjk(p.a, p.b, &s, 0) > 0) continue;
        overlap++;
//<
//> little_depths_middle 05a 05a
        real depth = middles_apart(p.a, p.b, &s);
//<
//> little_depths_epa 05b 05z
        real depth = epa(p.a, p.b, &s);
//<
//> little_depths_tail 05a 05z
        bool shorter = false;
        for (int k = 0; k < 100; k++) {
            real other = way_out(p.a, p.b, vec3_unit(random_vec3(1)));
            shorter = shorter || other < depth - 1e-9;
        }
        longer += shorter;
        for (int k = 0; k < p.a.count; k++)
            p.box[k] = vec3_add_scaled(p.box[k], depth + 1e-6, s.v);
        s.count = 0;
        still += gjk(p.a, p.b, &s, HUGE_VAL) == 0;
    }
    printf("overlap %d pairs\n", overlap);
    printf("a way out was shorter %d pairs\n", longer);
    printf("overlap still %d pairs\n", still);
}
//<

//> little_sunk_head 05a 05z
// A box of 0.4 m, 6 cm deep in a floor of 4 m, near its edge.
static void show_sunk_box(void)
{
    vec3 box[8], floor[8];
    simplex s = { .count = 0 };
    box_points(vec3_make(0.4, 0.4, 0.4), box);
    box_points(vec3_make(4, 0.2, 4), floor);
    for (int i = 0; i < 8; i++)
        box[i] = vec3_add(box[i], vec3_make(1, 0.24, 0));
    hull a = { box, 8 }, b = { floor, 8 };
    gjk(a, b, &s, 0);
//<
//> little_sunk_middle 05a 05a
    printf("the sunk box moves %.3f m\n", middles_apart(a, b, &s));
//<
//> little_sunk_epa 05b 05z
    printf("the sunk box moves %.3f m\n", epa(a, b, &s));
//<
//> little_sunk_tail 05a 05z
}
//<

//> little_main_05 05a 05z
int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_cube();
    show_depths();
    show_sunk_box();
}
//<

//> little_questions_head 06a 06z
static void clear(void)
{
    particle_count = stick_count = piece_count = body_count = 0;
}

// What is one search for contacts?
static void show_questions(const char *scene)
{
    asked = touching = 0;
    deepest = 0;
//<
//> little_questions_compared 06b 06z
    compared = 0;
//<
//> little_questions_tail 06a 06z
    find();
    printf("%s: asked %ld pairs\n", scene, asked);
    printf("%s: touching %ld pairs\n", scene, touching);
    printf("%s: deepest %.3f m\n", scene, deepest);
//<
//> little_questions_print 06b 06z
    printf("%s: compared %ld spheres\n", scene, compared);
//<
//> little_main_06 06a 06z
}

int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    vec3 cube = { 0.8, 0.8, 0.8 }, ball[12];
    int n = icosahedron_points(0.5, ball);
    show_cube();
    clear();
    for (int i = 0; i < 50; i++) body_add(ball, n, vec3_make(0.8 * i, 0, 0), 1);
    show_questions("50 bodies");
    clear();
    box_add(cube, vec3_make(0, 0.4, 0), 0);
    cloth_add(40, 2, vec3_make(0, 0.81, 0));
    show_questions("cloth on a cube");
    cloth_add(40, 2, vec3_make(0, 0.9, 0));
    show_questions("two cloths");
}
//<

//> little_scenes_07 07a 08z
// --- Scenes -----------------------------------------------------------------

// A fly of 1 g, 0.1 m deep in an elephant of 1 kg, and one response.
static void show_fly(void)
{
    vec3 ball[12];
    int n = icosahedron_points(0.2, ball);
    clear();
    int fly = body_add(ball, n, vec3_make(-0.07, 1, 0), 0.001);
    int elephant = box_add(vec3_make(1, 1, 1), vec3_make(0.5, 1, 0), 1);
    vec3 a = middle_of(fly, n), b = middle_of(elephant, 8);
    find();
    response_separate(&contacts[0]);
    real left = contact_depth(&contacts[0]);
    a = vec3_sub(middle_of(fly, n), a);
    b = vec3_sub(middle_of(elephant, 8), b);
    printf("the fly moves %.4f m\n", vec3_length(a));
    printf("the elephant moves %.4f m\n", vec3_length(b));
    printf("overlap left %.4f m\n", fabs(left));
}

// Three cubes, a little out of line, fall on each other.
static void show_pile(void)
{
    int cube[3];
    vec3 early[3];
    real creep = 0;
    clear();
    for (int i = 0; i < 3; i++) {
        vec3 center = vec3_make(0, 0.5 + 1.1 * i, 0);
        cube[i] = box_add(vec3_make(1, 1, 1),
                          vec3_add(center, random_vec3(0.03)), 1);
    }
    for (int i = 0; i < 600; i++) {
        if (i == 300)
            for (int k = 0; k < 3; k++) early[k] = middle_of(cube[k], 8);
        step(32, 1 / 60.0);
    }
    for (int k = 0; k < 3; k++)
        creep = real_max(creep, vec3_distance(middle_of(cube[k], 8), early[k]));
    printf("the pile is high %.3f m\n", middle_of(cube[2], 8).y + 0.5);
    printf("the pile creeps in 5 s %.3f m\n", creep);
}

// A box on a slope of 1 in 5: how far does it slide from 1 s to 3 s?
static void show_slope(void)
{
    vec3 after[2];
    clear();
    planes[0] = (plane){ vec3_unit(vec3_make(-1, 5, 0)), 0 };
    int box = box_add(vec3_make(1, 0.5, 1), vec3_make(0, 0.4, 0), 1);
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 60 + 60 * i; k++) step(32, 1 / 60.0);
        after[i] = middle_of(box, 8);
    }
    printf("the box slides %.4f m\n", vec3_distance(after[0], after[1]));
}

// A cloth falls on a pinned cube, a little beside its middle.
static void show_cloth(void)
{
    clear();
    box_add(vec3_make(0.8, 0.8, 0.8), vec3_make(0, 0.4, 0), 0);
    cloth_add(20, 2, vec3_make(0.2, 0.9, 0));
    for (int i = 0; i < 300; i++) step(32, 1 / 60.0);
    printf("the cloth lies high %.3f m\n", middle_of(8, 400).y);
    printf("strain of the cloth %.2f %%\n", 100 * strain());
    vec3 moved = vec3_sub(middle_of(0, 8), vec3_make(0, 0.4, 0));
    printf("the pinned cube moves %.3f m\n", vec3_length(moved));
}
//<

//> little_main_07 07a 07z
int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_fly();
    show_pile();
    show_slope();
    show_cloth();
}
//<

//> little_blow 08a 08z
// A cloth is struck: one particle has gone 0.9 of a cell.  How many times is a
// stick relaxed until all are within 1 %, and how far are they off on the way?
static void show_blow(const char *order, bool outwards)
{
    clear();
    cloth_add(21, 20, vec3_make(0, 5, 0));
    int struck = 10 * 21 + 5, relaxed = 0;
    if (outwards) sticks_order(struck);
    particles[struck].position.x += 0.7;
    particles[struck].position.z += 0.5;
    while (strain() > 0.01 && relaxed < 1000000) {
        for (int i = 0; i < stick_count; i++) stick_relax(&sticks[i]);
        relaxed += stick_count;
        if (relaxed == stick_count)
            printf("%s: after one round %.1f %%\n", order, 100 * strain());
    }
    printf("%s: relaxed %d sticks\n", order, relaxed);
}

int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_fly();
    show_pile();
    show_slope();
    show_cloth();
    show_blow("as listed", false);
    show_blow("outwards", true);
}
//<

//> little_run 09a 09z
// --- Scenes -----------------------------------------------------------------

// Runs a scene for so many frames, and measures every tenth.
static void run(const char *scene, int frames)
{
    real deepest = 0, worst = 0;
    for (int i = 1; i <= frames; i++) {
//<
//> little_run_rounds 09a 09a
        step(32, 1 / 60.0);
//<
//> little_run_draw 09b 09z
        step(1 / 60.0);
        if (drawing && i % 4 == 0) draw();
//<
//> little_run_measure 09a 09z
        if (i % 10 > 0) continue;
        deepest = real_max(deepest, overlap());
        worst = real_max(worst, strain());
    }
    printf("%s: overlap %.2f mm\n", scene, 1000 * deepest);
    printf("%s: overlap at the end %.2f mm\n", scene, 1000 * overlap());
    printf("%s: strain %.2f %%\n", scene, 100 * worst);
    printf("%s: strain at the end %.2f %%\n", scene, 100 * strain());
}
//<

//> little_main_09_head 09a 09z
static void show_three(void)
{
    clear();
    walls_add(4.7);
    balls_add(50, 0.5, 4, 4.6, 1);
    run("50 bodies", 600);
    clear();
    box_add(vec3_make(0.8, 0.8, 0.8), vec3_make(0, 0.4, 0), 0);
    cloth_add(20, 2, vec3_make(0.1, 0.9, 0));
    run("cloth on a cube", 300);
    clear();
    rope_add(vec3_make(-1.3, 1.5, 0), vec3_make(1.3, 1.5, 0), 50, 1.15);
    cloth_add(20, 2, vec3_make(0, 1.6, 0));
    run("cloth on a rope", 300);
}
//<

//> little_main_09a 09a 09a
int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_three();
}
//<

//> little_main_09b 09b 09z
// The room of this book's reader: change it.
static void show_room(void)
{
    clear();
    walls_add(6);
    box_add(vec3_make(1, 0.8, 1), vec3_make(-1.2, 0.4, 0.6), 0);
    cloth_add(22, 2, vec3_make(-1.2, 0.9, 0.6));
    rope_add(vec3_make(-1.2, 2, -2), vec3_make(2, 2, -2), 32, 1);
    cloth_add(22, 2, vec3_make(0.4, 2.1, -2));
    balls_add(18, 0.3, 3, 3.2, 2.5);
    run("the room", 480);
}

// With the argument draw: the room alone, and its frames.
int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    if (!drawing) show_three();
    show_room();
}
//<
