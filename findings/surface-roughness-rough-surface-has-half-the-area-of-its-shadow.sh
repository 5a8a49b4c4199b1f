#!/usr/bin/env bash
# Finding: The area ratio of surface-roughness says that a rough surface is half as large as its own projection: the projected triangles are counted twice, the true ones once.
# Package: surface-roughness 0.0.3 (PyPI)
# Expected: The ratio Rs of true to projected area is 1 for a nearly flat surface and grows with the slopes; it can't be below 1.
# Seen: 0.5000 for a surface of 0.0001 slope, 0.556 for waves of slope 0.7 whose own `area` is 1.113 of the square; below 1 until the true ratio exceeds 2.
# Touches carom: The developed area ratio Sdr, 100 (Rs - 1) %, of a map for carom comes out at -50 % and more; double Rs first.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surface-roughness==0.0.3 numpy==2.4.6 scipy==1.17.1 pandas==2.3.3 matplotlib==3.10.7 meshio==5.3.5 tqdm==4.67.1 shapely==2.1.2
cd "$folder"
cat > area.py <<'PYTHON'
import contextlib
import importlib.metadata
import io
import sys

import meshio
import numpy as np
from surface_roughness import Surface

print("surface-roughness", importlib.metadata.version("surface-roughness"))
POINTS, SIDE, WAVES = 121, 10.0, 4

x, y = np.meshgrid(np.linspace(0, SIDE, POINTS), np.linspace(0, SIDE, POINTS), indexing="ij")
corner = np.arange(POINTS**2).reshape(POINTS, POINTS)
a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
k = 2 * np.pi * WAVES / SIDE
fault = False
for slope in (1e-4, 0.1, 0.7, 3.0):
    z = slope / k * np.cos(k * x) + 1e-6 * np.cos(k * y)
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    meshio.write_points_cells("waves.stl", points, [("triangle", triangles)])
    with contextlib.redirect_stdout(io.StringIO()):
        surface = Surface("waves.stl")
        ratio = float(surface.rs())
    sides = points[triangles]
    area = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1).sum() / 2
    right = area / SIDE**2
    print(f"waves of slope {slope:g}: expected Rs {right:.5f}, seen {ratio:.5f}, {ratio / right:.4f} of it; "
          f"area of its own {float(surface.area):.3f} on a square of {SIDE**2:g}")
    fault |= abs(float(surface.area) / area - 1) > 1e-4 or abs(ratio / right - 0.5) > 0.005
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore area.py
