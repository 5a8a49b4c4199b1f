#!/usr/bin/env bash
# Finding: In coal the order of two shapes decides whether a cylinder that stands on a box touches it on its whole base or in one point; turned end for end it is the other order.
# Package: coal 3.0.3 (PyPI)
# Expected: The patch is documented as the common part of a plane and both shapes, so neither the order nor the end matters: by the twelve samples of a curved shape its area is 3 R^2.
# Seen: Box, cylinder: 12 points and 3 R^2 in all of 100 random cases; cylinder, box: one point without area in all of them; the other way round for a cylinder on its head; boxes are right both ways.
# Touches carom: A law of carom's that takes the extent of a contact from coal would lose torsional friction by it; ask in both orders and take the larger patch.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check coal==3.0.3 libcoal==3.0.3 numpy==2.4.6
cd "$folder"
cat > patch.py <<'PYTHON'
import sys

import coal
import numpy as np

R = 0.5
HEAD_DOWN = np.diag([1.0, -1.0, -1.0])


def turn(random) -> np.ndarray:
    """A random rotation of the scene."""
    q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def patch(first, second) -> tuple[int, float]:
    """Points and area of the contact patch of two placed shapes."""
    request, result = coal.CollisionRequest(), coal.CollisionResult()
    request.enable_contact = True
    coal.collide(*first, *second, request, result)
    patches = coal.ContactPatchResult()
    coal.computeContactPatch(*first, *second, result, coal.ContactPatchRequest(), patches)
    corners = patches.getContactPatch(0)
    points = np.array([corners.getPoint(i) for i in range(corners.size())])
    spokes = points - points.mean(axis=0)
    return len(points), float(np.linalg.norm(np.cross(spokes, np.roll(spokes, -1, axis=0)).sum(axis=0)) / 2)


def scene(upper, own, scene_turn, place):
    """The upper shape, turned by `own`, and the box of 4 by 4 by 2 below it, all turned by `scene_turn`."""
    return (upper, coal.Transform3s(scene_turn @ own, scene_turn @ place)), (coal.Box(4, 4, 2), coal.Transform3s(scene_turn, np.zeros(3)))


print("coal", coal.__version__)
fault = False
for name, upper, own, expected, upper_first, box_first in (
    ("box", coal.Box(1, 1, 1), np.eye(3), 1.0, True, True),
    ("cylinder", coal.Cylinder(R, 1), np.eye(3), 3 * R**2, False, True),
    ("cylinder on its head", coal.Cylinder(R, 1), HEAD_DOWN, 3 * R**2, True, False),
    ("cone", coal.Cone(R, 1), np.eye(3), 3 * R**2, False, True),
):
    above, below = scene(upper, own, np.eye(3), np.array([0.1, 0.05, 1.49]))
    seen = patch(above, below), patch(below, above)
    print(f"{name} on box: expected area {expected:g} in both orders; seen with it first: {seen[0][0]} points, area {seen[0][1]:.4f}; "
          f"with the box first: {seen[1][0]} points, area {seen[1][1]:.4f}")
    for (points, area), right in zip(seen, (upper_first, box_first)):
        fault |= abs(area - expected) > 1e-3 if right else points != 1
random = np.random.default_rng(1)
right = [0, 0]
for _ in range(100):
    radius, height, depth = random.uniform(0.2, 0.8), random.uniform(0.5, 2), random.uniform(0.001, 0.1)
    place = np.array([*random.uniform(-1, 1, 2), 1 + height / 2 - depth])
    pair = scene(coal.Cylinder(radius, height), np.eye(3), turn(random), place)
    for order in (0, 1):
        right[order] += abs(patch(pair[order], pair[1 - order])[1] / (3 * radius**2) - 1) < 0.01
print(f"100 random cylinders on a box, the scene turned at random: expected 100 of 3 R^2 in both orders, "
      f"seen {right[0]} with the cylinder first, {right[1]} with the box first")
fault |= right != [0, 100]
sys.exit(int(fault))
PYTHON
env/bin/python patch.py
