#!/usr/bin/env bash
# Finding: In omi_physics the coefficient of static friction does nothing: a box that should stick on a slope by a static coefficient of 1, or 10, slides as if there were the sliding coefficient alone.
# Package: omi_physics 0.4.0 (PyPI)
# Expected: A box at rest on a slope of 20 degrees (tangent 0.364) stays while the static coefficient is above 0.364, and slides with g (sin - f cos) of the sliding coefficient f otherwise.
# Seen: With static 1 and sliding 0.1 it has 2.43 m/s after 1 s, the same as with static 0.1 or 10. With static 0 and sliding 0.5 it stays. Materials are read from files and written to them with both numbers.
# Touches carom: Static friction in a scene of carom holds a body up to its own limit; a scene of glTF with two coefficients is another motion here.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check omi_physics==0.4.0 numpy==2.4.6
cd "$folder"
cat > slope.py <<'PYTHON'
import importlib.metadata
import math
import sys

from omi_physics import PhysicsWorld, model

print("omi_physics", importlib.metadata.version("omi_physics"))
G, STEP = 9.81, 1 / 240


def slide(static: float, sliding: float, slope: float) -> float:
    """Speed after 1 s of a box that starts from rest on an inclined plane, m/s."""
    world = PhysicsWorld(gravity=model.Gravity(gravity=G, direction=(math.sin(slope), -math.cos(slope), 0)), fixed_dt=STEP, sleep_enabled=False)
    surface = world.add_material(model.Material(staticFriction=static, dynamicFriction=sliding))
    plane, box = world.add_shape(model.Shape.box((100, 1, 10))), world.add_shape(model.Shape.box((0.2, 0.1, 0.2)))
    world.add_body(model.Motion(type=model.STATIC), collider=model.Collider(shape=plane, physicsMaterial=surface), position=(0, -0.5, 0))
    body = world.add_body(model.Motion(type=model.DYNAMIC, mass=1.0),
                          collider=model.Collider(shape=box, physicsMaterial=surface), position=(0, 0.05, 0))
    for _ in range(240):
        world.step(STEP)
    return float(world.linear_velocity[body][0])


fault = False
slope = math.radians(20)
for static, sliding in ((0.1, 0.1), (1.0, 0.1), (10.0, 0.1), (0.5, 0.3), (0.5, 0.5)):
    alone = max(0.0, G * (math.sin(slope) - sliding * math.cos(slope)))
    expected = 0.0 if static > math.tan(slope) else alone
    seen = slide(static, sliding, slope)
    print(f"static {static:g}, sliding {sliding:g}: expected {expected:.3f} m/s after 1 s, seen {seen:.3f}, by the sliding coefficient alone {alone:.3f}")
    fault |= abs(seen - alone) > 1e-3
print(f"static 0, sliding 0.5: seen {abs(slide(0.0, 0.5, slope)):.3f} m/s")
fault |= abs(slide(0.0, 0.5, slope)) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python slope.py
