#!/usr/bin/env bash
# Finding: Two readers of the NMS files of NanoFocus confocal microscopes differ in the pitch by a factor of a million, and one of them puts every height above the highest that the file states.
# Package: surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI)
# Expected: Both take the two pitches of the head in one unit and spread the 65535 counts from the lowest to the highest height that the head states.
# Seen: SurfaceTopography takes a pitch of 0.0005 for 0.5 um, surfalize for 0.0000005 um, while the heights have one unit: the rms slope is 0.1 or 100000. Heights stated as 2 to 5 um are 2 to 5 um or, by surfalize, 5 to 8 um.
# Touches carom: carom reads no NMS. Look at the pitch before a map from there goes to x3p or sdf for carom: pressures of contact go as the slopes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile surfalize==0.19.2 SurfaceTopography==1.27.1 numpy==2.4.6
cd "$folder"
cat > narrow.py <<'PYTHON'
import importlib.metadata
import struct
import sys

import numpy as np
import surfalize
import SurfaceTopography

for name in ("surfalize", "SurfaceTopography"):
    print(name, importlib.metadata.version(name))
COLUMNS, ROWS = 60, 40
PITCH = (0.0005, 0.0008)  # as the head has it, which names no unit
LOWEST, HIGHEST = 2.0, 5.0  # as the head has them
x, y = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
shape = np.sin(0.1 * x) + np.cos(0.13 * y)
counts = np.round((shape - shape.min()) / np.ptp(shape) * (2**16 - 2)).astype("<u2")
heights = LOWEST + counts / (2**16 - 2) * (HIGHEST - LOWEST)

head = bytearray(3468)
struct.pack_into("<2d", head, 16, LOWEST, HIGHEST)
struct.pack_into("16s", head, 1076, b"2020-01-02 03:04")
struct.pack_into("<2I2d", head, 1368, COLUMNS, ROWS, *PITCH)
with open("map.nms", "wb") as file:
    file.write(bytes(head) + counts.tobytes())


def slope(points: np.ndarray, pitch: float) -> float:
    """Root of the mean square of the slopes along the rows."""
    return float(np.sqrt(np.mean((np.diff(points, axis=1) / pitch) ** 2)))


own = surfalize.Surface.load("map.nms")
topography = SurfaceTopography.read_topography("map.nms").to_unit("um")
readers = {
    "SurfaceTopography": (np.asarray(topography.heights()).T, topography.pixel_size),
    "surfalize": (own.data, (own.step_x, own.step_y)),
}
print(f"expected: one pitch, heights from {LOWEST} to {HIGHEST} um")
fault = False
for name, (points, pitch) in readers.items():
    print(f"{name}: pitch {pitch[0]:g} by {pitch[1]:g} um, heights from {points.min():.3f} to {points.max():.3f} um,", end=" ")
    print(f"slope {slope(points, pitch[0]):.3g}")
    fault |= points.shape != (ROWS, COLUMNS) or not np.allclose(points - points.min(), heights - LOWEST, atol=1e-9)
points, pitch = readers["SurfaceTopography"]
fault |= not np.allclose(pitch, np.array(PITCH) * 1e3) or abs(points.min() - LOWEST) > 1e-9
points, pitch = readers["surfalize"]
fault |= not np.allclose(pitch, np.array(PITCH) * 1e-3) or abs(points.min() - HIGHEST) > 1e-9
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore narrow.py
