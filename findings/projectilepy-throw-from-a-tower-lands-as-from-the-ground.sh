#!/usr/bin/env bash
# Finding: In projectilepy the height of a throw does nothing: a ball thrown from a tower of 100 m starts at 0 and lands as one that is thrown from the ground.
# Package: projectilepy 0.2.1 (PyPI)
# Expected: `initial_height` is the height of launch: at 20 m/s and 30 degrees a ball from 2 m lands at 38.4 m, one from 100 m at 97.8 m, and the highest points lie as much higher.
# Seen: All land at 35.3 m after 2.04 s and rise to 5.1 m, and the first position is (0, 0), without drag and with it. The package itself offers to solve for the height of launch.
# Touches carom: Speed and angle at landing are the start of a bounce in carom; shift heights by hand and stop at minus the height (`stop_height`).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check projectilepy==0.2.1 numpy==2.4.6
cd "$folder"
cat > tower.py <<'PYTHON'
import importlib.metadata
import math
import sys

import projectilepy

print("projectilepy", importlib.metadata.version("projectilepy"))
SPEED, ANGLE, G = 20.0, 30.0, 9.81
across, up = SPEED * math.cos(math.radians(ANGLE)), SPEED * math.sin(math.radians(ANGLE))
BALL = dict(drag="Newtonian", mass=0.145, drag_coefficient=0.35, cross_sectional_area=0.0043)


def throw(height: float, **settings) -> tuple[float, float, float]:
    model = projectilepy.model(SPEED, ANGLE, initial_height=height, gravity=G, **settings)
    model.run()
    return model.final_position()[0], model.max_height(), model.positionValues[0][1]


fault = False
ground, dragged = throw(0.0), throw(0.0, **BALL)
for height in (0.0, 2.0, 100.0):
    time = (up + math.sqrt(up * up + 2 * G * height)) / G
    length, top, start = throw(height)
    print(f"thrown from {height:g} m: expected to land at {across * time:.2f} m and to rise to {height + up * up / (2 * G):.2f} m; "
          f"seen {length:.2f} m and {top:.2f} m, start at {start:g} m")
    fault |= (length, top, start) != ground or throw(height, **BALL) != dragged
    fault |= abs(length / (across * 2 * up / G) - 1) > 1e-3 or start != 0
print(f"with drag from every height: {dragged[0]:.2f} m")
# From the ground the flight is right, and so is a lower target.
model = projectilepy.model(SPEED, ANGLE, gravity=G)
model.run(stop_height=-100)
time = (up + math.sqrt(up * up + 200 * G)) / G
print(f"stopped at -100 m: expected {across * time:.2f} m, seen {model.final_position()[0]:.2f} m")
fault |= abs(model.final_position()[0] / (across * time) - 1) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python tower.py
