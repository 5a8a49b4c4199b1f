#!/usr/bin/env bash
# Finding: verity-x3p reads a point that was not measured as a measured point of height 0, if the heights of the x3p file are integers.
# Package: verity-x3p 0.2.0 (PyPI), x3pio 2.0.0 (PyPI)
# Expected: Integer heights mark missing points by a file of validity bits (ISO 25178-72); the mask that verity-x3p gives beside the heights is false there, as it is for floating-point heights.
# Seen: A surface 10 to 23 um high with one hole: 16 and 32 bits give height 0 and mask true, a pit of 16 um below the mean; 64-bit floats give mask false.
# Touches carom: 0 is a height like any other, so that such a pit passes unseen in an array; carom reads the mask of the file and counts the points that miss.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check verity-x3p==0.2.0 x3pio==2.0.0 numpy==2.4.6
cd "$folder"
cat > holes.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import verity_x3p
import x3pio

for name in ("verity-x3p", "x3pio"):
    print(name, importlib.metadata.version(name))
heights = np.array([[10.0, 11, 12], [20, np.nan, 22], [21, 22, 23]]) * 1e-6
seen = {}
for kind in (x3pio.DataType.INT16, x3pio.DataType.INT32, x3pio.DataType.FLOAT64):
    x3pio.write("surface.x3p", heights, x_scale=1e-6, y_scale=1e-6, z_type=kind)
    assert np.isnan(x3pio.read("surface.x3p").layers[0].z[1, 1]), "x3pio keeps the hole"
    surface = verity_x3p.read_x3p("surface.x3p")
    seen[kind.name] = float(np.asarray(surface.data)[1, 1]), bool(np.asarray(surface.mask)[1, 1])
    print(f"{kind.name}: expected no valid height at the hole; seen height {seen[kind.name][0]}, mask {seen[kind.name][1]}")
right = seen["INT16"] == seen["INT32"] == (0.0, True) and seen["FLOAT64"][1] is False
sys.exit(int(not right))
PYTHON
env/bin/python holes.py
