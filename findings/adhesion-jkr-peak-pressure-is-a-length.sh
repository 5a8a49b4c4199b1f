#!/usr/bin/env bash
# Finding: In Adhesion the peak pressure of a JKR contact is a length, some tenths of the contact radius, whatever the modulus does to the pressure.
# Package: Adhesion 0.93 (PyPI)
# Expected: The pressure in the middle of the contact, 3.09e5 Pa for a gel ball of 10 um at 1 uN; without adhesion it is that of Hertz, and a hundred times stiffer body has about 21.5 times the pressure.
# Seen: JKR.peak_pressure gives 6.9e-7: the root of the unstable contact radius, in m. With all but no adhesion it is the contact radius of Hertz; a stiffer body has less of it. The stress_distribution of the same module is right.
# Touches carom: Take the pressure of an adhesive contact for a comparison from JKR.stress_distribution at r = 0, with the sign reversed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --prefer-binary adhesion==0.93 ContactMechanics==1.8.3 SurfaceTopography==1.27.1 \
  NuMPI==0.18.1 muGrid==1.6.1 netCDF4==1.7.5.1.post1 DiscoverVersion==0.4.0 numpy==2.2.6 scipy==1.15.3
cd "$folder"
cat > peak.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from Adhesion.ReferenceSolutions import JKR

print("Adhesion", importlib.metadata.version("Adhesion"))
R, LOAD = 1e-5, 1e-6


def radii(E: float, w: float) -> np.ndarray:
    """Both roots of the contact radius by JKR, m."""
    adhesive = 3 * np.pi * w * R
    return (3 * R / (4 * E) * (LOAD + adhesive + np.array([1, -1]) * np.sqrt(2 * adhesive * LOAD + adhesive**2))) ** (1 / 3)


def middle(E: float, w: float) -> float:
    """Pressure in the middle by the closed form, Pa."""
    a = radii(E, w)[0]
    return 2 * E * a / (np.pi * R) - np.sqrt(2 * w * E / (np.pi * a))


fault = False
for name, E, w in (("gel, w 0.05 J/m2", 2e6, 0.05), ("200 MPa, w 0.05 J/m2", 2e8, 0.05), ("gel, w 1 pJ/m2", 2e6, 1e-12)):
    settings = dict(radius=R, contact_modulus=E, work_of_adhesion=w)
    peak = float(JKR.peak_pressure(force=LOAD, **settings))
    a = float(JKR.contact_radius(force=LOAD, **settings))
    stress = -float(JKR.stress_distribution(np.array([1e-6 * a]), a, **settings)[0])
    print(f"{name}: expected {middle(E, w):.5g} Pa, stress_distribution {stress:.5g} Pa; "
          f"seen {peak:.5g}, where the contact radius is {a:.5g} m and its unstable root {radii(E, w)[1]:.5g} m")
    fault |= abs(stress / middle(E, w) - 1) > 1e-6 or abs(a / radii(E, w)[0] - 1) > 1e-9
    fault |= abs(peak / radii(E, w)[1] - 1) > 1e-6
hertz = (6 * LOAD * 2e6**2 / (np.pi**3 * R**2)) ** (1 / 3)
print(f"without adhesion by Hertz: {hertz:.5g} Pa and a radius of {(3 * LOAD * R / 8e6) ** (1 / 3):.5g} m")
fault |= abs(middle(2e6, 1e-12) / hertz - 1) > 1e-3
fault |= abs(float(JKR.peak_pressure(force=LOAD, radius=R, contact_modulus=2e6, work_of_adhesion=1e-12)) / (3 * LOAD * R / 8e6) ** (1 / 3) - 1) > 1e-2
sys.exit(int(fault))
PYTHON
env/bin/python peak.py
