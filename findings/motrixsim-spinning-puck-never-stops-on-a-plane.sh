#!/usr/bin/env bash
# Finding: In MotrixSim a cylinder that spins on its base on a plane has no friction at all, whatever the coefficient; the same one on a box, or a box on the plane, stops in half a second.
# Package: motrixsim-core 0.10.1 (PyPI)
# Expected: Friction 0.3 under a puck of 0.1 m stops 20 rad/s in 0.34 s if it bears on its rim and in 0.51 s if it bears on all of its base; a plane and the flat face of a box are the same floor.
# Seen: 20.000 rad/s after three seconds on the plane, also with friction 1 and for a tall cylinder; 0 on the box. A plane grips it again when it slides: at 1 m/s 20 become 5 rad/s in 0.3 s.
# Touches carom: For curling stones, pucks and coins beside carom's torsion take a box as the floor in this engine.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check motrixsim-core==0.10.1 numpy==2.4.6
cd "$folder"
cat > puck.py <<'PYTHON'
import importlib.metadata
import sys

import motrixsim
import numpy as np

print("motrixsim-core", importlib.metadata.version("motrixsim-core"))
STEP, SPIN, RADIUS, GRAVITY = 0.002, 20.0, 0.1, 9.81
SCENE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}"/>
  <worldbody>
    <geom {floor} friction="{friction} 0 0"/>
    <body pos="0 0 {half}"><freejoint/><geom {body} mass="1" friction="{friction} 0 0"/></body>
  </worldbody>
</mujoco>
"""
FLOORS = {"plane": 'type="plane" size="50 50 1"', "box": 'type="box" size="5 5 0.5" pos="0 0 -0.5"'}


def spin(floor: str, body: str, half: float, friction: float, slide: float, time: float) -> float:
    """Spin about the vertical after a time."""
    model = motrixsim.load_mjcf_str(SCENE.format(step=STEP, gravity=GRAVITY, floor=FLOORS[floor], friction=friction, body=body, half=half))
    data = motrixsim.SceneData(model)
    velocity = np.array(data.dof_vel)
    velocity[0], velocity[5] = slide, SPIN
    data.set_dof_vel(velocity)
    for _ in range(round(time / STEP)):
        motrixsim.step(model, data)
    return float(np.array(data.dof_vel)[5])


PUCK, TALL, BRICK = 'type="cylinder" size="0.1 0.05"', 'type="cylinder" size="0.1 0.1"', 'type="box" size="0.1 0.1 0.05"'
fault = False
for name, floor, body, half, friction, slide, time, lowest, highest in (
    ("puck", "plane", PUCK, 0.05, 0.3, 0.0, 3.0, 19.99, 20.01),
    ("puck", "plane", PUCK, 0.05, 1.0, 0.0, 3.0, 19.99, 20.01),
    ("tall cylinder", "plane", TALL, 0.1, 0.3, 0.0, 3.0, 19.99, 20.01),
    ("puck", "box", PUCK, 0.05, 0.3, 0.0, 3.0, -0.01, 0.01),
    ("brick", "plane", BRICK, 0.05, 0.3, 0.0, 3.0, -0.01, 0.01),
    ("puck that slides at 1 m/s", "plane", PUCK, 0.05, 0.3, 1.0, 0.3, 2.0, 9.0),
):
    seen = spin(floor, body, half, friction, slide, time)
    stops = SPIN * RADIUS / (2 * friction * GRAVITY), 3 * SPIN * RADIUS / (4 * friction * GRAVITY)
    expected = "less than 20 rad/s" if slide else f"0 rad/s, since a disc stops after {stops[0]:.2f} to {stops[1]:.2f} s"
    print(f"{name} on a {floor}, friction {friction:g}, after {time:g} s: expected {expected}; seen {seen:.4f} rad/s")
    fault |= not lowest <= seen <= highest
sys.exit(int(fault))
PYTHON
env/bin/python puck.py | grep -v profiler
