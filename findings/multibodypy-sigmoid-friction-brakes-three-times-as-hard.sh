#!/usr/bin/env bash
# Finding: In MultibodyPy the sigmoid law of friction with the coefficient 0.3 brakes a sliding body with 0.9 of its load, and starts from 0.6 of it at no speed at all.
# Package: MultibodyPy 0.0.5 (PyPI)
# Expected: It is a smooth Coulomb law, as the linear and the tanh law of the package: nothing at rest, and the coefficient times the load well above its speed.
# Seen: With 0.3 at 0.01 m/s under 1000 N: 600 N at 1e-9 m/s, where the others have less than a millinewton, 871 N at half the speed and 900 N from 0.03 m/s on, the others 300 N. One coefficient is added to twice the sigmoid in place of being subtracted.
# Touches carom: Use the tanh or the linear law where a slide is compared with carom's Coulomb friction.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile MultibodyPy==0.0.5 numpy==1.26.4 scipy==1.11.4
cd "$folder"
cat > slow.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from MultibodyPy import forces

COEFFICIENT, SPEED, LOAD, MASS = 0.3, 0.01, 1000.0, 100.0
laws = {
    "linear": forces.SimpleFriction(COEFFICIENT, SPEED),
    "tanh": forces.HyperbolicTangensFriction(COEFFICIENT, SPEED),
    "sigmoid": forces.SigmoidFriction(COEFFICIENT, SPEED),
}


def friction(law, speed: float) -> float:
    return float(law.get_friction_force(LOAD, np.array([speed, 0.0, 0.0])))


print("MultibodyPy", importlib.metadata.version("MultibodyPy"), f"coefficient {COEFFICIENT} at {SPEED} m/s, load {LOAD:g} N")
fault = False
for speed in (1e-9, 0.005, 0.03, 1.0):
    seen = {name: friction(law, speed) for name, law in laws.items()}
    print(f"{speed:g} m/s: " + ", ".join(f"{name} {force:.4f} N" for name, force in seen.items()))
    fault |= abs(seen["sigmoid"] - LOAD * COEFFICIENT * (1 + 2 / (1 + np.exp(-6 * speed / SPEED)))) > 1e-6
    if speed > 0.02:
        fault |= max(abs(seen[name] - COEFFICIENT * LOAD) for name in ("linear", "tanh")) > 0.5 or abs(seen["sigmoid"] - 3 * COEFFICIENT * LOAD) > 0.5
    if speed < 1e-6:
        fault |= max(seen["linear"], seen["tanh"]) > 1e-3 or abs(seen["sigmoid"] - 2 * COEFFICIENT * LOAD) > 1e-3
for name, law in laws.items():
    # A body of 100 kg brakes from 1 m/s to 0.1 m/s.
    speed, way, step = 1.0, 0.0, 1e-5
    while speed > 0.1:
        speed -= step * friction(law, speed) / MASS
        way += step * speed
    expected = (1 - 0.1**2) / (2 * COEFFICIENT * LOAD / MASS)
    print(f"{name}: way from 1 to 0.1 m/s expected {expected:.4f} m, seen {way:.4f} m")
    fault |= abs(way / expected - (1 / 3 if name == "sigmoid" else 1)) > 2e-3
sys.exit(int(fault))
PYTHON
env/bin/python slow.py
