#!/usr/bin/env bash
# Finding: In pyrigidbody3d the order in which bodies are added decides their impact: a floor that is added after a ball lets it through, and of two balls only the later one has a restitution.
# Package: pyrigidbody3d 0.3 (PyPI)
# Expected: A ball of restitution 1 that falls at 3 m/s on a floor of restitution 1 rises at 3 m/s, and an impact of two balls is the same whichever was added first.
# Seen: With the floor first it rises at 3.15 m/s, with the ball first it falls on through it at 3 m/s without a contact. Restitutions 1 and 0 of two balls give 1.43 and 1.57 m/s, 0 and 1 give -0.07 and 3.07 m/s; the floor's own never counts.
# Touches carom: Add floors first and give both bodies one restitution before an impact is compared with carom's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check setuptools==75.8.0 wheel==0.45.1 numpy==2.2.6
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-build-isolation --no-deps pyrigidbody3d==0.3
cd "$folder"
cat > last.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from pyrigidbody3d import geometry, rigidbody, world

print("pyrigidbody3d", importlib.metadata.version("pyrigidbody3d"))
SPEED, STEP, RADIUS = 3.0, 1e-3, 0.5


def ball(place: tuple, velocity: tuple, restitution: float) -> rigidbody.RigidBody:
    """A smooth ball of 1 kg."""
    body = rigidbody.RigidBody(1.0, geometry.Sphere(RADIUS))
    body.world_pose.position, body.linear_velocity = np.array(place, float), np.array(velocity, float)
    body.restitution, body.friction_coeffcient = restitution, 0.0
    return body


def run(bodies: list) -> None:
    """A tenth of a second without gravity."""
    space = world.World(1)
    space.gravity = np.zeros(3)
    space.bodies += bodies
    for _ in range(100):
        space.step(STEP)


def fall(floor_first: bool, of_ball: float, of_floor: float) -> tuple[float, float]:
    """Height over the contact and vertical velocity of a ball that falls from 1 cm."""
    floor = rigidbody.RigidBody(0.0, geometry.Plane())
    floor.restitution, floor.friction_coeffcient = of_floor, 0.0
    falling = ball((0, 0, RADIUS + 0.0105), (0, 0, -SPEED), of_ball)
    run([floor, falling] if floor_first else [falling, floor])
    return falling.world_pose.position[2] - RADIUS, falling.linear_velocity[2]


fault = False
for floor_first, of_ball, of_floor, value in (
    (True, 1.0, 1.0, 3.15), (False, 1.0, 1.0, -3.0), (True, 1.0, 0.0, 3.15), (True, 0.0, 1.0, 0.15),
):
    height, speed = fall(floor_first, of_ball, of_floor)
    print(f"{'floor' if floor_first else 'ball'} first, restitution of ball {of_ball:g}, of floor {of_floor:g}: "
          f"seen {speed:+.2f} m/s at {height:+.2f} m over the floor")
    fault |= abs(speed - value) > 0.01 or (height < 0) != (not floor_first)
print("expected: the first two alike, +3 m/s above the floor, and the last two alike")
for first, second, values in ((1.0, 0.0, (1.425, 1.575)), (0.0, 1.0, (-0.075, 3.075))):
    one, two = ball((-1.0105, 0, 0), (SPEED, 0, 0), first), ball((0, 0, 0), (0, 0, 0), second)
    run([one, two])
    print(f"two balls of restitution {first:g} and {second:g}: expected the same in both lines, "
          f"seen {one.linear_velocity[0]:.3f} and {two.linear_velocity[0]:.3f} m/s")
    fault |= not np.allclose([one.linear_velocity[0], two.linear_velocity[0]], values, atol=0.01)
sys.exit(int(fault))
PYTHON
env/bin/python last.py
