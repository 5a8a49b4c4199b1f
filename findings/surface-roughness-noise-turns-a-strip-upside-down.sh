#!/usr/bin/env bash
# Finding: surface-roughness turns many measured strips upside down when it levels them, so that a ridge becomes a scratch; which, only the noise of the measurement decides.
# Package: surface-roughness 0.0.3 (PyPI)
# Expected: To level a surface turns it by the small angle between its best plane and the horizontal; heights keep their sign and places their order.
# Seen: Of 40 strips that differ in noise of 2 um alone some fifteen to twenty-five come out turned by 180 degrees, with the ridge of 50 um pointing down and an axis reversed; the rest are right, and no message tells them apart.
# Touches carom: Peaks bear the load: give carom the mesh itself, or compare a height of the surface with the file before a profile or a direction of this package is used.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surface-roughness==0.0.3 numpy==2.4.6 scipy==1.17.1 pandas==2.3.3 matplotlib==3.10.7 meshio==5.3.5 tqdm==4.67.1 shapely==2.1.2
cd "$folder"
cat > strips.py <<'PYTHON'
import contextlib
import importlib.metadata
import io
import sys

import meshio
import numpy as np
from surface_roughness import Surface

print("surface-roughness", importlib.metadata.version("surface-roughness"))
NX, NY, LENGTH, WIDTH, RIDGE, NOISE = 21, 61, 0.4, 4.0, 0.05, 0.002  # points and mm


def strip(seed: int) -> np.ndarray:
    """Points of a strip with one ridge across its middle."""
    x, y = np.meshgrid(np.linspace(0, LENGTH, NX), np.linspace(0, WIDTH, NY), indexing="ij")
    z = RIDGE * np.exp(-(((y - WIDTH / 2) / 0.2) ** 2)) + np.random.default_rng(seed).normal(0, NOISE, x.shape)
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()])


corner = np.arange(NX * NY).reshape(NX, NY)
a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
upright = 0
for seed in range(40):
    points = strip(seed)
    meshio.write_points_cells("strip.stl", points, [("triangle", triangles)])
    kept = meshio.read("strip.stl").points
    with contextlib.redirect_stdout(io.StringIO()):
        surface = Surface("strip.stl")
    before, after = kept - kept.mean(axis=0), surface.points - surface.points.mean(axis=0)
    assert before[:, 2].max() > 3 * -before[:, 2].min()
    slope = np.linalg.lstsq(np.column_stack([before[:, :2], np.ones(len(before))]), before[:, 2], rcond=None)[0][:2]
    assert abs(slope).max() < 0.02  # nothing to level: it is less than a degree out
    highest, lowest = after[:, 2].max(), after[:, 2].min()
    upright += highest > -lowest
    if seed < 6:
        print(f"noise {seed}: expected heights from {before[:, 2].min() * 1e3:.1f} to {before[:, 2].max() * 1e3:.1f} um, seen {lowest * 1e3:.1f} to {highest * 1e3:.1f} um; "
              f"first point expected at {before[0, 0]:.2f}, {before[0, 1]:.2f} mm, seen at {after[0, 0]:.2f}, {after[0, 1]:.2f} mm")
print(f"40 strips that differ in noise: expected 40 upright, seen {upright} upright and {40 - upright} upside down")
sys.exit(int(not 5 <= upright <= 35))
PYTHON
env/bin/python -W ignore strips.py
