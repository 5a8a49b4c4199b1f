#!/usr/bin/env bash
# Finding: An x3p file that SurfaceTopography writes is refused as corrupted by surfalize and by x3pio: it stores the checksum of the heights where that of main.xml belongs.
# Package: SurfaceTopography 1.25.0 (PyPI), surfalize 0.19.2 (PyPI), x3pio 2.0.0 (PyPI)
# Expected: ISO 25178-72 is a format of exchange; a surface written by one of these packages can be read by the others.
# Seen: md5checksum.hex holds the MD5 of bindata/data.bin; surfalize raises CorruptedFileError, x3pio X3pChecksumError, and only x3pio.read(verify=False) gives the heights.
# Touches carom: carom holds against the heights the sum that main.xml states for them, and reads the file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SurfaceTopography==1.25.0 surfalize==0.19.2 x3pio==2.0.0 numpy==2.4.6
cd "$folder"
cat > exchange.py <<'PYTHON'
import hashlib
import importlib.metadata
import sys
import zipfile

import numpy as np
import surfalize
import SurfaceTopography
import x3pio

for name in ("SurfaceTopography", "surfalize", "x3pio"):
    print(name, importlib.metadata.version(name))
heights = np.arange(12.0).reshape(3, 4) * 1e-6
SurfaceTopography.Topography(heights.T, (8e-6, 3e-6), unit="m").to_x3p("surface.x3p")
with zipfile.ZipFile("surface.x3p") as archive:
    stored = archive.read("md5checksum.hex").decode().split()[0].lower()
    sums = {name: hashlib.md5(archive.read(name)).hexdigest() for name in ("main.xml", "bindata/data.bin")}
print("checksum of main.xml: expected", sums["main.xml"], "stored", stored, "which is that of", *(n for n, s in sums.items() if s == stored))


def outcome(read):
    try:
        read("surface.x3p")
        return "read"
    except Exception as error:
        return type(error).__name__


seen = {"surfalize": outcome(surfalize.Surface.load), "x3pio": outcome(x3pio.read)}
print("expected: read by both; seen:", seen)
unverified = x3pio.read("surface.x3p", verify=False).layers[0].z
right = seen == {"surfalize": "CorruptedFileError", "x3pio": "X3pChecksumError"} and stored == sums["bindata/data.bin"]
sys.exit(int(not right or not np.allclose(unverified, heights, rtol=0, atol=1e-15)))
PYTHON
env/bin/python -W ignore exchange.py
