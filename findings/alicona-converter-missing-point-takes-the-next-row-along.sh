#!/usr/bin/env bash
# Finding: In alicona_converter one point that was not measured costs a row of the map: its own row goes on with the next one after the hole, the next row is lost, and all below move up by one pitch.
# Package: alicona_converter 1.0.10 (PyPI)
# Expected: An exported map of 40 by 30 points in which one point is missing keeps its 30 rows, or is refused; the other points keep their places.
# Seen: The file for the lubrication software has 28 rows in place of 30 and still 1 um from row to row: the last is dropped of every map, the one after the hole is gone, and the rest of the row with the hole is shifted by a point. A ball below the hole lies 1 um higher up.
# Touches carom: Maps that went through this converter are shorter than the surface, by a row and one for each hole; fill holes before it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numba==0.62.1 llvmlite==0.45.1 numpy==2.3.5 scipy==1.17.1 matplotlib==3.10.7 SciencePlots==2.2.2 \
  python-translator==1.0.3 requests==2.34.2 beautifulsoup4==4.15.0 pytest==9.2.0
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps alicona_converter==1.0.10 scientific_plots==1.9.10
cd "$folder"
cat > hole.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from alicona_converter import SurfaceData

COLUMNS, ROWS = 40, 30
hole = tuple(int(word) for word in sys.argv[1:])
x, y = np.meshgrid(np.arange(COLUMNS), np.arange(ROWS))
heights = 0.01 * x + 0.1 * y  # um
with open("map.txt", "w") as file:
    for row in range(ROWS):
        for column in range(COLUMNS):
            if (column, row) != hole:
                file.write(f"{column} {row} {heights[row, column]:.6f}\n")
SurfaceData("map.txt").write_flow_factor_data("map.dat", E=210, nu=0.3, yield_pressure=1000)
head, body = open("map.dat").read().split("<data_start>\n")
words = dict(line.split("=") for line in head.splitlines() if "=" in line)
seen = np.array([[float(word) for word in line.split()] for line in body.splitlines() if not line.startswith("<")]).T
level = heights[0, 0] - seen[0, 0]  # the mean is taken off
rows = np.rint((seen[:, 0] + level) / 0.1).astype(int)
whole = [bool(np.abs(line + level - heights[row]).max() < 1e-6) for line, row in zip(seen, rows)]
lost = sorted(set(range(ROWS)) - set(rows.tolist()))
print("alicona_converter", importlib.metadata.version("alicona_converter"), f"hole at {hole}:" if hole else "no hole:",
      f"expected {ROWS} rows, seen {words['ny']}, pitch {words['dy_[ym]']} um, rows lost {lost}, rows mixed {[int(rows[i]) for i in range(len(rows)) if not whole[i]]}")
fault = float(words["dy_[ym]"]) != 1 or int(words["ny"]) != len(seen) or seen.shape[1] != COLUMNS
if hole:
    row = hole[1]
    mixed = seen[row] + level
    fault |= lost != [row + 1, ROWS - 1] or [i for i in range(len(whole)) if not whole[i]] != [row]
    # After the hole the row goes on one point late and ends with the first point of the lost one.
    fault |= np.abs(mixed[hole[0] : -1] - heights[row, hole[0] + 1 :]).max() > 1e-6 or abs(mixed[-1] - heights[row + 1, 0]) > 1e-6
else:
    fault |= lost != [ROWS - 1] or not all(whole)
sys.exit(int(fault))
PYTHON
env/bin/python hole.py
env/bin/python hole.py 10 12
env/bin/python hole.py 30 5
