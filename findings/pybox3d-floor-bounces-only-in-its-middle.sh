#!/usr/bin/env bash
# Finding: In pybox3d a ball that falls straight on a fixed floor bounces only if it lands in the middle of the floor: the floor takes the impact as if it could turn about its centre.
# Package: pybox3d 2026b0 (PyPI)
# Expected: A floor of mass 0 is fixed, so the place of an impact does not matter; with restitution 1 a ball comes back at 3 m/s everywhere.
# Seen: 3 m/s in the middle, 2.45 m/s at 0.2 m from it, 0.69 m/s at 0.5 m, none 1 m from it; 50 m from it the ball keeps 2.7 m/s downwards. The size of the floor does not matter, moving it along brings the bounce back. A smooth ball that slides 0.33 m before it lands loses half its rebound.
# Touches carom: Compare bounces with pybox3d only straight above the centre of its floor, which rules out a slide before the bounce.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pybox3d==2026b0 numpy==2.4.6
cd "$folder"
cat > middle.py <<'PYTHON'
import importlib.metadata
import sys

from pybox3d import RigidBody, Vec3, World

print("pybox3d", importlib.metadata.version("pybox3d"))
RADIUS, SPEED, STEP = 0.5, 3.0, 1 / 240


def rebound(place: float, centre: float = 0.0, half: float = 100.0, slide: float = 0.0) -> float:
    """Speed up, without gravity and friction, of a ball that comes down at `place`; its time of flight is 0.0333 s."""
    world = World(gravity=(0, 0, 0))
    world.sleeping_enabled = False
    floor = RigidBody(Vec3(centre, -1, 0), Vec3(half, 1, half), mass=0.0)
    ball = RigidBody.sphere((place, RADIUS + 0.1, 0), RADIUS, 1.0)
    for body in (floor, ball):
        body.friction, body.restitution = 0.0, 1.0
    ball.linear_velocity = Vec3(slide, -SPEED, 0)
    world.add_body(floor)
    handle = world.add_body(ball)
    for _ in range(96):
        world.step(STEP)
    return handle.linear_velocity.y


fault = False
for what, options, seen in (
    ("in the middle", {"place": 0.0}, 3.0),
    ("0.2 m off", {"place": 0.2}, 2.4545),
    ("0.5 m off", {"place": 0.5}, 0.6923),
    ("0.5 m off, floor of 2 by 2 m", {"place": 0.5, "half": 1.0}, 0.6923),
    ("1 m off", {"place": 1.0}, 0.0),
    ("50 m off", {"place": 50.0}, -2.6804),
    ("50 m off, floor moved along", {"place": 50.0, "centre": 50.0}, 3.0),
    ("in the middle, sliding at 10 m/s", {"place": 0.0, "slide": 10.0}, 1.4393),
):
    speed = rebound(**options)
    print(f"{what}: expected {SPEED:.3f} m/s up; seen {speed:.3f} m/s")
    fault |= abs(speed - seen) > 0.01
sys.exit(int(fault))
PYTHON
env/bin/python middle.py
