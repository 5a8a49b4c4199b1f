#!/usr/bin/env bash
# Finding: In distance3d the contact force of a ball on a box gains a part that grows with the distance of the scene from the origin, and no longer is opposite to the force on the ball.
# Package: distance3d 0.9.1 (PyPI)
# Expected: The hydroelastic pressure between a ball and a flat face acts along the normal of the face: no force along it, equal and opposite forces, the same wherever the two stand.
# Seen: 0.3 m off the axis of the box the force leans by 30 degrees; with the scene 100 m aside the force along the normal is 31 times as large, 100 m above it there is a force along the face, 31 times the normal one. The ball's own force is right.
# Touches carom: Take the force on the first body and turn it round, not the force on the second, and put the scene at the origin, before forces are compared.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check distance3d==0.9.1 numpy==2.4.6
cd "$folder"
cat > leaning.py <<'PYTHON'
import importlib.metadata
import sys
import warnings

warnings.simplefilter("ignore")
import numpy as np
from distance3d.hydroelastic_contact import RigidBody, contact_forces

print("distance3d", importlib.metadata.version("distance3d"))
ASIDE = 0.3  # of the ball's centre from the axis of the box, m
DEPTH = 0.1


def forces(place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Force on the box and on the ball, whose centre is at the place but for ASIDE; the face is above it."""
    ball = RigidBody.make_sphere(place + [ASIDE, 0.0, 0.0], 1.0, 4)
    pose = np.eye(4)
    pose[:3, 3] = place + [0.0, 0.0, 2.0 - DEPTH]
    box = RigidBody.make_box(pose, np.array([4.0, 4.0, 2.0]))
    touching, on_box, on_ball = contact_forces(ball, box)
    assert touching
    return on_box[:3], on_ball[:3]


fault = False
for place, along, normal in (
    ((0.0, 0.0, 0.0), -0.00838, 0.01470),
    ((10.0, 0.0, 0.0), -0.00838, 0.05881),
    ((100.0, 0.0, 0.0), -0.00838, 0.4558),
    ((0.0, 0.0, 10.0), -0.05249, 0.01470),
    ((0.0, 0.0, 100.0), -0.4494, 0.01470),
):
    on_box, on_ball = forces(np.array(place))
    print(f"scene at {place} m: expected on the box (0, 0, 0.0147) N, the opposite of the force on the ball; "
          f"seen on the box ({on_box[0]:.5f}, {on_box[1]:.5f}, {on_box[2]:.5f}), "
          f"on the ball ({on_ball[0]:.5f}, {on_ball[1]:.5f}, {on_ball[2]:.5f})")
    fault |= abs(on_box[0] - along) > 1e-3 or abs(on_box[2] - normal) > 2e-3
    fault |= abs(on_ball[0]) > 1e-4 or abs(on_ball[2] + 0.0147) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore leaning.py
