#!/usr/bin/env bash
# Finding: In hurst-estimators the wavelet estimate of the Hurst exponent depends on the level of zero: a levelled profile has a negative one, and the higher it is lifted the larger it grows, beyond 1.
# Package: hurst-estimators 0.0.3 (PyPI)
# Expected: The exponent says how differences grow with distance; a constant has no differences, and its wavelet coefficients are zero. Other estimators of the package give the same number for every offset.
# Seen: For synthetic noise of exponent 0.7 and standard deviation 1: -0.6 when its mean is taken off, 0.71 with a mean of 1, 0.86 with 100, 1.01 with 10000; for 0.9 a levelled profile has none. The mean height of the coarsest level counts as one more wavelet coefficient.
# Touches carom: The exponent of a rough surface in carom is from differences of height; take another estimator of the package for a measured profile.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile hurst-estimators==0.0.3 numpy==1.26.4 scipy==1.15.3 PyWavelets==1.8.0
cd "$folder"
cat > level.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from hurst_estimators.estimators import central_estimator, dfa_estimator, wavelet_estimator

print("hurst-estimators", importlib.metadata.version("hurst-estimators"))


def noise(exponent: float, points: int) -> np.ndarray:
    """Increments of a self-affine profile, exact in their correlation, of mean zero and standard deviation 1."""
    lag = np.arange(points, dtype=float)
    correlation = (np.abs(lag + 1) ** (2 * exponent) - 2 * lag ** (2 * exponent) + np.abs(lag - 1) ** (2 * exponent)) / 2
    power = np.fft.fft(np.concatenate([correlation, [0.0], correlation[:0:-1]])).real.clip(0)
    random = np.random.default_rng(1)
    wave = random.standard_normal(2 * points) + 1j * random.standard_normal(2 * points)
    profile = np.fft.fft(np.sqrt(power / (2 * points)) * wave).real[:points]
    return profile - profile.mean()


fault = False
for exponent in (0.3, 0.5, 0.7, 0.9):
    profile = noise(exponent, 4096)
    seen, others = [], []
    for offset in (0.0, 1.0, 100.0, 1e4):
        seen.append(wavelet_estimator(profile + offset)[0])
        others.append((dfa_estimator(profile + offset, 20)[0], central_estimator(profile + offset, 400)[0]))
    print(f"exponent {exponent:g}: expected one number for all levels; seen by wavelets " + ", ".join(f"{value:.3f}" for value in seen)
          + " at level 0, 1, 100, 10000; by two others " + " and ".join(f"{value:.3f}" for value in others[0]) + " at all levels")
    fault |= seen[0] > 0 or not seen[1] < seen[2] < seen[3] or abs(seen[3] - seen[1] - 0.304) > 0.01 or np.ptp(others, axis=0).max() > 1e-6
    fault |= not exponent - 0.2 < others[0][0] < exponent + 0.1
sys.exit(int(fault or seen[3] < 1))
PYTHON
env/bin/python -W ignore level.py
