#!/usr/bin/env bash
# Finding: In tribology the approach of two crossed cylinders is 0.35 times that of a ball on a plane, though the contact is the same, and its function of the contact area says so.
# Package: tribology 0.5.16 (PyPI)
# Expected: Crossed cylinders of equal radius R touch as a ball of R touches a plane: by Hertz the gap, the area and the approach are the same.
# Seen: ahertz gives one area for both; dhertz gives a 2.87 times larger approach for the ball, and how the curvature is shared between the bodies moves it for ellipses too, by 0.45 to 1.42.
# Touches carom: Take the stiffness of a Hertz contact from carom or from its area in this package, not from dhertz.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
# The package asks for NumPy of 2019, which has no build for this Python; its functions of Hertz work with a current one.
"$folder/env/bin/pip" install -q --disable-pip-version-check numpy==1.26.4 numexpr==2.10.2 scipy==1.13.1 matplotlib==3.9.4 \
  opencv-python-headless==4.10.0.84 setuptools==75.8.0
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps tribology==0.5.16
cd "$folder"
cat > crossed.py <<'PYTHON'
import importlib.metadata
import sys
import warnings

warnings.simplefilter("ignore")
import tribology

FLAT = float("inf")
R = 0.01
LOAD = 100.0
MODULUS = tribology.eeff(210e9, 0.3, 210e9, 0.3)


def contact(radii: tuple[float, float, float, float]) -> tuple[float, float]:
    """Area (mm2) and approach (um) of two steel bodies with the radii x and y of the first, x and y of the second."""
    area = tribology.ahertz(*tribology.reff(*radii), MODULUS, LOAD)[2]
    return 1e6 * area, 1e6 * tribology.dhertz(MODULUS, *radii, LOAD)


print("tribology", importlib.metadata.version("tribology"))
fault = False
for name, one, other, ratio in (
    ("ball on plane", (R, R, FLAT, FLAT), (R, R, FLAT, FLAT), 1.0),
    ("two balls of 2 R", (R, R, FLAT, FLAT), (2 * R, 2 * R, 2 * R, 2 * R), 1.0),
    ("crossed cylinders of R", (R, R, FLAT, FLAT), (R, FLAT, FLAT, R), 0.3483),
    ("crossed cylinders of R and 4 R for an ellipsoid", (R, 4 * R, FLAT, FLAT), (R, FLAT, FLAT, 4 * R), 0.4487),
    ("two ellipsoids of 2 R and 8 R for an ellipsoid", (R, 4 * R, FLAT, FLAT), (2 * R, 8 * R, 2 * R, 8 * R), 1.4194),
):
    (area, approach), (area_other, approach_other) = contact(one), contact(other)
    seen = approach_other / approach
    print(f"{name}: area {area:.5f} and {area_other:.5f} mm2; approach {approach:.3f} and {approach_other:.3f} um")
    print(f"  ratio of the approaches: expected 1, seen {seen:.4f}")
    fault |= abs(area_other / area - 1) > 1e-9 or abs(seen - ratio) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python crossed.py
