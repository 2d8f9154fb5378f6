//> little_show_sides 10a 10z
// --- Scenes ------------------------------------------------------------------

static void show_sides(const char *name, const shape *s)
{
    int most = 0;
    for (int f = 0; f < s->sides; f++)
        if (s->corners[f] > most) most = s->corners[f];
    printf("%s: sides %d faces\n", name, s->sides);
    printf("%s: corners of a side %d vertices\n", name, most);
//<
//> little_show_weight 10b 10b
    printf("%s: volume %.6f m^3\n", name, s->volume);
    printf("%s: inertia %.6f m^2\n", name, s->inertia.x.x);
//<
//> little_show_sides_end 10a 10z
}

//<
//> little_show_corners 10b 10b
// What do the corners of a box alone weigh, an eighth of 1 kg each?
static void show_corners(const shape *s)
{
    real sum = 0;
    for (int i = 0; i < s->count; i++) {
        vec3 x = s->vertex[i];
        sum += (vec3_dot(x, x) - x.x * x.x) / s->count;
    }
    printf("eight particles: inertia %.6f m^2\n", sum);
}

//<
//> little_main_10 10a 10z
int main(void)
{
    const shape *box = box_make(1, 1, 1);
    show_sides("box", box);
    show_sides("icosahedron", icosahedron_make(0.5));
//<
//> little_main_10b 10b 10b
    show_corners(box);
//<
//> little_main_10_end 10a 10z
}
//<

//> little_show_manifold 11a 13b
// --- Scenes ------------------------------------------------------------------

// A box of 1 m lies on another, turned, and 1 mm deep.
static void show_manifold(void)
{
    contact c = { .reach = MARGIN };
    const shape *box = box_make(1, 1, 1);
    c.b = body_add(box, vec3_make(0, 0, 0), 1);
    c.a = body_add(box, vec3_make(0, 0.999, 0), 1);
    body_turn(c.a, vec3_make(0, 0.8, 0));
    bool met = contact_meet(&c);
    real wide = 0;
    for (int i = 0; i < c.count; i++)
        for (int j = 0; j < i; j++) {
            const contact_point *p = &c.point[i], *q = &c.point[j];
            wide = real_max(wide, vec3_distance(p->local_b, q->local_b));
        }
    printf("points %d points\n", met ? c.count : 0);
    printf("as wide as %.3f m\n", wide);
    printf("normal %.6f up\n", c.normal.y);
}
//<
//> little_main_11 11a 11z

int main(void)
{
    show_manifold();
}
//<

//> little_main_12 12a 12z
// A rope swings down with a load, for 5 s in substeps of 1/480 s: its worst
// strain, and the last.
static void show_rope(int links, real load, int rounds)
{
    real worst = 0;
    hang_rope(links, load);
    for (int i = 0; i < 2400; i++) {
        rope_step(rounds, 1 / 480.0);
        worst = real_max(worst, strain());
    }
    printf("%d links, %g kg, rounds %d: strain %.2f %%\n", links, load, rounds,
           100 * worst);
    printf("%d links, %g kg, rounds %d: at the end %.4f %%\n", links, load,
           rounds, 100 * strain());
}

int main(void)
{
    show_manifold();
    show_rope(10, 100, 12);
    show_rope(20, 100, 12);
    show_rope(40, 100, 12);
    show_rope(40, 100, 64);
}
//<

//> little_main_13a 13a 13b
// A box spins for 10 s; nothing acts on it.
int main(void)
{
    show_manifold();
    body *b = body_add(box_make(1, 2, 3), vec3_make(0, 0, 0), 1);
    b->spin = vec3_make(1, 3, 0.5);
    vec3 momentum = body_angular_momentum(b);
    for (int i = 0; i < 600; i++) body_move(b, 1 / 60.0);
    vec3 lost = vec3_sub(body_angular_momentum(b), momentum);
    real share = vec3_length(lost) / vec3_length(momentum);
    real stretch = fabs(vec3_length(b->axes.x) - 1);
    printf("angular momentum lost %.2g %%\n", 100 * share);
    printf("axes stretched %.2g %%\n", 100 * stretch);
}
//<

//> little_scenes_bodies 13c
// --- Scenes ------------------------------------------------------------------

static void clear(void)
{
    body_count = contact_count = 0;
//<
//> little_clear_boxes 14b
    boxed = 0;
//<
//> little_clear_substeps 18b
    substeps = 4;
//<
//> little_clear_joints 17a
    joint_count = 0;
//<
//> little_clear_soft 16a
    particle_count = strand_count = soft_count = touch_count = 0;
//<
//> little_scenes_floor 13c
}

//<
//> little_floor_add 13c 14z 15c
static void floor_add(void)
{
    body_add(box_make(40, 1, 40), vec3_make(0, -0.5, 0), 0);
}

//<
//> little_rigid_overlap 13c
// m, the deepest overlap of two bodies.
static real overlap(void)
{
    real deepest = 0;
    for (body *a = bodies; a < bodies + body_count; a++)
        for (body *b = bodies; b < a; b++) {
            simplex s = { .count = 0 };
            real near = a->shape->radius + b->shape->radius;
            if (a->inverse_mass + b->inverse_mass == 0
                || vec3_distance(a->position, b->position) > near) continue;
//<
//> little_overlap_joined 17a
            if (bodies_joined(a, b)) continue;
//<
//> little_overlap_end 13c
            if (gjk(body_hull(a), body_hull(b), &s, 0) > 0) continue;
            deepest = real_max(deepest, epa(body_hull(a), body_hull(b), &s));
        }
    return deepest;
}

//<
//> little_draw_engine 18c
// --- Drawing -----------------------------------------------------------------

static bool drawing;            // as the argument draw wants it

static void print_face(vec3 a, vec3 b, vec3 c)
{
    printf("face %.4f %.4f %.4f %.4f %.4f %.4f %.4f %.4f %.4f\n",
           a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
}

static void draw_body(const body *b)
{
    const shape *s = b->shape;
    const vec3 *at = body_hull(b).at;
    printf("body\n");
    for (int f = 0; f < s->sides; f++)
        for (int k = 2; k < s->corners[f]; k++)
            print_face(at[s->side[f][0]], at[s->side[f][k - 1]],
                       at[s->side[f][k]]);
}

// All bodies but the floor, and the cloth.
static void draw(void)
{
    printf("frame\n");
    for (body *b = bodies; b < bodies + body_count; b++)
        if (b->shape->radius < 5) draw_body(b);
    printf("body\n");
    for (soft_piece *p = soft_pieces; p < soft_pieces + soft_count; p++) {
        vec3 at[3];
        piece_at(p, at);
        print_face(at[0], at[1], at[2]);
    }
}
//<

//> little_cuts 16a 16z
// How many pieces of cloth cut a body?
static int cuts(void)
{
    int count = 0;
    for (body *b = bodies; b < bodies + body_count; b++)
        for (soft_piece *p = soft_pieces; p < soft_pieces + soft_count; p++) {
            vec3 at[3];
            simplex s = { .count = 0 };
            piece_at(p, at);
            count += gjk((hull){ at, 3 }, body_hull(b), &s, 0) == 0;
        }
    return count;
}

// Does the edge from p to q go through a triangle?
static bool edge_crosses(vec3 p, vec3 q, const vec3 *t)
{
    vec3 n = vec3_cross(vec3_sub(t[1], t[0]), vec3_sub(t[2], t[0]));
    real a = vec3_dot(n, vec3_sub(p, t[0])), b = vec3_dot(n, vec3_sub(q, t[0]));
    if (a * b >= 0) return false;
    vec3 x = vec3_add_scaled(p, a / (a - b), vec3_sub(q, p));
    for (int k = 0; k < 3; k++) {
        vec3 edge = vec3_sub(t[(k + 1) % 3], t[k]);
        if (vec3_dot(n, vec3_cross(edge, vec3_sub(x, t[k]))) <= 0) return false;
    }
    return true;
}

// How many threads cross a triangle that they are no corner of?
static int crossings(void)
{
    int count = 0;
    for (soft_piece *p = soft_pieces; p < soft_pieces + soft_count; p++)
        for (strand *s = strands; s < strands + strand_count; s++)
            for (int i = 0; i < s->links; i++) {
                vec3 t[3];
                bool shared = false;
                piece_at(p, t);
                for (int k = 0; k < 3; k++)
                    if (p->vertex[k] == s->at[i]
                        || p->vertex[k] == s->at[i + 1]) shared = true;
                if (!shared)
                    count += edge_crosses(particles[s->at[i]].position,
                                          particles[s->at[i + 1]].position, t);
            }
    return count;
}

//<
//> little_joint_gaps 17a
static real joint_gaps(void)
{
    real worst = 0;
    for (joint *j = joints; j < joints + joint_count; j++)
        worst = real_max(worst, vec3_length(j->gap));
    return worst;
}

//<
//> little_show 13c
// Runs what is there for so many frames, and measures it.
static void show(const char *name, int frames)
{
    real deepest = 0;
//<
//> little_show_asked 13f
    asked = 0;
//<
//> little_show_compared 14a 15z
    compared = 0;
//<
//> little_show_strained 16a
    real strained = 0;
//<
//> little_show_cuts 16a 16z
    int cut = 0, crossed = 0;
//<
//> little_show_gap 17a
    real widest = 0;
//<
//> little_show_run 13c
    for (int i = 1; i <= frames; i++) {
        step(1 / 60.0);
//<
//> little_show_draw 18c
        if (drawing && i % 4 == 1) draw();
//<
//> little_show_strain 16a
        strained = real_max(strained, strain());
//<
//> little_show_gaps 17a
        widest = real_max(widest, joint_gaps());
//<
//> little_show_measure 13c
        if (i % 10 == 0) deepest = real_max(deepest, overlap());
//<
//> little_show_cuts_count 16a 16z
        if (i % 20 > 0) continue;
        int now = cuts(), crossing = crossings();
        cut = now > cut ? now : cut;
        crossed = crossing > crossed ? crossing : crossed;
//<
//> little_show_print 13c
    }
    printf("%s: overlap %.2f mm\n", name, 1000 * deepest);
    printf("%s: overlap at the end %.2f mm\n", name, 1000 * overlap());
//<
//> little_show_asked_print 13f
    printf("%s: asked %ld pairs/frame\n", name, asked / frames);
//<
//> little_show_compared_print 14a 15z
    printf("%s: compared %ld pairs/frame\n", name, compared / frames);
//<
//> little_show_cuts_print 16a 16z
    printf("%s: cut %d triangles\n", name, cut);
    printf("%s: crossed %d edges\n", name, crossed);
//<
//> little_show_strain_print 16a
    printf("%s: strain %.2f %%\n", name, 100 * strained);
    printf("%s: strain at the end %.2f %%\n", name, 100 * strain());
//<
//> little_show_gap_print 17a
    printf("%s: gap %.4f mm\n", name, 1000 * widest);
//<
//> little_show_awake 18a
    int awake = 0;
    for (int i = 0; i < body_count; i++) awake += body_is_awake(&bodies[i]);
    printf("%s: awake %d bodies\n", name, awake);
//<
//> little_show_end 13c
}

//<
//> little_show_pile 13c 14z 18a 18b
// Boxes of 1 kg on each other, the top one of another mass.
static void pile_add(int count, real top)
{
    clear();
    floor_add();
    const shape *s = box_make(1, 1, 1);
    for (int i = 0; i < count; i++)
        body_add(s, vec3_make(0, i + 0.5, 0), i + 1 < count ? 1 : top);
}

static void show_pile(const char *name, int count, real top, int frames)
{
    pile_add(count, top);
    show(name, frames);
    vec3 x = bodies[count].position;
    printf("%s: moved %.2f mm\n", name, 1000 * sqrt(x.x * x.x + x.z * x.z));
    printf("%s: the top is at %.2f m\n", name, x.y);
}
//<

//> little_main_13c 13c 13d
int main(void)
{
    show_pile("two boxes", 2, 1, 600);
    show_pile("ten boxes", 10, 1, 600);
    printf("asked %ld pairs\n", asked);
}
//<
//> little_main_13e 13e 13e
int main(void)
{
    show_pile("ten boxes", 10, 1, 600);
    show_pile("ten boxes, 20 kg", 10, 20, 600);
    printf("asked %ld pairs\n", asked);
}
//<

//> little_room 13f 15z 18a 18b
// A room of that width, full of icosahedra that fly.  Walls are boxes.
static void room_add(int cells, real side)
{
    clear();
    const shape *wall = box_make(side + 2, side + 2, 1);
    const shape *across = box_make(1, side + 2, side + 2);
    const shape *floor = box_make(side + 2, 1, side + 2);
    for (int k = -1; k <= 1; k += 2) {
        real d = k * (side / 2 + 0.5), up = side / 2;
        body_add(wall, vec3_make(0, up, d), 0);
        body_add(across, vec3_make(d, up, 0), 0);
        body_add(floor, vec3_make(0, up + d, 0), 0);
    }
    vec3 low = { 0.55 - side / 2, 0.55, 0.55 - side / 2 };
    const shape *ball = icosahedron_make(0.5);
    real far = (side - 1.1) / (cells - 1);
    for (int k = 0; k < cells * cells * cells; k++) {
        vec3 cell = { k % cells, k / cells % cells, k / cells / cells };
        body *b = body_add(ball, vec3_add_scaled(low, far, cell), 1);
        b->velocity = random_vec3(5);
        b->spin = random_vec3(5);
        body_turn(b, random_vec3(2));
    }
}
//<

//> little_main_13f 13f 13g
int main(void)
{
    show_pile("ten boxes", 10, 1, 600);
    show_pile("ten boxes, 20 kg", 10, 20, 600);
    room_add(4, 4.8);
    show("room of 64", 120);
}
//<

//> little_main_14 14a 14z
int main(void)
{
    show_pile("ten boxes, 20 kg", 10, 20, 600);
    room_add(4, 4.8);
    show("room of 64", 120);
    room_add(6, 7.8);
    show("room of 216", 60);
}
//<

//> little_bullets 15a 15z
// Bullets of 50 to 990 m/s at a plate of 2 mm: how many are behind it?
static void show_bullets(void)
{
    int through = 0;
    clear();
    body_add(box_make(0.002, 4, 4), vec3_make(0, 2, 0), 0);
    const shape *s = box_make(0.02, 0.02, 0.02);
    for (int i = 0; i < 100; i++) {
        real y = 0.3 + 0.35 * (i % 10), z = 0.35 * (i / 10) - 1.6;
        body *b = body_add(s, vec3_make(-1 - 0.01 * i, y, z), 0.01);
        b->velocity = vec3_make(50 + 9.5 * i, random_real(), random_real());
        b->spin = random_vec3(30);
    }
    bool behind[101] = { false };
    for (int i = 0; i < 30; i++) {
        step(1 / 60.0);
        for (int k = 1; k <= 100; k++) {
            vec3 x = bodies[k].position;
            bool beside = fabs(x.y - 2) > 2 || fabs(x.z) > 2;
            if (x.x > 0 && !beside) behind[k] = true;
        }
    }
    for (int k = 1; k <= 100; k++) through += behind[k];
    printf("through %d bullets\n", through);
}
//<
//> little_drop 15c 15z
// A ball falls by 1 m, with a restitution.  The height of its middle again.
static void show_drop(real restitution)
{
    real again = 0, before = 0;
    bool was_down = false;
    clear();
    floor_add();
    body *b = body_add(icosahedron_make(0.1), vec3_make(0, 1.1, 0), 1);
    b->restitution = restitution;
    for (int i = 0; i < 90; i++) {
        before = b->velocity.y;
        step(1 / 60.0);
        if (b->velocity.y > before + 1) was_down = true;
        if (was_down) again = real_max(again, b->position.y);
    }
    printf("restitution %g: up again %.3f m\n", restitution, again);
}
//<
//> little_main_15 15a 15z
int main(void)
{
    room_add(4, 4.8);
    show("room of 64", 120);
    show_bullets();
//<
//> little_main_15c 15c 15c
    show_drop(0);
    show_drop(0.8);
//<
//> little_main_15_end 15a 15z
}
//<

//> little_cloth_on_cube 16a
static void cloth_on_cube(int n, vec3 at)
{
    clear();
    floor_add();
    body_add(box_make(0.8, 0.8, 0.8), vec3_make(0, 0.4, 0), 0);
    cloth_add(n, 2, at);
}
//<
//> little_main_16 16a 16z
int main(void)
{
    cloth_on_cube(20, vec3_make(0, 0.9, 0));
    show("cloth on a cube", 120);
    cloth_on_cube(16, vec3_make(0.3, 1.5, 0.2));
    for (int i = 0; i < particle_count; i++)
        particles[i].previous.y += 40 / 480.0;
    show("thrown at 40 m/s", 60);
    printf("sought %ld times\n", sought);
}
//<

//> little_joint_scenes 17a 18b
// A chain of links of 0.2 m and 1 kg hangs down, with a load.
static void chain_add(int links, real load)
{
    clear();
    const shape *s = box_make(0.05, 0.2, 0.05), *box = box_make(0.5, 0.5, 0.5);
    body *last = body_add(s, vec3_make(0, 0.1, 0), 0);
    for (int i = 0; i <= links; i++) {
        bool is_load = i == links;
        vec3 at = { 0, -0.2 * i - (is_load ? 0.25 : 0.1), 0 };
        body *b = body_add(is_load ? box : s, at, is_load ? load : 1);
        joint_add(last, b, vec3_make(0, -0.2 * i, 0));
        last = b;
    }
    last->velocity.x = 1;
}
//<
//> little_door 17c 18b
// A door is struck, also across its hinge, for 10 s.
static void show_door(void)
{
    clear();
    body *post = body_add(box_make(0.1, 0.1, 0.1), vec3_make(0, 2, 0), 0);
    body *door = body_add(box_make(1, 2, 0.1), vec3_make(0.6, 2, 0), 10);
    hinge_add(post, door, vec3_make(0.05, 1, 0), vec3_make(0.05, 3, 0));
    door->spin = vec3_make(3, 3, 0);
    show("the door", 600);
    real tilt = sqrt(2 * real_max(0, 1 - door->axes.y.y));
    printf("the door: tilted %.2g rad\n", tilt);
}
//<
//> little_main_17 17a 17z
int main(void)
{
    cloth_on_cube(12, vec3_make(0, 0.9, 0));
    show("cloth on a cube", 100);
    chain_add(5, 1);
    show("chain of 5, 1 kg", 300);
    chain_add(50, 100);
    show("chain of 50, 100 kg", 300);
//<
//> little_main_17c 17c 17c
    show_door();
//<
//> little_main_17_end 17a 17z
}
//<

//> little_main_18a 18a 18a
int main(void)
{
    show_pile("ten boxes, 20 kg", 10, 20, 600);
    show_pile("1000 kg on 1 kg", 2, 1000, 300);
    room_add(4, 4.8);
    show("room of 64", 600);
    cloth_on_cube(12, vec3_make(0, 0.9, 0));
    show("cloth on a cube", 100);
    chain_add(50, 100);
    show("chain of 50, 100 kg", 300);
    show_door();
}
//<
//> little_main_18b 18b 18b
int main(void)
{
    time_to_sleep = 1e9;
    show_pile("ten boxes, 20 kg", 10, 20, 600);
    show_pile("1000 kg on 1 kg", 2, 1000, 300);
    time_to_sleep = 0.5;
    room_add(4, 4.8);
    show("room of 64", 600);
    cloth_on_cube(20, vec3_make(0, 0.9, 0));
    show("cloth on a cube", 120);
    chain_add(50, 100);
    show("chain of 50, 100 kg", 300);
    show_door();
}
//<
