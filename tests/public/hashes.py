"""The worlds of hashes.c in Python, which must print the same lines; then what
Python alone has."""

import tumble


def run(world, name, steps):
    for _ in range(steps):
        world.step()
    print(f"{name} {world.hash():016x}")
    return world


def on_ground():
    world = tumble.World()
    world.plane_add((0, 1, 0), 0, -1)
    return world


def readme():
    w = on_ground()
    box = w.shape_box((1, 1, 1), 2)
    falling = w.body_add(box, tumble.body_at(0, 3, 0))
    sign = w.body_add(box, tumble.body_at(4, 2, 0))
    w.joint_hinge(tumble.body_ground(), sign, (4, 2.5, 0), (0, 0, 1))
    w.body_push(falling, (4, 0, 0), (0, 3, 0))
    run(w, "readme", 300)


def heap():
    w = on_ground()
    shapes = [w.shape_box((0.4, 0.5, 0.6), 1), w.shape_sphere(0.3, 2), w.shape_icosahedron(0.3, 1), w.shape_capsule(0.5, 0.2, 3)]
    for k in range(16):
        o = tumble.body_at(0.1 * (k % 3), 0.5 + 0.7 * k, 0.05 * k)
        o.pose.rotation = tumble.quat_turn((1, k, 2), 0.3 * k)
        w.body_add(shapes[k % 4], o)
    return run(w, "heap", 120)


def cloth():
    w = on_ground()
    w.body_add(w.shape_sphere(0.5, 1), tumble.body_at(0, 1, 0, kind=tumble.STATIC))
    w.body_add(w.shape_cloth(12, 12, 1.6, 1.6, 0.5), tumble.body_at(0.1, 1.6, 0))
    rope = w.body_add(w.shape_rope(12, 1.5, 0.3), tumble.body_at(2, 1, 0))
    w.body_pin(rope, 0)
    run(w, "cloth", 40)


def hills():
    side = 9
    w = tumble.World()
    heights = [0.1 * (k * 7 % 5) for k in range(side * side)]
    w.body_add_heights(heights, side, side, 4, 4, 0, tumble.body_at(0, 0, 0))
    box = w.shape_box((0.4, 0.3, 0.4), 1)
    for k in range(6):
        w.body_add(box, tumble.body_at(0.5 * (k % 3) - 0.4, 1 + 0.4 * k, 0.2 * k - 0.5))
    run(w, "hills", 120)


def alone(w):
    """Many at once is what one by one is; failures; a saved world; old names; numpy."""
    assert tumble.World.box is tumble.World.shape_box and tumble.at is tumble.body_at and tumble.turn is tumble.quat_turn
    assert tumble.World.unjoin is tumble.World.joint_remove and not hasattr(tumble.World, "get_poses")
    bodies = w.bodies()
    rows = w.poses().tolist()
    assert len(rows) == len(bodies) == 16
    for body, row in zip(bodies, rows):
        pose = w.body_pose(body)
        assert row == [*pose.position, *pose.rotation]
    velocity, spin = w.velocities(bodies)
    assert velocity.tolist() == [[*w.body_velocity(b)] for b in bodies]
    assert spin.tolist() == [[*w.body_spin(b)] for b in bodies]
    assert w.poses([]).tolist() == [] and list(w.moved()) == [b for b in bodies if w.body_is_awake(b)]
    saved = w.save()
    other = tumble.World.load(saved)
    w.step()
    other.step()
    assert w.hash() == other.hash()
    w.restore(saved)
    w.step()
    assert w.hash() == other.hash()
    assert w.ray((0, 50, 0), (0, -5, 0), ~0 & 0xFFFFFFFF) and w.ray((90, 50, 0), (90, 40, 0), 1) is None
    w.body_remove(bodies[3])
    assert not w.body_exists(bodies[3]) and w.poses(bodies).tolist()[3] == [0, 0, 0, 0, 0, 0, 0]
    for wrong, why in [(lambda: w.body_remove(bodies[3]), "gone"), (lambda: w.shape_box((-1, 1, 1), 1), "side"),
                       (lambda: tumble.World(dt=-1), "dt"), (lambda: tumble.World.load(saved[:-1]), "")]:
        try:
            wrong()
        except tumble.Failure as failure:
            assert why in str(failure), failure
        else:
            assert False, "what fails did not say so"
    try:
        import numpy
    except ImportError:
        return
    memory = w.poses()
    array = numpy.asarray(memory)
    array[0, 0] = 7
    assert array.shape == (15, 7) and memory[0, 0] == 7         # a view, no copy
    grid = numpy.zeros((3, 3))
    assert w.body_exists(w.body_add_heights(grid, 3, 3, 1, 1, 0, tumble.body_at(0, -9, 0)))


readme()
w = heap()
cloth()
hills()
alone(w)
