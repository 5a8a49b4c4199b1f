#!/usr/bin/env bash
# Finding: In spmkit a force curve without any adhesion has one of the size of its offset: the base line is taken off for the modulus, but not for the adhesion of the same result.
# Package: spmkit 0.1.2 (PyPI)
# Expected: The fit of a curve, and the maps of a whole channel, take the base line off first. A Hertzian curve without pull-off then has no adhesion, one with a pull-off of 3 nN has 3 nN, wherever the zero of the deflection lay.
# Seen: The modulus is the same for every offset, but a curve that lies 5 nN low has 5.0 nN of adhesion, one with a pull-off of 3 nN that lies 5 nN high has none, and one that lies 5 nN low has 8.0 nN.
# Touches carom: Correct a curve before its adhesion is turned into a work of adhesion for a JKR or DMT contact.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==1.26.4 scipy==1.11.4
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps spmkit==0.1.2
cd "$folder"
cat > pull.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from spmkit.core.analysis import mechanics
from spmkit.core.models import SPMChannel

MODULUS, POISSON, RADIUS = 2e6, 0.5, 1e-6  # Pa, none, m
CONTACT, RANGE, POINTS = 1.5e-6, 2e-6, 2001  # m, m


def curve(pull: float, offset: float) -> np.ndarray:
    """Force (N) over the travel of a stiff cantilever: a base line, a dip before contact, then Hertz."""
    travel = np.linspace(0.0, RANGE, POINTS)
    depth = np.clip(travel - CONTACT, 0.0, None)
    hertz = 4 / 3 * MODULUS / (1 - POISSON**2) * np.sqrt(RADIUS) * depth**1.5
    dip = -pull * np.clip(1 - np.abs(travel - CONTACT + 5e-8) / 5e-8, 0.0, None)
    return hertz + dip + offset


print("spmkit", importlib.metadata.version("spmkit"))
fault = False
for pull in (0.0, 3e-9):
    for offset in (0.0, -5e-9, 5e-9):
        force = curve(pull, offset)
        data = mechanics.ForceCurve(z=np.linspace(0.0, RANGE, POINTS), force=force)
        one = mechanics.fit_hertz(data, RADIUS, POISSON, contact_point=CONTACT)
        channel = SPMChannel("Deflection", np.vstack([force] * 4), "N", 1.0, 1.0, metadata={"Dim0Min": "0", "Dim0Range": str(RANGE)})
        map_ = mechanics.fit_all(channel, RADIUS, POISSON).adhesion
        first = mechanics.adhesion(mechanics.baseline_correct(data))
        print(
            f"pull-off {1e9 * pull:.1f} nN, offset {1e9 * offset:+.1f} nN: expected {1e9 * pull:.2f} nN, {1e-6 * MODULUS:.3f} MPa; seen {1e9 * one.adhesion:.2f} nN, "
            f"{1e-6 * one.young_modulus:.3f} MPa, in the map {1e9 * map_.mean():.2f} nN; corrected by hand before {1e9 * first:.2f} nN"
        )
        fault |= abs(one.young_modulus / MODULUS - 1) > 0.01 or abs(first - pull) > 1e-12
        fault |= abs(one.adhesion - max(pull - offset, 0.0)) > 1e-12 or np.abs(map_ - one.adhesion).max() > 1e-15
sys.exit(int(fault))
PYTHON
env/bin/python pull.py
