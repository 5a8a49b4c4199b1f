#!/usr/bin/env bash
# Finding: A map that surfalize saves as a TrueMap file is a thousand times as wide, as long and as high for SurfaceTopography.
# Package: surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI)
# Expected: The lengths and heights of a tmd file have one unit, which the format does not write down; a map of 20 um comes back as one of 20 um.
# Seen: surfalize writes and reads micrometres, SurfaceTopography reads millimetres: 20 um become 20 mm, Sq of 0.35 um 0.35 mm. Slopes, Sdr and every ratio stay, so that they tell nothing.
# Touches carom: carom reads x3p and sdf, which say metres. Convert into one of them, not by way of tmd, and compare the rms height, as carom's page on profilometers says.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surfalize==0.19.2 SurfaceTopography==1.27.1 numpy==2.4.6
cd "$folder"
cat > truemap.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import surfalize
import SurfaceTopography

for name in ("surfalize", "SurfaceTopography"):
    print(name, importlib.metadata.version(name))
PITCH, COLUMNS, ROWS = 0.5, 40, 30  # um
x, y = np.meshgrid(np.arange(COLUMNS) * PITCH, np.arange(ROWS) * PITCH)
heights = 0.4 * np.sin(0.7 * x) + 0.3 * np.cos(0.5 * y)  # um
heights -= heights.mean()
surface = surfalize.Surface(heights, PITCH, PITCH)


def measures(topography) -> dict[str, float]:
    """Width, length and roughness in um and the slope of a topography."""
    moved = topography.to_unit("µm")
    return {
        "width": moved.physical_sizes[0],
        "length": moved.physical_sizes[1],
        "Sq": moved.rms_height_from_area(),
        "slope": moved.rms_gradient(),
    }


expected = {"width": COLUMNS * PITCH, "length": ROWS * PITCH, "Sq": surface.Sq()}
factors = {}
for kind in ("sdf", "tmd"):
    surface.save(f"map.{kind}")
    seen = measures(SurfaceTopography.read_topography(f"map.{kind}"))
    back = surfalize.Surface.load(f"map.{kind}")
    factors[kind] = [seen[name] / value for name, value in expected.items()]
    factors[kind].append(back.Sq() / expected["Sq"])
    print(f"saved by surfalize as {kind}: expected width {expected['width']:g} um, length {expected['length']:g} um, Sq {expected['Sq']:.4f} um")
    print(f"    seen by SurfaceTopography: width {seen['width']:g} um, length {seen['length']:g} um, Sq {seen['Sq']:.4f} um, "
          f"slope {seen['slope']:.4f}; by surfalize: Sq {back.Sq():.4f} um")
fault = not np.allclose(factors["sdf"], 1.0, rtol=1e-3) or not np.allclose(factors["tmd"], [1e3, 1e3, 1e3, 1.0], rtol=1e-3)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore truemap.py
