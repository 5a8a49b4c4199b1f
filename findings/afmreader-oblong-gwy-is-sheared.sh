#!/usr/bin/env bash
# Finding: AFMReader exchanges width and height of an image of gwy without transposing it, so a round hill becomes a row of shreds, and the pixel takes the wrong size.
# Package: AFMReader 0.0.7, gwyfile 0.3.0 (PyPI)
# Expected: An image of 96 by 48 points with square pixels of 10 nm comes back as it was written, with 10 nm, as gwyfile reads it.
# Seen: AFMReader gives 96 rows of 48 and 20 nm in place of 48 rows of 96 and 10 nm, and the steps from row to row have 14 times their rms; square images come back right.
# Touches carom: Crop a map to a square before it goes through AFMReader, or read gwy otherwise; carom itself reads none of it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
# Only what its reader of gwy needs; the packages for its other formats are large.
"$folder/env/bin/pip" install -q --disable-pip-version-check numpy==2.4.6 loguru==0.7.3 h5py==3.16.0 ruamel.yaml==0.19.1
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps AFMReader==0.0.7 gwyfile==0.3.0
cd "$folder"
cat > oblong.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import gwyfile
from AFMReader.gwy import load_gwy
from gwyfile.objects import GwyContainer, GwyDataField, GwySIUnit
from loguru import logger

logger.remove()
PIXEL = 10.0


def write(name: str, columns: int, rows: int) -> np.ndarray:
    """A round hill of 5 nm in the middle of an image, as gwy; its heights in nm."""
    x, y = np.arange(columns) - (columns - 1) / 2, np.arange(rows) - (rows - 1) / 2
    heights = 5 * np.exp(-(x[None, :] ** 2 + y[:, None] ** 2) / 100)
    file = GwyContainer()
    file["/0/data/title"] = "Height"
    metre = {"si_unit_xy": GwySIUnit(unitstr="m"), "si_unit_z": GwySIUnit(unitstr="m")}
    file["/0/data"] = GwyDataField(heights * 1e-9, xreal=columns * PIXEL * 1e-9, yreal=rows * PIXEL * 1e-9, **metre)
    file.tofile(name)
    return heights


for package in ("AFMReader", "gwyfile"):
    print(package, importlib.metadata.version(package))
fault = False
for columns, rows in ((64, 64), (96, 48), (48, 96)):
    heights = write("hill.gwy", columns, rows)
    image, pixel = load_gwy("hill.gwy", "Height")
    other = gwyfile.util.get_datafields(gwyfile.load("hill.gwy"))["Height"]
    right = image.shape == heights.shape and np.allclose(image, heights) and abs(pixel - PIXEL) < 1e-9
    slopes = [np.diff(image, axis=axis).std() / np.diff(heights, axis=axis).std() for axis in (0, 1)]
    print(f"{columns} columns, {rows} rows: expected shape {heights.shape}, pixel {PIXEL:g} nm")
    print(f"  gwyfile: shape {other.data.shape}, pixel {1e9 * other.xreal / columns:g} nm, same heights {np.allclose(1e9 * other.data, heights)}")
    print(f"  AFMReader: shape {image.shape}, pixel {pixel:g} nm, same heights {right}")
    print(f"  steps from row to row times {slopes[0]:.2f}, from column to column times {slopes[1]:.2f}")
    fault |= other.data.shape != heights.shape or not np.allclose(1e9 * other.data, heights)
    fault |= right != (columns == rows) or image.shape != (columns, rows) or abs(pixel - PIXEL * columns / rows) > 1e-9
    fault |= not np.allclose(image.ravel(), heights.ravel())
sys.exit(int(fault))
PYTHON
env/bin/python oblong.py
