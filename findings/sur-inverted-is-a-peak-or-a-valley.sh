#!/usr/bin/env bash
# Finding: A sur file with the flag of inversion is a peak for surfalize and a valley for SurfaceTopography, and for values 2 and 3 also its mirror image.
# Package: SurfaceTopography 1.27.1 (PyPI), surfalize 0.19.2 (PyPI)
# Expected: The word at byte 290 of the head (0 none, 1 z, 2 z and columns, 3 z and rows) means one thing; both read the same map.
# Seen: 0: the same map. 1: the heights of SurfaceTopography are minus those of surfalize. 2 and 3: mirrored as well. Neither warns.
# Touches carom: carom turns the map as SurfaceTopography does. Look at the map first: a contact must not begin in its grooves.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.27.1 surfalize==0.19.2 numpy==2.4.6
cd "$folder"
cat > inverted.py <<'PYTHON'
import importlib.metadata
import struct
import sys

import numpy as np
import surfalize
import SurfaceTopography

for name in ("SurfaceTopography", "surfalize"):
    print(name, importlib.metadata.version(name))
points = np.array([[0, 1, 2, 3], [4, 90, 6, 7], [8, 9, 10, 11]], dtype="<i4")  # one peak
turned = {0: points, 1: -points, 2: -points[:, ::-1], 3: -points[::-1]}
fault = False
for flag, stated in turned.items():
    head = bytearray(512)
    head[:12] = b"DIGITAL SURF"
    for place, kind, *values in (
        (14, "<3h", 1, 1, 2), (98, "<h", 32), (100, "<5i", 0, 90, 4, 3, 12), (120, "<3f", 1, 1, 1),
        (276, "<3f", 1, 1, 1), (288, "<2h", 1, flag), (306, "<6h", 0, 0, 0, 1, 1, 2020),
    ):
        struct.pack_into(kind, head, place, *values)
    for place in range(180, 276, 16):
        head[place : place + 2] = b"um"
    path = f"flag{flag}.sur"
    with open(path, "wb") as file:
        file.write(head + points.tobytes())
    own = surfalize.Surface.load(path).data
    other = np.asarray(SurfaceTopography.read_topography(path).heights()).T
    print(f"flag {flag}: expected the same heights; seen surfalize {own.min():g} to {own.max():g} um, SurfaceTopography {other.min():g} to {other.max():g} um")
    fault |= not (np.allclose(own, points) and np.allclose(other, stated))
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore inverted.py
