#!/usr/bin/env bash
# Finding: The developed interfacial area ratio Sdr of slippy is negative for a flat map, by 2 % on 100 by 100 points and by 11 % on 20 by 20.
# Package: slippy 0.5.2 (PyPI)
# Expected: Sdr is the area above that of the plane over that of the plane: zero of a flat map, and of one surface the same on every grid that resolves it.
# Seen: ((n - 1)^2 - n^2) / (n - 1)^2 of n by n points: the cells between the points are weighed against one more row and column; shallow grooves of Sdr 0.000247 come out at -0.020, and less negative on a finer grid.
# Touches carom: Take the rms slope or the developed area of a rough map from another program before it goes into a contact by carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
# The package asks for a NumPy older than 1.21, which has no build for this Python; its Sdr needs nothing of the old one.
"$folder/env/bin/pip" install -q --disable-pip-version-check numpy==1.26.4 scipy==1.13.1 matplotlib==3.9.4 \
  tinydb==4.8.2 numba==0.60.0
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps slippy==0.5.2
cd "$folder"
cat > flat.py <<'PYTHON'
import importlib.metadata
import sys
import warnings

import numpy as np

warnings.simplefilter("ignore")
import slippy.surface

SIDE = 1.0


def developed(heights: np.ndarray, spacing: float) -> float:
    return float(slippy.surface.roughness(heights, "sdr", grid_spacing=spacing, no_flattening=True))


print("slippy", importlib.metadata.version("slippy"))
fault = False
for points in (20, 50, 100, 200):
    spacing = SIDE / points
    x = (np.arange(points) + 0.5) * spacing
    flat = developed(np.zeros((points, points)), spacing)
    law = ((points - 1) ** 2 - points**2) / (points - 1) ** 2
    print(f"{points} by {points} points, flat: expected 0, seen {flat:.5f}, by the count of the cells {law:.5f}")
    fault |= abs(flat - law) > 1e-9
    if points >= 100:
        amplitude = 0.001
        slope = 10 * np.pi * amplitude * np.cos(np.linspace(0, 2 * np.pi, 10001)[:-1])
        true = float(np.mean(np.sqrt(1 + slope**2)) - 1)
        grooves = developed(np.tile(amplitude * np.sin(10 * np.pi * x)[:, None], (1, points)), spacing)
        print(f"{points} by {points} points, five grooves: expected {true:.6f}, seen {grooves:.5f}")
        fault |= grooves > -0.009
sys.exit(int(fault))
PYTHON
env/bin/python flat.py
