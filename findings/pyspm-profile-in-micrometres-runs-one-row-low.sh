#!/usr/bin/env bash
# Finding: In pySPM a profile between two points given in micrometres is read one row too low; along the lower edge it is zero height, whatever the map.
# Package: pySPM 0.6.3 (PyPI)
# Expected: The profile between two points is the same whether the points are given in pixels or in micrometres; a map that is level at 100 nm has a level profile.
# Seen: In pixels it is right. In micrometres all heights are those of the next lower row, and what starts at the edge starts outside the map with 0: the level map has a step of 100 nm, its lower edge lies at 0.
# Touches carom: Cut profiles for a contact from the array or with points in pixels; a step at the start of a profile may be the reader's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pySPM==0.6.3 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > low.py <<'PYTHON'
import importlib.metadata
import sys
import warnings

warnings.simplefilter("ignore")
import numpy as np
import pySPM

print("pySPM", importlib.metadata.version("pySPM"))
ROWS, COLUMNS = 41, 61
WIDTH, HEIGHT = 6.0, 4.0  # um; one pixel is 0.1 um from centre to centre
row = np.arange(ROWS)[:, None] + np.zeros(COLUMNS)
MAPS = {"level map of 100 nm": 100.0 + 0.0 * row, "ramp of 100 nm to 140 nm, 1 nm a row": 100.0 + row}
# Row 0 is the lower edge: cut and show agree on that.


def profile(heights: np.ndarray, ends: tuple[float, float, float, float]) -> np.ndarray:
    image = pySPM.SPM_image(heights.copy(), real={"x": WIDTH, "y": HEIGHT, "unit": "um"}, zscale="nm")
    return image.get_profile(*ends, pixels=False)[1]


def in_pixels(heights: np.ndarray) -> np.ndarray:
    """The column in the middle, downwards."""
    image = pySPM.SPM_image(heights.copy(), real={"x": WIDTH, "y": HEIGHT, "unit": "um"}, zscale="nm")
    return image.get_profile(COLUMNS // 2, 0, COLUMNS // 2, ROWS - 1, pixels=True)[1]


fault = False
for name, heights in MAPS.items():
    print(name)
    down = in_pixels(heights)
    print(f"    column in pixels: expected {heights[-1, 0]:g} to {heights[0, 0]:g}; seen {down[0]:g} to {down[-1]:g} nm")
    fault |= not np.allclose(down, heights[::-1, COLUMNS // 2])
    for line, ends, rows in (
        ("lower edge", (0.0, 0.0, WIDTH, 0.0), (0, 0)),
        ("middle row", (0.0, HEIGHT / 2, WIDTH, HEIGHT / 2), (ROWS // 2, ROWS // 2)),
        ("upper edge", (0.0, HEIGHT, WIDTH, HEIGHT), (ROWS - 1, ROWS - 1)),
        ("column from edge to edge", (WIDTH / 2, 0.0, WIDTH / 2, HEIGHT), (0, ROWS - 1)),
    ):
        seen = profile(heights, ends)
        wanted = [heights[place, 0] for place in rows]
        lower = [heights[place - 1, 0] if place else 0.0 for place in rows]
        print(f"    {line} in um: expected {wanted[0]:g} to {wanted[1]:g}; seen {seen[0]:g} to {seen[-1]:g} nm, "
              f"peak to valley {np.ptp(seen):g} nm")
        fault |= not np.allclose([seen[0], seen[-1]], lower)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore low.py
