#!/usr/bin/env bash
# Finding: In coxeter a disc or an ellipse aside of the origin has its two second moments of area exchanged in the part that its place adds; a polygon of the same outline has not.
# Package: coxeter 0.11.0 (PyPI)
# Expected: The moment about x is the integral of y2, so a disc that moves along x keeps it and gains about y, as its inscribed polygon of 2000 corners does.
# Seen: Three units along x the disc of radius 0.5 has 7.118 about x where the polygon has 0.049, and 0.049 about y where it has 7.118. Area, product and polar moment agree, so that they tell nothing.
# Touches carom: For the tilting stiffness of several contact spots sum the moments of polygons, or add the parts of the centres yourself.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check coxeter==0.11.0 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > moments.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from coxeter.shapes import Circle, ConvexPolygon, Ellipse

print("coxeter", importlib.metadata.version("coxeter"))
ANGLES = np.linspace(0.0, 2.0 * np.pi, 2000, endpoint=False)
fault = False
for a, b, x, y in ((0.5, 0.5, 0.0, 0.0), (0.5, 0.5, 3.0, 0.0), (0.5, 0.5, 3.0, 1.0), (1.0, 0.5, 0.0, 0.0), (1.0, 0.5, 0.0, 3.0)):
    shape = Circle(a, center=(x, y, 0.0)) if a == b else Ellipse(a, b, center=(x, y, 0.0))
    outline = ConvexPolygon(np.column_stack([x + a * np.cos(ANGLES), y + b * np.sin(ANGLES)]))
    area = np.pi * a * b
    law = np.array([area * (b**2 / 4 + y**2), area * (a**2 / 4 + x**2), area * x * y])
    swapped = np.array([area * (b**2 / 4 + x**2), area * (a**2 / 4 + y**2), area * x * y])
    seen = np.array(shape.planar_moments_inertia, dtype=float)
    polygon = np.array(outline.planar_moments_inertia, dtype=float)
    print(f"{type(shape).__name__} of half axes {a}, {b} at ({x:g}, {y:g}), moments about x, about y, product:")
    for name, value in (("expected", law), ("seen, polygon", polygon), ("seen, shape", seen)):
        print(f"    {name}: {value[0]:.4f}, {value[1]:.4f}, {value[2]:.4f}; polar {value[0] + value[1]:.4f}")
    fault |= not np.allclose(polygon, law, rtol=1e-4, atol=1e-6) or not np.allclose(seen, swapped, rtol=1e-9, atol=1e-12)
    fault |= abs(shape.polar_moment_inertia / (law[0] + law[1]) - 1.0) > 1e-9
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore moments.py
