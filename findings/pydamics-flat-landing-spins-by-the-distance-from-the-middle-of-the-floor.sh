#!/usr/bin/env bash
# Finding: In pydamics a box that lands flat on a level floor is set spinning, the faster the farther it lands from the middle of the floor: 40 m away it leaves with 1800 times its energy.
# Package: pydamics 0.5.1 (PyPI)
# Expected: A flat landing turns nothing, wherever the floor ends: with restitution 0.5 the box rises at half its speed, with a quarter of its energy.
# Seen: It rises at half its speed, and turns at 4.5 rad/s for each metre between its centre and that of the floor: 22.5 rad/s at 5 m and 28 times the energy, 180 rad/s at 40 m. The contact is taken to be midway between the two centres.
# Touches carom: Compare the impact of a box with carom's rigid impact only above the centre of a solid, or land balls.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pydamics==0.5.1
cd "$folder"
cat > flat.py <<'PYTHON'
import importlib.metadata
import sys

import pydamics

print("pydamics", importlib.metadata.version("pydamics"))
SPEED = 3.0


class Floor:
    """A plain object that is made solid."""


def land(aside: float, restitution: float, width: float, height: float) -> tuple[float, float, float]:
    """Vertical velocity, spin and energy over that before of a box of 1 kg that lands flat `aside` of the middle."""
    floor = pydamics.solidify(Floor(), position=(0.0, 0.0))
    floor.seo.solid(width=100.0, height=1.0, restitution=restitution)
    box = pydamics.Entity(mass=1.0, position=(aside, 0.5 + height / 2 + 0.01))
    box.moment_of_inertia = (width**2 + height**2) / 12
    box.physics2d.collider(shape="box", width=width, height=height, restitution=restitution)
    box.velocity = pydamics.Vec2(0.0, -SPEED)
    world = pydamics.World()
    world.add_solid(floor)
    world.add(box)
    for _ in range(100):
        world.step(1e-3)
        if box.velocity.y > 0:
            break
    energy = (box.velocity.x**2 + box.velocity.y**2 + box.moment_of_inertia * box.angular_velocity**2) / SPEED**2
    return box.velocity.y, box.angular_velocity, energy


fault = False
WIDTH, HEIGHT = 6**0.5 / 2**0.5, 3**0.5  # moment of inertia 0.5 kg m2
for aside in (0.0, 1.0, 5.0, -5.0, 40.0):
    up, spin, energy = land(aside, 0.5, WIDTH, HEIGHT)
    print(f"{aside:+.0f} m from the middle of a floor of 100 m: expected 1.5 m/s, 0 rad/s, 0.25 of the energy; "
          f"seen {up:.2f} m/s, {spin:+.2f} rad/s, {energy:.2f} of it")
    fault |= abs(up - 1.5) > 1e-9 or abs(spin + 4.5 * aside) > 1e-9
    fault |= abs(energy - (2.25 + 0.5 * (4.5 * aside) ** 2) / 9) > 1e-9
up, spin, energy = land(5.0, 1.0, 1.0, 0.2)
print(f"flat box of 1 by 0.2 m, restitution 1, +5 m: expected 3 m/s, 0 rad/s; seen {up:.2f} m/s, {spin:+.1f} rad/s, {energy:.0f} times the energy")
fault |= abs(spin + 2.5 * 6 / ((1 + 0.04) / 12)) > 1e-6 or energy < 100
sys.exit(int(fault))
PYTHON
env/bin/python flat.py
