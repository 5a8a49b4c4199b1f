#!/usr/bin/env bash
# Finding: A list of x, y, z whose points go column by column gives surfalize a map with the right size and the heights at wrong places.
# Package: surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI)
# Expected: Each line states its own x and y, so the order of the lines has no meaning; SurfaceTopography reads the same map from both orders.
# Seen: A plane that rises by 1 um per point along x and 10 um along y: row by row right, column by column 10 of 12 points are wrong by up to 18 um, and no warning.
# Touches carom: carom places each point by its x and y. Whoever converts such a list by surfalize sorts it by y, then x, before.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.27.1 surfalize==0.19.2 numpy==2.4.6
cd "$folder"
cat > columns.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import surfalize
import SurfaceTopography

for name in ("surfalize", "SurfaceTopography"):
    print(name, importlib.metadata.version(name))
x, y = np.meshgrid(np.arange(4) * 2e-6, np.arange(3) * 2e-6)
heights = 0.5 * x + 5 * y
orders = {"rows": [a.ravel() for a in (x, y, heights)], "columns": [a.T.ravel() for a in (x, y, heights)]}
error, wrong = {}, {}
for order, lists in orders.items():
    np.savetxt(f"{order}.xyz", np.column_stack(lists))
    own = surfalize.Surface.load(f"{order}.xyz").data * 1e-6
    other = np.asarray(SurfaceTopography.read_topography(f"{order}.xyz").heights()).T
    assert own.shape == heights.shape and np.allclose(other, heights, rtol=0, atol=1e-15), "SurfaceTopography reads both orders"
    error[order] = abs(own - heights).max() * 1e6
    wrong[order] = int((abs(own - heights) > 1e-9).sum())
    print(f"{order}: expected error 0 um, seen {error[order]:.1f} um at {wrong[order]} of {heights.size} points")
sys.exit(int(not (error["rows"] < 1e-6 and wrong["columns"] > 5 and error["columns"] > 1)))
PYTHON
env/bin/python -W ignore columns.py
