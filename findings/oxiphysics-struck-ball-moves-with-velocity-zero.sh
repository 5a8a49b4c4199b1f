#!/usr/bin/env bash
# Finding: In oxiphysics a head-on collision of balls changes no velocity: the struck ball is carried along at half the speed while its velocity reads 0, whatever the restitution.
# Package: oxiphysics 0.1.2 (PyPI)
# Expected: Of two equal smooth balls with restitution 1 the moving one stops and the other leaves with 3 m/s; with 0 both go on at 1.5 m/s; in a glancing hit the momentum stays.
# Seen: Both ways the velocities stay 3 and 0 m/s, while both balls advance 1.5 m each second. In a glancing hit only the first ball gains momentum across, -0.35 kg m/s against 0, and the other stands still. A ball falls through a fixed box of 200 by 2 by 200 m without a contact, as balls meet only balls.
# Touches carom: No collision of oxiphysics tells anything about a law of carom's; compare free flight at most.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check oxiphysics==0.1.2
cd "$folder"
cat > carried.py <<'PYTHON'
import importlib.metadata
import sys

from oxiphysics import PhysicsWorld, RigidBodyConfig

print("oxiphysics", importlib.metadata.version("oxiphysics"))
RADIUS, SPEED, STEP = 0.5, 3.0, 1 / 240


def ball(world: PhysicsWorld, place: tuple, velocity: tuple, restitution: float) -> int:
    """A smooth ball of 1 kg."""
    config = RigidBodyConfig.dynamic(1.0, *place)
    config.add_sphere(RADIUS)
    config.set_friction(0.0)
    config.set_restitution(restitution)
    config.set_linear_damping(0.0)
    config.set_angular_damping(0.0)
    config.set_velocity(*velocity)
    return world.add_rigid_body(config)


def hit(restitution: float, aside: float, seconds: float) -> tuple[list, list]:
    """Velocities and mean velocities over the last tenth of a second of both balls; they touch after 0.1 s."""
    world = PhysicsWorld.with_zero_gravity()
    balls = [ball(world, (-1.3, 0, 0), (SPEED, 0, 0), restitution), ball(world, (0, aside, 0), (0, 0, 0), restitution)]
    for _ in range(round((seconds - 0.1) / STEP)):
        world.step(STEP)
    before = [world.get_position(one) for one in balls]
    for _ in range(24):
        world.step(STEP)
    after = [world.get_position(one) for one in balls]
    return [world.get_velocity(one) for one in balls], [[(b - a) / 0.1 for a, b in zip(*two)] for two in zip(before, after)]


fault = False
for restitution in (1.0, 0.0):
    velocities, means = hit(restitution, 0.0, 0.5)
    expected = SPEED * (1 - restitution) / 2, SPEED * (1 + restitution) / 2
    print(f"head-on, restitution {restitution:g}: expected {expected[0]:g} and {expected[1]:g} m/s;", end=" ")
    print(f"seen {velocities[0][0]:.3f} and {velocities[1][0]:.3f} m/s, by the positions {means[0][0]:.3f} and {means[1][0]:.3f} m/s")
    fault |= abs(velocities[0][0] - SPEED) > 1e-6 or abs(velocities[1][0]) > 1e-6
    fault |= abs(means[0][0] - SPEED / 2) > 0.01 or abs(means[1][0] - SPEED / 2) > 0.01
velocities, _ = hit(1.0, -0.5, 1.0)
print(f"glancing: expected momenta across of -p and p; seen {velocities[0][1]:.4f} and {velocities[1][1]:.4f} kg m/s")
fault |= abs(velocities[0][1] + 0.35) > 0.01 or abs(velocities[1][1]) > 1e-6

world = PhysicsWorld.with_zero_gravity()
floor = RigidBodyConfig.static_body(0, -1, 0)
floor.add_box(100, 1, 100)
floor.set_restitution(1.0)
world.add_rigid_body(floor)
falling, contacts = ball(world, (0, 0.7, 0), (0, -SPEED, 0), 1.0), 0
for _ in range(240):
    world.step(STEP)
    contacts = max(contacts, world.contact_count())
height, speed = world.get_position(falling)[1], world.get_velocity(falling)[1]
print(f"ball on a fixed box: expected at 3.3 m, rising at 3 m/s; seen at {height:.2f} m, {speed:.2f} m/s, {contacts} contacts")
fault |= abs(height + 2.3) > 0.02 or abs(speed + SPEED) > 1e-6 or contacts != 0
sys.exit(int(fault))
PYTHON
env/bin/python carried.py
