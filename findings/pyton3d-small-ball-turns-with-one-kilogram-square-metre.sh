#!/usr/bin/env bash
# Finding: In pyton3d a ball with an inertia below 1e-4 kg m2 gets one of 1 kg m2: a billiard ball that grips the floor stops dead, a bowling ball rolls on.
# Package: pyton3d 0.2.0 (PyPI)
# Expected: A ball that slides at 1 m/s and grips in an impact leaves rolling at 5/7 m/s, 25 rad/s for a billiard ball, 6.6 rad/s for a bowling ball.
# Seen: The bowling ball does; the billiard ball leaves with 0.0001 m/s and 0.005 rad/s, a golf ball with less: to invert the inertia its determinant is compared with 1e-12, and below that the identity is taken. In mm and g the billiard ball is right.
# Touches carom: Impacts of small balls can be compared with carom's in mm and g only.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pyton3d==0.2.0
cd "$folder"
cat > small.py <<'PYTHON'
import importlib.metadata
import sys

from pyton3d import Material, PhysicsWorld, PlaneCollider, RigidBody, SphereCollider, Vec3

print("pyton3d", importlib.metadata.version("pyton3d"))


def grip(mass: float, radius: float, speed: float) -> tuple[float, float]:
    """Speed along over that before, and spin, after a plastic impact with much friction at three times the speed."""
    surface = Material(restitution=0.0, static_friction=5.0, dynamic_friction=5.0)
    world = PhysicsWorld(gravity=Vec3(0, 0, 0))
    world.force_generators.clear()  # no drag
    floor = RigidBody(position=Vec3(0, 0, 0), is_static=True)
    floor.collider = PlaneCollider(Vec3(0, 1, 0), 0.0)
    ball = RigidBody(position=Vec3(0, radius * 1.001, 0), mass=mass)
    ball.collider, ball.velocity = SphereCollider(radius), Vec3(speed, -3 * speed, 0)
    ball.linear_damping = ball.angular_damping = 1.0  # a factor for each step
    for body in (floor, ball):
        body.material = surface
        world.add_body(body)
    for _ in range(10):
        world.step(1e-3 * radius / speed)
    return ball.velocity.x / speed, -ball.angular_velocity.z


fault = False
for name, mass, radius, speed, right in (
    ("bowling ball, m and kg", 7.26, 0.108, 1.0, True),
    ("football, m and kg", 0.43, 0.11, 1.0, True),
    ("billiard ball, m and kg", 0.17, 0.0286, 1.0, False),
    ("billiard ball, mm and g", 170.0, 28.6, 1000.0, True),
    ("golf ball, m and kg", 0.0459, 0.02135, 1.0, False),
):
    along, spin = grip(mass, radius, speed)
    print(f"{name}: expected {5 / 7:.4f} of the speed and {5 / 7 * speed / radius:.3f} rad/s, seen {along:.4f} and {spin:.4f} rad/s")
    inertia = 0.4 * mass * radius**2 if right else 1.0
    kept = mass * radius**2 / (inertia + mass * radius**2)  # of the sliding of the contact, that is in the speed
    fault |= abs(along - kept) > 2e-3 or abs(spin * radius / speed / kept - 1) > 5e-3
sys.exit(int(fault))
PYTHON
env/bin/python small.py
