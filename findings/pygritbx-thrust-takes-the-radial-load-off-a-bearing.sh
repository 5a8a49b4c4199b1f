#!/usr/bin/env bash
# Finding: In pygritbx the thrust of a bearing changes its radial load: 1000 N along the shaft turn a radial 5000 N into 3606, 5385 or 6403 N, by the direction in which the radial load points.
# Package: pygritbx 1.1.4 (PyPI)
# Expected: The radial load is the root of the squares of the two components across the shaft, 5000 N for 3000 and 4000 N of either sign, and the life of a bearing does not depend on which way is up.
# Seen: The size of the thrust is taken from all three components. The equivalent load goes along, so that one bearing under one load lives 6400, 1700 or 940 million turns; without thrust the load is right.
# Touches carom: Loads of a rolling contact that were resolved with this package must be resolved anew before they go into a case.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==2.4.6 scipy==1.17.1 matplotlib==3.10.7
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps pygritbx==1.1.4
cd "$folder"
cat > thrust.py <<'PYTHON'
import importlib.metadata
import math
import sys

import numpy as np
from pygritbx import Force, Support

print("pygritbx", importlib.metadata.version("pygritbx"))
RATING = 50000.0


def load(force: tuple[float, float, float]) -> tuple[float, float, float]:
    """Radial load, thrust and life in millions of turns of an angular contact bearing of 40 degrees on a shaft along z."""
    bearing = Support(name="A", type="Pin", bearingType="Contact Ball", axis=np.array([0.0, 0.0, 1.0]), loc=0.0,
                      C=RATING, C0=40000.0, e=1.14, X=0.35, Y=0.57, Y0=0.26, Y2=0.57)
    bearing.F_tot = Force(np.array(force), 0.0)
    bearing.updateReaction()
    bearing.n, bearing.a_skf = 1000, 1.0
    bearing.calculateA1(rel=90)
    bearing.calculateEquivalentDynamicLoad()
    bearing.calculateBearingLife()
    return float(bearing.F_r), float(bearing.F_a), float(bearing.L_10m)


fault = False
for force, wrong in (((3000.0, 4000.0, 0.0), 5000.0), ((3000.0, 4000.0, 1000.0), 3605.55), ((3000.0, 4000.0, -1000.0), 4123.11),
                     ((3000.0, -4000.0, 1000.0), 5385.16), ((-3000.0, -4000.0, 1000.0), 6403.12), ((5000.0, 0.0, 1000.0), 4123.11)):
    radial, thrust, life = load(force)
    print(f"force {force} N: expected radial {math.hypot(*force[:2]):.0f} N, thrust {abs(force[2]):.0f} N; "
          f"seen radial {radial:.1f} N, thrust {thrust:.0f} N, life {life:.0f} million turns")
    fault |= abs(radial - wrong) > 0.01 or abs(thrust - abs(force[2])) > 1e-9
longest, shortest = load((3000.0, 4000.0, 1000.0))[2], load((-3000.0, -4000.0, 1000.0))[2]
print(f"turned by half a turn the same bearing lives {longest / shortest:.2f} times as long; expected 1")
fault |= abs(longest / shortest / 6.78 - 1) > 0.01
sys.exit(int(fault))
PYTHON
env/bin/python thrust.py
