#!/usr/bin/env bash
# Finding: Of three packages that read one x3p file of 16-bit heights, SurfaceTopography alone takes them for unsigned: a valley of 20 um becomes a peak of 26 um, without a word.
# Package: SurfaceTopography 1.25.0 (PyPI), surfalize 0.19.2 (PyPI), x3pio 2.0.0 (PyPI)
# Expected: The data type I of ISO 25178-72 is a signed integer of 16 bits; all three read the heights that were written.
# Seen: Heights of -20 and 23 um: x3pio and surfalize read both, SurfaceTopography reads +26.0 and 23 um, the negative one higher by 65536 steps of the z axis; 32 bits (type L) likewise.
# Touches carom: carom reads these integers with their sign. Heights that reach it through SurfaceTopography are wrong wherever they are below zero: give it the file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.25.0 surfalize==0.19.2 x3pio==2.0.0 numpy==2.4.6
cd "$folder"
cat > signs.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import surfalize
import SurfaceTopography
import x3pio

for name in ("SurfaceTopography", "surfalize", "x3pio"):
    print(name, importlib.metadata.version(name))
heights = np.array([[0.0, 1, 2, 3], [10, 11, 12, 13], [-20, 21, 22, 23]])  # um
fault = False
for kind, bits in ((x3pio.DataType.INT16, 16), (x3pio.DataType.INT32, 32)):
    path = f"surface{bits}.x3p"
    x3pio.write(path, heights * 1e-6, x_scale=2e-6, y_scale=1e-6, z_type=kind, revision=x3pio.Revision.ISO5436_2000)
    seen = {
        "x3pio": x3pio.read(path).layers[0].z * 1e6,
        "surfalize": surfalize.Surface.load(path).data,
        "SurfaceTopography": np.asarray(SurfaceTopography.read_topography(path).heights()).T * 1e6,
    }
    for name, z in seen.items():
        print(f"{bits} bits, expected lowest and highest height -20 and 23 um, {name}: {z.min():.2f} and {z.max():.2f}, at the valley {z[2, 0]:.2f}")
    wrapped = heights.copy()
    wrapped[2, 0] += 23 * 2**bits / (2 ** (bits - 1) - 1)
    stated = {"x3pio": heights, "surfalize": heights, "SurfaceTopography": wrapped}
    fault |= any(abs(seen[name] - z).max() > 0.01 for name, z in stated.items())
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore signs.py
