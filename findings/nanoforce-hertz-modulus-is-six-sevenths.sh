#!/usr/bin/env bash
# Finding: From a force curve that is Hertz's to the last digit nanoforce takes 6/7 of its modulus: it lays a straight line through the curve and reads the greatest force off that.
# Package: nanoforce 0.3.32 (PyPI)
# Expected: A function that is documented as the Hertz model gives back the modulus of a Hertz curve, as its own pyramid model gives back that of a parabola.
# Seen: 0.857 of the modulus for soft and stiff samples, small and large balls, shallow and deep curves, so that nothing in the data tells it.
# Touches carom: `carom fit` needs the true modulus; multiply one from this function by 7/6, or fit force against depth to the power 3/2.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps nanoforce==0.3.32
"$folder/env/bin/pip" install -q --disable-pip-version-check numpy==1.26.4 scipy==1.15.3 pandas==2.2.3 scikit-learn==1.5.2 plotly==5.24.1 easygui==0.98.3 NSFopen==2.2.4 seaborn==0.13.2 matplotlib==3.9.4 h5py==3.12.1 2> "$folder/pip.log"
cd "$folder"
cat > hertz.py <<'PYTHON'
import contextlib
import importlib.metadata
import io
import sys

import numpy as np
from nanoforce import AFM

print("nanoforce", importlib.metadata.version("nanoforce"))
POISSON, ANGLE = 0.5, 35.0


def modulus(depth: np.ndarray, force: np.ndarray, call) -> float:
    """Modulus in MPa of one curve in nm and nN, deepest point first."""
    curve = AFM()
    curve.z_approach, curve.approach = -depth[:, None], force[:, None]
    with contextlib.redirect_stdout(io.StringIO()):
        call(curve)
    return float(curve.modulus[0])


fault = False
for true, radius, deepest in ((0.02, 5e-6, 1000.0), (2.0, 1e-6, 300.0), (3000.0, 10e-9, 3.0)):  # MPa, m, nm
    depth = np.linspace(deepest, 0.0, 2001)
    metres = depth * 1e-9
    plane = true * 1e6 / (1 - POISSON**2)
    ball = 4 / 3 * plane * np.sqrt(radius) * metres**1.5 * 1e9
    pyramid = plane * np.tan(np.radians(ANGLE)) * metres**2 / np.sqrt(2) * 1e9
    seen = modulus(depth, ball, lambda curve: curve.calc_modulus(poisson_ratio=POISSON, indenter_radius=radius))
    other = modulus(depth, pyramid, lambda curve: curve.calc_modulus_pyramid(poisson_ratio=POISSON, face_angle=ANGLE))
    print(f"ball of {radius * 1e6:g} um, {deepest:g} nm deep: expected {true:g} MPa, seen {seen:.5g}, {seen / true:.4f} of it; pyramid {other:.5g}")
    fault |= abs(seen / true - 6 / 7) > 0.002 or abs(other / true - 1) > 1e-6
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore hertz.py
