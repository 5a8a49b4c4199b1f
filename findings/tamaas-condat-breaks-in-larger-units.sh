#!/usr/bin/env bash
# Finding: The solver Condat of tamaas gives infinite pressures for the contact with friction that it solves to 0.4 %, if the modulus is 1000 in place of 1.
# Package: tamaas 2.9.0 (PyPI)
# Expected: Elasticity has no unit of its own: modulus and load 1000 times as large give 1000 times the traction, as they do from the solver PolonskyKeerTan.
# Seen: Modulus 1: mean pressure right to 5e-8, peak 1.004 of Hertz; modulus 1000: pressures of inf, and neither an error nor a warning.
# Touches carom: Whoever compares carom with tamaas states the problem in units in which the pressures are of the size of 1; carom itself takes any units.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check tamaas==2.9.0 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > units.py <<'PYTHON'
import sys

import numpy as np
import tamaas as tm

tm.set_log_level(tm.LogLevel.error)
CELLS, SIDE, RADIUS, CONTACT, POISSON, FRICTION = 64, 3.0, 10.0, 0.5, 0.5, 0.3


def contact(solver, modulus: float) -> tuple[float, float]:
    """Mean pressure over the given one, peak over Hertz's, of a sphere pressed and shifted by 0.6 of the friction limit."""
    x = (np.arange(CELLS) + 0.5) / CELLS * SIDE - SIDE / 2
    surface = -np.add.outer(x**2, x**2) / (2 * RADIUS)
    model = tm.ModelFactory.createModel(tm.model_type.surface_2d, [SIDE, SIDE], [CELLS, CELLS])
    model.E, model.nu = modulus * (1 - POISSON**2), POISSON
    mean = 4 / 3 * modulus * CONTACT**3 / RADIUS / SIDE**2
    method = solver(model, surface, 1e-8, FRICTION)
    method.max_iter = 5000
    with np.errstate(all="ignore"):
        method.solve(np.array([0.6 * FRICTION * mean, 0.0, mean]))
        pressure = model.traction[..., 2]
        return float(pressure.mean() / mean), float(pressure.max() / (2 / np.pi * CONTACT / RADIUS * modulus))


print("tamaas", tm.__version__)
fault = False
for solver, breaks in ((tm.PolonskyKeerTan, False), (tm.Condat, True)):
    for modulus in (1.0, 1000.0):
        mean, peak = contact(solver, modulus)
        print(f"{solver.__name__}, modulus {modulus:g}: expected 1 and some 1.004, seen mean {mean:.6f}, peak {peak:.4f}")
        right = abs(mean - 1) < 1e-5 and abs(peak - 1.004) < 0.002
        fault |= np.isfinite(mean) if breaks and modulus > 1 else not right
sys.exit(int(fault))
PYTHON
env/bin/python units.py
