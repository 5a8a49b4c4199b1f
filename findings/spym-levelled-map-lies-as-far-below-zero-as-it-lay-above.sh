#!/usr/bin/env bash
# Finding: In spym levelling subtracts the mean height twice: a map with a mean of 5 nm lies at -5 nm afterwards, and at 5 nm again after a second levelling.
# Package: spym 0.9.2 (PyPI)
# Expected: The plane of least squares is taken off, so that the rest has a mean of zero and a second levelling changes nothing.
# Seen: The tilt goes, the mean changes its sign, at each call; the root mean square of the heights is 5.0 nm in place of 0.1, and the background that it gives back lies twice as high as the map.
# Touches carom: Subtract the mean of such a map again before its heights go to a rough contact of carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --prefer-binary spym==0.9.2 numpy==2.2.6 scipy==1.15.3 xarray==2025.6.1 pandas==2.3.3 \
  matplotlib==3.10.7 hvplot==0.12.2 holoviews==1.21.0 panel==1.8.3 bokeh==3.8.0
cd "$folder"
cat > level.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import spym  # registers the accessor
import xarray

print("spym", importlib.metadata.version("spym"))
y, x = np.mgrid[0:64, 0:96]
rough = np.random.default_rng(1).normal(size=y.shape)


def report(heights: np.ndarray) -> tuple[float, float]:
    return float(heights.mean()), float(np.sqrt((heights**2).mean()))


fault = False
for mean in (5.0, -2.0, 0.0):
    heights = 0.02 * (x - x.mean()) - 0.03 * (y - y.mean()) + 0.1 * rough
    heights += mean - heights.mean()
    design = np.column_stack([x.ravel(), y.ravel(), np.ones(x.size)])
    plane = (design @ np.linalg.lstsq(design, heights.ravel(), rcond=None)[0]).reshape(x.shape)
    image = xarray.DataArray(heights.copy(), dims=("y", "x"))
    image.spym.plane()
    once = report(image.values)
    background = float(image.spym.background.mean())
    spread = float(np.abs(image.values + mean - (heights - plane)).max())
    image.spym.plane()
    twice = report(image.values)
    wanted = report(heights - plane)
    print(f"map of mean {mean:+.1f} nm: expected mean {abs(wanted[0]):.3f} and rms {wanted[1]:.3f}; "
          f"seen {once[0]:+.3f} and {once[1]:.3f}, after a second levelling {twice[0]:+.3f} and {twice[1]:.3f}; background {background:+.1f} nm")
    fault |= abs(once[0] + mean) > 1e-9 or abs(twice[0] - mean) > 1e-9 or abs(background - 2 * mean) > 1e-9
    fault |= spread > 1e-9  # but for its mean it is the plane of least squares
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore level.py
