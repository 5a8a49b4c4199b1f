#!/usr/bin/env bash
# Finding: An oblique profile of surfalize lies on a line through the corner of the map, whichever y it is asked to start at.
# Package: surfalize 0.19.2 (PyPI)
# Expected: get_oblique_profile(x0, y0, x1, y1) gives heights along the line between these two points; those of rows that are 10 um apart differ.
# Seen: On a map whose row n is n um high, the profiles of equal slope that start at y = 2, 10 and 20 um are the same profile, 0.7 to 5.5 um high.
# Touches carom: Take the profile for a two-dimensional contact as a row or a column, or from the array itself.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check surfalize==0.19.2 numpy==2.4.6
cd "$folder"
cat > oblique.py <<'PYTHON'
import sys
from importlib.metadata import version

import numpy as np
import surfalize

print("surfalize", version("surfalize"))
rows, columns = np.mgrid[:41, :41]
surface = surfalize.Surface(rows.astype(float), 1, 1)  # heights and steps in um
seen = {}
for start in (2, 10, 20):
    profile = surface.get_oblique_profile(3, start, 23, start + 5).data[:-1]
    seen[start] = profile
    print(f"from y = {start} um: expected heights around {start + 2.5} (or, counted from the other edge, {40 - start - 2.5}) um, seen {profile.min():.2f} to {profile.max():.2f} um")
level = surface.get_horizontal_profile(40 - 20).data
assert np.allclose(level, 20), "a horizontal profile is right"
same = all(np.allclose(profile, seen[2], rtol=0, atol=1e-9) for profile in seen.values())
sys.exit(int(not (same and len(seen[2]) > 15 and seen[2].max() < 8)))
PYTHON
env/bin/python oblique.py
