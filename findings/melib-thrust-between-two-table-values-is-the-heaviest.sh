#!/usr/bin/env bash
# Finding: In melib the thrust factor of a ball bearing that lies between two values of its table gives the last row, the heaviest thrust, whatever the factor is.
# Package: melib 1.1.1 (PyPI)
# Expected: A factor Y of 2.2 lies between 2.30 and 1.99, so the thrust over the static rating lies between 0.014 and 0.028 and the limit e between 0.19 and 0.22; the function says it computes both from Y.
# Seen: Every Y between table values, 2.2 as well as 1.1, gives 0.56 and 0.44, the row of Y = 1.0; on a table value the answer is right, and from e or from the thrust it is interpolated.
# Touches carom: None in its code; a thrust load from an iteration over Y with this function is up to forty times too high for a bearing contact of carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile setuptools==75.8.0 wheel==0.45.1 numpy==2.4.6 scipy==1.17.1 matplotlib==3.10.7 openpyxl==3.1.5 ordered-set==4.1.0
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-build-isolation --no-deps pylatex==1.4.2 melib==1.1.1
cd "$folder"
cat > thrust.py <<'PYTHON'
import importlib.metadata
import sys

from melib.library import dgbbrtfacs

print("melib", importlib.metadata.version("melib"))
# What the function itself gives for its table values of Y.
TABLE = [2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00]
rows = [dgbbrtfacs(Y=factor) for factor in TABLE]
fault = any(row[0] >= after[0] or row[1] >= after[1] for row, after in zip(rows, rows[1:]))
for factor in (2.2, 1.99, 1.8, 1.5, 1.4, 1.2, 1.1):
    e, thrust, _ = (float(value) for value in dgbbrtfacs(Y=factor))
    above = max(index for index, value in enumerate(TABLE) if value >= factor)
    below = above if TABLE[above] == factor else above + 1
    print(f"Y {factor:g}: expected e from {rows[above][0]:g} to {rows[below][0]:g}, thrust over rating from {rows[above][1]:g} to {rows[below][1]:g}; "
          f"seen {e:g} and {thrust:g}")
    fault |= (e, thrust) != ((rows[above][0], rows[above][1]) if above == below else (0.44, 0.56))
# The other way: from the thrust to Y and back.
for thrust in (0.02, 0.07, 0.2):
    factor = float(dgbbrtfacs(TC=thrust)[2])
    back = float(dgbbrtfacs(Y=factor)[1])
    print(f"thrust over rating {thrust:g} gives Y {factor:.4f}, which gives {back:g}, {back / thrust:.1f} times as much")
    fault |= back != 0.56
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore thrust.py
