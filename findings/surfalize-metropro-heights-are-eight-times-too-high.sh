#!/usr/bin/env bash
# Finding: In surfalize the heights of a MetroPro file of high phase resolution are eight times those of SurfaceTopography and prysm, and four times at super resolution.
# Package: surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI), prysm 0.21.1 (PyPI)
# Expected: The word of phase resolution in the head (0, 1, 2 for 4096, 32768, 131072 counts a fringe) scales the phase; all readers give heights of one size.
# Seen: surfalize counts that word from one: 1 means 4096 counts to it and 2 means 32768. Lengths and shape are the same, no reader warns.
# Touches carom: carom sends maps of other instruments through surfalize or SurfaceTopography. Take the second for MetroPro, or carom presses a surface that is eight times as rough.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surfalize==0.19.2 SurfaceTopography==1.27.1 prysm==0.21.1 numpy==2.4.6
cd "$folder"
cat > fringes.py <<'PYTHON'
import importlib.metadata
import struct
import sys

import numpy as np
import surfalize
import SurfaceTopography
from prysm.io import read_zygo_dat

for name in ("surfalize", "SurfaceTopography", "prysm"):
    print(name, importlib.metadata.version(name))
WAVE, SCALE, PITCH = 633e-9, 0.5, 1e-6  # m, of a wave, m
STEP = 100e-9  # height of the one step on the map, m
COUNTS = {1: 32768, 2: 131072}  # of one fringe: high and super resolution


def metropro(resolution: int) -> bytes:
    """A file of 5 by 4 points without an intensity image: flat but for a step of `STEP` in one row."""
    head = bytearray(834)
    for place, kind, *values in (
        (0, ">4sHI", b"\x88\x1b\x03\x6f", 1, 834),
        (12, "30s", b"Mon Mar 02 10:00:00 2020"),
        (68, ">2HI", 5, 4, 80),
        (76, ">i", 1583143200),
        (164, ">2f", SCALE, WAVE),
        (176, ">f", 1.0),
        (184, ">f", PITCH),
        (218, ">h", resolution),
    ):
        struct.pack_into(kind, head, place, *values)
    phase = np.zeros((4, 5), dtype=">i4")
    phase[1] = round(STEP / (SCALE * WAVE) * COUNTS[resolution])
    return bytes(head) + phase.tobytes()


fault = False
for resolution, wrong in ((1, 8.0), (2, 4.0)):
    path = f"resolution{resolution}.dat"
    with open(path, "wb") as file:
        file.write(metropro(resolution))
    own = surfalize.Surface.load(path)
    topography = SurfaceTopography.read_topography(path).to_unit("nm")
    heights = np.asarray(topography.heights())
    steps = {
        "surfalize": np.ptp(own.data) * 1e3,
        "SurfaceTopography": np.ptp(heights),
        "prysm": np.ptp(read_zygo_dat(path)["phase"]),
    }
    seen = ", ".join(f"{name} {step:.2f} nm" for name, step in steps.items())
    print(f"phase resolution {resolution}: expected a step of {STEP * 1e9:g} nm; seen {seen}")
    print(f"    pitch: surfalize {own.step_x:g} um, SurfaceTopography {topography.pixel_size[0] / 1e3:g} um")
    for name, step in steps.items():
        fault |= abs(step / (STEP * 1e9) - (wrong if name == "surfalize" else 1.0)) > 0.01
    fault |= abs(own.step_x - 1.0) > 1e-6 or abs(topography.pixel_size[0] - 1e3) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore fringes.py
