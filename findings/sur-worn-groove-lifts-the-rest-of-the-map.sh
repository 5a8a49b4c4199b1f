#!/usr/bin/env bash
# Finding: In a SUR file on its way from RosettaSciIO to Gwyddion or surfalize, or back, all heights move by half of the total height: a groove of 8 um makes the untouched surface 4 um higher or lower.
# Package: rosettasciio 0.15.0 (PyPI), surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI), gwyddionpy 0.1.0 (PyPI)
# Expected: One file has one set of heights, so that the difference of a map before and after wear is 0 outside the groove.
# Seen: RosettaSciIO takes the offset in the file for the height of the lowest point, surfalize and Gwyddion for that of the number 0, and SurfaceTopography leaves it out: three zeros. RosettaSciIO and surfalize are each at one with their own files.
# Touches carom: carom takes the offset as Gwyddion and surfalize do. Heights within one map are right by all; a gap or a wear depth from two maps is not: level both by a part that was not touched.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile rosettasciio==0.15.0 surfalize==0.19.2 SurfaceTopography==1.27.1 gwyddionpy==0.1.0 gwyddionpy-converter==0.1.0 numpy==2.4.6
cd "$folder"
cat > wear.py <<'PYTHON'
import importlib.metadata
import sys

import gwyddionpy
import numpy as np
import surfalize
import SurfaceTopography
from rsciio.digitalsurf import file_reader, file_writer

for name in ("rosettasciio", "surfalize", "SurfaceTopography", "gwyddionpy"):
    print(name, importlib.metadata.version(name))
ROWS, COLUMNS, GROOVE = 40, 60, slice(25, 35)
new = 10.0 + np.where(np.add.outer(np.arange(ROWS), np.arange(COLUMNS)) % 2, 0.5, -0.5)  # um: from 9.5 to 10.5
worn = new.copy()
worn[:, GROOVE] -= 8.0


def write_rosettasciio(path: str, heights: np.ndarray) -> None:
    axes = [{"name": name, "units": "um", "size": size, "offset": 0.0, "scale": 1.0, "index_in_array": place, "navigate": False}
            for place, (name, size) in enumerate((("Y", ROWS), ("X", COLUMNS)))]
    signal = {"data": heights, "axes": axes, "metadata": {"General": {}, "Signal": {"quantity": "Height (um)"}}, "original_metadata": {}}
    file_writer(path, signal, compressed=False)


def write_surfalize(path: str, heights: np.ndarray) -> None:
    surfalize.Surface(heights, 1.0, 1.0).save(path)


READERS = {
    "rosettasciio": lambda path: np.asarray(file_reader(path)[0]["data"], dtype=float),
    "surfalize": lambda path: surfalize.Surface.load(path).data,
    "Gwyddion": lambda path: next(iter(gwyddionpy.load(path).channels.values())).data * 1e6,
    "SurfaceTopography": lambda path: np.asarray(SurfaceTopography.read_topography(path).heights()).T,
}
fault = False
for writer, write, lifts, zeros in (
    ("rosettasciio", write_rosettasciio, (0.0, -4.0, -4.0, 4.0), (0.0, -0.5, -0.5, -10.0)),
    ("surfalize", write_surfalize, (4.0, 0.0, 0.0, 4.0), (0.5, 0.0, 0.0, -10.0)),
):
    write("new.sur", new)
    write("worn.sur", worn)
    for (reader, read), lift, zero in zip(READERS.items(), lifts, zeros):
        before, after = read("new.sur"), read("worn.sur")
        change = after - before
        outside, inside = np.delete(change, np.arange(COLUMNS)[GROOVE], axis=1), change[:, GROOVE]
        print(f"written by {writer}, read by {reader}: mean height of the new one expected {new.mean():.2f} um, seen {before.mean():.2f} um; "
              f"wear outside and inside of the groove expected 0.00 and -8.00 um, seen {outside.mean():.2f} and {inside.mean():.2f} um")
        fault |= abs(outside - lift).max() > 0.01 or abs(inside - lift + 8.0).max() > 0.01 or abs(before.mean() - new.mean() - zero) > 0.01
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore wear.py
