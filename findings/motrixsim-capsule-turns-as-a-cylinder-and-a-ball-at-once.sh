#!/usr/bin/env bash
# Finding: In MotrixSim every capsule, short or long, has 0.9 m r2 about its axis: half for a cylinder and two fifths for a ball, each of the whole mass.
# Package: motrixsim-core 0.10.1 (PyPI)
# Expected: Cylinder and caps share the mass, so the moment lies between 0.4 m r2 of a ball and 0.5 m r2 of a cylinder; a capsule that starts at 2 m/s without spin rolls on at 1.34 to 1.39 m/s.
# Seen: It rolls on at 1.053 m/s, whatever its length and mass, and down a slope at 0.76 to 0.78 of its acceleration; ball and cylinder are right, and so is the capsule whose moments are written into the file.
# Touches carom: Give capsules an `inertial` of their own before rolling or tangential restitution by this engine is compared with carom's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check motrixsim-core==0.10.1 numpy==2.4.6
cd "$folder"
cat > capsule.py <<'PYTHON'
import importlib.metadata
import math
import sys

import motrixsim
import numpy as np

print("motrixsim-core", importlib.metadata.version("motrixsim-core"))
R, STEP, SPEED, SLOPE = 0.1, 0.002, 2.0, math.radians(10)
SCENE = """
<mujoco>
  <option timestep="{step}" gravity="{along} 0 {down}"/>
  <worldbody>
    <geom type="plane" size="50 50 1" friction="1 0 0"/>
    <body pos="0 0 {radius}" quat="0.70710678 0.70710678 0 0"><freejoint/>{inertial}<geom {geom} friction="1 0 0"/></body>
  </worldbody>
</mujoco>
"""


def speed(geom: str, inertial: str, start: float, slope: float) -> float:
    """Speed after a second of a body that lies across x."""
    model = motrixsim.load_mjcf_str(SCENE.format(
        step=STEP, along=9.81 * math.sin(slope), down=-9.81 * math.cos(slope), radius=R, inertial=inertial, geom=geom))
    data = motrixsim.SceneData(model)
    velocity = np.array(data.dof_vel)
    velocity[0] = start
    data.set_dof_vel(velocity)
    for _ in range(round(1 / STEP)):
        motrixsim.step(model, data)
    return float(np.array(data.dof_vel)[0])


def capsule(half: float) -> float:
    """Moment of a capsule about its axis over m r2; `half` is half the length of its cylinder."""
    share = 2 * half / (2 * half + 4 / 3 * R)
    return 0.5 * share + 0.4 * (1 - share)


GIVEN = '<inertial pos="0 0 0" mass="1" diaginertia="0.026625 0.026625 0.00475"/>'
fault = False
for name, geom, inertial, right, stated in (
    ("ball", f'type="sphere" size="{R}" mass="1"', "", 0.4, 0.4),
    ("cylinder", f'type="cylinder" size="{R} 0.2" mass="1"', "", 0.5, 0.5),
    ("capsule 0.1 m long between its caps", f'type="capsule" size="{R} 0.05" mass="1"', "", capsule(0.05), 0.9),
    ("capsule 0.4 m long, 3 kg", f'type="capsule" size="{R} 0.2" mass="3"', "", capsule(0.2), 0.9),
    ("capsule 1 m long, by density", f'type="capsule" size="{R} 0.5" density="1000"', "", capsule(0.5), 0.9),
    ("capsule 0.4 m long, moments in the file", f'type="capsule" size="{R} 0.2"', GIVEN, capsule(0.2), capsule(0.2)),
):
    slides, rolls = speed(geom, inertial, SPEED, 0.0), speed(geom, inertial, 0.0, SLOPE)
    moments = SPEED / slides - 1, 9.81 * math.sin(SLOPE) / rolls - 1
    print(f"{name}: expected {SPEED / (1 + right):.4f} m/s after sliding, {9.81 * math.sin(SLOPE) / (1 + right):.4f} m/s down the slope, {right:.4f} m r2; "
          f"seen {slides:.4f}, {rolls:.4f} m/s, {moments[0]:.4f} and {moments[1]:.4f} m r2")
    fault |= any(abs(moment - stated) > 0.004 for moment in moments)
sys.exit(int(fault))
PYTHON
env/bin/python capsule.py | grep -v profiler
