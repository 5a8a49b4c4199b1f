#!/usr/bin/env bash
# Finding: In AFM-Learn the background of a map that is not square is not removed: a plane on 100 by 90 points keeps nine tenths of its height, and with the default order one on 64 by 128 becomes twice as rough.
# Package: AFM-Learn 0.10.0 (PyPI)
# Expected: A tilted plane is flat after its background is taken off, with any order from 1 on, whatever the number of rows and columns.
# Seen: It is on 64 by 64 points. Of a rms height of 1.42 on 100 by 90 points 1.28 is left at order 1 and 1.34 at the default order 3; on 64 by 128 order 3 makes 3.91 of 1.88. The fit takes the points row by row from a grid of which rows and columns are exchanged.
# Touches carom: Crop a map to a square before its roughness from this package goes into a contact model.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
# Its reader of ibw files needs a NumPy that still has np.complex.
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==1.23.5 scipy==1.10.1 matplotlib==3.7.5 igor==0.3 imutils==0.5.4 opencv-python-headless==4.9.0.80 plotly==6.5.0
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps AFM-Learn==0.10.0
cd "$folder"
cat > level.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from afm_learn.afm_image_analyzer import afm_RMS_roughness, fit_background

print("AFM-Learn", importlib.metadata.version("AFM-Learn"))
fault = False
for shape in ((64, 64), (90, 90), (100, 90), (128, 64), (64, 128)):
    row, column = np.indices(shape)
    plane = 0.02 * row + 0.05 * column
    before = afm_RMS_roughness(plane)
    # The least-squares plane over the very same points leaves nothing.
    terms = np.column_stack([row.ravel(), column.ravel(), np.ones(plane.size)])
    rest = plane.ravel() - terms @ np.linalg.lstsq(terms, plane.ravel(), rcond=None)[0]
    after = [afm_RMS_roughness(fit_background(plane, degrees=(order, order))[0]) for order in (1, 2)]
    after.append(afm_RMS_roughness(fit_background(plane)[0]))
    print(f"plane on {shape[0]} by {shape[1]} points, rms {before:.4f}: expected {rest.std():.4f}; seen {after[0]:.4f} with order 1, {after[1]:.4f} with 2, {after[2]:.4f} with the default")
    fault |= rest.std() > 1e-9
    fault |= max(after) > 1e-3 if shape[0] == shape[1] else min(after) < 0.08 * before
    if shape == (100, 90):
        fault |= abs(after[0] / before - 0.902) > 0.01
    if shape == (64, 128):
        fault |= abs(after[2] / before - 2.076) > 0.02
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore level.py
