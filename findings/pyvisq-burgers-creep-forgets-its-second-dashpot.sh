#!/usr/bin/env bash
# Finding: In pyvisq the creep of a Burgers body does not depend on its Kelvin-Voigt branch: that branch takes the spring and the dashpot of the Maxwell branch a second time.
# Package: pyvisq 1.2.2 (PyPI)
# Expected: J(t) = 1 / ka + t / ca + (1 - exp(-kb t / cb)) / kb, and a relaxation G that belongs to it: the convolution of G and J is t.
# Seen: With ka 1, ca 100 the creep after 50 s is 1.893 for every kb and cb, where kb 10, cb 5 give 1.6 and kb 0.1, cb 5 give 7.82; the relaxation depends on them as it should, so the two no longer belong together.
# Touches carom: carom's bodies are elastic; a viscoelastic law that is fitted to creep with this model for a restitution has its delayed part wrong.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pyvisq==1.2.2 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > burgers.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from pyvisq.models import burgers, elements
from scipy.integrate import quad

print("pyvisq", importlib.metadata.version("pyvisq"))
SPRING, DASHPOT = 1.0, 100.0


def body(kb: float, cb: float):
    return burgers.Burgers(burgers.BurgersParams(
        elements.DashpotParams(DASHPOT), elements.SpringParams(SPRING), elements.DashpotParams(cb), elements.SpringParams(kb)))


def creep(t: float, kb: float, cb: float) -> float:
    """Strain under the unit stress."""
    return 1 / SPRING + t / DASHPOT - np.expm1(-kb * t / cb) / kb


fault = False
for kb, cb in ((10.0, 5.0), (0.1, 5.0), (10.0, 500.0), (1.0, 100.0)):
    model = body(kb, cb)
    seen = [float(model.J(t)) for t in (5.0, 50.0, 200.0)]
    right = [creep(t, kb, cb) for t in (5.0, 50.0, 200.0)]
    print(f"kb {kb:g}, cb {cb:g}: creep after 5, 50, 200 s expected {np.round(right, 4)}, seen {np.round(seen, 4)}")
    fault |= not np.allclose(seen, [creep(t, SPRING, DASHPOT) for t in (5.0, 50.0, 200.0)], rtol=1e-9)
model = body(0.1, 5.0)
time = 50.0
for name, compliance in (("its own creep", lambda t: float(model.J(t))), ("the creep by the formula", lambda t: creep(t, 0.1, 5.0))):
    product = quad(lambda s: model.G(s) * compliance(time - s), 0, time, limit=200)[0]
    print(f"convolution of relaxation and {name} up to {time:g} s: expected {time:g}, seen {product:.4f}")
    fault |= abs(product - time) > 1e-3 if name != "its own creep" else abs(product - time) < 10
sys.exit(int(fault))
PYTHON
env/bin/python burgers.py
