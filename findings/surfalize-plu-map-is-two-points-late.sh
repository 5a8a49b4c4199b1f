#!/usr/bin/env bash
# Finding: surfalize reads the number of rows and columns before the heights of a PLU file of Sensofar as two heights, so the whole map stands two points to the right and each row begins with the end of the row above.
# Package: surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI), gwyddionpy 0.1.0 with gwyddionpy-converter 0.1.0 (PyPI)
# Expected: A peak in row 8 and column 45 is there for each reader, and a ledge along the right edge stays there.
# Seen: surfalize has the peak in column 47, the first two heights are 1e-43 um, the last two are lost, and the ledge of 1 um along the right edge lies along the left one. Nothing is refused.
# Touches carom: carom reads no PLU. Send such maps through SurfaceTopography, or each row that carom presses begins with two points of the row above.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile surfalize==0.19.2 SurfaceTopography==1.27.1 gwyddionpy==0.1.0 gwyddionpy-converter==0.1.0 numpy==2.4.6
export XDG_CACHE_HOME="$folder/cache"
cd "$folder"
cat > late.py <<'PYTHON'
import importlib.metadata
import struct
import sys

import gwyddionpy
import numpy as np
import surfalize
import SurfaceTopography

for name in ("surfalize", "SurfaceTopography", "gwyddionpy", "gwyddionpy-converter"):
    print(name, importlib.metadata.version(name))
COLUMNS, ROWS, PITCH = 60, 40, 0.5  # um
x, y = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
heights = 0.05 * np.exp(-((x - 45) ** 2 + (y - 8) ** 2) / 60)  # um
heights += 1.0 * (x >= COLUMNS - 2)  # a ledge of two points along the right edge
heights[8, 45] += 2.0


def plu() -> bytes:
    """A topography of one layer: head, calibration, configuration, then rows, columns, heights and their range."""
    head = struct.pack("<128sI256s", b"Thu Jan 02 03:04:05 2020", 1577934245, b"")
    calibration = struct.pack("<3I7f", ROWS, COLUMNS, 1, 1.0, PITCH, PITCH, 0.0, 0.0, 1.0, 0.0)
    kind = struct.pack("<5I", 3, 0, 0, 1, 0)
    scan = struct.pack("<5Idf2I", COLUMNS, ROWS, COLUMNS, ROWS, 0, 0.1, 10.0, 100, 0)
    layers = struct.pack("<5b3xI", 0, 1, 0, 0, 0, 0)
    layer = struct.pack("<2I", ROWS, COLUMNS) + heights.astype("<f4").tobytes()
    return head + calibration + kind + scan + layers + layer + struct.pack("<2f", heights.min(), heights.max())


with open("map.plu", "wb") as file:
    file.write(plu())
channel = next(iter(gwyddionpy.load("map.plu").channels.values()))
readers = {
    "gwyddionpy": channel.data * 1e6,
    "SurfaceTopography": SurfaceTopography.read_topography("map.plu").to_unit("um").heights().T,
    "surfalize": surfalize.Surface.load("map.plu").data,
}
print(f"expected: the peak in row 8, column 45, edges 0 um and 1 um")
fault = False
for name, points in readers.items():
    points = np.asarray(points, dtype=float)
    row, column = (int(place) for place in np.unravel_index(points.argmax(), points.shape))
    right = points.shape == heights.shape and np.allclose(points, heights, atol=1e-6)
    print(f"{name}: the peak in row {row}, column {column}, edges {points[20, 0]:.2f} um and {points[20, -1]:.2f} um,", end=" ")
    print(f"first heights {points[0, 0]:.1g} um and {points[0, 1]:.1g} um, as written: {right}")
    if name == "surfalize":
        fault |= right or (row, column) != (8, 47) or not np.allclose(points.ravel()[2:], heights.ravel()[:-2], atol=1e-6)
        fault |= points[0, :2].max() > 1e-40
    else:
        fault |= not right
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore late.py
