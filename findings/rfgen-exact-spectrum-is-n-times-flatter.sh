#!/usr/bin/env bash
# Finding: rfgen's switch between a noisy and an exact spectrum changes the height of the surface by the number of points on its side.
# Package: rfgen 0.2.3 (PyPI)
# Expected: With noise=True the spectrum fluctuates around the power law that noise=False follows exactly (docstring): the root-mean-square height is the same, up to its scatter.
# Seen: Ratio of the rms heights 64.6, 127.9 and 256.6 for maps of 64, 128 and 256 points on a side, and sqrt(N) for lines.
# Touches carom: A map of rfgen has no unit and no stated rms height. Divide by its standard deviation before `scale`; with `shape = "rough"` carom's `rms` is exact.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check rfgen==0.2.3 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > flat.py <<'PYTHON'
import sys

import numpy as np
import rfgen

print("rfgen", rfgen.__version__)


def rms(points: int, dim: int, noise: bool) -> float:
    """Root mean square of the rms height of 60 surfaces that have the same band of waves."""
    band = {"dim": dim, "N": points, "Hurst": 0.8, "k_low": 4 / points, "k_high": 0.25}
    heights = (rfgen.selfaffine_field(noise=noise, rng=np.random.default_rng(seed), **band) for seed in range(60))
    return float(np.sqrt(np.mean([h.var() for h in heights])))


fault = False
for dim in (2, 1):
    for points in (64, 128, 256):
        ratio = rms(points, dim, True) / rms(points, dim, False)
        stated = points ** (dim / 2)
        print(f"dim {dim}, N {points}: rms height with noise over without, expected 1, seen {ratio:.1f} (N^(dim/2) = {stated:.1f})")
        fault |= abs(ratio / stated - 1) > 0.1
sys.exit(int(fault))
PYTHON
env/bin/python flat.py
