#!/usr/bin/env bash
# Finding: In MultibodyPy the bilinear law of friction returns its coefficient as the force: above the speed of sticking a contact under 1000 N has 0.35 N, and pushes the body on instead of braking it.
# Package: MultibodyPy 0.0.5 (PyPI)
# Expected: Under 1000 N, with 0.4 at 0.01 m/s that falls to 0.3 at 0.02 m/s, a body that slides with 0.015 m/s is held back by 350 N, as the Stribeck law of the package does with these numbers, and one under 10 N by 3.5 N.
# Seen: 0.35 N under 1, 10 and 1000 N alike, in the direction of sliding; below 0.01 m/s the force is right, so that it falls from 400 N to nothing at that speed. At 1 m/s it is -9.5 N whatever the load, as the straight line goes on.
# Touches carom: Check the sign and the load of friction before a stick-slip or braking run is compared with carom's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile MultibodyPy==0.0.5 numpy==1.26.4 scipy==1.11.4
cd "$folder"
cat > brake.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from MultibodyPy import bodies, forces

STIFFNESS = 1e6  # N/m
STATIC, CREEP, DYNAMIC, SLIDING = 0.4, 0.01, 0.3, 0.02  # coefficients and the speeds (m/s) where they hold


def force(law, load: float, speed: float) -> np.ndarray:
    """Force on a body that slides along x with its contact pressed in by load / stiffness."""
    ground = bodies.Ground([0, 0, 0, 1] + [0] * 9)
    body = bodies.RigidBody(np.eye(3), np.eye(3), [0, 0, -load / STIFFNESS, 1, 0, 0, 0, speed, 0, 0, 0, 0, 0])
    body.A0Kd = ground.A0Kd = np.zeros((3, 3))  # no spin
    marks = (bodies.Marker([0, 0, 0], body), bodies.Marker([0, 0, 0], ground))
    contact = forces.KelvinVoigtContact(body, ground, *marks, np.array([0.0, 0.0, 1.0]), STIFFNESS, 0.0, law)
    return contact.get_force()[0]


print("MultibodyPy", importlib.metadata.version("MultibodyPy"))
bilinear = forces.BilinearFriction(DYNAMIC, SLIDING, STATIC, CREEP)
stribeck = forces.StribeckFriction(STATIC, CREEP, DYNAMIC, SLIDING)
fault = False
for load in (1.0, 10.0, 1000.0):
    for speed in (0.005, 0.015, SLIDING, 1.0):
        right, seen = force(stribeck, load, speed), force(bilinear, load, speed)
        coefficient = np.interp(speed, [0, CREEP, SLIDING], [0, STATIC, DYNAMIC])
        print(f"load {load:g} N, {speed:g} m/s: expected {-coefficient * load:.4f} N along x; Stribeck law {right[0]:.4f} N, bilinear law {seen[0]:.4f} N; normal {seen[2]:.4f} N")
        fault |= abs(right[0] + coefficient * load) > 1e-6 * load or abs(seen[2] - load) > 1e-6 * load
        if speed < CREEP:
            fault |= abs(seen[0] - right[0]) > 1e-6 * load
        else:
            line = DYNAMIC + (DYNAMIC - STATIC) / (SLIDING - CREEP) * (speed - SLIDING)
            fault |= abs(seen[0] - line) > 1e-6
sys.exit(int(fault))
PYTHON
env/bin/python brake.py
