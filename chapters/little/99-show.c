//> little_wrecker 18c
// A load of 40 kg on a level chain, which falls and swings towards +x.
static void wrecker_add(vec3 top, int links)
{
    const shape *link = box_make(0.2, 0.05, 0.05);
    const shape *load = icosahedron_make(0.3);
    body *last = body_add(link, vec3_add(top, vec3_make(0.1, 0, 0)), 0);
    for (int i = 0; i <= links; i++) {
        vec3 end = vec3_add(top, vec3_make(-0.2 * i, 0, 0));
        vec3 at = vec3_add(end, vec3_make(i < links ? -0.1 : -0.3, 0, 0));
        body *b = body_add(i < links ? link : load, at, i < links ? 1 : 40);
        joint_add(last, b, end);
        last = b;
    }
}
//<
//> little_wall 18c
// Bricks of 2 kg in six rows, each row half a brick along.
static void wall_add(real x)
{
    const shape *brick = box_make(0.3, 0.3, 0.5);
    for (int row = 0; row < 6; row++)
        for (int i = row % 2; i < 6; i++) {
            real z = 0.51 * (i - 2.5 - row % 2 / 2.0);
            body_add(brick, vec3_make(x, 0.15 + 0.3 * row, z), 2);
        }
}
//<
//> little_gate 18c
// A gate on a post, 1 m wide and ajar.
static void gate_add(vec3 at)
{
    vec3 middle = vec3_add(at, vec3_make(0, 0, 0.55));
    vec3 low = vec3_add(at, vec3_make(0, -0.4, 0.05));
    body *post = body_add(box_make(0.1, 1, 0.1), at, 0);
    body *gate = body_add(box_make(0.06, 0.8, 1), middle, 5);
    hinge_add(post, gate, low, vec3_add(low, vec3_make(0, 0.8, 0)));
}
//<
//> little_main_18c 18c
// A wall and what breaks it, a cloth over a cube and what falls on it, a gate.
static void show_engine(void)
{
    cloth_on_cube(20, vec3_make(0, 0.9, 0));
    wall_add(-1.6);
    wrecker_add(vec3_make(-1.9, 2.9, 0), 10);
    gate_add(vec3_make(1.3, 0.55, -0.5));
    const shape *ball = icosahedron_make(0.15);
    for (int i = 0; i < 3; i++) {
        vec3 at = { 0.2 * i - 0.2, 2 + i, 0.1 * i };
        body_turn(body_add(ball, at, 0.3), vec3_make(0, 0.5 * i, 0));
    }
    show("your engine", 300);
}

int main(int count, char **arguments)
{
    drawing = count > 1 && arguments[1][0] == 'd';
    show_engine();
}
//<
