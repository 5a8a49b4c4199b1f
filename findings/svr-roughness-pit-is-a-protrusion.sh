#!/usr/bin/env bash
# Finding: In svr-roughness a pit of a casting is a protrusion and a bump a depression, or not, by the outline of the scan: the side from which the plate was measured is lost.
# Package: svr-roughness 0.8.5 (PyPI)
# Expected: A pit 0.5 mm deep in a plate that is scanned from above (+z) is a depression, a bump of 0.5 mm a protrusion, whatever the size of the plate.
# Seen: On 60 by 50 mm both are taken for the other kind; on 80 by 50 mm both are protrusions. The normal of the fitted plane points down or up by chance of its axes, and the kind is by its side.
# Touches carom: Heights that come back from this package may be upside down; take the sign of the normal from the scan before a map is pressed in carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile svr-roughness==0.8.5 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > pit.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import svr_roughness

print("svr-roughness", importlib.metadata.version("svr-roughness"))


def scan(length: float, width: float, height: float) -> np.ndarray:
    """Points of a plate with a round bump or pit on it and noise of 10 um, in mm, from above."""
    x, y = np.meshgrid(np.arange(0, length + 1e-9, 0.2), np.arange(0, width + 1e-9, 0.2))
    noise = 0.01 * np.random.default_rng(0).standard_normal(x.shape)
    z = noise + height * np.exp(-((x - 0.4 * length) ** 2 + (y - 0.6 * width) ** 2) / (2 * 1.5**2))
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()])


wrong = right = 0
for length, width in ((60, 50), (50, 60), (80, 50), (55, 50), (50, 50)):
    for height, kind in ((0.5, "protrusion"), (-0.5, "depression")):
        result = svr_roughness.analyze_points(scan(length, width, height), detect_abnormalities=True)
        (spot,) = result.abnormalities
        up = result.plane.normal[2] > 0
        print(f"{length} by {width} mm, height {height:+g} mm: expected a {kind}, seen a {spot.kind} of {spot.peak_deviation_um:g} um, "
              f"normal {'up' if up else 'down'}")
        wrong += spot.kind != kind
        right += spot.kind == kind
        if (spot.kind == kind) != up or not 400 < spot.peak_deviation_um < 500:
            sys.exit("the kind is not by the side of the normal")
print(f"{wrong} of {wrong + right} are taken for the other kind")
sys.exit(int(not (wrong >= 3 and right >= 2)))
PYTHON
env/bin/python pit.py
