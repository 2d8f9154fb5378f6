#> rollouts-py
# rollouts.py - two thousand futures of one world, in Python: rollouts.c again.

import math
import tumble

ROLLOUTS, SPEED, GRAVITY = 2000, 10, 9.81       # m/s, m/s^2

w = tumble.World()
ball = w.body_add(w.shape_sphere(0.1, 1), tumble.body_at(0, 0, 0))
saved = w.save()


def roll_out(angle):
    """The same world again, and one throw, until the ball is as low as it began."""
    w = tumble.World.load(saved)
    w.body_set_velocity(ball, (SPEED * math.cos(angle), SPEED * math.sin(angle), 0), (0, 0, 0))
    before, at = None, w.body_position(ball)
    while before is None or at.y > 0:
        before = at
        w.step()
        at = w.body_position(ball)
    return before.x + (at.x - before.x) * before.y / (before.y - at.y)


angle = [math.pi / 2 * (k + 0.5) / ROLLOUTS for k in range(ROLLOUTS)]
reached = [roll_out(a) for a in angle]
best = max(range(ROLLOUTS), key=lambda k: reached[k])
print(f"the best of {ROLLOUTS}: {angle[best]:.3f} rad, {reached[best]:.4f} m far; "
      f"v^2 / g is {SPEED * SPEED / GRAVITY:.4f} m")
#<
