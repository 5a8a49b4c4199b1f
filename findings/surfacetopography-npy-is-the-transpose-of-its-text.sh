#!/usr/bin/env bash
# Finding: One array saved by np.save and by np.savetxt gives SurfaceTopography two maps with x and y exchanged, and so do its two readers of text for one file.
# Package: SurfaceTopography 1.27.1 (PyPI)
# Expected: The same map from both files: rows and columns of an array are the rows and columns of its text.
# Seen: read_topography takes the rows of npy along x and the rows of text along y; read_matrix takes those of text along x; grooves along x come out along y.
# Touches carom: carom takes a row of npy as a row of constant y, as it does of text: np.save("map.npy", np.ma.filled(heights, np.nan).T) for SurfaceTopography's arrays.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.27.1 numpy==2.4.6
cd "$folder"
cat > transpose.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import SurfaceTopography
from SurfaceTopography.IO.Text import read_matrix

print("SurfaceTopography", importlib.metadata.version("SurfaceTopography"))
rows = np.arange(8)[:, None] * np.ones(8)  # each row has one height: grooves along the rows
np.save("map.npy", rows)
np.savetxt("map.txt", rows)
size = (8.0, 8.0)
maps = {
    "npy": SurfaceTopography.read_topography("map.npy", physical_sizes=size),
    "text": SurfaceTopography.read_topography("map.txt", physical_sizes=size),
    "text by read_matrix": read_matrix("map.txt", physical_sizes=size),
}
seen = {}
for name, topography in maps.items():
    heights = np.asarray(topography.heights())  # h[x, y]
    along_x, along_y = abs(np.diff(heights, axis=0)).max(), abs(np.diff(heights, axis=1)).max()
    seen[name] = "y" if along_y > along_x else "x"
    print(f"{name}: expected the same direction for all, seen heights that change along {seen[name]}")
sys.exit(int(seen != {"npy": "x", "text": "y", "text by read_matrix": "x"}))
PYTHON
env/bin/python -W ignore transpose.py
