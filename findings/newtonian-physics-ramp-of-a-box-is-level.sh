#!/usr/bin/env bash
# Finding: In newtonian-physics a ramp is level: a box that is set at an angle is met as if it lay flat, so that a smooth ball comes to rest on a slope of 30 degrees; the same ramp as a polygon works.
# Package: newtonian-physics 0.2.0 (PyPI, module pyphysics)
# Expected: A smooth ball on a plane inclined by 30 degrees slides with g sin 30 = 4.9 m/s2, and a box and a polygon with the same corners are one body.
# Seen: On the box it falls to the height of the flat one and rests there at 30, 45 and 60 degrees; on the polygon it slides with 4.9, 6.9 and 8.5 m/s2.
# Touches carom: Slopes of a scene in carom turn with their angle; build them as polygons in this package before they are compared.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check newtonian-physics==0.2.0
cd "$folder"
cat > ramp.py <<'PYTHON'
import importlib.metadata
import math
import sys

from pyphysics import Body, Box, Circle, ConvexPolygon, Vec2, World

print("newtonian-physics", importlib.metadata.version("newtonian-physics"))
G, STEP, RADIUS = 9.81, 1 / 1000, 0.1


def slide(shape: object, angle: float) -> tuple[float, float, float]:
    """Acceleration along the ramp between 0.5 and 1 s, and the place of the ball after 1 s."""
    world = World(gravity=Vec2(0, -G))
    world.add(Body.static(shape=shape, angle=angle, friction=0, restitution=0))
    # Above the middle, just in touch with the turned ramp of thickness 1 m.
    ball = world.add(Body.dynamic(shape=Circle(RADIUS), position=Vec2(0, (0.5 + RADIUS) / math.cos(angle)),
                                  mass=1.0, friction=0, restitution=0, damping=0))
    speeds = []
    for step in range(1000):
        world.step(STEP)
        if step in (499, 999):
            speeds.append(math.hypot(ball.velocity.x, ball.velocity.y))
    return (speeds[1] - speeds[0]) / 0.5, ball.position.x, ball.position.y


fault = False
for degrees in (0, 30, 45, 60):
    angle = math.radians(degrees)
    expected = G * math.sin(angle)
    polygon, box = slide(ConvexPolygon.rectangle(40, 1), angle), slide(Box(40, 1), angle)
    print(f"{degrees} degrees: expected {expected:.2f} m/s2; seen on the polygon {polygon[0]:.2f} m/s2, "
          f"on the box {box[0]:.2f} m/s2, where the ball stays at height {box[2]:.3f} m")
    fault |= abs(polygon[0] - expected) > 0.05 or box[0] != 0 or abs(box[2] - (0.5 + RADIUS)) > 0.01
sys.exit(int(fault))
PYTHON
env/bin/python ramp.py
