#!/usr/bin/env bash
# Finding: A missing point in an SDF file of surfalize is a height of minus infinity for SurfaceTopography, which does not count it as missing.
# Package: SurfaceTopography 1.25.0 (PyPI), surfalize 0.19.2 (PyPI), sdfio 2.0.0 (PyPI)
# Expected: ISO 25178-71 has a value for points that were not measured; `has_undefined_data` is true and the heights are masked, as they are for SurfaceTopography's other formats.
# Seen: surfalize and sdfio read NaN; SurfaceTopography gives -inf, has_undefined_data false, and an rms height that is masked. Files of 16-bit integers, written by sdfio, it masks.
# Touches carom: carom takes this point of the file as missing, and refuses a height of -inf in an array by row and column.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.25.0 surfalize==0.19.2 sdfio==2.0.0 numpy==2.4.6
cd "$folder"
cat > holes.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import sdfio
import surfalize
import SurfaceTopography

for name in ("SurfaceTopography", "surfalize", "sdfio"):
    print(name, importlib.metadata.version(name))
heights = np.array([[10.0, 11, 12, 13], [20, np.nan, 22, 24], [21, 22, 23, 25]])  # um
surfalize.Surface(heights, 2, 2).save("floats.sdf")
own = sdfio.Metadata(data_type=sdfio.DataType.INT16, revision=sdfio.Revision.ISO_1_0)
sdfio.write("integers.sdf", heights * 1e-6, x_scale=2e-6, y_scale=2e-6, metadata=own)
for path in ("floats.sdf", "integers.sdf"):
    assert np.isnan(surfalize.Surface.load(path).data[1, 1]) and np.isnan(sdfio.read(path).data[1, 1])
floats, integers = (SurfaceTopography.read_topography(path) for path in ("floats.sdf", "integers.sdf"))
hole = np.ma.asarray(floats.heights())[1, 1]
rms = floats.rms_height_from_area()
print("integers: expected missing, seen", "missing" if integers.has_undefined_data else integers.heights()[1, 1])
print(f"floats: expected missing, seen height {hole}, has_undefined_data {floats.has_undefined_data}, rms height {rms}")
sys.exit(int(not (integers.has_undefined_data and not floats.has_undefined_data and hole == -np.inf and rms is np.ma.masked)))
PYTHON
env/bin/python -W ignore holes.py
