#!/usr/bin/env bash
# Finding: A missing point that SurfaceTopography read from x3p or sur is saved by savetxt or savez as a measured one, with the height of one step of the file.
# Package: SurfaceTopography 1.27.1 (PyPI), surfalize 0.19.2 (PyPI)
# Expected: The hole is NaN under the mask, as it is if SurfaceTopography wrote the x3p file itself, so that whoever saves the heights saves a NaN.
# Seen: The product of a masked map and the height of one step keeps that step under the mask: 1 m for a float x3p with increment 1, 3.5e-9 um (one step of the integers) for sur, and NaN for the own x3p.
# Touches carom: A hole of sur passes as a height within the surface. Write np.ma.filled(heights, np.nan), or give carom the x3p or sur file itself.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.27.1 surfalize==0.19.2 numpy==2.4.6
cd "$folder"
cat > hole.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import surfalize
import SurfaceTopography

for name in ("SurfaceTopography", "surfalize"):
    print(name, importlib.metadata.version(name))
heights = np.array([[10.0, 11, 12, 13], [20, np.nan, 22, 24], [21, 22, 23, 25]])  # um
surface = surfalize.Surface(heights, 2, 2)
surface.save("other.x3p")
surface.save("other.sur")
masked = np.ma.masked_invalid(heights.T * 1e-6)
SurfaceTopography.Topography(masked, (8e-6, 6e-6), unit="m").to_x3p("own.x3p")
saved = {}
for path in ("own.x3p", "other.x3p", "other.sur"):
    topography = SurfaceTopography.read_topography(path)
    read = topography.heights()
    assert topography.has_undefined_data and read.mask[1, 1] and read.mask.sum() == 1, "the hole is known"
    np.savetxt("saved.txt", read)
    np.savez("saved.npz", heights=read)
    saved[path] = float(np.loadtxt("saved.txt")[1, 1])
    assert np.array_equal(np.load("saved.npz")["heights"][1, 1], saved[path], equal_nan=True)
    print(f"{path}: expected nan saved for the hole, seen {saved[path]}, in the unit of the topography ({topography.unit!r})")
step = (25 - 10) / 2**32
right = np.isnan(saved["own.x3p"]) and saved["other.x3p"] == 1.0 and abs(saved["other.sur"] / step - 1) < 1e-6
sys.exit(int(not right))
PYTHON
env/bin/python -W ignore hole.py
