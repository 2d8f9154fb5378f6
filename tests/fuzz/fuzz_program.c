// fuzz_program.c - tumble.h called in any order, with any ids and numbers.  See
// fuzz.h.
//
// Each call takes a byte or two: which function, which of the ids that are
// known (those that went are kept, too), and numbers from a list of nasty ones.
// What is refused must say why; what stands must stay finite; and what is saved
// and loaded must go on with the same bits.

#include "fuzz.h"
#include "tumble.h"

#include <math.h>

enum { MOST_IDS = 24, MOST_STEPS = 40, MOST_CALLS = 200 };

static const uint8_t *at, *end;
static tumble_world *w;
static tumble_shape shape[MOST_IDS];
static tumble_body body[MOST_IDS];
static tumble_joint joint[MOST_IDS];
static tumble_plane wall[MOST_IDS];
static int shapes, bodies, joints, walls, steps;

static unsigned byte(void) { return at < end ? *at++ : 0; }

static double number(void)
{
    static const double list[] = {
        0, 1, -1, 0.5, 0.1, 2, 3, -0.3, 10, 0.01, 1.0 / 3, 4, 5, 0.7, -2, 1.5 };
    static const double nasty[] = {
        (double)NAN, HUGE_VAL, -HUGE_VAL, 1e300, -1e17, 1e-300, 1e9, -1e5 };
    unsigned b = byte();
    if (b < 240) return list[b % 16];
    return nasty[b % 8];
}

static tumble_vec3 triple(void)
{
    double x = number(), y = number();
    return tumble_v(x, y, number());
}

static tumble_shape any_shape(void)
{
    unsigned b = byte();
    tumble_shape none = { b, b };
    return shapes > 0 && b < 250 ? shape[b % (unsigned)shapes] : none;
}

static tumble_body any_body(void)
{
    unsigned b = byte();
    tumble_body none = { b, b };
    if (b == 249) return tumble_body_ground();
    return bodies > 0 && b < 249 ? body[b % (unsigned)bodies] : none;
}

static tumble_joint any_joint(void)
{
    unsigned b = byte();
    tumble_joint none = { b, b };
    return joints > 0 && b < 250 ? joint[b % (unsigned)joints] : none;
}

static int few(void) { return (int)(byte() % 12) - 1; }

static void make_shape(void)
{
    tumble_vec3 point[8];
    tumble_shape s = { 0, 0 };
    if (shapes == MOST_IDS) return;
    switch (byte() % 9) {
    case 0: s = tumble_shape_box(w, triple(), number()); break;
    case 1: s = tumble_shape_icosahedron(w, number(), number()); break;
    case 2: s = tumble_shape_sphere(w, number(), number()); break;
    case 3: { double l = number(), r = number();
              s = tumble_shape_capsule(w, l, r, number()); break; }
    case 4: for (int k = 0; k < 8; k++) point[k] = triple();
            s = tumble_shape_hull(w, point, few() % 9, number()); break;
    case 5: { int n = few(); double l = number();
              s = tumble_shape_rope(w, n, l, number()); break; }
    case 6: { int n = few(), m = few(); double l = number(), d = number();
              s = tumble_shape_cloth(w, n, m, l, d, number()); break; }
    case 7: { double l = number(), r = number();
              s = tumble_shape_cylinder(w, l, r, number()); break; }
    case 8: { double l = number(), r = number();
              s = tumble_shape_cone(w, l, r, number()); break; }
    }
    MUST(s.generation != 0 || tumble_world_failure(w), "refused in silence");
    if (s.generation != 0) shape[shapes++] = s;
}

static void make_body(void)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = (tumble_kind)(byte() % 3);
    o.pose.position = triple();
    o.pose.rotation = tumble_quat_turn(triple(), number());
    o.velocity = triple();
    o.spin = triple();
    o.friction = number();
    o.restitution = number();
    o.damping = number();
    if (byte() % 4 == 0) o.mask = byte();
    if (bodies == MOST_IDS) return;
    tumble_body b = tumble_body_add(w, any_shape(), o);
    MUST(b.generation != 0 || tumble_world_failure(w), "refused in silence");
    if (b.generation != 0) body[bodies++] = b;
}

// A few triangles, or a small terrain.
static void make_surface(void)
{
    tumble_vec3 point[8];
    double height[64];
    int corner[18];
    tumble_body_options o = tumble_body_at(number(), number(), number());
    tumble_body b;
    if (bodies == MOST_IDS) return;
    if (byte() % 4 == 0) o.mask = byte();
    o.pose.rotation = tumble_quat_turn(triple(), number());
    for (int k = 0; k < 8; k++) point[k] = triple();
    for (int k = 0; k < 18; k++) corner[k] = byte() % 256 == 255 ? 8 : byte() % 8;
    for (int k = 0; k < 64; k++) height[k] = byte() % 8 ? 0 : number();
    int n = few(), m = few();
    double deep = byte() % 4 ? 0 : number();
    if (byte() % 2)
        b = tumble_body_add_mesh(w, point, 8, corner, n % 7, deep, o);
    else {
        double wide = number();
        b = tumble_body_add_heights(w, height, n < 8 ? n : 8, m < 8 ? m : 8,
                                    wide, number(), deep, o);
    }
    MUST(b.generation != 0 || tumble_world_failure(w), "refused in silence");
    if (b.generation != 0) body[bodies++] = b;
}

static void make_joint(void)
{
    tumble_body a = any_body(), b = any_body();
    tumble_vec3 p = triple(), q = triple();
    tumble_joint j = { 0, 0 };
    if (joints == MOST_IDS) return;
    switch (byte() % 6) {
    case 0: j = tumble_joint_ball(w, a, b, p); break;
    case 1: j = tumble_joint_hinge(w, a, b, p, q); break;
    case 2: j = tumble_joint_fixed(w, a, b, p); break;
    case 3: { double least = number();
              j = tumble_joint_distance(w, a, p, b, q, least, number());
              break; }
    case 4: j = tumble_joint_hang(w, a, few(), b); break;
    case 5: j = tumble_joint_slider(w, a, b, p, q); break;
    }
    MUST(j.generation != 0 || tumble_world_failure(w), "refused in silence");
    if (j.generation != 0) joint[joints++] = j;
}

static void touch(void)
{
    tumble_body b = any_body();
    bool done = false;
    tumble_vec3 p = triple(), q = triple();
    tumble_pose pose = { p, tumble_quat_turn(q, number()) };
    switch (byte() % 15) {
    case 0:  done = tumble_body_push(w, b, p, q); break;
    case 1:  done = tumble_body_force(w, b, p, q); break;
    case 2:  done = tumble_body_set_pose(w, b, pose); break;
    case 3:  done = tumble_body_set_velocity(w, b, p, q); break;
    case 4:  done = tumble_body_wake(w, b); break;
    case 5:  done = tumble_body_sleep(w, b); break;
    case 6:  done = tumble_body_set_material(w, b, p.x, p.y); break;
    case 7:  done = tumble_body_set_damping(w, b, p.x, p.y); break;
    case 8:  done = tumble_body_set_filter(w, b, byte(), byte()); break;
    case 9:  done = tumble_body_pin(w, b, few()); break;
    case 10: done = tumble_body_unpin(w, b, few()); break;
    case 11: done = tumble_body_push_vertex(w, b, few(), p); break;
    case 12: done = tumble_body_set_bending(w, b, p.x); break;
    case 13: done = tumble_body_remove(w, b); break;
    case 14: done = tumble_body_set_vertex_velocity(w, b, few(), p); break;
    }
    MUST(done || tumble_world_failure(w), "refused in silence");
}

static bool drive(tumble_joint j)
{
    double speed = number(), force = number(), more = number();
    switch (byte() % 5) {
    case 0:  return tumble_joint_set_motor(w, j, speed, force);
    case 1:  return tumble_joint_set_spring(w, j, speed, force, more);
    case 2:  return tumble_joint_set_servo(w, j, speed, force, more, number());
    case 3:  return tumble_joint_set_friction(w, j, force);
    default: return tumble_joint_set_cone(w, j, triple(), speed, force, more);
    }
}

static void hold(void)
{
    tumble_joint j = any_joint();
    bool done = false;
    switch (byte() % 4) {
    case 0: { double least = number();
              done = tumble_joint_set_limits(w, j, least, number()); break; }
    case 1: done = tumble_joint_set_strength(w, j, number()); break;
    case 2: done = tumble_joint_remove(w, j); break;
    case 3: done = drive(j); break;
    }
    MUST(done || tumble_world_failure(w), "refused in silence");
    (void)(tumble_joint_force(w, j) + tumble_joint_gap(w, j)
           + tumble_joint_torque(w, j)
           + tumble_joint_angle(w, j) + tumble_joint_speed(w, j)
           + tumble_joint_drive(w, j) + tumble_joint_swing(w, j)
           + tumble_joint_twist(w, j));
}

static void walk(tumble_vec3 p, tumble_vec3 way)
{
    tumble_walker how = tumble_walker_capsule(number(), number());
    tumble_walk at = { .position = p, .ground = any_body(), .stands = byte() % 2 };
    how.step = number();
    for (int k = 0; k < 3; k++)
        if (tumble_world_walk(w, how, at, way, &at)) {
            tumble_vec3 x = at.position;
            MUST(x.x - x.x == 0 && x.y - x.y == 0 && x.z - x.z == 0, "walk");
        }
}

static void look(void)
{
    tumble_hit h;
    tumble_body met[4];
    tumble_contact c[4];
    tumble_event e[4];
    tumble_vec3 p = triple(), q = triple(), v[4];
    tumble_pose pose = { p, { 0, 0, 0, 1 } };
    switch (byte() % 7) {
    case 0: if (tumble_world_ray(w, p, q, ~0u, &h))
                MUST(h.fraction >= 0 && h.fraction <= 1, "%g", h.fraction);
            break;
    case 1: tumble_world_nearest(w, p, q.x, byte(), &h); break;
    case 2: tumble_world_overlap(w, any_shape(), pose, ~0u, met, 4); break;
    case 3: tumble_world_sweep(w, any_shape(), pose, q, ~0u, &h); break;
    case 4: MUST(tumble_world_contacts(w, c, 4) >= 0, "contacts"); break;
    case 5: MUST(tumble_world_events(w, e, 4) >= 0, "events"); break;
    case 6: walk(p, q); break;
    }
    MUST(tumble_body_vertices(w, any_body(), v, 4) >= 0, "vertices");
}

// Whatever number was accepted, all that comes out is finite.
static void check(void)
{
    for (int k = 0; k < bodies; k++) {
        tumble_vec3 p = tumble_body_position(w, body[k]);
        MUST(p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0, "body %d", k);
    }
    const char *why = tumble_world_failure(w);
    MUST(!why || (strlen(why) > 0 && !strchr(why, '\n')), "one sentence");
    tumble_world_forget_failure(w);
}

// The world is saved and thrown away, and the loaded one goes on as it would
// have; of bytes of which one is another nothing is loaded.
static void save_and_load(void)
{
    size_t size = tumble_world_save(w, NULL, 0), where = byte() * 256 + byte();
    unsigned char *kept = malloc(size);
    if (!kept) return;
    MUST(tumble_world_save(w, kept, size) == size, "%zu bytes", size);
    tumble_world *copy = tumble_world_load(kept, size);
    MUST(copy, "%s", tumble_world_failure(NULL));
    kept[where % size] ^= (unsigned char)(1 << where % 8);
    MUST(!tumble_world_load(kept, size), "byte %zu was altered", where % size);
    free(kept);
    for (int k = 0; k < 4; k++) {
        MUST(tumble_world_hash(copy) == tumble_world_hash(w), "%d steps later",
             k);
        tumble_world_step(copy);
        tumble_world_step(w);
    }
    tumble_world_free(w);
    w = copy;
    steps += 4;
}

static void change_walls(void)
{
    unsigned b = byte();
    tumble_vec3 normal = triple();
    if (b % 2 == 0 && walls < MOST_IDS) {
        tumble_plane p = tumble_plane_add(w, normal, number(), number());
        MUST(p.generation != 0 || tumble_world_failure(w),
             "refused in silence");
        if (p.generation != 0) wall[walls++] = p;
    } else {
        tumble_plane p = { b, b };
        if (walls > 0 && b < 250) p = wall[b % (unsigned)walls];
        MUST(tumble_plane_remove(w, p) || tumble_world_failure(w),
             "refused in silence");
    }
}

static void call(void)
{
    switch (byte() % 10) {
    case 0: make_shape(); break;
    case 1: case 2: if (byte() % 4 == 0) make_surface();
                    else make_body();
                    break;
    case 3: make_joint(); break;
    case 4: touch(); break;
    case 5: hold(); break;
    case 6: look(); break;
    case 7: if (byte() % 8 == 0) change_walls();
            else if (byte() % 8 == 0) tumble_shape_remove(w, any_shape());
            break;
    case 8: for (int k = byte() % 4; k >= 0 && steps < MOST_STEPS; k--, steps++)
                tumble_world_step(w);
            break;
    case 9: if (steps < MOST_STEPS) save_and_load();
            break;
    }
    check();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    tumble_options o = tumble_options_default();
    at = data, end = data + size;
    shapes = bodies = joints = walls = steps = 0;
    o.most_substeps = 20;
    o.restitution = byte() % 4 == 0 ? 1 : 0;
    w = tumble_world_make(&o);
    for (int k = 0; w && at < end && k < MOST_CALLS; k++) call();
    tumble_world_free(w);
    return 0;
}
