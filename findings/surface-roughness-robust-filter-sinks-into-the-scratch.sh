#!/usr/bin/env bash
# Finding: The robust Gaussian filter of surface-roughness lets a ridge out and follows a scratch of the same size to its ground: its weight grows without bound below the profile.
# Package: surface-roughness 0.0.3 (PyPI)
# Expected: A robust filter gives outliers no weight on either side, so that the mean line of a profile turned upside down is the mean line turned upside down.
# Seen: At a cut-off of 0.8 mm the line runs at -0.5 um under a ridge of 20 um and 0.1 mm, at -19.8 um in a scratch of 20 um and at -96.8 um in one of 100 um; the plain filter of the same class at 4.1, -4.9 and -23 um.
# Touches carom: Scratches vanish from a profile whose waviness was taken off by this filter before it enters a contact; filter the profile upside down as well and compare.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surface-roughness==0.0.3 numpy==2.4.6 scipy==1.17.1 pandas==2.3.3 matplotlib==3.10.7 meshio==5.3.5 tqdm==4.67.1 shapely==2.1.2
cd "$folder"
cat > scratch.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from surface_roughness.roughness import Profile

print("surface-roughness", importlib.metadata.version("surface-roughness"))
CUTOFF, POINTS, STEP, FIRST, LAST = 0.8, 301, 0.01, 146, 155  # mm, points, mm, first and last point of the outlier
X = np.arange(POINTS) * STEP
WAVES = 0.001 * np.sin(2 * np.pi * X / 0.8) + np.random.default_rng(1).normal(0, 0.0005, POINTS)  # mm


def lines(outlier: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Robust and plain mean line within the outlier, and its height there, in um."""
    z = WAVES.copy()
    z[FIRST : LAST + 1] += outlier
    profile = Profile(np.column_stack([X, z]))
    assert np.sign(profile.points[150, 1]) == np.sign(outlier)
    within = slice(FIRST, LAST + 1)
    return 1e3 * profile.robust_gaussian_filter(CUTOFF)[within], 1e3 * profile.gaussian_filter(CUTOFF)[within], 1e3 * profile.points[within, 1].mean()


fault = False
for what, outlier in (("ridge", 0.02), ("scratch", -0.02), ("deeper scratch", -0.1)):
    robust, plain, height = lines(outlier)
    print(f"{what} of {outlier * 1e3:g} um and {STEP * (LAST - FIRST + 1):g} mm, in the profile at {height:.1f} um: expected robust mean line within 2 um of 0, "
          f"seen {robust.mean():.2f} um; plain filter {plain.mean():.2f} um")
    fault |= abs(robust).max() > 2 if outlier > 0 else abs(robust.mean() / height - 1) > 0.15
    fault |= abs(plain.mean() / height) > 0.5
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore scratch.py
